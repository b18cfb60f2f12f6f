#!/usr/bin/python3
"""What proofs/certificate-format.md, section 12, derives of a sample, in fractions and by readings of its own: certificates
for tests, and the verdict on any. `forge_samples.py` and `make.py` use it; what is tested has no part in it.
"""
import math
import re
from fractions import Fraction as F

from exact import decimal, root

UNITS = {"mm": F(1), "um": F(1, 1000), "m": F(1000), "in": F(254, 10)}


class Gradation:
    """Openings to the power d, ascending, masses and factors of classes, tolerances of openings."""

    def __init__(self, powers, masses, d=1, factors=None, tolerances=None, unit="mm"):
        self.Y, self.m, self.d, self.unit = list(powers), [F(v) for v in masses], d, unit
        self.c, self.t = list(factors or [F(1)] * len(self.Y)), tolerances and list(tolerances)

    def asked(self, pan=None, cut=None, factor=None):
        """With the changes of a question, which fit."""
        Y, first = list(self.Y), 0
        if pan is not None:
            Y[0] = F(pan)**self.d
        if cut is not None:
            first = Y.index(F(cut)**self.d)
        scale = F(factor or 1)**self.d
        return Gradation([y * scale for y in Y[first:]], self.m[first:], self.d, self.c[first:],
                         self.t and self.t[first:], self.unit)

    @property
    def k(self):
        return len(self.Y) - 1


class Tolerance:
    """The lines of a tolerance: (word, value) with value None for `file`, a list of percents, or one."""

    def __init__(self, lines=(), factor=None):
        self.lines, self.factor = list(lines), F(factor or 1)

    def text(self):
        rows = []
        for word, value in self.lines:
            if word == "band":
                rows += ["band " + " ".join(decimal(v) for v in row) for row in value]
            elif word == "passing-each":
                rows.append("passing-each " + " ".join(decimal(v) for v in value))
            else:
                rows.append(f"{word} {'file' if value is None else decimal(value)}")
        return "".join(row + "\n" for row in rows)

    def bounds(self, g, shares):
        """For each class the bounds on its share and on what passes its upper opening; and on the total."""
        k, zero, one = g.k, F(0), F(1)
        retained, passing, total = [[zero, one] for _ in range(k)], [[zero, one] for _ in range(k)], None

        def narrow(pair, lo, hi):
            pair[0], pair[1] = max(pair[0], lo), min(pair[1], hi)
        G = [sum(shares[:j + 1]) for j in range(k)]
        for word, value in self.lines or [("retained", F(0))]:
            if word == "retained":
                for j in range(k):
                    e = (g.t[j] if value is None else value) / 100
                    narrow(retained[j], shares[j] - e, shares[j] + e)
            elif word in ("passing", "passing-each"):
                for j in range(k - 1):
                    e = (g.t[j + 1] if value is None else value[j] if word == "passing-each" else value) / 100
                    narrow(passing[j], G[j] - e, G[j] + e)
            elif word == "total":
                total = value / 100
            else:
                for x, lo, hi in value:
                    power = (x * self.factor)**g.d
                    if power > g.Y[0]:
                        j = k - 1 if power > g.Y[-1] else g.Y.index(power) - 1
                        narrow(passing[j], lo / 100, hi / 100)
        return retained, passing, total


class Derived:
    """What rows (lo, hi, quantity, open), of N-th powers in the gradation's unit, say of a gradation."""

    def __init__(self, g, law, rows, N, places=0):
        a, b = law
        common = math.gcd(a, b * N)
        self.e, exponent = b * N // common, a // common
        unit = rows[0][1] if self.e > 1 else F(1)
        self.g, k = g, g.k
        self.below = self.above = self.unplaced = 0
        self.q = [0] * k
        least, most = [F(0)] * k, [F(0)] * k
        seen, outside = [[] for _ in range(k)], False
        for lo, hi, q, is_open in rows:
            last = sum(y**N < hi**g.d for y in g.Y)
            first = sum(y**N < lo**g.d or ((is_open or lo == 0) and y**N == lo**g.d) for y in g.Y)
            if first < last:
                self.unplaced += q
                outside = outside or first == 0 or last == k + 1
            elif first == 0:
                self.below += q
            elif first == k + 1:
                self.above += q
            else:
                self.q[first - 1] += q
                seen[first - 1].append((lo, hi))
                least[first - 1] += q * self.mass(lo / unit, exponent, places)[0]
            for j in range(max(first, 1), min(last, k) + 1):
                most[j - 1] += q * self.mass(hi / unit, exponent, places)[1]
        least, most = ([c * t for c, t in zip(g.c, of)] for of in (least, most))
        self.n = self.below + self.above + self.unplaced + sum(self.q)
        self.find_shares(least, most)
        self.find_conditions(seen, outside)

    def mass(self, z, exponent, places):
        T = z**exponent
        roots = root(T.numerator, self.e), root(T.denominator, self.e)
        if roots[0]**self.e == T.numerator and roots[1]**self.e == T.denominator:
            return (F(*roots),) * 2
        m = root(T.numerator * 10**(places * self.e) // T.denominator, self.e)
        return F(m, 10**places), F(m + 1, 10**places)

    def find_shares(self, least, most):
        g, k = self.g, self.g.k
        all_least, all_most = sum(least), sum(most)
        self.shares = [(t / all_most if all_most else F(0),
                        min(F(1), T / all_least) if all_least else F(bool(all_most))) for t, T in zip(least, most)]
        self.passing = [(sum(y[0] for y in self.shares[:j + 1]), min(F(1), sum(y[1] for y in self.shares[:j + 1])))
                        for j in range(k)]
        if all_least:
            self.passing[-1] = F(1), F(1)
        self.targets = [m / sum(g.m) for m in g.m[:-1]]
        error = lambda y, t: (F(0) if y[0] <= t <= y[1] else min(abs(y[0] - t), abs(y[1] - t)),
                              max(abs(y[0] - t), abs(y[1] - t)))
        self.errors = [error(y, t) for y, t in zip(self.shares, self.targets)]
        self.passing_errors = [error(self.passing[j], sum(self.targets[:j + 1])) for j in range(k - 1)]
        self.total = sum(e[0] for e in self.errors), sum(e[1] for e in self.errors)

    def find_conditions(self, seen, outside):
        word = lambda yes, no: "no" if no else "yes" if yes else "open"
        gone = self.below + self.above > 0
        second = word(not outside, gone)
        placed = second == "yes" and not self.unplaced
        differ = any(x[0] > y[1] for of in seen for x in of for y in of)
        same = all(q <= 1 or {v for row in of for v in row} == {of[0][0]} for q, of in zip(self.q, seen))
        unequal = any(not y[0] <= t <= y[1] for y, t in zip(self.shares, self.targets))
        equal = all(y == (t, t) for y, t in zip(self.shares, self.targets))
        self.conditions = ["yes", second, word(placed and same, gone or differ), word(placed and equal, gone or unequal)]

    def verdicts(self, tolerance):
        """All that can be said: ("match",), ("outside",), or (kind, j, found, side, bound of that side)."""
        retained, passing, total = tolerance.bounds(self.g, self.targets)
        said = [("outside",)] if self.below + self.above else []
        values = [("class", j + 1, y, lo, hi) for j, (y, (lo, hi)) in enumerate(zip(self.shares, retained))]
        values += [("passing", j + 1, y, lo, hi) for j, (y, (lo, hi)) in enumerate(zip(self.passing, passing))]
        values += [("total", None, self.total, F(0), total)] if total is not None else []
        if not said and not self.unplaced and all(lo <= y[0] and y[1] <= hi for _, _, y, lo, hi in values):
            return [("match",)]
        for kind, j, y, lo, hi in values:
            if kind == "passing" and j == self.g.k:
                continue
            if y[1] < lo:
                said.append((kind, j, y, "least", lo))
            if y[0] > hi:
                said.append((kind, j, y, "most", hi))
        return said


def around(y, places):
    """Decimal percents around a share, as texts."""
    scale = 100 * 10**places
    return decimal(F(math.floor(y[0] * scale), 10**places)), decimal(F(math.ceil(y[1] * scale), 10**places))


def certificate(derived, law, tolerance, options=(), places=None, digits=6, choose=lambda verdicts: verdicts[0]):
    """The text of a certificate; nothing where the verdict is open."""
    verdicts = derived.verdicts(tolerance)
    if not verdicts:
        return None
    lines = ["mdm-certificate sample 1", "law " + (str(law[0]) if law[1] == 1 else f"{law[0]}/{law[1]}"), *options]
    lines += tolerance.text().splitlines()
    lines += [f"places {places}"] if derived.e > 1 else []
    lines.append(f"particles {derived.n}")
    lines += [f"{word} {n}" for word in ("below", "above", "unplaced") if (n := getattr(derived, word))]
    for j, (q, y) in enumerate(zip(derived.q, derived.shares)):
        share = str(100 * y[0]) if y[0] == y[1] else " ".join(around(y, digits))
        lines.append(f"class {j + 1} {q} {share}")
    for name, errors in (("retained-error", derived.errors), ("passing-error", derived.passing_errors)):
        if errors:
            j = max(range(len(errors)), key=lambda i: errors[i][1])
            lines.append(f"{name} {j + 1} {' '.join(around(errors[j], digits))}")
    lines.append("total-error " + " ".join(around(derived.total, digits)))
    lines.append("conditions " + " ".join(derived.conditions))
    said = choose(verdicts)
    if len(said) == 1:
        lines.append("verdict " + said[0])
    else:
        kind, j, y, side, bound = said
        while True:
            p, r = around(y, digits)
            v = decimal(F((math.floor if side == "least" else math.ceil)(bound * 100 * 10**digits), 10**digits))
            if F(r) < F(v) if side == "least" else F(v) < F(p):
                break
            digits += 1
        lines.append(f"verdict {kind} {f'{j} ' if j else ''}{p} {r} {side} {v}")
    return "\n".join(lines + ["end"]) + "\n"


INTEGER, DECIMAL = r"(?:0|[1-9]\d*)", r"(?:0|[1-9]\d*)(?:\.\d*[1-9])?"
RATIONAL = INTEGER + r"(?:/[1-9]\d*)?"
INDEX = r"(?:0|[1-9]\d{0,17})"
CLAIMS = re.compile(
    rf"(?:places (?P<places>{INTEGER})\n)?particles (?P<n>[1-9]\d*)\n"
    rf"(?:below (?P<below>[1-9]\d*)\n)?(?:above (?P<above>[1-9]\d*)\n)?(?:unplaced (?P<unplaced>[1-9]\d*)\n)?"
    rf"(?P<classes>(?:class {INDEX} {INTEGER} (?:{RATIONAL}|{DECIMAL} {DECIMAL})\n)*)"
    rf"retained-error (?P<retained>{INDEX} {DECIMAL} {DECIMAL})\n"
    rf"(?:passing-error (?P<passing>{INDEX} {DECIMAL} {DECIMAL})\n)?total-error (?P<total>{DECIMAL} {DECIMAL})\n"
    r"conditions (?P<conditions>(?:(?:yes|no|open) ){3}(?:yes|no|open))\n"
    rf"verdict (?P<verdict>match|outside|(?:class|passing) {INDEX} {DECIMAL} {DECIMAL} (?:least|most) {DECIMAL}"
    rf"|total {DECIMAL} {DECIMAL} most {DECIMAL})\nend\n")


def is_lowest(text):
    parts = [int(v) for v in text.split("/")]
    return len(parts) == 1 or (parts[1] > 1 and math.gcd(*parts) == 1)


def judge(claims, derive, tolerance):
    """0, 1 or 2, the exit code for the lines from `places` on. derive(places) is what the sample says."""
    found = CLAIMS.fullmatch(claims)
    if not found or int(found["places"] or 0) > 1000:
        return 2
    rows = [row.split()[1:] for row in found["classes"].splitlines()]
    if any((not is_lowest(row[2])) if len(row) == 3 else F(row[2]) >= F(row[3]) for row in rows):
        return 2
    verdict = found["verdict"].split()
    pairs = [found["retained"].split()[1:], found["total"].split()]
    pairs += [found["passing"].split()[1:]] if found["passing"] else []
    pairs += [verdict[-4:-2]] if len(verdict) > 1 else []
    if any(F(p) > F(r) for p, r in pairs):
        return 2
    d = derive(int(found["places"] or 0))
    encloses = lambda p, r, y: F(p) <= 100 * y[0] and 100 * y[1] <= F(r)

    def largest(text, errors):
        if not text or not errors:
            return not text and not errors
        j, p, r = text.split()
        return 1 <= int(j) <= len(errors) and F(p) <= 100 * errors[int(j) - 1][0] and all(
            100 * e[1] <= F(r) for e in errors)
    holds = (found["places"] is not None) == (d.e > 1)
    holds = holds and [int(found[word] or 0) for word in ("n", "below", "above", "unplaced")] == [
        d.n, d.below, d.above, d.unplaced]
    holds = holds and len(rows) == d.g.k and all(
        int(row[0]) == j + 1 and int(row[1]) == d.q[j] and encloses(row[2], row[-1], d.shares[j])
        for j, row in enumerate(rows))
    holds = holds and largest(found["retained"], d.errors) and largest(found["passing"], d.passing_errors)
    holds = holds and encloses(*found["total"].split(), d.total) and found["conditions"].split() == d.conditions
    said = d.verdicts(tolerance)
    if len(verdict) == 1:
        return 0 if holds and (verdict[0],) in said else 1
    kind, (p, r, side, v) = verdict[0], verdict[-4:]
    for each in said:
        if len(each) == 5 and each[0] == kind and each[3] == side and (kind == "total" or each[1] == int(verdict[1])):
            asked = F(r) < F(v) <= 100 * each[4] if side == "least" else 100 * each[4] <= F(v) < F(p)
            return 0 if holds and encloses(p, r, each[2]) and asked else 1
    return 1
