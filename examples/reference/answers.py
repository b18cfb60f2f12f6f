"""What mdm answers, for the programs that make the set; and the ways of writing that they share."""

import csv
import pathlib
import subprocess

from proofs import program

MDM = program("mdm")


def mdm(*arguments, text="", codes=(0,)):
    """What mdm prints; any other exit code ends it all."""
    run = subprocess.run([MDM, *map(str, arguments)], input=text, stdout=subprocess.PIPE, text=True)
    if run.returncode not in codes:
        raise subprocess.CalledProcessError(run.returncode, run.args)
    return run.stdout


def write_table(path, header, rows):
    """CSV."""
    with open(path, "w", encoding="utf-8", newline="") as table:
        csv.writer(table, lineterminator="\n").writerows([header, *rows])


def write_stream(path, texts):
    """Certificates one after the other, and their index, of the lines 1, 2, ..."""
    ends, entries = 0, ["mdm-proofs 1"]
    for number, text in enumerate(texts, 1):
        entries.append(f"{number} {ends} {len(text)}")
        ends += len(text)
    pathlib.Path(path).write_text("".join(texts))
    pathlib.Path(f"{path}.index").write_text("\n".join(entries) + "\n")
