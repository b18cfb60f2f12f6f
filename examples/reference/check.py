#!/usr/bin/python3
"""check.py [BATCH...]: verifies the answers of the reference set from definitions, with Python's standard library alone.

A sweep finds each exact match again. Within a tolerance the tree in the proof of an answer is verified. Batches are those
of batches.csv; without a name, all of them. Exits with 1 if an answer is wrong, and with 2 if a file cannot be read.
"""

import csv
import json
import math
import pathlib
import sys
from decimal import ROUND_DOWN, Context, Decimal
from fractions import Fraction
from itertools import accumulate, islice


class Wrong(Exception):
    """What is wrong with an answer, and where it stands."""


def demand(condition, what, error=Wrong):
    if not condition:
        raise error(what)


class Gradation:
    """Openings x of k classes, their masses m and shares, and the bounds f and F of the mass of a particle, which is x^3.
    x, f and F are to the power `root`: 2 where phi are half, so that they are rational."""

    def __init__(self, where, name, x, m, tolerances=(), root=1):
        x, m, self.tolerances = (list(map(Fraction, values)) for values in (x, m, tolerances))
        good = 0 <= x[0] and all(lower < upper for lower, upper in zip(x, x[1:])) and len(m) == len(x)
        demand(good and 0 <= min(m) == m[-1] < max(m), f"{where}: this is no gradation", ValueError)
        self.id, self.k, self.root, self.x, self.m = name, len(x) - 1, root, x, m[:-1]
        self.printed = [Fraction(Context(prec=15).sqrt(Decimal(y.numerator) / y.denominator)) if root == 2 else y for y in x]
        self.shares = [mass / sum(m) for mass in self.m]
        self.f, self.F = [y ** 3 for y in x[:-1]], [y ** 3 for y in x[1:]]


def gradations(folder, name):
    """Those of a file: JSON, one a line; or one as CSV, by whole and half phi."""
    lines = (folder / name).read_text(encoding="utf-8").splitlines()
    if name.endswith(".csv"):
        header, *rows = csv.reader(line for line in lines if not line.startswith("#"))
        demand(header == ["size_phi", "mass"], f"{name}: other columns", ValueError)
        x, m = zip(*sorted((Fraction(2) ** (-2 * Fraction(phi)), Fraction(mass)) for phi, mass in rows))
        return [Gradation(name, pathlib.Path(name).stem, x, m, root=2)]
    found = [json.loads(line, parse_float=Fraction) for line in lines]
    demand(all(read["unit"] == "mm" and "factors" not in read for read in found), f"{name}: not in mm", ValueError)
    return [Gradation(f"{name}:{i}", read["id"], read["sizes"], read["masses"], read.get("tolerances_percent", ()))
            for i, read in enumerate(found, 1)]


class Row:
    """A class in an answer: openings, share, q particles, and their sizes from lo to hi."""

    def __init__(self, where, fields):
        demand(len(fields) == 8, f"{where}: {len(fields)} columns", ValueError)
        self.where, self.fields, self.q = where, fields, int(fields[5])
        self.lower, self.upper, self.share, _, self.lo, self.hi = (Fraction(text or 0) for text in fields[2:])

    def check(self, g, j, share):
        """It is that of class j with this share. Sizes are in the class, and agree to 14 digits."""
        demand(self.fields[:2] == [g.id, str(j + 1)], f"{self.where}: {self.fields[:2]} and not {g.id}, {j + 1}")
        demand([self.lower, self.upper] == g.printed[j:j + 2], f"{self.where}: {self.fields[2:4]} are other openings")
        cut = Context(prec=15, rounding=ROUND_DOWN).divide(*map(Decimal, (100 * share).as_integer_ratio()))
        demand(self.share == Fraction(cut), f"{self.where}: the share is {self.fields[4]} and not {cut}")
        inside = g.x[j] < self.lo ** g.root <= self.hi ** g.root <= g.x[j + 1] and self.hi - self.lo <= self.hi / 10 ** 14
        good = inside if self.q else self.fields[6:] == ["", ""]
        demand(good, f"{self.where}: sizes {self.fields[6:]} are not in the class, or do not agree to 14 digits")


def smallest_match(g, least):
    """The smallest match with `least` particles or more in each class with mass: every match has as many in each class.

    q particles hold the mass s m for scales s above q f / m, up to q F / m. A match has a scale above q f / m of all that
    it needs, and so needs more than s m / F in each class: this is raised until it is enough.
    """
    q, raised = [], [least if m else 0 for m in g.m]
    while q != raised:
        q = raised
        scale = max(n ** g.root * f / m ** g.root for n, f, m in zip(q, g.f, g.m) if m)
        floors = [scale * m ** g.root // F for m, F in zip(g.m, g.F)]
        raised = [max(n, 1 + (math.isqrt(b) if g.root == 2 else b)) if n else 0 for n, b in zip(q, floors)]
    return q


def check_exact(g, rows, least, wanted):
    """No match of `least` particles in each class, `wanted` in all, is smaller. One scale gives all sizes."""
    for j, row in enumerate(rows):
        row.check(g, j, g.shares[j])
    found, total = smallest_match(g, least), sum(row.q for row in rows)
    for row, q in zip(rows, found):
        demand((row.q == q or row.q > q > 0) and total == max(wanted, sum(found)),
               f"{row.where}: quantity {row.q} of {total}, where the smallest match has {q} of {sum(found)}")
    scales = [[(row.q * size ** 3 / m) ** g.root for size in (row.lo, row.hi)] for row, m in zip(rows, g.m) if m]
    low = max(lo for lo, _ in scales)
    for (lo, hi), row in zip(scales, (row for row in rows if row.q)):
        demand(low < hi or low == lo == hi, f"{row.where}: sizes {row.fields[6:]} are of another scale than others")


class Tree:
    """The tree in a proof: no match has fewer than N particles, with bounds on the shares of classes and of all up to them."""

    def __init__(self, g, tolerance, N, lines):
        self.k, self.f, self.F, self.N, self.lines, self.all = g.k, g.f, g.F, N, lines, [(0, 1)] * g.k
        pairs = ((i, j) for j in range(g.k + 1) for i in range(j))
        self.classes = {"": range(g.k), **{str(j) if j == i + 1 else f"{i + 1}-{j}": range(i, j) for i, j in pairs}}
        G, (kind, _, percent) = list(accumulate(g.shares)), tolerance.partition(":")
        shares = {"retained": g.shares, "passing": G, "laboratory": G}[kind]
        errors = g.tolerances if tolerance == "retained:file" else [Fraction(percent.removesuffix("%") or 0)] * g.k
        if kind == "laboratory":  # the least e of six places, and above 0, with e >= 0.05 sqrt(X (100 - X)), X = 100 p
            errors = [Fraction(1 + math.isqrt(max(0, math.ceil(25 * 10 ** 12 * p * (1 - p)) - 1)), 10 ** 6) for p in shares]
        near = [(max(0, p - e / 100), min(1, p + e / 100)) for p, e in zip(shares, errors)]
        self.retained, self.passing = (near, self.all) if kind == "retained" else (self.all, near[:-1] + self.all[:1])

    def holds(self, least, most):
        """Reads a node below splits that bound the counts of classes: whether no smaller match is there."""
        word, *rest = next(self.lines, "end").split(" ")
        if word == "split":
            J, v = self.classes[rest[0]], int(rest[1])
            return self.holds(least, {**most, J: v - 1}) and self.holds({**least, J: v}, most)
        terms = [(int(n), c[0].replace("d", "f"), self.classes[c[1:]]) for n, c in zip(rest[::2], rest[1::2], strict=True)]
        return word == "leaf" and all(n > 0 for n, _, _ in terms) and self.leaf(terms, least, most)

    def leaf(self, terms, least, most):
        """Whether conditions of counts q and masses t, each times a number, add up to 0 > 0 or 0 >= 1."""
        q, t, right, strict = [0] * self.k, [0] * self.k, 0, False
        for n, kind, J in terms:
            n = -n if kind in "FQSNRP" else n
            strict = strict or kind == "m" or kind == "f" and least.get(J, 0) >= 1
            counts, masses, share = [-weight for weight in (self.F if kind == "F" else self.f)], J, 0
            if kind in "qsQSN":  # q >= least, -q >= -most
                counts, masses = [1] * self.k, ()
                right += n * (least.get(J, 0) if kind in "qs" else self.N - 1 if kind == "N" else most[J])
            elif kind not in "fF":  # t - low M >= 0, high M - t >= 0; M > 0. Else t - f q >= 0, F q - t >= 0
                bounds = {"r": self.retained, "p": self.passing, "m": self.all}[kind.lower()]
                masses = range(J.stop - 1 if kind in "rR" else 0, self.k if kind == "m" else J.stop)
                counts, share = [0] * self.k, bounds[J.stop - 1][kind in "RP"]
            q = [value + n * counts[j] * (j in J) for j, value in enumerate(q)]
            t = [value + n * ((j in masses) - share) for j, value in enumerate(t)]
        return not any(q + t) and (right > 0 or right == 0 and strict)


def check_tolerant(g, rows, tolerance, proof):
    """The answer is that of its proof and within the tolerance. No match is smaller, unless the proof has windows."""
    lines, N, t, first = iter(proof.splitlines()), sum(row.q for row in rows), [0] * g.k, rows[0].where
    demand([*islice(lines, 4)][1::2] == ["law 3", f"particles {N}"], f"{first}: {g.id} has {N} particles, its proof not")
    for j, row in ((j, row) for j, row in enumerate(rows) if row.q):
        *names, mass, lo, hi = next(lines, "").split(" ")
        demand(names + [lo, hi] == ["class", str(j + 1), *row.fields[5:]], f"{row.where}: this is not in the proof")
        t[j], lo, hi = Fraction(mass), row.q * row.lo ** 3, row.q * row.hi ** 3
        demand(lo <= t[j] < hi or lo == t[j] == hi, f"{row.where}: the proof has another mass of these sizes: {mass}")
    tree, P = Tree(g, tolerance, N, lines), list(accumulate(t))
    for j, row in enumerate(rows):
        row.check(g, j, t[j] / P[-1])
        for mass, (low, high) in ((t[j], tree.retained[j]), (P[j], tree.passing[j])):
            demand(low <= mass / P[-1] <= high, f"{row.where}: the share {row.fields[4]} is not within the tolerance")
    demand("\nwindow" in proof or tree.holds({}, {}) and not [*lines], f"{first}: the proof for {g.id} has a gap")


def check(folder, batch, file, count, options):
    """Verifies the answers of a batch, and returns what they are."""
    words, name = iter(options.split()), f"{batch}.answers.csv"
    tolerance, wanted, least = {"--tolerance": "", "--at-least": 1, "--min-per-class": 1, **dict(zip(words, words))}.values()
    header, *rows = csv.reader((folder / name).read_text(encoding="utf-8").splitlines())
    columns = f"id,class,lower_mm,upper_mm,{'match_' * bool(tolerance)}share_percent,quantity,size_lo_mm,size_hi_mm"
    demand(header == columns.split(","), f"{name}: the columns are not {columns}")
    found, rows = gradations(folder, file), [Row(f"{name}:{i}", fields) for i, fields in enumerate(rows, 2)]
    demand(len(rows) == sum(g.k for g in found), f"{name}: {len(rows)} classes, and not as many as in {file}")
    proofs = (folder / f"{batch}.proofs").read_text(encoding="utf-8").split("end\n") if tolerance else [""] * (len(found) + 1)
    demand(len(proofs) - 1 == len(found) == int(count) and proofs[-1] == "", f"{batch}: not {count} gradations and proofs")
    for g, proof in zip(found, proofs):
        own, rows = rows[:g.k], rows[g.k:]
        check_tolerant(g, own, tolerance, proof) if tolerance else check_exact(g, own, int(least), int(wanted))
    windows = sum("\nwindow" in proof for proof in proofs)
    return f"{len(found)} right" + f"; {windows} of them not shown to be the smallest (windows)" * (windows > 0)


def main():
    name, failed, folder = "batches.csv", False, pathlib.Path(__file__).resolve().parent
    try:
        rows = csv.reader((folder / name).read_text(encoding="utf-8").splitlines())
        batches = {row[0]: row for row in islice(rows, 1, None)}
        for name in sys.argv[1:] or batches:
            demand(name in batches, "batches.csv has no such batch", ValueError)
            try:
                print(f"{name}: {check(folder, *batches[name])}", flush=True)
            except Wrong as wrong:
                failed = True
                print(f"FAILED: {wrong}")
    except Exception as error:  # what cannot be read has many forms
        print(f"{name}: {error}", file=sys.stderr)
        return 2
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
