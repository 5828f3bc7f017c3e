#!/usr/bin/env python3
"""Writes the references of tests/exact/elliptic.rs: `elliptic.py elliptic.json`.

Needs mpmath and python-flint (Arb). Jacobi: descending arithmetic-geometric mean
at 700 digits; Carlson and Legendre: Arb's R_F and R_J at 3000 bits with 1-m and
1-n formed exactly. Neither shares code or method with the library.
"""

import json, math, random, sys
import mpmath as mp
from mpmath import mpf
from flint import arb, acb, ctx

ctx.prec = 3000
mp.mp.dps = 120
PI = mp.pi


def agmK(m1):
    return PI / (2 * mp.agm(mpf(1), mp.sqrt(m1)))


def jac(u, m, m1):
    if m == 0:
        return mp.sin(u), mp.cos(u), mpf(1), u
    a, b, c = mpf(1), mp.sqrt(m1), mp.sqrt(m)
    A, C = [a], [c]
    while abs(c / a) > mpf(10) ** (-mp.mp.dps - 5):
        a1 = (a + b) / 2
        c = c * c / (4 * a1)
        b = mp.sqrt(a * b)
        a = a1
        A.append(a)
        C.append(c)
    phi = mpf(2) ** (len(A) - 1) * a * u
    for k in range(len(A) - 1, 0, -1):
        phi = (phi + mp.asin(C[k] / A[k] * mp.sin(phi))) / 2
    s, c = mp.sin(phi), mp.cos(phi)
    return s, c, mp.sqrt(m1 + m * c * c), phi


def A(x):
    return arb(float(x)) if not isinstance(x, mpf) else arb(mp.nstr(x, 800))


def back(v):
    assert float(v.rel_accuracy_bits()) > 1500, (v,)
    return mpf(v.str(400, radius=False))


def rf(*a):
    return back(acb.elliptic_rf(*[acb(A(x)) for x in a]).real)


def rj(*a):
    return back(acb.elliptic_rj(*[acb(A(x)) for x in a]).real)


def rd(x, y, z):
    return rj(x, y, z, z)


def rc(x, y):
    return rf(x, y, y)


# Legendre by Carlson in Arb, exact mpf complements (400 digits)
def parts(phi, m1):
    j = mp.nint(phi / PI)
    r = phi - j * PI
    s, c = mp.sin(r), mp.cos(r)
    return j, s, c, c * c + m1 * s * s


def comp(kind, m1, n1=None):
    m = 1 - m1
    if kind == "F":
        return agmK(m1)
    if kind == "E":
        return rf(mpf(0), m1, mpf(1)) - m / 3 * rd(mpf(0), m1, mpf(1)) if m1 else mpf(1)
    if kind == "D":
        return rd(mpf(0), m1, mpf(1)) / 3
    return rf(mpf(0), m1, mpf(1)) + (1 - n1) / 3 * rj(mpf(0), m1, mpf(1), n1)


def inc(kind, phi, m1, n1=None):
    j, s, c, w = parts(phi, m1)
    m = 1 - m1
    if kind == "F":
        v = s * rf(c * c, w, mpf(1))
    elif kind == "E":
        v = s * rf(c * c, w, mpf(1)) - m / 3 * s**3 * rd(c * c, w, mpf(1)) if w else s
    elif kind == "D":
        v = s**3 / 3 * rd(c * c, w, mpf(1))
    else:
        v = s * rf(c * c, w, mpf(1)) + (1 - n1) / 3 * s**3 * rj(
            c * c, w, mpf(1), c * c + n1 * s * s
        )
    return v + 2 * j * comp(kind, m1, n1) if j else v


def pack(v):
    hi = float(mp.nstr(v, 60))
    return dict(value=mp.nstr(v, 40, min_fixed=1, max_fixed=0), low=float(v - mpf(hi)))


fams = {}


def add(name, args, vals, cond=None):
    r = dict(arguments=args, results=[pack(v) for v in vals])
    if cond is not None:
        r["condition"] = [float(mp.nstr(c, 17)) for c in cond]
    fams.setdefault(name, []).append(r)


R = random.Random(20261121)
lu = lambda a, b: 10 ** R.uniform(a, b)


def addjac(name, u, p, kind):
    old = mp.mp.dps
    mp.mp.dps = 700
    P = mpf(p)
    m, m1 = {"m": (P, 1 - P), "k": (P * P, 1 - P * P), "m1": (1 - P, P)}[kind]
    if m1 == 0:
        U = mpf(u)
        s, c = mp.tanh(U), mp.sech(U)
        d = c
        am = mp.atan(mp.sinh(U))
    else:
        s, c, d, am = jac(mpf(u), m, m1)
    U = mpf(u)
    # condition of the absolute error: |u f'(u)|
    add(
        name,
        [u, p],
        [s, c, d, am],
        [abs(U * c * d), abs(U * s * d), abs(U * m * s * c), abs(U * d)],
    )
    mp.mp.dps = old


def K(p, kind):
    P = mpf(p)
    m1 = {"m": 1 - P, "k": 1 - P * P, "m1": P}[kind]
    return float(agmK(m1))


for i in range(12):
    m = R.random()
    addjac("jacobi_generic", R.uniform(-1, 1) * K(m, "m"), m, "m")
for u, m in (
    (1.0, 0.5),
    (-1.7, 0.5),
    (1.3, 0.5000000000000001),
    (-1.178061769633577, 0.5811521325045647),
    (0.7, 0.0),
    (0.0, 0.3),
    (1e-200, 0.9),
    (-0.3, 1.0),
    (25.0, 1.0),
):
    addjac("jacobi_generic", u, m, "m")
for i in range(10):
    m = 1 - lu(-16, -3)
    addjac("jacobi_near_one", R.uniform(-1, 1) * K(m, "m"), m, "m")
for u, m in (
    (-11.64835228604657, 0.9999999988802507),
    (-19.272227646232718, 1 - 2.0**-52),
    (19.0, 1 - 2.0**-53),
):
    addjac("jacobi_near_one", u, m, "m")
for i in range(8):
    m = lu(-300, -3)
    addjac("jacobi_small", R.uniform(-1, 1) * K(m, "m"), m, "m")
for i in range(8):
    m = R.uniform(0.05, 0.95)
    addjac("jacobi_far", R.choice([-1, 1]) * K(m, "m") * lu(0, 4), m, "m")
for i in range(8):
    m = 1 - lu(-16, -3)
    addjac("jacobi_far_near_one", R.uniform(-100, 100) * K(m, "m"), m, "m")
for u, m in ((-542.4794392571798, 0.9999999999999961), (1873.5, 1 - 2.0**-53)):
    addjac("jacobi_far_near_one", u, m, "m")
for i in range(8):
    k = math.sqrt(R.random())
    addjac("jacobi_k", R.uniform(-1, 1) * K(k, "k"), k, "k")
addjac("jacobi_k", -16.9380052444828, 0.9999999999999847, "k")
mp.mp.dps = 700
for i in range(10):
    m1 = lu(-300, -3)
    addjac("jacobi_m1", R.uniform(-1, 1) * K(m1, "m1"), m1, "m1")
for u, m1 in ((300.0, 1e-300), (-345.0, 2.5e-300), (372.0, 5e-324)):
    addjac("jacobi_m1", u, m1, "m1")
mp.mp.dps = 120
for i in range(10):
    a = [lu(-3, 3) for _ in range(4)]
    add("rf", a[:3], [rf(*a[:3])])
    add("rd", a[:3], [rd(*a[:3])])
    add("rj", a, [rj(*a)])
    add("rc", a[:2], [rc(*a[:2])])
    a = [lu(-150, 150) for _ in range(4)]
    add("rf", a[:3], [rf(*a[:3])])
    add("rd", a[:3], [rd(*a[:3])])
    add("rj", a, [rj(*a)])
    add("rc", a[:2], [rc(*a[:2])])
for a in ([1.0, 2.0, 0.0], [0.0, 1e-150, 1e150], [3.0, 3.0, 3.0]):
    add("rf", a, [rf(*a)])
for a in (
    [0.0, 0.25],
    [2.0, 2.0],
    [2.0, 2.1],
    [2.1, 2.0],
    [2.25, 2.0],
    [1e-300, 1.0],
    [1.0, 1e-300],
):
    add("rc", a, [rc(*a)])
for a in ([0.0, 2.0, 1.0], [2.0, 3.0, 4.0], [0.0, 1e100, 1e-100]):
    add("rd", a, [rd(*a)])
for a in (
    [0.0, 1.0, 2.0, 3.0],
    [2.0, 3.0, 4.0, 5.0],
    [1.0, 2.0, 3.0, 1e-30],
    [1.0, 2.0, 3.0, 1e-60],
    [2.0, 3.0, 4.0, 4096.0],
    [2.0, 3.0, 4.0, 4097.0],
    [0.0, 3.0, 4.0, 1e9],
    [1.0, 2.0, 3.0, 1e60],
    [42.68652264732386, 181.92244449801538, 33.91333082328346, 8.616035765396207e-150],
    [1.5685362545379008e130, 1.4424155735320046e-122, 9.11395338052735e60, 3.349173522473967e53],
    [3.4526301177173613, 29.92100868775273, 361.30597125266127, 1.9651221072892907e-09],
    [0.22456244649964568, 0.037414312521692854, 0.11057090806235144, 1.1151099757871672e123],
    [0.0012516749249787918, 415.2969437547583, 0.0026657985188260533, 1.2841208988658644e76],
    [7.220948821293842e-94, 1.7176292146825802e-149, 1.1191127786277277e92, 4.617570209989128e121],
):
    add("rj", a, [rj(*a)])
mp.mp.dps = 800
near = lambda: (math.pi / 2 - lu(-15, -1)) if R.random() < 0.5 else R.uniform(0, math.pi / 2)
for i in range(10):
    p = near()
    m = R.random() if i % 2 else 1 - lu(-16, -3)
    m1 = 1 - mpf(m)
    for kd in ("F", "E", "D"):
        add(kd.lower(), [p, m], [inc(kd, mpf(p), m1)])
for p, m in (
    (1.5707963164346344, 0.9999999999999998),
    (math.pi / 2, 0.5),
    (math.pi / 2, 1 - 2.0**-53),
    (-3.0, 0.7),
    (22.0, 0.3),
    (-1e6, 0.9),
    (1e-200, 0.5),
    (math.pi, 0.9),
    (1.2, 0.0),
):
    for kd in ("F", "E", "D"):
        if kd == "D" and p < 1e-100 and p > 0:
            continue
        add(kd.lower(), [p, m], [inc(kd, mpf(p), 1 - mpf(m))])
for p, m in ((1.3, 1.0), (-0.4, 1.0)):
    P = mpf(p)
    add("f", [p, m], [mp.asinh(mp.tan(P))])
    add("e", [p, m], [mp.sin(P)])
add("e", [7.5, 1.0], [4 + mp.sin(mpf(7.5) - 2 * PI)])
for i in range(6):
    p = near()
    m1 = lu(-300, -3)
    for kd in ("F", "E", "D"):
        add(kd.lower() + "_m1", [p, m1], [inc(kd, mpf(p), mpf(m1))])
for i in range(10):
    m = R.random()
    n = [R.uniform(-1, 1), 1 - lu(-16, -3), -lu(1, 16), -lu(16, 150)][i % 4]
    p = near()
    add("pi", [n, p, m], [inc("P", mpf(p), 1 - mpf(m), 1 - mpf(n))])
km = 0.4628733846362644**2
for n, p, m in (
    (-1.432190604644356e104, 0.056651704517594305, km),
    (-1.0, 1.0, 0.5),
    (-1.0000000000000002, 1.0, 0.5),
    (0.0, 1.0, 0.5),
    (-5.0, 1.2, 0.0),
    (3.0, 0.5, 0.5),
    (0.9, 10.0, 0.6),
    (-7.0, -10.0, 0.6),
    (-1e300, 1.0, 0.25),
    (0.5, 1.3, 1.0),
):
    add("pi", [n, p, m], [inc("P", mpf(p), 1 - mpf(m), 1 - mpf(n))])
for i in range(6):
    add(
        "pi_n1_m1",
        *(lambda n1, p, m1: ([n1, p, m1], [inc("P", mpf(p), mpf(m1), mpf(n1))]))(
            lu(-300, -3), near(), lu(-300, 0)
        ),
    )
for i in range(6):
    n1, m1 = lu(-300, 0), lu(-300, 0)
    add("complete_pi_n1_m1", [n1, m1], [comp("P", mpf(m1), mpf(n1))])
for i in range(4):
    add(
        "pi_n1_m1",
        *(lambda n1, p, m1: ([n1, p, m1], [inc("P", mpf(p), mpf(m1), mpf(n1))]))(
            lu(-3, 0), near(), lu(-300, 0)
        ),
    )
for m1 in (1.0, 0.75, 0.5, 0.1, 1e-3, 1e-8, 2.0**-53, 1e-30, 1e-100, 1e-300):
    M = mpf(m1)
    add("k_m1", [m1], [agmK(M)])
    add("complete_e_m1", [m1], [comp("E", M)])
    add("complete_d_m1", [m1], [comp("D", M)])
for m in (1e-300, 1e-20, 1e-8, 0.01, 0.3, 0.5, 0.9, 1 - 2.0**-53):
    M = 1 - mpf(m)
    add("k", [m], [agmK(M)])
    add("complete_e", [m], [comp("E", M)])
    add("complete_d", [m], [comp("D", M)])
for n, m in (
    (-1e150, 0.3),
    (-30.0, 0.7),
    (-1.0, 0.5),
    (-0.5, 0.2),
    (0.3, 0.9),
    (0.999999, 0.5),
    (1 - 2.0**-53, 1 - 2.0**-53),
):
    add("complete_pi", [n, m], [comp("P", 1 - mpf(m), 1 - mpf(n))])
doc = dict(
    provenance="Exact doubles in, 40 digits out (low: the value minus its nearest double). Jacobi: descending AGM at 700 digits in mpmath. Carlson and Legendre: elliptic_rf and elliptic_rj of Arb (python-flint) at 3000 bits, with complements 1-m and 1-n formed exactly; K: AGM in mpmath. Rows: random (seed 20261121), the switching points of our own code, and inputs at which other libraries fail. condition: |u f'(u)|. Results of jacobi rows: sn, cn, dn, am.",
    families=fams,
)
with open(sys.argv[1], "w") as f:
    f.write('{\n"provenance": ' + json.dumps(doc["provenance"]) + ',\n"families": {\n')
    f.write(
        ",\n".join(
            '"%s": [\n%s\n]' % (k, ",\n".join(json.dumps(r) for r in v)) for k, v in fams.items()
        )
    )
    f.write("\n}\n}\n")
print({k: len(v) for k, v in fams.items()})
