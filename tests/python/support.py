"""The command line beside the module, and gradations to ask about."""

import json
import os
import subprocess
from pathlib import Path

import exactmdm

# The sanitizers' library is for Python, which was not linked with them, and not for programs that were.
PRELOADED = os.environ.pop("LD_PRELOAD", None)

SOURCE = Path(__file__).resolve().parents[2]
SANDS = sorted((SOURCE / "examples/gradations").glob("*-sand.csv"))
SAND = SOURCE / "examples/gradations/athabasca-sand.csv"
SUITE = SOURCE / "examples/reference/average/suite-2750.jsonl"


def mdm(*arguments, stdin=None):
    """Exit code, standard output and standard error of the program, whose messages name options as keywords."""
    done = subprocess.run([exactmdm.program.program(), *map(str, arguments)], input=stdin, capture_output=True, text=True,
                          encoding="utf-8", env={**os.environ, "MDM_OPTION_SPELLING": "keyword"})
    return done.returncode, done.stdout, done.stderr


def python_environment():
    """The environment of another Python."""
    return os.environ if PRELOADED is None else {**os.environ, "LD_PRELOAD": PRELOADED}


def sand():
    """A gradation with a match of 6 particles."""
    return exactmdm.Gradation(["0.1", "0.2", "0.4", "0.8"], [20, 30, 50, 0], id="sand")


def endless():
    """A gradation whose smallest match takes 10^11 steps: its sieves are as narrow."""
    return exactmdm.Gradation(["1", "1.00000000001", "1.00000000002", "1.00000000003"], ["1", "1.3", "1.7", 0])


def suite(lines):
    """Some gradations of the suite."""
    with open(SUITE, encoding="utf-8") as file:
        return [json.loads(line) for line, _ in zip(file, range(lines))]
