"""Sheets that people understand: they may be refused, not misread."""

from fractions import Fraction

from . import words
from .sample import NUMBERS
from .sheet import draft_of, finished, table_lines
from .table import Column, chosen_header, decimal_text, rounded

MASS = (words.RETAINED_MASS,)
MASS_AND_PASSING = (words.RETAINED_MASS, words.PASSING_PERCENT)


def rare_size_header(dice):
    draft = draft_of(dice)
    draft.form.size_word = dice.choice(words.SIZE_RARE[draft.language])
    return finished(draft, "rare header of sizes", "unusual")


def rare_column_header(dice):
    draft = draft_of(dice)
    column = dice.choice(draft.form.columns)
    column.header = chosen_header(column.what, draft.language, dice, rare=True)
    return finished(draft, "rare header of masses", "unusual")


def rare_foot(dice):
    draft = draft_of(dice, washed=dice.random() < 0.5)
    draft.form.foot_words["pan"] = dice.choice(words.PAN_RARE[draft.language])
    draft.form.foot_words["washed"] = dice.choice(words.WASH_RARE[draft.language])
    return finished(draft, "rare words below the sieves", "unusual")


def pan_of_number(dice):
    draft = draft_of(dice, language="en", series="ASTM")
    finest = decimal_text(draft.sample.openings[-1], None)
    draft.form.foot_words["pan"] = dice.choice(words.PAN_OF_NUMBER).format(n=NUMBERS[finest])
    draft.form.sizes = dice.choice(("names", "names and openings", "mm"))
    return finished(draft, "pan named by a sieve", "unusual")


def units_below_headers(dice):
    draft = draft_of(dice)
    draft.tabulate()
    lines = table_lines(draft)
    words_only, units = [], []
    for header in draft.table.size_headers + [column.header for column in draft.table.columns]:
        word, _, unit = header.partition(" (")
        words_only.append(word)
        units.append(unit.removesuffix(")"))
    if dice.random() < 0.5:
        units = [f"({unit})" if unit else "" for unit in units]
    return finished(draft, "units in a row of their own", "unusual", [words_only, units, *lines[1:]])


def index_column(dice):
    draft = draft_of(dice)
    draft.tabulate()
    header, *rows = table_lines(draft)
    lines = [[dice.choice(("No.", "#", "Nr.", "")), *header]] + [[str(i + 1), *row] for i, row in enumerate(rows)]
    return finished(draft, "rows are numbered", "unusual", lines)


def no_unit_of_sizes(dice):
    draft = draft_of(dice)
    draft.form.sizes = "mm"
    draft.tabulate()
    draft.table.size_headers = [draft.form.size_word]
    return finished(draft, "sizes without a unit", "unusual")


def masses_first(dice):
    draft = draft_of(dice)
    draft.tabulate()
    return finished(draft, "sizes in the last column", "unusual", [line[::-1] for line in table_lines(draft)])


def horizontal(dice):
    draft = draft_of(dice)
    draft.tabulate()
    return finished(draft, "horizontal", "unusual", [list(line) for line in zip(*table_lines(draft))])


def ranges(dice):
    """A row is named by the sieve that its grains pass and the one on which they stay."""
    draft = draft_of(dice, dice.choice((MASS, (words.RETAINED_PERCENT,))))
    draft.form.sizes = "mm"
    draft.form.foot = ("pan",)
    table = draft.tabulate()
    between = dice.choice(("-", " - ", "–", " to "))
    coarser = None
    for row in table.sieves():
        if coarser is None:
            coarser, row.labels = row.labels[0], ["> " + row.labels[0]]
            continue
        coarser, row.labels = row.labels[0], [coarser + between + row.labels[0]]
    draft.form.foot_words["pan"] = "< " + coarser
    for row in table.foot():
        row.labels = ["< " + coarser]
    return finished(draft, "ranges of sizes", "unusual")


def passed_and_stayed(dice):
    """Two columns of sizes: passing, and retained on."""
    draft = draft_of(dice, MASS, language="en")
    draft.form.sizes, draft.form.ascending, draft.form.foot, draft.form.total_word = "mm", False, ("pan",), ""
    table = draft.tabulate()
    table.size_headers = ["Passing sieve (mm)", "Retained on sieve (mm)"]
    coarser = "-"
    for row in table.rows:
        row.labels = [coarser, row.labels[0]]
        coarser = row.labels[1]
    return finished(draft, "two columns of sizes", "unusual")


def with_cells(draft, change):
    """The table's lines with cells of values changed: change(row, j, text)."""
    lines = table_lines(draft)
    first = len(draft.table.size_headers)
    for row, line in zip(draft.table.rows, lines[1:]):
        for j in range(len(draft.table.columns)):
            line[first + j] = change(row, j, line[first + j])
    return lines


def thousands(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.CUMULATIVE_MASS,))))
    draft.sample.retained = [10 * mass for mass in draft.sample.retained]
    draft.sample.pan *= 10
    draft.sample.lost = Fraction(0)
    draft.tabulate()
    separator = dice.choice((",", " ", "'")) if draft.style.sign == "." else dice.choice((".", " "))

    def grouped(row, j, text):
        whole = len(text.split(draft.style.sign)[0])
        return text if draft.table.columns[j].what[1] != "g" or whole <= 3 else text[:whole - 3] + separator + text[whole - 3:]
    if draft.style.medium == "workbook":
        draft.style.medium = "tab"
    return finished(draft, "thousands separated", "unusual", with_cells(draft, grouped))


def results_below(dice):
    draft = draft_of(dice)
    if dice.random() < 0.7:
        draft.below.append([])
    draft.below += [["D60 (mm)", decimal_text(Fraction(dice.randint(20, 900), 100), 2, draft.style.sign)],
                    ["Cu", decimal_text(Fraction(dice.randint(20, 90), 10), 1, draft.style.sign)]]
    return finished(draft, "results below the table", "unusual")


def numbers_above(dice):
    draft = draft_of(dice)
    draft.above += [["Water content (%)", decimal_text(Fraction(dice.randint(20, 300), 10), 1, draft.style.sign)],
                    ["Particle density (Mg/m3)", decimal_text(Fraction(265, 100), 2, draft.style.sign)]]
    return finished(draft, "other numbers above the table", "unusual")


def units_in_values(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.PASSING_PERCENT,), (words.RETAINED_PERCENT,))))
    draft.tabulate()
    gap = dice.choice(("", " "))
    change = lambda row, j, text: text + gap + draft.table.columns[j].what[1] if text else text
    return finished(draft, "units in the cells of values", "unusual", with_cells(draft, change))


def gap_in_table(dice):
    draft = draft_of(dice)
    draft.tabulate()
    lines = table_lines(draft)
    lines.insert(dice.randint(3, len(draft.sample.openings)), [])
    return finished(draft, "a blank line among the sieves", "unusual", lines)


def header_again(dice):
    draft = draft_of(dice)
    draft.tabulate()
    lines = table_lines(draft)
    at = dice.randint(3, len(draft.sample.openings))
    again = [lines[0]] if dice.random() < 0.5 else [[], lines[0]]
    return finished(draft, "the header again on a new page", "unusual", lines[:at] + again + lines[at:])


def section_titles(dice):
    draft = draft_of(dice, language="en")
    draft.form.ascending = False
    draft.tabulate()
    lines = table_lines(draft)
    at = dice.randint(3, len(draft.sample.openings))
    lines.insert(at, ["Fine sieving"])
    if dice.random() < 0.5:
        lines.insert(1, ["Coarse sieving"])
    return finished(draft, "titles among the sieves", "unusual", lines)


def fractions(dice):
    draft = draft_of(dice, (words.PASSING_PERCENT,))
    draft.form.foot = ()
    draft.tabulate()
    column = draft.table.columns[0]
    column.header = dice.choice(("Fraction passing", "Passing (-)", "Passing"))
    column.decimals += 2
    change = lambda row, j, text: decimal_text(row.values[j] / 100, column.decimals, draft.style.sign)
    values = [list(row.values) for row in draft.table.rows]
    for row in draft.table.rows:
        row.values[0] /= 100
    lines = table_lines(draft)
    for row, old in zip(draft.table.rows, values):
        row.values = old
    column.decimals -= 2
    return finished(draft, "fractions", "unusual", lines)


def numbers_alone(dice):
    """4, 10, 40 under `Sieve No.`."""
    draft = draft_of(dice, language="en", series="ASTM")
    small = [i for i, opening in enumerate(draft.sample.openings) if decimal_text(opening, None) in NUMBERS]
    draft.sample.openings = [draft.sample.openings[i] for i in small]
    draft.sample.retained = [draft.sample.retained[i] for i in small]
    draft.sample.retained[0] = Fraction(0)
    draft.form.sizes = "names"
    draft.form.size_word = dice.choice(("Sieve No.", "Sieve", "US Sieve No.", "Sieve number"))
    draft.form.foot_words["name style"] = ("{}", "")
    return finished(draft, "numbers alone as names", "unusual")


def tare(dice):
    """The sieve is weighed empty and with the soil."""
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING)), language="en")
    draft.form.total_word = ""
    table = draft.tabulate()
    decimals = draft.sample.decimals
    new = [Column(None, "Mass of sieve (g)", decimals), Column(None, "Mass of sieve + soil (g)", decimals)]
    for row in table.rows:
        empty = rounded(Fraction(dice.randint(30000, 50000), 100), decimals)
        row.values = [empty, empty + row.values[0], *row.values]
    table.columns = new + table.columns
    return finished(draft, "sieves weighed empty and full", "unusual")


def specification(dice):
    draft = draft_of(dice, dice.choice(((words.PASSING_PERCENT,), MASS_AND_PASSING)), language="en")
    table = draft.tabulate()
    at = table.column(words.PASSING_PERCENT)
    names = dice.choice((("Spec. min (%)", "Spec. max (%)"), ("Lower limit", "Upper limit"), ("Min % passing", "Max % passing"),
                         ("Specification",)))
    for row in table.rows:
        value = row.values[at]
        limits = [None, None] if value is None else [max(rounded(value - 8, 0), Fraction(0)), min(rounded(value + 9, 0), Fraction(100))]
        row.values = row.values + limits[:len(names)]
    table.columns = table.columns + [Column(None, name, 0) for name in names]
    return finished(draft, "limits beside percent passing", "unusual")


def hydrometer(dice):
    """Below the sieves the diameters of a sedimentation, in the same columns."""
    draft = draft_of(dice, (words.PASSING_PERCENT,))
    draft.form.sizes, draft.form.foot = "mm", ()
    draft.form.opening_decimals = None
    openings, retained = draft.sample.openings, draft.sample.retained
    unit = Fraction(1, 10**draft.sample.decimals)
    rest = draft.sample.pan
    for text in ("0.0432", "0.0201", "0.0061", "0.0015"):
        held = rounded(rest * Fraction(dice.randint(10, 40), 100), draft.sample.decimals)
        openings.append(Fraction(text))
        retained.append(held)
        rest -= held
    draft.sample.pan = rest
    assert unit > 0
    table = draft.tabulate()
    lines = table_lines(draft)
    if not draft.form.ascending and dice.random() < 0.6:
        lines.insert(len(table.rows) - 3, dice.choice(([], ["Hydrometer"], ["Sedimentation"])))
    return finished(draft, "a hydrometer below the sieves", "unusual", lines)


def passing_mass(dice):
    draft = draft_of(dice, (words.RETAINED_MASS,))
    draft.form.columns = [Column(words.PASSING_MASS, "Mass passing (g)", draft.sample.decimals)]
    draft.form.total_word = ""
    draft.form.percent_of = "recovered"
    draft.form.stated = ()
    return finished(draft, "mass passing", "unusual")


def remarks_column(dice):
    draft = draft_of(dice)
    draft.tabulate()
    header, *rows = table_lines(draft)
    said = dice.randrange(len(rows))
    lines = [[*header, "Remarks"]] + [[*row, "shell fragments" if i == said else ""] for i, row in enumerate(rows)]
    return finished(draft, "a column of remarks", "unusual", lines)


def dashes_for_zero(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.RETAINED_PERCENT,))))
    draft.tabulate()
    sign = dice.choice(("-", "", "–"))
    is_retained = lambda j: draft.table.columns[j].what[0] == "retained"
    change = lambda row, j, text: sign if row.values[j] == 0 and is_retained(j) else text
    return finished(draft, "dashes or blanks for zero", "unusual", with_cells(draft, change))


def kilograms(dice):
    draft = draft_of(dice, dice.choice((MASS, (words.CUMULATIVE_MASS,), MASS_AND_PASSING)))
    draft.form.stated = ()
    draft.tabulate()
    column = draft.table.columns[0]
    lines = table_lines(draft)
    first = len(draft.table.size_headers)
    lines[0][first] = lines[0][first].replace("(g)", "(kg)").replace("[g]", "[kg]").replace(", g", ", kg").replace("in g", "in kg")
    for row, line in zip(draft.table.rows, lines[1:]):
        line[first] = decimal_text(row.values[0] / 1000, column.decimals + 3, draft.style.sign)
    return finished(draft, "kilograms", "unusual", lines)


def sums_of_rounded(dice):
    draft = draft_of(dice, dice.choice(((words.RETAINED_MASS, words.RETAINED_PERCENT, words.PASSING_PERCENT),
                                        (words.RETAINED_PERCENT, words.PASSING_PERCENT))))
    draft.form.sums_rounded = True
    return finished(draft, "sums of rounded percents", "unusual")


def no_pan_but_dry_mass(dice):
    draft = draft_of(dice, dice.choice((MASS, (words.CUMULATIVE_MASS,))))
    draft.form.foot, draft.form.stated, draft.form.total_word = (), ("dry",), ""
    return finished(draft, "no pan, but the dry mass above", "unusual")


def footnote_mark(dice):
    draft = draft_of(dice)
    draft.tabulate()
    at, mark = dice.randrange(len(draft.table.rows)), dice.choice(("*", " *", "1)", " (a)"))
    change = lambda row, j, text: text + mark if j == 0 and text and row is draft.table.rows[at] else text
    return finished(draft, "a footnote's mark at a value", "unusual", with_cells(draft, change))


def two_units_of_sizes(dice):
    draft = draft_of(dice)
    draft.form.sizes = "mm"
    table = draft.tabulate()
    table.size_headers = [table.size_headers[0], f"{draft.form.size_word} (µm)"]
    for row in table.rows:
        row.labels.append("" if row.opening is None else decimal_text(row.opening * 1000, None, draft.style.sign))
    return finished(draft, "sizes in two units", "unusual")


def quoted_commas(dice):
    draft = draft_of(dice, language=dice.choice(("de", "fr", "es", "it")))
    draft.style.medium, draft.style.sign, draft.form.sign = "comma", ",", ","
    return finished(draft, "decimal commas in quotes", "unusual")


def other_point(dice):
    draft = draft_of(dice, language=dice.choice(("de", "fr", "es", "it")))
    draft.style.medium, draft.style.sign, draft.form.sign = dice.choice(("semicolon", "tab")), ".", "."
    return finished(draft, "decimal points where commas are usual", "unusual")


def unit_option_agrees(dice):
    draft = draft_of(dice)
    if draft.form.sizes not in ("mm", "um"):
        draft.form.sizes = "mm"
    draft.options = ("--unit", draft.form.sizes)
    return finished(draft, "--unit says what the header says", "unusual")


KINDS = tuple((make, 1) for make in (
    rare_size_header, rare_column_header, rare_foot, pan_of_number, units_below_headers, index_column, no_unit_of_sizes,
    masses_first, horizontal, ranges, passed_and_stayed, thousands, results_below, numbers_above, units_in_values,
    gap_in_table, header_again, section_titles, fractions, numbers_alone, tare, specification, hydrometer, passing_mass,
    remarks_column, dashes_for_zero, kilograms, sums_of_rounded, no_pan_but_dry_mass, footnote_mark, two_units_of_sizes,
    quoted_commas, other_point, unit_option_agrees))
