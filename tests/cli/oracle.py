#!/usr/bin/python3
"""Second computation of everything that `mdm batch` answers, with fractions of the standard library alone.

    oracle.py MDM MDM_CHECK [--seconds S] [--seed K]        random small problems
    oracle.py MDM MDM_CHECK --suite FILE [--floats CSV]     JSON Lines; float answers are never smaller

The least match is found by walking all scales at which something changes, not by the program's sweep. Every
answer is judged completely: status, N, quantities, window, scale, margin, sizes, volume; its proof must be
accepted. Scales are taken to the power b of the law x^(a/b): q_j^b A_j < S <= q_j^b B_j. Exits with 1 if
anything differs.
"""
import argparse, csv, heapq, json, os, random, subprocess, sys, tempfile, time
from fractions import Fraction as Q
from math import isqrt


def arctan_inverse(n, unit):
    """unit times arctan(1/n), rounded in each of some 200 terms."""
    term, total, k = unit // n, 0, 1
    while term:
        total += term // k if k % 4 == 1 else -(term // k)
        term //= n * n
        k += 2
    return total


UNIT = 10**150
PI = 16 * arctan_inverse(5, UNIT) - 4 * arctan_inverse(239, UNIT)  # Machin's formula, off by less than 10^5
PI_LO, PI_HI = Q(PI - 10**5, UNIT), Q(PI + 10**5, UNIT)


class Problem:
    """A gradation (parsed JSON) under a question (a dict of option values as text)."""

    def __init__(self, gradation, question):
        rows = sorted(zip(map(Q, gradation["sizes"]), map(Q, gradation["masses"]),
                          map(Q, gradation.get("factors", ["1"] * len(gradation["sizes"])))))
        if "pan-size" in question:
            rows[0] = (Q(question["pan-size"]), *rows[0][1:])
        if "cut-below" in question:
            rows = [row for row in rows if row[0] >= Q(question["cut-below"])]
        size_factor = Q(question.get("size-factor", 1)) * (Q("25.4") if gradation.get("unit") == "in" else 1)
        self.x = [row[0] * size_factor for row in rows]
        self.m = [row[1] for row in rows[:-1]]
        self.c = [row[2] for row in rows[:-1]]
        a, _, b = question.get("law", "power:3").partition(":")[2].partition("/")
        self.a, self.b = int(a), int(b or 1)
        common = Q(self.a, self.b)
        self.a, self.b = common.numerator, common.denominator
        self.classes = [j for j, m in enumerate(self.m) if m > 0]
        self.A = {j: self.c[j]**self.b * self.x[j]**self.a / self.m[j]**self.b for j in self.classes}
        self.B = {j: self.c[j]**self.b * self.x[j + 1]**self.a / self.m[j]**self.b for j in self.classes}
        self.R = max(1, int(question.get("min-per-class", 1)))
        self.at_least = max(1, int(question.get("at-least", 1)))
        self.weight = sum(m / c for m, c in zip(self.m, self.c))
        self.start = self.start_scale(question)

    def start_scale(self, question):
        """Bounds of s_0; equal if it is rational."""
        e = Q(question.get("void-ratio", 0))
        shape, _, lengths = question.get("specimen", "").partition(":")
        lengths = [Q(length) for length in lengths.split("x")] if lengths else []
        if shape == "cylinder":
            s = 3 * lengths[0]**2 * lengths[1] / (2 * (1 + e) * self.weight)
            return s, s
        if shape == "box":
            volume = lengths[0] * lengths[1] * lengths[2] / (1 + e)
        elif "solids-volume" in question:
            volume = Q(question["solids-volume"])
        else:
            return None
        return 6 * volume / (PI_HI * self.weight), 6 * volume / (PI_LO * self.weight)

    def root(self, n):
        """Largest integer whose power b is at most n."""
        if self.b == 1:
            return n
        if self.b == 2:
            return isqrt(n)
        q = 1 << (n.bit_length() // self.b + 1)
        while q**self.b > n:
            q = ((self.b - 1) * q + n // q**(self.b - 1)) // self.b
        return q

    def least(self, j, S, closed):
        """Least q >= R with q^b B_j >= S (closed) or > S."""
        y = S / self.B[j]
        q = self.root(y.numerator // y.denominator)
        if not (closed and q**self.b == y):
            q += 1
        return max(self.R, q)

    def most(self, j, S, closed):
        """Largest q with q^b A_j < S (closed: the scale is S) or <= S (it is just above); None: no end."""
        if self.A[j] == 0:
            return None
        y = S / self.A[j]
        q = self.root(y.numerator // y.denominator)
        return q - 1 if closed and q**self.b == y else q

    def range_at(self, S, closed):
        """Lower and upper counts at the scale S, or just above it; None where some class has none."""
        lower = {j: self.least(j, S, closed) for j in self.classes}
        upper = {j: self.most(j, S, closed) for j in self.classes}
        if any(upper[j] is not None and upper[j] < lower[j] for j in self.classes):
            return None
        return lower, upper

    def steps(self, most):
        """All (S, closed) where counts can appear, ascending from the start on; at most `most` of them."""
        first = Q(0)
        if self.start:
            first = self.start[1]
            yield first, True
        yield first, False
        heap = []
        for j in self.classes:
            if self.A[j] > 0:
                q = max(self.R, self.root((first / self.A[j]).numerator // (first / self.A[j]).denominator))
                heap.append((q**self.b * self.A[j], j, q))
        heapq.heapify(heap)
        for _ in range(most):
            if not heap:
                return
            S, j, q = heap[0]
            heapq.heapreplace(heap, ((q + 1)**self.b * self.A[j], j, q + 1))
            if S > first:
                yield S, False

    def solve(self, most=4000):
        """(least N of any match, quantities of the answer to the question), or None if it takes too long."""
        least = None
        for S, closed in self.steps(most):
            counts = self.range_at(S, closed)
            if counts is None:
                continue
            lower, upper = counts
            if least is None:
                least = sum(lower.values())
            total = None if None in upper.values() else sum(upper.values())
            if total is not None and total < self.at_least:
                continue
            q = dict(lower)
            for j in self.classes:  # the finest first
                missing = max(0, self.at_least - sum(q.values()))
                q[j] += missing if upper[j] is None else min(missing, upper[j] - q[j])
            return least, q
        return None

    def reachable(self, most=4000):
        """All N with a match, as joined intervals; the last has no end. None if it takes too long."""
        if any(self.A[j] == 0 for j in self.classes):
            # One class takes any number from its lower end on: all N from the least on.
            return [[self.solve()[0], None]] if self.solve() else None

        def closed_from(A, B):
            """Least q >= R from which on the scales of q and of q + 1 overlap."""
            q = self.R
            while (q + 1)**self.b * A > q**self.b * B:
                q += 1 + q // 100
            return q

        # Twice the bound of Theorem 8, in doubles: it need not be sharp.
        s = max(closed_from(self.A[j], self.B[j]) * float(self.A[j])**(1 / self.b) for j in self.classes)
        width = sum(float(self.A[j])**(-1 / self.b) - float(self.B[j])**(-1 / self.b) for j in self.classes)
        s = Q(2 * max(s, (3 * len(self.classes) - 1) / width))**self.b
        intervals = []
        for S, closed in self.steps(most):
            counts = self.range_at(S, closed)
            if counts:
                lo, hi = (sum(part.values()) for part in counts)
                if intervals and lo <= intervals[-1][1] + 1:
                    intervals[-1][1] = max(hi, intervals[-1][1])
                else:
                    intervals.append([lo, hi])
                if S > s and (not self.start or S > self.start[1]):
                    return intervals[:-1] + [[intervals[-1][0], None]]
        return None


def enumerated_least(p, most):
    """Least N <= most of any match, by trying all vectors; None if there is none."""
    def vectors(k, n):
        if k == 1:
            if n >= p.R:
                yield (n,)
            return
        for first in range(p.R, n - (k - 1) * p.R + 1):
            for rest in vectors(k - 1, n - first):
                yield (first, *rest)
    for n in range(1, most + 1):
        for q in vectors(len(p.classes), n):
            above = max(n**p.b * p.A[j] for n, j in zip(q, p.classes))
            up_to = min(n**p.b * p.B[j] for n, j in zip(q, p.classes))
            if above < up_to and (not p.start or p.start[1] <= up_to):
                return n
    return None


def faults(p, answer, question, limited, most=4000):
    """What is wrong with an answer: a list of sentences. A limit may cost the rule which match is shown."""
    wrong = []

    def expect(condition, text):
        if not condition:
            wrong.append(text)

    shown = answer["classes"]
    expect([Q(c["lower"]) for c in shown] == p.x[:-1], "lower bounds")
    expect([Q(c["upper"]) for c in shown] == p.x[1:], "upper bounds")
    expect([Q(c["mass"]) for c in shown] == p.m, "class masses")
    if answer["particles"] is None:
        return wrong
    q = {j: int(shown[j]["quantity"]) for j in p.classes}
    empty = [(c["quantity"], c["size"]) for c, m in zip(shown, p.m) if m == 0]
    expect(all(shown_empty == ("0", None) for shown_empty in empty), "empty classes")
    expect(sum(q.values()) == int(answer["particles"]), "particles are not the sum of the quantities")
    expect(sum(q.values()) >= p.at_least and min(q.values()) >= p.R, "a floor is not met")
    solved = p.solve(most)
    if answer["status"] == "optimal":
        expect(answer["lower_bound"] == answer["particles"], "lower bound of an optimal answer")
        if solved:
            if not (limited and p.at_least > 1):
                expect(q == solved[1], f"quantities {q} instead of {solved[1]}")
            expect(sum(q.values()) == sum(solved[1].values()), f"N = {sum(solved[1].values())} is the least")
            if p.at_least == 1 and solved[0] <= 12 and len(p.classes) <= 4:
                expect(enumerated_least(p, solved[0]) == solved[0], "enumeration disagrees with the oracle")
    elif solved:
        n = sum(solved[1].values())
        expect(int(answer["lower_bound"]) <= n <= int(answer["particles"]), f"N = {n} is outside the bounds")

    scale = answer["scale"]
    above, up_to, S = Q(scale["above"]), Q(scale["up_to"]), Q(scale["chosen"])
    expect(above == max(q[j]**p.b * p.A[j] for j in p.classes), "scale above")
    expect(up_to == min(q[j]**p.b * p.B[j] for j in p.classes), "scale up to")
    expect(above < S <= up_to, "the scale is outside its window")
    expect(scale.get("scale_power", "1") == str(p.b), "scale power")
    if p.start:
        expect(S >= p.start[1], "the scale is below the start")
        expect(Q(scale["start"][0]) <= p.start[1] and Q(scale["start"][1]) >= p.start[0], "start")
    width = up_to - above
    if question.get("scale") == "upper":
        expect(S == up_to, "not the upper scale")
    elif p.start and above < p.start[1] <= up_to and "scale" not in question:
        unit = Q(10)**(1 - int(question.get("digits", 15)))
        expect(S - p.start[1] <= unit * p.start[1], "not the start's volume")
    elif p.start and p.start[1]**2 > above * up_to:
        expect(p.start[1] <= S <= p.start[1] + (up_to - p.start[1]) / 8, "scale too far from the start")
    elif above == 0:
        expect(S == up_to / 2, "not half the upper end")
    else:
        expect(S <= width / 100 or (S - width / 100)**2 <= above * up_to, "scale above the middle")
        expect((S + width / 100)**2 >= above * up_to, "scale below the middle")

    margin = Q(scale["margin"])  # closest / size - 1 with size^a in S
    closest = min(up_to / S, S / above) if above > 0 else up_to / S
    if closest == 1:
        expect(margin == 0, "margin")
    else:
        expect((1 + margin * Q(98, 100))**p.a <= closest <= (1 + margin * Q(102, 100))**p.a, "margin")

    for j in p.classes:
        lo, hi = (Q(text) for text in shown[j]["size"])
        T = S * p.m[j]**p.b / (q[j] * p.c[j])**p.b
        expect(p.x[j] < lo and hi <= p.x[j + 1], f"class {j + 1}: size outside")
        expect(lo**p.a <= T < hi**p.a if lo < hi else lo**p.a == T, f"class {j + 1}: enclosure")
        expect((hi - lo) * 10**int(question.get("digits", 15)) <= 10 * lo, f"class {j + 1}: digits")
    if (p.a, p.b) == (3, 1):
        lo, hi = (Q(text) for text in answer["solids_volume"])
        volume = S * p.weight / 6
        expect(lo <= PI_HI * volume and PI_LO * volume <= hi and hi > lo, "solids volume")
    else:
        expect(answer["solids_volume"] is None, "solids volume of another law")
    if "all_from" in answer.get("spectrum", ()):
        intervals = p.reachable(most)
        if intervals:
            got = [[int(a), int(b)] for a, b in answer["spectrum"]["intervals"]]
            got.append([int(answer["spectrum"]["all_from"]), None])
            expect(got == intervals, f"spectrum {got} instead of {intervals}")
    return wrong


def decimal(q):
    """A fraction with a decimal denominator as text."""
    places = 0
    while (q * 10**places).denominator != 1:
        places += 1
    digits = str(int(q * 10**places)).rjust(places + 1, "0")
    return digits[:len(digits) - places] + ("." + digits[len(digits) - places:] if places else "")


def random_gradation(r, identity):
    k = r.choice([1, 2, 2, 3, 3, 4, 5, 6])
    kind = r.randrange(5)
    if kind == 0:
        sizes = sorted(r.sample(range(1, 25), k + 1))
    elif kind == 1:
        sizes = [2**i for i in range(k + 1)]
    elif kind == 2:
        first = r.randrange(5, 60)
        sizes = [first + i for i in range(k + 1)]
    elif kind == 3:
        sizes = sorted(r.sample([i * i for i in range(1, 20)], k + 1))
    else:
        sizes = sorted(r.sample([Q(i, 1000) for i in range(38, 4000, 37)], k + 1))
    if r.random() < 0.3:
        sizes[0] = 0
    kind = r.randrange(7)
    base = r.choice([2**31, 2**53, 2**63, 2**64, 2**127, 10**30])
    if kind <= 1:
        masses = [Q(r.randrange(0, 12)) for _ in range(k)]
    elif kind == 2:
        masses = [Q(sizes[j + 1])**3 * r.choice([0, 1, 1, 2, 3]) for j in range(k)]
    elif kind == 3:
        masses = [Q(base + r.randrange(-3, 4)) for _ in range(k)]
    elif kind == 4:
        masses = [Q(r.randrange(0, 10**6), 10**r.randrange(0, 30)) for _ in range(k)]
    elif kind == 5:
        masses = [Q(sizes[j])**3 * r.randrange(1, 9) for j in range(k)]
    else:
        masses = [Q(r.randrange(1, 10**4), 100) for _ in range(k)]
    if not any(masses):
        masses[r.randrange(k)] = Q(1)
    gradation = {"id": identity, "sizes": [decimal(Q(x)) for x in sizes],
                 "masses": [decimal(m) for m in masses] + ["0"]}
    if r.random() < 0.25:
        gradation["factors"] = [r.choice(["1", "2", "0.5", "2.65", "1.000001", "8"]) for _ in sizes]
    if r.random() < 0.3:
        for key in ("sizes", "masses", "factors"):
            if key in gradation:
                gradation[key].reverse()
        if "factors" in gradation:
            del gradation["factors"]
    return gradation


def random_question(r):
    question = {}
    if r.random() < 0.3:
        question["min-per-class"] = str(r.choice([0, 1, 2, 3, 10]))
    if r.random() < 0.35:
        question["at-least"] = str(r.choice([2, 5, 17, 50, 200]))
    if r.random() < 0.15:
        question["size-factor"] = r.choice(["2", "0.1", "1.5", "1e3"])
    if r.random() < 0.15:
        question["digits"] = str(r.choice([10, 12, 25, 60]))
    if r.random() < 0.25:
        question["scale"] = r.choice(["upper", "robust"])
    kind = r.random()
    if kind < 0.3:
        question["law"] = "power:" + r.choice(["1", "2", "3", "1/2", "5/2", "3/2", "1/3", "7/3", "6/4"])
    elif kind < 0.45:
        question["specimen"] = r.choice(["cylinder:1x1", "cylinder:2x3", "cylinder:10x24.4", "box:2x1x2",
                                         "box:3x3x3.5"])
        question["void-ratio"] = r.choice(["0", "0.5", "0.683"])
    elif kind < 0.5:
        question["solids-volume"] = r.choice(["1", "0.001", "30", "5e3"])
    return question


class Run:
    """Asks the programs and counts what is wrong."""

    def __init__(self, mdm, check):
        self.mdm, self.check = mdm, check
        self.answers = self.bad = 0

    def report(self, *words):
        self.bad += 1
        print(*words, flush=True)

    def ask(self, command, question, extra, text):
        """The program's run and its options."""
        options = [word for name, value in question.items() for word in ("--" + name, value)] + list(extra)
        done = subprocess.run([self.mdm, *command, *options], capture_output=True, text=True, input=text,
                              timeout=600)
        return done, options

    def judge(self, gradation, question, options, line, most):
        """The answer of a line, after it was judged."""
        self.answers += 1
        answer = json.loads(line)
        try:
            wrong = faults(Problem(gradation, question), answer, question, "--max-steps" in options, most)
        except Exception as e:  # an answer without what it should have
            wrong = [repr(e)]
        if wrong:
            self.report(options, json.dumps(gradation), line, wrong)
        return answer

    def batch(self, gradations, question, extra=(), most=4000):
        """The answers to all gradations."""
        answers = []
        with tempfile.TemporaryDirectory() as folder:
            done, options = self.ask(["batch", "--proofs", folder + "/proofs"], question, extra,
                                     "".join(json.dumps(g) + "\n" for g in gradations))
            lines = done.stdout.splitlines()
            if len(lines) != len(gradations):
                self.report(options, "exit", done.returncode, done.stderr, json.dumps(gradations))
                return answers
            for number, (g, line) in enumerate(zip(gradations, lines), 1):
                answers.append(self.judge(g, question, options, line, most))
                if answers[-1]["status"] != "optimal":
                    continue
                with open(folder + "/g.json", "w") as file:
                    json.dump(g, file)
                proof = f"{folder}/proofs/{number:06}-{g['id']}.proof"
                verdict = subprocess.run([self.check, folder + "/g.json", proof],
                                         capture_output=True, text=True)
                if verdict.returncode != 0:
                    self.report(options, json.dumps(g), "mdm-check:", verdict.stdout, verdict.stderr)
        return answers

    def solve(self, g, question, *extra):
        """One gradation through `mdm solve`, where there is a spectrum."""
        done, options = self.ask(["solve", "-", "--format", "json"], question, extra, json.dumps(g))
        if done.stdout:
            self.judge(g, question, options, done.stdout, 4000)
        else:
            self.report(options, json.dumps(g), done.returncode, done.stderr)


def random_problems(run, seconds, seed):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        r = random.Random(seed)
        question = random_question(r)
        gradations = [random_gradation(r, f"{seed}.{i}") for i in range(30)]
        run.batch(gradations, question)
        run.batch(gradations[:10], question, extra=("--max-steps", str(r.choice([0, 1, 2, 5]))))
        for g in gradations[:3]:
            without = {key: value for key, value in question.items() if key != "at-least"}
            run.solve(g, without, "--spectrum", "--max-steps", "2000")
        if time.monotonic() < end:
            seed += 1
    return seed


def suite(run, file, floats):
    with open(file) as lines:
        gradations = [json.loads(line) for line in lines]
    answers = run.batch(gradations, {}, most=0)
    ours = {g["id"]: (g, answer) for g, answer in zip(gradations, answers)}
    matches = others = 0
    for row in csv.DictReader(open(floats)) if floats else ():
        g, answer = ours[row["id"]]
        p = Problem(g, {})
        q = dict(zip(p.classes, map(int, row["quantities"].split())))
        if len(q) != len(p.classes) or max(q[j] * p.A[j] for j in q) >= min(q[j] * p.B[j] for j in q):
            others += 1
            continue
        matches += 1
        if any(q[j] < int(answer["classes"][j]["quantity"]) for j in q):
            run.report(row["id"], "a published match has fewer particles in a class", row["quantities"])
    if floats:
        print(f"{matches} published vectors are matches, {others} are none")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("mdm")
    parser.add_argument("check")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--suite")
    parser.add_argument("--floats")
    a = parser.parse_args()
    run = Run(a.mdm, a.check)
    if a.suite:
        suite(run, a.suite, a.floats)
    else:
        print("seeds", a.seed, "to", random_problems(run, a.seconds, a.seed))
    print(f"{run.answers} answers, {run.bad} faults")
    return run.bad > 0


if __name__ == "__main__":
    sys.exit(main())
