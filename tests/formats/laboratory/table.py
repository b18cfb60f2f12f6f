"""The table of a sheet: what each row and column of it shows, rounded as it is printed."""

import dataclasses
from fractions import Fraction

from . import words
from .sample import INCHES, NUMBERS


def rounded(value, decimals):
    """Half away from zero, as calculators and spreadsheets do."""
    scaled = abs(value) * 10**decimals
    whole = (2 * scaled.numerator + scaled.denominator) // (2 * scaled.denominator)
    return Fraction(whole if value >= 0 else -whole, 10**decimals)


def decimal_text(value, decimals, sign="."):
    """The exact decimal; `decimals` None: as many digits as it has."""
    if decimals is None:
        decimals = next(d for d in range(12) if (value * 10**d).denominator == 1)
    whole = abs(value) * 10**decimals
    assert whole.denominator == 1, (value, decimals)
    digits = str(whole.numerator).rjust(decimals + 1, "0")
    text = digits if decimals == 0 else digits[:-decimals] + sign + digits[-decimals:]
    return "-" + text if value < 0 else text


@dataclasses.dataclass
class Column:
    what: tuple  # (meaning, unit); None for a column that says nothing of this sample's masses
    header: str
    decimals: int


@dataclasses.dataclass
class Row:
    role: str  # sieve, pan, washed, pan and washed, total
    opening: Fraction  # of a sieve, mm
    labels: list  # cells of the size columns
    values: list  # a column each; None: an empty cell


@dataclasses.dataclass
class Table:
    size_headers: list
    columns: list
    rows: list
    stated: dict = dataclasses.field(default_factory=dict)  # dry, after, washed: masses in the heading

    def sieves(self):
        """Coarsest first."""
        return sorted((row for row in self.rows if row.role == "sieve"), key=lambda row: -row.opening)

    def foot(self):
        """What passes the finest sieve."""
        return [row for row in self.rows if row.role in ("pan", "washed", "pan and washed")]

    def total(self):
        return next((row for row in self.rows if row.role == "total"), None)

    def column(self, what):
        return next((j for j, column in enumerate(self.columns) if column.what == what), None)


@dataclasses.dataclass
class Form:
    """How a laboratory prints."""
    language: str
    sign: str
    columns: list
    sizes: str = "mm"  # mm, um, cells, mixed cells, names, names and openings, inches, numbers
    size_word: str = ""
    percent_of: str = "recovered"  # or dry mass
    sums_rounded: bool = False  # percent passing is 100 less the rounded percents above
    foot: tuple = ("pan",)
    foot_words: dict = dataclasses.field(default_factory=dict)
    total_word: str = ""
    stated: tuple = ()
    ascending: bool = False
    opening_decimals: int = None


def percents_base(form, sample):
    return sample.recovered if form.percent_of == "recovered" else sample.dry_mass


def retained_values(masses, column, base):
    if column.what[1] == "g":
        return [rounded(mass, column.decimals) for mass in masses]
    return [rounded(100 * mass / base, column.decimals) for mass in masses]


def running_sums(masses):
    sums, above = [], Fraction(0)
    for mass in masses:
        above += mass
        sums.append(above)
    return sums


def sieve_values(form, sample, column):
    """The column's values from the coarsest sieve to the finest."""
    base = percents_base(form, sample)
    meaning, unit = column.what
    if meaning == "retained":
        return retained_values(sample.retained, column, base)
    sums = running_sums(sample.retained)
    if meaning == "cumulative":
        return retained_values(sums, column, base)
    if unit == "g":
        return [rounded(base - above, column.decimals) for above in sums]
    if form.sums_rounded:
        shares = [rounded(100 * mass / base, column.decimals) for mass in sample.retained]
        return [100 - above for above in running_sums(shares)]
    return [rounded(100 - 100 * above / base, column.decimals) for above in sums]


def foot_masses(form, sample):
    masses = {"pan": sample.pan, "washed": sample.washed, "pan and washed": sample.fines}
    return [masses[role] for role in form.foot]


def foot_values(form, sample, column):
    """The column's values in the rows below the finest sieve: passing has none there but the last 0."""
    base = percents_base(form, sample)
    masses = foot_masses(form, sample)
    meaning, _ = column.what
    if meaning == "retained":
        return retained_values(masses, column, base)
    if meaning == "cumulative":
        above = sum(sample.retained)
        return retained_values([above + mass for mass in running_sums(masses)], column, base)
    return [None] * len(masses)


def total_value(rows, j, column):
    if column.what[0] != "retained":
        return None
    return sum((row.values[j] for row in rows if row.values[j] is not None), Fraction(0))


def size_labels(form, opening):
    """The cells that name a sieve."""
    text = decimal_text(opening, form.opening_decimals, form.sign)
    plain = decimal_text(opening, None)
    if form.sizes == "mm":
        return [text]
    if form.sizes == "um":
        return [decimal_text(opening * 1000, None, form.sign)]
    if form.sizes == "cells":
        return [text + " mm"]
    if form.sizes == "mixed cells":
        return [text + " mm"] if opening >= 1 else [decimal_text(opening * 1000, None, form.sign) + " µm"]
    if form.sizes == "names and openings":
        return [sieve_name(plain, form), text]
    if form.sizes == "names with openings":
        return [f"{sieve_name(plain, form)} ({text} mm)"]
    return [sieve_name(plain, form)]


def sieve_name(plain, form):
    number, inch = form.foot_words["name style"]
    if plain in NUMBERS:
        return number.format(NUMBERS[plain])
    inches = INCHES[plain]
    if inch.startswith("spaced"):
        return inches.replace("-", " ") + inch.removeprefix("spaced")
    return inches + inch


def size_headers(form):
    word = form.size_word
    if form.sizes == "mm":
        return [f"{word} (mm)"]
    if form.sizes == "um":
        return [f"{word} (µm)"]
    if form.sizes == "names and openings":
        return [form.foot_words["name header"], f"{word} (mm)"]
    return [word]


def tabulated(form, sample):
    """The table of the sample in this form."""
    headers = size_headers(form)
    blank = [""] * (len(headers) - 1)
    by_column = [sieve_values(form, sample, column) for column in form.columns]
    rows = [Row("sieve", opening, size_labels(form, opening), [values[i] for values in by_column])
            for i, opening in enumerate(sample.openings)]
    foot = [foot_values(form, sample, column) for column in form.columns]
    for i, role in enumerate(form.foot):
        rows.append(Row(role, None, [form.foot_words[role]] + blank, [values[i] for values in foot]))
    totals = [total_value(rows, j, column) for j, column in enumerate(form.columns)]
    if form.ascending:
        rows.reverse()
    if form.total_word:
        rows.append(Row("total", None, [form.total_word] + blank, totals))
    masses = {"dry": sample.dry_mass, "after": sample.dry_mass - sample.washed, "washed": sample.washed}
    return Table(headers, form.columns, rows, {name: masses[name] for name in form.stated})


def with_unit_style(header, style, language):
    """`Sieve size (mm)` in the other ways in which units are written."""
    if style == "(" or "(" not in header:
        return header
    word, unit = header[:-1].split(" (")
    if style == "[":
        return f"{word} [{unit}]"
    if style == "in" and language in ("en", "de"):
        return f"{word} in {unit}"
    if style == ",":
        return f"{word}, {unit}"
    return header


def chosen_header(what, language, dice, rare=False):
    return dice.choice((words.COLUMN_RARE if rare else words.COLUMN)[what][language])
