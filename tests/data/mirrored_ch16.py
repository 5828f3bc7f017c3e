#!/usr/bin/env python3
"""Writes mirrored_ch16.json: exercises of chapter 16 with signs, limits and thresholds, for
tests/pages/reference_statics. Needs mpmath.

Values: closed forms at 60 digits, inputs as exact doubles; sens: sum of |x df/dx| over the
inputs x, by central differences."""
import json
import os
from mpmath import mp, mpf, acos, ellipk, pi, sin, sqrt

mp.dps = 60


def atwood(m1, m2, I, R, g):
    part = g / (m1 + m2 + I / R**2)
    a = (m1 - m2) * part
    return {"a": a, "T1": m1 * (g - a), "T2": m2 * (g + a)}


def conical(M, l, g, omega):
    cone = l * omega**2 > g
    return {
        "theta": acos(g / (l * omega**2)) if cone else mpf(0),
        "tension": M * l * omega**2 if cone else M * g,
        "omega_threshold": sqrt(g / l),
    }


def corner(R, m, g, mu, Omega):
    """Pressed to the wall, which is on the right if Omega is negative."""
    floor = m * g / (1 + mu**2)
    alpha = mu * (floor + mu * floor) * R / (m * R**2 / 2)
    stop = abs(Omega) / alpha
    turns = abs(Omega) * stop / 2 / (2 * pi)
    return {"N_floor": floor, "N_wall": mu * floor, "alpha": alpha, "t_stop": stop, "turns": turns}


def rod_disk(l, m, M, R, g, theta0):
    out = {}
    for name, own in (("rigid", M * R**2 / 2), ("free", 0)):
        inertia = m * l**2 / 3 + M * l**2 + own
        small = 2 * pi * sqrt(inertia / ((m / 2 + M) * g * l))
        wide = small * ellipk(sin(theta0 / 2) ** 2) * 2 / pi
        out |= {f"I_{name}": inertia, f"T_small_{name}": small, f"T_amp_{name}": wide}
    return out


G = 9.80665
CASES = {
    "atwood": (atwood, {
        "lighter-first": dict(m1=2.0, m2=3.0, I=0.02, R=0.1, g=G),
        "much-lighter-first": dict(m1=0.013, m2=7.9, I=0.004, R=0.31, g=1.62),
        "light-pulley": dict(m1=1.7, m2=2.6, I=1e-3, R=0.2, g=G),
        "heavy-pulley": dict(m1=1.7, m2=2.6, I=40.0, R=0.05, g=G),
    }),
    "conical": (conical, {
        "other-way": dict(M=0.4, l=0.8, g=G, omega=-5.0),
        "just-above": dict(M=0.4, l=0.8, g=G, omega=3.5015),
        "a-hair-above": dict(M=0.4, l=0.8, g=G, omega=3.501188),
        "just-below": dict(M=0.4, l=0.8, g=G, omega=3.501),
        "below-other-way": dict(M=0.7, l=1.3, g=G, omega=-1.1),
        "at-rest": dict(M=0.4, l=0.8, g=G, omega=0.0),
        "fast": dict(M=0.4, l=0.8, g=G, omega=4000.0),
    }),
    "corner": (corner, {
        "other-way": dict(R=0.1, m=3.0, g=G, mu=0.25, Omega=-60.0),
        "smooth": dict(R=0.1, m=3.0, g=G, mu=2e-5, Omega=60.0),
        "rough": dict(R=0.07, m=1.3, g=1.62, mu=9.0, Omega=-13.0),
        "slow": dict(R=0.1, m=3.0, g=G, mu=0.25, Omega=1e-6),
    }),
    "rod_disk": (rod_disk, {
        "other-side": dict(l=1.0, m=0.6, M=1.1, R=0.2, g=G, theta0=-1.0),
        "all-but-upright": dict(l=1.0, m=0.6, M=1.1, R=0.2, g=G, theta0=3.141),
        "a-touch": dict(l=1.0, m=0.6, M=1.1, R=0.2, g=G, theta0=-1e-5),
        "wheel": dict(l=0.5, m=0.6, M=1.1, R=4.0, g=G, theta0=0.7),
        "point": dict(l=1.0, m=0.6, M=1.1, R=1e-6, g=G, theta0=0.7),
    }),
}


def sens(of, inputs, field):
    total = mpf(0)
    for name, x in inputs.items():
        moved = [of(**(inputs | {name: x * (1 + h)}))[field] for h in (mpf(10) ** -20, -mpf(10) ** -20)]
        total += abs(moved[0] - moved[1]) / (2 * mpf(10) ** -20)
    return float(mp.nstr(total, 3))


def case(problem, name, of, inputs):
    exact = {key: mpf(value) for key, value in inputs.items()}
    return {
        "id": f"st-{problem}-{name}",
        "kind": "static",
        "problem": problem,
        "inputs": inputs,
        "expect": {key: mp.nstr(value, 25) for key, value in of(**exact).items()},
        "sens": {key: sens(of, exact, key) for key in of(**exact)},
    }


cases = [case(problem, name, of, inputs) for problem, (of, named) in CASES.items() for name, inputs in named.items()]
body = ",\n".join(json.dumps(c) for c in cases)
note = "signs, limits and thresholds of chapter 16; written by mirrored_ch16.py"
with open(os.path.join(os.path.dirname(__file__), "mirrored_ch16.json"), "w") as out:
    out.write(f'{{"schema": "rigid-oracle/1", "note": "{note}", "cases": [\n{body}\n]}}\n')
