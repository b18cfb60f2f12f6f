#!/usr/bin/python3
"""forge_samples.py COUNT SEED MDM MDM_CHECK [CHECKER ...] [--sizes CHECKER ...]: random samples with ties at openings, open ends, ranges, roots and
irrational laws. Of each, `mdm verify --proof` writes a certificate, or says that it is open, as samples.py does in fractions;
all checkers accept its certificate and that of samples.py, with the same line; and of both a changed one has the verdict that
samples.py has. MDM can be - : then there are but the certificates of samples.py. Checkers behind --sizes take no ranges, and
no law but those that give all sizes rational masses: of all else they say so.
"""
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as F

import samples
from exact import decimal

LAWS = [(3, 1)] * 4 + [(1, 1), (2, 1), (1, 2), (3, 2), (5, 2)]


def some_gradation(r):
    """A gradation, its text, and the question's changes."""
    k = r.choice([1, 1, 2, 2, 3, 4, 6])
    if r.random() < .1:  # phi, of halves
        phis = r.sample(range(-6, 7), k + 1)
        phis.sort(reverse=True)
        d = 2 if any(p % 2 for p in phis) else 1
        powers = [F(2)**(-p * d // 2) for p in phis]
        names, head, unit = [decimal_of(F(p, 2)) for p in phis], "size_phi", "mm"
    else:
        unit, d = r.choice(["mm", "mm", "um", "m"]), 1
        head = f"size_{unit}"
        powers = sorted(F(v, 4) for v in r.sample(range(1, 33), k + 1))
        if r.random() < .3:
            powers[0] = F(0)
        names = [decimal(p) for p in powers]
    masses = [r.choice([0, 1, 1, 2, 3, 5, 8]) for _ in range(k)] + [0]
    if not any(masses):
        masses[0] = 1
    factors = [F(r.choice([1, 1, 2, 5]), r.choice([1, 2])) for _ in masses] if r.random() < .2 else None
    tolerances = [F(r.choice([0, 1, 5, 20])) for _ in masses] if r.random() < .3 else None
    return samples.Gradation(powers, masses, d, factors, tolerances, unit), names, head


def decimal_of(value):
    return ("-" if value < 0 else "") + decimal(abs(value))


def csv_of(g, names, head):
    """The gradation file, whatever its masses are now."""
    text = f"{head},mass{',tolerance_percent' if g.t else ''}{',factor' if any(c != 1 for c in g.c) else ''}\n"
    for j, name in enumerate(names):
        text += name + "," + decimal(g.m[j]) + ("," + decimal(g.t[j]) if g.t else "")
        text += ("," + decimal(g.c[j]) if any(c != 1 for c in g.c) else "") + "\n"
    return text


def some_changes(r, g):
    """The lines of a certificate, the options of mdm, and the gradation that is asked about."""
    pan = cut = factor = None
    if g.Y[0] == 0 and r.random() < .3 and g.Y[1] > F(1, 8):
        pan = F(1, 8)
    if g.d == 1 and g.k > 1 and r.random() < .15 and any(g.m[1:]):
        cut = g.Y[1]
    if r.random() < .15:
        factor = r.choice([F(2), F(1, 2), F(3)])
    words = [(name, v) for name, v in (("pan-size", pan), ("cut-below", cut), ("size-factor", factor)) if v is not None]
    unit = {"pan-size": g.unit, "cut-below": g.unit, "size-factor": ""}
    return ([f"{name} {decimal(v)}" for name, v in words],
            [w for name, v in words for w in ("--" + name, decimal(v) + unit[name])], g.asked(pan, cut, factor), factor)


def some_rows(r, g, unit):
    """The text of a sample, its rows in the gradation's unit, and N."""
    to_unit = samples.UNITS[unit] / samples.UNITS[g.unit]
    N = r.choice([2, 3]) if r.random() < .15 else 1
    ranges, quantities = N == 1 and r.random() < .4, r.random() < .8
    text = f"size_lo_{unit},size_hi_{unit}" if ranges else f"size_{unit}" + (f"^{N}" if N > 1 else "")
    text += ",quantity\n" if quantities else "\n"
    rows = []

    def some_size():
        j = r.randrange(g.k)
        lo, hi = (float(g.Y[i])**(1 / g.d) for i in (j, j + 1))
        if r.random() < .3 and g.d == 1 and g.Y[j + 1 if r.random() < .8 else j]:
            x = g.Y[j + 1] if r.random() < .8 or not g.Y[j] else g.Y[j]
        else:
            x = F(round((lo + (hi - lo) * r.choice([0.25, .5, .75, 1, r.random()])) * 8), 8) or F(1, 8)
        if r.random() < .03:
            x = g.Y[-1] * 2
        x = max(x, F(1, 64)) / to_unit
        return x if N > 1 or written(x) else F(round(x * 10**6) or 1, 10**6)
    for _ in range(r.choice([1, 1, 2, 3, 5, 8])):
        x = some_size()
        q, is_open = r.choice([1, 1, 2, 3, 7, 100]) if quantities else 1, False
        lo = hi = x
        if ranges and r.random() < .8:
            width = r.choice([F(1, 10**6), F(1, 1000), F(1, 8), F(1)])
            lo = r.choice([x, x * (1 - width / 2)]) if r.random() < .9 else F(0)
            hi = r.choice([x, x * (1 + width)])
            is_open = lo < hi and r.random() < .3
        if N > 1:
            z = lo**N if r.random() < .5 else F(lo.numerator, lo.denominator) * r.choice([1, 2, F(3, 2), F(1, 3)])
            lo = hi = z
            text += str(z)
        elif ranges:
            text += (">" if is_open else "") + decimal(lo) + "," + decimal(hi)
        else:
            text += decimal(lo)
        text += f",{q}\n" if quantities else "\n"
        rows.append((lo * to_unit**N, hi * to_unit**N, q, is_open))
    return text, rows, N


def written(v):
    d = v.denominator
    for p in (2, 5):
        while d % p == 0:
            d //= p
    return d == 1


def some_tolerance(r, g, derived, factor):
    """Lines that are near to what the sample has; and the options of mdm that say the same."""
    near = lambda e: r.choice([e, F(round(e * 1000), 1000), e * F(9, 10), e * F(11, 10), F(r.choice([0, 1, 5, 20]))])
    percent = lambda v, most: min(max(F(round(v * 10**6), 10**6) if not written(v) else v, F(0)), F(most))
    lines, options = [], []
    if r.random() < .35:
        return samples.Tolerance((), factor), []
    worst = lambda errors: 100 * max((e[1] for e in errors), default=F(0))
    kinds = r.sample(["retained", "passing", "total", "file", "passing-file", "band"], r.choice([1, 1, 2]))
    for kind in ("retained", "file", "passing", "passing-file", "total", "band"):
        if kind not in kinds:
            continue
        if kind in ("file", "passing-file"):
            if g.t:
                word = "retained" if kind == "file" else "passing"
                lines.append((word, None))
                options += ["--tolerance", word + ":file"]
        elif kind == "band":
            if g.d == 1 and not options:
                rows = []
                for j in sorted(r.sample(range(g.k + 1), r.choice([1, min(2, g.k + 1)]))):
                    y = derived.passing[j - 1] if j else (F(0), F(0))
                    lo, hi = (percent(100 * v, 100) for v in y)
                    lo, hi = max(lo - r.choice([0, 1, 10]), F(0)), min(hi + r.choice([0, 0, 1, 10]), F(100))
                    rows.append((g.Y[j] / (factor or 1), lo if j else F(0), max(hi, lo)))
                if all(written(x) for x, _, _ in rows):
                    lines.append(("band", rows))
                    options += ["--band", "limits.csv"]
        else:
            e = percent(near(100 * derived.total[1] if kind == "total" else
                             worst(derived.errors if kind == "retained" else derived.passing_errors)),
                        200 if kind == "total" else 100)
            lines.append((kind, e))
            options += ["--tolerance", f"{kind}:{decimal(e)}"]
    return samples.Tolerance(lines, factor), options


def matched(r, g, derived):
    """Masses with which an exact sample matches, where they have decimals; else those that are there."""
    if r.random() < .5 or any(y[0] != y[1] for y in derived.shares) or not any(y[0] for y in derived.shares):
        return g.m
    scale = 1
    for y in derived.shares:
        scale = scale * y[0].denominator // samples.math.gcd(scale, y[0].denominator)
    return [y[0] * scale for y in derived.shares] + [F(0)]


def changed(r, text):
    """A certificate with one change in the claims, or in a byte."""
    lines = text.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith(("places", "particles")))
    i = r.randrange(first, len(lines))
    words = lines[i].split(" ")
    kind = r.randrange(7)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines.insert(i, lines[i])
    elif kind == 2 and i + 1 < len(lines):
        lines[i], lines[i + 1] = lines[i + 1], lines[i]
    elif kind == 3:
        w = r.randrange(len(words))
        words[w] = r.choice(["yes", "no", "open", "least", "most", "class", "passing", "total", "match", "outside", "0", "1"])
        lines[i] = " ".join(words)
    elif kind in (4, 5):
        numbers = [w for w, word in enumerate(words) if word[:1].isdigit()]
        if numbers:
            w = r.choice(numbers)
            n = F(words[w])
            if "/" in words[w]:
                words[w] = str(n + r.choice([F(1, n.denominator), -F(1, n.denominator), F(1, 10**9)]))
            else:
                unit = F(1, 10**len(words[w].partition(".")[2]))
                words[w] = decimal(max(F(0), n + unit * r.choice([1, -1, 2, -2, 10, -1000])))
            lines[i] = " ".join(words)
    else:
        at = r.randrange(len(lines[i]) + 1)
        lines[i] = lines[i][:at] + r.choice([" ", "0", "9", ".", "/", "-", "\t", "x", ""]) + lines[i][at + r.randrange(2):]
    return "\n".join(lines) + "\n", first


class Run:
    def __init__(self, mdm, checkers, of_sizes):
        self.mdm, self.checkers, self.of_sizes = mdm, checkers, of_sizes
        self.counts, self.is_of_sizes, self.checked = {}, False, []

    def count(self, what):
        self.counts[what] = self.counts.get(what, 0) + 1

    def check(self, proof, expected):
        """The checkers have this exit code and one line, the same where they accept or refuse."""
        lines = set()
        for checker in self.checkers:
            done = subprocess.run([checker, "g.csv", "s.csv", proof], capture_output=True, text=True)
            assert done.returncode == expected, (checker, proof, expected, done)
            lines.add(done.stdout)
        assert len(lines) == 1, lines
        line = lines.pop()
        copy = f"{len(self.checked)}.proof"
        pathlib.Path(copy).write_text(pathlib.Path(proof).read_text())
        self.checked.append((copy, expected, line))
        return line

    def check_of_sizes(self):
        """The checkers of sizes say the same of all certificates of a case, or that they take none."""
        words = [w for proof, _, _ in self.checked for w in ("g.csv", "s.csv", proof)]
        for checker in self.of_sizes if words else []:
            done = subprocess.run([checker, "--samples", *words], capture_output=True, text=True)
            expected = max(code for _, code, _ in self.checked) if self.is_of_sizes else 2
            lines = "".join(line for _, _, line in self.checked) if self.is_of_sizes else ""
            assert (done.returncode, done.stdout) == (expected, lines), (checker, expected, lines, done)
            if not self.is_of_sizes:
                assert len(self.checked) == len(done.stderr.splitlines()), (checker, done)
                assert done.stderr.count(": use mdm-check\n") >= sum(code < 2 for _, code, _ in self.checked), (checker, done)
            for _, code, _ in self.checked:
                self.count("--sizes: " + (("accepted", "refused", "malformed")[code] if self.is_of_sizes else "not taken"))
        self.checked = []

    def case(self, r):
        g, names, head = some_gradation(r)
        law = r.choice(LAWS)
        options, flags, asked, factor = some_changes(r, g)
        unit = r.choice(["mm", "mm", "um", "m", "in"])
        text, rows, N = some_rows(r, asked, unit)
        places = r.choice([0, 5, 20, 40])
        derive = lambda P: samples.Derived(asked, law, rows, N, P)
        derived = derive(places)
        first = len(g.Y) - len(asked.Y)
        masses = matched(r, asked, derived)
        g.m[first:], asked.m = masses, list(masses)
        if not any(g.m):
            return self.count("no mass")
        derived = derive(places)
        self.is_of_sizes = not text.startswith("size_lo_") and derived.e == 1
        tolerance, asked_flags = some_tolerance(r, asked, derived, factor)
        pathlib.Path("g.csv").write_text(csv_of(g, names, head))
        pathlib.Path("s.csv").write_text(text)
        for name, value in tolerance.lines:
            if name == "band":
                rows_of = "".join(f"{decimal(x)},{decimal(lo)},{decimal(hi)}\n" for x, lo, hi in value)
                pathlib.Path("limits.csv").write_text(f"size_{g.unit},passing_min_percent,passing_max_percent\n" + rows_of)
        made = samples.certificate(derived, law, tolerance, options, places, r.choice([0, 3, 6]), r.choice)
        if made:
            pathlib.Path("made.proof").write_text(made)
            self.expect_line(self.check("made.proof", 0), derived, made)
            self.count("made")
            self.forge(r, made, derive, tolerance)
        else:
            self.count("open")
        if self.mdm != "-":
            self.verify(r, law, flags + asked_flags, derive, tolerance)

    def verify(self, r, law, flags, derive, tolerance):
        pathlib.Path("mdm.proof").unlink(missing_ok=True)
        done = subprocess.run([self.mdm, "verify", "g.csv", "s.csv", "--proof", "mdm.proof", "--format", "csv", "--quiet",
                               "--law", f"power:{law[0]}/{law[1]}", *flags], capture_output=True, text=True)
        assert done.returncode in (0, 1, 3), done
        proof = pathlib.Path("mdm.proof")
        said = derive(60).verdicts(tolerance)
        if done.returncode == 3:
            assert not proof.exists(), done
            assert not said or derive(60).e > 1, (said, done)
            return self.count("mdm: open")
        assert not pathlib.Path("mdm.proof.sample.csv").exists()
        if not proof.exists(): # mdm tells more: several roots, or that one class alone has particles
            # mdm has 30 places or more; those with more lie between those with fewer.
            assert not said or not derive(30).verdicts(tolerance), (said, done)
            return self.count("mdm: none")
        assert said and (done.returncode == 0) == (said == [("match",)]), (said, done)
        written = proof.read_text()
        first = min(written.index(word) for word in ("\nplaces", "\nparticles") if word in written) + 1
        assert samples.judge(written[first:], derive, tolerance) == 0, written
        self.check("mdm.proof", 0)
        self.count("mdm: match" if done.returncode == 0 else "mdm: no match")
        self.forge(r, written, derive, tolerance)

    def forge(self, r, text, derive, tolerance):
        for _ in range(2):
            forged, first = changed(r, text)
            if forged == text:
                continue
            head = "".join(line + "\n" for line in text.splitlines()[:first])
            if not forged.startswith(head) or forged[len(head):].startswith(("passing ", "total ")): # a line of a tolerance
                continue
            expected = samples.judge(forged[len(head):], derive, tolerance)
            pathlib.Path("forged.proof").write_text(forged)
            self.check("forged.proof", expected)
            self.count(("forged: true", "forged: refused", "forged: malformed")[expected])

    @staticmethod
    def expect_line(line, derived, made):
        one, matches = derived.n == 1, "\nverdict match\n" in made
        words = ("matches" if one else "match") if matches else "does not match" if one else "do not match"
        assert line.startswith(f'accepted: the {derived.n} particle{"" if one else "s"} of "s.csv" {words} "g.csv" '), line
        conditions = ", ".join(f"{i + 1} {c}" for i, c in enumerate(derived.conditions))
        assert f"; conditions {conditions} (" in line and line.endswith(")\n"), line


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    count, seed = int(sys.argv[1]), int(sys.argv[2])
    words = [w if w in ("-", "--sizes") else str(pathlib.Path(w).resolve()) for w in sys.argv[3:]] + ["--sizes"]
    i = words.index("--sizes")
    run = Run(words[0], words[1:i], words[i + 1:-1])
    with tempfile.TemporaryDirectory() as folder:
        import os
        os.chdir(folder)
        for i in range(count):
            r = random.Random(f"{seed} {i}")
            try:
                run.case(r)
                run.check_of_sizes()
            except AssertionError:
                print(f"case {i} of seed {seed}:", file=sys.stderr)
                for name in ("g.csv", "s.csv", "limits.csv", "made.proof", "mdm.proof", "forged.proof"):
                    if pathlib.Path(name).exists():
                        print(f"--- {name}\n{pathlib.Path(name).read_text()}", file=sys.stderr)
                raise
        os.chdir("/")
    print(", ".join(f"{what} {n}" for what, n in sorted(run.counts.items())))


main()
