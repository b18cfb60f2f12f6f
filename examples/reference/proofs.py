"""The batches of the reference set, their gradations, proofs and answers."""

import csv
import itertools
import os
import pathlib
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
