#!/usr/bin/env python3
"""Writes sequences.txt, the references of tests/bodies/attitude/sequences. Needs mpmath;
fixed seed.

A row: the axes of three turns, a quaternion (doubles, taken as exact, of any length), and
the three angles, computed with 700 digits and rounded once. They come from where the turns
carry the axes, with vector products: nothing is renamed here, as it is in the library."""
import random
import mpmath as mp
from mpmath import mpf

mp.mp.dps = 700
random.seed(22)
U = random.uniform
E = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
out = []


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]


def matrix(q):
    """|q|^2 R, exactly."""
    w, x, y, z = q
    return [[w*w+x*x-y*y-z*z, 2*(x*y-w*z), 2*(x*z+w*y)], [2*(x*y+w*z), w*w-x*x+y*y-z*z, 2*(y*z-w*x)],
            [2*(x*z-w*y), 2*(y*z+w*x), w*w-x*x-y*y+z*z]]


def angles(axes, q):
    i, j, k = (E[a] for a in axes)
    r = matrix(q)
    forth = lambda v: [dot(row, v) for row in r]
    back = lambda v: [dot([row[c] for row in r], v) for c in range(3)]
    # R k = turn about i of (turn about j of k), in the plane across i.
    u = cross(j, i) if axes[0] == axes[2] else k
    carried = forth(k)
    sin_a, cos_a = dot(carried, cross(i, u)), dot(carried, u)
    if axes[0] == axes[2]:
        second = mp.atan2(mp.hypot(sin_a, cos_a), dot(carried, i))
    else:
        second = mp.atan2(dot(carried, cross(j, k)), mp.hypot(sin_a, cos_a))
    if sin_a == 0 == cos_a:
        carried = forth(j)
        return [mp.atan2(dot(carried, cross(i, j)), dot(carried, j)), second, mpf(0)]
    # R^T i likewise, by the turns backwards.
    v = [-c for c in cross(j, k)] if axes[0] == axes[2] else i
    carried = back(i)
    return [mp.atan2(sin_a, cos_a), second, mp.atan2(dot(carried, cross(v, k)), dot(carried, v))]


def turn(axis, angle):
    return [mp.cos(angle / 2)] + [mp.sin(angle / 2) * c for c in E[axis]]


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [a*w - b*x - c*y - d*z, a*x + b*w + c*z - d*y, a*y - b*z + c*w + d*x, a*z + b*y - c*x + d*w]


def row(axes, q):
    # As the library keeps it: unit to 4 eps already, or made so, which rounds it.
    q = [mpf(float(c)) for c in q]
    n = mp.sqrt(sum(c * c for c in q))
    if abs(n - 1) > mpf(2) ** -52:
        q = [mpf(float(c / n)) for c in q]
    out.append(" ".join(["xyz"[a] for a in axes] + [repr(float(c)) for c in q + angles(axes, q)]))


def tiny():
    return mpf(random.choice((-1, 1)) * 10 ** random.choice((U(-20, -1), U(-300, -20))))


def some():
    return mpf(U(-3.14, 3.14))


for i in range(3):
    for j in range(3):
        for k in range(3):
            if i == j or j == k:
                continue
            axes, lock = (i, j, k), mpf(0) if i == k else mp.pi / 2
            turned = lambda a, b, c: product(product(turn(i, a), turn(j, b)), turn(k, c))
            for _ in range(8):
                row(axes, turned(some(), mpf(U(0, 3.14) if i == k else U(-1.57, 1.57)), some()))
                row(axes, turned(some(), tiny(), some()))          # about nothing, or at a lock
                row(axes, turned(tiny(), tiny(), tiny()))
                row(axes, turned(tiny(), some() / 3, tiny()))
                row(axes, turned(some(), random.choice((-1, 1)) * (mp.pi / 2 if lock else mp.pi) + tiny(), some()))
            # Next to a lock as doubles can be: pairs of components equal, and two that are tiny.
            third = 3 - i - j
            for _ in range(4):
                for pairs in (((0, 1 + j), (1 + i, 1 + third)), ((1 + i, 1 + third), (0, 1 + j))):
                    for size in (tiny, lambda: mpf(0)):
                        q, h, s = [mpf(0)] * 4, mpf(U(0.5, 0.9)), random.choice((-1, 1))
                        q[pairs[0][0]], q[pairs[0][1]] = h, h * s
                        q[pairs[1][0]], q[pairs[1][1]] = size(), size()
                        row(axes, q)
            for _ in range(4):  # at a lock
                p, r, s = mpf(U(-1, 1)), mpf(U(-1, 1)), random.choice((-1, 1))
                q = [mpf(0)] * 4
                hand = 1 if (i + 1) % 3 == j else -1
                q[0], q[1 + j], q[1 + i], q[1 + third] = (p, s * p, r, hand * s * r) if lock else (p, 0, r, 0)
                row(axes, q)

with open(__file__.replace(".py", ".txt"), "w") as f:
    f.write("# written by sequences.py with mpmath %s\n" % mp.__version__)
    f.write("\n".join(out) + "\n")
