#!/usr/bin/env python3
"""Writes the references of tests/exact/late.rs: `late.py late.txt`.

Needs mpmath. A line is: kind, name, inputs, periods, t, then the attitude as a unit
quaternion and the rates on the body axes, or angle and rate of a pendulum, 25 digits. The
inputs and t are doubles and taken as exact.

By Jacobi functions and integrals of the third kind in Euler angles, 80 digits: the time is
counted from whole periods. Periods and advances are formed a second time by quadrature and
must agree to 50 digits.
"""

import sys
from mpmath import mp, mpf, matrix, sqrt, sin, cos, asin, atan2, pi, nint, nstr
from mpmath import ellipk, ellipfun, elliprf, elliprj, polyroots, quad, fabs, re

mp.dps = 80


def euler(phi, theta, zeta):
    """Rz(phi) Rx(theta) Rz(zeta) as a quaternion."""
    c, s, plus, minus = cos(theta / 2), sin(theta / 2), (phi + zeta) / 2, (phi - zeta) / 2
    return [c * cos(plus), s * cos(minus), s * sin(minus), c * sin(plus)]


def times(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]


def about(axis, angle):
    size = sqrt(sum(x * x for x in axis))
    return [cos(angle / 2)] + [sin(angle / 2) * x / size for x in axis]


def inverse(q):
    return [q[0], -q[1], -q[2], -q[3]]


def agree(a, b):
    assert fabs(a - b) <= mpf(10) ** -50 * (1 + fabs(a)), (a, b)


def jacobi(u, m):
    """sn, cn, dn and the amplitude: whole 2K first."""
    k = ellipk(m)
    n = nint(u / (2 * k))
    sn, cn, dn = [re(ellipfun(f, u - 2 * n * k, m=m)) for f in ("sn", "cn", "dn")]
    sign = -1 if int(n) % 2 else 1
    return sign * sn, sign * cn, dn, n * pi + atan2(sn, cn)


def first(phi, m1):
    """F(phi | 1 - m1), |phi| <= pi."""
    j = nint(phi / pi)
    s, c = sin(phi - j * pi), cos(phi - j * pi)
    return s * elliprf(c * c, c * c + m1 * s * s, 1) + 2 * j * elliprf(0, m1, 1)


def third(n, phi, m1):
    """int dx / ((1 - n sin^2) sqrt(1 - m sin^2)) up to phi, whole half turns first."""
    j = nint(phi / pi)
    s, c = sin(phi - j * pi), cos(phi - j * pi)
    y = c * c + m1 * s * s
    part = s * elliprf(c * c, y, 1) + n * s**3 / 3 * elliprj(c * c, y, 1, 1 - n * s * s)
    whole = elliprf(0, m1, 1) + n / 3 * elliprj(0, m1, 1, 1 - n)
    return re(part + 2 * j * whole)


def quadrature(f, m1):
    """int_0^{pi/2} f(sin^2), by halves that crowd towards pi/2."""
    ends, x = [mpf(0)], mpf(1)
    while x * x > m1 / 4:
        ends.append(pi / 2 - x)
        x /= 2
    return quad(lambda x: f(sin(x) ** 2), ends + [pi / 2])


class Free:
    def __init__(self, inputs):
        inputs = [mpf(x) for x in inputs]
        self.I, self.w, angles = inputs[:3], inputs[3:6], inputs[6:]
        self.start = euler(*angles)
        I, w = self.I, self.w
        self.L = sqrt(sum((i * x) ** 2 for i, x in zip(I, w)))
        equal = [I[(i + 1) % 3] == I[(i + 2) % 3] for i in range(3)]
        self.axis = equal.index(True) if any(equal) else None
        if self.axis is not None:
            i, j = self.axis, (self.axis + 1) % 3
            self.spin = (1 - I[i] / I[j]) * w[i]
            self.turn = self.L / I[j]
            self.period = 2 * pi / fabs(self.spin)
            return
        lo, mid, hi = sorted(range(3), key=lambda i: I[i])
        side = I[hi] * (I[hi] - I[mid]) * w[hi] ** 2 - I[lo] * (I[mid] - I[lo]) * w[lo] ** 2
        self.order = [lo, mid, hi] if side > 0 else [hi, mid, lo]
        rows = [[mpf(self.order[r] == c) for c in range(3)] for r in range(3)]
        sign = mp.det(matrix(rows))
        self.rows = [[sign * x for x in row] for row in rows]
        J = self.J = [I[i] for i in self.order]
        w1, w2, w3 = v = [sign * w[i] for i in self.order]
        a = J[0] * (J[2] - J[0]) * w1**2 + J[1] * (J[2] - J[1]) * w2**2
        b = J[1] * (J[1] - J[0]) * w2**2 + J[2] * (J[2] - J[0]) * w3**2
        self.third = 1 if w3 > 0 else -1
        self.second = self.third * (1 if J[2] > J[0] else -1)
        self.A = [
            sqrt(a / (J[0] * (J[2] - J[0]))),
            self.second * sqrt(a / (J[1] * (J[2] - J[1]))),
            self.third * sqrt(b / (J[2] * (J[2] - J[0]))),
        ]
        self.p = sqrt((J[2] - J[1]) * b / (J[0] * J[1] * J[2]))
        self.m = (J[1] - J[0]) * a / ((J[2] - J[1]) * b)
        self.m1 = fabs(J[2] - J[0]) * fabs(side) / (fabs(J[2] - J[1]) * fabs(b))
        agree(self.m + self.m1, 1)
        self.am0 = atan2(w2 / self.A[1], w1 / self.A[0])
        self.tau0 = first(self.am0, self.m1)
        self.n = J[2] * (J[0] - J[1]) / (J[0] * (J[2] - J[1]))
        self.period = 4 * ellipk(self.m) / self.p
        agree(ellipk(self.m), quadrature(lambda x: 1 / sqrt(1 - self.m * x), self.m1))
        agree(
            third(self.n, pi / 2, self.m1),
            quadrature(lambda x: 1 / (1 - self.n * x) / sqrt(1 - self.m * x), self.m1),
        )
        quaternion, _ = self.local(mpf(0))
        self.outer = times(self.start, inverse(quaternion))

    def local(self, t):
        """From the body to a frame along L, and the rates."""
        J, L = self.J, self.L
        sn, cn, dn, am = jacobi(self.p * t + self.tau0, self.m)
        v = [self.A[0] * cn, self.A[1] * sn, self.A[2] * dn]
        gained = third(self.n, am, self.m1) - third(self.n, self.am0, self.m1)
        psi = L * t / J[2] + L * (J[2] - J[0]) / (J[0] * J[2] * self.p) * gained
        l = [j * x / L for j, x in zip(J, v)]
        theta, zeta = atan2(sqrt(l[0] ** 2 + l[1] ** 2), l[2]), atan2(l[0], l[1])
        permuted = of_rows(self.rows)
        rates = [sum(self.rows[r][i] * v[r] for r in range(3)) for i in range(3)]
        return times(euler(psi, theta, zeta), permuted), rates

    def at(self, t):
        if self.axis is None:
            quaternion, rates = self.local(t)
            return times(self.outer, quaternion), rates
        i, j, k = self.axis, (self.axis + 1) % 3, (self.axis + 2) % 3
        momentum = [a * x for a, x in zip(self.I, self.w)]
        own = [mpf(n == i) for n in range(3)]
        turned = times(self.start, about(momentum, self.turn * t))
        c, s, w = cos(self.spin * t), sin(self.spin * t), self.w
        rates = [mpf(0)] * 3
        rates[i], rates[j], rates[k] = w[i], w[j] * c + w[k] * s, w[k] * c - w[j] * s
        return times(turned, about(own, self.spin * t)), rates


def of_rows(R):
    """The quaternion of a rotation matrix."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    rows = [
        [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
    ]
    i = max(range(4), key=lambda i: rows[i][i])
    return [x / (2 * sqrt(rows[i][i])) for x in rows[i]]


class Top:
    """I1 I3 mgl, phi theta zeta, rates on the body axes."""

    def __init__(self, inputs):
        i1, i3, weight, phi, theta, zeta, x, y, z = [mpf(x) for x in inputs]
        nodal = [x * cos(zeta) - y * sin(zeta), x * sin(zeta) + y * cos(zeta)]
        if theta == 0:
            # The node line is where the axis leaves the pole.
            node = atan2(-y, x)
            phi, zeta, nodal = phi + zeta - node, node, [sqrt(x * x + y * y), mpf(0)]
        self.B, self.w3, self.phi, self.zeta = i3 * z / i1, z, phi, zeta
        self.A = self.B * cos(theta) + nodal[1] * sin(theta)
        gravity = 2 * weight / i1
        self.flip = f = -1 if gravity < 0 else 1
        self.D, self.s = self.A - f * self.B, self.A + f * self.B
        G, B, v = fabs(gravity), f * self.B, f * cos(theta)
        self.G, self.Bv = G, B
        al = (nodal[0] ** 2 + nodal[1] ** 2) + G * v
        # (1 - v^2)(al - G v) - (A - B v)^2.
        cubic = [G, -(al + B * B), 2 * self.A * B - G, al - self.A**2]
        if self.D == 0:
            below, above = sorted(real_roots([-G, al - G + B * B, al - B * B]))
            self.v = sorted([below, above, mpf(1)])
        elif self.s == 0:
            below, above = sorted(real_roots([G, -(al + G) - B * B, al - B * B]))
            self.v = [mpf(-1), below, above]
        else:
            roots = polyroots(cubic, maxsteps=2000, extraprec=1500)
            self.v = sorted(re(x) for x in roots)
        v1, v2, v3 = self.v
        self.p = sqrt(G * (v3 - v1)) / 2
        self.m, self.m1 = (v2 - v1) / (v3 - v1), (v3 - v2) / (v3 - v1)
        rate = -f * sin(theta) * nodal[0]
        self.am0 = atan2(sqrt(max(v - v1, mpf(0))), sqrt(max(v2 - v, mpf(0))))
        self.am0 *= -1 if rate < 0 else 1
        if theta == 0:
            self.am0 = -pi / 2
        elif nodal[0] == 0:
            self.am0 = mpf(0) if v - v1 < v2 - v else pi / 2
        self.tau0 = first(self.am0, self.m1)
        self.n = [(v2 - v1) / (1 - v1), -(v2 - v1) / (1 + v1) if v1 > -1 else mpf(0)]
        self.period = 2 * ellipk(self.m) / self.p
        agree(ellipk(self.m), quadrature(lambda x: 1 / sqrt(1 - self.m * x), self.m1))
        for n, gap in [(self.n[0], self.D), (self.n[1], self.s)]:
            if gap != 0:
                agree(
                    third(n, pi / 2, self.m1),
                    quadrature(
                        lambda x: 1 / (1 - n * x) / sqrt(1 - self.m * x), min(self.m1, 1 - n)
                    ),
                )
        assert self.D == 0 or fabs(self.D) > 1e-30
        assert self.s == 0 or fabs(self.s) > 1e-30

    def at(self, t):
        v1, v2, v3 = self.v
        sn, cn, dn, am = jacobi(self.p * t + self.tau0, self.m)

        def turned(gap, n, reach):
            if gap == 0:
                return mpf(0)
            return gap / reach / self.p * (third(n, am, self.m1) - third(n, self.am0, self.m1))

        minus, plus = turned(self.D, self.n[0], 1 - v1), turned(self.s, self.n[1], 1 + v1)
        phi = self.phi + (minus + plus) / 2
        zeta = self.zeta + self.w3 * t - self.flip * ((minus - plus) / 2 + self.Bv * t)
        # Signed where the axis passes the pole.
        if self.D == 0 and v2 == 1:
            half = sqrt((1 - v1) / 2)
            theta, rate = 2 * asin(half * cn), -2 * half * sn * dn * self.p
            rate /= cos(theta / 2)
        else:
            to_one = (1 - v2) + (v2 - v1) * cn * cn
            from_minus_one = (1 + v1) + (v2 - v1) * sn * sn
            theta = 2 * atan2(sqrt(to_one), sqrt(from_minus_one))
            rate = -2 * self.p * (v2 - v1) * sn * cn * dn / sqrt(to_one * from_minus_one)
        if self.flip < 0:
            theta, rate = pi - theta, -rate
        across = (self.A - self.B * cos(theta)) / sin(theta)
        s, c = sin(zeta), cos(zeta)
        rates = [rate * c + across * s, across * c - rate * s, self.w3]
        return euler(phi, theta, zeta), rates


def real_roots(q):
    a, b, c = q
    root = sqrt(b * b - 4 * a * c)
    far = -(b + root) / 2 if b > 0 else -(b - root) / 2
    return [far / a, c / far]


class Pendulum:
    """I m g d, theta0 omega0."""

    def __init__(self, inputs):
        moment, mass, gravity, lever, theta, omega = [mpf(x) for x in inputs]
        self.W = sqrt(mass * gravity * lever / moment)
        swing = omega / (2 * self.W)
        self.k2 = sin(theta / 2) ** 2 + swing**2
        self.gap = cos(theta / 2) ** 2 - swing**2
        self.k = sqrt(self.k2)
        self.sense = -1 if omega < 0 else 1
        if self.gap > 0:
            self.tau0 = first(atan2(sin(theta / 2), swing), self.gap)
            self.period = 4 * ellipk(self.k2) / self.W
            agree(ellipk(self.k2), quadrature(lambda x: 1 / sqrt(1 - self.k2 * x), self.gap))
        else:
            self.m = 1 / self.k2
            self.tau0 = first(self.sense * theta / 2, -self.gap / self.k2)
            self.period = 2 * ellipk(self.m) / (self.k * self.W)

    def at(self, t):
        if self.gap > 0:
            sn, cn, _, _ = jacobi(self.W * t + self.tau0, self.k2)
            return [2 * asin(self.k * sn)], [2 * self.W * self.k * cn]
        _, _, dn, am = jacobi(self.k * self.W * t + self.tau0, self.m)
        return [2 * self.sense * am], [2 * self.sense * self.W * self.k * dn]


def cases():
    start = [0.3, 1.1, -0.7]
    for name, moments, rates in [
        ("oblate", [1.0, 1.0, 1.9], [1.0, 0.5, -0.2]),
        ("prolate", [0.2, 1.3, 1.3], [3.1, 0.4, 0.3]),
        ("asymmetric", [1.0, 2.0, 2.6], [0.8, 0.4, 0.3]),
        ("about_the_first_axis", [1.0, 1.3, 1.7], [1.1, 0.2, 0.1]),
        ("m_below_1/2", [1.0, 1.5, 2.2], [0.3, 1.2, 0.7]),
        ("hyperbolic", [1.0, 1.5, 2.2], [0.1, 1.0, 0.3]),
        ("about_the_middle_axis", [1.0, 2.0, 2.5], [1e-5, 1.3, 3e-5]),
        ("needle", [1e-4, 1.0, 1.00003], [12.0, 0.2, 0.5]),
        ("nearly_symmetric", [1.0, 1.0 + 1e-9, 1.7], [0.3, 0.2, 1.0]),
    ]:
        yield "free", name, moments + rates + start
    for name, body, rates in [
        ("waves", [1.0, 0.4, 1.0], [0.2, 0.9, 6.0]),
        ("cusps", [1.0, 0.4, 1.0], [0.0, 0.0, 6.0]),
        ("nearly_steady", [1.0, 0.4, 1.0], [-0.26178, 0.31079, 6.0]),
        ("loops", [1.0, 0.4, 1.0], [0.5, -0.6, 4.0]),
        ("fast", [1.0, 0.4, 1.0], [0.1, 0.0, 300.0]),
        ("slow", [1.0, 0.4, 1.0], [0.3, 0.2, 0.5]),
        ("heavy", [0.02, 0.011, 0.3], [2.0, 3.0, 13.0]),
        ("wide", [1.0, 0.3, 1.0], [1.3, 0.2, 1.0]),
        ("m_below_0.8", [1.0, 0.3, 1.0], [0.7, 0.2, 0.2]),
        ("m_above_0.8", [1.0, 0.3, 1.0], [0.8, 0.2, 0.2]),
        ("hanging", [1.0, 0.4, -1.0], [0.5, 0.6, 4.0]),
        ("hanging,_wide", [1.0, 0.4, -1.0], [1.5, 0.6, 0.3]),
    ]:
        yield "top", name, body + start + rates
    yield "top", "beside_the_upright_standstill", [1.0, 0.5, 1.0, 0.0, 1e-5, 0.0, 0.0, 0.0, 3.9]
    yield "top", "through_the_pole", [1.0, 0.5, 1.0, 0.3, 0.0, -0.7, 0.4, 0.3, 5.0]
    rod = [1.0 / 3.0, 1.0, 9.80665, 0.5]
    for name, motion in [
        ("small", [1e-3, 0.0]),
        ("one_radian", [1.0, 0.3]),
        ("three_radians", [3.0, 0.0]),
        ("from_upright", [3.14159, 0.0]),
        ("turning_over", [0.5, 9.0]),
        ("just_over", [-1.0, -6.7333]),
    ]:
        yield "pendulum", name, rod + motion


KINDS = {"free": Free, "top": Top, "pendulum": Pendulum}

if __name__ == "__main__":
    with open(sys.argv[1], "w") as file:
        for kind, name, inputs in cases():
            motion = KINDS[kind](inputs)
            for periods in ["1", "1e3", "1e6", "1e9", "1e12"]:
                t = float((mpf(periods) + mpf("0.37")) * motion.period)
                place, rates = motion.at(mpf(t))
                values = [nstr(x, 25, min_fixed=0, max_fixed=0) for x in place + rates]
                numbers = [repr(float(x)) for x in inputs] + [periods, repr(t)]
                file.write(" ".join([kind, name] + numbers + values) + "\n")
