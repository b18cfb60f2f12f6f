#!/usr/bin/python3
"""rows.py LOG CONSTANT PRESSURE: holds the rows of a triaxial model's log against the stress that was to be constant.

CONSTANT is sigma_3 or p. Ends with 1 where more than a twentieth of the rows, or the last, is off by more than 2 %, the mean of
all by more than 0.5 %, where the other stress is constant, too, or where a row names another one.
"""

import csv
import sys

log, constant, pressure = sys.argv[1], sys.argv[2], float(sys.argv[3])
with open(log, encoding="ascii", newline="") as file:
    rows = list(csv.DictReader(file))
p = [float(row["p"]) for row in rows]
sigma_3 = [float(row["p"]) - float(row["q"]) / 3 for row in rows]
kept, other = (p, sigma_3) if constant == "p" else (sigma_3, p)
off = [abs(value / pressure - 1) for value in kept]
worst = []
if sum(value > 0.02 for value in off) > 0.05 * len(rows):
    worst.append(f"{sum(value > 0.02 for value in off)} of {len(rows)} rows are off, by {max(off)} at most")
if off[-1] > 0.02:
    worst.append(f"the last row is off by {off[-1]}")
if abs(sum(kept) / len(rows) / pressure - 1) > 0.005:
    worst.append(f"the mean is {sum(kept) / len(rows)} Pa")
if abs(other[-1] / pressure - 1) < 0.05:
    worst.append(f"the other stress is {other[-1]} Pa at the end")
if {row["constant"] for row in rows} != {constant}:
    worst.append("a row has another constant stress")
print(*worst, sep="\n")
sys.exit(bool(worst))
