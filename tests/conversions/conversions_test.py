#!/usr/bin/python3
"""conversions_test.py MDM: files of particles with places, from each format that is read to each that is written.

This file draws grains in four classes, some of which overlap, and writes them itself as engines, VTK and ParaView do. mdm
export reads each, and gzipped too, and writes each format; what it writes is read here by a few lines of Python, must have
the same grains at the same places in the same classes, and goes through mdm export once more. mdm verify counts them.
"""

import gzip
import json
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile

MDM = str(pathlib.Path(sys.argv[1]).resolve())
SIDE = "0.02"
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def drawn_grains():
    """x, y, z, radius in m, as decimals, and the class; classes 2, 3, 5 and 7 have sizes within a factor of 1.2."""
    draw = random.Random(34)
    grains = []
    for number, radius in ((2, 300), (3, 420), (5, 700), (7, 990)):
        for _ in range(40 // number):
            r = draw.randint(radius, radius * 12 // 10) * 1e-6
            grains.append((*(draw.uniform(r, float(SIDE) - r) for _ in range(3)), r, number))
    draw.shuffle(grains)
    return [tuple(f"{value:.9g}" for value in grain[:4]) + (grain[4],) for grain in grains]


GRAINS = drawn_grains()
N = len(GRAINS)
NUMBERS = {number: number for number in (2, 3, 5, 7)}
RANKS = {number: rank for rank, number in enumerate(NUMBERS, 1)}


def rows(template, grains=None):
    """A line a grain; i counts from 1."""
    return "".join(template.format(x=x, y=y, z=z, r=r, d=f"{2 * float(r):.9g}", c=c, i=i) + "\n"
                   for i, (x, y, z, r, c) in enumerate(grains or GRAINS, 1))


def vtp():
    def array(name, values, more=""):
        return f'<DataArray type="Float64" Name="{name}" format="ascii"{more}>\n{values}</DataArray>\n'
    return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">\n<PolyData>\n'
            f'<Piece NumberOfPoints="{N}" NumberOfVerts="0">\n<PointData>\n'
            + array("id", rows("{i}")) + array("type", rows("{c}")) + array("radius", rows("{r}"))
            + "</PointData>\n<CellData/>\n<Points>\n" + array("Points", rows("{x} {y} {z}"), ' NumberOfComponents="3"')
            + "</Points>\n</Piece>\n</PolyData>\n</VTKFile>\n")


BOX = f"0 {SIDE}\n" * 3
DUMP = f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{N}\nITEM: BOX BOUNDS ff ff ff\n{BOX}ITEM: ATOMS "
# Name: content, whether it has classes, and the options with which mdm reads it.
WRITTEN_HERE = {
    "lammps.dump": (DUMP + "id type x y z radius\n" + rows("{i} {c} {x} {y} {z} {r}"), True, []),
    "unwrapped.dump": (DUMP + "diameter zu yu xu id\n" + rows("{d} {z} {y} {x} {i}"), False, []),
    "named.dump": (DUMP + "id type c_r x y z\n" + rows("{i} {c} {r} {x} {y} {z}"), True,
                   ["--size-column", "c_r", "--radius"]),
    "liggghts.data": (f"LIGGGHTS data file\n\n{N} atoms\n7 atom types\n\n" + "".join(
        f"0 {SIDE} {axis}lo {axis}hi\n" for axis in "xyz") + "\nAtoms\n\n" + rows("{i} {c} {d} 2650 {x} {y} {z}"),
        True, []),
    "spheres.vtk": (f"# vtk DataFile Version 3.0\nspheres\nASCII\nDATASET POLYDATA\nPOINTS {N} double\n"
                    + rows("{x} {y} {z}") + f"POINT_DATA {N}\nSCALARS radius double 1\nLOOKUP_TABLE default\n" + rows("{r}")
                    + "SCALARS class int 1\nLOOKUP_TABLE default\n" + rows("{c}"), True, []),
    "settled.vtp": (vtp(), True, []),
    "named.vtp": (vtp().replace('Name="radius"', 'Name="c_r"'), True, ["--size-column", "c_r", "--radius"]),
    "paraview.csv": ('"Point ID","id","type","v:0","radius","Points:0","Points:1","Points:2"\n'
                     + rows("{i},{i},{c},0.5,{r},{x},{y},{z}"), True, ["--size-unit", "m"]),
    "own.csv": ("id,type,x_m,y_m,z_m,radius_m\n" + rows("{i},{c},{x},{y},{z},{r}"), True, []),
    "named.csv": ("who;x;y;z;c_d;weight\n" + rows("{i};{x};{y};{z};{d};7"), False,
                  ["--size-column", "c_d", "--diameter", "--size-unit", "m"]),
    "grains.xyzr": ("# x y z r\n" + rows("{x} {y} {z} {r}"), False, ["--size-unit", "m"]),
    "grains.extxyz": (f'{N}\nLattice="{SIDE} 0 0 0 {SIDE} 0 0 0 {SIDE}" pbc="F F F" unit=m '
                      "Properties=species:S:1:pos:R:3:radius:R:1:type:I:1\n" + rows("X {x} {y} {z} {r} {c}"), True, []),
    "snapshot_1.txt": (f"{N}\n" + rows("{x} {y} {z} {r} {i} {c} 1 0 0 0"), True, []),
}


def table(text, columns, separator=None):
    """Columns x, y, z, r, class of lines, as numbers; a class of None is none."""
    found = []
    for line in text.splitlines():
        words = [word.strip() for word in line.split(separator)]
        found.append(tuple(None if column is None else float(column(words) if callable(column) else words[column])
                           for column in columns))
    return found


def block(text, begin, end=None):
    """What stands behind one line and before another."""
    text = text[text.index(begin) + len(begin):]
    return text[:text.index(end)] if end else text


def read_lammps(path):
    text = path.read_text()
    return table(block(text, "Atoms # sphere\n\n"), (4, 5, 6, lambda w: float(w[2]) / 2, 1))


def read_yade(path):
    return table("".join(line for line in path.open() if not line.startswith("#")), (0, 1, 2, 3, None))


def read_vtk(path):
    text = path.read_text()
    places = block(text, f"POINTS {N} double\n", "VERTICES").splitlines()
    radii = block(text, "SCALARS radius double 1\nLOOKUP_TABLE default\n", "SCALARS").splitlines()
    classes = block(text, "SCALARS class int 1\nLOOKUP_TABLE default\n").splitlines()
    return [(*map(float, p.split()), float(r), float(c)) for p, r, c in zip(places, radii, classes)]


def read_esys(path):
    return table(block(path.read_text(), f"Simple\n{N}\n", "EndParticles"), (0, 1, 2, 3, 5))


def read_lethe(path):
    return table("".join(path.open().readlines()[1:]), (0, 1, 2, lambda w: float(w[9]) / 2, None), ";")


def read_kratos(path):
    text = path.read_text()
    radii = dict(line.split()[::2] for line in block(text, "NodalData RADIUS\n", "End NodalData").splitlines())
    return [(*map(float, words[1:]), float(radii[words[0]]), None)
            for words in map(str.split, block(text, "Begin Nodes\n", "End Nodes").splitlines())]


def read_dem_engine(path):
    return table("".join(path.open().readlines()[1:]), (0, 1, 2, lambda w: w[7][1:], None), ",")


def read_musen(path):
    lines = [line for line in path.open() if line.startswith("0 ")]
    return table("".join(lines), (15, 16, 17, 5, lambda w: w[8].partition("_")[2]))


def read_phasicflow(path):
    sizes = [None] * N
    for d, begin, end in re.findall(r"([\d.e+-]+)\s+selector\d+\s*{[^{]*{ begin (\d+); end (\d+);", path.read_text()):
        sizes[int(begin):int(end) + 1] = [float(d) / 2] * (int(end) + 1 - int(begin))
    places = path.with_name(path.name + "-positions").read_text().splitlines()
    return [(*map(float, place.split()), r, None) for place, r in zip(places, sizes)]


def read_gsd(path):
    data = path.read_bytes()
    _, index, entries, names_at, names_n = struct.unpack_from("<5Q", data)
    names = data[names_at:names_at + 64 * names_n].split(b"\0")
    chunks = {}
    for k in range(entries):
        _, count, at, width, name, kind, _ = struct.unpack_from("<QQqIHBB", data, index + 32 * k)
        if at:
            letter = {1: "B", 3: "I", 4: "Q", 9: "f"}[kind]
            values = struct.unpack_from(f"<{count * width}{letter}", data, at)
            chunks[names[name].decode()] = [values[i:i + width] for i in range(0, len(values), width)]
    box = [side for side, in chunks["configuration/box"]]
    types = [bytes(name).rstrip(b"\0").decode() for name in chunks["particles/types"]]
    return [(*(p + side / 2 for p, side in zip(place, box)), d / 2, float(types[kind]))
            for place, (d,), (kind,) in zip(chunks["particles/position"], chunks["particles/diameter"],
                                            chunks["particles/typeid"])]


def read_extxyz(path):
    return table("".join(path.open().readlines()[2:]), (2, 3, 4, 5, 1))


def read_pfc(path):
    return table("".join(path.open().readlines()[1:]), (1, 2, 3, 4, 5), ",")


# Format: its reader here, and whether mdm reads its places, or classes, back.
FORMATS = {"lammps": (read_lammps, True, True), "yade": (read_yade, True, False), "vtk": (read_vtk, True, True),
           "esys": (read_esys, True, True), "lethe": (read_lethe, True, False), "kratos": (read_kratos, True, False),
           "dem-engine": (read_dem_engine, True, False), "musen": (read_musen, True, True),
           "phasicflow": (read_phasicflow, False, False), "gsd": (read_gsd, True, True),
           "extxyz": (read_extxyz, True, True), "pfc": (read_pfc, True, True)}


def aligned(grains):
    """Radius, place from the lower corner of the smallest box around all on, class: ascending."""
    low = [min(g[axis] - g[3] for g in grains) for axis in range(3)]
    return sorted((g[3], *(g[axis] - low[axis] for axis in range(3)), g[4] or 0) for g in grains)


def compare(what, found, labels, within):
    """labels: what each class is called; None where the format has none, or they are others."""
    if len(found) != N:
        return check(False, f"{what}: {len(found)} grains, not {N}")
    expected = aligned([(*map(float, g[:4]), labels[g[4]] if labels else 0) for g in GRAINS])
    for have, want in zip(aligned(found), expected):
        same_class = not labels or found[0][4] is None or have[4] == want[4]
        if not same_class or any(abs(a - b) > within for a, b in zip(have[:4], want)):
            return check(False, f"{what}: {have} is not {want}")


def run(*arguments):
    return subprocess.run([MDM, *map(str, arguments)], capture_output=True, text=True, check=False)


def convert(folder, path, options, labels, within):
    """Writes each format from the file at `path`, whose classes are called so; the formats, and what is written."""
    for to, (read, _, _) in FORMATS.items():
        out = folder / f"{path.name}-{to}" / "out"
        out.parent.mkdir()
        types = ["--types", "class"] if to == "lammps" else []  # which are in a row
        outcome = run("export", path, *options, "--to", to, *types, "--quiet", "-o", out)
        what = f"{path.name} to {to}"
        check(outcome.returncode == 0, f"{what}: {outcome.stderr}")
        if outcome.returncode == 0:
            compare(what, read(out), labels and (RANKS if to == "lammps" else labels),
                    1e-9 if to in ("gsd", "dem-engine") else within)
            yield to, out


def count(path, options, gradation):
    """mdm verify finds all grains."""
    verdict = run("verify", gradation, path, *options, "--tolerance", "100", "--format", "json")
    check(verdict.returncode == 0 and json.loads(verdict.stdout)["particles"] == str(N),
          f"verify {path.name}: {verdict.stdout[:200]} {verdict.stderr}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        gradation = folder / "wide.csv"
        gradation.write_text("size_mm,mass\n0.01,1\n1,1\n10,0\n")
        written = []
        for file, (content, has_classes, options) in WRITTEN_HERE.items():
            plain, packed = folder / file, folder / f"{file}.gz"
            plain.write_text(content)
            packed.write_bytes(gzip.compress(content.encode()))
            for path in (plain, packed):
                count(path, options, gradation)
                for to, out in convert(folder, path, options, NUMBERS if has_classes else None, 1e-10):
                    if file == "lammps.dump" and path == plain:
                        written.append((to, out))
        for to, out in written:
            _, has_places, keeps_classes = FORMATS[to]
            options = [] if to in ("gsd", "lammps", "vtk", "esys", "lethe", "kratos", "musen", "dem-engine",
                                   "extxyz") else ["--size-unit", "m"]
            count(out, options, gradation)
            if has_places:
                second = folder / f"second-{to}"
                out.rename(second)
                labels = keeps_classes and (RANKS if to == "lammps" else NUMBERS)
                for _ in convert(folder, second, options, labels, 1e-9):
                    pass
    print(f"{len(failures)} failures")
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
