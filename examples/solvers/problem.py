"""What the adapters share: they read a gradation as JSON, write its problem by `mdm convert --problem` in their solver's
language, and answer as `mdm crosscheck` asks. MDM_BIN may name the folder of mdm, MDM_QUESTION has what is asked beside
the gradation, such as `--tolerance retained:1%`. With --version an adapter says which solver it runs, or that there is none."""

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


def gradation():
    """The gradation on standard input."""
    return json.load(sys.stdin)


def problem(kind, text=None):
    """The problem of the gradation on standard input in a language."""
    done = subprocess.run([MDM, "convert", "-", "--problem", kind, *QUESTION], input=text or sys.stdin.read(),
                          stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout


def answer(counts):
    """Prints counts by the names of their variables; what was computed in double is rounded. None: there is no solution."""
    def whole(count):
        return int(count) if re.fullmatch(r"\d+", str(count)) else round(float(count))

    if counts is None:
        print('{"status": "infeasible"}')
    elif not counts:
        print('{"status": "gave up"}')
    else:
        names = sorted(counts, key=lambda name: int(name[1:]))
        print(json.dumps({"quantities": [whole(counts[name]) for name in names]}))


def exact_only():
    """Where more is asked than the smallest exact match: says so and ends."""
    if QUESTION:
        print("exact matches alone")
        sys.exit(77)


def say_version(command):
    """With --version, says it and ends; exit 77 where the program is missing."""
    if sys.argv[1:] != ["--version"]:
        return
    if shutil.which(command[0]) is None:
        print(f"{command[0]} is not installed")
        sys.exit(77)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if "ModuleNotFoundError" in done.stdout:
        print(f"{pathlib.Path(sys.argv[0]).name} is not installed")
        sys.exit(77)
    print(re.search(r"\S.*\d+\.\d+.*|$", done.stdout)[0].strip() or command[0])
    sys.exit(0)


def solve(kind, command, counts, version, infeasible="nothing", read=None):
    """Runs a solver on the problem's file. {problem} and {solution} in its command are files; what it prints and the solution
    are searched for counts, pairs of a name and a number, and for the words by which it says that there is no solution."""
    say_version(shlex.split(version))
    with tempfile.TemporaryDirectory() as folder:
        files = {"problem": pathlib.Path(folder, "problem." + kind), "solution": pathlib.Path(folder, "solution")}
        files["problem"].write_text(problem(kind))
        done = subprocess.run([word.format(**files) for word in shlex.split(command)], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True)
        text = done.stdout + (files["solution"].read_text() if files["solution"].exists() else "")
        if re.search(infeasible, text, re.M):
            return answer(None)
        found = dict(re.findall(counts, text, re.M))
        return answer(read(found, files["problem"].read_text()) if read else found)
