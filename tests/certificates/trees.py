"""The smallest match within a tolerance and its certificate, in fractions: by trying all counts, with a solver of
linear systems that knows nothing but pivots."""
import math
from fractions import Fraction as F
from itertools import combinations_with_replacement, count

from exact import decimal, enclose

PI = ("3.14159265358979323846", "3.14159265358979323847")


def first_phase(columns, right):
    """Some y >= 0 with sum y_i columns_i = right and None; or None and some z with z columns_i <= 0 < z right. The first
    phase of the simplex method, with Bland's rule where the steepest takes long."""
    rows, n = len(right), len(columns)
    sign = [-1 if b < 0 else 1 for b in right]
    table = [[sign[i] * columns[j][i] for j in range(n)] + [F(i == k) for k in range(rows)] + [sign[i] * right[i]]
             for i in range(rows)]
    basis = list(range(n, n + rows))
    cost = [sum(table[i][j] for i in range(rows)) for j in range(n)] + [F(0)] * rows
    cost.append(sum(table[i][-1] for i in range(rows)))
    for step in count():
        rising = [j for j in range(n) if cost[j] > 0]
        if not rising:
            break
        enter = rising[0] if step > 200 else max(rising, key=lambda j: cost[j])
        leave = min((table[i][-1] / table[i][enter], basis[i], i) for i in range(rows) if table[i][enter] > 0)[2]
        pivot = table[leave][enter]
        table[leave] = [v and v / pivot for v in table[leave]]
        for row in [*(table[i] for i in range(rows) if i != leave), cost]:
            if row[enter]:
                factor = row[enter]
                row[:] = [v - factor * w if w else v for v, w in zip(row, table[leave])]
        basis[leave] = enter
    if cost[-1] != 0:
        return None, [sign[i] * (cost[n + i] + 1) for i in range(rows)]
    y = [F(0)] * (n + rows)
    for i in range(rows):
        y[basis[i]] = table[i][-1]
    return y[:n], None


def solution(columns, right):
    """Some y >= 0 with sum y_i columns_i = right, or None."""
    return first_phase(columns, right)[0]


def whole(values, names):
    """Multiples in integers: pairs with the names of those above 0."""
    scale = math.lcm(*(v.denominator for v in values))
    scale = F(scale, math.gcd(*(int(v * scale) for v in values)))
    return [(int(v * scale), n) for v, n in zip(values, names) if v]


class Tree:
    """A gradation x, m, c (texts) and a question with a tolerance: its least match, and the certificate.

    tolerance: lines of the certificate; file: the column tolerance_percent; most: where to give up, for `none`.
    Version 2: sums are splits (i, j, v) of classes from i to j, first of all, avoid the letters of conditions that leaves
    do without, and below is a bound on all matches, claimed alone where with_witness is false."""

    def __init__(self, x, m, tolerance, c=None, file=None, law=(3, 1), pan=None, cut=None, factor=None, least=None,
                 cylinder=None, volume=None, at_least=None, most=12, places=12, degree=1, band_file=False, sums=(),
                 avoid="", below=None, with_witness=True):
        """Where the degree is d, x holds openings to the power d: the same gradation of them under the law a/(b d).
        With band_file the lines `band` of the tolerance are those of the gradation's file."""
        self.law, self.d, self.band_file = law, degree, band_file
        exponent = F(law[0], law[1] * degree)
        self.a, self.b = exponent.numerator, exponent.denominator
        self.tolerance = tolerance
        self.options = [f"{word} {value}" for word, value in
                        (("pan-size", pan), ("cut-below", cut), ("size-factor", factor), ("min-per-class", least),
                         ("cylinder", cylinder), ("solids-volume", volume),
                         ("pi", " ".join(PI) if volume else None), ("at-least", at_least)) if value]
        x, m = [F(v) for v in x], [F(v) for v in m]
        c, file = [F(v) for v in c or ["1"] * len(x)], [F(v) for v in file or ["0"] * len(x)]
        if pan:
            x[0] = F(pan)
        if cut:
            x, m, c, file = (column[x.index(F(cut)):] for column in (x, m, c, file))
        self.x = [v * F(factor or 1) for v in x]
        self.k, self.c, self.m = len(x) - 1, c, m
        # Openings are b-th powers: their roots are found by trying.
        roots = [next(r for u in range(1, 100) for n in range(int(v * u) + 2) if (r := F(n, u))**self.b == v)
                 if self.b > 1 else v for v in self.x]
        self.f = [c[j] * roots[j]**self.a for j in range(self.k)]
        self.F = [c[j] * roots[j + 1]**self.a for j in range(self.k)]
        self.least = [int(least or 0) if m[j] > 0 else 0 for j in range(self.k)]
        self.at_least = max(1, int(at_least or 1))
        self.weight = self.enough = F(0)
        if cylinder:
            D, H, e = map(F, cylinder.split())
            self.weight = self.enough = 3 * D * D * H / (2 * (1 + e))
        if volume:
            self.weight, self.enough = (6 * F(volume) / F(p) for p in reversed(PI))
        self.bound(file, F(factor or 1))
        self.second, self.avoid = bool(sums or below), ""
        self.B = self.N = None
        self.N, self.q, self.t = next(((n, q, t) for n in range(self.at_least, most + 1) for q in self.counts(n)
                                       if (t := self.masses(q))), (None, None, None))
        self.B, self.avoid, self.nodes = below or self.N, avoid, []
        self.grow(self.least, [None] * self.k, {}, sums)
        self.N = self.N if with_witness else None
        if self.N:
            self.sizes = [enclose((self.t[j] / (self.q[j] * c[j]))**self.b, self.a * degree, self.x[j],
                                  self.x[j + 1], places, degree)
                          if self.q[j] else None for j in range(self.k)]

    def counts(self, n):
        """All counts with the sum n."""
        for cuts in combinations_with_replacement(range(n + 1), self.k - 1):
            ends = [0, *cuts, n]
            q = [ends[j + 1] - ends[j] for j in range(self.k)]
            if all(v >= l for v, l in zip(q, self.least)):
                yield q

    def bound(self, file, factor):
        """What the lines demand: bounds on shares, and the total."""
        whole = sum(self.m)
        self.g = [m / whole for m in self.m[:-1]]
        G = [sum(self.g[:j + 1]) for j in range(self.k)]
        self.retained, self.passing = [[[F(0), F(1)] for _ in self.g] for _ in range(2)]
        self.e = F(2)

        def narrow(bounds, lo, hi):
            bounds[:] = max(bounds[0], lo), min(bounds[1], hi)

        for line in self.tolerance:
            word, *values = line.split()
            if word == "total":
                self.e = F(values[0]) / 100
            elif word == "band":
                X, lo, hi = (F(values[0]) * factor)**self.d, F(values[1]) / 100, F(values[2]) / 100
                if X > self.x[0]:
                    narrow(self.passing[self.x.index(X) - 1 if X in self.x else self.k - 1], lo, hi)
            else:
                for j in range(self.k if word == "retained" else self.k - 1):
                    E = F(values[j] if word == "passing-each" else
                          file[j + (word == "passing")] if values == ["file"] else values[0]) / 100
                    bounds, share = (self.retained, self.g) if word == "retained" else (self.passing, G)
                    narrow(bounds[j], share[j] - E, share[j] + E)

    def conditions(self, least, most, of_sums=None):
        """name: (coefficients of q, t, p; right side; strict). of_sums: (i, j): [least, most] of these classes."""
        k = self.k
        one = [[F(i == j) for i in range(k)] for j in range(k)]
        upto = [[F(i <= j) for i in range(k)] for j in range(k)]
        none, all_ = [F(0)] * k, [F(1)] * k

        def times(s, v):
            return [s * u for u in v]

        def share(row, s):
            return [u - s for u in row]

        rows = {}
        for j in range(k):
            J = str(j + 1)
            rows["f" + J] = (times(-self.f[j], one[j]) + one[j] + none, 0, least[j] >= 1)
            rows["F" + J] = (times(self.F[j], one[j]) + times(-1, one[j]) + none, 0, False)
            rows["q" + J] = (one[j] + none + none, least[j], False)
            if most[j] is not None:
                rows["Q" + J] = (times(-1, one[j]) + none + none, -most[j], False)
            for word, row, (lo, hi) in (("rR", one, self.retained[j]), ("pP", upto, self.passing[j])):
                rows[word[0] + J] = (none + share(row[j], lo) + none, 0, False)
                rows[word[1] + J] = (none + times(-1, share(row[j], hi)) + none, 0, False)
            rows["e" + J] = (none + times(-1, share(one[j], self.g[j])) + one[j], 0, False)
            rows["x" + J] = (none + none + one[j], 0, False)
        rows["E"] = (none + times(self.e / 2, all_) + times(-1, all_), 0, False)
        rows["m"] = (none + all_ + none, 0, True)
        rows["w"] = (none + [(1 / self.c[j] if self.weight else F(0)) for j in range(k)] + none, self.weight, False)
        rows["n"] = (all_ + none + none, self.at_least, False)
        if self.B:
            rows["N"] = (times(-1, all_) + none + none, 1 - self.B, False)
        for i in range(k) if self.second else ():
            for j in range(i + 1, k):
                low, high = (of_sums or {}).get((i, j), (0, None))
                here = [F(i <= b <= j) for b in range(k)]
                name = f"{i + 1}-{j + 1}"
                rows["s" + name] = (here + none + none, low, False)
                if high is not None:
                    rows["S" + name] = (times(-1, here) + none + none, -high, False)
                rows["d" + name] = ([-f * u for f, u in zip(self.f, here)] + here + none, 0, low >= 1)
        return rows

    def leaf(self, least, most, of_sums=None):
        """Multiples that add up to a contradiction, 0 >= 1 or else 0 > 0; or None."""
        rows = self.conditions(least, most, of_sums)
        names = sorted(name for name in rows if name[0] not in self.avoid)
        for strict in (False, True):
            right = [F(0)] * (3 * self.k) + ([F(0), F(1)] if strict else [F(1)])
            columns = [rows[n][0] + [F(rows[n][1])] + ([F(rows[n][2])] if strict else []) for n in names]
            y = solution(columns, right)
            if y:
                return whole(y, names)
        return None

    def grow(self, least, most, of_sums, sums):
        leaf = self.leaf(least, most, of_sums)
        if leaf:
            self.nodes.append(["leaf", leaf])
            return
        if sums:
            i, j, v = sums[0]
            low, high = of_sums.get((i - 1, j - 1), (0, None))
            self.nodes.append(["split", f"{i}-{j}", v])
            self.grow(least, most, {**of_sums, (i - 1, j - 1): (low, v - 1 if high is None else min(high, v - 1))}, sums[1:])
            self.grow(least, most, {**of_sums, (i - 1, j - 1): (max(low, v), high)}, sums[1:])
            return
        top = [self.B - 1 if u is None else u for u in most]
        j = max(range(self.k), key=lambda i: (least[i] < top[i], least[i] == 0, top[i] - least[i]))
        v = 1 if least[j] == 0 else (least[j] + top[j] + 1) // 2
        self.nodes.append(["split", j + 1, v])
        self.grow(least, [v - 1 if i == j else u for i, u in enumerate(most)], of_sums, ())
        self.grow([v if i == j else u for i, u in enumerate(least)], most, of_sums, ())

    def masses(self, q):
        """Masses that make the counts a match, off all open bounds by some part; or None."""
        if self.leaf(q, q):
            return None
        rows = self.conditions(q, q)
        for part in (F(1, 10), F(1, 1000), F(1, 10**6)):
            columns, right = [[] for _ in range(2 * self.k)], []
            for name, (coefficients, constant, strict) in rows.items():
                if name[0] in "qQnsSd":
                    continue
                if name == "w":
                    constant = self.enough
                # An upper opening that is irrational is the size of no decimal.
                inside = name[0] == "F" and self.d > 1 and q[int(name[1:]) - 1] > 0
                over = part if (name[0] == "f" and strict) or inside else F(0)
                right.append(constant - sum(u * v for u, v in zip(coefficients, q)) + over)
                for i, column in enumerate(columns):
                    column.append(coefficients[self.k + i])
            n = len(right)
            columns += [[-F(i == j) for i in range(n)] for j in range(n)]
            y = solution(columns, right)
            if y and sum(y[:self.k]) > 0:
                return y[:self.k]
        return None

    def version(self):
        return 2 if self.second else 1

    def proof(self):
        lines = [f"mdm-certificate {self.version()}", f"law {F(*self.law)}", *self.options,
                 *(line for line in self.tolerance if not (self.band_file and line.startswith("band"))),
                 *(["band file"] if self.band_file else [])]
        bound = f"{self.B}.." if self.B != self.N else ""
        lines.append(f"particles {bound}{self.N or ''}" if self.B else "particles none")
        if self.N:
            lines += [f"class {j + 1} {self.q[j]} {self.t[j]} {self.sizes[j][0]} {self.sizes[j][1]}"
                      for j in range(self.k) if self.q[j]]
        for kind, *values in self.nodes:
            lines.append(f"split {values[0]} {values[1]}" if kind == "split" else
                         " ".join([kind, *(f"{m} {name}" for m, name in values[0])]))
        return "\n".join(lines + ["end", ""])
