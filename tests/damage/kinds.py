"""Damaged copies of samples, sets by number, blends, materials and judgements of the reference set: each check.py refuses them."""

import contextlib
import csv
import io
import json
import pathlib
import re
import sys
from fractions import Fraction
from itertools import permutations


class Kind:
    """A kind of questions: its folder, its program as a module, and the lines of its answers."""

    def __init__(self, folder, module, answers, *arguments):
        self.folder, self.module, self.answers, self.arguments = pathlib.Path(folder), module, answers, arguments
        self.lines = (self.folder / answers).read_text(encoding="utf-8").splitlines(keepends=True)

    def rows(self):
        return list(csv.DictReader(self.lines))

    def text(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def count(self):
        """How many answers there are: of materials several rows are one."""
        return len({row["id"] for row in self.rows()}) if self.answers.endswith(".csv") else len(self.lines)

    def with_row(self, i, **changes):
        """The answers with other fields in row i."""
        return self.with_rows({i: changes})

    def with_rows(self, changes):
        out, rows = io.StringIO(), self.rows()
        for i, fields in changes.items():
            rows[i].update(fields)
        writer = csv.DictWriter(out, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        return {self.answers: out.getvalue()}

    def with_answer(self, i, answer):
        return {self.answers: "".join([*self.lines[:i], json.dumps(answer) + "\n", *self.lines[i + 1:]])}

    def run(self):
        """How its program exits, and what it prints."""
        printed, kept = io.StringIO(), sys.argv
        sys.argv = ["check.py", *self.arguments]
        with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
            code = self.module.main()
        sys.argv = kept
        return code, printed.getvalue()


def chosen(draw, rows, wanted=lambda row: True):
    return draw.choice([(i, row) for i, row in enumerate(rows) if wanted(row)])


def nearly(text):
    """A number a little above."""
    number = Fraction(text)
    return str(number + (number or 1) / 1000)


# samples

def verdict(draw, kind):
    i, row = chosen(draw, kind.rows())
    return kind.with_row(i, verdict={"match": "no match", "no match": "match"}[row["verdict"]])


def particles(draw, kind):
    i, row = chosen(draw, kind.rows())
    return kind.with_row(i, particles=str(int(row["particles"]) + draw.choice((-1, 1))))


def sides(draw, kind):
    i, row = chosen(draw, kind.rows(), lambda row: row["below"] != row["above"])
    return kind.with_row(i, below=row["above"], above=row["below"])


def error_end(draw, kind):
    """Of ranges the ends enclose what there is, so that the upper end is made smaller."""
    i, row = chosen(draw, kind.rows())
    column = draw.choice([column for column in row if column.endswith("_error_hi")])
    smaller = str(Fraction(row[column]) / 2)
    return kind.with_row(i, **{column: smaller if "-ranges-" in row["id"] else nearly(row[column])})


def tolerance_dropped(draw, kind):
    i, _ = chosen(draw, kind.rows(), lambda row: "fewer-within-retained" in row["id"] or "six-digits-within" in row["id"])
    return kind.with_row(i, options="")


def quantity_in_sample(draw, kind):
    name = draw.choice(kind.rows())["sample"]
    lines = kind.text(name).splitlines()
    i = draw.randrange(1, len(lines))
    sizes, _, quantity = lines[i].rpartition(",")
    lines[i] = f"{sizes},{int(quantity) + 1}"
    return {name: "\n".join(lines) + "\n"}


def size_in_sample(draw, kind):
    """A size of twice as many particles' mass: the share is another."""
    name = draw.choice([row["sample"] for row in kind.rows() if row["sample"].endswith(("-exact.csv", "-rounded.csv"))])
    header, *rows = kind.text(name).splitlines()
    i = draw.randrange(len(rows))
    size, quantity = rows[i].split(",")
    rows[i] = f"{Fraction(size) * Fraction(999, 1000)},{quantity}"
    return {name: "\n".join([header, *rows]) + "\n"}


def mass_in_gradation(draw, kind):
    name = draw.choice(kind.rows())["gradation"]
    header, *rows = kind.text(name).splitlines()
    i = draw.choice([i for i, row in enumerate(rows) if not row.endswith(",0")])
    size, mass = rows[i].split(",")
    rows[i] = f"{size},{Fraction(mass) * Fraction(1001, 1000)}"
    return {name: "\n".join([header, *rows]) + "\n"}


def other_sample(draw, kind):
    i, row = chosen(draw, kind.rows(), lambda row: row["sample"].endswith("-one-more.csv"))
    return kind.with_row(i, sample=row["sample"].replace("one-more", "one-less"))


# sets by number

def doubled_set(draw, kind):
    """It has the shares, and twice the particles that are needed."""
    i, row = chosen(draw, kind.rows())
    doubled = " ".join(str(2 * int(q)) for q in row["quantities"].split())
    return kind.with_row(i, quantities=doubled, particles=str(2 * int(row["particles"])))


def quantity_by_one(draw, kind):
    i, row = chosen(draw, kind.rows())
    counts = [int(q) for q in row["quantities"].split()]
    counts[draw.randrange(len(counts))] += 1
    return kind.with_row(i, quantities=" ".join(map(str, counts)))


def other_set(draw, kind):
    """Of an exact set two quantities are swapped."""
    i, row = chosen(draw, kind.rows(), lambda row: not row["options"] and len(set(row["quantities"].split())) > 1)
    counts = row["quantities"].split()
    a, b = draw.choice([(a, b) for a, b in permutations(range(len(counts)), 2) if counts[a] != counts[b]])
    counts[a], counts[b] = counts[b], counts[a]
    return kind.with_row(i, quantities=" ".join(counts))


def finer_tolerance(draw, kind):
    """At an edge: in the question and in its answer."""
    old, new = draw.choice((("retained:0.1%", "retained:0.0999999%"), ("retained:5%", "retained:4.999999%")))
    return {name: kind.text(name).replace(old, new) for name in ("number.csv", kind.answers)}


def coarser_tolerance(draw, kind):
    old, new = draw.choice((("retained:0.0999%", "retained:0.1%"), ("retained:4.999%", "retained:5%")))
    return {name: kind.text(name).replace(old, new) for name in ("number.csv", kind.answers)}


def share_in_gradation(draw, kind):
    name = draw.choice(sorted({row["gradation"] for row in kind.rows() if row["gradation"] != "microscope.csv"}))
    lines = kind.text(name).splitlines()
    i = draw.choice([i for i, line in enumerate(lines) if re.fullmatch(r"[\d.]+,[\d.]*[1-9][\d.]*", line)])
    return {name: "\n".join([*lines[:i], f"{lines[i]}1" if "." in lines[i].split(",")[1] else f"{lines[i]}.1", *lines[i + 1:], ""])}


def answer_removed(draw, kind):
    i = draw.randrange(1, len(kind.lines))
    return {kind.answers: "".join(kind.lines[:i] + kind.lines[i + 1:])}


# blends

def answered(draw, kind, wanted):
    """A drawn problem with its answer, of those that are wanted."""
    pairs = zip(kind.text("drawn.jsonl").splitlines(), kind.lines)
    return chosen(draw, [tuple(map(json.loads, pair)) for pair in pairs], lambda pair: wanted(*pair))


def has_blend(_, answer):
    return answer["status"] == "optimal"


def none_said(draw, kind):
    i, (_, answer) = answered(draw, kind, lambda problem, answer: has_blend(problem, answer) and len(problem["stockpiles"]) <= 4)
    return kind.with_answer(i, {"id": answer["id"], "status": "none"})


def blend_said(draw, kind):
    i, (problem, answer) = answered(draw, kind, lambda _, answer: answer["status"] == "none")
    k = len(problem["stockpiles"])
    return kind.with_answer(i, {"id": answer["id"], "status": "optimal", "value": "0", "shares": ["1"] + ["0"] * (k - 1)})


def value(draw, kind):
    i, (_, answer) = answered(draw, kind, has_blend)
    return kind.with_answer(i, {**answer, "value": nearly(answer["value"])})


def half_a_step(draw, kind):
    i, (_, answer) = answered(draw, kind, lambda problem, answer: has_blend(problem, answer) and answer["shares"].count("0") == 0)
    first, second, *rest = map(Fraction, answer["shares"])
    return kind.with_answer(i, {**answer, "shares": [str(first - Fraction(1, 200)), str(second + Fraction(1, 200)), *map(str, rest)]})


def worse_blend(draw, kind):
    """Another blend within the limits, with its own value; it is worse, or comes later of those that are equally good."""
    def others(problem, answer):
        read, steps = kind.module.Problem(problem), [int(Fraction(share) * 100) for share in answer.get("shares", ())]
        for a, b in permutations(range(len(steps)), 2):
            moved = [n + (i == a) - (i == b) for i, n in enumerate(steps)]
            if min(moved) >= 0 and read.keeps(moved):
                yield {**answer, "shares": [str(Fraction(n, 100)) for n in moved], "value": str(read.value(moved))}
    i, pair = answered(draw, kind, lambda problem, answer: len(problem["stockpiles"]) <= 4 and any(others(problem, answer)))
    return kind.with_answer(i, draw.choice(list(others(*pair))))


def limit(draw, kind):
    """A limit that the blend does not keep."""
    i, (problem, answer) = answered(draw, kind, has_blend)
    place, sieve = chosen(draw, problem["sieves"][:-1])
    passing = sum(Fraction(share) * Fraction(stockpile["passing"][place]) for share, stockpile in zip(answer["shares"], problem["stockpiles"]))
    sieve["least" if passing < 100 else "most"] = str(passing + Fraction(1, 1000) if passing < 100 else Fraction(99))
    lines = kind.text("drawn.jsonl").splitlines()
    return {"drawn.jsonl": "\n".join([*lines[:i], json.dumps(problem), *lines[i + 1:], ""])}


def cost(draw, kind):
    i, (problem, answer) = answered(draw, kind, lambda problem, answer: has_blend(problem, answer) and problem["aim"] == "cost")
    stockpile = draw.choice([s for s, share in zip(problem["stockpiles"], answer["shares"]) if share != "0"])
    stockpile["cost"] = nearly(stockpile["cost"])
    lines = kind.text("drawn.jsonl").splitlines()
    return {"drawn.jsonl": "\n".join([*lines[:i], json.dumps(problem), *lines[i + 1:], ""])}


def modulus(draw, kind):
    """The modulus of a stockpile is another than its curve has."""
    i, (problem, _) = answered(draw, kind, lambda problem, _: "moduli" in problem)
    stockpile = draw.choice(problem["stockpiles"])
    stockpile["moduli"] = [nearly(stockpile["moduli"][0])]
    lines = kind.text("drawn.jsonl").splitlines()
    return {"drawn.jsonl": "\n".join([*lines[:i], json.dumps(problem), *lines[i + 1:], ""])}


def line_removed(draw, kind):
    i = draw.randrange(len(kind.lines))
    return {kind.answers: "".join(kind.lines[:i] + kind.lines[i + 1:])}


# materials

def doubled_match(draw, kind):
    """It has the shares, and twice the particles that are needed."""
    rows = kind.rows()
    name = draw.choice(sorted({row["id"] for row in rows}))
    return kind.with_rows({i: {column: str(2 * int(row[column])) for column in ("quantity", "particles")}
                           for i, row in enumerate(rows) if row["id"] == name})


def quantity_of_class(draw, kind):
    i, row = chosen(draw, kind.rows())
    return kind.with_row(i, quantity=str(int(row["quantity"]) + 1))


def size_of_class(draw, kind):
    i, row = chosen(draw, kind.rows(), lambda row: row["size_lo"])
    return kind.with_row(i, size_lo=nearly(row["size_lo"]), size_hi=nearly(row["size_hi"]))


def share_of_class(draw, kind):
    i, row = chosen(draw, kind.rows())
    return kind.with_row(i, share=nearly(row["share"]))


def material_of_class(draw, kind):
    i, row = chosen(draw, kind.rows())
    return kind.with_row(i, material=row["material"] + " ")


def row_removed(draw, kind):
    i = draw.randrange(1, len(kind.lines))
    return {kind.answers: "".join(kind.lines[:i] + kind.lines[i + 1:])}


def other_options(kind, old, new):
    return {"materials.csv": kind.text("materials.csv").replace(old, new)}


def finer_edge(draw, kind):
    return other_options(kind, *draw.choice(((":1.1%", ":1.09999999999999999999999%"), ("total:2.2%", "total:2.199999999999999999999%"),
                                             ("retained:0.0002%", "retained:0.00019999999999999999999999%"))))


def coarser_edge(draw, kind):
    return other_options(kind, *draw.choice(((":1.0999999999999999999%", ":1.1%"), ("total:2.1999999999999999999%", "total:2.2%"),
                                             ("retained:5%", "retained:5.0000000000000000000001%"))))


def fewer_asked(draw, kind):
    """Another question, which fewer particles match."""
    return other_options(kind, *draw.choice(((" --at-least 20", ""), ("--at-least 1000", "--at-least 999"), ("--min-per-class 10", ""))))


def number_in_mixture(draw, kind):
    """The mass or the factor of a class is another: exact questions are asked of each gradation."""
    name = draw.choice(sorted({line.split(",")[1] for line in kind.text("materials.csv").splitlines()[1:]}))
    lines = kind.text(name).splitlines()
    i = draw.choice([i for i, line in enumerate(lines) if re.match(r"[\d.]+,[\d.]*[1-9]", line)])
    fields = lines[i].split(",")
    place = draw.choice([place for place, column in enumerate(lines[1].split(",")) if column in ("mass", "retained_g", "factor")])
    fields[place] = nearly(fields[place])
    return {name: "\n".join([*lines[:i], ",".join(fields), *lines[i + 1:], ""])}


# judgements

def other_verdict(draw, kind):
    i, row = chosen(draw, kind.rows())
    return kind.with_row(i, verdict=draw.choice([word for word in ("pass", "fail", "hangs") if word != row["verdict"]]))


def curves_swapped(draw, kind):
    i, row = chosen(draw, kind.rows(), lambda row: row["verdict"] == "hangs")
    return kind.with_row(i, within=row["outside"], outside=row["within"])


def curve_beyond(draw, kind):
    """At one sieve a curve is a percentage point and a half lower, which rounds to another report."""
    i, row = chosen(draw, kind.rows(), lambda row: row["verdict"] == "hangs")
    side = draw.choice(("within", "outside"))
    curve = row[side].split()
    place = draw.randrange(len(curve))
    curve[place] = str(Fraction(curve[place]) - Fraction(3, 2))
    return kind.with_row(i, **{side: " ".join(curve)})


def curve_missing(draw, kind):
    i, _ = chosen(draw, kind.rows(), lambda row: row["verdict"] == "hangs")
    return kind.with_row(i, **{draw.choice(("within", "outside")): ""})


def limit_at_report(draw, kind):
    """A limit of a specification becomes one of a percent that a report passes with: it hangs there."""
    i, row = chosen(draw, kind.rows(), lambda row: row["verdict"] == "pass")
    lines = kind.text(row["specification"]).splitlines()
    reported = dict(line.split(",") for line in kind.text(row["report"]).splitlines()[1:-1])
    places = [(n, line.split(",")) for n, line in enumerate(lines) if line.split(",")[0] in reported]
    n, (size, _, most) = draw.choice([(n, fields) for n, fields in places if Fraction(reported[fields[0]]) > 0])
    lines[n] = f"{size},{reported[size]},{most}"
    return {row["specification"]: "\n".join(lines) + "\n"}


def decimal_added(draw, kind):
    """A percent on which a verdict hangs is printed with a nought more, and so with less room, in all its rows below 100."""
    i, row = chosen(draw, kind.rows(), lambda row: row["verdict"] == "hangs")
    header, *rows = kind.text(row["report"]).splitlines()
    rows = [line + ("00" if "." in line.split(",")[1] else ".00") for line in rows]
    return {row["report"]: "\n".join([header, *rows]) + "\n"}


SAMPLES = (verdict, particles, sides, error_end, tolerance_dropped, quantity_in_sample, size_in_sample, mass_in_gradation, other_sample)
NUMBER = (doubled_set, quantity_by_one, other_set, finer_tolerance, coarser_tolerance, share_in_gradation, answer_removed)
BLENDS = (none_said, blend_said, value, half_a_step, worse_blend, limit, cost, modulus, line_removed)
MATERIALS = (doubled_match, quantity_of_class, size_of_class, share_of_class, material_of_class, row_removed, finer_edge, coarser_edge,
             fewer_asked, number_in_mixture)
JUDGEMENTS = (other_verdict, curves_swapped, curve_beyond, curve_missing, limit_at_report, decimal_added)
UNREADABLE = (answer_removed, modulus)  # that is no wrong answer, but a table without one, or a problem that contradicts itself
TIMES = 3


def check_kinds(draw, load, folder, expect):
    """Each damage some times, drawn; returns how many copies there were."""
    kinds = ((Kind(folder / "samples", load(folder / "samples/check.py"), "samples.answers.csv"), SAMPLES),
             (Kind(folder / "number", load(folder / "number/check.py"), "number.answers.csv"), NUMBER),
             (Kind(folder / "blends", load(folder / "blends/check.py"), "drawn.answers.jsonl", "drawn"), BLENDS),
             (Kind(folder / "materials", load(folder / "materials/check.py"), "materials.answers.csv"), MATERIALS),
             (Kind(folder / "judgements", load(folder / "judgements/check.py"), "judgements.answers.csv"), JUDGEMENTS))
    copies = 0
    for kind, damages in kinds:
        lines = (kind.folder / "check.py").read_text(encoding="utf-8").splitlines()
        expect(len(lines) <= 200, f"{kind.folder.name}/check.py has {len(lines)} lines")
        code, said = kind.run()
        expect(code == 0 and f"{kind.count()} right" in said, f"{kind.folder.name} is refused: {said}")
        for damage in TIMES * damages:
            copies += 1
            changed = damage(draw, kind)
            kept = {name: kind.text(name) for name in changed}
            for name, text in changed.items():
                expect(text != kept[name], f"{damage.__name__} changes nothing")
                (kind.folder / name).write_text(text, encoding="utf-8")
            code, said = kind.run()
            expect(code == (2 if damage in UNREADABLE else 1) and "Traceback" not in said,
                   f"{kind.folder.name}: {damage.__name__}: exit {code}: {said}")
            for name, text in kept.items():
                (kind.folder / name).write_text(text, encoding="utf-8")
    return copies
