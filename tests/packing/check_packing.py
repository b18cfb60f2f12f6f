#!/usr/bin/python3
"""check_packing.py FILE...: judges packing files in whole numbers, with no code of the project.

No two discs overlap, all are inside the box, each rests on two earlier discs, the floor or a wall, which it touches
within 64 units, its centre above and between them. Says what is wrong first, or `ok` and the number of discs.
"""

import sys
from collections import defaultdict

TOUCH = 64


def check(path):
    lines = open(path, encoding="ascii").read().splitlines()
    start = lines.index("x y r left right")
    head = dict(line.split(" ") for line in lines[:start])
    width, periodic = int(head["width"]), head["sides"] == "periodic"
    discs, cells = [], defaultdict(list)
    rows = [line.split(" ") for line in lines[start + 1:]]
    side = 2 * max(int(row[2]) for row in rows) + TOUCH
    columns = max(1, width // side)

    def nearest(dx):
        return (dx + width // 2) % width - width // 2 if periodic else dx

    for i, (x, y, r, left, right) in enumerate(rows):
        x, y, r = int(x), int(y), int(r)
        if y < r or not (0 <= x < width if periodic else r <= x <= width - r):
            return f"disc {i} is outside the box"
        column, row = min(x // side, columns - 1), y // side
        for c in {(column + k) % columns if periodic else column + k for k in (-2, -1, 0, 1, 2)}:
            for j in (j for k in (-1, 0, 1) for j in cells[c, row + k]):
                a, b, s = discs[j]
                if nearest(x - a) ** 2 + (y - b) ** 2 < (r + s) ** 2:
                    return f"discs {j} and {i} overlap"
        supports = []
        for word in (left, right):
            if word.isdigit():
                if int(word) >= i:
                    return f"disc {i} rests on a later one"
                a, b, s = discs[int(word)]
                u, v, gap2 = nearest(a - x), b - y, (r + s + TOUCH) ** 2
            else:
                u, v = {"floor": (0, -y), "left-wall": (-x, 0), "right-wall": (width - x, 0)}[word]
                gap2 = (r + TOUCH) ** 2
            if u * u + v * v > gap2:
                return f"disc {i} does not touch {word}"
            supports.append((u, v))
        (u, v), (a, b) = supports
        if u > 0 or a < 0 or u * b - v * a < 0:
            return f"disc {i} would roll off {left} and {right}"
        discs.append((x, y, r))
        cells[column, row].append(i)
    return None


for file in sys.argv[1:]:
    wrong = check(file)
    if wrong:
        sys.exit(f"{file}: {wrong}")
print("ok")
