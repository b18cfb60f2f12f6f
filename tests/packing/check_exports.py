#!/usr/bin/python3
"""check_exports.py PACKING FACTOR LMGC90 VTK CSV: three exports of a packing hold its discs, with no code of the project.

Numbers are read as fractions: each is that of the packing times FACTOR, exactly. The first file is read as numpy.loadtxt
does for LMGC90, the second as a reader of legacy VTK. Says what is wrong first, or `ok`.
"""

import sys
from fractions import Fraction


def packing(path, factor):
    head, _, rows = open(path, encoding="ascii").read().partition("x y r left right\n")
    unit = Fraction(factor) / 10 ** int(dict(line.split(" ") for line in head.splitlines())["places"])
    return [(tuple(int(n) * unit for n in row.split()[:3]), row.split()[3:]) for row in rows.splitlines()]


def lmgc90(path):
    """`radius x y` a line; what follows a # is left out, and so are empty lines."""
    rows = [line.partition("#")[0].split() for line in open(path, encoding="ascii")]
    return [(Fraction(x), Fraction(y), Fraction(r)) for r, x, y in filter(None, rows)]


def vtk(path):
    lines = open(path, encoding="ascii").read().splitlines()
    assert lines[0] == "# vtk DataFile Version 3.0" and len(lines[1]) < 256 and lines[2:4] == ["ASCII", "DATASET POLYDATA"]
    words = " ".join(lines[4:]).split()

    def take(*expected):
        """The next words are these; what stands for None is handed on."""
        found, words[:len(expected)] = words[:len(expected)], []
        assert all(e in (None, f) for e, f in zip(expected, found)), (expected, found)
        return [f for e, f in zip(expected, found) if e is None]

    n = int(take("POINTS", None, "double")[0])
    points = [list(map(Fraction, take(None, None, None))) for _ in range(n)]
    take("VERTICES", str(n), str(2 * n))
    for i in range(n):
        take("1", str(i))
    take("POINT_DATA", str(n), "SCALARS", "radius", "double", "1", "LOOKUP_TABLE", "default")
    radii = [Fraction(take(None)[0]) for _ in range(n)]
    assert not words and all(z == 0 for _, _, z in points)
    return [(x, y, r) for (x, y, _), r in zip(points, radii)]


def csv(path):
    rows = [line.split(",") for line in open(path, encoding="ascii").read().splitlines()]
    assert [name.partition("_")[0] for name in rows[0]] == ["x", "y", "radius", "left", "right"]
    return [(tuple(map(Fraction, row[:3])), row[3:]) for row in rows[1:]]


written = packing(sys.argv[1], sys.argv[2])
discs = [disc for disc, _ in written]
assert discs and lmgc90(sys.argv[3]) == discs, "LMGC90"
assert vtk(sys.argv[4]) == discs, "VTK"
assert csv(sys.argv[5]) == written, "CSV"
print("ok")
