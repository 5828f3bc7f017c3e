#!/usr/bin/env python3
"""Writes attitude.txt, the references of tests/bodies/attitude. Needs mpmath; fixed seed.

Inputs are doubles, taken as exact. A reference is computed with 700 digits (so that
angles of 1e-300 keep their meaning) and rounded once: to the nearest double, or, where
the test measures an error, to a pair of doubles (leading part, rest)."""
import random
import mpmath as mp
from mpmath import mpf

mp.mp.dps = 700
random.seed(15)
out = []


def row(kind, *numbers):
    out.append(" ".join([kind] + [repr(float(x)) for x in numbers]))


def pair(values):
    """All leading parts, then all rests."""
    return [float(v) for v in values] + [float(v - mpf(float(v))) for v in values]


def quaternion(phi, s, c, zeta):
    """Of Rz(phi) Rx(theta) Rz(zeta), s, c = sin, cos of theta/2."""
    a, b = (phi + zeta) / 2, (phi - zeta) / 2
    return [c * mp.cos(a), s * mp.cos(b), s * mp.sin(b), c * mp.sin(a)]


def wrap(x):
    while x > mp.pi:
        x -= 2 * mp.pi
    while x <= -mp.pi:
        x += 2 * mp.pi
    return x


def angles(q):
    w, x, y, z = q
    theta = 2 * mp.atan2(mp.hypot(x, y), mp.hypot(w, z))
    if x == 0 == y:
        return wrap(2 * mp.atan2(z, w)), theta, mpf(0)
    if w == 0 == z:
        return wrap(2 * mp.atan2(y, x)), theta, mpf(0)
    h, g = mp.atan2(z, w), mp.atan2(y, x)
    return wrap(h + g), theta, wrap(h - g)


def rotation_vector(q):
    if q[0] < 0:
        q = [-c for c in q]
    s = mp.sqrt(sum(c * c for c in q[1:]))
    return [2 * mp.atan2(s, q[0]) * c / s for c in q[1:]]


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [a*w - b*x - c*y - d*z, a*x + b*w + c*z - d*y, a*y - b*z + c*w + d*x, a*z + b*y - c*x + d*w]


def exact(values):
    return [mpf(float(v)) for v in values]


def some_angle():
    return mpf(random.uniform(-3.141592653589793, 3.141592653589793))


def some_axis():
    v = [mpf(random.gauss(0, 1)) for _ in range(3)]
    n = mp.sqrt(sum(c * c for c in v))
    return [c / n for c in v]


# --- Euler angles of quaternions: theta (or pi - theta) generic, small, tiny, zero
spans = [lambda: random.uniform(0.1, 3.0), lambda: 10 ** random.uniform(-20, -1),
         lambda: 10 ** random.uniform(-300, -20), lambda: 0.0]
for near_pi in (False, True):
    for span in spans:
        for _ in range(40):
            d = mpf(span())
            s, c = mp.sin(d / 2), mp.cos(d / 2)
            if near_pi:
                s, c = c, s
            q = [float(v) for v in quaternion(some_angle(), s, c, some_angle())]
            row("angles", *q, *angles(exact(q)))
# where trusted libraries were seen to fail
for q in ([0.9979827882148414, -4.6519431608838617e-08, 6.000597357401207e-09, -0.06348507247321],
          [-0.4438378500778439, 0.0008695422857050547, -0.00017574323287500404, 0.8961066766009541],
          [1.56e-18, 0.707119828422041, 0.7070937337103076, -1.19e-18],
          [0.9464822854831113, 3.7697429866966353e-14, 5.613550488603185e-14, 0.3227557641106759]):
    row("failed_elsewhere", *q, *angles(exact(q)))

# --- rotation vectors of quaternions: generic, near pi, near 0, w < 0
for sign, near_pi, span in ((1, False, lambda: random.uniform(0.1, 3.0)), (1, True, lambda: 10 ** random.uniform(-16, -1)),
                            (1, False, lambda: 10 ** random.uniform(-20, -1)), (1, False, lambda: 10 ** random.uniform(-300, -20)),
                            (-1, False, lambda: 10 ** random.uniform(-300, -1))):
    for _ in range(40):
        a = mpf(span())
        s, c = mp.sin(a / 2), mp.cos(a / 2)
        if near_pi:
            s, c = c, s
        q = [float(sign * c)] + [float(sign * s * v) for v in some_axis()]
        row("vector", *q, *rotation_vector(exact(q)))
for q in ([1.0, 9.46e-9, 8.89e-10, 2.88e-9], [0.9999999999999628, 2.64e-7, -2.01e-10, 6.92e-8]):
    row("vector", *q, *rotation_vector(exact(q)))
a = mp.pi - mpf(10) ** -16
q = [float(mp.cos(a / 2))] + [float(mp.sin(a / 2) * mpf(v)) for v in ("-0.1245", "0.1766", "-0.9764")]
n = mp.sqrt(sum(c * c for c in exact(q)))
q = [float(c / n) for c in exact(q)]
row("vector", *q, *rotation_vector(exact(q)))

# --- quaternions of Euler angles, up to 1e15 rad
for size in (0.0, 1.0, 6.0, 15.0):
    for _ in range(40):
        big = lambda: random.choice((-1, 1)) * 10 ** random.uniform(size - 1, size) if size else float(some_angle())
        phi, zeta = big(), big()
        theta = random.choice((random.uniform(0, 3.14), 10 ** random.uniform(-300, -1), 3.141592653589793))
        p, t, z = exact((phi, theta, zeta))
        row("from_angles", phi, theta, zeta, *pair(quaternion(p, mp.sin(t / 2), mp.cos(t / 2), z)))

# --- quaternions of rotation vectors
for size in (-300, -10, -1, 0.5, 6, 15):
    for _ in range(30):
        v = [float(c * mpf(10) ** random.uniform(size - 1, size)) for c in some_axis()]
        e = exact(v)
        n = mp.sqrt(sum(c * c for c in e))
        row("from_vector", *v, *pair([mp.cos(n / 2)] + [mp.sin(n / 2) * c / n for c in e]))

# --- normalisation
for power in (-300, -150, 0, 150, 300):
    for _ in range(20):
        q = [random.gauss(0, 1) * 10.0 ** power for _ in range(4)]
        n = mp.sqrt(sum(c * c for c in exact(q)))
        row("unit", *q, *[c / n for c in exact(q)])

# --- angle between two attitudes: neighbours, small, generic, near pi
for d in (0.0, -15.5, -12, -6, -1, 0.4, None):
    for _ in range(20):
        q = [mpf(random.gauss(0, 1)) for _ in range(4)]
        n = mp.sqrt(sum(c * c for c in q))
        q = [c / n for c in q]
        a = mp.pi - mpf(10) ** random.uniform(-16, -1) if d is None else mpf(10) ** mpf(d) if d else mpf(0)
        p = product(q, [mp.cos(a / 2)] + [mp.sin(a / 2) * c for c in some_axis()])
        q, p = [float(c) for c in q], [float(c) for c in p]
        if d == 0.0:
            p[random.randrange(4)] *= 1 + 2.0 ** -52
        e = product([c * s for c, s in zip(exact(q), (1, -1, -1, -1))], exact(p))
        row("between", *q, *p, 2 * mp.atan2(mp.sqrt(sum(c * c for c in e[1:])), abs(e[0])))

# --- matrices of quaternions that are unit to the last bit
for span in spans + [lambda: 3.141592653589793]:
    for _ in range(30):
        d = mpf(span())
        q = [float(v) for v in quaternion(some_angle(), mp.sin(d / 2), mp.cos(d / 2), some_angle())]
        w, x, y, z = exact(q)
        n = w*w + x*x + y*y + z*z
        m = [w*w+x*x-y*y-z*z, 2*(x*y-w*z), 2*(x*z+w*y), 2*(x*y+w*z), w*w-x*x+y*y-z*z, 2*(y*z-w*x),
             2*(x*z-w*y), 2*(y*z+w*x), w*w-x*x-y*y+z*z]
        row("matrix", *q, *pair([v / n for v in m]))

with open(__file__.replace(".py", ".txt"), "w") as f:
    f.write("# written by attitude.py with mpmath %s\n" % mp.__version__)
    f.write("\n".join(out) + "\n")
