#!/usr/bin/python3
"""verdicts_test.py MDM [QUESTIONS [SEED]]: mdm crosscheck on random questions within tolerances, beside models of z3's own.

Of each question z3 finds the least number of particles, and of each answer, smallest matches and changed ones, whether
masses in its classes hold what is asked. Nothing of mdm's is in the models but the question.
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
from fractions import Fraction

if not shutil.which("z3"):
    print("z3 is missing")
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)

MDM = sys.argv[1]
QUESTIONS = int(sys.argv[2]) if len(sys.argv) > 2 else 60
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 1


def number(r):
    return f"(/ {abs(r.numerator)}.0 {r.denominator}.0)" if r >= 0 else f"(- {number(-r)})"


def draw(rng):
    """A gradation of 2 to 5 classes, and tolerances of one or two kinds with other demands."""
    classes = rng.randint(2, 5)
    sizes = sorted(rng.sample(range(1, 12), classes + 1))
    masses = [rng.randint(1, 9) for _ in range(classes)]
    kinds = rng.sample(["retained", "passing", "total"], rng.choice([1, 1, 2]))
    tolerances = {kind: Fraction(rng.choice([1, 2, 5, 10, 20, 30]), 2) for kind in kinds}
    least = rng.choice([0, 0, 0, 1, 2])
    at_least = rng.choice([1, 1, 1, rng.randint(2, 12)])
    return sizes, masses, tolerances, least, at_least


def model(sizes, masses, tolerances, least, at_least):
    """Counts q and masses t that hold all of it."""
    k, whole = len(masses), sum(masses)
    lines = [f"(declare-const q{j} Int)(declare-const t{j} Real)" for j in range(k)]
    M = "(+ 0.0 " + " ".join(f"t{j}" for j in range(k)) + ")"

    def within(mass, share, e):
        lines.append(f"(assert (<= (* {number(share - e)} {M}) {mass} (* {number(share + e)} {M})))")

    for j in range(k):
        low, high = sizes[j] ** 3, sizes[j + 1] ** 3
        lines.append(f"(assert (>= q{j} {least}))"
                     f"(assert (ite (= q{j} 0) (= t{j} 0.0) (and (< (* {low}.0 q{j}) t{j}) (<= t{j} (* {high}.0 q{j})))))")
    for kind, percent in tolerances.items():
        e = percent / 100
        if kind == "retained":
            for j in range(k):
                within(f"t{j}", Fraction(masses[j], whole), e)
        elif kind == "passing":
            for j in range(k - 1):
                within("(+ 0.0 " + " ".join(f"t{i}" for i in range(j + 1)) + ")", Fraction(sum(masses[:j + 1]), whole), e)
        else:
            errors = [f"(- t{j} (* {number(Fraction(masses[j], whole))} {M}))" for j in range(k)]
            total = " ".join(f"(ite (>= {x} 0.0) {x} (- {x}))" for x in errors)
            lines.append(f"(assert (<= (+ 0.0 {total}) (* {number(e)} {M})))")
    counts = " ".join(f"q{j}" for j in range(k))
    return lines + [f"(assert (> {M} 0.0))(assert (>= (+ 0 {counts}) {at_least}))"], counts


def z3(text):
    done = subprocess.run(["z3", "-in", "-T:60"], input=text, capture_output=True, text=True, check=False)
    assert "timeout" not in done.stdout and "unknown" not in done.stdout, done.stdout
    return done.stdout


def smallest(lines, counts):
    """The counts of a smallest match; nothing where there is none."""
    out = z3("\n".join(lines) + f"(minimize (+ 0 {counts}))(check-sat)(get-value ({counts}))")
    return [int(n) for n in re.findall(r"\(q\d+ (\d+)\)", out)] if out.startswith("sat") else None


def are_matches(lines, answers):
    checks = "".join("(push)" + "".join(f"(assert (= q{j} {n}))" for j, n in enumerate(q)) + "(check-sat)(pop)" for q in answers)
    return [word == "sat" for word in z3("\n".join(lines) + checks).split()]


def answers_near(rng, found):
    """The smallest match, and others near it."""
    answers = [found]
    for _ in range(4):
        q = list(found)
        for _ in range(rng.choice([1, 1, 2])):
            j = rng.randrange(len(q))
            q[j] = max(0, q[j] + rng.choice([-1, 1, 1, 2]))
        answers.append(q)
    return [q for q in answers if any(q)]


def main():
    rng = random.Random(SEED)
    wrong, verdicts = [], {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for question in range(QUESTIONS):
            sizes, masses, tolerances, least, at_least = draw(rng)
            lines, counts = model(sizes, masses, tolerances, least, at_least)
            found = smallest(lines, counts)
            answers = answers_near(rng, found or [1] * len(masses))
            fits = are_matches(lines, answers)
            wanted = ["not-a-match" if not fit else "minimal" if sum(q) == sum(found) else "larger"
                      for fit, q in zip(fits, answers)]
            gradation = {"id": "g", "sizes": [str(x) for x in sizes], "masses": [str(m) for m in masses] + ["0"]}
            (folder / "suite.jsonl").write_text(json.dumps(gradation) + "\n")
            (folder / "answers.jsonl").write_text("".join(json.dumps({"id": "g", "quantities": q}) + "\n" for q in answers)
                                                  + '{"id": "g", "status": "infeasible"}\n')
            options = [word for kind, percent in tolerances.items()
                       for word in ("--tolerance", f"{kind}:{float(percent)}%")]
            options += ["--min-per-class", str(least)] if least else []
            options += ["--at-least", str(at_least)] if at_least > 1 else []
            done = subprocess.run([MDM, "crosscheck", folder / "suite.jsonl", folder / "answers.jsonl", *options, "--format",
                                   "json", "--quiet"], capture_output=True, text=True, check=False)
            assert done.returncode in (0, 1), (options, done.stderr)
            rows = json.loads(done.stdout)["rows"]
            given = [row["verdict"] for row in rows]
            wanted.append("minimal" if found is None else "infeasible")
            minima = {row["minimum"] for row in rows}
            if given != wanted or minima != {None if found is None else str(sum(found))}:
                wrong.append((question, gradation, options, answers, given, wanted, minima, found))
            for verdict in wanted:
                verdicts[verdict] = verdicts.get(verdict, 0) + 1
    print(*wrong, sep="\n")
    print(f"{QUESTIONS} questions, answers {verdicts}, {len(wrong)} differ")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
