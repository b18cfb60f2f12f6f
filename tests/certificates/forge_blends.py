#!/usr/bin/python3
"""forge_blends.py COUNT SEED MADE MDM MDM-CHECK MDM-CHECK-VERIFIED: both checkers say the same of certificates of blends.

First of those that make.py wrote to the folder MADE, as they are and changed; then of the answers of mdm blend to COUNT random problems,
which are to be accepted, and of these changed: in a number, a letter, a line or a byte, and with files that are changed or in another
order. What is printed on standard output and the exit code are compared.
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter

NAMES = ("accepted", "refused", "malformed")
SIEVES = ["0.075", "0.15", "0.3", "0.6", "1.18", "2.36", "4.75", "9.5", "19", "37.5"]
INCHES = {"4.75": "No. 4", "2.36": "No. 8", "9.5": "3/8 in", "19": "3/4 in"}
AIMS = ["cost", "deviation", "max-deviation", "squares", "none"]
NUMBER = re.compile(r"\d+(?:/\d+)?")


def changed(r, text):
    """The text with one change."""
    lines = text.split("\n")
    way = r.randrange(7)
    if way <= 2:
        numbers = list(NUMBER.finditer(text))
        at = r.choice(numbers)
        n, _, d = at.group().partition("/")
        new = r.choice([str(int(n) + 1), str(max(int(n) - 1, 0)), "0", f"{n}/{int(d or 1) + 1}", f"0{n}", str(2**64), str(10**9),
                        str(10**9 + 1), r.choice(numbers).group(), "1" * 30])
        return text[:at.start()] + new + text[at.end():]
    if way == 3:
        i = r.randrange(len(lines))
        lines[i] = re.sub(r"\b[luab](?=\d)", lambda _: r.choice("luabx"), lines[i], count=1)
        return "\n".join(lines)
    if way == 4:
        del lines[r.randrange(len(lines))]
        return "\n".join(lines)
    if way == 5:
        lines.insert(r.randrange(len(lines)), r.choice(lines + ["at-most 2", "split 1 50", "none", "leaf", "coarseness 1/2 60", "share 1 0 1/2",
                                                               "modulus en 1 3", "modulus astm 2 6", "minimise none", "blend none"]))
        return "\n".join(lines)
    at = r.randrange(len(text))
    return text[:at] + r.choice(["", " ", "\n", "\t", "-", ".5", "/2", "e", "\r"]) + text[at + r.randrange(2):]


class Run:
    def __init__(self, mdm, checkers):
        self.mdm, self.checkers, self.counts = mdm, checkers, Counter()

    def check(self, what, files, expected=None):
        outcomes = []
        for checker in self.checkers:
            done = subprocess.run([checker, *files], capture_output=True)
            assert done.returncode == 2 or done.stdout.count(b"\n") == 1, (files, done)
            assert (done.returncode == 2) == (done.stdout == b"") and (done.returncode == 0) == (done.stderr == b""), (files, done)
            outcomes.append((done.returncode, done.stdout.decode()))
        assert outcomes[0] == outcomes[1], (files, outcomes)
        assert expected in (None, outcomes[0][0]), (files, outcomes)
        self.counts[f"{what} {NAMES[outcomes[0][0]]}"] += 1

    def forge(self, r, what, files, times):
        """With the certificate, the last of the files, changed, then another file, then with another order."""
        for _ in range(times):
            self.check(what, files[:-1] + [self.write("forged.proof", changed(r, pathlib.Path(files[-1]).read_text()))])
        i = r.randrange(len(files) - 1)
        other = self.write("forged" + pathlib.Path(files[i]).suffix, changed(r, pathlib.Path(files[i]).read_text()))
        self.check("files:", files[:i] + [other] + files[i + 1:])
        self.check("order:", r.sample(files[:-1], len(files) - 1) + files[-1:])
        self.check("order:", files[:1] + files[2:])

    @staticmethod
    def write(name, text):
        pathlib.Path(name).write_bytes(text.encode())
        return name

    def made(self, folder):
        for code, verdict in enumerate(("accepted", "rejected", "unparsable")):
            for case in sorted((folder / verdict).iterdir()):
                files = [str(case / name) for name in ("limits.csv", "1.csv", "2.csv", "proof")]
                self.check("made:", files, code)
                self.forge(random.Random(case.name), "made, changed:", files, 3)

    def problem(self, r):
        """A random problem in files, and the options of mdm blend."""
        sieves = sorted(r.sample(SIEVES, r.randrange(3, 8)), key=float)
        stockpiles = r.randrange(2, 5)
        curves = [[0] + sorted(r.choice([0, 5, 20, 35, 50, 64.5, 80, 100]) for _ in sieves[2:]) + [100] for _ in range(stockpiles)]
        weights = [r.random() for _ in curves]
        middle = [sum(w * c[s] for w, c in zip(weights, curves)) / sum(weights) for s in range(len(sieves))]
        room = r.choice([2, 5, 10, 20])
        limits = [(x, max(0, round(m - room, 1)), min(100, round(m + room, 1))) if r.random() < 0.7 else (x, 0, 100)
                  for x, m in zip(sieves, middle)]
        limits[-1] = (sieves[-1], r.choice([0, 100]), 100)
        self.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n" +
                   "".join(f"{x},{lo},{hi}\n" for x, lo, hi in limits))
        files = [self.stockpile(r, i, sieves, curve) for i, curve in enumerate(curves)]
        aim = r.choice(AIMS)
        names = [pathlib.Path(f).stem for f in files]
        words = ["--spec", "limits.csv", "--minimise", aim, "--step", r.choice(["1%", "5%", "10%", "1kg of 7kg", "2%"])]
        if aim == "cost":
            words += ["--cost", ",".join(f"{n}={r.randrange(1, 200) / 10}" for n in names)]
        elif aim != "none":
            target = sorted(r.randrange(0, 101) for _ in sieves[1:]) + [100]
            target[0] = 0
            words += ["--target", self.write("target.csv", "size_mm,passing_percent\n" +
                                             "".join(f"{x},{p}\n" for x, p in zip(sieves, target)))]
        if r.random() < 0.3:
            words += ["--share", f"{r.choice(names)}={r.choice(['10..60%', '..45%', '5..', '33..34%'])}"]
        if r.random() < 0.3:
            words += ["--at-most-stockpiles", str(r.randrange(1, stockpiles + 1))]
        for limit in ("FM=3..5", "FM=..4.5", "FM-EN=1..", "FM-EN=2..4", "CF=30..75", "CF=20..", "CF=..60"):
            if r.random() < 0.12 and not any(w.startswith(limit.split("=")[0] + "=") for w in words):
                words += ["--limit", limit]
        return files, words

    def stockpile(self, r, i, sieves, curve):
        """Some of the rows, in one of the forms that a gradation has."""
        rows = [(x, p) for x, p in zip(sieves, curve) if p in (0, 100) or r.random() < 0.8]
        form = r.choice(["mm", "mm", "um", "json", "sieve", "retained"])
        if form == "json":
            masses = [b - a for (_, a), (_, b) in zip(rows, rows[1:])] + [0]
            return self.write(f"s{i}.json", json.dumps({"sizes": [x for x, _ in rows], "masses": [str(m) for m in masses]}) + "\n")
        if form == "retained":
            rows = [(x, b - a) for (x, a), (_, b) in zip(rows, rows[1:])] + [(rows[-1][0], 0)]
            return self.write(f"s{i}.csv", "size_mm,retained_g\n" + "".join(f"{x},{m}\n" for x, m in rows))
        header, name = {"um": ("size_um", lambda x: f"{float(x) * 1000:g}"),
                        "sieve": ("sieve", lambda x: INCHES.get(x, x + " mm"))}.get(form, ("size_mm", str))
        return self.write(f"s{i}.csv", header + ",passing_percent\n" + "".join(f"{name(x)},{p}\n" for x, p in rows))

    def case(self, r):
        files, words = self.problem(r)
        proof = pathlib.Path("mdm.proof")
        proof.unlink(missing_ok=True)
        done = subprocess.run([self.mdm, "blend", *files, *words, "--proof", str(proof), "--quiet"], capture_output=True, text=True)
        if not proof.exists():
            self.counts["not answered"] += 1
            assert done.returncode != 0 and done.stderr, done
            return
        self.counts["without a blend"] += "\nblend none\n" in proof.read_text()
        self.check("mdm:", ["limits.csv", *files, "mdm.proof"], 0)
        self.forge(r, "mdm, changed:", ["limits.csv", *files, "mdm.proof"], 3)


def main():
    if len(sys.argv) != 7:
        sys.exit(__doc__)
    count, seed = int(sys.argv[1]), int(sys.argv[2])
    made, mdm, *checkers = [str(pathlib.Path(w).resolve()) for w in sys.argv[3:]]
    run = Run(mdm, checkers)
    import os
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run.made(pathlib.Path(made) / "blends")
        for i in range(count):
            try:
                run.case(random.Random(f"{seed} {i}"))
            except AssertionError:
                print(f"case {i} of seed {seed}:", file=sys.stderr)
                for file in sorted(pathlib.Path().iterdir()):
                    print(f"--- {file}\n{file.read_text()}", file=sys.stderr)
                raise
        os.chdir("/")
    print(", ".join(f"{what} {n}" for what, n in sorted(run.counts.items())))


main()
