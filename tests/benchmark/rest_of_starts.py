#!/usr/bin/python3
"""rest_of_starts.py MDM: steps after which LIGGGHTS and LAMMPS have brought sands to rest, from layers, from random places and from
a deposit.

MDM is the program mdm. Each sand settles on the same ground, with the same stiffness and so the same time step, until it is
at rest as its model says: by kinetic energy and unbalanced force.
"""

import os
import re
import subprocess
import sys
import tempfile

MDM = os.path.realpath(sys.argv[1])
SANDS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../examples/gradations")
ENGINES = {"liggghts": "liggghts", "lammps": "lmp"}
CASES = [("hostun-rf-sand", ["--at-least", "400"], "1.8x1.8"), ("c778-graded-sand", ["--at-least", "400"], "2x2"),
         ("ottawa-f65-sand", ["--cut-below", "0.1416"], "2x2")]


def settled(engine, name, question, box, start):
    """Number of grains and the step from which on they are at rest."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([MDM, "export", f"{SANDS}/{name}.csv", *question, "--to", engine, "--model", "settle", "--young", "5e6",
                        "--box", box, "--start", start, "--quiet", "-o", os.path.join(folder, "sand.in")], check=True)
        log = subprocess.run([ENGINES[engine], "-in", "sand.in", "-var", "steps", "2000000", "-var", "unjammed", "1"],
                             cwd=folder, check=True, capture_output=True, text=True).stdout
        with open(os.path.join(folder, "sand-settled.dump"), encoding="ascii") as file:
            grains = len(file.read().partition("ITEM: ATOMS")[2].splitlines()) - 1
    return grains, int(re.search(r"^SETTLED after (\d+) steps", log, re.MULTILINE)[1])


for name, question, box in CASES:
    for engine in ENGINES:
        found = {start: settled(engine, name, question, box, start) for start in ("layers", "mixed", "deposit")}
        print(f"{name}, {found['layers'][0]} grains, {engine}: " +
              ", ".join(f"{start} {steps} steps" for start, (_, steps) in found.items()), flush=True)
