#!/usr/bin/python3
"""sheets.py MDM [--count N] [--seed K] [--first I] [--kind PART] [--keep FOLDER] [--python FOLDER] [--module FOLDER]

Makes N sheets as laboratories print them (laboratory/), each with every gradation that a careful reader may read of it,
has `mdm batch` read them all, and compares exactly: read right, refused, or misread. No sheet may be misread, and of
the ordinary ones 95 % are to be read. Prints a table by kind and the smallest examples of what is wrong; --keep writes
all sheets that were misread, and all ordinary ones that were refused, into FOLDER. With --python and --module the
Python package and the JavaScript module read the same sheets: they must say what the program says.
"""

import argparse
import collections
import itertools
import pathlib
import random
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
import readers
from laboratory import kinds
from laboratory.truth import Reading

LEAST_SHARE = Fraction(95, 100)  # of the ordinary sheets that are read
IN_MM = {"mm": Fraction(1), "um": Fraction(1, 1000), "m": Fraction(1000), "in": Fraction(254, 10)}


def sheet_of(seed, index):
    """The same for every count of sheets."""
    dice = random.Random(f"{seed} {index}")
    return kinds.chosen(dice)(dice)


def reading_of(answer):
    """What the program read."""
    unit = IN_MM[answer["unit"]]
    masses = {Fraction(c["lower"]) * unit: Fraction(c["mass"]) for c in answer["classes"]}
    masses[Fraction(answer["classes"][-1]["upper"]) * unit] = Fraction(0)
    return Reading.of(masses)


def verdict_of(sheet, answer):
    if answer["status"] == "error":
        return "refused"
    return "right" if reading_of(answer) in sheet.readings else "misread"


def written(sheets, folder):
    """The sheets as files: lists of (index, sheet, name) by the options that they are read with."""
    by_options = collections.defaultdict(list)
    for index, sheet in sheets:
        name = f"{index}.{sheet.ending}"
        (folder / name).write_bytes(sheet.content)
        by_options[sheet.options].append((index, sheet, name))
    return by_options


def without_versions(answer):
    return {key: value for key, value in answer.items() if key != "versions"}


def same_as_python(answer, other):
    """The same refusal; or the same classes, with all notes of the reading."""
    if "error" in (answer["status"], other["status"]):
        return answer.get("error") == other.get("error")
    return reading_of(answer) == reading_of(other) and set(other["notes"]) <= set(answer["notes"])


def differences(given, folder, files, options, answers):
    """What Python and JavaScript say that the program does not."""
    names = [name for _, _, name in files]
    found = []
    if given.python:
        said = readers.by_program(given.program.resolve(), folder, names, options, "keyword")
        others = readers.by_python(given.python.resolve(), folder, names, options)
        found += [("Python", name, a, b) for name, a, b in zip(names, said, others) if not same_as_python(a, b)]
    if given.module:
        known = [(name, a) for name, a in zip(names, answers) if not name.endswith(".xlsx")]
        others = readers.by_module(given.module.resolve(), given.node, folder, [name for name, _ in known], options)
        found += [("JavaScript", name, a, b) for (name, a), b in zip(known, others)
                  if without_versions(a) != without_versions(b)]
    return found


def judge(given, sheets, folder):
    """(index, sheet, verdict, answer) of all, and the differences between the ways of reading."""
    results, found = [], []
    for options, files in written(sheets, folder).items():
        answers = readers.by_program(given.program.resolve(), folder, [name for _, _, name in files], options)
        results += [(index, sheet, verdict_of(sheet, answer), answer) for (index, sheet, _), answer in zip(files, answers)]
        found += differences(given, folder, files, options, answers)
    return results, found


def table(results):
    """Lines by kind."""
    counts = collections.defaultdict(collections.Counter)
    for _, sheet, verdict, _ in results:
        counts[sheet.grade, sheet.kind][verdict] += 1
    lines = [f"{'':10} {'':38} {'right':>6} {'refused':>8} {'misread':>8}"]
    for (grade, kind), verdicts in sorted(counts.items(), key=lambda item: (kinds.GRADES.index(item[0][0]), item[0][1])):
        lines.append(f"{grade:10} {kind:38} {verdicts['right']:6} {verdicts['refused']:8} {verdicts['misread']:8}")
    return lines


def share_lines(results):
    """The share of the ordinary sheets that is read, by language and by medium."""
    ordinary = [(sheet, verdict) for _, sheet, verdict, _ in results if sheet.grade == "ordinary"]
    lines = []
    for what in ("language", "medium"):
        counts = collections.defaultdict(collections.Counter)
        for sheet, verdict in ordinary:
            counts[getattr(sheet, what)][verdict == "right"] += 1
        lines.append(f"ordinary, read by {what}: " + ", ".join(
            f"{name} {100 * c[True] / (c[True] + c[False]):.1f} %" for name, c in sorted(counts.items())))
    return lines


def shown_reading(reading):
    shares = [f"{float(opening):.6g}: {float(100 * share):.4g}" for opening, share in reversed(reading.shares)]
    return "{" + ", ".join(shares) + "} % by mm"


def shown(index, sheet, answer):
    """An example: the sheet, what was read or said, what is right."""
    lines = [f"--- {index}: {sheet.kind} ({sheet.grade}, {sheet.language}, {sheet.medium}) {' '.join(sheet.options)}"]
    if sheet.medium == "workbook":
        lines.append("(a workbook; --keep writes it)")
    else:
        encoding = "utf-16" if sheet.content[:2] == b"\xff\xfe" else "utf-8-sig"
        try:
            lines.append(sheet.content.decode(encoding).rstrip())
        except UnicodeDecodeError:
            lines.append(sheet.content.decode("cp1252").rstrip())
    if answer["status"] == "error":
        return "\n".join([*lines, f"refused: {answer['error']}"])
    lines.append(f"read:  {shown_reading(reading_of(answer))}")
    lines += [f"right: {shown_reading(reading)}" for reading in sheet.readings] or ["right: nothing, it contradicts itself"]
    return "\n".join(lines + [f"note:  {note}" for note in answer["notes"]])


def examples(results, verdict, grade=None, most=6):
    """The smallest of each kind and reason."""
    smallest = {}
    chosen = [r for r in results if r[2] == verdict and grade in (None, r[1].grade)]
    for index, sheet, _, answer in sorted(chosen, key=lambda r: len(r[1].content)):
        reason = answer.get("error", "").split(":")[-1]
        smallest.setdefault((sheet.kind, reason), (index, sheet, answer))
    return [shown(*example) for example in itertools.islice(smallest.values(), most)]


def keep(results, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for index, sheet, verdict, answer in results:
        if verdict == "misread" or (verdict == "refused" and sheet.grade == "ordinary"):
            name = f"{verdict}-{sheet.kind.replace(' ', '-')}-{index}"
            (folder / f"{name}.{sheet.ending}").write_bytes(sheet.content)
            (folder / f"{name}.said").write_text(shown(index, sheet, answer) + "\n", encoding="utf-8")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=4000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="the number of the first sheet")
    parser.add_argument("--kind", default="", help="only kinds with these words")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--python", type=pathlib.Path, help="the folder with the package exactmdm")
    parser.add_argument("--module", type=pathlib.Path, help="the folder of the JavaScript module")
    parser.add_argument("--node", default="node")
    parser.add_argument("--refused", type=int, default=0, help="print so many refusals of ordinary sheets")
    return parser.parse_args()


def main():
    given = arguments()
    numbered = ((i, sheet_of(given.seed, i)) for i in range(given.first, given.first + given.count))
    sheets = [(i, sheet) for i, sheet in numbered if given.kind in sheet.kind]
    with tempfile.TemporaryDirectory() as folder:
        results, found = judge(given, sheets, pathlib.Path(folder))
    if given.keep:
        keep(results, given.keep)
    ordinary = [verdict for _, sheet, verdict, _ in results if sheet.grade == "ordinary"]
    misread = sum(verdict == "misread" for _, _, verdict, _ in results)
    share = Fraction(ordinary.count("right"), max(len(ordinary), 1))
    print(*examples(results, "misread"), *examples(results, "refused", "ordinary", given.refused), sep="\n")
    print(*table(results), *share_lines(results), sep="\n")
    print(f"{len(results)} sheets: {misread} misread; {100 * float(share):.2f} % of {len(ordinary)} ordinary ones read")
    for way, name, answer, other in found[:3]:
        print(f"{way} reads {name} otherwise:\n{without_versions(answer)}\n{without_versions(other)}")
    if given.python or given.module:
        print(f"{len(found)} differences between the ways of reading")
    return 1 if misread or found or share < LEAST_SHARE else 0


if __name__ == "__main__":
    sys.exit(main())
