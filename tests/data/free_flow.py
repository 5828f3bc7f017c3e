#!/usr/bin/env python3
"""Writes the references of tests/exact/free_flow.rs: `free_flow.py free_flow.txt`.

Needs mpmath. A line is: kind, I1 I2 I3, l1 l2 l3, dt, then the quaternion of the
free rotation over dt less 1, 25 digits. Taylor series of the body's own equations,
order 50, 40 digits, steps of a third of a radian.
"""

import random, sys
from mpmath import mp, mpf, fsum, polyval, nstr, pi

mp.dps = 40


def turn(I, l, dt, order=50):
    steps = max(1, int(abs(dt) * max(abs(l[i]) / I[i] for i in range(3)) * 3) + 1)
    I, l = [mpf(i) for i in I], [mpf(x) for x in l]
    q, h = [mpf(1), mpf(0), mpf(0), mpf(0)], mpf(dt) / steps
    K = [1 / I[2] - 1 / I[1], 1 / I[0] - 1 / I[2], 1 / I[1] - 1 / I[0]]
    conv = lambda a, b, k: fsum(a[i] * b[k - i] for i in range(k + 1))
    for _ in range(steps):
        L, Q = [[x] for x in l], [[x] for x in q]
        W = [[l[i] / I[i] / 2] for i in range(3)]
        for k in range(order):
            new = [K[i] * conv(L[(i + 1) % 3], L[(i + 2) % 3], k) for i in range(3)]
            p = lambda i, j: conv(Q[i], W[j], k)
            turned = [
                -p(1, 0) - p(2, 1) - p(3, 2),
                p(0, 0) + p(2, 2) - p(3, 1),
                p(0, 1) + p(3, 0) - p(1, 2),
                p(0, 2) + p(1, 1) - p(2, 0),
            ]
            for i in range(3):
                L[i].append(new[i] / (k + 1))
                W[i].append(L[i][-1] / I[i] / 2)
            for i in range(4):
                Q[i].append(turned[i] / (k + 1))
        l, q = [polyval(c[::-1], h) for c in L], [polyval(c[::-1], h) for c in Q]
    return [q[0] - 1] + q[1:]


def cases():
    r = random.Random(5)

    def moments():
        while True:
            I = [round(r.uniform(0.3, 3), 6) for _ in range(3)]
            if all(I[i] <= 0.97 * (I[i - 1] + I[i - 2]) for i in range(3)):
                return I

    momentum = lambda: [round(r.uniform(-2, 2), 6) for _ in range(3)]
    for _ in range(30):
        yield "step", moments(), momentum(), round(r.uniform(-0.5, 0.5), 6)
    for _ in range(10):
        yield "long", moments(), momentum(), round(r.uniform(2, 12), 6)
    for k in range(10):
        yield "short", moments(), momentum(), 10.0 ** -(1 + k)
    axis = [[1.5, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 1.5], [0.0, 1.5, 1e-9], [1e-200, 1.5, 0.0]]
    for l in axis:
        yield "axis", moments(), l, 0.3
    for off in [1e-2, 1e-5, 1e-8, 1e-12, 0.0]:
        yield "separatrix", [1.0, 2.0, 2.5], [off, 2.0, off], 0.4
    for off in [1e-3, 1e-8, 2.0**-52, 0.0]:
        yield "near-symmetric", [1.0, 1.0 + off, 1.7], momentum(), 0.45
        yield "near-sphere", [1.0, 1.0 + off, 1.0 - off / 2], momentum(), 2.5
    for off in [1e-2, 1e-4, 1e-6]:
        yield "needle", [1.0, 1.0 + off / 2, off], [0.3, -0.4, off * 2.0], 0.2
        yield "needle", [1.0, 1.0 + off / 2, off], [0.3e-2, -0.4e-2, 0.4], off * 0.5
    yield "disc", [1.0, 1.5, 2.5], [0.3, 0.4, 2.5], 0.35
    yield "disc", [1.0, 1.0, 2.0], [0.3, 0.4, 2.5], -0.35
    yield "half-turn", [1.0, 1.0, 1.0], [0.0, 0.0, 1.0], float(pi)
    yield "half-turn", [1.0, 1.001, 1.002], [0.1, 0.2, 1.0], 3.0


with open(sys.argv[1], "w") as file:
    for kind, I, l, dt in cases():
        numbers = [repr(float(x)) for x in I + l + [dt]]
        values = [nstr(x, 25, min_fixed=0, max_fixed=0) for x in turn(I, l, dt)]
        file.write(" ".join([kind] + numbers + values) + "\n")
