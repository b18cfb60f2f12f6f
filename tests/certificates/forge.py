#!/usr/bin/python3
"""Forged certificates of version 3. Each claims that no match has fewer particles than one more than the smallest match
has: whatever the tree, the claim is false, and a checker has to refuse it.

forge.py COUNT SEED MDM_CHECK [VERIFIED] gives so many to mdm-check, and the true ones that they were made of; a second
program, mdm-check-verified, has to say the same of each. The smallest match is found by z3. Some trees are changed in places;
others are made with a rule that is wrong: it says how many were found."""
import copy
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction as F

from windows import MUTATIONS, WindowTree


def question(r):
    """A random question on two or three classes with small numbers, so that ends often meet."""
    k = r.choice((2, 2, 3))
    x = sorted(r.sample(range(0, 10), k + 1))
    m = [r.randint(0, 5) for _ in range(k)]
    if not any(m):
        m[0] = 1
    c = [r.choice(("1", "1", "2", "0.5")) for _ in range(k + 1)] if r.random() < .3 else None
    tolerance = []
    if r.random() < .6:
        tolerance.append(f"retained {r.choice((0, 5, 10, 20, 25, 50))}")
    if r.random() < .3:
        tolerance.append(f"passing {r.choice((0, 5, 10, 25))}")
    if r.random() < .3 or not tolerance:
        tolerance.append(f"total {r.choice((0, 10, 20, 50, 100))}")
    if r.random() < .1:
        tolerance.append(f"band {x[1]} {r.choice((0, 10))} {r.choice((0, 50, 80))}")
    options = {}
    if r.random() < .25:
        options["least"] = str(r.choice((1, 2)))
    if r.random() < .25:
        options["at_least"] = str(r.randint(2, 6))
    law = (1, 1)
    if r.random() < .15:
        law, options["cylinder"] = (3, 1), f"{r.randint(1, 6)} {r.randint(1, 6)} 0.5"
    return [str(v) for v in x], [str(v) for v in m] + ["0"], tolerance, dict(options, c=c, law=law, plain=r.random() < .2)


def masses_of_splits(of, r):
    """Where splits of M are of interest: where particles of one class have exactly a bound on its share; and others."""
    ends = {q * size / share for j, shares in enumerate(of.bounds_of_shares()) for size in (of.f[j], of.F[j])
            for share in shares for q in range(1, 5) if size > 0 and share > 0}
    chosen = set(r.sample(sorted(ends), min(len(ends), r.randint(0, 4))))
    return chosen | {F(r.randint(1, 60), r.choice((1, 1, 2, 3))) for _ in range(r.choice((0, 0, 1, 2)))}


class Conditions(WindowTree):
    """Of a question, without a tree."""

    def __init__(self, *arguments, **question):
        super().__init__(*arguments, below=2, with_witness=False, most=0, **question)

    def grow(self, *_):
        pass


class Z3:
    def __init__(self):
        self.z3 = subprocess.Popen(["z3", "-in"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def least(self, of, most=9):
        """The least number of particles from at_least on, at most 9; or None."""
        k = of.k

        def sum_of(terms):
            return "(+ 0 " + " ".join(terms) + ")"

        def number(v):
            return f"(/ {v.numerator} {v.denominator})" if v >= 0 else f"(- (/ {-v.numerator} {v.denominator}))"

        say = ["(push)", *(f"(declare-const q{j} Int) (declare-const t{j} Real) (declare-const p{j} Real)" for j in range(k))]
        M = sum_of(f"t{j}" for j in range(k))
        for j in range(k):
            f, top = number(of.f[j]), number(of.F[j])
            say.append(f"(assert (>= q{j} {of.least[j]}))")
            say.append(f"(assert (ite (= q{j} 0) (= t{j} 0) (and (< (* {f} q{j}) t{j}) (<= t{j} (* {top} q{j})))))")
            for (lo, hi), passing in ((of.retained[j], False), (of.passing[j], True)):
                mass = sum_of(f"t{i}" for i in range(j + 1)) if passing else f"t{j}"
                say.append(f"(assert (and (<= (* {number(lo)} {M}) {mass}) (<= {mass} (* {number(hi)} {M}))))")
            say.append(f"(assert (and (>= p{j} 0) (>= p{j} (- t{j} (* {number(of.g[j])} {M})))))")
        say.append(f"(assert (<= {sum_of(f'p{j}' for j in range(k))} (* {number(of.e / 2)} {M})))")
        if of.weight:
            volume = sum_of(f"(* {number(1 / of.c[j])} t{j})" for j in range(k))
            say.append(f"(assert (>= {volume} {number(of.weight)}))")
        count = sum_of(f"q{j}" for j in range(k))
        say.append(f"(assert (and (>= {count} {of.at_least}) (>= {count} 1)))")
        for n in range(of.at_least, most + 1):
            say.append(f"(push) (assert (<= {count} {n})) (check-sat) (pop)")
        say.append("(pop)")
        self.z3.stdin.write("\n".join(say) + "\n")
        self.z3.stdin.flush()
        answers = [self.z3.stdout.readline().strip() for _ in range(of.at_least, most + 1)]
        assert set(answers) <= {"sat", "unsat"}, answers
        return of.at_least + answers.index("sat") if "sat" in answers else None


def changed(lines, r):
    """The lines of a tree, with one thing changed."""
    lines = [line.split() for line in lines]
    at = r.randrange(len(lines))
    line = lines[at]
    kind = r.randrange(9)
    if line[0] == "split":
        if kind < 6:
            v = F(line[2])
            v = r.choice((v + 1, v - 1, v * 2, v / 2, v + F(1, 1000), v * F(999, 1000), F(int(v)), F(r.randint(1, 60))))
            line[2] = str(v)
        elif kind == 6:
            line[1] = r.choice(("M", "1", "2", "1-2"))
        else:
            other = r.choice([other for other in lines if other[0] == "split"])
            line[2], other[2] = other[2], line[2]
    elif kind < 3 and len(line) > 1:
        i = r.randrange(1, len(line), 2)
        m = int(line[i])
        line[i] = str(r.choice((m + 1, m - 1, 2 * m, m // 2, m + r.randint(1, 5), r.randint(1, 100))))
    elif kind == 3 and len(line) > 1:
        i = r.randrange(2, len(line), 2)
        swap = {"t": "T", "T": "t", "p": "P", "P": "p", "s": "S", "S": "s", "n": "N", "N": "n", "E": "w", "w": "E"}
        line[i] = swap.get(line[i][0], "t") + line[i][1:]
    elif kind == 4 and len(line) > 3:
        i = r.randrange(1, len(line), 2)
        del line[i:i + 2]
    elif kind == 5 and len(line) > 1:
        name = r.choice(("t", "T", "E", "w", "n", "N", "p1", "P1", "p2", "P2"))
        if name not in line:
            line += [str(r.randint(1, 9)), name]
    elif kind == 6 and len(line) > 1:
        factor = r.choice((2, 3, 10, 1000))
        line[1::2] = [str(int(m) * factor + r.choice((0, 0, 1))) for m in line[1::2]]
    else:
        other = r.choice([other for other in lines if other[0] != "split"])
        line[:], other[:] = other[:], line[:]
    return [" ".join(line) for line in lines]


def verdicts_of(program, folder, pairs):
    """What mdm-check says of each pair, in a stream: a line each, with the gradation's name left out."""
    index, at = ["mdm-proofs 1"], 0
    for i, (_, text) in enumerate(pairs):
        index.append(f"{i + 1} {at} {len(text)}")
        at += len(text)
    (folder / "stream").write_text("".join(text for _, text in pairs))
    (folder / "stream.index").write_text("\n".join(index) + "\n")
    (folder / "suite").write_text("".join(gradation + "\n" for gradation, _ in pairs))
    said = subprocess.run([program, "--suite", folder / "suite", folder / "stream", "--verbose"], capture_output=True, text=True)
    lines = said.stdout.splitlines()
    assert len(lines) == len(pairs) + 1, lines[-1]
    return [without_name(line) for line in lines[:-1]]


def verified_verdicts_of(program, folder, pairs, at_once=1000):
    """The verdicts of a program that takes pairs of files and says the reason of a refusal in another line."""
    verdicts = []
    for begin in range(0, len(pairs), at_once):
        names = []
        for i, pair in enumerate(pairs[begin:begin + at_once]):
            for text, ending in zip(pair, ("json", "proof")):
                names.append(folder / f"{i}.{ending}")
                names[-1].write_text(text)
        said = subprocess.run([program, *names], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        lines = iter(said.stdout.splitlines())
        for line in lines:
            verdicts.append(without_name(line))
            if verdicts[-1] == "refused":
                next(lines)
    assert len(verdicts) == len(pairs)
    return verdicts


def without_name(line):
    """An accepted line without the file's name, of others what they are."""
    word = line.split(":")[0]
    return line.split('"')[0] + line.split('"')[2] if word == "accepted" else word if word == "refused" else "malformed"


def counts_of(verdicts):
    kinds = [verdict.split(":")[0] for verdict in verdicts]
    return {kind: kinds.count(kind) for kind in ("accepted", "refused", "malformed")}


def main(count, seed, program, verified=None):
    r = random.Random(seed)
    pairs, true, found, seen = [], [], dict.fromkeys(MUTATIONS, 0), set()
    judge, WindowTree.most_counts = Z3(), 12
    while len(pairs) < count:
        x, m, tolerance, options = question(r)
        of = Conditions(x, m, tolerance, **options)
        N = judge.least(of)
        if N is None or N < 2:
            continue
        options["masses"] = masses_of_splits(of, r)
        try:
            tree = WindowTree(x, m, tolerance, below=N, with_witness=False, most=0, give_up=12, **options)
        except (ValueError, StopIteration):
            continue
        gradation = json.dumps({"sizes": x, "masses": m, **({"factors": options["c"]} if options["c"] else {})})
        true.append((gradation, tree.proof()))
        tree.B = N + 1
        head = tree.proof().splitlines()
        first = next(i for i, line in enumerate(head) if line.split()[0] in ("split", "leaf", "window"))
        trees = [head[first:-1]]
        for wrong in r.sample(MUTATIONS, 2):
            other = copy.copy(tree)
            other.wrong, other.nodes, other.give_up = wrong, [], 6
            try:
                other.grow(other.least, [None] * other.k, {}, ())
            except ValueError:
                continue
            found[wrong] += 1
            trees.append(other.proof().splitlines()[first:-1])
        for lines in trees:
            for n in range(min(1 + 300 * len(lines), max(50, count // 100))):
                forged = lines
                for _ in range(min(n, r.choice((1, 1, 1, 2, 3)))):
                    forged = changed(forged, r)
                text = "\n".join(head[:first] + forged + ["end", ""])
                if text not in seen:
                    seen.add(text)
                    pairs.append((gradation, text))
    pairs = pairs[:count] + true
    with tempfile.TemporaryDirectory() as folder:
        verdicts = verdicts_of(program, pathlib.Path(folder), pairs)
        others = verified_verdicts_of(verified, pathlib.Path(folder), pairs) if verified else verdicts
    of_forged, of_true = counts_of(verdicts[:count]), counts_of(verdicts[count:])
    differ = sum(one != other for one, other in zip(verdicts, others))
    print(len(true), "questions;", ", ".join(f"{n} with {wrong}" for wrong, n in found.items()))
    print("forged:", of_forged, "\ntrue:", of_true)
    if verified:
        print(differ, "verdicts differ")
    ok = of_forged["accepted"] == 0 and of_true["accepted"] == len(true) and differ == 0
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    if shutil.which("z3") is None:
        print("no z3")
        sys.exit(77)
    main(int(sys.argv[1]), int(sys.argv[2]), *sys.argv[3:])
