#!/usr/bin/python3
"""check.py [BATCH]: verifies the answers to problems of blends from definitions, with Python's standard library alone.

BATCH is published or drawn; both without it. That a blend keeps all limits and has its value is verified of each. Of up to four
stockpiles all blends in steps are tried: none is better, or there is none. Exits with 1 if an answer is wrong, and with 2 if
a file cannot be read. Certificates are not read: mdm-check does that.
"""

import csv
import json
import math
import pathlib
import sys
from fractions import Fraction

MOST_STOCKPILES = 4
MODULI = {"FM": "0.15 0.3 0.6 1.18 2.36 4.75 9.5 19 37.5 75 150".split(), "FM-EN": "0.125 0.25 0.5 1 2 4".split()}


class Wrong(Exception):
    """What is wrong with an answer, and where it stands."""


def demand(condition, what, error=Wrong):
    if not condition:
        raise error(what)


def modulus(name, sieves, passing):
    """The sum of the shares retained on its sieves; one above all sieves of the problem retains nothing."""
    at, largest = dict(zip(sieves, passing)), max(sieves)
    demand(at[largest] == 100, "a stockpile is not known to pass the largest sieve", ValueError)
    return sum(1 - (100 if size > largest else at[size]) / Fraction(100) for size in map(Fraction, MODULI[name]))


class Problem:
    """Values that a blend has the mean of: what passes each sieve, moduli, and the cost; and what is asked of them."""

    def __init__(self, read):
        self.steps, self.aim, stockpiles, sieves = int(read["steps"]), read["aim"], read["stockpiles"], read["sieves"]
        demand(self.aim in ("none", "cost", "deviation", "max-deviation"), "another aim", ValueError)
        sizes, self.k = [Fraction(sieve["size"]) for sieve in sieves], len(stockpiles)
        demand(sizes == sorted(set(sizes)), "sieves do not ascend", ValueError)
        self.values = [[Fraction(percent) for percent in stockpile["passing"]] for stockpile in stockpiles]
        demand(all(len(curve) == len(sizes) and curve == sorted(curve) and 0 <= curve[0] <= curve[-1] <= 100 for curve in self.values),
               "no curve of a stockpile", ValueError)
        self.least, self.most = ([Fraction(sieve.get(end, none)) for sieve in sieves] for end, none in (("least", 0), ("most", 100)))
        for place, limit in enumerate(read.get("moduli", ())):
            for stockpile, curve in zip(stockpiles, self.values):
                told, own = Fraction(stockpile["moduli"][place]), modulus(limit["name"], sizes, curve[:len(sizes)])
                demand(told == own, f"{limit['name']} of {stockpile['name']} is {own}", ValueError)
                curve.append(own)
            self.least.append(Fraction(limit["least"]))
            self.most.append(Fraction(limit["most"]))
        self.targets = [Fraction(sieve["target"]) for sieve in sieves] if "deviation" in self.aim else []
        self.costs = [Fraction(stockpile["cost"]) for stockpile in stockpiles] if self.aim == "cost" else []
        ends = [[Fraction(stockpile.get(end, none)) for stockpile in stockpiles] for end, none in (("least", 0), ("most", 1))]
        self.shares = [(math.ceil(lo * self.steps), math.floor(hi * self.steps)) for lo, hi in zip(*ends)]
        self.at_most = int(read.get("at_most", self.k))

    def keeps(self, counts):
        """Whether these steps of each stockpile are a blend within all limits."""
        mixed = self.mixed(counts)
        return (sum(counts) == self.steps and sum(n > 0 for n in counts) <= self.at_most
                and all(lo <= n <= hi for n, (lo, hi) in zip(counts, self.shares))
                and all(lo <= value <= hi for value, lo, hi in zip(mixed, self.least, self.most)))

    def mixed(self, counts):
        return [sum(n * curve[s] for n, curve in zip(counts, self.values)) / Fraction(self.steps) for s in range(len(self.least))]

    def value(self, counts):
        """What a blend is to have least of."""
        if self.aim == "cost":
            return sum(n * cost for n, cost in zip(counts, self.costs)) / self.steps
        off = [abs(value - target) for value, target in zip(self.mixed(counts), self.targets)]
        return {"none": 0, "deviation": sum(off), "max-deviation": max(off, default=0)}[self.aim]

    def best(self):
        """The best blend, of equally good ones that with the smaller share of the first stockpile, then of the second, and so
        on; or None. All are tried, in integers, in this order; what no blend of the rest brings within the limits is left out."""
        scale = math.lcm(*(number.denominator for row in (*self.values, self.least, self.most, self.targets, self.costs) for number in row))
        values = [[int(number * scale) for number in curve] for curve in self.values]
        least, most, targets = ([int(number * scale) * self.steps for number in row] for row in (self.least, self.most, self.targets))
        costs, columns = [int(cost * scale) for cost in self.costs], range(len(least))
        lows, highs = ([[end(curve[s] for curve in values[i:]) for s in columns] for i in range(self.k)] for end in (min, max))
        found, found_value = None, None

        def search(i, rest, counts, sums):
            nonlocal found, found_value
            if any(a + rest * high < lo or a + rest * low > hi for a, low, high, lo, hi in zip(sums, lows[i], highs[i], least, most)):
                return
            lo, hi = self.shares[i]
            if i < self.k - 1:
                for n in range(lo, min(hi, rest) + 1):
                    search(i + 1, rest - n, (*counts, n), [a + n * b for a, b in zip(sums, values[i])])
            elif lo <= rest <= hi and sum(n > 0 for n in (*counts, rest)) <= self.at_most:
                blend = (*counts, rest)
                off = [abs(a + rest * b - t) for a, b, t in zip(sums, values[i], targets)]
                value = sum(off) if self.aim == "deviation" else max(off) if off else sum(n * c for n, c in zip(blend, costs))
                if found is None or value < found_value:
                    found, found_value = blend, value

        search(0, self.steps, (), [0] * len(least))
        return found


def check(where, problem, answer):
    """Verifies an answer, and returns whether it is shown to be the best."""
    counts = None
    if answer["status"] == "none":
        demand("shares" not in answer and "value" not in answer, f"{where}: there is none, and it has one")
    else:
        demand(answer["status"] == "optimal", f"{where}: its status is {answer['status']}")
        counts = tuple(Fraction(share) * problem.steps for share in answer["shares"])
        demand(len(counts) == problem.k and all(n.denominator == 1 for n in counts), f"{where}: {answer['shares']} are no steps")
        demand(problem.keeps(counts), f"{where}: {answer['shares']} do not keep the limits")
        demand(problem.value(counts) == Fraction(answer["value"]), f"{where}: the value is {problem.value(counts)}")
    if problem.k > MOST_STOCKPILES:
        return False
    best = problem.best()
    demand(best == counts, f"{where}: the best blend has the steps {best}")
    return True


def check_files(folder, read):
    """The files of a published problem have its numbers."""
    def column(name, place):
        rows = csv.reader((folder / read["id"] / name).read_text(encoding="utf-8").splitlines()[2:])
        return [Fraction(row[place]) for row in rows]
    sieves, first = read["sieves"], f"{read['id']}: its files have other"
    expected = [("limits.csv", 1, [sieve.get("least", 0) for sieve in sieves]), ("limits.csv", 2, [sieve.get("most", 100) for sieve in sieves])]
    expected += [(stockpile["name"] + ".csv", 1, stockpile["passing"]) for stockpile in read["stockpiles"]]
    expected += [("target.csv", 1, [sieve["target"] for sieve in sieves])] if "deviation" in read["aim"] else []
    for name, place, numbers in expected:
        demand(column(name, 0) == [Fraction(sieve["size"]) for sieve in sieves], f"{first} sieves: {name}")
        demand(column(name, place) == [Fraction(number) for number in numbers], f"{first} numbers: {name}")


def check_batch(folder, name):
    problems, answers = ([json.loads(line, parse_float=Fraction) for line in (folder / f"{name}{ending}").read_text(encoding="utf-8").splitlines()]
                         for ending in (".jsonl", ".answers.jsonl"))
    demand([problem["id"] for problem in problems] == [answer["id"] for answer in answers], f"{name}: answers to other problems")
    shown = 0
    for number, (read, answer) in enumerate(zip(problems, answers), 1):
        shown += check(f"{name}.answers.jsonl:{number}", Problem(read), answer)
        if name == "published":
            check_files(folder, read)
    rest = len(answers) - shown
    return f"{len(answers)} right" + f"; {rest} of them not shown to be the best (more than {MOST_STOCKPILES} stockpiles)" * (rest > 0)


def main():
    folder, name, failed = pathlib.Path(__file__).resolve().parent, "blends", False
    try:
        for name in sys.argv[1:] or ("published", "drawn"):
            try:
                print(f"blends/{name}: {check_batch(folder, name)}", flush=True)
            except Wrong as wrong:
                failed = True
                print(f"FAILED: blends/{wrong}")
    except Exception as error:  # what cannot be read has many forms
        print(f"blends/{name}: {error}", file=sys.stderr)
        return 2
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
