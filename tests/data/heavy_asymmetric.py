#!/usr/bin/env python3
"""Writes the references for heavy asymmetric bodies: `heavy_asymmetric.py heavy_asymmetric.json`.

Needs gmpy2. There is no closed form. Two routes, each a Taylor series with its own
equations, order, step and precision, must agree to 30 digits:

  A: angular velocity on the body's axes and two rows of R, 192 bits, order 56;
  B: quaternion and angular momentum on the fixed axes, 224 bits, order 40.

Inputs: moments I about the fixed point, weight m g and lever l (centre of mass at
l e3), z-x-z angles, body rates; all exact binary64, products formed exactly. Values:
25 digits. sens, sens_norm, sens_path: first order, by differences at 1e-16.
"""

import json, math, multiprocessing, random, sys
from operator import mul

import gmpy2
from gmpy2 import mpfr


def precision(bits):
    gmpy2.get_context().precision = bits


def conv(a, b, k):
    return sum(map(mul, a[: k + 1], b[k::-1]), mpfr(0))


def horner(series, h):
    value = series[-1]
    for c in reversed(series[:-1]):
        value = value * h + c
    return value


def carry(series, y, t0, t1, order, bits):
    """Taylor steps: the two last terms stay below 2^-bits of the state."""
    t, tol = mpfr(t0), mpfr(2) ** (8 - bits)
    while t != t1:
        s = series(y, order)
        h = None
        for c in s:
            for k in (order, order - 1):
                if c[k] != 0:
                    size = max(abs(c[0]), mpfr(1))
                    hk = gmpy2.exp(gmpy2.log(tol * size / abs(c[k])) / k)
                    h = hk if h is None else min(h, hk)
        rest = t1 - t
        if h is None or h >= abs(rest):
            h, t = rest, mpfr(t1)
        else:
            h = h if rest > 0 else -h
            t = t + h
        y = [horner(c, h) for c in s]
    return y


# ------------------------------------------------------------------ route A


def body_series(I, P):
    I1, I2, I3 = I
    k1, k2, k3 = (I2 - I3) / I1, (I3 - I1) / I2, (I1 - I2) / I3
    p1, p2 = P / I1, -P / I2

    def series(y, order):
        w1, w2, w3 = [y[0]], [y[1]], [y[2]]
        a = [[y[3]], [y[4]], [y[5]]]  # the space axis X on the body's axes
        b = [[y[6]], [y[7]], [y[8]]]  # the space axis Z
        for k in range(order):
            p = lambda u, v: conv(u, v, k)
            r = k + 1
            # I w' = I w x w + P (Z x e3), Z x e3 = (b2, -b1, 0)
            n1 = (k1 * p(w2, w3) + p1 * b[1][k]) / r
            n2 = (k2 * p(w3, w1) + p2 * b[0][k]) / r
            n3 = k3 * p(w1, w2) / r
            new = [
                (
                    (p(e[1], w3) - p(e[2], w2)) / r,
                    (p(e[2], w1) - p(e[0], w3)) / r,
                    (p(e[0], w2) - p(e[1], w1)) / r,
                )
                for e in (a, b)
            ]
            w1.append(n1), w2.append(n2), w3.append(n3)
            for e, n in zip((a, b), new):
                for i in range(3):
                    e[i].append(n[i])
        return [w1, w2, w3] + a + b

    return series


def rotation(angles):
    (cf, sf), (ct, st), (cz, sz) = [(gmpy2.cos(x), gmpy2.sin(x)) for x in angles]
    return [
        [cf * cz - sf * ct * sz, -cf * sz - sf * ct * cz, sf * st],
        [sf * cz + cf * ct * sz, -sf * sz + cf * ct * cz, -cf * st],
        [st * sz, st * cz, ct],
    ]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def fields_a(I, y):
    w, a, b = y[:3], y[3:6], y[6:9]
    R = [a, cross(b, a), b]
    L = [sum(R[i][j] * I[j] * w[j] for j in range(3)) for i in range(3)]
    return {"omega": w, "R": R[0] + R[1] + R[2], "L_space": L}


def start_a(angles, omega):
    R = rotation(angles)
    return list(omega) + R[0] + R[2]


# ------------------------------------------------------------------ route B


def space_series(I, P):
    inv = [1 / i for i in I]

    def series(y, order):
        q = [[v] for v in y[:4]]
        L = [[v] for v in y[4:6]]
        l3 = y[6]
        for k in range(order):
            if k == 0:
                sq, R, w, e = {}, [[[] for _ in range(3)] for _ in range(3)], [[], [], []], None
            r = k + 1
            s = {}
            for i in range(4):
                for j in range(i, 4):
                    s[i, j] = conv(q[i], q[j], k)
            rows = [
                [s[0, 0] + s[1, 1] - s[2, 2] - s[3, 3], 2 * (s[1, 2] - s[0, 3]), 2 * (s[1, 3] + s[0, 2])],
                [2 * (s[1, 2] + s[0, 3]), s[0, 0] - s[1, 1] + s[2, 2] - s[3, 3], 2 * (s[2, 3] - s[0, 1])],
                [2 * (s[1, 3] - s[0, 2]), 2 * (s[2, 3] + s[0, 1]), s[0, 0] - s[1, 1] - s[2, 2] + s[3, 3]],
            ]
            for i in range(3):
                for j in range(3):
                    R[i][j].append(rows[i][j])
            for j in range(3):
                l = conv(R[0][j], L[0], k) + conv(R[1][j], L[1], k) + R[2][j][k] * l3
                w[j].append(l * inv[j] / 2)
            p = lambda i, j: conv(q[i], w[j], k)
            n = [
                (-p(1, 0) - p(2, 1) - p(3, 2)) / r,
                (p(0, 0) + p(2, 2) - p(3, 1)) / r,
                (p(0, 1) + p(3, 0) - p(1, 2)) / r,
                (p(0, 2) + p(1, 1) - p(2, 0)) / r,
            ]
            # L' = P Z x e3 = P (-e_Y, e_X, 0)
            t = [-P * R[1][2][k] / r, P * R[0][2][k] / r]
            for i in range(4):
                q[i].append(n[i])
            for i in range(2):
                L[i].append(t[i])
        return q + L + [[l3] + [mpfr(0)] * order]

    return series


def fields_b(I, y):
    w, x, yy, z = y[:4]
    R = [
        [w * w + x * x - yy * yy - z * z, 2 * (x * yy - w * z), 2 * (x * z + w * yy)],
        [2 * (x * yy + w * z), w * w - x * x + yy * yy - z * z, 2 * (yy * z - w * x)],
        [2 * (x * z - w * yy), 2 * (yy * z + w * x), w * w - x * x - yy * yy + z * z],
    ]
    L = y[4:7]
    omega = [sum(R[i][j] * L[i] for i in range(3)) / I[j] for j in range(3)]
    return {"omega": omega, "R": R[0] + R[1] + R[2], "L_space": L}


def start_b(I, angles, omega):
    f, t, z = [x / 2 for x in angles]
    ct, st = gmpy2.cos(t), gmpy2.sin(t)
    q = [ct * gmpy2.cos(f + z), st * gmpy2.cos(f - z), st * gmpy2.sin(f - z), ct * gmpy2.sin(f + z)]
    R = rotation(angles)
    return q + [sum(R[i][j] * I[j] * omega[j] for j in range(3)) for i in range(3)]


# ------------------------------------------------------------------ a case

FIELDS = ("omega", "R", "L_space")


def exact(case):
    I = [mpfr(x) for x in case["I"]]
    P = mpfr(case["weight"]) * mpfr(case["lever"])
    angles = [mpfr(x) for x in case["euler0"]]
    omega = [mpfr(x) for x in case["omega0"]]
    return I, P, angles, omega


def run_a(I, P, y, times, order, bits):
    t, out = 0, []
    series = body_series(I, P)
    for end in times:
        y = carry(series, y, t, mpfr(end), order, bits)
        t = mpfr(end)
        out.append(y)
    return out


def biggest(f, g):
    return {k: float(max(abs(a - b) for a, b in zip(f[k], g[k]))) for k in FIELDS}


def sensitivities(case, times):
    """Per sample: sens, sens_norm, sens_path, in plain numbers."""
    bits, order = 128, 32
    precision(bits)
    d = mpfr(10) ** -16
    I, P, angles, omega = exact(case)
    base = run_a(I, P, start_a(angles, omega), times, order, bits)
    at = [fields_a(I, y) for y in base]
    sens = [dict.fromkeys(FIELDS, 0.0) for _ in times]
    norm = [dict.fromkeys(FIELDS, 0.0) for _ in times]

    def change(I2, P2, angles2, omega2, relative, normwise):
        run = run_a(I2, P2, start_a(angles2, omega2), times, order, bits)
        for s, n, f, y in zip(sens, norm, at, run):
            for k, v in biggest(f, fields_a(I2, y)).items():
                s[k] += relative * v / float(d)
                n[k] += normwise * v / float(d)

    largest = float(max(I))
    for i in range(3):
        moved = [I[j] + (d if j == i else 0) for j in range(3)]
        change(moved, P, angles, omega, float(I[i]), largest)
    # weight and lever: the product, for each of them
    change(I, P + d * abs(P), angles, omega, 2.0, 2.0)
    for i in range(3):
        moved = [angles[j] + (d if j == i else 0) for j in range(3)]
        change(I, P, moved, omega, abs(float(angles[i])), 1.0)
    fastest = max(abs(float(w)) for w in omega)
    for i in range(3):
        moved = [omega[j] + (d if j == i else 0) for j in range(3)]
        change(I, P, angles, moved, abs(float(omega[i])), fastest)
    for s, n, y, t in zip(sens, norm, base, times):
        series = body_series(I, P)(y, 2)
        rate = fields_a(I, [c[1] for c in series])["omega"], [c[1] for c in series]
        a, da, b, db = y[3:6], rate[1][3:6], y[6:9], rate[1][6:9]
        c = [u + v for u, v in zip(cross(db, a), cross(b, da))]
        moving = {"omega": rate[0], "R": da + c + db}
        w, dw, R = y[:3], rate[0], [a, cross(b, a), b]
        dR = [da, c, db]
        moving["L_space"] = [
            sum(I[j] * (dR[i][j] * w[j] + R[i][j] * dw[j]) for j in range(3)) for i in range(3)
        ]
        for k in FIELDS:
            v = float(max(abs(x) for x in moving[k])) * abs(t)
            s[k] += v
            n[k] += v
    return sens, norm, path(case, times, order, bits, d)


def path(case, times, order, bits, d):
    """The largest norm-wise sensitivity to the state at one of 10 times on the way."""
    I, P, angles, omega = exact(case)
    out = []
    for end in times:
        stops = [mpfr(end) * k / 10 for k in range(1, 11)]
        y, t, worst = start_a(angles, omega), mpfr(0), dict.fromkeys(FIELDS, 0.0)
        carried = []  # perturbed states, each with its weight, by the stop they started at
        series = body_series(I, P)
        size = max(abs(w) for w in omega)
        for stop, to in enumerate(stops):
            if stop > 0:
                group = []
                size = max(size, *[abs(w) for w in y[:3]])
                for i in range(3):
                    moved = list(y)
                    moved[i] += d * size
                    group.append(moved)
                axes = ([0, -d, 0], [d, 0, 0], [0, 0, d])
                for turn in ([d, 0, 0], [0, d, 0], [0, 0, d]):
                    moved = list(y)
                    for at in (3, 6):
                        e = y[at : at + 3]
                        moved[at : at + 3] = [u + v for u, v in zip(e, cross(e, turn))]
                    group.append(moved)
                carried.append(group)
            y = carry(series, y, t, to, order, bits)
            carried = [[carry(series, z, t, to, order, bits) for z in g] for g in carried]
            t = to
        base = fields_a(I, y)
        for group in carried:
            total = dict.fromkeys(FIELDS, 0.0)
            for z in group:
                for k, v in biggest(base, fields_a(I, z)).items():
                    total[k] += v / float(d)
            for k in FIELDS:
                worst[k] = max(worst[k], total[k])
        out.append(worst)
    return out


def decimals(x):
    if x == 0:
        return "0"
    return "{0:.24e}".format(x)


def solve(case):
    times = case["times"]
    precision(192)
    I, P, angles, omega = exact(case)
    a = [fields_a(I, y) for y in run_a(I, P, start_a(angles, omega), times, 56, 192)]
    precision(224)
    I, P, angles, omega = exact(case)
    y, t, b, series = start_b(I, angles, omega), 0, [], space_series(I, P)
    for end in times:
        y = carry(series, y, t, mpfr(end), 40, 224)
        t = mpfr(end)
        b.append(fields_b(I, y))
    off = max(max(biggest(f, g).values()) for f, g in zip(a, b))
    digits = -math.log10(off) if off > 0 else 60.0
    assert digits >= 30, (case["id"], digits)
    sens, norm, on_path = sensitivities(case, times)
    precision(224)
    short = lambda d: {k: float("%.3g" % v) for k, v in d.items()}
    samples = [
        {
            "t": t,
            **{k: [decimals(v) for v in f[k]] for k in FIELDS},
            "sens": short(s),
            "sens_norm": short(n),
            "sens_path": short(p),
        }
        for t, f, s, n, p in zip(times, b, sens, norm, on_path)
    ]
    print(case["id"], "%.1f" % digits, [s["sens_norm"]["R"] for s in samples], [s["sens_path"]["R"] for s in samples], flush=True)
    return {
        "id": case["id"],
        "kind": "heavy_asymmetric",
        "ref": "16.2",
        "title": case["id"],
        "inputs": {k: case[k] for k in ("I", "weight", "lever", "euler0", "omega0")},
        "derived": {},
        "samples": samples,
        "check": {"method": "Taylor, two sets of equations", "agree_digits": int(digits)},
    }


def cases():
    r = random.Random(20)
    num = lambda lo, hi: round(r.uniform(lo, hi), 6)

    def moments():
        while True:
            I = [num(0.3, 3.0) for _ in range(3)]
            if all(I[i] < 0.97 * (I[(i + 1) % 3] + I[(i + 2) % 3]) for i in range(3)):
                return I

    def angles():
        return [num(-3, 3), num(0.1, 3.0), num(-3, 3)]

    out = []

    def add(id, I, weight, lever, euler0, omega0, times):
        out.append(dict(id=id, I=I, weight=weight, lever=lever, euler0=euler0, omega0=omega0, times=times))

    for k in range(20):  # torque and rotation of the same size
        t = num(2, 15)
        add(f"random-{k}", moments(), num(0.2, 3), num(-1, 1), angles(), [num(-2, 2) for _ in range(3)], [round(t / 7, 6), t, 2 * t])
    for k in range(6):  # fast against a small torque
        size = 10 ** -(1 + k / 2)
        add(f"weak-{k}", moments(), round(size, 8), num(0.4, 1), angles(), [num(-1.5, 1.5) for _ in range(3)], [num(3, 6), num(20, 30)])
    for k in range(4):  # a spin of 10 to 80 about one axis
        spin = [num(-0.5, 0.5) for _ in range(3)]
        spin[k % 3] = 10.0 * 2**k
        add(f"spin-{k}", moments(), num(0.5, 2), 1.0, angles(), spin, [num(1, 2), num(2, 4)])
    for k in range(4):  # from rest
        add(f"rest-{k}", moments(), 1.0, num(0.3, 1), angles(), [0.0, 0.0, 0.0], [num(2, 4), num(6, 12)])
    for k, off in enumerate([1e-3, 1e-6, 1e-9]):  # hardly asymmetric
        i = num(0.8, 1.5)
        add(f"near-symmetric-{k}", [i, i + off, num(0.5, 1.5)], 1.0, 0.7, angles(), [num(-1, 1), num(-1, 1), 3.0], [5.0, 20.0])
    for k, off in enumerate([1e-2, 1e-4, 1e-7]):  # off the middle axis, hardly any torque
        add(f"middle-axis-{k}", [1.0, 2.0, 2.5], off, 1.0, angles(), [off, 1.0, off], [5.0, 20.0])
    add("kovalevskaya-0", [2.0, 1.0, 2.0], 1.0, 0.5, [0.3, 1.1, 0.4], [0.4, 0.9, -0.7], [4.0, 20.0])
    add("kovalevskaya-1", [1.0, 2.0, 2.0], 1.0, 1.0, [0.3, 2.1, -0.4], [1.4, -0.9, 0.7], [4.0, 15.0])
    add("disc", [1.0, 1.5, 2.5], 1.0, 0.5, [0.0, 1.2, 0.5], [0.3, -0.2, 4.0], [4.0, 20.0])
    add("needle", [1.0, 1.0 + 2**-10, 2**-9], 1.0, 0.5, [0.0, 0.9, 0.5], [0.3, -0.2, 25.0], [4.0, 20.0])
    add("hanging", [1.0, 1.3, 0.4], 2.0, -0.5, [0.2, 1e-3, 0.1], [1e-3, 0.0, 0.5], [4.0, 25.0])
    add("upright", [1.0, 1.3, 0.4], 1.0, 0.5, [0.0, 0.0, 0.0], [1e-4, 0.0, 9.0], [2.0, 8.0])
    add("pole", [1.0, 1.5, 0.8], 1.0, 0.4, [0.0, 1.0, 0.0], [-1.8, 1e-4, 1e-4], [3.0, 12.0])
    add("back", [1.0, 1.5, 0.8], 1.0, 0.4, [1.0, 1.0, 2.0], [0.8, 0.6, 1.1], [-2.0, -14.0])
    add("spherical", [1.2, 1.2, 1.2], 1.0, 0.4, [1.0, 1.0, 2.0], [0.8, 0.6, 1.1], [3.0, 14.0])
    return out


def main():
    with multiprocessing.Pool(2) as pool:
        done = pool.map(solve, cases(), chunksize=1)
    note = "Heavy asymmetric bodies, centre of mass on e3. Values: Taylor series in two sets of equations; sensitivities by differences at 1e-16."
    head = json.dumps({"schema": "rigid-oracle/1", "set": "heavy-asymmetric", "note": note})[:-1]
    with open(sys.argv[1], "w") as file:
        file.write(head + ', "cases": [\n' + ",\n".join(json.dumps(c) for c in done) + "\n]}\n")


if __name__ == "__main__":
    main()
