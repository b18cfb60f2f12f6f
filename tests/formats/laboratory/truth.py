"""What a careful reader may read of a printed table: every gradation that its printed numbers allow.

A reading is exact: it follows one column to the last digit. Where a column says all (percents, or masses with a pan, a
total or the dry mass), its fines are part of it. Columns must agree: where two of them differ by more than rounding and
the loss of one percent that sieving may have, nothing may be read.
"""

import dataclasses
from fractions import Fraction

LOSS = Fraction(1)  # percentage points between what was weighed in and what was found again


@dataclasses.dataclass(frozen=True)
class Reading:
    """Openings in mm and the share of the mass between each and the next coarser one; 0 is the pan."""
    shares: tuple

    @staticmethod
    def of(masses):
        """From a dictionary of masses by opening; None where that is no gradation."""
        total = sum(masses.values())
        if total <= 0 or min(masses.values()) < 0 or masses[max(masses)] != 0:
            return None
        shares = {opening: Fraction(mass) / total for opening, mass in masses.items() if opening != 0 or mass != 0}
        return Reading(tuple(sorted(shares.items())))

    def passing(self):
        """Percent passing by opening."""
        below, passing = Fraction(0), {}
        for opening, share in self.shares:
            passing[opening] = below
            below += 100 * share
        return passing

    def distance(self, other):
        """The largest difference of percent passing, in percentage points."""
        mine, theirs = self.passing(), other.passing()
        return max(abs(mine.get(opening, 0) - theirs.get(opening, 0)) for opening in {*mine, *theirs})


@dataclasses.dataclass
class Said:
    """What one column says."""
    masses: dict  # by opening, without fines
    whole: Fraction  # what they and the fines add up to; None where the column does not say
    fines: Fraction  # in rows of their own; None where there are none


def stated_wash(table):
    stated = table.stated
    if "washed" in stated:
        return stated["washed"]
    if "dry" in stated and "after" in stated:
        return stated["dry"] - stated["after"]
    return None


def wash_beside_rows(table):
    """The wash loss that the heading alone has, in g."""
    in_rows = any(row.role != "pan" for row in table.foot())
    return Fraction(0) if in_rows else (stated_wash(table) or Fraction(0))


def said_by(table, j):
    """The masses that column j says, in its own unit; None where they cannot be."""
    meaning, unit = table.columns[j].what
    sieves = table.sieves()
    values = [row.values[j] for row in sieves]
    if any(value is None or value < 0 for value in values):
        return None
    openings = [row.opening for row in sieves]
    foot = [row.values[j] for row in table.foot()]
    foot = [value for value in foot if value is not None]
    total = table.total()
    full = Fraction(100) if unit == "%" else table.stated.get("dry")
    if full is None and total is not None and not foot and meaning != "passing":
        full = total.values[j]
    if meaning == "passing":
        top = Fraction(100) if unit == "%" else values[0]
        steps = [a - b for a, b in zip([top, *values], values)]
        return None if min(steps) < 0 else Said(dict(zip(openings, steps)), top, values[-1])
    if meaning == "cumulative":
        steps = [b - a for a, b in zip([Fraction(0), *values], values)]
        if min(steps) < 0:
            return None
        fines = max(foot) - values[-1] if foot else None
        return Said(dict(zip(openings, steps)), full, fines)
    return Said(dict(zip(openings, values)), full, sum(foot) if foot else None)


def rounding(table, j):
    """Percentage points by which printing may change a percent passing of column j."""
    meaning, unit = table.columns[j].what
    half = Fraction(1, 2 * 10**table.columns[j].decimals)
    if unit == "g":
        said = said_by(table, j)
        half = 100 * half / max(sum(said.masses.values()), 1) if said else half
    return half * (len(table.sieves()) + 2)


def fines_of(table, j, said):
    """The fines that column j allows, and whether it says them for certain."""
    meaning, unit = table.columns[j].what
    if meaning == "passing":
        return [said.fines], True
    wash = wash_beside_rows(table)
    if unit == "%":
        dry = table.stated.get("dry")
        wash = 100 * wash / dry if dry else Fraction(0)
    rest = None if said.whole is None else said.whole - sum(said.masses.values())
    if said.fines is not None:
        return [said.fines + wash], True
    if rest is None:
        return [wash], wash > 0
    slack = LOSS * said.whole / 100 + rounding(table, j) * said.whole / 100
    fines = [rest] if rest >= 0 else []
    if abs(rest - wash) <= slack:
        fines.append(wash)
    return fines, True


def adds_up(table, j, said, fines):
    """Whether what is found again is what was weighed in, and the total of the rows their sum."""
    found = sum(said.masses.values()) + fines
    slack = LOSS / 100 + rounding(table, j) / 100
    if said.whole is not None and abs(said.whole - found) > slack * said.whole:
        return False
    total = table.total()
    if total is None or total.values[j] is None or table.columns[j].what[0] != "retained":
        return True
    in_rows = sum(said.masses.values()) + (said.fines if said.fines is not None else fines)
    return abs(total.values[j] - in_rows) <= slack * in_rows


def readings(table):
    """All readings of the table; none where it contradicts itself."""
    if len({row.opening for row in table.sieves()}) < len(table.sieves()):
        return []
    certain, possible, allowed = [], [], LOSS
    for j, column in enumerate(table.columns):
        if column.what is None:
            continue
        said = said_by(table, j)
        if said is None:
            return []
        allowed += rounding(table, j)
        fines, is_certain = fines_of(table, j, said)
        found = [Reading.of({**said.masses, Fraction(0): amount}) for amount in fines if adds_up(table, j, said, amount)]
        found = [reading for reading in found if reading]
        if is_certain and not found:
            return []
        (certain if is_certain else possible).extend(found)
    if any(a.distance(b) > allowed for a in certain for b in certain):
        return []
    return certain + [a for a in possible if all(a.distance(b) <= allowed for b in certain)]
