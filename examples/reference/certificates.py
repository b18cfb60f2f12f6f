"""The certificates of samples, of sets by number, of blends and of materials: the files that a checker is given with each, and
whether the certificate says what its answer says. That what it says is true is the checker's business.

Each certificate is given as its name, the folder and the names of the files, whether it says so, and what the checker has to
print of it."""

import csv
import filecmp
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

from proofs import HOME, witness

sys.path.append(str(HOME / "blends"))
from problem_files import claim, write_files

KINDS = ("retained", "passing", "total")


def table(name):
    with open(HOME / name, encoding="utf-8") as rows:
        return list(csv.DictReader(rows))


def asked(options):
    """The lines that state a tolerance."""
    found = dict(word.split(":") for word in options.split()[1::2])
    return [f"{kind} {found[kind].removesuffix('%')}" for kind in KINDS if kind in found]


def says_sample(answer, lines):
    """Question, particles, those outside and the verdict are those of the answer; the errors are enclosed."""
    outside = [f"{side} {answer[side]}" for side in ("below", "above") if answer[side] != "0"]
    head = ["mdm-certificate sample 1", "law 3", *asked(answer["options"]), f"particles {answer['particles']}", *outside]
    errors = {line.split("-")[0]: list(map(Fraction, line.split()[-2:])) for line in lines if "-error " in line}
    encloses = all(errors[kind][0] <= Fraction(answer[f"{kind}_error_lo"]) <= Fraction(answer[f"{kind}_error_hi"]) <= errors[kind][1]
                   for kind in KINDS)
    matches = ("verdict match" in lines) == (answer["verdict"] == "match")
    return lines[:len(head)] == head and lines[len(head)].startswith("class 1 ") and encloses and matches


def samples():
    for answer in table("samples/samples.answers.csv"):
        proof = f"{answer['id']}.proof"
        says = says_sample(answer, (HOME / "samples" / proof).read_text().splitlines())
        yield answer["id"], HOME / "samples", [answer["gradation"], answer["sample"], proof], says, ""


def number():
    for answer in table("number/number.answers.csv"):
        proof = f"{answer['id']}.proof"
        lines = ["mdm-certificate number 1", *asked(answer["options"]), f"particles {answer['particles']}",
                 f"quantities {answer['quantities']}", "end"]
        says = (HOME / "number" / proof).read_text().splitlines() == lines
        yield answer["id"], HOME / "number", [answer["gradation"], proof], says, ""


def blends(name):
    """The problems of a batch, with their answers."""
    return [[json.loads(line) for line in (HOME / f"blends/{name}{ending}").read_text().splitlines()]
            for ending in (".jsonl", ".answers.jsonl")]


def of_blend(problem, answer, folder, files):
    lines = claim(problem, answer)
    value = f" than its {answer['value']} (" if "value" in answer and problem["aim"] != "none" else ""
    says = (folder / "blend.proof").read_text().splitlines()[:len(lines)] == lines and problem["id"] == answer["id"]
    return answer["id"], folder, ["limits.csv", *files, "blend.proof"], says, value


def published():
    """The files of each problem are in its folder, as its line and its source have them."""
    sources = {row["id"]: row["source"] for row in table("blends/sources.csv")}
    for problem, answer in zip(*blends("published"), strict=True):
        folder = HOME / "blends" / problem["id"]
        with tempfile.TemporaryDirectory() as work:
            files = write_files(problem, pathlib.Path(work), f"# {sources[problem['id']]}\n")
            names = sorted(path.name for path in pathlib.Path(work).iterdir())
            same = filecmp.cmpfiles(work, folder, names, shallow=False)[0] == names
        name, *given, says, value = of_blend(problem, answer, folder, files)
        yield name, *given, says and same, value


def drawn():
    """The certificates stand in one stream; limits and stockpiles are in the line."""
    stream = (HOME / "blends/drawn.proofs").read_text()
    entries = (HOME / "blends/drawn.proofs.index").read_text().splitlines()[1:]
    for problem, answer, entry in zip(*blends("drawn"), entries, strict=True):
        _, offset, length = map(int, entry.split())
        with tempfile.TemporaryDirectory() as work:
            folder = pathlib.Path(work)
            files = write_files(problem, folder)
            (folder / "blend.proof").write_text(stream[offset:offset + length])
            yield of_blend(problem, answer, folder, files)


def materials():
    """The sample in a certificate is that of the answer, class by class."""
    rows = table("materials/materials.answers.csv")
    for question in table("materials/materials.csv"):
        answer = [row for row in rows if row["id"] == question["id"]]
        words, particles = question["options"].replace("--tolerance ", "--").replace(":", " ").split(), answer[0]["particles"]
        lines = [f"{option[2:]} {number.removesuffix('%')}" for option, number in zip(words[::2], words[1::2])]
        lines = sorted(["law 3", *lines, f"particles {particles}"])
        proof = (HOME / "materials" / f"{question['id']}.proof").read_text()
        counted = [(row["class"], row["quantity"], row["size_lo"], row["size_hi"]) for row in answer if row["quantity"] != "0"]
        says = sorted(proof.splitlines()[1:len(lines) + 1]) == lines and witness(proof) == counted
        value = f"accepted: N = {particles} is the smallest number of particles"
        yield question["id"], HOME / "materials", [question["gradation"], f"{question['id']}.proof"], says, value


ALL = {"samples": samples, "number": number, "blends/published": published, "blends/drawn": drawn, "materials": materials}


def judge(kind, given, checker):
    """Says how many certificates of a kind the checker accepts, and which it does not; returns their number, 0 if one is wrong."""
    accepted, failed = 0, []
    for name, folder, files, says, value in given:
        run = subprocess.run([checker, *files], cwd=folder, capture_output=True, text=True)
        right = run.returncode == 0 and run.stdout.startswith("accepted: ") and says and value in run.stdout
        accepted += right
        failed += [] if right else [name]
    print(*(f"FAILED: {kind}: {name}: its certificate is refused, or says something else" for name in failed), sep="\n",
          end="\n" * bool(failed))
    print(f"{kind}: {accepted} certificates accepted")
    return 0 if failed else accepted
