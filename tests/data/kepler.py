#!/usr/bin/env python3
"""Writes the references of tests/accuracy/orbiting_body.rs: `kepler.py > kepler.txt`.

Needs mpmath. A line is e, tau, x, y: eccentricity and time from the pericentre (doubles),
and the place on the orbit, in units of the pericentre distance q and of sqrt(q^3/(G M)).
Kepler's equation in its classical forms, E - e sin(E) = M and e sinh(H) - H = N, the
parabola by Cardano's formula, all by bisection and Newton at 80 digits.
"""

import random
from mpmath import mp, mpf, sqrt, sin, cos, sinh, cosh, asinh, cbrt, pi, floor, log

mp.dps = 80
random.seed(15)


def root(f, low, high):
    for _ in range(330):
        middle = (low + high) / 2
        if f(middle) < 0:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def place(e, tau):
    e, tau = mpf(e), mpf(tau)
    if e < 1:
        alpha = 1 - e
        m = tau * alpha * sqrt(alpha)
        a = root(lambda a: a - e * sin(a) - abs(m), mpf(0), pi)
        a = a if m >= 0 else -a
        return (cos(a) - e) / alpha, sqrt((1 - e) * (1 + e)) * sin(a) / alpha
    if e == 1:
        # tan(f/2) = D, D + D^3/3 = tau/sqrt(2).
        w = 3 * abs(tau) / sqrt(mpf(8))
        d = cbrt(w + sqrt(w * w + 1))
        d = d - 1 / d
        d = d if tau >= 0 else -d
        return 1 - d * d, 2 * d
    beta = e - 1
    n = tau * beta * sqrt(beta)
    h = root(lambda h: e * sinh(h) - h - abs(n), mpf(0), asinh(abs(n)) + 60)
    h = h if n >= 0 else -h
    return (e - cosh(h)) / beta, sqrt((e - 1) * (e + 1)) * sinh(h) / beta


def half_period(e):
    return float(pi / (mpf(1) - mpf(e)) ** mpf(1.5)) if e < 1 else float("inf")


near = [1 - 2.0 ** -53, 1 - 1e-15, 1 - 1e-12, 1 - 1e-8, 1 - 1e-4, 1.0, 1 + 2.0 ** -52, 1 + 1e-12, 1 + 1e-8, 1 + 1e-4]
plain = [0.0, 1e-300, 1e-9, 0.0167086342, 0.0549, 0.2, 0.5, 0.6288, 0.9, 0.99, 1.01, 1.5, 2.0, 10.0]
for e in near + plain:
    most = half_period(e)
    times = [1e-9, 1e-3, 0.1, 0.7, 1.9, 3.0, 5.0, 30.0, 1e3, 1e6]
    if most < 1e300:
        times = [t for t in times if t < 0.98 * most] + [0.3 * most, 0.8 * most, 0.99 * most]
    for tau in times:
        tau = tau * random.uniform(0.8, 1.0) * random.choice([-1, 1])
        x, y = place(e, tau)
        print(repr(e), repr(tau), mp.nstr(x, 32), mp.nstr(y, 32))
