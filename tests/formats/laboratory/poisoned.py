"""Sheets that contradict themselves, or that hide something which a careful reader sees."""

import copy
import dataclasses
from fractions import Fraction

from . import words
from .sheet import draft_of, finished, heading_line, table_lines
from .table import Column, Row, decimal_text, rounded
from .truth import Reading, readings, rounding

MASS = (words.RETAINED_MASS,)
MASS_AND_PASSING = (words.RETAINED_MASS, words.PASSING_PERCENT)
COMPARED = (
    MASS_AND_PASSING,
    (words.RETAINED_MASS, words.CUMULATIVE_MASS),
    (words.RETAINED_PERCENT, words.PASSING_PERCENT),
    (words.RETAINED_MASS, words.CUMULATIVE_PERCENT),
    (words.CUMULATIVE_MASS, words.PASSING_PERCENT),
    (words.RETAINED_MASS, words.RETAINED_PERCENT, words.CUMULATIVE_PERCENT, words.PASSING_PERCENT),
)


def noticeable(table):
    """Percentage points that neither rounding nor a loss in sieving explains."""
    return 2 + 2 * sum(rounding(table, j) for j, column in enumerate(table.columns) if column.what)


def heavy_rows(draft):
    """Sieves whose mass is noticeable."""
    sample, least = draft.sample, noticeable(draft.table)
    by_opening = dict(zip(sample.openings, sample.retained))
    return [row for row in draft.table.sieves() if 100 * by_opening[row.opening] > least * sample.dry_mass]


def row_left_out(dice):
    draft = draft_of(dice, dice.choice((*COMPARED, MASS)))
    if len(draft.form.columns) == 1:
        draft.form.foot, draft.form.total_word = ("pan",), dice.choice(words.TOTAL[draft.language])
    table = draft.tabulate()
    heavy = heavy_rows(draft)
    if heavy:
        table.rows = [row for row in table.rows if row is not heavy[dice.randrange(len(heavy))]]
    return finished(draft, "a row is left out", "poisoned")


def mistyped(dice):
    draft = draft_of(dice, dice.choice(COMPARED))
    table = draft.tabulate()
    j = dice.randrange(len(table.columns))
    column, rows = table.columns[j], table.sieves()[1:]
    whole = draft.sample.dry_mass if column.what[1] == "g" else Fraction(100)
    row = rows[dice.randrange(len(rows))]
    change = rounded(whole * noticeable(table) / 100 * Fraction(dice.randint(11, 40), 10), column.decimals)
    row.values[j] = abs(row.values[j] + dice.choice((-1, 1)) * change)
    return finished(draft, "a value is mistyped", "poisoned")


def shifted(value, table, decimals, dice):
    return rounded(value * (1 + noticeable(table) / 100 * dice.choice((-1, 1)) * Fraction(dice.randint(11, 40), 10)), decimals)


def total_contradicts(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.RETAINED_MASS, words.RETAINED_PERCENT))))
    draft.form.foot, draft.form.total_word = ("pan",), dice.choice(words.TOTAL[draft.language])
    table = draft.tabulate()
    total = table.total()
    total.values[0] = shifted(total.values[0], table, table.columns[0].decimals, dice)
    return finished(draft, "the total does not add up", "poisoned")


def dry_mass_contradicts(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.CUMULATIVE_MASS,))))
    draft.form.foot, draft.form.stated = ("pan",), ("dry",)
    table = draft.tabulate()
    table.stated["dry"] = shifted(table.stated["dry"], table, draft.sample.decimals, dice)
    return finished(draft, "the dry mass does not add up", "poisoned")


def unit_option_contradicts(dice):
    draft = draft_of(dice)
    unit, other = dice.choice((("mm", "um"), ("mm", "in"), ("mm", "m"), ("um", "mm")))
    draft.form.sizes, draft.options, draft.readings = unit, ("--unit", other), []
    return finished(draft, "--unit contradicts the header", "poisoned")


def wash_in_heading(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.CUMULATIVE_MASS,))), washed=True)
    draft.form.foot = ("pan",)
    draft.form.percent_of = "dry mass"
    draft.form.stated = dice.choice((("washed",), ("dry", "after"), ("dry", "after", "washed"), ("dry", "washed")))
    return finished(draft, "wash loss in the heading alone", "poisoned")


def wash_in_heading_without_pan(dice):
    draft = draft_of(dice, MASS, washed=True)
    draft.sample.pan = Fraction(0)
    draft.form.foot, draft.form.total_word = (), ""
    draft.form.stated = dice.choice((("dry", "after"), ("dry", "after", "washed"), ("dry", "washed")))
    return finished(draft, "wash loss in the heading, no pan", "poisoned")


def wash_contradicts(dice):
    draft = draft_of(dice, MASS, washed=True)
    draft.form.stated, draft.readings = ("dry", "washed"), []
    table = draft.tabulate()
    table.stated["washed"] *= 2
    return finished(draft, "wash loss twice, and not the same", "poisoned")


def with_fines(draft):
    """Fines that nobody overlooks."""
    sample = draft.sample
    sample.pan = rounded(sum(sample.retained) * Fraction(draft.dice.randint(8, 30), 100), sample.decimals)
    return draft


def pan_missing(dice):
    draft = with_fines(draft_of(dice, dice.choice((MASS_AND_PASSING, (words.RETAINED_MASS, words.CUMULATIVE_PERCENT),
                                                   (words.CUMULATIVE_MASS, words.PASSING_PERCENT)))))
    draft.form.foot, draft.form.stated, draft.form.total_word = (), (), ""
    return finished(draft, "no pan beside percents with fines", "poisoned")


def percents_without_pan(dice):
    draft = with_fines(draft_of(dice, (words.RETAINED_PERCENT,)))
    draft.form.foot, draft.form.total_word = (), ""
    return finished(draft, "percent retained without the pan", "poisoned")


def ends_below_total(dice):
    """Cumulative masses, or masses, that end below the total in the last row."""
    draft = with_fines(draft_of(dice, dice.choice(((words.CUMULATIVE_MASS,), MASS))))
    draft.form.foot, draft.form.stated = (), ()
    draft.form.total_word = dice.choice(words.TOTAL[draft.language])
    table = draft.tabulate()
    table.total().values = [draft.sample.recovered]
    return finished(draft, "masses end below the total", "poisoned")


def repeated_sieve(dice):
    draft = draft_of(dice)
    table = draft.tabulate()
    at = dice.randrange(1, len(draft.sample.openings))
    table.rows.insert(at, copy.deepcopy(table.rows[at]))
    return finished(draft, "a sieve twice", "poisoned")


def negative(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.RETAINED_PERCENT,))))
    table = draft.tabulate()
    row = dice.choice(table.sieves()[1:])
    row.values[0] = -abs(row.values[0]) - 1
    return finished(draft, "a negative mass", "poisoned")


def passing_rises(dice):
    draft = draft_of(dice, dice.choice(((words.PASSING_PERCENT,), (words.CUMULATIVE_PERCENT,), (words.CUMULATIVE_MASS,))))
    table = draft.tabulate()
    rows = table.sieves()
    a, b = dice.sample(range(1, len(rows)), 2)
    if rows[a].values[0] == rows[b].values[0]:
        rows[a].values[0] += 1
    rows[a].values[0], rows[b].values[0] = rows[b].values[0], rows[a].values[0]
    return finished(draft, "passing rises, cumulative falls", "poisoned")


def above_hundred(dice):
    draft = draft_of(dice, (words.PASSING_PERCENT,))
    table = draft.tabulate()
    table.sieves()[0].values[0] = Fraction(dice.randint(102, 120))
    draft.readings = []
    return finished(draft, "passing above 100", "poisoned")


def sizes_of_two_units(dice):
    """As on forms of BS 1377: mm, and below 1.18 mm micrometres, with no word of it or the wrong one."""
    draft = draft_of(dice, language="en", series="BS")
    draft.form.sizes, draft.form.opening_decimals = "mm", None
    table = draft.tabulate()
    for row in table.sieves():
        if row.opening < Fraction(118, 100):
            row.labels = [decimal_text(row.opening * 1000, None)]
    if dice.random() < 0.5:
        table.size_headers = [dice.choice(("BS test sieve", "BS test sieve (mm)", "Sieve size", "Test sieve"))]
    return finished(draft, "mm and um in one column", "poisoned")


def impossible_unit(dice):
    """Micrometres below a header of mm: sieves of 4.75 m."""
    draft = draft_of(dice)
    draft.form.sizes = "um"
    table = draft.tabulate()
    table.size_headers = [f"{draft.form.size_word} (mm)"]
    return finished(draft, "um below a header of mm", "poisoned")


def two_samples(dice):
    draft = draft_of(dice, dice.choice(((words.PASSING_PERCENT,), MASS)))
    draft.form.stated, draft.form.percent_of = (), "recovered"
    draft.form.sizes = "mm"
    column = draft.form.columns[0]
    draft.form.columns = [column, dataclasses.replace(column)]
    table = draft.tabulate()
    first, second = dice.choice((("S1", "S2"), ("BH1 2.0 m", "BH2 3.5 m"), ("A", "B")))
    form = dice.choice(("{h} {s}", "{s} {h}", "{s}: {h}", "{h}"))
    names = [form.format(h=column.header, s=name) for name in (first, second)]
    if dice.random() < 0.3:
        names[0] = column.header
    table.columns = [dataclasses.replace(column, header=name) for name in names]
    rows = table.sieves()
    for a, b in zip(rows[1:], rows[2:]):
        a.values[1] = (a.values[1] + b.values[1]) / 2
    table.columns[1].decimals += 1
    draft.readings = []
    return finished(draft, "two samples", "poisoned")


def sample_below(dice):
    """Another sample below the first, with a table of its own."""
    draft = draft_of(dice)
    other = copy.deepcopy(draft)
    other.sample.retained[1:] = reversed(other.sample.retained[1:])
    other.tabulate()
    draft.below += [[], [f"{words.SAMPLE_NAME[draft.language]} 2"], *table_lines(other)]
    draft.readings = []
    return finished(draft, "another sample below", "poisoned")


def coarsest_retains(dice):
    draft = draft_of(dice)
    table = draft.tabulate()
    coarsest = table.sieves()[0]
    table.rows = [row for row in table.rows if row is not coarsest]
    return finished(draft, "the coarsest sieve retains", "poisoned")


def text_for_number(dice):
    draft = draft_of(dice, dice.choice((MASS, (words.PASSING_PERCENT,), (words.CUMULATIVE_PERCENT,))))
    draft.tabulate()
    lines = table_lines(draft)
    lines[dice.randint(2, len(draft.sample.openings))][-1] = dice.choice(("n/a", "?", "lost", "n.b.", "#REF!", "12,3,4", "1.2.3"))
    draft.readings = []
    return finished(draft, "text for a number", "poisoned", lines)


def value_missing(dice):
    """A mass is missing that another column has."""
    draft = draft_of(dice, MASS_AND_PASSING)
    table = draft.tabulate()
    row = dice.choice(table.sieves()[1:])
    draft.readings = readings(dataclasses.replace(table, columns=table.columns[1:], stated={}, rows=[
        dataclasses.replace(r, values=r.values[1:]) for r in table.rows]))
    if row.values[0] == 0:
        draft.readings = None
    else:
        row.values[0] = None
    return finished(draft, "a mass is missing", "poisoned")


def wrong_header(dice):
    """The words of one kind of values above another."""
    draft = draft_of(dice, dice.choice(((words.CUMULATIVE_MASS, words.PASSING_PERCENT), (words.PASSING_PERCENT,),
                                        (words.RETAINED_PERCENT,), (words.CUMULATIVE_PERCENT,))))
    table = draft.tabulate()
    wrong = {words.CUMULATIVE_MASS: words.RETAINED_MASS, words.PASSING_PERCENT: words.RETAINED_PERCENT,
             words.RETAINED_PERCENT: words.PASSING_PERCENT, words.CUMULATIVE_PERCENT: words.PASSING_PERCENT}
    draft.readings = readings(table)
    what = wrong[table.columns[0].what]
    header = dice.choice(words.COLUMN[what][draft.language])
    table.columns = [dataclasses.replace(table.columns[0], header=header), *table.columns[1:]]
    return finished(draft, "values below a wrong header", "poisoned")


def ambiguous_header(dice):
    """`Refus` is what one sieve retains, or all coarser ones too."""
    draft = draft_of(dice, (dice.choice((words.CUMULATIVE_MASS, words.RETAINED_MASS, words.CUMULATIVE_PERCENT)),),
                     language=dice.choice(("fr", "es", "it")))
    draft.form.foot = ("pan",)
    column = draft.form.columns[0]
    column.header = {"fr": "Refus", "es": "Retenido", "it": "Trattenuto"}[draft.language] + f" ({column.what[1]})"
    return finished(draft, "an ambiguous header", "poisoned")


def names_contradict(dice):
    """`No. 4` beside 2.36 mm."""
    draft = draft_of(dice, language="en", series="ASTM")
    draft.form.sizes = dice.choice(("names and openings", "names with openings"))
    draft.form.size_word = "Opening" if draft.form.sizes == "names and openings" else "Sieve"
    table = draft.tabulate()
    rows = table.sieves()
    a, b = rows[-1], rows[-2]
    if draft.form.sizes == "names and openings":
        a.labels[0], b.labels[0] = b.labels[0], a.labels[0]
    else:
        text = decimal_text(b.opening, draft.form.opening_decimals)
        a.labels[0] = a.labels[0].split(" (")[0] + f" ({text} mm)"
        b.labels[0] = b.labels[0].split(" (")[0] + f" ({decimal_text(a.opening, draft.form.opening_decimals)} mm)"
    draft.readings = []
    return finished(draft, "names and openings contradict", "poisoned")


def composite(dice):
    """The coarse sieves on the whole sample, the fine ones on a part of what passed them."""
    draft = with_fines(draft_of(dice, dice.choice((MASS, MASS, MASS_AND_PASSING)), language="en"))
    form, sample = draft.form, draft.sample
    form.sizes, form.foot, form.total_word, form.ascending = "mm", ("pan",), "", False
    form.percent_of, sample.lost = "recovered", Fraction(0)
    sample.retained = [20 * mass for mass in sample.retained]
    sample.pan *= 20
    split = dice.randint(2, len(sample.openings) - 2)
    is_said = len(form.columns) == 1 or dice.random() < 0.5
    table = draft.tabulate()
    right = readings(dataclasses.replace(table, columns=table.columns[1:], stated={}, rows=[
        dataclasses.replace(row, values=row.values[1:]) for row in table.rows])) if len(table.columns) == 2 else []
    coarse = sum(sample.retained[:split + 1])
    passed = sample.recovered - coarse
    part = Fraction(1, dice.randint(8, 30))
    for row in table.rows[split + 1:]:
        row.values[0] = rounded(row.values[0] * part, sample.decimals)
    fine = sum(row.values[0] for row in table.rows[split + 1:])
    masses = dict(zip(sample.openings, sample.retained[:split + 1]))
    masses.update({row.opening or Fraction(0): row.values[0] * passed / fine for row in table.rows[split + 1:]})
    draft.readings = right + [Reading.of(masses)]
    lines = table_lines(draft)
    if is_said:
        dry, taken = (decimal_text(mass, sample.decimals) for mass in (sample.recovered, fine))
        how = dice.randrange(3)
        if how == 0:
            lines.insert(split + 2, [f"Subsample of {taken} g"])
            draft.above.append(["Total dry mass (g)", dry])
        elif how == 1:
            draft.above += [["Total dry mass (g)", dry], ["Mass of subsample (g)", taken]]
        else:
            lines.insert(split + 2, ["Fine fraction, riffled", taken])
            draft.above.append(["Total dry mass (g)", dry])
    form.stated = ()
    table.stated = {}
    return finished(draft, "composite sieving", "poisoned", lines)


def hash_names(dice):
    """`#4`, `#40 US`, `#200 wet`, `# 10`: rows, not comments."""
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING, (words.RETAINED_PERCENT,))), language="en", series="ASTM")
    form = draft.form
    form.sizes, form.size_word = "names", dice.choice(("Sieve", "Sieve No.", "US sieve"))
    form.foot_words["name style"] = (dice.choice(("#{}", "# {}", "#{} US", "#{}*", "#{} wet")), " in")
    return finished(draft, "names that begin with #", "poisoned")


def canonical_hash_names(dice):
    """In the canonical grammar # begins a comment, but never before a digit."""
    draft = draft_of(dice, MASS, language="en", series="ASTM")
    form = draft.form
    form.sizes, form.total_word, form.foot, form.stated = "names", "", ("pan",), ()
    form.foot_words["name style"], form.foot_words["pan"] = ("#{}", " in"), "pan"
    draft.style.medium, draft.style.encoding = "comma", "utf-8"
    table = draft.tabulate()
    table.size_headers, table.columns[0].header = ["sieve"], "retained_g"
    draft.is_bare = True
    return finished(draft, "canonical rows that begin with #", "poisoned")


def row_without_name(dice):
    """What the pan holds, beside an empty cell."""
    draft = with_fines(draft_of(dice, dice.choice((MASS, (words.RETAINED_PERCENT,), MASS_AND_PASSING))))
    draft.form.foot = ("pan",)
    draft.form.foot_words["pan"] = ""
    return finished(draft, "a mass without a name", "poisoned")


def fines_below(dice):
    """The pan, or the wash loss, below the table, as on forms of EN 933-1."""
    draft = with_fines(draft_of(dice, MASS, washed=True))
    form, sample = draft.form, draft.sample
    form.total_word, form.stated = "", ()
    if dice.random() < 0.5:
        sample.washed, form.foot, word, mass = Fraction(0), (), words.PAN, sample.pan
    else:
        form.foot, word, mass = ("pan",), words.WASH, sample.washed
    table = draft.tabulate()
    text, name = decimal_text(mass, sample.decimals, draft.style.sign), dice.choice(word[draft.language])
    draft.below += [[], dice.choice(([f"{name} (g)", text], [name, f"{text} g"], [f"{name} = {text} g"]))]
    whole = dataclasses.replace(table, rows=table.rows + [Row("washed", None, [name], [mass])])
    draft.readings = readings(whole)
    return finished(draft, "fines below the table", "poisoned")


def heading_below(dice):
    """The dry masses before and after washing below the table."""
    draft = draft_of(dice, MASS, washed=True)
    draft.form.foot, draft.form.total_word, draft.form.stated = ("pan",), "", ("dry", "after")
    table = draft.tabulate()
    draft.readings = readings(table)
    draft.below += [[], *(heading_line(draft, name, mass) for name, mass in table.stated.items())]
    table.stated = {}
    return finished(draft, "masses of washing below the table", "poisoned")


def subtotal(dice):
    draft = draft_of(dice, dice.choice((MASS, MASS_AND_PASSING)), language="en")
    draft.form.ascending = False
    table = draft.tabulate()
    at = dice.randint(2, len(draft.sample.openings) - 1)
    row = Row("total", None, [dice.choice(("Subtotal", "Total coarse", "Sum gravel"))] + [""] * (len(table.size_headers) - 1),
              [sum(row.values[0] for row in table.rows[:at])] + [None] * (len(table.columns) - 1))
    draft.readings = readings(table)
    table.rows.insert(at, row)
    return finished(draft, "a sum among the sieves", "poisoned")


def loss_row(dice):
    """What was lost in sieving is no fines."""
    draft = draft_of(dice, MASS)
    sample, form = draft.sample, draft.form
    sample.lost = rounded(sample.recovered * Fraction(dice.randint(3, 9), 1000), sample.decimals)
    form.foot, form.stated, form.total_word = ("pan",), (), dice.choice(words.TOTAL[draft.language])
    table = draft.tabulate()
    draft.readings = readings(table)
    name = {"en": "Loss", "de": "Siebverlust", "fr": "Pertes", "es": "Pérdida", "it": "Perdita"}[draft.language]
    table.rows.insert(len(table.rows) - 1, Row("loss", None, [name] + [""] * (len(table.size_headers) - 1), [sample.lost]))
    table.total().values = [sample.dry_mass]
    return finished(draft, "a row of what was lost", "poisoned")


KINDS = tuple((make, 1) for make in (
    row_left_out, mistyped, total_contradicts, dry_mass_contradicts, unit_option_contradicts, wash_in_heading,
    wash_in_heading_without_pan, wash_contradicts, pan_missing, percents_without_pan, ends_below_total, repeated_sieve,
    negative, passing_rises, above_hundred, sizes_of_two_units, impossible_unit, two_samples, sample_below,
    coarsest_retains, text_for_number, value_missing, wrong_header, ambiguous_header, names_contradict, composite,
    hash_names, canonical_hash_names, row_without_name, fines_below, heading_below, subtotal, loss_row))
