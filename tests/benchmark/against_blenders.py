#!/usr/bin/python3
"""The best blends in whole percents: mdm, and HiGHS (scipy.optimize), as a linear program that is rounded and with integers.

    tests/benchmark/against_blenders.py build/release/bin/mdm [NUMBER]

NUMBER problems (200) of 2 to 8 stockpiles, 10 sieves with limits about a mix that keeps them, and costs, or a target that
is to be missed least in sum. Times are CPU times, of mdm those of a process each. What HiGHS answers is judged in fractions: does
it keep all limits, and is its value the proved one? Needs python3-scipy 1.9 or later.
"""
import json
import random
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from fractions import Fraction
from pathlib import Path

import numpy
from scipy.optimize import Bounds, LinearConstraint, linprog, milp

SIZES = ("0.075", "0.15", "0.3", "0.6", "1.18", "2.36", "4.75", "9.5", "12.5", "19")
STEPS = 100


def drawn(draw, number):
    """Percents of one decimal, limits in whole percents on either side of a mix, as sheets and specifications have them."""
    k = 2 + number % 7
    curves = [sorted(Fraction(draw.randrange(0, 1001), 10) for _ in SIZES[1:]) + [Fraction(100)] for _ in range(k)]
    cuts = sorted(draw.randrange(0, STEPS + 1) for _ in range(k - 1))
    mix = [Fraction(b - a, STEPS) for a, b in zip([0, *cuts], [*cuts, STEPS])]
    limits = []
    for s in range(len(SIZES)):
        passing = sum(x * curve[s] for x, curve in zip(mix, curves))
        room = draw.choice((0, 1, 2, 5))
        limits.append((max(0, passing // 1 - room), min(100, -(-passing // 1) + room)))
    problem = {"curves": curves, "limits": limits}
    if number % 2:
        problem["costs"] = [Fraction(draw.randrange(400, 2000), 100) for _ in range(k)]
    else:
        problem["target"] = [Fraction(a + b, 2) for a, b in limits]
    return problem


def decimal(number):
    return f"{float(number):.10g}"


def line_of(problem):
    """As mdm blend --problems takes it."""
    costs = problem.get("costs", [Fraction(0)] * len(problem["curves"]))
    targets = problem.get("target", [None] * len(SIZES))
    return json.dumps({
        "stockpiles": [{"name": f"S{i}", "passing": [*map(decimal, curve)], "cost": decimal(cost)}
                       for i, (curve, cost) in enumerate(zip(problem["curves"], costs))],
        "sieves": [{"size": size, "least": str(a), "most": str(b), **({"target": decimal(t)} if t is not None else {})}
                   for size, (a, b), t in zip(SIZES, problem["limits"], targets)],
        "steps": str(STEPS), "aim": "cost" if "costs" in problem else "deviation"}) + "\n"


def value(problem, counts):
    """That of counts of sum STEPS, or None where they break a limit."""
    value = Fraction(0)
    for s, (a, b) in enumerate(problem["limits"]):
        passing = sum(n * curve[s] for n, curve in zip(counts, problem["curves"])) / STEPS
        if not a <= passing <= b:
            return None
        if "target" in problem:
            value += abs(passing - problem["target"][s])
    if "costs" in problem:
        value = sum(n * cost for n, cost in zip(counts, problem["costs"])) / STEPS
    return value


def of_mdm(program, problems):
    """The counts and the value of each best blend, and the CPU time of the run."""
    with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as file:
        file.writelines(map(line_of, problems))
        file.flush()
        begin = children()
        run = subprocess.run([program, "blend", "--problems", file.name], check=True, capture_output=True, text=True)
        took = children() - begin
    best = [json.loads(line)["blends"][0] for line in run.stdout.splitlines()]
    return [([int(Fraction(share) * STEPS) for share in b["shares"]], Fraction(b["value"])) for b in best], took


def rows_of(problem):
    """Objective, matrix and bounds of the rows; variables are shares, and a deviation a sieve where there is a target."""
    passing = numpy.array([[float(curve[s]) for curve in problem["curves"]] for s in range(len(SIZES))])
    n, k = passing.shape
    least, most = ([float(end[i]) for end in problem["limits"]] for i in (0, 1))
    if "costs" in problem:
        return (numpy.array([float(c) for c in problem["costs"]]), numpy.vstack([numpy.ones((1, k)), passing]),
                [1, *least], [1, *most])
    target = [float(t) for t in problem["target"]]
    zero, one = numpy.zeros((n, n)), numpy.eye(n)
    rows = numpy.vstack([numpy.hstack([numpy.ones((1, k)), numpy.zeros((1, n))]), numpy.hstack([passing, zero]),
                         numpy.hstack([passing, one]), numpy.hstack([passing, -one])])
    infinite = [numpy.inf] * n
    return (numpy.concatenate([numpy.zeros(k), numpy.ones(n)]), rows, [1, *least, *target, *[-i for i in infinite]],
            [1, *most, *infinite, *target])


def rounded(shares):
    """Counts of sum STEPS by largest remainders."""
    exact = [max(0, STEPS * x) for x in shares]
    counts = [int(x) for x in exact]
    for i in sorted(range(len(exact)), key=lambda i: counts[i] - exact[i])[:STEPS - sum(counts)]:
        counts[i] += 1
    return counts


def by_rounding(problem):
    objective, rows, least, most = rows_of(problem)
    finite = numpy.isfinite(least), numpy.isfinite(most)
    result = linprog(objective, A_ub=numpy.vstack([rows[finite[1]], -rows[finite[0]]]),
                     b_ub=numpy.concatenate([numpy.array(most)[finite[1]], -numpy.array(least)[finite[0]]]), method="highs")
    return None if result.x is None else rounded(result.x[:len(problem["curves"])])


def by_integers(problem):
    """Whole numbers n with shares n / STEPS."""
    objective, rows, least, most = rows_of(problem)
    k = len(problem["curves"])
    scale = numpy.concatenate([numpy.full(k, 1 / STEPS), numpy.ones(len(objective) - k)])
    result = milp(c=objective * scale, constraints=LinearConstraint(rows * scale, least, most),
                  integrality=(numpy.arange(len(objective)) < k).astype(int),
                  bounds=Bounds(0, numpy.where(numpy.arange(len(objective)) < k, STEPS, numpy.inf)), options={"mip_rel_gap": 0})
    return None if result.x is None else [round(n) for n in result.x[:k]]


def children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    draw = random.Random(1)
    problems = [drawn(draw, number) for number in range(count)]
    best, times = [], []
    for problem in problems:
        [(counts, proved)], took = of_mdm(program, [problem])
        times.append(took)
        assert value(problem, counts) == proved
        best.append(proved)
    in_one_run = of_mdm(program, problems)[1] / count
    table = [("mdm", times, 0, 0, 0)]
    for name, method in (("HiGHS, rounded", by_rounding), ("HiGHS, integers", by_integers)):
        times, broken, missed, none = [], 0, 0, 0
        for problem, proved in zip(problems, best):
            begin = time.process_time()
            counts = method(problem)
            times.append(time.process_time() - begin)
            found = None if counts is None or sum(counts) != STEPS else value(problem, counts)
            none += counts is None
            broken += counts is not None and found is None
            missed += found is not None and found != proved
            assert found is None or found >= proved, (problem, counts)
        table.append((name, times, none, broken, missed))
    print(f"{count} problems, all of which have a blend (seed 1)")
    print(f"{'':16}  {'median ms':>9}  {'90 % ms':>8}  {'no answer':>9}  {'breaks a limit':>14}  {'not the best':>12}")
    for name, times, none, broken, missed in table:
        ninth = statistics.quantiles(times, n=10)[-1]
        print(f"{name:16}  {1000 * statistics.median(times):9.1f}  {1000 * ninth:8.1f}  {none:9}  {broken:14}  {missed:12}")
    print(f"mdm takes {1000 * in_one_run:.1f} ms a problem where all are lines of one run")


if __name__ == "__main__":
    main()
