#!/usr/bin/python3
"""suites_test.py MDM: the lines of mdm suite are those of a second generator, this one, written from the schema mdm-suite-1.

MDM is the program. Random numbers, choices of sieves, random and gap-graded masses, ties and beta curves with whole
parameters are the same to the last digit; lognormal curves, in doubles here, wherever these can tell.
"""

import json
import math
import subprocess
import sys
from fractions import Fraction

import mpmath

MDM = sys.argv[1]
SERIES = [Fraction(text) for text in "0.063 0.09 0.125 0.18 0.25 0.355 0.5 0.71 1 1.4 2 2.8 4 5.6 8".split()]
LOW = 0xFFFFFFFF


def philox(seed, stream, index):
    """Number `index` of a stream: the low half of Philox 4x32-10's block."""
    counter = [index & LOW, index >> 32, stream & LOW, stream >> 32]
    key = [seed & LOW, seed >> 32]
    for _ in range(10):
        p, q = 0xD2511F53 * counter[0], 0xCD9E8D57 * counter[2]
        counter = [(q >> 32) ^ counter[1] ^ key[0], q & LOW, (p >> 32) ^ counter[3] ^ key[1], p & LOW]
        key = [(key[0] + 0x9E3779B9) & LOW, (key[1] + 0xBB67AE85) & LOW]
    return counter[1] << 32 | counter[0]


class Stream:
    """The random numbers of a line."""

    def __init__(self, seed, line):
        self.seed, self.line, self.index = seed, line, 0

    def bits(self):
        self.index += 1
        return philox(self.seed, self.line, self.index - 1)

    def choice(self, n):
        """One of 0 .. n - 1 by one number."""
        return self.bits() * n >> 64 if n > 1 else 0

    def large_choice(self, n):
        """The same by numbers of 64 bits more than n has."""
        if n == 1:
            return 0
        r, numbers = 0, -(-n.bit_length() // 64) + 1
        for _ in range(numbers):
            r = r << 64 | self.bits()
        return r * n >> 64 * numbers

    def number(self, ends):
        low, high = map(Fraction, ends)
        return low + (high - low) * Fraction(self.choice(1001), 1000) if low != high else low


def sieves(random, classes):
    left, taken = classes + 1, []
    for i, opening in enumerate(SERIES):
        if left and (left == len(SERIES) - i or random.choice(len(SERIES) - i) < left):
            taken.append(opening)
            left -= 1
    return taken


def parts(random, n, whole):
    cuts = sorted(random.large_choice(whole - n + 1) for _ in range(n - 1))
    return [b - a + 1 for a, b in zip([0] + cuts, cuts + [whole - n])]


def shares(passing, whole):
    """What passes each sieve, rounded, as shares of the classes."""
    rounded = [math.floor(p * whole + Fraction(1, 2)) for p in passing]
    return [b - a for a, b in zip(rounded, rounded[1:])]


def beta_passing(x, a, b):
    """I_x(a, b) for whole a and b, the chance of at least a successes of a + b - 1."""
    n = a + b - 1
    return sum(math.comb(n, i) * x**i * (1 - x) ** (n - i) for i in range(a, n + 1))


def lognormal_passing(openings, median, deviation):
    first, spread = math.log(openings[0]), math.log(openings[-1] / openings[0])
    at = [math.erf((math.log(x) - first - float(median) * spread) / (float(deviation) * math.sqrt(2))) for x in openings]
    return [Fraction((z - at[0]) / (at[-1] - at[0])) for z in at]


def normal_passing(random, classes, kind, whole):
    centre, deviation, noise = (random.number(kind[name]) for name in ("centre", "deviation", "noise"))
    up_to = [0]
    for j in range(classes):
        place = (Fraction(2 * j + 1, 2) - centre * classes) / deviation
        with mpmath.workdps(60):
            square = place * place / 2
            height = mpmath.exp(-mpmath.mpf(square.numerator) / square.denominator)
            rounded = int(mpmath.floor(height * whole + mpmath.mpf(1) / 2))
        up_to.append(up_to[-1] + rounded + math.floor(noise * random.large_choice(whole + 1)))
    return [Fraction(some, up_to[-1]) for some in up_to]


def line(n, seed, kind, digits):
    """The sizes and masses of a line, as fractions."""
    random, whole = Stream(seed, n), 10**digits
    classes = 3 + random.choice(6)
    x = sieves(random, classes)
    if kind["kind"] == "random":
        units = parts(random, classes, whole)
    elif kind["kind"] == "gap-graded":
        first = 1 + random.choice(classes - 2)
        units = parts(random, classes - 1, whole)
        units.insert(first, 0)
    elif kind["kind"] == "beta":
        units = shares([beta_passing((d - x[0]) / (x[-1] - x[0]), kind["a"], kind["b"]) for d in x], whole)
    elif kind["kind"] == "lognormal":
        median, deviation = random.number(kind["median"]), random.number(kind["deviation"])
        units = shares(lognormal_passing(x, median, deviation), whole)
    elif kind["kind"] == "normal":
        units = shares(normal_passing(random, classes, kind, whole), whole)
    else:
        masses = []
        for lower, upper in zip(x, x[1:]):
            at = (lower, upper)[random.choice(2)]
            masses.append((1 + random.choice(20)) * at**3)
        return x, masses + [0]
    return x, [Fraction(100 * u, whole) for u in units] + [0]


def main():
    kinds = [({"kind": "random"}, 6), ({"kind": "random"}, 45), ({"kind": "gap-graded"}, 6), ({"kind": "ties"}, 6),
             ({"kind": "beta", "a": 2, "b": 3}, 6), ({"kind": "beta", "a": 1, "b": 4}, 9),
             ({"kind": "lognormal", "median": ["0.2", "0.8"], "deviation": ["0.5", "2"]}, 6),
             ({"kind": "normal", "centre": ["0.25", "0.75"], "deviation": ["0.5", "3"], "noise": ["0", "0.5"]}, 6)]
    wrong = compared = 0
    for kind, digits in kinds:
        description = {"schema": "mdm-suite-1", "sieves": {"series": "ISO R20/3", "from": "0.063", "to": 8},
                       "classes": [3, 8], "digits": digits, "masses": kind}
        for seed, first in ((1, 1), (2**64 - 1, 2**40)):
            run = subprocess.run([MDM, "suite", "-", "--seed", str(seed), "--lines", f"{first}-{first + 99}"],
                                 input=json.dumps(description), capture_output=True, text=True, check=True)
            for n, text in enumerate(run.stdout.splitlines(), first):
                g = json.loads(text)
                sizes, masses = line(n, seed, kind, digits)
                compared += 1
                if (g["id"], [*map(Fraction, g["sizes"])], [*map(Fraction, g["masses"])]) != (f"g-{n}", sizes, masses):
                    wrong += 1
                    print("differs:", kind, text, [*map(float, masses)])
    print(f"{compared} lines compared, {wrong} differ")
    return 1 if wrong or compared != 200 * len(kinds) else 0


sys.exit(main())
