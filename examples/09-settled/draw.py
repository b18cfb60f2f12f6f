#!/usr/bin/python3
"""draw.py GRADATION CURVE DUMP OUT: the curve that mdm plot wrote as SVG, and beside it the grains of a dump of LAMMPS.

The grains are seen from above one corner of their box, without perspective; what is nearer is drawn later. Each class of
the gradation, a canonical CSV in mm, has its colour."""
import csv
import math
import sys

WIDTH, HEIGHT, MARGIN = 1180, 520, 20
COLOURS = ["#ffe79e", "#fcc95a", "#fba541", "#f08322", "#d1590c", "#9c3a06", "#5c1f06"]
TURN, TILT = math.radians(35), math.radians(24)  # of the view


def sieves(path):
    """The openings of a gradation, from the finest on, in m."""
    lines = [line for line in open(path, encoding="ascii") if not line.startswith("#")]
    return sorted(float(row["size_mm"]) / 1000 for row in csv.DictReader(lines))


def grains(path, openings):
    """(class, x, y, z, radius) of each grain."""
    lines = open(path, encoding="ascii").read().split("\n")
    start = next(i for i, line in enumerate(lines) if line.startswith("ITEM: ATOMS id type x y z radius"))
    for line in lines[start + 1:]:
        if line:
            x, y, z, radius = map(float, line.split()[2:])
            yield (sum(opening < 2 * radius for opening in openings), x, y, z, radius)


def seen(grain):
    """(depth, right, up, radius, class): depth grows towards the eye."""
    number, x, y, z, radius = grain
    right = x * math.cos(TURN) + y * math.sin(TURN)
    away = y * math.cos(TURN) - x * math.sin(TURN)
    return (z * math.sin(TILT) - away * math.cos(TILT), right, z * math.cos(TILT) + away * math.sin(TILT), radius, number)


def shades():
    """A ball of each colour, lit from the left above."""
    return "\n".join(
        f'<radialGradient id="class{i}" cx="0.36" cy="0.3" r="0.75"><stop offset="0" stop-color="#ffffff"/>'
        f'<stop offset="0.25" stop-color="{colour}"/><stop offset="1" stop-color="{colour}"/></radialGradient>'
        for i, colour in enumerate(COLOURS, 1))


def balls(all_seen, left, top, width, height):
    """The grains as circles within that rectangle."""
    x0, x1 = (min(x - r for _, x, _, r, _ in all_seen), max(x + r for _, x, _, r, _ in all_seen))
    y0, y1 = (min(y - r for _, _, y, r, _ in all_seen), max(y + r for _, _, y, r, _ in all_seen))
    scale = min(width / (x1 - x0), height / (y1 - y0))
    left += (width - scale * (x1 - x0)) / 2
    for _, x, y, radius, number in sorted(all_seen):
        yield (f'<circle cx="{left + scale * (x - x0):.1f}" cy="{top + height - scale * (y - y0):.1f}" '
               f'r="{scale * radius:.1f}" fill="url(#class{number})"/>')


def main(gradation, curve, dump, out):
    diagram = open(curve, encoding="utf-8").read()
    diagram = diagram[diagram.index("<svg "):]
    side = (WIDTH - 3 * MARGIN) // 2
    picture = "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" font-family="sans-serif">',
        "<title>A sieve analysis, and the smallest set of particles that matches it, settled</title>",
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>', "<defs>", shades(), "</defs>",
        f'<svg x="{MARGIN}" y="{MARGIN}" width="{side}" height="{HEIGHT - 2 * MARGIN}" ' +
        diagram[diagram.index("viewBox="):].rstrip(),
        '<g stroke="#333333" stroke-width="0.4">',
        *balls(list(map(seen, grains(dump, sieves(gradation)))), 2 * MARGIN + side, MARGIN, side, HEIGHT - 2 * MARGIN), "</g>",
        "</svg>", ""])
    with open(out, "w", encoding="utf-8") as file:
        file.write(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
