#!/usr/bin/python3
"""check.py: verifies materials.answers.csv from definitions, with Python's standard library alone.

Each answer is a match: one mass of the sample gives all shares and sizes. A sweep finds each smallest exact match again. Within a
tolerance all numbers of particles in the classes are searched through: no fewer match. Exits with 1 if an answer is wrong, and
with 2 if a file cannot be read. Certificates are not read: mdm-check does that.
"""

import csv
import math
import pathlib
import sys
from collections import namedtuple
from fractions import Fraction
from itertools import groupby

COLUMNS = "id,particles,class,material,lower,upper,share,quantity,size_lo,size_hi".split(",")
Class = namedtuple("Class", "number material lower upper factor m f F")  # m is its mass; that of a particle is above f, up to F


class Wrong(Exception):
    """What is wrong with an answer, and where it stands."""


def demand(condition, what, error=Wrong):
    if not condition:
        raise error(what)


def table(path):
    """The header of a table, and its rows, each as long; lines of comments are left out."""
    lines = path.read_text(encoding="utf-8").splitlines()
    header, *rows = csv.reader(line for line in lines if not line.startswith("# "))
    demand(rows and all(len(row) == len(header) for row in rows), f"{path.name}: a row is not as long as the header", ValueError)
    return header, rows


def gradation(path):
    """The classes of all materials: in the order of the bytes of their names, and those of a material from the finest up."""
    header, rows = table(path)
    columns = dict(zip(("size", "mass", *header[2:]), zip(*rows)))
    demand(set(header) <= {"size_mm", "size_um", "mass", "retained_g", "factor", "material"}, f"{path.name}: other columns", ValueError)
    numbers = [map(Fraction, columns.get(name, [1] * len(rows))) for name in ("size", "mass", "factor")]
    rows, classes = sorted(zip((name.encode() for name in columns["material"]), *numbers)), []
    for _, own in groupby(rows, lambda row: row[0]):
        masses = [row[2] for row in own]
        demand(0 <= min(masses) == masses[-1] < max(masses), f"{path.name}: a material without mass, or with some on its last sieve", ValueError)
    for number, ((name, lower, mass, factor), (next_name, upper, _, _)) in enumerate(zip(rows, rows[1:]), 1):
        if name == next_name:
            demand(0 <= lower < upper and factor > 0, f"{path.name}: no opening, or one that is there twice", ValueError)
            classes.append(Class(number, name.decode(), lower, upper, factor, mass, factor * lower ** 3, factor * upper ** 3))
    return classes


class Question:
    """What is asked: the errors that are allowed, as shares, and at least so many particles in each class with mass, and in all."""

    def __init__(self, options):
        words = options.replace("--tolerance ", "--").replace(":", " ").split()
        asked = dict(zip(words[::2], words[1::2]))
        demand(set(asked) <= {"--retained", "--total", "--min-per-class", "--at-least"} and 2 * len(asked) == len(words),
               f"{options} is another question", ValueError)
        self.is_exact = not {"--retained", "--total"} & set(asked)
        self.retained, self.total = (Fraction(asked.get(kind, "0%" if self.is_exact else "200%")[:-1]) / 100 for kind in ("--retained", "--total"))
        self.per_class, self.at_least = int(asked.get("--min-per-class", self.is_exact)), int(asked.get("--at-least", 1))


def smallest_match(classes, per_class):
    """The smallest exact match with `per_class` particles or more in each class with mass. q particles hold the mass s m for scales s
    above q f / m, up to q F / m. A match has a scale above q f / m of all that it needs, and so needs more than s m / F in
    each class: this is raised until it is enough."""
    q, raised = [], [per_class if c.m else 0 for c in classes]
    while q != raised:
        q = raised
        scale = max(n * c.f / c.m for n, c in zip(q, classes) if c.m)
        raised = [max(n, 1 + scale * c.m // c.F) if c.m else 0 for n, c in zip(q, classes)]
    return q


def has_exact_match(classes, per_class, first, last):
    """Whether `first` to `last` particles have an exact match. It is one up to its largest scale, which is q F / m of some class;
    at a scale each class can have every number of particles from a least one to a greatest one."""
    filled = [c for c in classes if c.m]
    for scale in {n * c.F / c.m for c in filled for n in range(1, last + 1)}:
        low = [max(per_class, math.ceil(scale * c.m / c.F)) for c in filled]
        high = [math.ceil(scale * c.m / c.f) - 1 if c.f else last for c in filled]
        if all(a <= b for a, b in zip(low, high)) and sum(low) <= last and sum(high) >= first:
            return True
    return False


class Search:
    """The search for matches within a tolerance with at most `last` particles: through all q of the classes, the coarsest first.

    Let u be 1 by the mass of the sample. The share of a class is above q f u and up to q F u, and from lo to hi. The shares sum to 1, and
    deviate from the targets g by at most T in total: max(share, g) sums to at most 1 + T/2, and min(share, g) to at least 1 - T/2.
    The larger u, the larger are the least and the greatest shares. The greatest ones are large enough from some u on; if the
    least ones are small enough anywhere, they are so there.
    """

    def __init__(self, classes, question, last):
        whole, self.question, self.last, self.T = sum(c.m for c in classes), question, last, question.total
        self.classes = sorted(classes, key=lambda c: -c.F)
        self.g, error = [c.m / whole for c in self.classes], min(question.retained, question.total / 2)
        self.lo, self.hi = [max(Fraction(0), g - error) for g in self.g], [min(Fraction(1), g + error) for g in self.g]

    def least_u(self, q):
        """The least u at which the greatest shares are large enough, or None; those of classes without a q yet are any."""
        least = [sum(lo / c.F for lo, c in zip(self.lo, self.classes)) / self.last]  # q >= lo / (F u) in each class
        least += [lo / (n * c.F) for n, lo, c in zip(q, self.lo, self.classes) if n]
        enough = all(n or not lo for n, lo in zip(q, self.lo))
        for most, wanted in ((self.hi, 1 - sum(self.hi[len(q):])), (self.g, 1 - self.T / 2 - sum(self.g[len(q):]))):
            rising = sorted((end / (n * c.F), end, n * c.F) for n, end, c in zip(q, most, self.classes) if n)
            enough = enough and sum(end for _, end, _ in rising) >= wanted
            least += [(wanted - sum(end for _, end, _ in rising[:i])) / sum(slope for _, _, slope in rising[i:]) for i in range(len(rising))]
        return max(least) if enough else None

    def fits(self, q, u):
        """Whether the least shares at u are small enough; classes without a q yet have no particles. Particles have more."""
        shares = [n * c.f * u for n, c in zip(q, self.classes)] + [0] * (len(self.classes) - len(q))
        for floors, most in ((self.lo, 1), (self.g, 1 + self.T / 2)):
            taken, is_open = sum(map(max, shares, floors)), any(n and share >= floor for n, share, floor in zip(q, shares, floors))
            if taken > most or taken == most and is_open:
                return False
        return all(n == 0 or share < hi for n, share, hi in zip(q, shares, self.hi))

    def finds(self, q=()):
        """Whether there is a match with these q of the first classes."""
        u, j = self.least_u(q), len(q)
        if u is None or not self.fits(q, u):
            return False
        if j == len(self.classes):
            return sum(q) >= self.question.at_least
        ends = [hi / (n * c.f) for n, hi, c in zip(q, self.hi, self.classes) if n and c.f]  # u is below
        needed = [math.ceil(lo / (c.F * min(ends))) if ends else int(lo > 0) for lo, c in zip(self.lo[j:], self.classes[j:])]
        first, *rest = [max(n, self.question.per_class) if c.m else n for n, c in zip(needed, self.classes[j:])]
        most = self.last - sum(q) - sum(rest)
        if self.classes[j].f and u > 0:
            most = min(most, max(0, math.ceil(self.hi[j] / (self.classes[j].f * u)) - 1))
        return any(self.finds((*q, n)) for n in range(first, most + 1))


def check_sample(where, classes, question, rows):
    """One mass of the sample gives all shares and sizes; the shares are within what is allowed."""
    masses, errors, whole = [], [], sum(c.m for c in classes)
    for row, c in zip(rows, classes, strict=True):
        told = int(row["class"]), row["material"], Fraction(row["lower"]), Fraction(row["upper"])
        demand(told == c[:4], f"{where}: {told} is not the class {c.number} of {c.material}")
        q, share, lo, hi = (Fraction(row[column] or 0) for column in ("quantity", "share", "size_lo", "size_hi"))
        demand(q >= (question.per_class if c.m else 0), f"{where}: {q} particles in the class {c.number} are too few")
        inside = c.lower < lo <= hi <= c.upper and hi - lo <= hi / 10 ** 14 and share > 0
        good = inside if q else share == 0 and row["size_lo"] == row["size_hi"] == ""
        demand(good, f"{where}: sizes are not in the class {c.number}, or do not agree to 14 digits, or it has another share")
        masses += [[q * c.factor * size ** 3 / share for size in (lo, hi)]] if q else []
        errors.append(abs(share - c.m / whole))
    good = sum(Fraction(row["share"]) for row in rows) == 1 and max(errors) <= question.retained and sum(errors) <= question.total
    demand(good, f"{where}: the shares do not sum to 1, or are not within the tolerance")
    low = max(lo for lo, _ in masses)
    demand(all(low < hi or low == lo == hi for lo, hi in masses), f"{where}: sizes and shares are of no one mass")


def check_answer(where, path, options, rows):
    """The answer is a match, and no fewer particles are one."""
    classes, question, N = gradation(path), Question(options), sum(int(row["quantity"]) for row in rows)
    demand(len(rows) == len(classes), f"{where}: {len(rows)} rows of {len(classes)} classes")
    check_sample(where, classes, question, rows)
    demand({row["particles"] for row in rows} == {str(N)} and N >= question.at_least, f"{where}: there are {N} particles")
    if question.is_exact:
        least, first = sum(smallest_match(classes, question.per_class)), question.at_least
        smaller = least < N if first <= least else first < N and has_exact_match(classes, question.per_class, first, N - 1)
    else:
        smaller = question.at_least < N and Search(classes, question, N - 1).finds()
    demand(not smaller, f"{where}: fewer particles than {N} are a match")


def main():
    folder, name, failed = pathlib.Path(__file__).resolve().parent, "materials.answers.csv", False
    try:
        header, rows = table(folder / name)
        asked, answers = table(folder / "materials.csv")[1], {}
        for row in rows:
            answers.setdefault(row[0], []).append(dict(zip(COLUMNS, row)))
        demand(header == COLUMNS and [*answers] == [row[0] for row in asked],
               f"{name}: other columns, or other questions than those of materials.csv", ValueError)
        for key, file, options in asked:
            try:
                check_answer(f"{name}: {key}", folder / file, options, answers[key])
            except Wrong as wrong:
                failed = True
                print(f"FAILED: {wrong}")
    except Exception as error:  # what cannot be read has many forms
        print(f"materials: {error}", file=sys.stderr)
        return 2
    if not failed:
        print(f"materials: {len(asked)} right")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
