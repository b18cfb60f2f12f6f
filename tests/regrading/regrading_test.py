#!/usr/bin/python3
"""regrading_test.py MDM MDM_CHECK: joining, splitting, scalping, replacing and scaling of mdm convert, against fractions.

The second method works on curves, the share that passes each size, and never on masses: the curve of what is written must
be the one that the operation's definition gives, at every size, to the last digit. Cases are drawn from a seed; those that
no exact cut serves must be refused. What is written is read again by MDM_CHECK.
"""

import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as F

MDM, MDM_CHECK = (str(pathlib.Path(p).resolve()) for p in sys.argv[1:3])
SIZES = [F(text) for text in "0.002 0.005 0.02 0.063 0.075 0.15 0.3 0.6 1.18 2 2.36 4.75 9.5 19 37.5 75".split()]
failures = []
refused = accepted = 0


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def decimal(value):
    for places in range(60):
        if (value * 10 ** places).denominator == 1:
            digits = str((value * 10 ** places).numerator).rjust(places + 1, "0")
            return digits if places == 0 else digits[:-places] + "." + digits[-places:]
    raise ValueError(value)


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    assert lines[0] == "size_mm,mass", lines[0]
    return sorted((F(a), F(b)) for a, b in (line.split(",") for line in lines[1:]))


class Curve:
    """The share that passes, at the sizes of a table; elsewhere only where no mass is around."""

    def __init__(self, rows):
        self.rows = rows
        self.total = sum(mass for _, mass in rows)

    def passing(self, size):
        """None where mass around it does not tell."""
        below = F(0)
        for (lower, mass), upper in zip(self.rows, [size for size, _ in self.rows[1:]] + [None]):
            if lower >= size:
                break
            if mass and upper > size:
                return None
            below += mass
        return below / self.total

    def sizes(self):
        return [size for size, _ in self.rows]


def drawn(rng, sizes, pan):
    """A complete table: masses on random sieves, the largest retains nothing, some classes are empty."""
    chosen = sorted(rng.sample(sizes, rng.randint(2, min(7, len(sizes)))))
    rows = [(size, F(rng.choice([0, rng.randint(1, 9999)]), 10)) for size in chosen[:-1]]
    if pan:
        rows.insert(0, (F(0), F(rng.randint(0, 3000), 10)))
    rows.append((chosen[-1], F(0)))
    return rows if any(mass for _, mass in rows) else drawn(rng, sizes, pan)


def write(folder, name, rows):
    path = pathlib.Path(folder, name)
    path.write_text("size_mm,mass\n" + "".join(f"{decimal(s)},{decimal(m)}\n" for s, m in rows))
    return str(path)


def run(*arguments):
    return subprocess.run([MDM, "convert", *arguments], capture_output=True, text=True, timeout=60)


def compare(result, expected, sizes, what):
    """expected(size): the share; None for the whole: it must be refused."""
    global refused, accepted
    if expected is None:
        refused += 1
        check(result.returncode == 2 and result.stdout == "" and result.stderr.count("\n") == 1, f"{what}: not refused")
        return
    accepted += 1
    if result.returncode != 0:
        check(False, f"{what}: {result.stderr}")
        return
    curve = Curve(rows_of(result.stdout))
    check(curve.sizes()[1:] == sorted(set(curve.sizes()[1:])), f"{what}: sizes")
    for size in sorted(sizes | set(curve.sizes())):
        check(curve.passing(size) == expected(size), f"{what}: at {size}: {curve.passing(size)}, not {expected(size)}")
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as written:
        written.write(result.stdout)
        written.flush()
        again = subprocess.run([MDM_CHECK, "--print", written.name], capture_output=True, text=True, timeout=60)
        check(again.returncode == 0 and rows_of(again.stdout) == curve.rows, f"{what}: MDM_CHECK reads another")


def join(rng, folder, n):
    coarse, fine = drawn(rng, SIZES[3:], rng.random() < 0.8), drawn(rng, SIZES[:8], True)
    at = rng.choice(SIZES[2:8])
    c, f = Curve(coarse), Curve(fine)
    pc, pf = c.passing(at), f.passing(at)
    above = any(m for s, m in fine if s >= at)
    both = [s for s in c.sizes() if s in f.sizes() and s > 0 and (s < at or s > at and above)]
    expected = None
    if pc and pf and pc < 1: # some of the coarse one is above the joint
        expected = lambda x: c.passing(x) if x >= at else (None if f.passing(x) is None else pc * f.passing(x) / pf)
    result = run("--join", write(folder, "c.csv", coarse), write(folder, "f.csv", fine), "--at", f"{decimal(at * 1000)}um")
    compare(result, expected, set(c.sizes()) | set(f.sizes()), f"join {n}")
    if expected:
        compared = [line for line in result.stdout.splitlines() if line.startswith("# compared at")]
        check(len(compared) == len(both), f"join {n}: compared {compared}, both have {both}")
        beyond = [line for line in result.stdout.splitlines() if line.startswith("# more than 100 % passes")]
        check(len(beyond) == sum(f.passing(s) * pc > pf for s in both), f"join {n}: {beyond}")


def split(rng, folder, n):
    at = rng.choice(SIZES[5:10])
    coarse = drawn(rng, [s for s in SIZES if s > at], False)
    coarse.insert(0, (at, F(rng.randint(1, 5000), 10)))
    mass, with_pan = F(rng.randint(1, 9000), 10), rng.random() < 0.5
    if with_pan:
        coarse.insert(0, (F(0), mass))
    fine = drawn(rng, [s for s in SIZES if s <= at] + rng.choice([[], [F(100)]]), True)
    whole = Curve(([] if with_pan else [(F(0), mass)]) + coarse)
    f = Curve(fine)
    options = [] if with_pan and rng.random() < 0.7 else ["--fine-mass", decimal(mass)]
    expected = None
    if f.passing(at) == 1:
        pc = whole.passing(at)
        expected = lambda x: whole.passing(x) if x >= at else (None if f.passing(x) is None else pc * f.passing(x))
    result = run("--split", write(folder, "c.csv", coarse), write(folder, "f.csv", fine), "--at", decimal(at), *options)
    compare(result, expected, set(whole.sizes()) | set(f.sizes()), f"split {n}")


def scalp(rng, folder, n):
    rows, at = drawn(rng, SIZES, rng.random() < 0.5), rng.choice(SIZES)
    c = Curve(rows)
    p = c.passing(at)
    expected = (lambda x: F(1) if x >= at else (None if c.passing(x) is None else c.passing(x) / p)) if p else None
    result = run(write(folder, "s.csv", rows), "--scalp", f"above:{decimal(at)}mm")
    compare(result, expected, set(c.sizes()), f"scalp {n}")


def replace(rng, folder, n):
    rows = drawn(rng, SIZES, rng.random() < 0.5)
    low, high, above = rng.choice(SIZES), rng.choice(SIZES), rng.choice(SIZES)
    c = Curve(rows)
    ends = [c.passing(size) for size in (low, high, above)]
    expected = None
    if low < high <= above and None not in ends and (ends[1] > ends[0] or ends[2] == 1):
        oversize = 1 - ends[2]

        def expected(x):
            if x >= above:
                return F(1)
            p = c.passing(x)
            if p is None or oversize == 0 or p <= ends[0]:
                return p
            return p + oversize * (min(p, ends[1]) - ends[0]) / (ends[1] - ends[0])
    result = run(write(folder, "r.csv", rows), "--replace", f"above:{decimal(above)}", "into",
                 f"{decimal(low)}mm..{decimal(high)}")
    compare(result, expected, set(c.sizes()), f"replace {n}")


def parallel(rng, folder, n):
    rows, (p, q) = drawn(rng, SIZES, rng.random() < 0.5), rng.choice([(1, 5), (1, 4), (3, 8), (7, 1), (1, 7)])
    c = Curve(rows)
    try:
        for size in c.sizes():
            decimal(size * F(p, q))
        expected = lambda x: c.passing(x * F(q, p))
    except ValueError:
        expected = None
    result = run(write(folder, "p.csv", rows), "--parallel", rng.choice([f"{p}/{q}", f"{p}e0/{q}"]))
    compare(result, expected, {s * F(p, q) for s in c.sizes()} if expected else set(), f"parallel {n}")


with tempfile.TemporaryDirectory() as folder:
    for operation in (join, split, scalp, replace, parallel):
        rng = random.Random(operation.__name__)
        for n in range(200):
            operation(rng, folder, n)
print(f"{accepted} written, {refused} refused, {len(failures)} failures")
check(accepted > 300 and refused > 150, "too few of one kind")
sys.exit(1 if failures else 0)
