#!/usr/bin/python3
"""check_sample.py MDM: the numbers of mdm verify --packing against numpy and scipy.spatial, and what it refuses.

Spheres at random places, overlapping, some alone, in a box with walls, in a periodic one, and in a cylinder. Pairs come
from a KD tree, the volume inside the inner part from slices of all spheres. Exits with 77 where scipy is missing, unless
MDM_REQUIRE_TOOLS is set in the environment.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from scipy.spatial import cKDTree
except ImportError:
    print("python3-scipy is not installed")
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)

MDM = sys.argv[1]
GRADATION = "size_mm,mass\n1,2\n2,2\n3,1\n4,0\n"
OPENINGS = [1, 2, 3, 4]


def verify(folder, name, text, *options):
    path = pathlib.Path(folder) / name
    path.write_text(text)
    done = subprocess.run([MDM, "verify", pathlib.Path(folder) / "g.csv", path, "--packing", "--format", "json",
                           "--tolerance", "100%", *options], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)["packing"]


def number(value):
    """A fraction's double; of an enclosure both ends."""
    if isinstance(value, list):
        return tuple(float(v) for v in value)
    n, _, d = value.partition("/")
    return (int(n) / int(d or 1),) * 2


def check(what, value, expected, error):
    low, high = number(value)
    assert high - low <= 1e-9 * max(1, abs(high)), (what, "is not known well", low, high)
    assert low - error <= expected <= high + error, (what, low, high, expected)


def spheres(seed, n, sides, cylinder=False):
    """Rounded decimals, so that the file has the same doubles."""
    rng = np.random.default_rng(seed)
    diameter = np.round(np.concatenate([rng.uniform(1.01, 2, n), rng.uniform(2.01, 3, n // 2),
                                        rng.uniform(3.01, 4, n // 8)]), 6)
    rng.shuffle(diameter)
    place = rng.uniform(0, 1, (len(diameter), 3)) * sides
    if cylinder:
        r, angle = sides[0] / 2 * np.sqrt(rng.uniform(0, 1, len(place))), rng.uniform(0, 2 * math.pi, len(place))
        place[:, 0], place[:, 1] = sides[0] / 2 + r * np.cos(angle), sides[0] / 2 + r * np.sin(angle)
    return np.round(place, 6), diameter


def pairs_of(place, diameter, periods, gap):
    """Sorted pairs within reach and the depth of each, with the periods of the axes (0: none)."""
    big = np.where(periods > 0, periods, 1e6)
    tree = cKDTree(np.where(periods > 0, place % big, place + 1e5), boxsize=big)
    i, j = tree.query_pairs(diameter.max() + gap, output_type="ndarray").T
    by = place[i] - place[j]
    by -= np.where(periods > 0, np.round(by / big) * big, 0)
    depth = (diameter[i] + diameter[j]) / 2 - np.sqrt((by ** 2).sum(axis=1))
    near = depth >= -gap
    return i[near], j[near], depth[near]


def strips(low, high, r):
    """Middles and widths of 200 strips of [low, high] in a sphere, narrow at its ends, by equal angles."""
    first, last = np.arcsin(low / r), np.arcsin(high / r)
    angle = first + (np.arange(200)[:, None] + 0.5) / 200 * (last - first)
    return r * np.sin(angle), r * np.cos(angle) * (last - first) / 200


def disc_in_box(r, x0, x1, y0, y1):
    """Areas of discs of radii r > 0 around the origin that lie in rectangles."""
    low, high = np.clip(x0, -r, r), np.clip(x1, -r, r)
    x, width = strips(low, high, r)
    half = np.sqrt(np.maximum(0, r ** 2 - x ** 2))
    return (np.maximum(0, np.minimum(y1, half) - np.maximum(y0, -half)) * width).sum(axis=0)


def volume_in(place, diameter, low, high):
    """Volume of spheres in a box, by slices of each that the box cuts."""
    r = diameter / 2
    inside = ((place - r[:, None] >= low) & (place + r[:, None] <= high)).all(axis=1)
    touched = ((place + r[:, None] > low) & (place - r[:, None] < high)).all(axis=1)
    total = (math.pi / 6 * diameter[inside] ** 3).sum()
    cut = touched & ~inside
    p, r = place[cut], r[cut]
    for z, thick in zip(*strips(np.maximum(low[2] - p[:, 2], -r), np.minimum(high[2] - p[:, 2], r), r)):
        rho = np.sqrt(np.maximum(1e-30, r ** 2 - z ** 2))
        total += (disc_in_box(rho, low[0] - p[:, 0], high[0] - p[:, 0], low[1] - p[:, 1], high[1] - p[:, 1])
                  * thick).sum()
    return total


def coordination(found, touched):
    assert found["particles"] == str(len(touched)), found
    assert found["floating"] == str((touched == 0).sum()), found
    assert found["rattlers"] == str((touched <= 1).sum()), found
    check("mean", found["mean"], touched.mean(), 1e-12)
    check("without rattlers", found["without_rattlers"], touched[touched > 1].mean(), 1e-12)


def judge(found, place, diameter, low, high, periods, gap, cylinder=False):
    volume = (high - low).prod() * (math.pi / 4 if cylinder else 1)
    check("void ratio", found["void_ratio"], volume / (math.pi / 6 * (diameter ** 3).sum()) - 1, 1e-9)
    moved = np.where(periods > 0, low + (place - low) % np.where(periods > 0, periods, 1), place)

    i, j, depth = pairs_of(place, diameter, periods, gap)
    touched = np.bincount(np.concatenate([i, j]), minlength=len(place))
    assert found["contacts"] == str(len(i)), (found["contacts"], len(i))
    coordination(found["coordination"], touched)
    over = depth > 0
    assert found["overlaps"]["pairs"] == str(over.sum())
    check("largest", found["overlaps"]["largest"], depth.max(), 1e-12)
    check("relative", found["overlaps"]["largest_relative"], (depth / np.minimum(diameter[i], diameter[j])).max(), 1e-12)
    check("mean", found["overlaps"]["mean"], depth[over].mean(), 1e-12)

    inner_low, inner_high = (np.array([number(x)[0] for x in found["inner"]["space"][end]]) for end in ("low", "high"))
    margin = 2 * diameter.max()
    if cylinder:
        half = (high[0] / 2 - margin) / math.sqrt(2)
        expected = high[0] / 2 - half
        assert abs(inner_low[0] - expected) < 1e-9 and abs(inner_high[1] - high[1] + expected) < 1e-9
    else:
        assert np.allclose(inner_low, np.where(periods > 0, low, low + margin), atol=1e-12)
        assert np.allclose(inner_high, np.where(periods > 0, high, high - margin), atol=1e-12)
    axes = periods == 0
    centred = ((moved >= inner_low) & (moved < inner_high))[:, axes].all(axis=1)
    coordination(found["inner"]["coordination"], touched[centred])
    wide_low, wide_high = np.where(axes, inner_low, -1e9), np.where(axes, inner_high, 1e9)
    solids = volume_in(moved, diameter, wide_low, wide_high)
    check("inner void ratio", found["inner"]["void_ratio"], (inner_high - inner_low).prod() / solids - 1, 1e-5)

    cubes = diameter ** 3
    group = np.searchsorted(OPENINGS, diameter) - 1
    band = np.clip(((moved[:, 2] - low[2]) / (high[2] - low[2]) * 10).astype(int), 0, 9)
    table = np.array([[cubes[(group == g) & (band == k)].sum() for k in range(10)] for g in range(3)])
    for g in range(3):
        of_class = found["classes"][g]
        assert of_class["particles"] == str((group == g).sum())
        check("height", of_class["mean_height"], np.average(moved[group == g, 2] - low[2], weights=cubes[group == g]), 1e-9)
        for k in range(10):
            check("share", of_class["shares"][k], table[g, k] / table[:, k].sum(), 1e-9)
    weights, p = table.sum(axis=0) / table.sum(), table.sum(axis=1) / table.sum()
    variance = (weights * (table / table.sum(axis=0) - p[:, None]) ** 2).sum()
    check("segregation", found["segregation"], variance / (p * (1 - p)).sum(), 1e-9)


def check_refusals(folder):
    dump = ("ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS %s\n0 %s\n0 9\n0 9\n"
            "ITEM: ATOMS id x y z diameter\n1 1 1 1 2\n2 %s 1 1 2\n")
    good = dump % ("ff ff ff", "9", "3")
    data = "title\n\n1 atoms\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n%s 9 zlo zhi\n\nAtoms\n\n1 1 2 2650 1 1 %s\n"
    cases = [
        (dump % ("ff ff ff", "9", "nan"), [], ":11: coordinate 'nan'"),
        (dump % ("ff ff ff", "9", "1e200"), [], ":11: coordinate '1e200' is beyond 1e60"),
        (dump % ("ff ff ff", "0", "3"), [], ":8: the box is empty"),
        (dump % ("ff ff ff", "9 1", "3"), [], ":6: the bounds of the box are not three lines"),
        (dump % ("ff ff ff", "x", "3"), [], ":8: bound of the box 'x'"),
        (dump % ("pp ff ff", "4", "3"), [], "is periodic and no wider than two of the largest diameters"),
        (good.replace("1 1 1 1 2", "1 1 1 1 0"), [], ":10: diameter '0' is not above 0"),
        (good.replace("1 1 1 1 2", "1 1 1 1 nan"), [], ":10: diameter 'nan'"),
        (good[:-10], [], "ends after 1 of 2 atoms"),
        (good + "3 5 5 5 2\n", [], "more atoms than the 2"),
        (good.replace("x y z", "a b c"), [], "particles without a place of their own"),
        (data % ("0", "inf"), [], ":12: 'inf' is not a number"),
        (data % ("nan", "1"), [], "bound of the box 'nan'"),
        ("size_mm\n2\n", [], "particles without a place of their own"),
        ("x,y,z,size_mm,quantity\n1,1,1,2,3\n", [], "particles without a place of their own"),
        ("x,y,z,size_phi\n1,1,1,0.5\n", [], ":2: coordinate is of a sphere whose size is no fraction"),
        ("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 double\n1 nan 1\n", [], ":6: 'nan'"),
        ("1\nProperties=pos:R:3:radius:R:1 Lattice=\"9 0 0 0 9 0 0 9\"\n1 1 1 1\n", [], "Lattice, Origin or pbc"),
        (good, ["--box", "9"], "--box: '9' is neither AxB nor AxBxC"),
        (good, ["--box", "9x0"], "--box:"),
        (good, ["--box", "9x9", "--specimen", "box:9x9x9"], "--box and --specimen"),
        (good, ["--box", "9x9", "--periodic", "z"], "the height is needed"),
        (good, ["--specimen", "cylinder:9x9", "--periodic", "x"], "a cylinder has walls"),
        (good, ["--periodic", "w"], "--periodic: 'w'"),
        ("1 1 1 1\n", ["--periodic", "x"], "the file has no box"),
        (good, ["--margin", "-1"], "--margin:"),
    ]
    for text, options, message in cases:
        path = pathlib.Path(folder) / "refused"
        path.write_text(text)
        done = subprocess.run([MDM, "verify", pathlib.Path(folder) / "g.csv", path, "--packing", *options],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 2 and not done.stdout, (text, options, done.returncode, done.stdout)
        assert message in done.stderr, (message, done.stderr)
    done = subprocess.run([MDM, "verify", pathlib.Path(folder) / "g.csv", path, "--box", "9x9"], capture_output=True,
                          text=True, check=False)
    assert done.returncode == 1 and "packing, lengths in" in done.stdout, done.stderr


def main():
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "g.csv").write_text(GRADATION)
        none = np.zeros(3)
        check_refusals(folder)

        sides = np.array([40., 36., 44.])
        place, diameter = spheres(1, 3000, sides)
        text = "".join(f"{x:.6f} {y:.6f} {z:.6f} {d / 2:.7f}\n" for (x, y, z), d in zip(place, diameter))
        judge(verify(folder, "a.txt", text, "--box", "40x36x44"), place, diameter, none, sides, none, 0)
        judge(verify(folder, "a.txt", text, "--box", "40x36x44", "--contact-gap", "0.25"), place, diameter, none, sides,
              none, 0.25)
        top = np.array([40., 36., (place[:, 2] + diameter / 2).max()])
        judge(verify(folder, "a.txt", text, "--box", "40x36"), place, diameter, none, top, none, 0)

        # A dump in metres of which the file says that it is periodic, some places beyond the box.
        place[::7] += sides * [1, -1, 2]
        dump = ("ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS pp pp pp\n0 0.04\n0 0.036\n0 0.044\n"
                "ITEM: ATOMS id x y z radius\n" % len(place))
        dump += "".join(f"{i} {x:.6f}e-3 {y:.6f}e-3 {z:.6f}e-3 {d / 2:.7f}e-3\n"
                        for i, ((x, y, z), d) in enumerate(zip(place, diameter)))
        judge(verify(folder, "a.dump", dump), place, diameter, none, sides, sides, 0)

        sides = np.array([50., 50., 40.])
        place, diameter = spheres(2, 2500, sides, cylinder=True)
        text = "x,y,z,diameter_mm\n" + "".join(f"{x:.6f},{y:.6f},{z:.6f},{d:.6f}\n"
                                               for (x, y, z), d in zip(place, diameter))
        judge(verify(folder, "c.csv", text, "--specimen", "cylinder:50x40"), place, diameter, none, sides, none, 0, True)
    print("all as scipy has it")


main()
