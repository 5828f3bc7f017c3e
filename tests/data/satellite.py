#!/usr/bin/env python3
"""Writes the reference of tests/accuracy/gravity_gradient.rs: `satellite.py satellite.txt`.

Needs mpmath. A satellite on a tilted circle, under the gradient of gravity, after a day: the
attitude as a unit quaternion, then the rates on the body axes, 25 digits. The inputs are
doubles and taken as exact.

Taylor series of the body's own equations, 45 digits: the rates and, on the body's axes, the
directions to the Earth now and a quarter of an orbit on, as they are at the start. Two orders and
steps must agree to 30 digits.
"""

import sys
from mpmath import mp, mpf, fsum, polyval, nstr, sin, cos, sqrt, fabs

mp.dps = 45
MOMENTS = [20, 90, 100]
MOTION = mpf(1.1e-3)
NORMAL, TOWARDS = [2, -1, 3], [1, 5, 1]
ANGLES = [mpf(x) for x in (0.4, 1.1, -0.7)]
RATES = [mpf(x * 1.1e-3) for x in (0.7, -1.3, 2.1)]
DAY = 86400


def dot(a, b):
    return fsum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3] for i in range(3)]


def unit(v):
    return [x / sqrt(dot(v, v)) for x in v]


def turned(phi, theta, zeta):
    """Rz(phi) Rx(theta) Rz(zeta), by rows."""
    z = lambda a: [[cos(a), -sin(a), 0], [sin(a), cos(a), 0], [0, 0, 1]]
    x = [[1, 0, 0], [0, cos(theta), -sin(theta)], [0, sin(theta), cos(theta)]]
    times = lambda a, b: [[dot(row, column) for column in zip(*b)] for row in a]
    return times(times(z(phi), x), z(zeta))


def quaternion(R):
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    rows = [
        [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
    ]
    i = max(range(4), key=lambda i: rows[i][i])
    return [x / (2 * sqrt(rows[i][i])) for x in rows[i]]


def after(steps, order):
    """Attitude and rates after a day."""
    normal = unit(NORMAL)
    first = unit([x - dot(TOWARDS, normal) * n for x, n in zip(TOWARDS, normal)])
    space = [first, cross(normal, first), normal]
    R = turned(*ANGLES)
    body = lambda v: [dot(column, v) for column in zip(*R)]
    a, b, w = body(space[0]), body(space[1]), list(RATES)
    A, B, C = [mpf(i) for i in MOMENTS]
    inert = [(B - C) / A, (C - A) / B, (A - B) / C]
    h, n = mpf(DAY) / steps, MOTION
    for step in range(steps):
        phase = n * h * step
        c, s = [cos(phase)], [sin(phase)]
        W, P, Q, D = [[x] for x in w], [[x] for x in a], [[x] for x in b], [[], [], []]
        conv = lambda x, y, k: fsum(x[i] * y[k - i] for i in range(k + 1))
        for k in range(order):
            for i in range(3):
                D[i].append(conv(P[i], c, k) + conv(Q[i], s, k))
            new = []
            for i in range(3):
                j, l = (i + 1) % 3, (i + 2) % 3
                new.append(inert[i] * (conv(W[j], W[l], k) - 3 * n * n * conv(D[j], D[l], k)))
            for V in (P, Q):
                rates = [
                    conv(V[(i + 1) % 3], W[(i + 2) % 3], k) - conv(V[(i + 2) % 3], W[(i + 1) % 3], k)
                    for i in range(3)
                ]
                for i in range(3):
                    V[i].append(rates[i] / (k + 1))
            for i in range(3):
                W[i].append(new[i] / (k + 1))
            c.append(-n * s[k] / (k + 1))
            s.append(n * c[k] / (k + 1))
        w, a, b = [[polyval(x[::-1], h) for x in V] for V in (W, P, Q)]
    seen = [a, b, cross(a, b)]
    R = [[dot([v[i] for v in space], [v[j] for v in seen]) for j in range(3)] for i in range(3)]
    return quaternion(R) + w


here, there = after(1440, 40), after(1200, 46)
assert all(fabs(x - y) < mpf(10) ** -30 for x, y in zip(here, there)), (here, there)
with open(sys.argv[1], "w") as file:
    file.write(" ".join(nstr(x, 25, min_fixed=0, max_fixed=0) for x in here) + "\n")
