#!/usr/bin/python3
"""check.py: verifies samples.answers.csv from definitions, with Python's standard library alone.

Of each sample the places of its particles, the shares of the mass and their errors are computed in fractions, of spheres.
Exits with 1 if an answer is wrong, and with 2 if a file cannot be read. Certificates are not read: mdm-check does that.
"""

import csv
import pathlib
import sys
from fractions import Fraction
from itertools import accumulate

COLUMNS = ("id,gradation,sample,options,verdict,particles,below,above,retained_error_lo,retained_error_hi,"
           "passing_error_lo,passing_error_hi,total_error_lo,total_error_hi").split(",")
KINDS = ("retained", "passing", "total")


class Wrong(Exception):
    """What is wrong with an answer, and where it stands."""


def demand(condition, what, error=Wrong):
    if not condition:
        raise error(what)


def table(path):
    """The header of a table, and its rows, each as long."""
    header, *rows = csv.reader(path.read_text(encoding="utf-8").splitlines())
    demand(rows and all(len(row) == len(header) for row in rows), f"{path.name}: a row is not as long as the header", ValueError)
    return header, rows


def gradation(path):
    """The cubes of the openings, and the shares of the classes between them."""
    header, rows = table(path)
    demand(header == ["size_mm", "mass"], f"{path.name}: the columns are not size_mm,mass", ValueError)
    x, m = zip(*(map(Fraction, row) for row in rows))
    good = 0 <= x[0] and all(lower < upper for lower, upper in zip(x, x[1:])) and 0 <= min(m) == m[-1] < max(m)
    demand(good, f"{path.name}: this is no gradation", ValueError)
    return [size ** 3 for size in x], [mass / sum(m) for mass in m[:-1]]


def sample(path):
    """Of each row the least and the largest cube of a size, and the number of particles."""
    header, rows = table(path)
    *sizes, last = header
    demand(last == "quantity" and sizes in (["size_mm"], ["size_lo_mm", "size_hi_mm"], ["size_mm^3"]),
           f"{path.name}: the columns are {header}", ValueError)
    power = 1 if sizes == ["size_mm^3"] else 3
    read = [(Fraction(row[0]) ** power, Fraction(row[-2]) ** power, int(row[-1])) for row in rows]
    demand(all(0 < lo <= hi and q > 0 for lo, hi, q in read), f"{path.name}: this is no sample", ValueError)
    return read


class Judged:
    """A sample against a gradation: particles outside all classes, and from where to where each value is.

    A class holds what is above its lower opening and not above its upper one. A share is of the mass in all classes.
    """

    def __init__(self, cubes, shares, rows):
        k = len(shares)
        least, most, self.outside = [Fraction(0)] * k, [Fraction(0)] * k, [0, 0]
        for lo, hi, q in rows:
            j = sum(cube < lo for cube in cubes) - 1
            demand(j == sum(cube < hi for cube in cubes) - 1, "sizes are in several classes", ValueError)
            if 0 <= j < k:
                least[j], most[j] = least[j] + q * lo, most[j] + q * hi
            else:
                self.outside[j >= k] += q
        self.retained = [(lo / sum(most), min(Fraction(1), hi / sum(least))) for lo, hi in zip(least, most)]
        passing = [(sum(lo for lo, _ in self.retained[:j]), min(Fraction(1), sum(hi for _, hi in self.retained[:j])))
                   for j in range(1, k)]
        each, above = ([(max(Fraction(0), lo - g, g - hi), max(hi - g, g - lo)) for (lo, hi), g in zip(values, targets)]
                       for values, targets in ((self.retained, shares), (passing, accumulate(shares))))
        largest = [tuple(max(ends) for ends in zip(*errors)) for errors in (each, above)]
        self.errors = dict(zip(KINDS, [*largest, tuple(sum(ends) for ends in zip(*each))]))

    def verdict(self, options):
        """Whether it matches: nothing is outside, and what the options ask for holds, closed; exactly without any."""
        kind, _, percent = (options.removeprefix("--tolerance ") or "retained:0%").partition(":")
        demand(kind in KINDS and percent.endswith("%"), f"{options} is another question", ValueError)
        least, most = (100 * error for error in self.errors[kind])
        allowed = Fraction(percent.removesuffix("%"))
        demand(most <= allowed or allowed < least or any(self.outside), "ranges leave it open", ValueError)
        return "match" if self.outside == [0, 0] and most <= allowed else "no match"


def check_row(folder, where, row):
    read = sample(folder / row["sample"])
    judged = Judged(*gradation(folder / row["gradation"]), read)
    expected = {"verdict": judged.verdict(row["options"]), "particles": str(sum(q for _, _, q in read)),
                **dict(zip(("below", "above"), map(str, judged.outside)))}
    for column, value in expected.items():
        demand(row[column] == value, f"{where}: {column} is {row[column]} and not {value}")
    for kind, ends in judged.errors.items():
        lo, hi = (100 * end for end in ends)
        told = [Fraction(row[f"{kind}_error_{end}"]) for end in ("lo", "hi")]
        exact = all(least == most for least, most, _ in read)
        enclosed = told[0] <= lo <= hi <= told[1] and 100000 * (told[1] - hi) <= hi and 100000 * (lo - told[0]) <= lo
        demand(told == [lo, hi] if exact else enclosed, f"{where}: the error {kind} is {told} and not {lo} to {hi}")


def main():
    folder, name, failed = pathlib.Path(__file__).resolve().parent, "samples.answers.csv", False
    try:
        header, rows = table(folder / name)
        demand(header == COLUMNS, f"{name}: other columns", ValueError)
        demand(len({row[0] for row in rows}) == len(rows), f"{name}: an id is there twice", ValueError)
        for number, row in enumerate(rows, 2):
            try:
                check_row(folder, f"{name}:{number}", dict(zip(COLUMNS, row)))
            except Wrong as wrong:
                failed = True
                print(f"FAILED: {wrong}")
    except Exception as error:  # what cannot be read has many forms
        print(f"samples: {error}", file=sys.stderr)
        return 2
    if not failed:
        print(f"samples: {len(rows)} right")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
