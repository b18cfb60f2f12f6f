"""The batches of the reference set, their gradations, proofs, questions and answers."""

import collections
import csv
import itertools
import os
import pathlib
import re
import shutil
import sys

HOME = pathlib.Path(__file__).resolve().parent


def program(name):
    """The program of exactmdm on PATH, or in the folder that MDM_BIN names."""
    found = shutil.which(name, path=os.environ.get("MDM_BIN"))
    if found is None:
        sys.exit(f"There is no {name}: build exactmdm, and set MDM_BIN to the folder of its programs")
    return os.path.abspath(found)


def batches():
    """The rows of batches.csv."""
    with open(HOME / "batches.csv", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def proofs(row):
    """The gradation and the proof of each line of a batch, as texts."""
    gradations = (HOME / row["gradations"]).read_text(encoding="utf-8")
    if row["gradations"].endswith(".csv"):
        yield gradations, (HOME / (row["batch"] + ".proof")).read_text(encoding="utf-8")
        return
    stream = (HOME / (row["batch"] + ".proofs")).read_bytes()
    lines = gradations.splitlines(keepends=True)
    for entry in (HOME / (row["batch"] + ".proofs.index")).read_text(encoding="utf-8").splitlines()[1:]:
        line, offset, length = map(int, entry.split())
        yield lines[line - 1], stream[offset:offset + length].decode()


def answers(row):
    """The answers of a batch: of each line the classes with particles, by (class, quantity, size_lo, size_hi)."""
    with open(HOME / (row["batch"] + ".answers.csv"), encoding="utf-8") as table:
        for _, classes in itertools.groupby(csv.reader(itertools.islice(table, 1, None)), lambda fields: fields[0]):
            yield [(c[1], c[5], c[6], c[7]) for c in classes if c[5] != "0"]


def witness(proof):
    """The same of the sample in a proof."""
    words = [line.split() for line in proof.splitlines() if line.startswith("class ")]
    return [(w[1], w[2], w[-2], w[-1]) for w in words]


def questions(row):
    """The questions of a batch as a verdict says them, and how many proofs are of each."""
    with open(HOME / "questions.csv", encoding="utf-8") as table:
        return collections.Counter({q["question"]: int(q["proofs"]) for q in csv.DictReader(table)
                                    if q["batch"] == row["batch"]})


def compare(row, verdicts):
    """What is wrong with the verdicts on the proofs of a batch, in their order: each is of the number of its answer, which is
    the sample in its proof, and all are of the questions of the batch."""
    asked = collections.Counter()
    wrong = []
    for number, (verdict, answer, (_, proof)) in enumerate(zip(verdicts, answers(row), proofs(row)), 1):
        said = re.fullmatch(r'accepted: N = (\d+) is (.* that matches) "[^"]*" (.*)', verdict)
        if said is None:
            wrong.append(f"answer {number}: {verdict}")
            continue
        asked[f"{said[2]} {said[3]}"] += 1
        if int(said[1]) != sum(int(quantity) for _, quantity, _, _ in answer) or answer != witness(proof):
            wrong.append(f"answer {number}: it is not what its proof says")
    if not len(verdicts) == asked.total() == int(row["lines"]):
        wrong.append(f"{asked.total()} proofs accepted of {row['lines']}")
    wrong += [f"{count} proofs of another question: {question}" for question, count in (asked - questions(row)).items()]
    return wrong
