#!/usr/bin/python3
"""walls.py DUMP LOG YOUNG POISSON: holds p and q of the last row of a triaxial log against the forces on six walls.

The box of the dump is the space between the walls. A grain presses on each that is nearer than its radius, by Hertz's law; the
stress is the mean of both walls of a pair. Ends with 1 where p or q is off by more than 1 % of p.
"""

import csv
import sys

import numpy as np

dump, log, young, poisson = sys.argv[1], sys.argv[2], float(sys.argv[3]), float(sys.argv[4])
with open(dump, encoding="ascii") as file:
    text = file.read()
bounds = np.array([row.split() for row in text.partition("BOX BOUNDS")[2].splitlines()[1:4]], dtype=float)
grains = np.array([row.split()[2:6] for row in text.partition("ITEM: ATOMS")[2].splitlines()[1:]], dtype=float)
with open(log, encoding="ascii", newline="") as file:
    last = list(csv.DictReader(file))[-1]
r, box = grains[:, 3], bounds[:, 1] - bounds[:, 0]
modulus = young / (2 * (1 - poisson ** 2))


def force(distance):
    """Of the grains on a wall."""
    overlap = np.maximum(r - distance, 0)
    return (4 / 3 * modulus * np.sqrt(r) * overlap ** 1.5).sum()


sigma = [(force(grains[:, axis] - low) + force(high - grains[:, axis])) / 2 / (box.prod() / box[axis])
         for axis, (low, high) in enumerate(bounds)]
p, sigma_3 = sum(sigma) / 3, (sigma[0] + sigma[1]) / 2
worst = [f"{name}: {float(last[name])} Pa is said, {here} Pa is found"
         for name, here in (("p", p), ("q", sigma[2] - sigma_3)) if abs(float(last[name]) - here) > 0.01 * p]
print(*worst, sep="\n")
sys.exit(bool(worst))
