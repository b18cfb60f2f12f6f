"""A sieve test: the mass on every sieve, what passes the finest one, what the washing took, what was lost."""

import dataclasses
from fractions import Fraction

# Openings in mm as the standards have them, coarsest first.
SERIES = {
    "ASTM": "75 50 37.5 25 19 12.5 9.5 4.75 2.36 2 1.18 0.85 0.6 0.425 0.3 0.25 0.15 0.106 0.075",
    "ISO": "63 31.5 16 8 4 2 1 0.5 0.25 0.125 0.063",
    "EN": "63 45 31.5 22.4 20 16 14 11.2 10 8 6.3 5.6 4 2 1 0.5 0.25 0.125 0.063",
    "BS": "75 63 50 37.5 28 20 14 10 6.3 5 3.35 2 1.18 0.6 0.425 0.3 0.212 0.15 0.063",
    "AFNOR": "50 40 31.5 25 20 16 12.5 10 8 6.3 5 4 2.5 2 1.25 1 0.63 0.5 0.315 0.2 0.16 0.1 0.08",
    "UNE": "63 50 40 25 20 12.5 10 6.3 5 2 1.25 0.4 0.16 0.08",
    "CNR": "71 40 30 25 15 10 5 2 0.4 0.18 0.075",
}

# ASTM E11: the names of the openings, inches above 4.75 mm, numbers from there on.
INCHES = {"75": "3", "50": "2", "37.5": "1-1/2", "25": "1", "19": "3/4", "12.5": "1/2", "9.5": "3/8"}
NUMBERS = {"4.75": "4", "2.36": "8", "2": "10", "1.18": "16", "0.85": "20", "0.6": "30", "0.425": "40", "0.3": "50",
           "0.25": "60", "0.15": "100", "0.106": "140", "0.075": "200"}


@dataclasses.dataclass
class Sample:
    """Openings in mm, coarsest first; masses in g, each a whole number of 10^-decimals."""
    series: str
    openings: list
    retained: list
    pan: Fraction
    washed: Fraction
    lost: Fraction
    decimals: int

    @property
    def fines(self):
        return self.pan + self.washed

    @property
    def recovered(self):
        """What the rows of a sheet account for."""
        return sum(self.retained) + self.fines

    @property
    def dry_mass(self):
        """What was weighed before washing."""
        return self.recovered + self.lost


def openings_of(series, dice):
    """Five to fourteen neighbours, a few left out, and something finer than 1 mm among them."""
    all_of_it = [Fraction(text) for text in SERIES[series].split()]
    count = dice.randint(5, min(14, len(all_of_it)))
    last = len(all_of_it) - dice.choice((0, 0, 0, 0, 1, 2))
    chosen = all_of_it[max(0, last - count):last]
    for _ in range(dice.choice((0, 0, 1, 2))):
        if len(chosen) > 5:
            del chosen[dice.randrange(1, len(chosen) - 1)]
    return chosen


def sample_of(series, dice, washed):
    """A test of some 200 to 5000 g; the coarsest sieve holds nothing, what is lost is below half a percent."""
    openings = openings_of(series, dice)
    decimals = dice.choice((0, 1, 1, 1, 2, 2))
    total = dice.randint(2000, 9000) if decimals == 0 else dice.randint(200, 3000)
    peak, width = dice.uniform(0.1, 0.9) * len(openings), dice.uniform(0.15, 0.8) * len(openings)
    weights = [dice.uniform(0.3, 1.0) / (1 + ((j - peak) / width) ** 2) for j in range(1, len(openings))]
    scale = total * 10**decimals / sum(weights)
    masses = [0] + [int(scale * weight) for weight in weights]
    if dice.random() < 0.1:
        masses[1] = 0
    unit = Fraction(1, 10**decimals)
    whole = sum(masses)
    pan = 0 if dice.random() < 0.15 else int(whole * dice.uniform(0.002, 0.15))
    gone = int(whole * dice.uniform(0.03, 0.25)) if washed else 0
    lost = int(whole * dice.uniform(0, 0.004)) if dice.random() < 0.4 else 0
    return Sample(series, openings, [m * unit for m in masses], pan * unit, gone * unit, lost * unit, decimals)
