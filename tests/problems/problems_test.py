#!/usr/bin/python3
"""problems_test.py MDM [COUNT]: the integer programs of `mdm convert --problem`, solved by other solvers.

z3 solves smt2, and lp, mps and json as this test reads them itself, exactly; GLPK and CBC solve lp and mps of exact matches,
Gecode mzn and clasp opb. The least sum is that of mdm solve, and mdm crosscheck finds the counts to be a smallest match.
Exits with 77 where a solver is missing, unless MDM_REQUIRE_TOOLS is set in the environment.
"""

import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

MDM = pathlib.Path(sys.argv[1]).resolve()
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 24
for tool in ("z3", "glpsol", "cbc", "minizinc", "clasp"):
    if shutil.which(tool) is None:
        print(f"{tool} is missing")
        sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)

failures = []
printed = [""]  # what the last solver said


def expect(what, found, expected):
    if found != expected:
        failures.append(f"{what}: {found!r}, not {expected!r}")


def run(*words, text=None, codes=(0,)):
    done = subprocess.run([*map(str, words)], input=text, capture_output=True, text=True, timeout=120)
    if done.returncode not in codes:
        failures.append(f"{' '.join(map(str, words))}: exit {done.returncode}: {done.stdout[-300:]}{done.stderr[-300:]}")
    return done.stdout


def z3(script):
    """The counts of an optimum, by name, or None."""
    printed[0] = out = run("z3", "-in", text=script, codes=(0, 1))
    if not out.startswith("sat"):
        return None
    return {name: int(value) for name, value in re.findall(r"\((q\d+) (\d+)\)", out)}


def z3_of(rows, variables):
    """Of rows (terms, sense, constant) of an integer program that was read."""
    def number(n):
        return f"(- {-n})" if n < 0 else str(n)

    script = "".join(f"(declare-const {v} {'Int' if v[0] == 'q' else 'Real'})(assert (>= {v} {number(least)}))\n"
                     for v, least in variables.items())
    for terms, sense, constant, where in rows:
        terms = " ".join(f"(* {number(n)} {f'(to_real {v})' if v[0] == 'q' else v})" for v, n in terms)
        row = f"({sense} (+ 0.0 {terms}) {number(constant)})"
        script += f"(assert {f'(=> (>= {where} 1) {row})' if where else row})\n"
    counts = " ".join(v for v in variables if v[0] == "q")
    return z3(f"{script}(minimize (+ 0 {counts}))(check-sat)(get-value ({counts}))")


def read_lp(text):
    text = "\n".join(line for line in text.splitlines() if not line.startswith("\\"))
    goal, rest = text.removeprefix("Minimize\n").split("Subject To\n")
    rows, rest = rest.split("Bounds\n")
    bounds, rest = rest.split("General\n")
    integers = rest.split("End")[0].split()
    assert {term for term in goal.split(":")[1].split() if term != "+"} == set(integers)
    assert all(v[0] == "q" for v in integers)
    found = []
    for name, left, constant in re.findall(r"(\w+):([^:>]*)>= (-?\d+)", rows):
        terms = [(v, int(sign + n)) for sign, n, v in re.findall(r"([+-]) (\d+) (\w+)", left)]
        found.append((terms, ">=", int(constant), None))
    assert max(map(len, text.splitlines())) <= 255
    return found, {v: int(n) for v, n in re.findall(r"(\w+) >= (-?\d+)", bounds)}


def read_mps(text):
    section, rows, right, least, integers, inside = None, {}, {}, {}, set(), False
    for line in text.splitlines():
        if line.startswith("*"):
            continue
        if not line.startswith(" "):
            section = line.split()[0]
            continue
        words = line.split()
        if section == "ROWS" and words[0] == "G":
            rows[words[1]] = []
        elif section == "COLUMNS" and words[1] == "'MARKER'":
            inside = words[2] == "'INTORG'"
        elif section == "COLUMNS":
            if inside:
                integers.add(words[0])
            if words[1] != "particles":
                rows[words[1]].append((words[0], int(words[2])))
        elif section == "RHS":
            right[words[1]] = int(words[2])
        elif section == "BOUNDS" and words[0] == "LO":
            least[words[2]] = int(words[3])
    assert integers == {v for v in least if v[0] == "q"}
    return [(terms, ">=", right.get(name, 0), None) for name, terms in rows.items()], least


def read_json(text):
    tree = json.loads(text)
    rows = [([(v, int(n)) for v, n in row["terms"]], row["sense"], int(row["constant"]), row["where"])
            for row in tree["rows"]]
    return rows, {v["name"]: int(v["least"]) for v in tree["variables"]}


def glpsol(path, kind, folder):
    out = folder / "glpk.txt"
    run("glpsol", f"--{'lp' if kind == 'lp' else 'freemps'}", path, "-o", out)
    printed[0] = out.read_text()
    return {name: int(value) for name, value in re.findall(r"^ +\d+ (q\d+) +\* +(\d+) ", printed[0], re.M)}


def cbc(path, folder):
    out = folder / "cbc.txt"
    run("cbc", path, "-ratioGap", "0", "-solve", "-solution", out)
    printed[0] = out.read_text()
    return {name: int(value) for name, value in re.findall(r"^ +\d+ (q\d+) +(\d+) ", printed[0], re.M)}


def minizinc(path):
    printed[0] = run("minizinc", "--solver", "gecode", path)
    return {name: int(value) for name, value in re.findall(r"(q\d+) = (\d+);", printed[0])}


def clasp(path):
    """The counts are sums of digits, as the comments say."""
    printed[0] = out = run("clasp", "--opt-mode=opt", path, codes=(0, 10, 20, 30))
    answers = re.findall(r"(?:^v .*\n)+", out, re.M)
    true = set(re.findall(r"(?<![-\w])x\d+", answers[-1])) if answers else set()
    return {name: int(least) + sum(int(n) for n, x in re.findall(r"(\d+) (x\d+)", digits) if x in true)
            for name, least, digits in re.findall(r"^\* (q\d+) = (\d+)((?: \+ \d+ x\d+)*)$", path.read_text(), re.M)}


def judge(folder, sand, options, counts, solution, what):
    """mdm crosscheck of the counts, and of what the solver wrote; classes without a variable have no particles."""
    classes = len(sand["sizes"]) - 1
    answer = {"id": sand["id"], "quantities": [str(counts.get(f"q{j + 1}", 0)) for j in range(classes)]}
    (folder / "suite.jsonl").write_text(json.dumps(sand) + "\n")
    (folder / "answers.jsonl").write_text(json.dumps(answer) + "\n")
    rows = run(MDM, "crosscheck", folder / "suite.jsonl", folder / "answers.jsonl", "--format", "csv", *options)
    expect(what, rows.splitlines()[1].split(",")[1], "minimal")
    (folder / "solution.txt").write_text(solution)
    row = run(MDM, "crosscheck", folder / "sand.json", "--solution", folder / "solution.txt", "--format", "csv", *options)
    expect(f"the solution of {what}", row.splitlines()[1:2], rows.splitlines()[1:2])


def random_sand(rng, number):
    k = rng.randint(2, 4)
    sizes = sorted(rng.sample([1, 2, 3, 4, 6, 8, 12, 16], k + 1))
    masses = [rng.choice([0, 1, 1, 2, 3, 5, 7]) if j else rng.randint(1, 4) for j in range(k)]
    return {"id": f"sand {number}", "sizes": [str(x) for x in sizes], "masses": [str(m) for m in masses] + ["0"]}


QUESTIONS = [[], [], ["--min-per-class", "2"], ["--at-least", "9"], ["--law", "power:2"], ["--size-factor", "1.5"],
             ["--tolerance", "retained:5%"], ["--tolerance", "passing:2%"], ["--tolerance", "total:10%", "--at-least", "4"],
             ["--tolerance", "retained:1%", "--min-per-class", "1"]]


def check_question(rng, number, folder, counted):
    sand = random_sand(rng, number)
    options = QUESTIONS[number % len(QUESTIONS)]
    what = f"{sand} {' '.join(options)}"
    file = folder / "sand.json"
    file.write_text(json.dumps(sand))
    answer = json.loads(run(MDM, "solve", file, "--format", "json", *options))
    particles = int(answer["particles"])
    is_exact = not any("tolerance" in word for word in options)
    texts = {}
    for language in ["lp", "mps", "smt2", "json"] + (["mzn", "opb"] if is_exact else []):
        path = folder / f"problem.{language}"
        run(MDM, "convert", file, "--problem", language, "-o", path, *options)
        texts[language] = path.read_text()
    found = {}

    def solved(solver, counts):
        found[solver] = counts, printed[0]

    solved("smt2", z3(texts["smt2"]))
    for language, read in (("lp", read_lp), ("mps", read_mps), ("json", read_json)):
        solved(language, z3_of(*read(texts[language])))
    if is_exact:
        solved("glpk lp", glpsol(folder / "problem.lp", "lp", folder))
        solved("glpk mps", glpsol(folder / "problem.mps", "mps", folder))
        solved("cbc lp", cbc(folder / "problem.lp", folder))
        solved("cbc mps", cbc(folder / "problem.mps", folder))
        solved("opb", clasp(folder / "problem.opb"))
        if number % 3 == 0:
            solved("mzn", minizinc(folder / "problem.mzn"))
    for solver, (counts, solution) in found.items():
        expect(f"{solver}: {what}", counts and sum(counts.values()), particles)
        if counts:
            judge(folder, sand, options, counts, solution, f"{solver}: {what}")
    # Without what makes sides strict some have fewer particles: the test can tell the difference.
    rows, variables = read_json(texts["json"])
    loose = z3_of([(terms, ">=", constant, None) for terms, _, constant, _ in rows], variables)
    counted["loose"] += loose is not None and sum(loose.values()) < particles


def check_refusals(folder):
    file = folder / "sand.csv"
    file.write_text("size_mm,mass\n0.1,20\n0.2,30\n0.4,50\n0.8,0\n")
    for words, message in [
            (["--problem", "qp"], "qp"),
            (["--problem", "opb", "--tolerance", "1%"], "integers alone"),
            (["--problem", "lp", "--solids-volume", "5"], "pi"),
            (["--problem", "lp", "--law", "power:1/3"], "irrational"),
            (["--problem", "lp", "--at-most", "5"], "at-most"),
            (["--problem", "lp", "--format", "csv"], "--format"),
            (["--problem", "lp", "-o", folder / "x.mps"], ".lp"),
            (["-o", folder / "x.lp"], "--problem lp"),
            (["--min-per-class", "2"], "--problem")]:
        done = subprocess.run([MDM, "convert", file, *words], capture_output=True, text=True)
        expect(f"exit of {words}", done.returncode, 2)
        expect(f"output of {words}", done.stdout, "")
        if message not in done.stderr:
            failures.append(f"{words}: {done.stderr!r} lacks {message!r}")
    expect("files that were refused", sorted(path.name for path in folder.glob("x.*")), [])
    long = folder / "long.csv"
    long.write_text("size_mm,mass\n0.1234567,2000000001\n0.2345678,3000000007\n0.4567891,0\n")
    done = subprocess.run([MDM, "convert", long, "--problem", "mzn"], capture_output=True, text=True)
    expect("exit of long numbers in MiniZinc", (done.returncode, "64 bits" in done.stderr), (2, True))


def main():
    rng = random.Random(20261124)
    counted = {"loose": 0}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for number in range(COUNT):
            check_question(rng, number, folder, counted)
        check_refusals(folder)
    if counted["loose"] == 0:
        failures.append("no question has a closed side that would have been a smaller match")
    print(f"{COUNT} questions in every language, {counted['loose']} with fewer particles if no side were open; "
          f"{len(failures)} failures")
    print("\n".join(failures))
    return 1 if failures else 0


sys.exit(main())
