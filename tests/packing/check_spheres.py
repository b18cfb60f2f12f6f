#!/usr/bin/python3
"""check_spheres.py FILE...: judges deposits of spheres in whole numbers, with no code of the project.

A file has a line `a b sides`, then a line `x y z r s s s` a sphere, in the order of their deposit. No two spheres overlap,
all are inside the space. A sphere lies on the floor, or on three: earlier spheres or sides, which it touches within 256
units (the flat sides in a cylinder within 1e-4 of its radius), and which together can carry its weight. One in a
thousand may lie otherwise. Says what is wrong first, or `ok`.
"""

import sys
from collections import defaultdict

TOUCH = 256
FLOOR, SIDE, NONE = -1, -2, -3


class Space:
    """The space, and what is seen of others from a place."""

    def __init__(self, words):
        self.a, self.b, self.sides = int(words[0]), int(words[1]), words[2]

    def nearest(self, d, width):
        return (d + width // 2) % width - width // 2 if self.sides == "periodic" else d

    def to(self, p, q):
        return (self.nearest(q[0] - p[0], self.a), self.nearest(q[1] - p[1], self.b), q[2] - p[2])

    def holds(self, p, r):
        x, y, z = p
        if self.sides == "periodic":
            return z >= r and 0 <= x < self.a and 0 <= y < self.b
        if not (z >= r and r <= x <= self.a - r and r <= y <= self.b - r):
            return False
        return self.sides != "cylinder" or (2 * x - self.a) ** 2 + (2 * y - self.a) ** 2 <= (self.a - 2 * r) ** 2

    def touched_sides(self, p, r):
        """Directions to the sides that a sphere touches."""
        x, y, _ = p
        if self.sides == "cylinder":
            u, v = 2 * x - self.a, 2 * y - self.a
            room = self.a - 2 * r - self.a // 10000 - TOUCH
            # Flat sides are turned by up to 1/81 against the round wall.
            return [(81 * u - v, 81 * v + u, 0), (81 * u + v, 81 * v - u, 0)] if u * u + v * v >= room * room else []
        walls = [(x, (-r, 0, 0)), (self.a - x, (r, 0, 0)), (y, (0, -r, 0)), (self.b - y, (0, r, 0))]
        return [d for far, d in walls if far <= r + TOUCH]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def carries(directions):
    """True if weights, none of them negative, of the three directions add up to straight down, nearly."""
    a, b, c = directions
    volume = sum(u * v for u, v in zip(a, cross(b, c)))
    parts = [part[2] * (-1 if volume > 0 else 1) for part in (cross(b, c), cross(c, a), cross(a, b))]
    return volume != 0 and min(parts) >= -max(parts) // 1000


def choices(supports, sides):
    """The directions of the supports: any of the touched sides for a side."""
    lists = [[[]]]
    for s in supports:
        lists.append([one + [d] for one in lists[-1] for d in (sides if s == SIDE else [s])])
    return lists[-1]


def rests(space, spheres, i, p, r, supports):
    if FLOOR in supports:
        return p[2] <= r + TOUCH
    if NONE in supports:
        return False
    directions = []
    for s in supports:
        if s == SIDE:
            directions.append(SIDE)
            continue
        d = space.to(p, spheres[s][0])
        if s >= i or sum(u * u for u in d) > (r + spheres[s][1] + TOUCH) ** 2:
            return False
        directions.append(d)
    return any(carries(choice) for choice in choices(directions, space.touched_sides(p, r)))


def check(path):
    lines = open(path, encoding="ascii").read().splitlines()
    space, rows = Space(lines[0].split()), [list(map(int, line.split())) for line in lines[1:]]
    side = 2 * max(row[3] for row in rows)
    nx, ny = max(1, space.a // side), max(1, space.b // side)
    spheres, cells, loose = [], defaultdict(list), 0
    for i, (x, y, z, r, *supports) in enumerate(rows):
        p = (x, y, z)
        if not space.holds(p, r):
            return f"sphere {i} is outside the space"
        u, v, w = min(x // side, nx - 1), min(y // side, ny - 1), z // side
        near = {((u + j) % nx, (v + k) % ny, w + m) for j in (-2, -1, 0, 1, 2) for k in (-2, -1, 0, 1, 2)
                for m in (-1, 0, 1)}
        for j in (j for cell in near for j in cells[cell]):
            if sum(d * d for d in space.to(p, spheres[j][0])) < (r + spheres[j][1]) ** 2:
                return f"spheres {j} and {i} overlap"
        loose += not rests(space, spheres, i, p, r, supports)
        spheres.append((p, r))
        cells[u, v, w].append(i)
    if 1000 * loose > len(rows):
        return f"{loose} of {len(rows)} spheres do not rest"
    return None


for file in sys.argv[1:]:
    wrong = check(file)
    if wrong:
        sys.exit(f"{file}: {wrong}")
print("ok")
