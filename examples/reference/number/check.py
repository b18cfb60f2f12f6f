#!/usr/bin/python3
"""check.py: verifies number.answers.csv from definitions, with Python's standard library alone.

Each answer is a set that has the shares by number, exactly or within the tolerance; and of each smaller number of particles,
from 1 on, it is found that no set has. Exits with 1 if an answer is wrong, and with 2 if a file cannot be read.
Certificates are not read: mdm-check does that.
"""

import csv
import math
import pathlib
import sys
from fractions import Fraction
from itertools import accumulate


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


def shares_by_number(path):
    """The share of each class, from the finest up: of a row and what is above it, or of what is below the next row."""
    (size, kind), rows = table(path)
    x, percents = zip(*(map(Fraction, row) for row in rows))
    ascends = all(lower < upper for lower, upper in zip(x, x[1:]))
    demand(size.startswith("size_") and ascends and min(percents) >= 0, f"{path.name}: this is no gradation", ValueError)
    if kind == "cumulative_number_percent":
        demand(percents[0] == 0 and percents[-1] == 100 and list(percents) == sorted(percents), f"{path.name}: no shares", ValueError)
        percents = [above - below for below, above in zip(percents, percents[1:])] + [0]
    else:
        demand(kind == "number_percent" and percents[-1] == 0 < sum(percents), f"{path.name}: no shares", ValueError)
    return [Fraction(percent) / sum(percents) for percent in percents[:-1]]


def tolerances(options):
    """The errors that are allowed, by kind, as shares; none in a class without any."""
    words = options.split()
    demand(set(words[::2]) <= {"--tolerance"}, f"{options} is another question", ValueError)
    found = dict(word.split(":") for word in words[1::2]) or {"retained": "0%"}
    demand(set(found) <= {"retained", "passing", "total"} and 2 * len(found) >= len(words), f"{options} is another question", ValueError)
    return {kind: Fraction(percent.removesuffix("%")) / 100 for kind, percent in found.items()}


def is_within(shares, allowed, quantities):
    """By definition: the shares of a set, and what is smaller than each opening, are that near; bounds are closed."""
    n = sum(quantities)
    off = [Fraction(q, n) - share for q, share in zip(quantities, shares)]
    errors = {"retained": max(map(abs, off)), "passing": max(map(abs, accumulate(off))), "total": sum(map(abs, off))}
    return all(errors[kind] <= most for kind, most in allowed.items())


def exists(shares, allowed, n):
    """Whether a set of n particles is within: the numbers that classes from the finest up can have together are all integers
    from `low` to `high`; the least total has each class rounded down, and those with the largest remainders up."""
    if "total" in allowed:
        remainders = sorted(n * share - n * share // 1 for share in shares)
        ups = int(sum(remainders))
        return sum(remainders[:len(shares) - ups]) + sum(1 - r for r in remainders[len(shares) - ups:]) <= n * allowed["total"]
    low = high = 0
    each, above, G = allowed.get("retained", 1), allowed.get("passing", 1), 0
    for share in shares:
        G += share
        least, most = max(0, math.ceil(n * (share - each))), math.floor(n * (share + each))
        if least > most:
            return False
        low, high = max(low + least, math.ceil(n * (G - above))), min(high + most, math.floor(n * (G + above)), n)
        if low > high:
            return False
    return high == n


def check_row(folder, where, row):
    shares, allowed = shares_by_number(folder / row["gradation"]), tolerances(row["options"])
    quantities, n = [int(q) for q in row["quantities"].split()], int(row["particles"])
    demand(len(quantities) == len(shares), f"{where}: {len(quantities)} quantities of {len(shares)} classes")
    demand(min(quantities) >= 0 and sum(quantities) == n > 0, f"{where}: the quantities do not sum to {n}")
    demand(is_within(shares, allowed, quantities), f"{where}: the shares of this set are others: {row['quantities']}")
    exact = all(most == 0 for most in allowed.values())  # then n shares are integers, which is sooner tried
    for fewer in range(1, n):
        found = all(fewer * share.numerator % share.denominator == 0 for share in shares) if exact else exists(shares, allowed, fewer)
        demand(not found, f"{where}: {fewer} particles are enough, and not {n} needed")


def main():
    folder, name, failed = pathlib.Path(__file__).resolve().parent, "number.answers.csv", False
    try:
        header, rows = table(folder / name)
        asked = table(folder / "number.csv")[1]
        demand(header == ["id", "gradation", "options", "particles", "quantities"], f"{name}: other columns", ValueError)
        demand([row[:3] for row in rows] == asked, f"{name}: other questions than those of number.csv", ValueError)
        for number, row in enumerate(rows, 2):
            try:
                check_row(folder, f"{name}:{number}", dict(zip(header, row)))
            except Wrong as wrong:
                failed = True
                print(f"FAILED: {wrong}")
    except Exception as error:  # what cannot be read has many forms
        print(f"number: {error}", file=sys.stderr)
        return 2
    if not failed:
        print(f"number: {len(rows)} right")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
