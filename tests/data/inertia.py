#!/usr/bin/env python3
"""Writes inertia.txt, the references of tests/bodies/inertia. Needs mpmath; fixed seed.

Rows: a kind, the six elements xx yy zz xy xz yz (doubles, taken as exact) of a tensor of
inertia, and its principal moments, ascending, as pairs of doubles (leading part, rest)."""
import random
import mpmath as mp
from mpmath import mpf

mp.mp.dps = 80
random.seed(3)
out = []


def row(kind, six):
    six = [float(x) for x in six]
    a, b, c, d, e, f = (mpf(x) for x in six)
    m = mp.matrix([[a, d, e], [d, b, f], [e, f, c]])
    moments = sorted(mp.eigsy(m, eigvals_only=True))
    pairs = [float(v) for v in moments] + [float(v - mpf(float(v))) for v in moments]
    out.append(" ".join([kind] + [repr(x) for x in six + pairs]))


def turned(moments):
    """R diag(moments) R^T for a random rotation."""
    q = [mpf(random.gauss(0, 1)) for _ in range(4)]
    n = mp.sqrt(sum(c * c for c in q))
    w, x, y, z = (c / n for c in q)
    r = mp.matrix([[w*w+x*x-y*y-z*z, 2*(x*y-w*z), 2*(x*z+w*y)],
                   [2*(x*y+w*z), w*w-x*x+y*y-z*z, 2*(y*z-w*x)],
                   [2*(x*z-w*y), 2*(y*z+w*x), w*w-x*x-y*y+z*z]])
    t = r * mp.diag([mpf(m) for m in moments]) * r.T
    return [t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]]


U = random.uniform
for _ in range(40):
    a, b = U(1, 2), U(1, 2)
    row("generic", turned((a, b, U(abs(a - b), a + b))))
for _ in range(40):  # two moments equal but for 10^-k
    a = U(1, 2)
    row("symmetric", turned((a, a * (1 + 10 ** U(-16, -1)), U(0.1, 1.9) * a)))
for _ in range(40):  # a needle
    a, s = U(1, 2), 10 ** U(-12, -1)
    row("needle", turned((a, a + s * U(0, 0.9), s)))
for _ in range(20):  # nearly a sphere
    row("sphere", turned([1 + 10 ** U(-16, -3) for _ in range(3)]))
for _ in range(20):  # off the principal axes by little
    six = [U(1, 1.5), U(1, 1.5), U(1, 1.5)] + [10 ** U(-20, -3) * U(-1, 1) for _ in range(3)]
    row("nearly_diagonal", six)

with open(__file__.replace(".py", ".txt"), "w") as f:
    f.write("# written by inertia.py with mpmath %s\n" % mp.__version__)
    f.write("\n".join(out) + "\n")
