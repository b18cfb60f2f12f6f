"""Makes the batches of blends: problems that are drawn, with seed 1; the files of published ones; answers and certificates."""

import csv
import json
import pathlib
import random
import tempfile
from fractions import Fraction

from answers import mdm, write_stream
from problem_files import options, write_files

SIEVES = ("0.075", "0.15", "0.3", "0.6", "1.18", "2.36", "4.75", "9.5", "12.5", "19")
SIEVES_EN = ("0.063", "0.125", "0.25", "0.5", "1", "2", "4", "8", "16", "31.5")
MODULI = {"FM": (SIEVES, (1, 2, 3, 4, 5, 6, 7, 9)), "FM-EN": (SIEVES_EN, (1, 2, 3, 4, 5, 6))}  # places of their sieves
AIMS = ("cost", "deviation", "max-deviation", "none")
DRAWN = 60


def tenths(number):
    """A whole number of tenths as a decimal."""
    return f"{number // 10}.{number % 10}".removesuffix(".0")


def drawn_curve(draw):
    """What passes each sieve, in tenths of a percent: nothing below some sieve, and all from another one on."""
    first = draw.randrange(0, 6)
    last = draw.randrange(first + 2, 10)
    return [0] * first + sorted(draw.randrange(0, 1001) for _ in range(last - first)) + [1000] * (10 - last)


def modulus(name, curve):
    """The sum of the shares retained on its sieves; the largest sieves retain nothing."""
    return sum(Fraction(1000 - curve[place], 1000) for place in MODULI[name][1])


def drawn_limits(draw, mixed):
    """Limits of some sieves, in tenths: about a mix, wide or narrow, and in each other problem maybe beside it."""
    room, beside = draw.choice((3, 10, 30, 60)), draw.choice((0, 1))
    limits = []
    for passing in mixed:
        low, high = (draw.randrange(-beside * room // 4, room + 1) for _ in range(2))
        ends = [max(0, min(1000, end)) for end in (passing // 100 - low, -(-passing // 100) + high)]
        limits.append(sorted(ends) if draw.randrange(4) else [0, 1000])
    return [*limits[:-1], [limits[-1][0], 1000]]


def drawn_problem(draw, number):
    """Two to six stockpiles, and limits about a mix of them that is drawn too."""
    k, aim = 2 + number % 5, AIMS[number // 5 % 4]
    curves = [drawn_curve(draw) for _ in range(k)]
    cuts = sorted(draw.randrange(0, 101) for _ in range(k - 1))
    mix = [above - below for below, above in zip([0, *cuts], [*cuts, 100])]
    mixed = [sum(n * curve[s] for n, curve in zip(mix, curves)) for s in range(10)]  # thousandths of a percent
    limits = [dict(zip(("least", "most"), map(tenths, ends))) if ends != [0, 1000] else {} for ends in drawn_limits(draw, mixed)]
    problem = {"id": f"drawn-{number + 1:02}",
               "stockpiles": [{"name": "ABCDEF"[i], "passing": [*map(tenths, curve)]} for i, curve in enumerate(curves)],
               "sieves": [{"size": size, **ends} for size, ends in zip(SIEVES, limits)], "steps": "100", "aim": aim}
    add_aim(draw, problem, mixed)
    add_limits(draw, problem, curves, mixed)
    return problem


def add_aim(draw, problem, mixed):
    """Costs, or a target: the mix in whole percents, or somewhat finer."""
    if problem["aim"] == "cost":
        for stockpile in problem["stockpiles"]:
            stockpile["cost"] = tenths(draw.randrange(40, 200))
    if "deviation" in problem["aim"]:
        finer = draw.randrange(0, 4)
        for sieve, passing in zip(problem["sieves"], mixed):
            sieve["target"] = str(min(100, passing // 1000 + finer))


def add_limits(draw, problem, curves, mixed):
    """In some problems limits of a share, of the number of stockpiles, or of a fineness modulus."""
    kind = draw.randrange(6)
    if kind == 0:
        draw.choice(problem["stockpiles"]).update(least=f"0.{draw.randrange(0, 3)}", most=f"0.{draw.randrange(3, 8)}")
    if kind == 1 and len(curves) > 2:
        problem["at_most"] = str(len(curves) - 1)
    if kind in (2, 3):
        name = ("FM", "FM-EN")[kind - 2]
        for sieve, size in zip(problem["sieves"], MODULI[name][0]):
            sieve["size"] = size
        for stockpile, curve in zip(problem["stockpiles"], curves):
            stockpile["moduli"] = [str(modulus(name, curve))]
        middle = int(10 * modulus(name, [Fraction(passing, 100) for passing in mixed]))
        ends = max(0, middle - draw.randrange(0, 4)), middle + draw.randrange(1, 4)
        problem["moduli"] = [{"name": name, **dict(zip(("least", "most"), map(tenths, ends)))}]


def short(answer):
    """Of an answer its blend with the value, or that there is none."""
    told = {"id": answer["id"], "status": answer["status"]}
    return {**told, **{key: answer["blends"][0][key] for key in ("value", "shares")}} if answer["blends"] else told


def certify(problem, told, folder, comment=""):
    """Writes the files of a problem into a folder, with a certificate of the same answer."""
    files = [folder / name for name in write_files(problem, folder, comment)]
    of_files = mdm("blend", *files, *options(problem, folder), "--format", "json", "--proof", folder / "blend.proof", "--quiet", codes=(0, 1))
    if short({**json.loads(of_files), "id": told["id"]}) != told:
        raise ValueError(f"{told['id']}: files and line have other blends")


def answers(name):
    """The problems of a batch, each with its answer; the answers are written."""
    text = pathlib.Path(f"blends/{name}.jsonl").read_text()
    lines = mdm("blend", "--problems", "-", "--quiet", text=text, codes=(0, 1)).splitlines()
    found = [short(json.loads(line)) for line in lines]
    pathlib.Path(f"blends/{name}.answers.jsonl").write_text("".join(json.dumps(told) + "\n" for told in found))
    return zip(map(json.loads, text.splitlines()), found)


def make_problems():
    """The problems that are drawn."""
    draw = random.Random(1)
    problems = [drawn_problem(draw, number) for number in range(DRAWN)]
    pathlib.Path("blends/drawn.jsonl").write_text("".join(json.dumps(problem) + "\n" for problem in problems))


def make():
    proofs = []
    for problem, told in answers("drawn"):
        with tempfile.TemporaryDirectory() as work:
            certify(problem, told, pathlib.Path(work))
            proofs.append((pathlib.Path(work) / "blend.proof").read_text())
    write_stream("blends/drawn.proofs", proofs)
    with open("blends/sources.csv", encoding="utf-8") as table:
        sources = {row["id"]: row["source"] for row in csv.DictReader(table)}
    for problem, told in answers("published"):
        folder = pathlib.Path("blends") / problem["id"]
        folder.mkdir(exist_ok=True)
        certify(problem, told, folder, f"# {sources[problem['id']]}\n")
