#!/usr/bin/python3
"""state.py DUMP LOG YOUNG POISSON [--wall box|six] [--law sjkr|jkr COHESION] [--unjammed]: holds the RESULT line of a model's log
against the grains that it left.

Contacts, void ratio and pressure are found anew from places and radii, by numpy: contacts are overlaps, periodic ones too,
and Hertz's law has their normal forces, or a law with cohesion. A box has a floor, four sides and weight; six walls have no friction and enclose grains without
weight; without walls the box is repeated on all sides. Ends with 1 where the line says something else, or says that grains carry
each other that do not.
"""

import sys

import numpy as np

sys.dont_write_bytecode = True
from contacts import contacts, modulus_of, number_in, result_line

dump, log, young, poisson = sys.argv[1], sys.argv[2], float(sys.argv[3]), float(sys.argv[4])
walls = sys.argv[sys.argv.index("--wall") + 1] if "--wall" in sys.argv else ""
law, cohesion = sys.argv[sys.argv.index("--law") + 1:][:2] if "--law" in sys.argv else ("hertz", 0)
line = result_line(log)
print(line)


def number(pattern):
    return number_in(line, pattern)


with open(dump, encoding="ascii") as file:
    text = file.read()
if text.startswith("#"):  # YADE
    box = np.array([float(word) for word in text.splitlines()[0].rpartition("box ")[2].partition(",")[0].split()])
    low = np.zeros(3)
    grains = np.loadtxt(dump)
else:
    bounds = np.array([row.split() for row in text.partition("BOX BOUNDS")[2].splitlines()[1:4]], dtype=float)
    low, box = bounds[:, 0], bounds[:, 1] - bounds[:, 0]
    grains = np.array([row.split()[2:6] for row in text.partition("ITEM: ATOMS")[2].splitlines()[1:]], dtype=float)
at, r = grains[:, :3] - low, grains[:, 3]

modulus = modulus_of(young, poisson)
fl, z = contacts(at, r, modulus, None if walls else box, law, float(cohesion))

# Of the centres from each wall; the last is the top.
distances = np.hstack((at, box - at)).T[:{"": 0, "box": 5, "six": 6}[walls]]
at_walls = (distances < r).sum(axis=0)
if walls == "six":
    for distance in distances:
        touching = distance < r
        force = 4 / 3 * modulus * np.sqrt(r[touching]) * (r - distance)[touching] ** 1.5
        fl += (force * distance[touching]).sum()

solids = 4 / 3 * np.pi * (r ** 3).sum()
volume = box[0] * box[1] * ((at[:, 2] + r).max() if walls == "box" else box[2])
floor = 2650 * 9.81 * solids * r.min() if walls == "box" else 0
several = z > 1
found = {"void ratio": (volume / solids - 1, number(r"void ratio ([^,]+),"), 1e-3),
         "Z": (z.mean(), number(r" Z ([^,]+),"), 0.03),
         "Z without rattlers": (z[several].mean() if several.any() else 0, number(r"without rattlers ([^,]+),"), 0.05),
         "rattlers": (1 - several.mean(), number(r"rattlers ([^ ]+) of the grains"), 0.03)}
pressure = (fl + floor) / 3 / volume
said = number(r"pressure ([^ ]+) Pa")
# The damping of contacts adds to what the engine says of grains that move: it is most of it in a gas.
if "--unjammed" not in sys.argv:
    found["pressure"] = (pressure / max(pressure, said), said / max(pressure, said), 0.03)
worst = [f"{name}: {said:.6g} is said, {here:.6g} is found" for name, (here, said, within) in found.items()
         if abs(here - said) > within]
# Two grains share a contact, and with a wall none does: of one with friction it counts twice. One without has a single force, where
# the contact of two grains has three.
carried = z + at_walls > 1
carrying = (z + (2 / 3 if walls == "six" else 2) * at_walls)[carried].mean() if carried.any() else 0
if carrying < 3.95 and "--unjammed" not in sys.argv:
    worst.append(f"{carrying:.4g} contacts of a grain that is carried")
print(*worst, sep="\n")
sys.exit(bool(worst))
