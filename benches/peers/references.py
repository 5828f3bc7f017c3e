#!/usr/bin/env python3
"""The attitudes at the end of the motions without a closed form: `references.py [KEY ...]`.

Needs gmpy2. Prints what `src/open.rs` holds: for each motion w, x, y, z to 45 digits, to how
many digits two routes agree, and its condition. Nothing here is of the library. A quarter of an
hour on one core.

Each route is a Taylor series with its own equations, order, steps and precision; they must
agree to 40 digits:

  A: angular velocity and two space axes on the body's axes (for the satellite the direction
     to the attracting body and the orbit's normal), 168 bits, order 58;
  B: quaternion and angular momentum on the fixed axes, 184 bits, order 46.

Besides, what each motion keeps is compared with its value at the start. Inputs are exact
binary64 numbers. The condition is what a relative change of the rates at the start comes to
in the attitude, by a difference at 1e-20.
"""

import sys
from operator import mul

import gmpy2
from gmpy2 import mpfr

# I; weight times lever; friction about e3; mean motion; torque on the body's axes, times
# cos(rate t); rates on the body's axes; end. All start at the attitude (1, 1, 1, 1)/2, at
# which e1, e2, e3 are along Y, Z, X.
MOTIONS = {
    "heavy_body": dict(I=[1.0, 1.3, 1.7], weight=0.25, omega=[0.25, 0.5, 1.25], end=1378.25),
    "damped_top": dict(I=[1.0, 1.0, 2.0], weight=0.2, friction=1.25e-3, omega=[0.0, 0.25, 0.75], end=1258.25),
    "satellite": dict(I=[1.0, 1.3, 1.7], orbit=0.125, omega=[0.25, 0.5, 1.25], end=1378.25),
    "driven_body": dict(I=[1.0, 1.3, 1.7], drive=[0.05, 0.04, 0.03], rate=0.75, omega=[0.25, 0.5, 1.25], end=1378.25),
}


class Motion:
    """The numbers of a motion, at the precision that is set."""

    def __init__(self, I, omega, end, weight=0.0, friction=0.0, orbit=0.0, drive=None, rate=0.0):
        self.I = [mpfr(x) for x in I]
        self.omega = [mpfr(x) for x in omega]
        self.end = mpfr(end)
        self.weight, self.friction = mpfr(weight), mpfr(friction)
        self.orbit, self.rate = mpfr(orbit), mpfr(rate)
        self.drive = [mpfr(x) for x in drive] if drive else None


def conv(a, b, k):
    return sum(map(mul, a[: k + 1], b[k::-1]), mpfr(0))


def cross_at(u, v, k):
    return [
        conv(u[1], v[2], k) - conv(u[2], v[1], k),
        conv(u[2], v[0], k) - conv(u[0], v[2], k),
        conv(u[0], v[1], k) - conv(u[1], v[0], k),
    ]


def cross(u, v):
    return cross_at([[c] for c in u], [[c] for c in v], 0)


def dot(u, v):
    return sum(map(mul, u, v), mpfr(0))


def wave(rate, t, order):
    """The series of cos and sin of rate (t + h)."""
    c, s = [gmpy2.cos(rate * t)], [gmpy2.sin(rate * t)]
    for k in range(order):
        n = -rate * s[k] / (k + 1), rate * c[k] / (k + 1)
        c.append(n[0]), s.append(n[1])
    return c, s


def horner(series, h):
    value = series[-1]
    for c in reversed(series[:-1]):
        value = value * h + c
    return value


def carry(series, y, end, order, bits):
    """Taylor steps whose two last terms stay below 2^(8 - bits) of the state."""
    t, tol, steps = mpfr(0), mpfr(2) ** (8 - bits), 0
    while t != end:
        s = series(t, y, order)
        h = end - t
        for c in s:
            for k in (order, order - 1):
                if c[k] != 0:
                    h = min(h, gmpy2.exp(gmpy2.log(tol * max(abs(c[0]), 1) / abs(c[k])) / k))
        y = [horner(c, h) for c in s]
        t, steps = (end if h == end - t else t + h), steps + 1
    return y, steps


# ------------------------------------------------------------------ route A


def series_a(m):
    I1, I2, I3 = m.I
    gradient = 3 * m.orbit**2

    def series(t, y, order):
        w, a, b = [[[v] for v in y[i : i + 3]] for i in (0, 3, 6)]
        c = wave(m.rate, t, order)[0] if m.drive else None
        for k in range(order):
            p = lambda i, j: conv(w[i], w[j], k)
            n = [(I2 - I3) * p(1, 2), (I3 - I1) * p(2, 0), (I1 - I2) * p(0, 1)]
            if m.weight:  # P Z x e3
                n[0] += m.weight * b[1][k]
                n[1] -= m.weight * b[0][k]
            if m.friction:
                n[2] -= m.friction * w[2][k]
            if m.drive:
                n = [v + d * c[k] for v, d in zip(n, m.drive)]
            da, db = cross_at(a, w, k), cross_at(b, w, k)
            if m.orbit:  # a: the direction to the attracting body, b: the orbit's normal
                q = lambda i, j: gradient * conv(a[i], a[j], k)
                n[0] += (I3 - I2) * q(1, 2)
                n[1] += (I1 - I3) * q(2, 0)
                n[2] += (I2 - I1) * q(0, 1)
                da = [u + m.orbit * v for u, v in zip(da, cross_at(b, a, k))]
            for i in range(3):
                w[i].append(n[i] / m.I[i] / (k + 1))
                a[i].append(da[i] / (k + 1))
                b[i].append(db[i] / (k + 1))
        return w + a + b

    return series


def start_a(m):
    # Rows of R: X = e3, Y = e1, Z = e2. The attracting body is at -X at first.
    toward = [0, 0, -1] if m.orbit else [0, 0, 1]
    return m.omega + [mpfr(v) for v in toward + [0, 1, 0]]


def rotation_a(m, y):
    a, b = y[3:6], y[6:9]
    if m.orbit:
        c, s = gmpy2.cos(m.orbit * m.end), gmpy2.sin(m.orbit * m.end)
        side = cross(b, a)
        # n = -(X cos + Y sin), Z x n = X sin - Y cos
        return [[-c * u + s * v for u, v in zip(a, side)], [-s * u - c * v for u, v in zip(a, side)], b]
    return [a, cross(b, a), b]


# ------------------------------------------------------------------ route B


def series_b(m):
    I = m.I

    def series(t, y, order):
        q, L = [[v] for v in y[:4]], [[v] for v in y[4:]]
        R, w = [[[] for _ in range(3)] for _ in range(3)], [[], [], []]
        toward, n, N = [[], [], []], None, None
        if m.drive:
            c = wave(m.rate, t, order)[0]
        if m.orbit:
            cs = wave(m.orbit, t, order)
            n = [[-v for v in cs[0]], [-v for v in cs[1]]]
            toward, N = [[], [], []], [[], [], []]
        for k in range(order):
            s = {(i, j): conv(q[i], q[j], k) for i in range(4) for j in range(i, 4)}
            rows = [
                [s[0, 0] + s[1, 1] - s[2, 2] - s[3, 3], 2 * (s[1, 2] - s[0, 3]), 2 * (s[1, 3] + s[0, 2])],
                [2 * (s[1, 2] + s[0, 3]), s[0, 0] - s[1, 1] + s[2, 2] - s[3, 3], 2 * (s[2, 3] - s[0, 1])],
                [2 * (s[1, 3] - s[0, 2]), 2 * (s[2, 3] + s[0, 1]), s[0, 0] - s[1, 1] - s[2, 2] + s[3, 3]],
            ]
            for i in range(3):
                for j in range(3):
                    R[i][j].append(rows[i][j])
            for j in range(3):
                w[j].append(sum((conv(R[i][j], L[i], k) for i in range(3)), mpfr(0)) / I[j])
            T = [mpfr(0)] * 3
            if m.weight:  # P Z x e3
                T = [-m.weight * R[1][2][k], m.weight * R[0][2][k], mpfr(0)]
            body = None
            if m.friction:
                body = [None, None, [-m.friction * v for v in w[2]]]
            if m.drive:
                body = [[d * v for v in c[: k + 1]] for d in m.drive]
            if m.orbit:  # 3 n0^2 n x (I n), in space: n x N with N = R I R^T n
                for j in range(3):
                    toward[j].append(I[j] * (conv(R[0][j], n[0], k) + conv(R[1][j], n[1], k)))
                for i in range(3):
                    N[i].append(3 * m.orbit**2 * sum((conv(R[i][j], toward[j], k) for j in range(3)), mpfr(0)))
                T = [
                    conv(n[1], N[2], k),
                    -conv(n[0], N[2], k),
                    conv(n[0], N[1], k) - conv(n[1], N[0], k),
                ]
            if body:
                T = [T[i] + sum((conv(R[i][j], body[j], k) for j in range(3) if body[j]), mpfr(0)) for i in range(3)]
            p = lambda i, j: conv(q[i], w[j], k)
            r = 2 * (k + 1)
            new = [
                (-p(1, 0) - p(2, 1) - p(3, 2)) / r,
                (p(0, 0) + p(2, 2) - p(3, 1)) / r,
                (p(0, 1) + p(3, 0) - p(1, 2)) / r,
                (p(0, 2) + p(1, 1) - p(2, 0)) / r,
            ]
            for i in range(4):
                q[i].append(new[i])
            for i in range(3):
                L[i].append(T[i] / (k + 1))
        return q + L

    return series


def start_b(m):
    # e1, e2, e3 along Y, Z, X
    l = [i * w for i, w in zip(m.I, m.omega)]
    return [mpfr(0.5)] * 4 + [l[2], l[0], l[1]]


def rotation(q):
    w, x, y, z = q
    return [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]


# ------------------------------------------------------------------ checks


def kept(m, y, t):
    """What the motion keeps, from a state of route A."""
    w, a, b = y[:3], y[3:6], y[6:9]
    l = [i * v for i, v in zip(m.I, w)]
    energy = dot(l, w) / 2
    if m.drive:
        return {}
    if m.friction:
        return {"l3 exp(k t)": l[2] * gmpy2.exp(m.friction / m.I[2] * t)}
    if m.orbit:
        potential = 3 * m.orbit**2 / 2 * sum((i * v * v for i, v in zip(m.I, a)), mpfr(0))
        return {"Jacobi's integral": energy + potential - m.orbit * dot(l, b)}
    return {"energy": energy + m.weight * b[2], "L_Z": dot(l, b)}


def off(one, other):
    return max(abs(u - v) for r, s in zip(one, other) for u, v in zip(r, s))


def route_a(numbers, bits=168, order=58, change=None):
    gmpy2.get_context().precision = bits
    m = Motion(**numbers)
    if change:
        m.omega = [w * (1 + c * change) for w, c in zip(m.omega, (1, -1, 1))]
    y, steps = carry(series_a(m), start_a(m), m.end, order, bits)
    for name, value in kept(m, y, m.end).items():
        before = kept(m, start_a(m), mpfr(0))[name]
        assert abs(value - before) < mpfr(2) ** (32 - bits), (name, value - before)
    return rotation_a(m, y), steps


def route_b(numbers, bits=184, order=46):
    gmpy2.get_context().precision = bits
    m = Motion(**numbers)
    y, steps = carry(series_b(m), start_b(m), m.end, order, bits)
    q = y[:4]
    assert abs(dot(q, q) - 1) < mpfr(2) ** (32 - bits)
    return q, steps


def solve(key):
    numbers = MOTIONS[key]
    (a, steps_a), (q, steps_b) = route_a(numbers), route_b(numbers)
    digits = float(-gmpy2.log10(off(a, rotation(q))))
    assert digits >= 40, (key, digits)
    d = mpfr(10) ** -20
    moved, _ = route_a(numbers, 112, 40, d)
    print(f"{key}: {digits:.1f} digits, {steps_a} and {steps_b} steps, condition {float(off(a, moved) / d):.2g}")
    for v in q:
        print(f"    {v:.42f}", flush=True)


if __name__ == "__main__":
    for key in sys.argv[1:] or MOTIONS:
        solve(key)
