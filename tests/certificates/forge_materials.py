#!/usr/bin/python3
"""Certificates of gradations of several materials, true and forged: mdm-check and mdm-check-verified have to print the same line of
each, and end alike; none may accept a number of particles that is not the smallest.

forge_materials.py COUNT SEED MDM MDM_CHECK VERIFIED draws so many gradations, whose materials overlap, has mdm prove the smallest
match of each, and changes certificates and gradations in places."""
import collections
import pathlib
import random
import re
import subprocess
import sys
import tempfile

NAMES = ("quartz", "shell", "a", "a b", 'x "y"', "one; two", "back\\slash", "\u00e9clat", "1, 2", "z")
OPTIONS = ([], ["--at-least", "12"], ["--min-per-class", "2"], ["--size-factor", "3"], ["--law", "power:2"],
           ["--tolerance", "retained:10%"], ["--tolerance", "total:20%"], ["--tolerance", "retained:12%", "--tolerance", "total:15%"],
           ["--tolerance", "retained:20%", "--min-per-class", "1"], ["--solids-volume", "9"],
           ["--tolerance", "total:20%", "--solids-volume", "9"])


def quoted(name):
    return '"' + name.replace('"', '""') + '"'


def gradation(r):
    """A file with its rows in any order."""
    factors = r.random() < .5
    header = ["size_mm", r.choice(("mass", "retained_g"))] + ["material"]
    rows = []
    for name in r.sample(NAMES, r.choice((1, 2, 2, 3))):
        sizes = sorted(r.sample(range(0, 9), r.randint(2, 4)))
        masses = [r.randint(0, 5) for _ in sizes[1:]]
        masses[r.randrange(len(masses))] += 1
        factor = r.choice(("1", "2.65", "0.5"))
        rows += [[str(x), str(m), quoted(name)] + [factor] * factors for x, m in zip(sizes, masses + [0])]
    r.shuffle(rows)
    return "\n".join(",".join(row) for row in [header + ["factor"] * factors] + rows) + "\n"


def changed(text, r):
    """With a number, a line, a word or a byte of it changed."""
    lines = text.splitlines()
    kind = r.randrange(5)
    if kind == 0:
        number = r.choice(list(re.finditer(r"\d+", text)))
        return text[:number.start()] + str(max(0, int(number[0]) + r.choice((-1, 1, 10)))) + text[number.end():]
    if kind == 1:
        lines.pop(r.randrange(len(lines)))
    elif kind == 2:
        lines.insert(r.randrange(len(lines)), r.choice(lines))
    elif kind == 3:
        lines.insert(r.randint(1, 3), r.choice(("pan-size 0.1", "cut-below 2", "retained file", "passing 5", "band file", "retained 5",
                                                "size-factor 2", "total 9", "passing-each 1 2")))
    else:
        place = r.randrange(len(text))
        return text[:place] + r.choice("0 1;,\"\n#materl") + text[place + 1:]
    return "\n".join(lines) + "\n"


def verdict(program, *files):
    done = subprocess.run([program, *files], capture_output=True, timeout=300)
    return done.returncode, done.stdout.decode("utf-8", "surrogateescape")


class Both:
    """What both checkers say."""

    def __init__(self, folder, checkers):
        self.table, self.proof = folder / "g.csv", folder / "p"
        self.checkers = checkers
        self.counts = collections.Counter()
        self.failures = []

    def judge(self, table, proof):
        self.table.write_text(table, encoding="utf-8")
        self.proof.write_text(proof, encoding="utf-8")
        code, line = said = verdict(self.checkers[0], self.table, self.proof)
        if said != verdict(self.checkers[1], self.table, self.proof):
            self.failures.append((said, verdict(self.checkers[1], self.table, self.proof), table, proof))
        if verdict(self.checkers[0], "--print", self.table) != verdict(self.checkers[1], "--print", self.table):
            self.failures.append(("--print", table))
        self.counts[code] += 1
        return code, line


def main(count, seed, mdm, *checkers):
    r = random.Random(seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        both = Both(folder, checkers)
        true = 0
        while true < count:
            table, options = gradation(r), r.choice(OPTIONS)
            (folder / "g.csv").write_text(table, encoding="utf-8")
            done = subprocess.run([mdm, "solve", folder / "g.csv", "--proof", folder / "true", *options], capture_output=True)
            if done.returncode != 0:
                continue
            true += 1
            proof = (folder / "true").read_text(encoding="utf-8")
            code, line = both.judge(table, proof)
            if code != 0 or "; classes of the materials " not in line:
                both.failures.append(("not accepted", line, table, proof))
            smallest = int(re.search(r"^particles (\d+)$", proof, re.M)[1])
            for N in (smallest - 1, smallest + 1):
                if both.judge(table, re.sub(r"^particles \d+$", f"particles {N}", proof, flags=re.M))[0] == 0:
                    both.failures.append(("accepted", N, table, proof))
            for _ in range(3):
                both.judge(table, changed(proof, r))
                both.judge(changed(table, r), proof)
    for failure in both.failures[:3]:
        print(*failure, sep="\n")
    print(f"accepted {both.counts[0]}, refused {both.counts[1]}, malformed {both.counts[2]}; {len(both.failures)} failures")
    return 1 if both.failures or not all(both.counts[code] >= count for code in (0, 1, 2)) else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:]))
