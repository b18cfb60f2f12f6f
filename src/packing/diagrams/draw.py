#!/usr/bin/python3
"""draw.py FOLDER: the three diagrams of ../README.md, written to FOLDER as SVG.

Discs are laid, and the surface is walked along, as surface_walk.cpp does it, but in plain floating point: a picture shows
what the algorithm finds. Numbers are written with one decimal, so that every machine writes the same bytes.
"""
import math
import pathlib
import sys

INK, GREY, LIGHT, BLUE, RED, GREEN = "#222", "#8a8f98", "#d9dce1", "#1f5fbf", "#c0392b", "#2e8b57"


# ---- The surface -----------------------------------------------------------------------------------------------------


class Disc:
    def __init__(self, x, y, r):
        self.x, self.y, self.r = x, y, r


class Walk:
    """The boundary of the places of a disc of radius q between two walls, from `start` to `end` if these are given,
    which are discs on whose top it can lie: arcs, vertices and the lowest place."""

    def __init__(self, discs, q, width, start=None, end=None):
        self.discs, self.q, self.width, self.starts_on_top = discs, q, width, start is not None
        self.arcs, self.vertices, self.floors = [], [], []
        at = (start, math.pi / 2, None) if start else self.down_the_left_wall()
        while at and len(self.arcs) < 1000:
            at = self.leave(*at, end)
        places = self.vertices + self.floors
        self.lowest = min(places, key=lambda p: (p[1], p[0])) if places else None

    def leg(self, disc, x):
        reach = disc.r + self.q
        return math.sqrt(max(0.0, reach * reach - (disc.x - x)**2))

    def down_the_left_wall(self):
        met = [d for d in self.discs if abs(d.x - self.q) < d.r + self.q]
        if not met:
            return self.cross_floor(self.q)
        top = max(met, key=lambda d: d.y + self.leg(d, self.q))
        y = top.y + self.leg(top, self.q)
        self.vertices.append((self.q, y))
        return top, math.atan2(y - top.y, self.q - top.x), None

    def cross_floor(self, x):
        ends = [(d.x - math.sqrt((d.r + self.q)**2 - (d.y - self.q)**2), d) for d in self.discs
                if abs(d.y - self.q) < d.r + self.q and d.x > x]
        right, disc = min(ends, key=lambda e: e[0], default=(self.width - self.q, None))
        self.floors.append(((x + right) / 2, self.q))
        return (disc, math.atan2(self.q - disc.y, right - disc.x), None) if disc else None

    def leave(self, disc, angle, previous, end):
        """Clockwise to the end of the arc around the disc, and on."""
        reach, ends = disc.r + self.q, []

        def offer(to, then):
            ends.append(((angle - to) % (2 * math.pi), then))

        for other in self.discs:
            distance = math.hypot(other.x - disc.x, other.y - disc.y)
            if other not in (disc, previous) and distance < reach + other.r + self.q:
                along = (distance**2 + reach**2 - (other.r + self.q)**2) / (2 * distance)
                turn = math.acos(along / reach)
                offer(math.atan2(other.y - disc.y, other.x - disc.x) + turn, other)
        if disc.y - reach < self.q:
            offer(math.asin((self.q - disc.y) / reach), "floor")
        if disc.x + reach > self.width - self.q:
            offer(math.acos((self.width - self.q - disc.x) / reach), "wall")
        if disc is end and (self.arcs or not self.starts_on_top):
            offer(math.pi / 2, "end")
        turn, then = min(ends, key=lambda e: e[0])
        to = angle - turn
        x, y = disc.x + reach * math.cos(to), disc.y + reach * math.sin(to)
        self.arcs.append((disc, angle, to))
        if then == "end":
            return None
        if then == "floor":
            return self.cross_floor(x)
        # Two discs carry a third that is above and between them.
        if then == "wall" or (disc.x <= x <= then.x and
                              (y - disc.y) * (then.x - disc.x) >= (x - disc.x) * (then.y - disc.y)):
            self.vertices.append((x, y))
        return None if then == "wall" else (then, math.atan2(y - then.y, x - then.x), disc)


def heap(radii, width):
    """Discs that are laid each at the lowest place."""
    discs = []
    for r in radii:
        x, y = Walk(discs, r, width).lowest
        discs.append(Disc(x, y, r))
    return discs


# ---- SVG -------------------------------------------------------------------------------------------------------------


class Drawing:
    """A picture with the y axis upwards: `scale` pixels a unit, the origin `left` and `below` the upper left corner."""

    def __init__(self, title, width, height, scale=1.0, left=0.0, below=0.0):
        self.scale, self.left, self.below = scale, left, below
        self.lines = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
            f'font-family="Helvetica, Arial, sans-serif" font-size="14">', f"<title>{title}</title>",
            f'<rect width="{width}" height="{height}" fill="#fff"/>']

    def x(self, x):
        return f"{self.left + self.scale * x + 0.0:.1f}"

    def y(self, y):
        return f"{self.below - self.scale * y + 0.0:.1f}"

    def add(self, line):
        self.lines.append(line)

    def circle(self, x, y, r, fill="none", stroke=INK, width=1.2, more=""):
        self.add(f'<circle cx="{self.x(x)}" cy="{self.y(y)}" r="{self.scale * r:.1f}" fill="{fill}" stroke="{stroke}" '
                 f'stroke-width="{width}"{more}/>')

    def line(self, points, stroke=INK, width=1.2, more=""):
        self.add(f'<polyline points="{" ".join(self.x(x) + "," + self.y(y) for x, y in points)}" fill="none" '
                 f'stroke="{stroke}" stroke-width="{width}"{more}/>')

    def arc(self, disc, reach, angle, to, stroke, width):
        """Clockwise."""
        ends = [(disc.x + reach * math.cos(v), disc.y + reach * math.sin(v)) for v in (angle, to)]
        (x, y), (u, v) = ends
        radius = f"{self.scale * reach:.1f}"
        self.add(f'<path d="M {self.x(x)} {self.y(y)} A {radius} {radius} 0 {int(angle - to > math.pi)} 1 {self.x(u)} '
                 f'{self.y(v)}" fill="none" stroke="{stroke}" stroke-width="{width}"/>')

    def text(self, x, y, text, fill=INK, anchor="start", size=14, more=""):
        """In pixels."""
        self.add(f'<text x="{x}" y="{y}" fill="{fill}" text-anchor="{anchor}" font-size="{size}"{more}>{text}</text>')

    def pointer(self, x, y, u, v, stroke=INK):
        """A thin line from a label, in pixels, to a place of the picture."""
        self.add(f'<line x1="{x}" y1="{y}" x2="{self.x(u)}" y2="{self.y(v)}" stroke="{stroke}" stroke-width="0.8"/>')

    def arrow(self, points, stroke, width=2.0):
        """With a head at its end."""
        self.line(points, stroke, width)
        (x, y), (u, v) = points[-2:]
        away = math.atan2(v - y, u - x)
        size = 9 / self.scale
        head = [(u, v)] + [(u - size * math.cos(away + turn), v - size * math.sin(away + turn)) for turn in (0.42, -0.42)]
        self.add(f'<polygon points="{" ".join(self.x(a) + "," + self.y(b) for a, b in head)}" fill="{stroke}"/>')

    def ground(self, width, height):
        """A floor, and two walls on it."""
        self.line([(0, height), (0, 0), (width, 0), (width, height)], INK, 2.4)

    def write(self, path):
        path.write_text("\n".join(self.lines + ["</svg>", ""]), encoding="utf-8")


# ---- The diagrams ----------------------------------------------------------------------------------------------------


def offset_circles(path):
    """Circles around discs, the walk along their outer arcs, and the lowest vertex."""
    q, radii = 0.72, [1.3, 0.8, 1.15, 0.5, 1.2, 0.9]
    x, discs = radii[0], []
    for before, r in zip([None, *radii], radii):
        x += 2 * math.sqrt(before * r) if before else 0
        discs.append(Disc(x, r, r))
    width = x + radii[-1]
    for pair, r in ((discs[0:2], 0.85), (discs[4:6], 0.95)):
        between = [v for v in Walk(pair, r, width).vertices if pair[0].x < v[0] < pair[1].x]
        discs.append(Disc(*between[0], r))
    walk = Walk(discs, q, width)
    left, below, scale = 40, 352, 54
    right = left + scale * width
    d = Drawing("Offset circles and the walk on them", 760, 440, scale, left, below)
    for disc in discs:
        d.circle(disc.x, disc.y, disc.r + q, stroke=GREY, width=1, more=' stroke-dasharray="5 4"')
    for x, y, w, h in ((0, below, 760, 88), (0, 0, left, 440), (right, 0, 760 - right, 440)):
        d.add(f'<rect x="{x:.1f}" y="{y:.1f}" width="{w:.1f}" height="{h:.1f}" fill="#fff"/>')
    for disc in discs:
        d.circle(disc.x, disc.y, disc.r, LIGHT)
    d.ground(width, 6.0)
    lowest = walk.lowest
    d.circle(*lowest, q, "#f6d5d0", RED, 2)
    first, last = walk.arcs[0], walk.arcs[-1]
    d.arrow([(q, 5.8), (q, first[0].y + (first[0].r + q) * math.sin(first[1]) + 0.1)], BLUE, 2.4)
    for disc, angle, to in walk.arcs:
        d.arc(disc, disc.r + q, angle, to, BLUE, 2.4)
    end = (width - q, last[0].y + (last[0].r + q) * math.sin(last[2]))
    d.arrow([end, (end[0], 5.8)], BLUE, 2.4)
    for vertex in walk.vertices:
        d.circle(*vertex, 0.1, RED if vertex == lowest else BLUE, "#fff", 1)
    carrier = discs[4]
    turn = math.radians(110)
    d.line([(carrier.x, carrier.y), (carrier.x + (carrier.r + q) * math.cos(turn),
                                     carrier.y + (carrier.r + q) * math.sin(turn))], INK, 1)
    d.circle(carrier.x, carrier.y, 0.05, INK)
    d.text(d.x(carrier.x + 0.05), d.y(carrier.y + 0.5), "r + q")
    d.text(f"{left + scale * width / 2:.1f}", 30, "the walk: the edge of all places of its centre that are reached from above", BLUE, "middle")
    d.text(left, 384, "Grey: discs of the front, radius r. Dashed: their offset circles, radius r + q, where the walk is not.")
    d.text(left, 406, "Blue dots: vertices. There a disc of radius q touches two, and they carry it if it is between them.", BLUE)
    d.text(left, 428, "Red: the lowest vertex, where the disc comes to lie.", RED)
    d.write(path)


# ---- A slide on two spheres ------------------------------------------------------------------------------------------


def sub(a, b):
    return tuple(u - v for u, v in zip(a, b))


def along(a, t, b):
    return tuple(u + t * v for u, v in zip(a, b))


def length(a):
    return math.sqrt(sum(u * u for u in a))


def unit(a):
    return tuple(u / length(a) for u in a)


def seen(a, turn=math.radians(38), tilt=math.radians(18)):
    """Right, up, and towards the eye, of a place."""
    x, y, z = a
    right, away = x * math.cos(turn) + y * math.sin(turn), -x * math.sin(turn) + y * math.cos(turn)
    return right, z * math.cos(tilt) + away * math.sin(tilt), z * math.sin(tilt) - away * math.cos(tilt)


def slide(path):
    """A sphere that rolls down on two others until it meets a third."""
    q = 0.62
    a, b = ((-1.0, 0.0, 1.05), 1.05), ((1.0, 0.05, 0.9), 0.9)
    axis = unit(sub(b[0], a[0]))
    distance = length(sub(b[0], a[0]))
    far, near = a[1] + q, b[1] + q
    middle = along(a[0], (distance + (far - near) * (far + near) / distance) / 2, axis)
    radius = math.sqrt(far**2 - length(sub(middle, a[0]))**2)
    up = unit(along((0.0, 0.0, 1.0), -axis[2], axis))
    front = (axis[1] * up[2] - axis[2] * up[1], axis[2] * up[0] - axis[0] * up[2], axis[0] * up[1] - axis[1] * up[0])

    def on_circle(degrees):
        v = math.radians(degrees)
        return along(along(middle, radius * math.cos(v), up), radius * math.sin(v), front)

    c_radius, stop = 0.75, 66
    # It is where the sphere touches it at the end of the slide.
    c = (along(on_circle(stop), c_radius + q, unit((-0.35, -1.0, -0.75))), c_radius)
    d = Drawing("A slide on two spheres", 820, 450, 100, 255, 350)
    d.add('<defs>')
    for name, light, dark in (("grey", "#f7f8fa", "#a9aeb7"), ("red", "#fdeeeb", "#e2998f"), ("pale", "#ffffff", "#f3d9d5")):
        d.add(f'<radialGradient id="{name}" cx="0.38" cy="0.32" r="0.75"><stop offset="0" stop-color="{light}"/>'
              f'<stop offset="1" stop-color="{dark}"/></radialGradient>')
    d.add('</defs>')

    def sphere(centre, r, fill, stroke=INK, more=""):
        d.circle(*seen(centre)[:2], r, f"url(#{fill})", stroke, 1.2, more)

    spheres = [(a[0], a[1], "grey", INK, ""), (b[0], b[1], "grey", INK, ""), (*c, "grey", INK, "")]
    for degrees in (8, 34):
        spheres.append((on_circle(degrees), q, "pale", RED, ' fill-opacity="0.75" stroke-dasharray="4 3"'))
    spheres.append((on_circle(stop), q, "red", RED, ""))
    for one in sorted(spheres, key=lambda s: seen(s[0])[2]):
        sphere(*one)
    d.line([seen(on_circle(v))[:2] for v in range(0, 361, 3)], GREY, 1, ' stroke-dasharray="5 4"')
    d.line([seen(a[0])[:2], seen(b[0])[:2]], INK, 1, ' stroke-dasharray="9 3 2 3"')
    d.arrow([seen(along(on_circle(8), 1.2, (0, 0, 1)))[:2], seen(along(on_circle(8), 0.04, (0, 0, 1)))[:2]], BLUE, 2.4)
    d.arrow([seen(on_circle(v))[:2] for v in range(8, stop + 1, 2)], BLUE, 2.4)
    for centre in (a[0], b[0], c[0], middle):
        d.circle(*seen(centre)[:2], 0.03, INK)

    def label(x, y, lines, place, fill=INK):
        for i, line in enumerate(lines):
            d.text(x, y + 18 * i, line, fill)
        d.pointer(x - 6, y - 5, *seen(place)[:2], fill)

    label(490, 50, ["1. It falls in its column, rolls down on the", "first sphere that it meets, and meets a second."],
          along(on_circle(8), 0.75, (0, 0, 1)), BLUE)
    label(490, 140, ["2. It slides on both: its centre goes along a", "circle (dashed) around the line between",
                     "their centres, at the distances r + q."], on_circle(36), BLUE)
    label(490, 262, ["3. It meets a third sphere. Its centre is above", "the triangle of the three: it rests.",
                     "Had it met none, it would have left one of", "the two where that presses no more, and",
                     "gone on around the other alone."], along(c[0], c_radius, unit(sub(on_circle(stop), c[0]))), RED)
    d.write(path)


# ---- A block with its separators -------------------------------------------------------------------------------------


def is_hidden(separator, by, radii):
    """Whether a disc of some of the radii cannot lie on the top of the separator, as lowest_place.cpp has it."""
    for q in radii:
        near, rise, dx = by.r + q, separator.y + separator.r + q - by.y, separator.x - by.x
        if abs(dx) < near and (rise < 0 or rise * rise + dx * dx < near * near):
            return True
    return False


def blocks(path):
    """The surface cut into blocks by separators, with the bound of each, and the search for the place of a disc."""
    width, least, greatest, r = 15.0, 0.42, 0.9, 0.56
    discs = heap([(0.9, 0.55, 0.7, 0.42, 0.8, 0.5, 0.62, 0.85, 0.45)[i % 9] for i in range(19)], width)
    separators = [s for s in sorted(discs, key=lambda s: s.x) if greatest < s.x < width - greatest and
                  not any(is_hidden(s, by, (least, greatest)) for by in discs if by is not s)]
    left, below, scale, top = 30, 332, 50, 6.2
    d = Drawing("A block with its separators", 810, 450, scale, left, below)
    ends = list(zip([None, *separators], [*separators, None]))
    bounds = [Walk(discs, least, width, *pair).lowest[1] - least for pair in ends]
    # Blocks are looked at in the order of their bounds, until one is above the bottom of the best place.
    looked_at, best = [], None
    for n in sorted(range(len(ends)), key=lambda n: bounds[n]):
        if best and bounds[n] > best[1] - r:
            break
        place = Walk(discs, r, width, *ends[n]).lowest
        looked_at.append((n, place))
        best = min(best or place, place, key=lambda p: p[1])
    assert len(ends) == 7 and [place is best for _, place in looked_at] == [False, True]  # as the text says
    shown = 5
    x, u = ends[shown][0].x, ends[shown][1].x
    d.add(f'<rect x="{d.x(x)}" y="{d.y(top)}" width="{scale * (u - x):.1f}" height="{scale * top:.1f}" fill="#eef4fc"/>')
    d.ground(width, top)
    for disc in discs:
        d.circle(disc.x, disc.y, disc.r, "#bcd2f0" if disc in separators else LIGHT)
    for s in separators:
        d.line([(s.x, s.y + s.r), (s.x, top)], BLUE, 1.4, ' stroke-dasharray="6 4"')
    for order, (n, place) in enumerate(looked_at, 1):
        found = place is best
        d.circle(*place, r, "#f6d5d0" if found else "none", RED, 2 if found else 1.4, "" if found else ' stroke-dasharray="4 3"')
        d.text(d.x(place[0]), f"{float(d.y(place[1])) + 5:.1f}", f"{order}", RED, "middle")
    for bound, pair in zip(bounds, ends):
        d.line([(pair[0].x if pair[0] else 0, bound), (pair[1].x if pair[1] else width, bound)], GREEN, 2.2)
    middle = (x + u) / 2
    for to in (x, u):
        d.arrow([(middle, top - 0.75), (to, top - 0.75)], BLUE, 1.4)
    d.text(d.x(middle), d.y(top - 0.5), "a block", BLUE, "middle")
    d.text(d.x(middle), d.y(top - 1.25), "between separators", BLUE, "middle", 13)
    d.text(left, 360, "Blue: separators. Every disc of the set can lie on their tops, with nothing above.", BLUE)
    d.text(left, 381, "Green: bounds. No disc of the class, of radius 0.42 to 0.58, can have its bottom lower in the block.", GREEN)
    d.text(left, 402, "Red: a disc of radius 0.56. The blocks with the least bounds are looked at first: 1, then 2, which is lower.", RED)
    d.text(left, 423, "All other bounds are above the bottom of 2: there it comes to lie, and five blocks are not looked at.", RED)
    d.write(path)


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    offset_circles(folder / "offset_circles.svg")
    slide(folder / "slide.svg")
    blocks(folder / "blocks.svg")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("draw.py FOLDER")
    main(pathlib.Path(sys.argv[1]))
