#!/usr/bin/python3
"""damage_test.py SOURCE: check.py of the reference set in SOURCE/examples accepts the set, and refuses 200 damaged copies;
so do those of samples, sets by number, blends, materials and judgements (kinds.py), each some dozens.

Each copy has one thing changed that matters: what is drawn, and where, is the same in every run.
"""

import csv
import importlib.util
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
from decimal import Decimal

sys.dont_write_bytecode = True
from kinds import check_kinds

SET = pathlib.Path(sys.argv[1]).resolve() / "examples/reference"
COPIES = 200

failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)
        print("failed:", message)


def program(path):
    """check.py as a module."""
    spec = importlib.util.spec_from_file_location("check", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Batch:
    """A batch: the names of its files, and their lines."""

    def __init__(self, name, gradations, _, options):
        self.name, self.gradations, self.options = name, gradations, options
        self.answers, self.proofs = f"{name}.answers.csv", f"{name}.proofs"
        self.is_tolerant, self.is_csv = "--tolerance" in options, gradations.endswith(".csv")

    @staticmethod
    def lines(file):
        return (SET / file).read_text(encoding="utf-8").splitlines(keepends=True)

    def rows(self, draw):
        """The lines of the answers, and which are those of one with two classes of particles or more, near the top."""
        lines = self.lines(self.answers)
        by_id = {}
        for i, line in enumerate(lines[1:], 1):
            by_id.setdefault(line.split(",")[0], []).append(i)
        chosen = [rows for rows in by_id.values() if sum(lines[i].split(",")[5] != "0" for i in rows) > 1]
        return lines, draw.choice(chosen[:400])


def with_field(lines, i, field, text):
    """The lines with another field in line i."""
    fields = lines[i].rstrip("\n").split(",")
    assert fields[field] != text
    fields[field] = text
    return lines[:i] + [",".join(fields) + "\n"] + lines[i + 1:]


def other_digit(draw, text, digits=99):
    """The number with one of its first digits, zeros in front left out, changed to another one."""
    mantissa = text.partition("e")[0]
    first = re.search("[1-9]", mantissa)
    places = [i for i, ch in enumerate(mantissa) if ch.isdigit() and i >= (first.start() if first else 0)][:digits]
    i = draw.choice(places)
    return text[:i] + draw.choice([d for d in "0123456789" if d != text[i]]) + text[i + 1:]


def filled(draw, batch):
    lines, rows = batch.rows(draw)
    return lines, rows, draw.choice([i for i in rows if lines[i].split(",")[5] != "0"])


def quantity_by_one(draw, batch):
    lines, _, i = filled(draw, batch)
    return {batch.answers: with_field(lines, i, 5, str(int(lines[i].split(",")[5]) + draw.choice((-1, 1))))}


def quantities_swapped(draw, batch):
    lines, rows = batch.rows(draw)
    counts = {i: lines[i].split(",")[5] for i in rows}
    pairs = [(i, j) for i in rows for j in rows if counts[i] != counts[j] and "0" not in (counts[i], counts[j])]
    if not pairs:
        return None
    i, j = draw.choice(pairs)
    return {batch.answers: with_field(with_field(lines, i, 5, counts[j]), j, 5, counts[i])}


def all_quantities_doubled(draw, batch):
    """A match, with the same sizes, but not the smallest."""
    lines, rows = batch.rows(draw)
    for i in rows:
        count = int(lines[i].split(",")[5])
        lines = with_field(lines, i, 5, str(2 * count)) if count else lines
    return {batch.answers: lines}


def size_bound(draw, batch):
    lines, _, i = filled(draw, batch)
    field = draw.choice((6, 7))
    return {batch.answers: with_field(lines, i, field, other_digit(draw, lines[i].rstrip("\n").split(",")[field], 12))}


def both_size_bounds(draw, batch):
    """The next range of ten digits: of another scale, or of another class."""
    lines, _, i = filled(draw, batch)
    bounds = [Decimal(text) for text in lines[i].rstrip("\n").split(",")[6:]]
    step = Decimal(1).scaleb(bounds[0].adjusted() - 9) * draw.choice((-1, 1))
    for field, bound in zip((6, 7), bounds):
        lines = with_field(lines, i, field, f"{bound + step:f}")
    return {batch.answers: lines}


def row_removed(draw, batch):
    lines, rows = batch.rows(draw)
    i = draw.choice(rows)
    return {batch.answers: lines[:i] + lines[i + 1:]}


def row_twice(draw, batch):
    lines, rows = batch.rows(draw)
    i = draw.choice(rows)
    return {batch.answers: lines[:i] + [lines[i]] + lines[i:]}


def rows_swapped(draw, batch):
    lines, rows = batch.rows(draw)
    i, j = draw.sample(rows, 2)
    lines[i], lines[j] = lines[j], lines[i]
    return {batch.answers: lines}


def answer_removed(draw, batch):
    lines, rows = batch.rows(draw)
    return {batch.answers: [line for i, line in enumerate(lines) if i not in rows]}


def id_of_row(draw, batch):
    lines, rows = batch.rows(draw)
    i = draw.choice(rows)
    return {batch.answers: with_field(lines, i, 0, lines[i].split(",")[0] + "x")}


def class_number(draw, batch):
    lines, rows = batch.rows(draw)
    i = draw.choice(rows)
    return {batch.answers: with_field(lines, i, 1, str(int(lines[i].split(",")[1]) + draw.choice((-1, 1))))}


def opening_of_row(draw, batch):
    lines, rows = batch.rows(draw)
    i, field = draw.choice(rows), draw.choice((2, 3))
    return {batch.answers: with_field(lines, i, field, other_digit(draw, lines[i].split(",")[field]))}


def share(draw, batch):
    lines, _, i = filled(draw, batch)
    return {batch.answers: with_field(lines, i, 4, other_digit(draw, lines[i].split(",")[4]))}


def name_of_shares(draw, batch):
    lines, _ = batch.rows(draw)
    old, new = ("match_share_percent", "share_percent")[:: 1 if batch.is_tolerant else -1]
    return {batch.answers: [lines[0].replace(f",{old},", f",{new},")] + lines[1:]}


def gradation_changed(draw, batch, change):
    if batch.is_csv:
        return None
    lines = batch.lines(batch.gradations)
    i = draw.randrange(min(len(lines), 400))
    gradation = json.loads(lines[i])
    change(gradation)
    return {batch.gradations: lines[:i] + [json.dumps(gradation) + "\n"] + lines[i + 1:]}


def mass(draw, batch):
    """Six digits of a mass: within a tolerance another target may have the same smallest match."""
    def change(gradation):
        masses = gradation["masses"]
        j = draw.choice([j for j, m in enumerate(masses) if Decimal(m)])
        masses[j] = other_digit(draw, masses[j], 6)
    return None if batch.is_tolerant else gradation_changed(draw, batch, change)


def opening(draw, batch):
    def change(gradation):
        j = draw.randrange(len(gradation["sizes"]))
        gradation["sizes"][j] = other_digit(draw, gradation["sizes"][j])
    return gradation_changed(draw, batch, change)


def id_of_gradation(draw, batch):
    return gradation_changed(draw, batch, lambda gradation: gradation.update(id=gradation["id"] + "x"))


def unit(draw, batch):
    return gradation_changed(draw, batch, lambda gradation: gradation.update(unit="um"))


def gradation_removed(draw, batch):
    lines = batch.lines(batch.gradations)
    i = draw.randrange(len(lines))
    return None if batch.is_csv else {batch.gradations: lines[:i] + lines[i + 1:]}


def tolerance_at_its_edge(draw, batch):
    """The next finer tolerance, which fewer particles than in the exact match do not meet."""
    if batch.name != "higher/edges":
        return None
    lines = batch.lines(batch.gradations)
    i = draw.choice([i for i, line in enumerate(lines) if "-tolerance\"" in line])
    tolerance = json.loads(lines[i])["tolerances_percent"][0]
    lines[i] = lines[i].replace(f'"{tolerance}"', f'"{Decimal(tolerance) - Decimal("0.000001")}"')
    return {batch.gradations: lines}


def proof_changed(draw, batch, change):
    """A change of one proof without windows, which check.py does not read; nothing where the batch has none."""
    if not batch.is_tolerant:
        return None
    proofs = [proof + "end\n" for proof in "".join(batch.lines(batch.proofs)).split("end\n")[:-1]]
    trees = [i for i, proof in enumerate(proofs) if "\nwindow" not in proof]
    if not trees:
        return None
    i = draw.choice(trees)
    return {batch.proofs: proofs[:i] + change(proofs[i].splitlines(keepends=True)) + proofs[i + 1:]}


def number_in_proof(draw, batch):
    return proof_changed(draw, batch, lambda lines: lines[:3] + [f"particles {int(lines[3].split()[1]) - 1}\n"] + lines[4:])


def mass_in_proof(draw, batch):
    def change(lines):
        i = draw.choice([i for i, line in enumerate(lines) if line.startswith("class ")])
        words = lines[i].split(" ")
        words[3] = other_digit(draw, words[3], 9)
        return lines[:i] + [" ".join(words)] + lines[i + 1:]
    return proof_changed(draw, batch, change)


def leaf_removed(draw, batch):
    def change(lines):
        i = draw.choice([i for i, line in enumerate(lines) if line.startswith("leaf ")])
        return lines[:i] + lines[i + 1:]
    return proof_changed(draw, batch, change)


def multiplier(draw, batch):
    def change(lines):
        i = draw.choice([i for i, line in enumerate(lines) if line.startswith("leaf ")])
        words = lines[i].rstrip("\n").split(" ")
        at = draw.randrange(1, len(words), 2)
        words[at] = str(int(words[at]) + 1)
        return lines[:i] + [" ".join(words) + "\n"] + lines[i + 1:]
    return proof_changed(draw, batch, change)


def larger_match_in_both(draw, batch):
    """A match of twice as many particles, in the answer and in its proof: the tree shows too little."""
    doubled = proof_changed(draw, batch, lambda lines: [
        re.sub(r"^class (\d+) (\d+) (\d+)", lambda w: f"class {w[1]} {2 * int(w[2])} {2 * int(w[3])}",
               re.sub(r"^particles (\d+)", lambda w: f"particles {2 * int(w[1])}", line)) for line in lines])
    if doubled is None:
        return None
    before, after = ("".join(text).split("end\n") for text in (batch.lines(batch.proofs), doubled[batch.proofs]))
    number = next(i for i, (one, other) in enumerate(zip(before, after)) if one != other)
    lines = batch.lines(batch.answers)
    names = list(dict.fromkeys(line.split(",")[0] for line in lines[1:]))
    for i, line in enumerate(lines):
        fields = line.split(",")
        if fields[0] == names[number] and fields[5] != "0":
            lines = with_field(lines, i, 5, str(2 * int(fields[5])))
    return {**doubled, batch.answers: lines}


def proof_removed(draw, batch):
    return proof_changed(draw, batch, lambda lines: [])


def question(draw, batch):
    """Another question in batches.csv: a finer tolerance, or another number of particles."""
    finer = {"retained:1%": "retained:0.999%", "passing:0.5%": "passing:0.499%", "retained:0.1%": "retained:0.099%",
             "passing:0.05%": "passing:0.0499%", "--at-least 1000": "--at-least 1001",
             "--tolerance laboratory": "--tolerance passing:0.1%"}
    asked = [words for words in finer if words in batch.options]
    return {"batches.csv": [line.replace(asked[0], finer[asked[0]]) if line.startswith(batch.name + ",") else line
                            for line in batch.lines("batches.csv")]} if asked else None


DAMAGES = (quantity_by_one, quantities_swapped, all_quantities_doubled, size_bound, both_size_bounds, row_removed, row_twice,
           rows_swapped, answer_removed, id_of_row, class_number, opening_of_row, share, name_of_shares, mass, opening,
           id_of_gradation, unit, gradation_removed, tolerance_at_its_edge, number_in_proof, mass_in_proof, leaf_removed,
           multiplier, larger_match_in_both, proof_removed, question)


def damaged_copies(batches):
    """COPIES times what was damaged, in which batch, and the files that are changed; each damage as often as others."""
    draw = random.Random(33)
    for i in range(COPIES):
        damage, changed = DAMAGES[i % len(DAMAGES)], None
        while changed is None:
            batch = draw.choice(batches)
            changed = damage(draw, batch)
        yield damage.__name__, batch, changed


def check_copies(checker, folder, batches):
    """Each damaged copy is refused: as wrong, with the place, or because it makes no gradation."""
    for what, batch, changed in damaged_copies(batches):
        for file, lines in changed.items():
            (folder / file).write_text("".join(lines), encoding="utf-8")
        rows = csv.reader((folder / "batches.csv").read_text(encoding="utf-8").splitlines())
        try:
            said = checker.check(folder, *next(row for row in rows if row[0] == batch.name))
            expect(False, f"{batch.name}: {what} is accepted: {said}")
        except checker.Wrong as wrong:
            expect(str(wrong).startswith(batch.name), f"{batch.name}: {what}: it is not said where: {wrong}")
        except ValueError as error:
            expect(what in ("opening", "unit"), f"{batch.name}: {what}: {error!r}")
        for file in changed:
            shutil.copy(SET / file, folder / file)


def run(folder, *batches):
    return subprocess.run([folder / "check.py", *batches], capture_output=True, text=True)


def check_program(folder, batches):
    """What check.py prints, and how it exits."""
    whole = run(folder)
    expect(whole.returncode == 0 and whole.stderr == "", f"the set is refused: {whole.stdout[-500:]}{whole.stderr[-500:]}")
    printed = [line.split(": ") for line in whole.stdout.splitlines()]
    expect([name for name, _ in printed] == [batch.name for batch in batches], f"other batches: {whole.stdout}")
    page = (folder / "README.md").read_text(encoding="utf-8")
    expect(all(line in page for line in whole.stdout.splitlines() if ";" in line), "README does not say what is left out")
    expect(sum(int(said.split()[0]) for _, said in printed) == 3222, "other answers")
    answers = folder / "lower/sands.answers.csv"
    text = answers.read_text(encoding="utf-8")
    for damaged, code, part in (
            (text.replace(",819,", ",818,"), 1, "lower/sands.answers.csv:2: quantity 818 of 1484, where the smallest match"),
            (text.replace(",819,", ",many,"), 2, "lower/sands: "), (text.replace(",819,", ","), 2, "7 columns"),
            ("", 2, "lower/sands: "), (None, 2, "No such file")):
        answers.unlink()
        if damaged is not None:
            answers.write_text(damaged, encoding="utf-8")
        done = run(folder, "lower/sands")
        expect(done.returncode == code and part in done.stdout + done.stderr and "Traceback" not in done.stderr,
               f"exit {done.returncode}, not {code} with {part!r}: {done.stdout}{done.stderr}")
        answers.write_text(text, encoding="utf-8")
    done = run(folder, "lower/sand")
    expect((done.returncode, done.stdout) == (2, "") and "no such batch" in done.stderr, f"an unknown batch: {done.stderr}")


def main():
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work) / "set"
        shutil.copytree(SET, folder)
        checker = program(folder / "check.py")
        lines = (folder / "check.py").read_text(encoding="utf-8").splitlines()
        expect(len(lines) <= 200, f"check.py has {len(lines)} lines")
        with open(folder / "batches.csv", encoding="utf-8") as table:
            batches = [Batch(*row) for row in list(csv.reader(table))[1:]]
        check_program(folder, batches)
        check_copies(checker, folder, batches)
        copies = COPIES + check_kinds(random.Random(33), program, folder, expect)
    page = (SET / "README.md").read_text(encoding="utf-8")
    expect(f"in {copies - COPIES} ways" in page and f"{COPIES} ways" in page, "README has another number of damages")
    print(f"{copies} damaged copies, {len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
