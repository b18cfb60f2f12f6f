#!/usr/bin/python3
"""rest_of_starts.py MDM: steps after which LIGGGHTS has brought sands to rest, from the start of its model and from a deposit.

MDM is the program mdm. Each sand settles twice on the same ground, with the same stiffness and so the same time step. It is
at rest from the step on after which its kinetic energy stays below 10^-4 M g d: M is its mass, d its smallest diameter. That
is a speed of 0.014 sqrt(g d), less than 1 mm/s for sand.
"""

import math
import os
import re
import subprocess
import sys
import tempfile

MDM = os.path.realpath(sys.argv[1])
SANDS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../examples/gradations")
EVERY = 100  # steps between two looks at the energy
CASES = [("hostun-rf-sand", ["--at-least", "1000"]), ("c778-graded-sand", ["--at-least", "1000"]),
         ("ottawa-f65-sand", ["--cut-below", "0.1416"])]


def run_length(model):
    return int(re.search(r"variable steps index (\d+)", model).group(1))


def settled(name, question, start):
    """Number of grains, and the first step at rest."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sand.in")
        subprocess.run([MDM, "export", f"{SANDS}/{name}.csv", *question, "--to", "liggghts", "--model", "settle",
                        "--young", "5e6", "--quiet", "-o", path, *start], check=True)
        with open(path, encoding="utf-8") as file:
            model = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(re.sub(r"\nfix gravity", f"\nthermo {EVERY}\nreset_timestep 0\nfix gravity", model))
        log = subprocess.run(["liggghts", "-in", "sand.in"], cwd=folder, check=True, capture_output=True, text=True).stdout
        with open(os.path.join(folder, "sand-settled.dump"), encoding="ascii") as file:
            radii = [float(line.split()[5]) for line in file if len(line.split()) == 6 and line[0].isdigit()]
    mass = sum(4 / 3 * math.pi * 2650 * r ** 3 for r in radii)
    rest = 1e-4 * mass * 9.81 * 2 * min(radii)
    energies = [(int(step), float(energy)) for step, energy in
                re.findall(rf"^ *(\d+) +{len(radii)} +(\S+) *$", log[log.rindex("Setting up run"):], re.MULTILINE)]
    moving = [step for step, energy in energies if energy > rest]
    return len(radii), None if moving and moving[-1] == run_length(model) else (moving[-1] + EVERY if moving else 0), run_length(model)


for name, question in CASES:
    n, inserted, steps = settled(name, question, [])
    _, deposited, _ = settled(name, question, ["--start", "deposit", "--steps", str(steps)])
    print(name, n, f"steps to rest: {inserted} inserted, {deposited} deposited, of {steps}", flush=True)
