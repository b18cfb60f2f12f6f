"""All kinds of sheets, each with how often it is made."""

from . import ordinary, poisoned, unusual

GRADES = ("ordinary", "unusual", "poisoned")
KINDS = ordinary.KINDS + unusual.KINDS + poisoned.KINDS


def chosen(dice):
    return dice.choices([make for make, _ in KINDS], [weight for _, weight in KINDS])[0]
