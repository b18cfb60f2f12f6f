#!/usr/bin/python3
"""Smallest matches within 1 % retained: mdm and HiGHS (scipy.optimize.milp) on a sample of the suite, in one run.

    tests/benchmark/against_highs.py build/release/bin/mdm [NUMBER]

Times are CPU times. An answer of HiGHS is judged in fractions: is there any sample with its quantities within the
tolerance (theory: the sample's mass M lies in an interval), and is it as small as the proved minimum?
Needs python3-scipy 1.9 or later.
"""
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from fractions import Fraction
from pathlib import Path

import numpy
from scipy.optimize import Bounds, LinearConstraint, milp

SUITE = Path(__file__).parents[2] / "examples/reference/average/suite-2750.jsonl"
TOLERANCE = Fraction(1, 100)
TIME_LIMIT = 60


class Problem:
    """Class bounds f, F (masses of one particle) and bounds on shares lo, hi, ascending by size."""

    def __init__(self, line):
        g = json.loads(line)
        rows = sorted(zip(map(Fraction, g["sizes"]), map(Fraction, g["masses"])))
        sizes = [x for x, _ in rows]
        masses = [m for _, m in rows[:-1]]
        self.f = [x**3 for x in sizes[:-1]]
        self.F = [x**3 for x in sizes[1:]]
        shares = [m / sum(masses) for m in masses]
        self.lo = [max(Fraction(0), g - TOLERANCE) for g in shares]
        self.hi = [min(Fraction(1), g + TOLERANCE) for g in shares]


def highs(problem):
    """Quantities by mixed integer programming, masses in units of the coarsest particle; None where it fails."""
    k = len(problem.f)
    unit = problem.F[-1]
    f = numpy.array([float(x / unit) for x in problem.f])
    F = numpy.array([float(x / unit) for x in problem.F])
    one = numpy.eye(k)
    all_mass = numpy.ones((k, k))
    lo = numpy.array([[float(x)] for x in problem.lo])
    hi = numpy.array([[float(x)] for x in problem.hi])
    rows = numpy.vstack(
        [
            numpy.hstack([-numpy.diag(f), one]),  # t - f q >= 0
            numpy.hstack([numpy.diag(F), -one]),  # F q - t >= 0
            numpy.hstack([0 * one, one - lo * all_mass]),  # t - lo M >= 0
            numpy.hstack([0 * one, hi * all_mass - one]),  # hi M - t >= 0
            numpy.hstack([numpy.ones((1, k)), numpy.zeros((1, k))]),  # at least one particle
        ]
    )
    least = numpy.concatenate([numpy.zeros(4 * k), [1]])
    result = milp(
        c=numpy.concatenate([numpy.ones(k), numpy.zeros(k)]),
        constraints=LinearConstraint(rows, least, numpy.inf),
        integrality=numpy.concatenate([numpy.ones(k), numpy.zeros(k)]),
        bounds=Bounds(0, numpy.inf),
        options={"time_limit": TIME_LIMIT, "mip_rel_gap": 0},
    )
    return None if result.x is None else [int(round(q)) for q in result.x[:k]]


def is_match(p, q):
    """True if some masses t_j of q_j particles are within the tolerance: sum of the least <= M <= sum of the greatest,
    each t_j in (f q, F q] and [lo M, hi M]. Both sums are piecewise linear in M: their kinks, the points where they
    meet M, and the middles between all of these decide."""
    if sum(q) < 1:
        return False

    def holds(M):
        least = most = Fraction(0)
        strict = False
        for f, F, lo, hi, n in zip(p.f, p.F, p.lo, p.hi, q):
            a, b = max(n * f, lo * M), min(n * F, hi * M)
            is_open = n > 0 and n * f >= lo * M
            if a > b or (is_open and a == b):
                return False
            least, most, strict = least + a, most + b, strict or is_open
        return least <= M <= most and not (strict and least == M)

    def sums(M):
        return (
            sum(max(n * f, lo * M) for f, lo, n in zip(p.f, p.lo, q)) - M,
            sum(min(n * F, hi * M) for F, hi, n in zip(p.F, p.hi, q)) - M,
        )

    kinks = {Fraction(0)}
    for f, F, lo, hi, n in zip(p.f, p.F, p.lo, p.hi, q):
        kinks |= {mass / share for mass in (n * f, n * F) for share in (lo, hi) if share > 0}
    kinks = sorted(kinks)
    points = set(kinks)
    for a, b in zip(kinks, kinks[1:]):
        for x, y in zip(sums(a), sums(b)):
            if x != y and 0 < x / (x - y) < 1:
                points.add(a + (b - a) * x / (x - y))
    points = sorted(points)
    middles = [(a + b) / 2 for a, b in zip(points, points[1:])]
    return any(M > 0 and holds(M) for M in points + middles)


def quantile(values, part):
    return sorted(values)[int(part * (len(values) - 1))]


def median(values):
    return quantile(values, 0.5)


def quartiles(values):
    return "25 %% %.3g, median %.3g, 75 %% %.3g, maximum %.3g" % tuple(quantile(values, part) for part in (0.25, 0.5, 0.75, 1))


def main():
    program, number = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    lines = random.Random(1).sample(SUITE.read_text().splitlines(), number)
    ours, mdm_ms, highs_ms, ratios = [], [], [], []
    failed = no_match = not_minimal = 0
    with tempfile.TemporaryDirectory() as folder:
        for line in lines:
            path = Path(folder, "gradation.json")
            path.write_text(line)
            # Fifty times one gradation, without the cost of starting the program.
            batch = Path(folder, "batch.jsonl")
            costs = []
            for times in (0, 50):
                batch.write_text((line + "\n") * times)
                before = os.times()
                out = subprocess.run(
                    [program, "batch", str(batch), "-j", "1", "--tolerance", "retained:1%"],
                    capture_output=True,
                    text=True,
                    check=True,
                ).stdout
                after = os.times()
                costs.append(sum(after[2:4]) - sum(before[2:4]))
            mdm_ms.append(max(0.1, (costs[1] - costs[0]) * 20))
            minimum = int(json.loads(out.splitlines()[0])["particles"])
            problem = Problem(line)
            start = time.process_time()
            q = highs(problem)
            highs_ms.append((time.process_time() - start) * 1000)
            if q is None:
                failed += 1
            elif not is_match(problem, q):
                no_match += 1
            elif sum(q) != minimum:
                not_minimal += 1
    print(f"{number} gradations of the suite, retained 1 %")
    print("mdm, ms of CPU:  ", quartiles(mdm_ms))
    print("HiGHS, ms of CPU:", quartiles(highs_ms))
    print("HiGHS / mdm: %.3g in sum, %.3g in the median" % (sum(highs_ms) / sum(mdm_ms), median(highs_ms) / median(mdm_ms)))
    print("HiGHS without an answer:", failed)
    print("HiGHS with quantities that no sample within the tolerance has:", no_match)
    print("HiGHS with a match that is not the smallest:", not_minimal)


if __name__ == "__main__":
    main()
