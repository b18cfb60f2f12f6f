#!/usr/bin/python3
"""Certificates of blends, VERDICT/NAME in a folder that make.py gives, with a solver of its own in fractions.

Each has the specification limits.csv, the stockpiles 1.csv, 2.csv, ..., and the certificate proof. The solver is for
two stockpiles, of which the second has n of M steps: a leaf needs one multiplier, or two of limits that contradict each other.
"""
import shutil
from fractions import Fraction as F
from itertools import product


class Problem:
    """Stockpiles as lists of (size, percent passing), the specification as a list of (size, least, most)."""

    def __init__(self, stockpiles, limits, passing, steps=100, aim="none", of_aim=(), shares=(), at_most=None, coarseness=None):
        """`passing` has what passes each sieve of the limits, worked out by hand where it is between sieves; `coarseness` the
        limits of the factor and what passes 9.5 mm and 2.36 mm."""
        self.stockpiles, self.limits, self.steps, self.aim = stockpiles, limits, steps, aim
        self.p = [[F(v) for v in row] for row in passing]
        self.L, self.U = [F(v[1]) for v in limits], [F(v[2]) for v in limits]
        self.of_aim, self.shares, self.at_most = [F(v) for v in of_aim], shares, at_most
        self.coarseness = coarseness
        if coarseness:
            x, y, coarse, fine = coarseness
            for c, least, most in ((F(x), -100, 100 - F(x)), (F(y), 100 - F(y), 100)):
                if 0 < c < 100:
                    self.p.append([a - c / 100 * b for a, b in zip(coarse, fine)])
                    self.L.append(F(least))
                    self.U.append(F(most))
        self.lo, self.hi = [0, 0], [steps, steps]
        for i, x, y in shares:
            self.lo[i - 1], self.hi[i - 1] = -int(-F(x) * steps // 1), int(F(y) * steps // 1)

    def passes(self, s, n):
        return (self.p[s][0] * (self.steps - n) + self.p[s][1] * n) / self.steps

    def value(self, n):
        """Of n steps of the second stockpile; nothing if the blend breaks a limit."""
        counts = [self.steps - n, n]
        if any(not lo <= c <= hi for c, lo, hi in zip(counts, self.lo, self.hi)):
            return None
        if self.at_most and sum(c > 0 for c in counts) > self.at_most:
            return None
        found = [self.passes(s, n) for s in range(len(self.p))]
        if any(not lo <= v <= hi for v, lo, hi in zip(found, self.L, self.U)):
            return None
        if self.aim == "cost":
            return sum(c * v for c, v in zip(self.of_aim, counts)) / self.steps
        gaps = [abs(v - t) for v, t in zip(found, self.of_aim)] or [F(0)]
        if self.aim == "squares":
            return sum(gap * gap for gap in gaps)
        return sum(gaps) if self.aim == "deviation" else max(gaps)

    def best(self):
        values = [(v, n) for n in range(self.steps + 1) if (v := self.value(n)) is not None]
        return min(values, default=None)

    def bound(self, leaf, chosen, lo, hi):
        """Theorem 22 (a) for multipliers {(letter, sieve): m} and n from lo to hi; nothing where they are not allowed."""
        of_targets = [m for (letter, _), m in chosen.items() if letter in "ab"]
        limit = {"max-deviation": sum, "deviation": max, "squares": lambda of_targets: 0}.get(self.aim)
        if of_targets and (not leaf or limit(of_targets) > 1):
            return None
        D, e = F(0), list(self.of_aim) if leaf and self.aim == "cost" else [F(0), F(0)]
        for (letter, s), m in chosen.items():
            sign = m if letter in "la" else -m
            D += sign * (self.of_aim[s] if letter in "ab" else self.L[s] if letter == "l" else self.U[s])
            e = [v - sign * p for v, p in zip(e, self.p[s])]
            if letter in "ab" and self.aim == "squares":
                D -= m * m / 4
        return min(D + (e[0] * (self.steps - n) + e[1] * n) / self.steps for n in (lo, hi))

    def leaf(self, leaf, lo, hi, best):
        """Multipliers that suffice for n from lo to hi, as few as can be; nothing if there are none of these kinds."""
        letters = [(letter, s) for s in range(len(self.p)) for letter in "lu"]
        if leaf and self.aim in ("deviation", "max-deviation"):
            letters += [(letter, s) for s in range(len(self.p)) for letter in "ab"]
        suffices = lambda b: b is not None and (b >= best if leaf else b > 0)
        if suffices(self.bound(leaf, {}, lo, hi)):
            return {}
        slope = lambda c: (self.p[c[1]][1] - self.p[c[1]][0]) * (1 if c[0] in "la" else -1)
        own = self.of_aim[1] - self.of_aim[0] if leaf and self.aim == "cost" else F(0)
        for c in letters:
            for m in {F(1), own / slope(c) if slope(c) else F(1)}:
                if m > 0 and suffices(self.bound(leaf, {c: m}, lo, hi)):
                    return {c: m}
        if leaf and self.aim == "squares":
            tangent = self.tangent(lo, hi)
            if suffices(self.bound(leaf, tangent, lo, hi)):
                return tangent
        if leaf and self.aim == "deviation": # the signs that all deviations have somewhere
            for n in (lo, hi):
                signs = {("a" if t >= self.passes(s, n) else "b", s): F(1) for s, t in enumerate(self.of_aim)}
                if suffices(self.bound(leaf, signs, lo, hi)):
                    return signs
        for c, d in product(letters, letters):
            if c != d and slope(c) * slope(d) < 0:
                m = -slope(c) / slope(d)
                for scale in (F(1), 1 / max(m, 1), 1 / (1 + m)):
                    chosen = {c: scale, d: m * scale}
                    if suffices(self.bound(leaf, chosen, lo, hi)):
                        return chosen
        return None

    def tangent(self, lo, hi):
        """Twice the deviations at the least sum of squares from lo to hi, where the parabola in n has its vertex."""
        gap = [self.p[s][0] - t for s, t in enumerate(self.of_aim)]
        step = [(self.p[s][1] - self.p[s][0]) / self.steps for s in range(len(self.p))]
        square = sum(v * v for v in step)
        n = min(max(-sum(v * w for v, w in zip(gap, step)) / square, F(lo)), F(hi)) if square else F(lo)
        slopes = [2 * (v + w * n) for v, w in zip(gap, step)]
        return {("b" if v > 0 else "a", s): abs(v) for s, v in enumerate(slopes) if v != 0}

    def tree(self, lo, hi, best):
        """Lines for n from lo to hi, halved where no multipliers suffice."""
        for leaf in ((False, True) if best is not None else (False,)):
            if lo > hi or (self.at_most == 1 and lo > 0 and hi < self.steps):
                return ["none"]
            chosen = self.leaf(leaf, lo, hi, best)
            if chosen is not None:
                words = [f"{m} {letter}{s + 1}" for (letter, s), m in chosen.items()]
                return [" ".join(["leaf" if leaf else "none"] + words)]
        middle = (lo + hi) // 2
        if lo == hi:
            raise AssertionError("no multipliers for one blend")
        return [f"split 2 {middle}"] + self.tree(lo, middle, best) + self.tree(middle + 1, hi, best)

    def certificate(self):
        lines = ["mdm-certificate blend 1", f"steps {self.steps}"]
        lines += [f"share {i} {x} {y}" for i, x, y in self.shares]
        lines += [f"at-most {self.at_most}"] if self.at_most else []
        lines += ["coarseness {} {}".format(*self.coarseness)] if self.coarseness else []
        lines.append(" ".join(["minimise", self.aim] + [str(v) for v in self.of_aim]))
        best = self.best()
        lines.append(f"blend {self.steps - best[1]} {best[1]}" if best else "blend none")
        if best is None or self.aim != "none":
            lo = max(self.lo[1], self.steps - self.hi[0])
            hi = min(self.hi[1], self.steps - self.lo[0])
            lines += self.tree_of_root(lo, hi, best and best[0])
        return lines + ["end"]

    def tree_of_root(self, lo, hi, best):
        """With at most one stockpile first all of the one, then all of the other, then both."""
        if self.at_most != 1:
            return self.tree(lo, hi, best)
        return (["split 2 0"] + self.tree(0, 0, best) + ["split 1 0"] + self.tree(self.steps, self.steps, best) +
                ["none"])


def csv(rows, header):
    return "\n".join([header] + [",".join(map(str, row)) for row in rows]) + "\n"


def write_pair(folder, problem, lines, ending="\n"):
    folder.mkdir(parents=True)
    (folder / "limits.csv").write_text(csv(problem.limits, "size_mm,passing_min_percent,passing_max_percent"))
    for i, rows in enumerate(problem.stockpiles, 1):
        (folder / f"{i}.csv").write_text(csv(rows, "size_mm,passing_percent"))
    (folder / "proof").write_text("\n".join(lines) + ending)


FINE = [("19", 100), ("12.5", 100), ("4.75", 96), ("0.075", 9)]
COARSE = [("19", 100), ("12.5", 90), ("4.75", 16), ("0.075", 0)]
LIMITS = [("0.075", 0, 10), ("4.75", 50, 70), ("12.5", 80, 100), ("19", 100, 100)]
PASSING = [(0, 9), (16, 96), (90, 100), (100, 100)]


# 9.5 mm is at 19/31 of the way from 4.75 to 12.5, 2.36 mm at 457/935 of that from 0.075 to 4.75.
COARSE_AT = (16 + F(19, 31) * 74, 96 + F(19, 31) * 4)
FINE_AT = (F(457, 935) * 16, 9 + F(457, 935) * 87)


def both(limits=LIMITS, passing=PASSING, **options):
    return Problem([COARSE, FINE], limits, passing, **options)


IMPOSSIBLE = [("0.075", 7, 10), ("4.75", 50, 70), ("12.5", 80, 90), ("19", 100, 100)]
BETWEEN = [("4.75", "60.3", "60.6"), ("19", 100, 100)]
ACCEPTED = {
    "no-aim": both(),
    "cost": both(limits=[("0.075", 0, 10), ("4.75", 52, 70), ("12.5", 80, 100), ("19", 100, 100)], aim="cost",
                 of_aim=("7", "541/50")),
    "cost-with-splits": both(aim="cost", of_aim=("7", "541/50")),
    "cost-of-the-other": both(aim="cost", of_aim=("9", "2")),
    "deviation": both(aim="deviation", of_aim=(3, 55, 93, 100)),
    "max-deviation": both(aim="max-deviation", of_aim=(3, 55, 93, 100)),
    "squares": both(aim="squares", of_aim=(3, 55, 93, 100)),
    "squares-at-a-limit": both(aim="squares", of_aim=(8, 90, 97, 100)),
    "squares-in-the-middle": both(limits=[("4.75", 50, 70), ("19", 100, 100)], passing=[(16, 96), (100, 100)], steps=7,
                                  aim="squares", of_aim=("58.4", 100)),
    "coarseness": both(limits=[("4.75", 50, 70), ("19", 100, 100)], passing=[(16, 96), (100, 100)], aim="cost",
                       of_aim=("9", "2"), coarseness=(25, 32, COARSE_AT, FINE_AT)),
    "coarseness-from-below": both(limits=[("19", 100, 100)], passing=[(100, 100)], aim="cost", of_aim=("9", "2"),
                                  coarseness=(15, 100, COARSE_AT, FINE_AT)),
    "coarseness-impossible": both(limits=[("4.75", 50, 70), ("19", 100, 100)], passing=[(16, 96), (100, 100)],
                                  coarseness=(0, 5, COARSE_AT, FINE_AT)),
    "impossible": both(limits=IMPOSSIBLE),
    "none-in-steps": both(limits=BETWEEN, passing=[(16, 96), (100, 100)], steps=10),
    "shares": both(aim="cost", of_aim=("9", "2"), shares=((1, "2/5", "1"), (2, "0", "29/50"))),
    "shares-impossible": both(shares=((2, "0", "2/5"),)),
    "one-stockpile": both(at_most=1),
    "one-stockpile-cost": Problem([COARSE, FINE], [("4.75", 10, 100), ("19", 100, 100)], [(16, 96), (100, 100)], aim="cost",
                                  of_aim=("9", "2"), at_most=1),
    # 8 mm is between 4.75 and 12.5: at 13/31 of the way.
    "interpolated": Problem([COARSE, FINE], [("8", 60, 70), ("19", 100, 100)],
                            [(16 + F(13, 31) * 74, 96 + F(13, 31) * 4), (100, 100)], aim="cost", of_aim=("1", "2")),
    "one-step": both(limits=[("4.75", 90, 100), ("19", 100, 100)], passing=[(16, 96), (100, 100)], steps=1, aim="cost",
                     of_aim=("1", "2")),
}


def changed(lines, old, new):
    assert any(old in line for line in lines), (old, lines)
    return [line.replace(old, new) for line in lines]


def main(blends):
    """Writes them to the folder blends."""
    def write(verdict, name, *pair, **how):
        write_pair(blends / verdict / name, *pair, **how)

    shutil.rmtree(blends, ignore_errors=True)
    for name, problem in ACCEPTED.items():
        write("accepted", name, problem, problem.certificate())
    cost, impossible, best = ACCEPTED["cost"], ACCEPTED["impossible"], ACCEPTED["cost"].best()[1]
    good, none = cost.certificate(), impossible.certificate()
    blend = next(line for line in good if line.startswith("blend"))
    leaf = next(line for line in good if line.startswith("leaf"))
    named = lambda n: f"blend {100 - n} {n}"
    rejected = {
        "dearer-blend": (cost, changed(good, blend, named(best + 1))),
        "breaks-a-limit": (cost, changed(good, blend, named(best - 1))),
        "sum-is-not-the-whole": (cost, changed(good, blend, f"blend {99 - best} {best}")),
        "three-counts": (cost, changed(good, blend, blend + " 0")),
        "other-costs": (cost, changed(good, "minimise cost 7", "minimise cost 8")),
        "too-few-costs": (cost, changed(good, "minimise cost 7 541/50", "minimise cost 7")),
        "no-multipliers": (cost, changed(good, leaf, "leaf")),
        "sieve-that-is-not-there": (cost, changed(good, leaf, "leaf 1 l5")),
        "half-a-contradiction": (impossible, [line.rpartition(" ")[0].rpartition(" ")[0] if line.startswith("none ") else line
                                              for line in none]),
        "none-of-limits-that-hold": (cost, none),
        "share-of-a-third": (cost, good[:2] + ["share 3 0 1/2"] + good[2:]),
        "share-beyond": (cost, good[:2] + ["share 2 0 1/5"] + good[2:]),
        "split-of-a-third": (cost, changed(good, leaf, f"split 3 5\n{leaf}\n{leaf}")),
        "split-that-proves-nothing": (impossible, none[:4] + ["split 1 50", "none", "none", "end"]),
        "deviations-counted-twice": (ACCEPTED["max-deviation"],
                                     ["mdm-certificate blend 1", "steps 100", "minimise max-deviation 3 55 93 100",
                                      "blend 50 50", "leaf 2 a2 2 b2 1 a3", "end"]),
        "squares-with-half-slopes": (ACCEPTED["squares"], [
            "leaf 1 b1" if line.startswith("leaf") else line for line in ACCEPTED["squares"].certificate()]),
        "squares-of-both-sides": (ACCEPTED["squares"], [
            "leaf 1 a1 1 b1" if line.startswith("leaf") else line for line in ACCEPTED["squares"].certificate()]),
        "coarseness-beyond": (cost, good[:2] + ["coarseness 90 100"] + good[2:]),
        "target-of-a-factor": (ACCEPTED["squares"], [
            "leaf 1 a5" if line.startswith("leaf") else line
            for line in ACCEPTED["squares"].certificate()[:2] + ["coarseness 0 99"] + ACCEPTED["squares"].certificate()[2:]]),
        "at-most-one": (cost, good[:2] + ["at-most 1"] + good[2:]),
    }
    for name, (problem, lines) in rejected.items():
        write("rejected", name, problem, lines)
    below = Problem([COARSE, FINE], [("0.02", 0, 5), ("19", 100, 100)], [(0, 0), (100, 100)])
    write("rejected", "below-the-finest-sieve", below, ["mdm-certificate blend 1", "steps 100", "minimise none", "blend 100 0", "end"])
    unparsable = {
        "other-version": changed(good, "blend 1", "blend 2"),
        "no-steps": [line for line in good if not line.startswith("steps")],
        "zero-steps": changed(good, "steps 100", "steps 0"),
        "too-many-steps": changed(good, "steps 100", "steps 1000000001"),
        "leading-zero": changed(good, "steps 100", "steps 0100"),
        "not-lowest": changed(good, "541/50", "1082/100"),
        "decimal": changed(good, "541/50", "10.82"),
        "negative": changed(good, "minimise cost 7", "minimise cost -7"),
        "unknown-aim": changed(good, "minimise cost", "minimise price"),
        "condition-twice": changed(good, leaf, leaf + " " + leaf.partition(" ")[2]),
        "unknown-condition": changed(good, leaf, "leaf 1 x1"),
        "target-without-targets": changed(good, leaf, "leaf 1 a1"),
        "multiplier-of-nothing": changed(good, leaf, "leaf 1"),
        "multiplier-zero": changed(good, leaf, "leaf 0 l1"),
        "sieve-zero": changed(good, leaf, "leaf 1 l0"),
        "leaf-of-none": [line.replace("none ", "leaf ") if line.startswith("none ") else line for line in none],
        "tree-without-an-end": good[:-2] + ["split 1 50", "none", "end"],
        "tree-where-none-is": ACCEPTED["no-aim"].certificate()[:-1] + ["none", "end"],
        "no-tree": [line for line in good if line != leaf],
        "shares-that-do-not-ascend": good[:2] + ["share 2 0 9/10", "share 1 0 9/10"] + good[2:],
        "share-of-everything": good[:2] + ["share 1 0 1"] + good[2:],
        "share-above-one": good[:2] + ["share 1 0 3/2"] + good[2:],
        "coarseness-of-everything": good[:2] + ["coarseness 0 100"] + good[2:],
        "coarseness-above-100": good[:2] + ["coarseness 0 101"] + good[2:],
        "coarseness-twice": good[:2] + 2 * ["coarseness 0 99"] + good[2:],
        "behind-the-end": good + ["end"],
    }
    for name, lines in unparsable.items():
        write("unparsable", name, cost, lines)
    write("unparsable", "no-line-end", cost, good, ending="")
    one_step = ACCEPTED["one-step"]
    write("unparsable", "count-beyond-64-bits", one_step, changed(one_step.certificate(), "blend 0 1", f"blend {2**64} 1"))
