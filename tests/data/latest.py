#!/usr/bin/env python3
"""Writes the references near the latest times at which phases are known: `latest.py latest.txt`.

The motions, the digits and the lines are those of late.py. The times are 2^46 turns of the fastest
rate at the start, or of the fastest swing of a pendulum: a quarter of what is known.
"""

import sys
from mpmath import mpf, nstr, pi, sqrt
from late import KINDS, cases

if __name__ == "__main__":
    with open(sys.argv[1], "w") as file:
        for kind, name, inputs in cases():
            motion = KINDS[kind](inputs)
            if kind == "pendulum":
                rate = motion.W * max(motion.k, 1)
            else:
                rates = inputs[3:6] if kind == "free" else inputs[6:]
                rate = sqrt(sum(mpf(x) ** 2 for x in rates))
            t = float(2**46 * 2 * pi / rate)
            place, rates = motion.at(mpf(t))
            values = [nstr(x, 25, min_fixed=0, max_fixed=0) for x in place + rates]
            numbers = [repr(float(x)) for x in inputs] + ["last", repr(t)]
            file.write(" ".join([kind, name] + numbers + values) + "\n")
