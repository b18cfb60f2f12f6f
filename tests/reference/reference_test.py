#!/usr/bin/python3
"""reference_test.py BIN SOURCE: the reference set of SOURCE/examples is what its `make` makes with the programs in BIN.

And its files are verified, changed ones refused, its pages right, and the programs on its page judge a solver as they say. R and
jsonlite may be missing unless MDM_REQUIRE_TOOLS is set in the environment.
"""

import csv
import filecmp
import fractions
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections import Counter

BIN, SOURCE = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
SET = SOURCE / "examples/reference"
DEVELOPMENT = BIN.parent / "proofs/coq"
ENVIRONMENT = dict(os.environ, MDM_BIN=str(BIN), PATH=f"{BIN}:{os.environ['PATH']}", LC_ALL="C")

# A solver that knows the answers to higher/long-numbers, but for the last digit of the largest quantity.
NEARLY_RIGHT = """#!/usr/bin/python3
import csv, json, sys
rows = list(csv.DictReader(open("higher/long-numbers.answers.csv")))
largest = max(rows, key=lambda row: int(row["quantity"]))
largest["quantity"] = str(int(largest["quantity"]) + 1)
name = json.load(sys.stdin)["id"]
print(json.dumps({"quantities": [int(row["quantity"]) for row in rows if row["id"] == name]}))
"""

failures = []


def check(condition, message):
    if not condition:
        failures.append(message)
        print("failed:", message)


def run(folder, *command):
    return subprocess.run(command, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)


def verify(folder, program, expected, part):
    """The program exits so, and prints the part."""
    done = run(folder, f"./{program}")
    check(done.returncode == expected, f"{program}: exit {done.returncode}: {done.stdout[-500:]}{done.stderr[-500:]}")
    check(part in done.stdout + done.stderr, f"{program} does not say {part!r}: {done.stdout[-300:]}{done.stderr[-300:]}")


def check_same(made):
    """Every byte of the set, and no other file."""
    def files(folder):
        return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    check(files(made) == files(SET), f"other files: {set(files(made)) ^ set(files(SET))}")
    different = filecmp.cmpfiles(made, SET, files(SET), shallow=False)[1:]
    check(different == ([], []), f"made again, these differ: {different}")


def changed(folder, file, old, new, program, expected, part):
    """A file with `new` in the place of `old` is refused."""
    before = (folder / file).read_bytes()
    check(old in before, f"{file} has no {old}")
    (folder / file).write_bytes(before.replace(old, new, 1))
    verify(folder, program, expected, part)
    (folder / file).write_bytes(before)


def check_package(folder):
    """datapackage.json, of every file below and every table."""
    package = json.loads((folder / "datapackage.json").read_text(encoding="utf-8"))
    for resource in package["resources"]:
        content = (folder / resource["path"]).read_bytes()
        check(resource["bytes"] == len(content), f"{resource['path']}: bytes")
        check(resource["hash"] == "sha256:" + hashlib.sha256(content).hexdigest(), f"{resource['path']}: hash")
    names = [resource["name"] for resource in package["resources"]]
    check(len(set(names)) == len(names), "names of resources repeat")
    check({"average/suite-2750.proofs", "higher/ties.json"} <= {r["path"] for r in package["resources"]}, "files missing")


def particles(folder, batch):
    """The number of particles of each id."""
    counts = Counter()
    with open(folder / f"{batch}.answers.csv", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            counts[row["id"]] += int(row["quantity"])
    return counts


def check_pages(folder):
    """Numbers on the pages are those of the answers."""
    page = (folder / "lower/README.md").read_text(encoding="utf-8")
    columns = [particles(folder, "lower/sands" + ending) for ending in ("", "-retained", "-passing", "-laboratory")]
    for sand in columns[0]:
        row = next(line for line in page.splitlines() if line.startswith(f"| {sand} |"))
        check([cell.strip() for cell in row.split("|")[3:7]] == [str(column[sand]) for column in columns], f"page: {row}")
    largest = max(particles(folder, "average/suite-2750").values())
    check(f"{largest:,}" in (folder / "average/README.md").read_text(encoding="utf-8"), f"{largest} is not on the page")
    with open(folder / "batches.csv", encoding="utf-8") as table:
        levels = Counter()
        for row in csv.DictReader(table):
            levels[row["batch"].split("/")[0]] += int(row["lines"])
            lines = particles(folder, row["batch"])
            check(len(lines) == int(row["lines"]), f"{row['batch']}: {len(lines)} answers")
            check(row["batch"].split("/")[1].split("-")[0] in (folder / row["batch"]).parent.joinpath("README.md").read_text(
                encoding="utf-8"), f"{row['batch']} is not on its page")
    page = (folder / "README.md").read_text(encoding="utf-8")
    for level, lines in levels.items():
        check(f"[{level}]({level})" in page and f"| {lines:,} |" in page, f"README: {level} has {lines} answers")
    run(folder, "mdm", "batch", "higher/edges.jsonl", "--quiet", "-o", "exact.answers.csv")
    exact, edges = particles(folder, "exact"), particles(folder, "higher/edges")
    (folder / "exact.answers.csv").unlink()
    for name, count in edges.items():
        check((count < exact[name]) == name.endswith("-tolerance"), f"{name}: {count} and {exact[name]} are no edge")


def check_levels(folder):
    """The numbers of right answers of the float solver on the page of the level higher."""
    page = (folder / "higher/README.md").read_text(encoding="utf-8")
    found = re.findall(r"\*\*([\w-]+)\*\* \((\d+) lines\)[^*]*? (\d+) right", page)
    check(len(found) == 8, f"{len(found)} batches of the level higher say what a float solver has right")
    for name, lines, right in found:
        run(folder, "mdm", "crosscheck", f"higher/{name}.jsonl", "--solver", shlex.quote(str(SOURCE / "examples/04-cross-check/float_solver")),
            "--quiet", "-j", "2", "-o", "rows.csv")
        with open(folder / "rows.csv", encoding="utf-8") as table:
            verdicts = [row["verdict"] for row in csv.DictReader(table)]
        check((len(verdicts), verdicts.count("minimal")) == (int(lines), int(right)), f"{name}: {Counter(verdicts)}")
    (folder / "rows.csv").unlink()


def blocks(page):
    """The indented blocks of a page."""
    block = []
    for line in page.splitlines() + ["end"]:
        if line.startswith("    ") or (not line and block):
            block.append(line[4:])
        elif block:
            yield "\n".join(block).rstrip("\n") + "\n"
            block = []


def check_kinds(folder):
    """The other kinds than levels: their numbers on the pages, the commands there, and what verify-proofs says of damage."""
    def lines(name):
        return (folder / name).read_text(encoding="utf-8").splitlines()
    counts = {"samples": len(lines("samples/samples.answers.csv")) - 1, "number": len(lines("number/number.answers.csv")) - 1,
              "blends": len(lines("blends/published.answers.jsonl")) + len(lines("blends/drawn.answers.jsonl")),
              "materials": len(lines("materials/materials.csv")) - 1, "judgements": len(lines("judgements/judgements.answers.csv")) - 1}
    page = "\n".join(lines("README.md"))
    for kind, count in counts.items():
        check(re.search(rf"\| \[{kind}\]\({kind}\) \| .* \| {count} \|", page), f"README: {kind} has {count} answers")
    total = sum(counts.values()) + sum(int(row.split(",")[2]) for row in lines("batches.csv")[1:])
    check(f"{total:,} reference answers" in (SOURCE / "README.md").read_text(encoding="utf-8"), f"the set has {total} answers")
    for kind in ("samples", "number", "materials", "judgements"):
        check(f"{counts[kind]} questions" in " ".join(lines(f"{kind}/README.md")), f"{kind}/README.md: {counts[kind]} questions")
    none = sum('"none"' in line for line in lines("blends/drawn.answers.jsonl"))
    check(f"for {none} of them there is no blend" in " ".join(lines("blends/README.md")), f"blends/README.md: {none} have none")
    for block in blocks("\n".join(lines("samples/README.md"))):
        for command in block.splitlines():
            check(run(folder / "samples", *shlex.split(command)).returncode == 0, f"samples/README.md: {command}")
    for name in ("published", "drawn"):
        judged = run(folder / "blends", "mdm", "crosscheck", f"{name}.jsonl", f"{name}.answers.jsonl", "--format", "csv", "--quiet")
        verdicts = [row["verdict"] for row in csv.DictReader(judged.stdout.splitlines())]
        check(verdicts == ["best"] * len(lines(f"blends/{name}.answers.jsonl")), f"blends/{name}: {Counter(verdicts)}")
    version = "".join(lines("VERSION"))
    check(f"version: {version}" in lines("CITATION.cff") and f"## {version}" in lines("CHANGES.md"), f"another version than {version}")
    check_damaged_kinds(folder)


def check_damaged_kinds(folder):
    """verify-proofs names each certificate that is of another answer, of another question, or false."""
    damages = (("samples", "athabasca-sand-one-more", "samples.answers.csv", ",1486,", ",1487,"),
               ("samples", "hostun-rf-sand-exact", "hostun-rf-sand-exact.proof", "verdict match", "verdict outside"),
               ("samples", "limestone-pfc-outside", "samples.answers.csv", "limestone-pfc-outside.csv,,no match,12078,0,1",
                "limestone-pfc-outside.csv,,no match,12078,1,0"),
               ("number", "eighths-exact", "eighths-exact.proof", "1000", "999"),
               ("number", "twenty-retained-5", "number.answers.csv", "5%,10,1 0", "5%,10,0 1"),
               ("blends/published", "tutorsglobe-4", "tutorsglobe-4/limits.csv", "0.4,22,28", "0.4,22,27.9"),
               ("blends/published", "doh-cold", "published.answers.jsonl", '["6/25", "18/25"', '["18/25", "6/25"'),
               ("blends/drawn", "drawn-02", "drawn.answers.jsonl", "3859/200", "3859/201"),
               ("blends/drawn", "drawn-01", "drawn.jsonl", '"cost": "', '"cost": "1'),
               ("materials", "tie-exact", "tie-exact.proof", "particles 3", "particles 2"),
               ("materials", "edge-retained-1.1", "materials.csv", "retained:1.1%", "retained:1.2%"),
               ("materials", "eight-exact", "materials.answers.csv", "eight-exact,46,1,", "eight-exact,46,2,"),
               ("materials", "gold-exact", "materials.answers.csv", "gold-exact,75,", "gold-exact,74,"))
    kept = {}
    for kind, _, name, old, new in damages:
        path = folder / kind.split("/")[0] / name
        text = path.read_text(encoding="utf-8")
        kept.setdefault(path, text)
        check(old in text, f"{path} has no {old}")
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
    done = run(folder, "./verify-proofs")
    check(done.returncode == 1 and "5 batches failed" in done.stdout, f"damaged kinds: {done.stdout[-500:]}{done.stderr[-500:]}")
    named = re.findall(r"FAILED: (.*): (.*): its certificate", done.stdout)
    check(sorted(named) == sorted((kind, what) for kind, what, *_ in damages), f"these are named: {named}")
    for path, text in kept.items():
        path.write_text(text, encoding="utf-8")


def check_other_question(folder, program):
    """Proofs that one particle matches within 100 % are accepted, each by itself, and noticed."""
    stream, index = (folder / f"average/suite-2750.proofs{ending}" for ending in ("", ".index"))
    kept = stream.read_bytes(), index.read_bytes()
    proofs, entries, offset = [], ["mdm-proofs 1"], 0
    for number, line in enumerate((folder / "average/suite-2750.jsonl").read_text().splitlines(), 1):
        sizes = sorted(json.loads(line)["sizes"], key=fractions.Fraction)
        proofs.append(f"mdm-certificate 1\nlaw 3\nretained 100\nparticles 1\nclass {len(sizes) - 1} 1 "
                      f"{fractions.Fraction(sizes[-1]) ** 3} {sizes[-1]} {sizes[-1]}\nleaf 1 N 1 n\nend\n")
        entries.append(f"{number} {offset} {len(proofs[-1])}")
        offset += len(proofs[-1])
    stream.write_text("".join(proofs))
    index.write_text("\n".join(entries) + "\n")
    alone = run(folder, str(BIN / "mdm-check"), "--suite", "average/suite-2750.jsonl", stream)
    check("2750 accepted as the smallest number of particles that matches within a tolerance (retained within 100%"
          in alone.stdout.splitlines()[-1], f"the summary hides the question: {alone.stdout[-500:]}")
    others = 748 if program == "verify-proofs" else 616
    verify(folder, program, 1, f"{others} proofs accepted, 1 batches failed")
    stream.write_bytes(kept[0])
    index.write_bytes(kept[1])


def check_theorems(folder):
    """With Coq's compiled development every line of the batches of real sands is a theorem; a changed proof is none."""
    if not (shutil.which("coqc") and (DEVELOPMENT / "Answer.vo").exists()):
        return
    batches = (folder / "batches.csv").read_text(encoding="utf-8")
    lower = [line for line in batches.splitlines(keepends=True) if line.startswith(("batch,", "lower/"))]
    (folder / "batches.csv").write_text("".join(lower), encoding="utf-8")
    ENVIRONMENT["MDM_COQ"] = str(DEVELOPMENT)
    verify(folder, "verify-proofs-formally", 0, "168 proofs accepted, 0 batches failed; 24 are theorems of Coq")
    changed(folder, "lower/sands.proofs", b"particles 1485", b"particles 1484", "verify-proofs-formally", 1, "18 are theorems of Coq")
    del ENVIRONMENT["MDM_COQ"]
    (folder / "batches.csv").write_text(batches, encoding="utf-8")


def check_judges(folder):
    """The programs on the page judge the float solver as the page says; those of this folder alone see a last digit of 41."""
    solver = folder / "my-solver"
    shutil.copy(SOURCE / "examples/04-cross-check/float_solver", solver)
    shell, printed, python, printed_by_python, in_r, printed_by_r = list(blocks((folder / "README.md").read_text(encoding="utf-8")))[:6]
    judges = [(python, ("/usr/bin/python3", "-c"), printed_by_python), (in_r, ("Rscript", "-e"), printed_by_r)]
    if not (shutil.which("Rscript") and run(folder, "Rscript", "-e", "library(jsonlite)").returncode == 0):
        check("MDM_REQUIRE_TOOLS" not in os.environ, "there is no R with jsonlite: r-base-core r-cran-jsonlite")
        judges.pop()
    for text, interpreter, expected in [(shell, ("sh", "-c"), printed), *judges]:
        check(len(text.splitlines()) <= 11, f"more than ten lines or so: {text}")
        check_prints(folder, interpreter, text, expected)
    solver.write_text(NEARLY_RIGHT, encoding="utf-8")
    for text, interpreter, _ in judges:
        check_prints(folder, interpreter, text.replace("higher/ties", "higher/long-numbers"), "39 of 40 are right\n")
    solver.unlink()


def check_prints(folder, interpreter, text, expected):
    done = run(folder, *interpreter, text)
    check(done.stdout == expected, f"{interpreter} prints {done.stdout!r}, not {expected!r}: {done.stderr[-500:]}")


def main():
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work) / "set"
        made = run(SET, "./make", str(folder))
        if made.returncode != 0:
            sys.exit(f"make fails: {made.stderr}")
        check_same(folder)
        verify(folder, "verify-integrity", 0, "files are as they were made")
        verify(folder, "verify-proofs", 0, "proofs accepted, 0 batches failed; bounds of 0 open problems failed")
        verified = (BIN / "mdm-check-verified").exists()
        if verified:
            verify(folder, "verify-proofs-formally", 0, "proofs accepted, 0 batches failed")
        for file, old, new, program, part in (
                ("average/suite-2750.jsonl", b"3.61169", b"3.61168", "verify-integrity", "FAILED"),
                ("average/suite-2750.jsonl", b"3.61169", b"9.61169", "verify-proofs", "refused"),
                ("higher/ties.answers.csv", b"298817,2,", b"298817,3,", "verify-proofs", "59 proofs accepted of 60"),
                ("open.csv", b",931218389", b",931218390", "verify-proofs", "open/bimodal-100-total-1: its proof has other bounds"),
                ("lower/sands.proofs", b"particles 1485", b"particles 1484", "verify-proofs", "FAILED: lower/sands:"),
                ("lower/sands.proofs", b"particles 1485", b"particles 1484", "verify-proofs-formally", "5 proofs accepted of 6"),
                ("higher/ties.answers.csv", b"298817,2,", b"298817,3,", "verify-proofs-formally", "not what its proof says"),
                ("questions.csv", b"lower/sands-retained,6,the", b"lower/sands-retained,5,the", "verify-proofs",
                 "1 proofs of another question")):
            if verified or program != "verify-proofs-formally":
                changed(folder, file, old, new, program, 1, part)
        for program in ("verify-proofs", "verify-proofs-formally") if verified else ("verify-proofs",):
            check_other_question(folder, program)
        (folder / "new").write_text("")
        verify(folder, "verify-integrity", 1, "SHA256SUMS does not list")
        (folder / "new").unlink()
        check_theorems(folder)
        check_package(folder)
        check_pages(folder)
        check_kinds(folder)
        check_levels(folder)
        check_judges(folder)
        check_same(folder)
    print(f"{len(failures)} failures, {'with' if verified else 'without'} mdm-check-verified")
    return 1 if failures else 0


sys.exit(main())
