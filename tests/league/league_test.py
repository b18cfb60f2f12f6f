#!/usr/bin/python3
"""league_test.py PROGRAMS PROJECT: a short league with planted solvers, of which it is known what becomes of their answers."""
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

PROGRAMS, PROJECT = (pathlib.Path(word).resolve() for word in (sys.argv.pop(1), sys.argv.pop(1)))
LEAGUE = PROJECT / "examples/solvers/league"
ENVIRONMENT = {**os.environ, "MDM_BIN": str(PROGRAMS), "PYTHONDONTWRITEBYTECODE": "1"}

#: Each begins with the smallest match.
HEAD = """#!/usr/bin/python3
import json, os, subprocess, sys, time
done = subprocess.run([os.environ["MDM_BIN"] + "/mdm", "solve", "-", "--format", "json"], stdin=sys.stdin, stdout=subprocess.PIPE)
q = [int(c["quantity"]) for c in json.loads(done.stdout)["classes"]]
"""
#: What a solver does, and in which column its answers are.
PLANTED = {
    "honest": ("print(json.dumps({'quantities': q}))", "right"),
    "one_fewer": ("q[0] -= 1; print(json.dumps({'quantities': q}))", "not_a_match"),
    "twice": ("print(json.dumps({'quantities': [2 * n for n in q]}))", "larger"),
    "pessimist": ("print(json.dumps({'status': 'infeasible'}))", "infeasible"),
    "weary": ("print(json.dumps({'status': 'gave up'}))", "gave_up"),
    "falling": ("os.abort()", "failed"),
    "mumbling": ("print('quantities: 12')", "failed"),
    "hanging": ("time.sleep(60)", "timeout"),
}


class League(unittest.TestCase):
    def setUp(self):
        self.work = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        for name, (end, _) in PLANTED.items():
            (self.work / name).write_text(HEAD + end + "\n")
            (self.work / name).chmod(0o755)

    def words(self, *names, sample=2, levels="lower,higher", output="league"):
        solvers = ",".join(name if (PROJECT / "examples/solvers" / name).exists() else str(self.work / name) for name in names)
        return [sys.executable, LEAGUE, "--solvers", solvers, "--sample", str(sample), "--levels", levels, "--time-limit", "1.5",
                "-j", "2", "--output", self.work / output]

    def run_league(self, *names, **options):
        done = subprocess.run(self.words(*names, **options), env=ENVIRONMENT, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(self.work / options.get("output", "league") / "league.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_every_answer_is_in_its_column(self):
        rows = self.run_league(*PLANTED)
        self.assertEqual(len(rows), 2 * len(PLANTED))
        columns = {column for _, column in PLANTED.values()}
        for row in rows:
            wanted = dict.fromkeys(columns, "0") | {PLANTED[row["solver"]][1]: "2"}
            self.assertEqual({c: row[c] for c in columns}, wanted, row["solver"])
            self.assertEqual((row["asked"], row["version"]), ("2", "given by its path"))
            self.assertEqual(row["accepted"], row["certificates"])
        self.assertTrue(all(int(row["certificates"]) == 2 for row in rows if row["solver"] in ("honest", "twice")))
        text = (self.work / "league/league.txt").read_text()
        examples = text.split("Shortest answers that are no match:\n")[1].splitlines()
        self.assertEqual([line.split(",")[0] for line in examples], ["one_fewer", "one_fewer"])
        for ending in ("svg", "html"):
            self.assertIn("one_fewer", (self.work / f"league/league.{ending}").read_text())

    def test_adapters_are_asked_within_a_tolerance_too(self):
        rows = self.run_league("z3", "float_sweep", sample=1, levels="lower,tolerance")
        found = {(row["solver"], row["level"]): row for row in rows}
        self.assertEqual(found["z3", "lower"]["right"], "1")
        self.assertEqual(found["z3", "tolerance"]["right"], "1")
        self.assertEqual(found["float_sweep", "lower"]["right"], "1")
        self.assertEqual((found["float_sweep", "tolerance"]["asked"], found["float_sweep", "tolerance"]["version"]), ("0", "exact matches alone"))

    def test_goes_on_where_it_was_interrupted(self):
        once = self.run_league("honest", "twice", "one_fewer", sample=4, output="once")
        league = subprocess.Popen(self.words("honest", "twice", "one_fewer", sample=4), env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                  start_new_session=True)
        journals = self.work / "league/journals"
        while not list(journals.glob("honest-*/journal.jsonl")):
            time.sleep(0.02)
        os.killpg(league.pid, signal.SIGKILL)
        league.wait()
        self.assertFalse((self.work / "league/league.csv").exists())
        self.assertEqual(self.run_league("honest", "twice", "one_fewer", sample=4), once)
        # What is in a journal is not asked again.
        for name in ("honest", "twice", "one_fewer"):
            (self.work / name).write_text(HEAD + "sys.exit(1)\n")
        self.assertEqual(self.run_league("honest", "twice", "one_fewer", sample=4), once)
        for file in ("league.txt", "league.svg", "league.html"):
            self.assertEqual((self.work / "once" / file).read_text(), (self.work / "league" / file).read_text())

    def test_refuses_answers_to_other_questions(self):
        self.run_league("honest", sample=1, levels="lower")
        done = subprocess.run(self.words("honest", sample=2, levels="lower"), env=ENVIRONMENT, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("has a league of other terms", done.stderr)

    def test_says_what_is_missing(self):
        for names, environment, words in (("nosuch", {}, "nosuch is no program"), ("float_sweep", {"MDM_BIN": "/nowhere"}, "there is no /nowhere/mdm")):
            done = subprocess.run([sys.executable, LEAGUE, "--solvers", names, "--output", self.work / "none"], capture_output=True, text=True,
                                  env=ENVIRONMENT | environment)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
            self.assertFalse((self.work / "none").exists())

    def test_adapters_are_short_and_say_what_they_run(self):
        names = json.loads(re.search(r"SOLVERS = (\[.*?\])", LEAGUE.read_text(), re.S)[1])
        for name in names:
            adapter = PROJECT / "examples/solvers" / name
            if name == "highs" and not shutil.which("node"):
                continue
            self.assertLessEqual(len(adapter.read_text().splitlines()), 20, name)
            done = subprocess.run([adapter, "--version"], env=ENVIRONMENT, capture_output=True, text=True, timeout=60)
            self.assertIn(done.returncode, (0, 77), name)
            self.assertEqual(len(done.stdout.splitlines()), 1, name + done.stderr)


unittest.main()
