"""Mirrored and extreme cases of the problems without a motion: mirrored_ch15.json.

Closed forms at 60 digits of the inputs as doubles; `sens` is the sum over the inputs of
|input * d(field)/d(input)|, by differences, the largest of a field's numbers.
    python3 mirrored_ch15.py > mirrored_ch15.json
"""
import json
from mpmath import cos, mp, mpf, sin, tan

mp.dps = 60


def coins(M, R1, R2, Omega):
    net = (1 + R1 / R2) * Omega
    return dict(Omega_spin=R1 / R2 * Omega, Omega_net=net, turns_per_orbit=1 + R1 / R2,
                L=M * (R1 + R2) ** 2 * Omega + M * R2 ** 2 / 2 * net,
                T=M * (R1 + R2) ** 2 * Omega ** 2 / 2 + M * R2 ** 2 / 4 * net ** 2)


def cone(M, h, alpha, Omega, rise):
    """The axis rises by this angle: moments about the vertex, spin without slip."""
    I3 = mpf(3) / 10 * M * h ** 2 * tan(alpha) ** 2
    I1 = mpf(3) / 5 * M * h ** 2 * (1 + tan(alpha) ** 2 / 4)
    # The line from the vertex to the contact is at rest: rho, or rho - tan(alpha) z.
    along, up = (-Omega / tan(alpha), 0 * Omega) if rise else (-Omega / tan(alpha), Omega)
    axis, across = (cos(rise), sin(rise)), (-sin(rise), cos(rise))
    w3, wp = along * axis[0] + up * axis[1], along * across[0] + up * across[1]
    spin = -Omega / sin(alpha) if rise else -Omega / tan(alpha)
    return dict(omega_rho=along, omega_z=up, spin=spin,
                L_rho=I3 * w3 * axis[0] + I1 * wp * across[0],
                L_z=I3 * w3 * axis[1] + I1 * wp * across[1],
                T=(I3 * w3 ** 2 + I1 * wp ** 2) / 2)


def cone_side(M, h, alpha, Omega):
    return cone(M, h, alpha, Omega, alpha)


def cone_raised(M, h, alpha, Omega):
    return cone(M, h, alpha, Omega, 0)


def rod_free(M, l, v):
    I = 5 * M * l ** 2 / 24
    return dict(v_cm=v / 2, L_cm=M * v * l / 4, I_cm=I, Omega=M * v * l / 4 / I,
                KE_before=M * v ** 2 / 2, KE_after=M * (v / 2) ** 2 + (M * v * l / 4) ** 2 / I / 2)


def gears(I1, I2, R1, R2, Omega1):
    Omega2 = -Omega1 * R1 / R2
    return dict(Omega2=Omega2, L=I1 * Omega1 + I2 * Omega2, T=(I1 * Omega1 ** 2 + I2 * Omega2 ** 2) / 2)


def discs(I1, I2, Omega1, Omega2, tau):
    reduced = I1 * I2 / (I1 + I2)
    return dict(Omega=(I1 * Omega1 + I2 * Omega2) / (I1 + I2), lost=reduced * (Omega1 - Omega2) ** 2 / 2,
                t=reduced * abs(Omega1 - Omega2) / tau)


def string(m, r0, u, s, t):
    r = r0 - s * t
    return dict(F=m * r0 ** 2 * u ** 2 / r ** 3, rate=r0 * u / r ** 2, phi=u * t / r,
                W=m * r0 ** 2 * u ** 2 / 2 * (1 / r ** 2 - 1 / r0 ** 2))


def percussion(l, d, m, mb, v, e):
    J = (1 + e) * v / (1 / mb + 3 * d ** 2 / (m * l ** 2))
    return dict(centre=2 * l / 3, reaction=3 * d / (2 * l) - 1, J=J, turn=3 * J * d / (m * l ** 2))


CASES = [
    ("st-coins-clockwise", coins, dict(M=0.01, R1=0.02, R2=0.012, Omega=-2.0)),
    ("st-coins-small", coins, dict(M=0.03, R1=0.5, R2=0.0007, Omega=-31.0)),
    ("st-cone-clockwise", cone_side, dict(M=2.0, h=0.3, alpha=0.4, Omega=-1.5)),
    ("st-cone-thin", cone_side, dict(M=0.4, h=0.7, alpha=0.003, Omega=-0.9)),
    ("st-cone-flat", cone_side, dict(M=0.4, h=0.02, alpha=1.56, Omega=0.3)),
    ("st-cone-raised-clockwise", cone_raised, dict(M=2.0, h=0.3, alpha=0.4, Omega=-1.5)),
    ("st-cone-raised-thin", cone_raised, dict(M=1.3, h=0.9, alpha=0.002, Omega=-2.5)),
    ("st-rod-from-the-right", rod_free, dict(M=0.8, l=1.2, v=-5.0)),
    ("st-gears-clockwise", gears, dict(I1=0.02, I2=0.005, R1=0.2, R2=0.1, Omega1=-30.0)),
    ("st-gears-unlike", gears, dict(I1=3.0, I2=0.0004, R1=0.07, R2=1.9, Omega1=-0.02)),
    ("st-discs-clockwise", discs, dict(I1=0.03, I2=0.05, Omega1=-40.0, Omega2=10.0, tau=0.5)),
    ("st-discs-overtaken", discs, dict(I1=0.03, I2=0.05, Omega1=-12.0, Omega2=-11.0, tau=0.02)),
    ("st-string-clockwise", string, dict(m=0.2, r0=0.8, u=-1.5, s=0.1, t=3.0)),
    ("st-percussion-from-behind", percussion, dict(l=0.85, d=0.7, m=1.2, mb=0.16, v=-30.0, e=0.5)),
]


def case(name, problem, inputs):
    exact = {key: mpf(value) for key, value in inputs.items()}
    fields, h = problem(**exact), mpf(10) ** -20
    sens = {field: mpf(0) for field in fields}
    for key in exact:
        moved = [problem(**{**exact, key: exact[key] * (1 + sign * h)}) for sign in (1, -1)]
        for field in fields:
            sens[field] += abs(moved[0][field] - moved[1][field]) / (2 * h)
    return dict(id=name, kind="static", problem=problem.__name__, inputs=inputs,
                expect={field: mp.nstr(value, 25) for field, value in fields.items()},
                sens={field: float(mp.nstr(value, 3)) for field, value in sens.items()})


note = "Mirrored and extreme cases; closed forms at 60 digits, by mirrored_ch15.py."
print(json.dumps(dict(schema="rigid-oracle/1", set="mirrored", note=note,
                      cases=[case(*given) for given in CASES]), indent=1))
