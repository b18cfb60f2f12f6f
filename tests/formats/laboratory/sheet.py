"""A sheet: the table with titles, headings and remarks around it, and what may be read of it."""

import dataclasses

from . import printing, truth, words
from .table import Column, Form, chosen_header, decimal_text, tabulated, with_unit_style
from .sample import sample_of

SEVERAL = (
    (words.RETAINED_MASS, words.PASSING_PERCENT),
    (words.RETAINED_MASS, words.RETAINED_PERCENT, words.CUMULATIVE_PERCENT, words.PASSING_PERCENT),
    (words.RETAINED_MASS, words.RETAINED_PERCENT, words.PASSING_PERCENT),
    (words.RETAINED_MASS, words.RETAINED_PERCENT),
    (words.RETAINED_MASS, words.CUMULATIVE_MASS),
    (words.CUMULATIVE_MASS, words.PASSING_PERCENT),
    (words.CUMULATIVE_MASS, words.CUMULATIVE_PERCENT, words.PASSING_PERCENT),
    (words.RETAINED_MASS, words.CUMULATIVE_MASS, words.CUMULATIVE_PERCENT, words.PASSING_PERCENT),
    (words.CUMULATIVE_PERCENT, words.PASSING_PERCENT),
    (words.RETAINED_PERCENT, words.PASSING_PERCENT),
)


@dataclasses.dataclass
class Draft:
    """A sheet before it is printed; a kind changes what makes it that kind."""
    dice: object
    language: str
    form: Form
    sample: object
    style: printing.Style
    unit_style: str = "("
    table: object = None
    above: list = dataclasses.field(default_factory=list)  # lines before the table
    below: list = dataclasses.field(default_factory=list)  # and after it
    readings: list = None  # where they are not those of the table
    options: tuple = ()  # of the command line
    is_bare: bool = False  # without titles and remarks

    def tabulate(self):
        self.table = tabulated(self.form, self.sample)
        return self.table


@dataclasses.dataclass
class Sheet:
    kind: str
    grade: str  # ordinary, unusual, poisoned
    language: str
    medium: str
    content: bytes
    readings: list
    options: tuple

    @property
    def ending(self):
        return {"workbook": "xlsx", "tab": "txt"}.get(self.medium, "csv")


def column_of(what, language, sample, dice, rare=False):
    decimals = sample.decimals if what[1] == "g" else dice.choice((1, 1, 1, 2, 2, 0))
    return Column(what, chosen_header(what, language, dice, rare), decimals)


def columns_of(whats, language, sample, dice):
    """With as many decimals in all columns of percents."""
    columns = [column_of(what, language, sample, dice) for what in whats]
    percents = [column for column in columns if column.what[1] == "%"]
    for column in percents:
        column.decimals = percents[0].decimals
    return columns


def foot_words(language, dice):
    number = dice.choice(("No. {}", "#{}", "No.{}", "No {}", "No. {}"))
    inch = dice.choice((" in", '"', " in.", "spaced in", 'spaced"'))
    return {
        "pan": dice.choice(words.PAN[language]),
        "washed": dice.choice(words.WASH[language]),
        "pan and washed": dice.choice(words.PAN_AND_WASH[language]),
        "name style": (number, inch),
        "name header": dice.choice(words.NAMED_SIEVE),
    }


def draft_of(dice, whats=None, language=None, series=None, washed=False):
    """An ordinary sheet of these columns."""
    language = language or dice.choices(words.LANGUAGES, (8, 4, 3, 2, 2))[0]
    sample = sample_of(series or dice.choice(words.SERIES_OF[language]), dice, washed)
    whats = whats or dice.choice(SEVERAL)
    style = printing.style_of(language, dice)
    form = Form(language, style.sign, columns_of(whats, language, sample, dice), sizes=dice.choices(("mm", "um"), (9, 1))[0],
                size_word=dice.choice(words.SIZE[language]), percent_of=dice.choice(("recovered", "dry mass")),
                foot_words=foot_words(language, dice), ascending=dice.random() < 0.25,
                opening_decimals=dice.choice((None, None, 3)))
    if sample.pan == 0 and dice.random() < 0.7:
        form.foot = ()
    if washed:
        form.foot = dice.choice((("washed", "pan"), ("pan", "washed")))
    if any(what[0] == "retained" for what in whats) and dice.random() < 0.4:
        form.total_word = dice.choice(words.TOTAL[language])
    if form.percent_of == "dry mass" and sample.lost > 0 or dice.random() < 0.1:
        form.stated = ("dry",)
    return Draft(dice, language, form, sample, style, dice.choice(("(", "(", "(", "[", ",", "in")))


def heading_words(name, language):
    return {"dry": words.DRY_MASS, "after": words.MASS_AFTER_WASHING, "washed": words.WASH}[name][language]


def heading_line(draft, name, mass):
    """A mass in the heading, in one of the ways in which forms have it."""
    dice = draft.dice
    word = dice.choice(heading_words(name, draft.language))
    text = decimal_text(mass, draft.sample.decimals, draft.style.sign)
    return dice.choice(([f"{word} (g)", text], [f"{word} [g]", text], [word, text, "g"], [word, f"{text} g"],
                        [f"{word}: {text} g"]))


def heading(draft):
    """Titles and what is known of the sample."""
    dice, language = draft.dice, draft.language
    lines = []
    if dice.random() < 0.7:
        lines.append([dice.choice(words.TITLE[language])])
    for key, value in ((words.PROJECT, "Terminal 3"), (words.SAMPLE_NAME, f"S{dice.randint(1, 40)}"),
                       (words.DEPTH, decimal_text(dice.randint(5, 200) * 1, 1, draft.style.sign)),
                       (words.DATE, dice.choice(("2024-03-11", "11.03.2024", "11/03/2024"))), (words.OPERATOR, "M. Weber")):
        if dice.random() < 0.3:
            lines.append([key[language], value])
    stated = [heading_line(draft, name, mass) for name, mass in draft.table.stated.items()]
    for line in stated:
        lines.insert(dice.randint(0, len(lines)), line)
    if lines and dice.random() < 0.5:
        lines.append([])
    return lines


def table_lines(draft):
    """The header and the rows."""
    table, sign = draft.table, draft.style.sign
    headers = table.size_headers + [column.header for column in table.columns]
    lines = [[with_unit_style(header, draft.unit_style, draft.language) for header in headers]]
    for row in table.rows:
        values = ["" if value is None else decimal_text(value, column.decimals, sign)
                  for value, column in zip(row.values, table.columns)]
        lines.append(row.labels + values)
    return lines


def remarks(draft):
    if draft.dice.random() > 0.3:
        return []
    return [[], [draft.dice.choice(words.REMARK[draft.language])]]


def finished(draft, kind, grade, table=None):
    """Prints the draft; `table` are its lines where a kind writes them in its own way."""
    if draft.table is None:
        draft.tabulate()
    found = truth.readings(draft.table) if draft.readings is None else draft.readings
    table = table or table_lines(draft)
    lines = table if draft.is_bare else draft.above + heading(draft) + table + draft.below + remarks(draft)
    return Sheet(kind, grade, draft.language, draft.style.medium, printing.printed(lines, draft.style), found,
                 draft.options)
