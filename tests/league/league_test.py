#!/usr/bin/python3
"""league_test.py PROGRAMS PROJECT: leagues of planted solvers, of which it is known what becomes of their answers."""
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

PROGRAMS, PROJECT = (pathlib.Path(word).resolve() for word in (sys.argv.pop(1), sys.argv.pop(1)))
SOLVERS = PROJECT / "examples/solvers"
LEAGUE = SOLVERS / "league"
ENVIRONMENT = {**os.environ, "MDM_BIN": str(PROGRAMS), "PYTHONDONTWRITEBYTECODE": "1"}
FILES = ("league.txt", "league.csv", "league.svg", "league.html")

#: Each begins with the smallest match.
HEAD = """#!/usr/bin/python3
import json, os, subprocess, sys, time
if sys.argv[1:] == ["--version"]: sys.exit(print("planted 1.0"))
words = [os.environ["MDM_BIN"] + "/mdm", "solve", "-", "--format", "json"]
done = subprocess.run(words, stdin=sys.stdin, stdout=subprocess.PIPE)
q = [int(c["quantity"]) for c in json.loads(done.stdout)["classes"]]
"""
#: What a solver does, and in which column its answers are.
PLANTED = {
    "honest": ("print(json.dumps({'quantities': q}))", "right"),
    "one_fewer": ("q[0] -= 1; print(json.dumps({'quantities': q}))", "impossible"),
    "top_heavy": ("q[-1] *= 10**6; print(json.dumps({'quantities': q}))", "not_a_match"),
    "twice": ("print(json.dumps({'quantities': [2 * n for n in q]}))", "larger"),
    "pessimist": ("print(json.dumps({'status': 'infeasible'}))", "infeasible"),
    "weary": ("print(json.dumps({'status': 'gave up', 'reason': 'beyond 64 bits'}))", "gave_up"),
    "falling": ("os.abort()", "failed"),
    "mumbling": ("print('quantities: 12')", "failed"),
    "hanging": ("time.sleep(60)", "timeout"),
}
COUNTED = ("right", "larger", "not_a_match", "impossible", "infeasible", "gave_up", "timeout", "new", "failed")


class League(unittest.TestCase):
    def setUp(self):
        self.work = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        for name, (end, _) in PLANTED.items():
            self.plant(name, HEAD + end + "\n")

    def plant(self, name, text):
        (self.work / name).write_text(text)
        (self.work / name).chmod(0o755)

    def words(self, *names, sample=2, levels="lower,higher", output="league", limit="4"):
        solvers = ",".join(name if (SOLVERS / name.split()[0]).exists() else f"./{name}" for name in names)
        return [sys.executable, LEAGUE, "--solvers", solvers, "--sample", str(sample), "--levels", levels,
                "--time-limit", limit, "-j", "2", "--output", output]

    def ask(self, *names, programs=PROGRAMS, **options):
        return subprocess.run(self.words(*names, **options), cwd=self.work, capture_output=True, text=True, timeout=120,
                              env={**ENVIRONMENT, "MDM_BIN": str(programs)})

    def run_league(self, *names, **options):
        done = self.ask(*names, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(self.work / options.get("output", "league") / "league.csv", newline="") as file:
            return list(csv.DictReader(file))

    def wait_until(self, condition, seconds=100):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "not in time")
            time.sleep(0.02)

    def contents(self, output):
        return [(self.work / output / name).read_text() for name in FILES]

    def refused(self, message, *names, code=1, programs=PROGRAMS, **options):
        done = self.ask(*names, programs=programs, **options)
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_every_answer_is_in_its_column(self):
        rows = self.run_league(*PLANTED)
        self.assertEqual(len(rows), 2 * len(PLANTED))
        for row in rows:
            wanted = dict.fromkeys(COUNTED, "0") | {PLANTED[row["solver"]][1]: "2"}
            self.assertEqual({c: row[c] for c in COUNTED}, wanted, row["solver"])
            self.assertEqual((row["asked"], row["version"]), ("2", "planted 1.0"))
            answers = "2" if row["solver"] in ("honest", "twice", "one_fewer", "top_heavy") else "0"
            self.assertEqual((row["certificates"], row["accepted"]), (answers, answers), row["solver"])
        text = self.contents("league")[0]
        parts = re.split("Shortest answers.*:\n|\n\nWhy answers.*:\n", text)
        examples, excuses = (part.splitlines() for part in parts[1:])
        self.assertEqual([line.split(",")[0] for line in examples], ["one_fewer"] * 2 + ["top_heavy"] * 2)
        self.assertRegex(examples[0], r"^one_fewer, lower: athabasca-sand, 7 classes. Answer 818 (\d+ ){5}\d+; "
                                      r"N = 1484, of the smallest match 1485: class")
        self.assertIn("weary, lower: gave up: beyond 64 bits", excuses)
        for drawn in self.contents("league")[2:]:
            self.assertIn("one_fewer", drawn)
        xml.etree.ElementTree.fromstring(self.contents("league")[2])

    def test_a_forged_certificate_is_refused(self):
        self.run_league("one_fewer", levels="lower")
        program = self.work / "programs/mdm-check"
        program.parent.mkdir()
        (program.parent / "mdm").symlink_to(PROGRAMS / "mdm")
        self.plant("programs/mdm-check", "#!/bin/sh\necho 'accepted: 5 particles match it'\n")
        done = self.ask("one_fewer", levels="lower", programs=program.parent)
        self.assertEqual((done.returncode, done.stderr), (1, "league: mdm-check refuses 2 certificates in league\n"))

    def test_adapters_are_asked_within_a_tolerance_too(self):
        self.plant("stranger", HEAD.replace("--version", "--who-are-you") + PLANTED["honest"][0])
        rows = self.run_league("z3", "float_sweep", "published spanned-integer", "stranger", sample=1,
                               levels="lower,tolerance", limit="20")
        found = {(row["solver"], row["level"]): row for row in rows}
        if found["z3", "lower"]["note"] != "not installed":
            self.assertEqual([found["z3", level]["right"] for level in ("lower", "tolerance")], ["1", "1"])
        for solver in ("float_sweep", "published spanned-integer", "stranger"):
            answered = found[solver, "lower"]
            self.assertEqual(int(answered["right"]) + int(answered["larger"]), 1, solver)
            asked = found[solver, "tolerance"]
            self.assertEqual((asked["asked"], asked["note"]), ("0", "exact matches alone"), solver)
        self.assertEqual(found["stranger", "lower"]["version"], "given by its path")

    def test_a_solver_that_is_missing_is_said(self):
        self.plant("absent", "#!/bin/sh\necho not installed\nexit 77\n")
        rows = self.run_league("absent", "honest", levels="lower")
        self.assertEqual([(row["solver"], row["note"], row["right"]) for row in rows],
                         [("absent", "not installed", "0"), ("honest", "", "2")])
        for drawn in self.contents("league"):
            self.assertIn("not installed", drawn)

    def test_goes_on_where_it_was_interrupted(self):
        names = ("honest", "twice", "one_fewer")
        self.run_league(*names, sample=4, output="once")
        league = subprocess.Popen(self.words(*names, sample=4), cwd=self.work, env=ENVIRONMENT, start_new_session=True,
                                  stdout=subprocess.DEVNULL)
        journals = self.work / "league/journals"
        self.wait_until(lambda: list(journals.glob("honest-*/journal.jsonl")))
        os.killpg(league.pid, signal.SIGKILL)
        league.wait()
        self.assertFalse((self.work / "league/league.csv").exists())
        self.run_league(*names, sample=4)
        self.assertEqual(self.contents("league"), self.contents("once"))
        # What is in a journal is not asked again.
        for name in names:
            self.plant(name, HEAD + "sys.exit(1)\n")
        self.run_league(*names, sample=4)
        self.assertEqual(self.contents("league"), self.contents("once"))

    def test_where_it_is_ended_so_are_solvers(self):
        beats = self.work / "beats"
        self.plant("beating", HEAD + f"for i in range(600): open({str(beats)!r}, 'a').write('beat'); time.sleep(0.1)\n")
        league = subprocess.Popen(self.words("beating", limit="60"), cwd=self.work, env=ENVIRONMENT)
        self.wait_until(beats.exists)
        league.terminate()
        self.assertEqual(league.wait(60), 128 + signal.SIGTERM)

        def is_still():
            before = beats.stat().st_size
            time.sleep(0.5)
            return beats.stat().st_size == before
        self.wait_until(is_still, 20)

    def test_refuses_what_are_other_questions_or_no_solvers(self):
        self.run_league("honest", sample=1, levels="lower")
        self.refused("terms.json is of a league of other terms", "honest", sample=2, levels="lower")
        self.refused("terms.json is of a league of other terms", "honest", sample=1, levels="lower", limit="5")
        self.plant("honest", (self.work / "honest").read_text().replace("planted 1.0", "planted 1.1"))
        self.refused("solver.json is of another version of the solver", "honest", sample=1, levels="lower")
        self.refused("./nobody is no program: give a path, or one of z3, scipy", "nobody", code=2, output="none")
        self.refused("a level is one of", "honest", code=2, levels="lowest", output="none")
        self.refused("there is no /nowhere/mdm: have it on PATH", "honest", code=2, output="none", programs="/nowhere")
        self.assertFalse((self.work / "none").exists())

    def test_adapters_are_short_and_say_what_they_run(self):
        for name in json.loads(re.search(r"SOLVERS = (\[.*?\])", LEAGUE.read_text(), re.S)[1]):
            program, *words = name.split()
            self.assertLessEqual(len((SOLVERS / program).read_text().splitlines()), 20, name)
            done = subprocess.run([SOLVERS / program, *words, "--version"], env=ENVIRONMENT, capture_output=True,
                                  text=True, timeout=60)
            says = done.stdout.splitlines()
            wanted = (77, 1) if says == ["not installed"] else (0, 2)
            self.assertEqual((done.returncode, len(says)), wanted, name + done.stderr)

    def test_the_run_that_is_kept_is_of_one_piece(self):
        text, table, picture, page = ((SOLVERS / "results" / name).read_text() for name in FILES)
        rows = list(csv.DictReader(table.splitlines()))
        lines = {tuple(line[:36].rsplit(maxsplit=1)): line[36:].split() for line in text.splitlines()[3:3 + len(rows)]}
        for row in rows:
            self.assertEqual(sum(int(row[c]) for c in COUNTED), int(row["asked"]))
            if not row["note"]:
                self.assertEqual(lines[row["solver"], row["level"]], [row[c] for c in COUNTED])
                self.assertIn(f">{row['right']}/{row['asked']}</text>", picture)
        self.assertIn(picture, page)
        page = (PROJECT / "examples/reference/README.md").read_text()
        for solver in dict.fromkeys(row["solver"] for row in rows if row["note"] != "not installed"):
            of_solver = [row for row in rows if row["solver"] == solver]
            wrong = [sum(int(row[c]) for c in ("not_a_match", "impossible", "infeasible")) for row in of_solver]
            cells = ["-" if row["note"] else f"{row['right']}, {n}" for row, n in zip(of_solver, wrong)]
            self.assertIn(f"| {solver} | {' | '.join(cells)} |", page)


unittest.main()
