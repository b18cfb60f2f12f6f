#!/usr/bin/python3
"""check.py: verifies judgements.answers.csv from definitions, with Python's standard library alone.

Of the curves that round to a report it is computed whether all, some or none keep the specification; curves that are shown
are verified. Exits with 1 if an answer is wrong, and with 2 if a file cannot be read. There are no certificates.
"""

import csv
import pathlib
import sys
from fractions import Fraction
from itertools import accumulate

COLUMNS = ["id", "report", "specification", "options", "verdict", "within", "outside"]
FM = [Fraction(size) for size in "0.15 0.3 0.6 1.18 2.36 4.75 9.5 19 37.5 75 150".split()]


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


def by_size(path, columns):
    """The rows of a table of sieves, from the finest up, as texts behind their sizes."""
    header, rows = table(path)
    demand(header == columns, f"{path.name}: the columns are not {columns}", ValueError)
    found = sorted((Fraction(row[0]), *row[1:]) for row in rows)
    demand(len({row[0] for row in found}) == len(found), f"{path.name}: a sieve is there twice", ValueError)
    return found


def room(printed):
    """From where to where the numbers are that round to a printed percent, ends included."""
    half = Fraction(1, 2 * 10 ** len(printed.partition(".")[2]))
    return max(Fraction(0), Fraction(printed) - half), min(Fraction(100), Fraction(printed) + half)


class Curves:
    """All curves, nondecreasing in size, between two bounds at each sieve: a set with a least curve and a greatest one."""

    def __init__(self, bounds):
        least, most = zip(*bounds)
        self.least, self.most = list(accumulate(least, max)), list(accumulate(most[::-1], min))[::-1]
        self.exist = all(lo <= hi for lo, hi in zip(self.least, self.most))

    def hold(self, curve):
        return curve == sorted(curve) and all(lo <= p <= hi for lo, p, hi in zip(self.least, curve, self.most))


class Question:
    """The curves that round to a report, and those that a specification allows at its sieves; limits of the modulus."""

    def __init__(self, folder, report, specification, options):
        printed = by_size(folder / report, ["size_mm", "passing_percent"])
        limits = by_size(folder / specification, ["size_mm", "passing_min_percent", "passing_max_percent"])
        self.sizes = [row[0] for row in printed]
        demand(self.sizes == [row[0] for row in limits], f"{report}: other sieves than those of {specification}", ValueError)
        percents = [Fraction(row[1]) for row in printed]
        demand(percents == sorted(percents) and percents[-1] == 100, f"{report}: this is no report", ValueError)
        rooms = [*(room(row[1]) for row in printed[:-1]), (Fraction(100), Fraction(100))]
        self.allowed = [(Fraction(lo), Fraction(hi)) for _, lo, hi in limits]
        self.reported = Curves(rooms)
        self.within = Curves([(max(a, lo), min(b, hi)) for (a, b), (lo, hi) in zip(rooms, self.allowed)])
        demand(options == "" or options.startswith("--limit FM="), f"{options} is another question", ValueError)
        self.modulus_limits = [Fraction(end) for end in options.removeprefix("--limit FM=").split("..")] if options else None

    def modulus(self, curve):
        """The sum of the shares retained on its sieves; one above the largest sieve retains nothing."""
        at = dict(zip(self.sizes, curve))
        return sum(1 - (100 if size > self.sizes[-1] else at[size]) / Fraction(100) for size in FM)

    def keeps(self, curve):
        at_sieves = all(lo <= p <= hi for p, (lo, hi) in zip(curve, self.allowed))
        return at_sieves and (not self.modulus_limits or self.modulus_limits[0] <= self.modulus(curve) <= self.modulus_limits[1])

    def verdict(self):
        """All curves keep the limits if the least and the greatest do, as each limit is of a value that rises or falls with them. Some
        curve keeps them if there is one at the sieves, and the moduli of those meet the limits: between the moduli of the least
        and the greatest of these curves each is that of a mean of the two."""
        if self.keeps(self.reported.least) and self.keeps(self.reported.most):
            return "pass"
        if not self.within.exist:
            return "fail"
        if self.modulus_limits:
            low, high = self.modulus(self.within.most), self.modulus(self.within.least)
            if high < self.modulus_limits[0] or self.modulus_limits[1] < low:
                return "fail"
        return "hangs"


def check_row(folder, where, row):
    question = Question(folder, row["report"], row["specification"], row["options"])
    verdict = question.verdict()
    demand(row["verdict"] == verdict, f"{where}: the verdict is {row['verdict']} and not {verdict}")
    for side in ("within", "outside"):
        curve = [Fraction(percent) for percent in row[side].split()]
        if verdict != "hangs":
            demand(curve == [], f"{where}: there is no curve to be shown {side}")
            continue
        demand(len(curve) == len(question.sizes) and question.reported.hold(curve), f"{where}: the curve {side} does not round to the report")
        demand(question.keeps(curve) == (side == "within"), f"{where}: the curve {side} is not {side} the limits")


def main():
    folder, name, failed = pathlib.Path(__file__).resolve().parent, "judgements.answers.csv", False
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
        print(f"judgements: {error}", file=sys.stderr)
        return 2
    if not failed:
        print(f"judgements: {len(rows)} right")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
