"""Makes the batch `judgements`: reports of what passes the sieves of a specification, drawn with seed 1 at and near its limits,
and what mdm judge says of each."""

import csv
import json
import pathlib
import random
import shutil
from fractions import Fraction

from answers import mdm, write_table

PROJECT = pathlib.Path(__file__).resolve().parents[3]
COLUMNS = ["id", "report", "specification", "options", "verdict", "within", "outside"]
REPORTS = 6  # of each specification
MODULUS_SIEVES = 6  # the finest of the seven of astm-c33-fine: the largest retains nothing


def limits(specification):
    """The rows of a specification, from the finest sieve up."""
    lines = specification.read_text().splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return sorted(rows, key=lambda row: Fraction(row["size_mm"]))


def drawn_report(draw, rows, is_close):
    """Percents as they are printed, of nought to two decimals: between the limits, or at most some units of the last digit off
    one of them. They do not decrease with size."""
    report, before = [], Fraction(0)
    for row in rows[:-1]:
        places = draw.choice((0, 1, 1, 2))
        unit = Fraction(1, 10 ** places)
        low, high = Fraction(row["passing_min_percent"]), Fraction(row["passing_max_percent"])
        if is_close and draw.randrange(3) == 0:
            passing = draw.choice((low, high)) + draw.randrange(-1, 2) * unit
        else:
            passing = low + (high - low) * Fraction(draw.randrange(20, 81), 100)
        units = max(-(-before // unit), min(100 / unit, passing // unit))
        if units * unit > 100:
            units, places = Fraction(100), 0
        before = units / 10 ** places
        report.append((row["size_mm"], f"{int(units) // 10 ** places}" + (f".{int(units) % 10 ** places:0{places}}" if places else "")))
    return [*report, (rows[-1]["size_mm"], "100")]


def modulus(report):
    """The fineness modulus of ASTM C125 of a report of the sieves of astm-c33-fine, as a decimal."""
    digits = int(100 * sum(100 - Fraction(passing) for _, passing in report[:MODULUS_SIEVES]))
    return f"{digits // 10000}.{digits % 10000:04}"


def row(name, report, specification, options):
    answer = json.loads(mdm("judge", f"judgements/{report}", "--spec", f"judgements/{specification}", *options.split(), "--format", "json",
                            "--quiet", codes=(0, 1)))["samples"][0]
    curves = [" ".join(point["percent"] for point in answer[side] or ()) for side in ("within", "outside")]
    return [name, report, specification, options, answer["verdict"], *curves]


def make():
    draw, rows = random.Random(1), []
    for source in sorted((PROJECT / "src/judge/specifications").glob("[as]*.csv")):  # of ASTM and AASHTO
        shutil.copy(source, f"judgements/{source.name}")
        for number in range(REPORTS):
            name = f"{source.stem}-{number + 1}"
            report = drawn_report(draw, limits(source), number > 0)
            write_table(f"judgements/{name}.csv", ["size_mm", "passing_percent"], report)
            rows.append(row(name, f"{name}.csv", source.name, ""))
            if source.stem == "astm-c33-fine":
                rows.append(row(f"{name}-modulus", f"{name}.csv", source.name, "--limit FM=2.3..3.1"))
                rows.append(row(f"{name}-modulus-edge", f"{name}.csv", source.name, f"--limit FM=2..{modulus(report)}"))
    write_table("judgements/judgements.answers.csv", COLUMNS, rows)
