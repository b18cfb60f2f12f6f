#!/usr/bin/python3
"""engine_rates.py MDM: grains by steps that LIGGGHTS, LAMMPS and YADE make in a second of CPU time, and the time of whole
models beside the estimate that mdm export gives.

MDM is the program mdm. The grains of a sand start as a deposit in a box. Each engine runs its model for some steps, and for
more: the difference leaves the start of the program out. These rates are in src/cli/export_command.cpp.
"""

import os
import re
import resource
import subprocess
import sys
import tempfile

MDM = os.path.realpath(sys.argv[1])
SAND = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../examples/gradations/ottawa-f65-sand.csv")
GRAINS = 2500
ENGINES = {"liggghts": (["liggghts", "-in"], "sand.in", 4000), "lammps": (["lmp", "-in"], "sand.in", 4000),
           "yade": (["yade", "-n", "-x"], "sand.py", 1000)}


def cpu_time(engine, steps):
    """The CPU time of a run, its grains and the steps that it made."""
    command, model, _ = ENGINES[engine]
    with tempfile.TemporaryDirectory() as folder:
        log = subprocess.run([MDM, "export", SAND, "--at-least", str(GRAINS), "--to", engine, "--model", "settle", "--start",
                              "deposit", "--steps", str(steps), "--unjammed", "-o", os.path.join(folder, model)],
                             check=True, capture_output=True, text=True).stderr
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        out = subprocess.run([*command, model], cwd=folder, check=True, capture_output=True, text=True).stdout
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        return seconds, int(log.split()[0]), int(re.search(r"^RESULT after (\d+) steps", out, re.MULTILINE)[1])


for name, (_, _, few) in ENGINES.items():
    first, grains, steps = cpu_time(name, few)
    second, _, more = cpu_time(name, 4 * few)
    print(f"{name}: {grains} grains, {grains * (more - steps) / (second - first):.2g} grains by steps a second", flush=True)

GRADED = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../examples/gradations/c778-graded-sand.csv")
UNITS = {"s": 1, "minutes": 60, "hours": 3600}
for options in (["--specimen", "cylinder:5x4.5"], ["--specimen", "box:4x4x4", "--void-ratio", "0.7"],
                ["--specimen", "cylinder:5x4.5", "--void-ratio", "0.65", "--friction-while-filling", "0.2"]):
    for name, (command, model, _) in ENGINES.items():
        with tempfile.TemporaryDirectory() as folder:
            told = subprocess.run([MDM, "export", GRADED, "--to", name, "--model", "settle", "--young", "1e6", *options, "-o",
                                   os.path.join(folder, model)], check=True, capture_output=True, text=True).stderr
            number, unit = re.search(r"some (\S+) (\S+) of a core", told).groups()
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            subprocess.run([*command, model], cwd=folder, check=True, capture_output=True)
            taken = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            print(f"{name} {' '.join(options)}: {taken:.2g} s, estimated {float(number) * UNITS[unit]:.2g} s", flush=True)
