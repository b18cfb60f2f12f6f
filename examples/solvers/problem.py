"""What the adapters share: they read a gradation as JSON, write its problem by `mdm convert --problem` in their
solver's language, and answer as `mdm crosscheck` asks. MDM_BIN may name the folder of mdm, MDM_QUESTION has what is
asked beside the gradation, such as `--tolerance retained:1%`. With --version an adapter says in a line which solver it
runs, or that there is none, and in a second line with which options."""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

MDM = str(pathlib.Path(os.environ["MDM_BIN"], "mdm")) if "MDM_BIN" in os.environ else "mdm"
QUESTION = shlex.split(os.environ.get("MDM_QUESTION", ""))
MISSING = 77


def gradation():
    """The gradation on standard input."""
    return json.load(sys.stdin)


def give_up(reason):
    """Says that there is no answer, and the first error of a text, or its last line, as the reason; and ends."""
    lines = [line.strip() for line in reason.splitlines() if line.strip()] or ["no counts"]
    error = next((line for line in lines if "error" in line.lower()), lines[-1])
    print(json.dumps({"status": "gave up", "reason": error}))
    sys.exit(0)


def problem(kind):
    """The problem of the gradation on standard input in a language, which may not have its numbers."""
    words = [MDM, "convert", "-", "--problem", kind, *QUESTION]
    done = subprocess.run(words, stdin=sys.stdin, capture_output=True, text=True)
    if done.returncode != 0:
        give_up(done.stderr)
    return done.stdout


def scaled_rows(lp):
    """The rows of a problem in LP in double, each the terms by name and what their sum is at least. Each row is divided
    by its largest number and real variables are in such units that they stand with 1 and more: written as it is, a row
    has numbers of up to 20 digits and more, beyond what solvers in double take."""
    rows = [({name: float(sign + n) for sign, n, name in re.findall(r"([+-]) (\d+) (\w+)", left)}, float(right))
            for left, right in re.findall(r":([^:>]*)>= (-?\d+)", lp.split("Subject To")[1].split("Bounds")[0])]

    def divided(terms, right):
        most = max(map(abs, terms.values()))
        return {name: n / most for name, n in terms.items()}, right / most

    rows, unit = [divided(*row) for row in rows], {}
    for terms, _ in rows:
        unit |= {name: min(abs(n), unit.get(name, 1)) for name, n in terms.items() if name[0] != "q"}
    return [divided({name: n / unit.get(name, 1) for name, n in terms.items()}, right) for terms, right in rows]


def scaled(lp):
    """The same problem with such rows."""
    rows = "".join(f" r{i}: {' '.join(f'{n:+.17g} {name}' for name, n in terms.items())} >= {right:.17g}\n"
                   for i, (terms, right) in enumerate(scaled_rows(lp), 1))
    return re.sub(r"(?s)(?<=Subject To\n).*(?=Bounds\n)", lambda _: rows, lp)


def answer(counts):
    """Prints counts by the names of their variables; those in double are rounded. None: there is no solution."""
    def whole(count):
        return int(count) if re.fullmatch(r"\d+", str(count)) else round(float(count))

    if counts is None:
        print('{"status": "infeasible"}')
    elif not counts:
        give_up("")
    else:
        names = sorted(counts, key=lambda name: int(name[1:]))
        print(json.dumps({"quantities": [whole(counts[name]) for name in names]}))


def exact_only():
    """Where more is asked than the smallest exact match: says so and ends."""
    if QUESTION:
        print("exact matches alone")
        sys.exit(MISSING)


def say_version(command, options="", named=r"\S.*\d+\.\d+.*"):
    """With --version, says what the command prints of it, and the options, and ends; exit 77 where it is missing."""
    if "--version" not in sys.argv[1:]:
        return
    words = shlex.split(command)
    done = shutil.which(words[0]) and subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                                     stderr=subprocess.STDOUT, text=True)
    found = done and re.search(named, done.stdout)
    print(f"{found[0]}\n{options}" if found else "not installed")
    sys.exit(0 if found else MISSING)


def solve(kind, command, counts, version, infeasible="nothing", read=None, prepare=None, script="", **named):
    """Runs a solver on the problem's file, prepared first. {problem} and {solution} in its command are files, {script}
    is a text; what it prints and the solution are searched for counts, pairs of a name and a number, and for the words
    by which it says that there is no solution. Where it dies of a signal, so does the adapter."""
    def words(files):
        return [re.sub(r"{(\w+)}", lambda name: files[name[1]], word) for word in shlex.split(command)]

    shown = shlex.join(words({"problem": "problem." + kind, "solution": "solution", "script": "SCRIPT"}))
    say_version(version, shown + (", rows scaled" if prepare else ""), **named)
    text = problem(kind)
    with tempfile.TemporaryDirectory() as folder:
        file, solution = pathlib.Path(folder, "problem." + kind), pathlib.Path(folder, "solution")
        file.write_text(prepare(text) if prepare else text)
        done = subprocess.run(words({"problem": str(file), "solution": str(solution), "script": script}),
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        printed = done.stdout + (solution.read_text() if solution.exists() else "")
    if done.returncode < 0:
        os.kill(os.getpid(), -done.returncode)
    if re.search(infeasible, printed, re.M):
        return answer(None)
    found = dict(re.findall(counts, printed, re.M))
    found = read(found, text) if read else found
    return answer(found) if found else give_up((done.stderr or printed).replace(folder + "/", ""))
