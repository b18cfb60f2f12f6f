#!/usr/bin/python3
"""discs.py DUMP LOG ISOSTATIC [--stress PA]: holds the RESULT line of a model of discs against the discs that it left.

All is found anew from places and radii, in the plane, by numpy: contacts are overlaps, of discs or with the two walls and the
floor; Hertz's law of spheres has their normal forces; the discs are two thirds of the smallest diameter long. Ends with 1
where the line says something else, a disc has left the plane, or the discs that carry have fewer contacts than ISOSTATIC.
With --stress the pressure is that of the discs that touch the lid, where the void ratio says that it is, within 3 %.
"""

import sys

import numpy as np

sys.dont_write_bytecode = True
from contacts import contacts, modulus_of, number_in, result_line

dump, log, isostatic = sys.argv[1], sys.argv[2], float(sys.argv[3])
stress = float(sys.argv[sys.argv.index("--stress") + 1]) if "--stress" in sys.argv else None
line = result_line(log)
print(line)


def number(pattern):
    return number_in(line, pattern)


with open(dump, encoding="ascii") as file:
    text = file.read()
if text.startswith("#"):  # YADE: the plane is x z
    width = float(text.splitlines()[0].rpartition("box ")[2].split()[0])
    grains = np.loadtxt(dump)
    at, off = grains[:, [0, 2]], grains[:, 1] - grains[0, 1]
else:  # LAMMPS: x y
    width = float(text.partition("BOX BOUNDS")[2].splitlines()[1].split()[1])
    grains = np.array([row.split()[2:6] for row in text.partition("ITEM: ATOMS")[2].splitlines()[1:]], dtype=float)
    at, off = grains[:, :2], grains[:, 2]
r = grains[:, 3]
n, length = len(r), 4 / 3 * r.min()

YOUNG, POISSON, DENSITY = 1e7, 0.25, 2650
modulus = modulus_of(YOUNG, POISSON)
fl, z = contacts(at, r, modulus)

solids = length * np.pi * (r ** 2).sum()
several = z > 1
found = {"Z": (z.mean(), number(r" Z ([^,]+),"), 0.03),
         "Z without rattlers": (z[several].mean(), number(r"without rattlers ([^,]+),"), 0.05),
         "rattlers": (1 - several.mean(), number(r"rattlers ([^ ]+) of the grains"), 0.03)}
said = number(r"pressure ([^ ]+) Pa")
if stress is None:
    volume = width * length * (at[:, 1] + r).max()
    found["void ratio"] = (volume / solids - 1, number(r"void ratio ([^,]+),"), 1e-3)
    here = (fl + DENSITY * 9.81 * solids * r.min()) / 2 / volume
    found["pressure"] = (here / said, 1, 0.03)
else:
    lid = (1 + number(r"void ratio ([^,]+),")) * solids / (width * length)
    under = at[:, 1] + r > lid
    # A wall of YADE counts as a sphere of the radius of the one that touches; a plane of LAMMPS was found by 1 + nu stiffer
    # than a wall of the grains' material (version of January 2022).
    root = np.sqrt(r[under] / 2) if text.startswith("#") else (1 + POISSON) * np.sqrt(r[under])
    push = (4 / 3 * modulus * root * (at[under, 1] + r[under] - lid) ** 1.5).sum() / (width * length)
    found["pressure"] = (said / stress, 1, 0.011)
    found["push on the lid"] = (push / stress, 1, 0.03)
worst = [f"{name}: {said:.6g} is said, {here:.6g} is found" for name, (here, said, within) in found.items()
         if abs(here - said) > within]
if np.abs(off).max() > 0:
    worst.append("a disc is out of the plane")
# Of walls each contact counts twice: two discs share the others.
at_walls = (at[:, 1] < r).astype(int) + (at[:, 0] < r) + (at[:, 0] > width - r)
held = z + at_walls > (1 if isostatic == 3 else 2)
carrying = (z + 2 * at_walls)[held].mean()
if carrying < isostatic - 0.05:
    worst.append(f"{carrying:.4g} contacts of a disc that is carried")
print(*worst, sep="\n")
sys.exit(bool(worst))
