#!/usr/bin/python3
"""rest_of_starts.py MDM: steps after which LIGGGHTS has brought sands to rest, from the start of its model and from a deposit.

MDM is the program mdm. Each sand settles twice on the same ground, with the same stiffness and so the same time step. It is
at rest from the step on after which its kinetic energy stays below a part of M g d: M is its mass, d its smallest diameter.
At one of a thousand, of 1,000 grains one may fall by d still.
"""

import math
import os
import re
import subprocess
import sys
import tempfile

MDM = os.path.realpath(sys.argv[1])
SANDS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../examples/gradations")
PARTS = [1e-2, 1e-3, 1e-4]
EVERY = 100  # steps between two looks at the energy
CASES = [("hostun-rf-sand", ["--at-least", "1000"]), ("c778-graded-sand", ["--at-least", "1000"]),
         ("ottawa-f65-sand", ["--cut-below", "0.1416"])]


def settled(name, question, start):
    """Number of grains, steps that were made, and for each part the first step at rest, or nothing."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sand.in")
        subprocess.run([MDM, "export", f"{SANDS}/{name}.csv", *question, "--to", "liggghts", "--model", "settle",
                        "--young", "5e6", "--quiet", "-o", path, *start], check=True)
        with open(path, encoding="utf-8") as file:
            model = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(model.replace("\nthermo 0\n", f"\nthermo {EVERY}\n"))
        # At no time at rest.
        log = subprocess.run(["liggghts", "-in", "sand.in", "-var", "at_rest", "1e-300"], cwd=folder, check=True,
                             capture_output=True, text=True).stdout
        with open(os.path.join(folder, "sand-settled.dump"), encoding="ascii") as file:
            rows = file.read().partition("ITEM: ATOMS")[2].splitlines()[1:]
    radii = [float(row.split()[5]) for row in rows]
    weight = sum(4 / 3 * math.pi * 2650 * r ** 3 for r in radii) * 9.81
    energies = [(int(step), float(energy)) for step, energy in
                re.findall(rf"^ *(\d+) +{len(radii)} +(\S+) ", log, re.MULTILINE)]
    steps = energies[-1][0]
    rests = []
    for part in PARTS:
        last = max((step for step, energy in energies if energy > part * weight * 2 * min(radii)), default=-EVERY)
        rests.append(None if last == steps else last + EVERY)
    return len(radii), steps, rests


for name, question in CASES:
    n, steps, inserted = settled(name, question, [])
    _, _, deposited = settled(name, question, ["--start", "deposit", "--steps", str(steps)])
    for part, *pair in zip(PARTS, inserted, deposited):
        print(f"{name}, {n} grains, below {part:g} M g d: {pair[0]} steps inserted, {pair[1]} from a deposit", flush=True)
