#!/usr/bin/python3
"""read_by_python.py [--unit UNIT] FILE...: what exactmdm.read makes of each file, as a line of JSON like those of mdm batch."""

import json
import sys

import exactmdm


def answer(name, unit):
    try:
        gradation = exactmdm.read(name, unit=unit)
    except exactmdm.InputError as error:
        return {"status": "error", "error": str(error)}
    sizes, masses = map(str, gradation.sizes), map(str, gradation.masses)
    rows = list(zip(sizes, masses))
    classes = [{"lower": lower, "upper": upper, "mass": mass} for (lower, mass), (upper, _) in zip(rows, rows[1:])]
    return {"status": "read", "unit": gradation.unit, "classes": classes, "notes": gradation.notes}


names = sys.argv[1:]
asked = None
if names[:1] == ["--unit"]:
    asked, names = names[1], names[2:]
for one in names:
    print(json.dumps(answer(one, asked)))
