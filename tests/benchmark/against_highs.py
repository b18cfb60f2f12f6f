#!/usr/bin/python3
"""Smallest matches within 1 % retained: mdm and HiGHS (scipy.optimize.milp) on a sample of the suite, in one run.

    tests/benchmark/against_highs.py build/release/bin/mdm [NUMBER]
    tests/benchmark/against_highs.py build/release/bin/mdm --curves [SECONDS]

With --curves: mdm, HiGHS and z3 on 20 questions on the curves of windows.py, with so many seconds each (60).

Times are CPU times. An answer of HiGHS is judged in fractions: is there any sample with its quantities within the
tolerance (theory: the sample's mass M lies in an interval), and is it as small as the proved minimum?
Needs python3-scipy 1.9 or later.
"""
import json
import math
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

import windows

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


CURVES = [(kind, 30, tolerance) for tolerance in ("retained:1%", "passing:1%", "total:5%", "laboratory") for kind in windows.KINDS]
CURVES += [(kind, 100, "passing:1%") for kind in windows.KINDS]


class CurveQuestion:
    """A curve within a tolerance as linear conditions on counts q_j, masses t_j and excesses p_j of shares: terms and a bound,
    terms >= bound. The mass is at least 1: that of a particle of the coarsest class which, with those above, has to have one."""

    def __init__(self, text, tolerance):
        rows = [line.split(",") for line in text.split()[1:]]
        sizes = [Fraction(x) for x, _ in rows]
        masses = [Fraction(m) for _, m in rows[:-1]]
        k = self.k = len(masses)
        share = [m / sum(masses) for m in masses]
        passing = [sum(share[: j + 1]) for j in range(k)]
        kind, _, percent = tolerance.rstrip("%").partition(":")
        widths = [Fraction(percent) / 100 if percent else self.laboratory(x) for x in passing]
        if kind == "retained":
            needed = [share[j] > widths[j] for j in range(k)]
        elif kind == "total":
            needed = [1 - passing[j] + share[j] > widths[j] / 2 for j in range(k)]
        else:
            needed = [j == 0 or passing[j - 1] + widths[j - 1] < 1 for j in range(k)]
        unit = max(x for x, of in zip(sizes, needed) if of)
        F = [(x / unit) ** 3 for x in sizes[1:]]
        self.f = [(x / unit) ** 3 for x in sizes[:-1]]
        self.rows = [({("q", j): 1 for j in range(k)}, 1), ({("t", j): 1 for j in range(k)}, 1)]
        for j in range(k):
            self.rows.append(({("t", j): 1 / F[j], ("q", j): -self.f[j] / F[j]}, 0))
            self.rows.append(({("t", j): -1 / F[j], ("q", j): 1}, 0))
        if kind == "total":
            for j in range(k):
                self.add_share([j], share[j], -1, ("p", j))
            self.rows.append(({**{("t", j): widths[0] / 2 for j in range(k)}, **{("p", j): -1 for j in range(k)}}, 0))
            return
        for j in range(k - (kind != "retained")):
            middle, of = (share[j], [j]) if kind == "retained" else (passing[j], range(j + 1))
            self.add_share(of, max(Fraction(0), middle - widths[j]), 1)
            self.add_share(of, min(Fraction(1), middle + widths[j]), -1)

    @staticmethod
    def laboratory(passing):
        """0.05 sqrt(X (100 - X)) percent, rounded up to 6 digits."""
        x = passing * 100
        square = int(x * (100 - x) * Fraction(25, 10000) * 10**12)
        root = math.isqrt(square)
        return Fraction(root + (root * root < square), 10**8)

    def add_share(self, of, share, sign, excess=None):
        """sign (sum of t in `of` - share M) >= 0, plus an excess."""
        terms = {("t", j): sign * ((j in of) - share) for j in range(self.k)}
        self.rows.append(({**terms, **({excess: 1} if excess else {})}, 0))


def highs_on_curve(question, seconds):
    """What HiGHS says: particles and whether it calls them the fewest."""
    k = question.k
    place = {name: i for i, name in enumerate((kind, j) for kind in "qtp" for j in range(k))}
    rows = numpy.zeros((len(question.rows), 3 * k))
    for row, (terms, _) in zip(rows, question.rows):
        for name, value in terms.items():
            row[place[name]] = float(value)
    result = milp(
        c=numpy.repeat([1.0, 0.0, 0.0], k),
        constraints=LinearConstraint(rows, [float(bound) for _, bound in question.rows], numpy.inf),
        integrality=numpy.repeat([1, 0, 0], k),
        bounds=Bounds(0, numpy.inf),
        options={"time_limit": seconds, "mip_rel_gap": 0},
    )
    return (None if result.x is None else int(round(sum(result.x[:k]))), result.status == 0)


def z3_on_curve(question, seconds):
    """What z3 says in exact arithmetic, where q >= 1 particles weigh more than q f: the same."""
    lines = []

    def number(value):
        value = Fraction(value)
        text = f"(/ {abs(value.numerator)}.0 {value.denominator}.0)"
        return f"(- {text})" if value < 0 else text

    names = sorted({name for terms, _ in question.rows for name in terms})
    for kind, j in names:
        lines.append(f"(declare-const {kind}{j} {'Int' if kind == 'q' else 'Real'}) (assert (>= {kind}{j} 0))")
    real = {name: f"(to_real {name[0]}{name[1]})" if name[0] == "q" else f"{name[0]}{name[1]}" for name in names}
    for terms, bound in question.rows:
        sum_of = " ".join(f"(* {number(value)} {real[name]})" for name, value in terms.items())
        lines.append(f"(assert (>= (+ 0.0 {sum_of}) {number(bound)}))")
    for j, f in enumerate(question.f):
        lines.append(f"(assert (or (= q{j} 0) (> t{j} (* {number(f)} (to_real q{j})))))")
    lines.append(f"(minimize (+ {' '.join(f'q{j}' for j in range(question.k))})) (check-sat) (get-objectives)")
    out = subprocess.run(["z3", f"-T:{seconds}", "-in"], input="\n".join(lines), capture_output=True, text=True).stdout
    words = out.replace("(", " ").replace(")", " ").split()
    return (int(words[-1]) if words and words[0] == "sat" and words[-1].isdigit() else None, words[:1] == ["sat"])


def cpu_of_children():
    return sum(os.times()[2:4])


def on_curves(program, seconds):
    print("| curve | mdm | s | HiGHS | s | z3 | s |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "curve.csv")
        for kind, classes, tolerance in CURVES:
            text = windows.curve(kind, classes)
            path.write_text(text)
            start = cpu_of_children()
            command = [program, "solve", path, "--tolerance", tolerance, "--time-limit", str(seconds), "--format", "json", "--quiet"]
            answer = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)
            cells = [f"{kind}, {classes}, {tolerance.replace(':', ' ').replace('%', ' %')}"]
            proved = answer["status"] == "optimal"
            cells += [("" if proved else "<= ") + f"{int(answer['particles']):,}", f"{cpu_of_children() - start:.2f}"]
            question = CurveQuestion(text, tolerance)
            for solver in highs_on_curve, z3_on_curve:
                start = cpu_of_children() + time.process_time()
                found, is_fewest = solver(question, seconds)
                used = cpu_of_children() + time.process_time() - start
                says = "-" if found is None else ("" if is_fewest else "<= ") + f"{found:,}"
                cells += [says, f"{used:.1f}"]
            print("| " + " | ".join(cells) + " |", flush=True)


def quantile(values, part):
    return sorted(values)[int(part * (len(values) - 1))]


def median(values):
    return quantile(values, 0.5)


def quartiles(values):
    return "25 %% %.3g, median %.3g, 75 %% %.3g, maximum %.3g" % tuple(quantile(values, part) for part in (0.25, 0.5, 0.75, 1))


def main():
    if sys.argv[2:3] == ["--curves"]:
        return on_curves(sys.argv[1], int(sys.argv[3]) if len(sys.argv) > 3 else TIME_LIMIT)
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
