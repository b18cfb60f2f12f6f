"""Sheets that any laboratory may send: they are to be read."""

from . import words
from .sheet import draft_of, finished
from .table import size_labels


def one_column(what, kind):
    def make(dice):
        draft = draft_of(dice, (what,))
        if what[0] == "retained" or what[1] == "g":
            draft.form.foot = draft.form.foot if draft.sample.fines == 0 else ("pan",)
        elif dice.random() < 0.5:
            draft.form.foot = ()
        return finished(draft, kind, "ordinary")
    return make


def several_columns(dice):
    return finished(draft_of(dice), "several columns", "ordinary")


def wash_loss_rows(dice):
    whats = dice.choice(((words.RETAINED_MASS,), (words.RETAINED_MASS, words.PASSING_PERCENT), (words.RETAINED_PERCENT,),
                         (words.RETAINED_MASS, words.RETAINED_PERCENT, words.PASSING_PERCENT)))
    draft = draft_of(dice, whats, washed=True)
    if dice.random() < 0.2:
        draft.form.foot = ("pan and washed",)
    if dice.random() < 0.3:
        draft.form.stated = ("dry", "after")
    return finished(draft, "wash loss in rows", "ordinary")


def sieve_names(dice):
    draft = draft_of(dice, language="en", series="ASTM")
    draft.form.sizes = dice.choice(("names", "names and openings", "names with openings"))
    if draft.form.sizes == "names and openings":
        draft.form.size_word = dice.choice(("Sieve opening", "Opening", "Sieve size", "Aperture"))
    else:
        draft.form.size_word = dice.choice(words.NAMED_SIEVE)
    return finished(draft, "sieve names", "ordinary")


def units_in_cells(dice):
    draft = draft_of(dice)
    draft.form.sizes = dice.choice(("cells", "mixed cells"))
    return finished(draft, "units in cells", "ordinary")


def pan_of_opening(dice):
    """`< 0.063 mm`, `Minus No. 200`: the pan under the name of the finest sieve."""
    draft = draft_of(dice)
    form, finest = draft.form, draft.sample.openings[-1]
    if form.sizes == "mm":
        texts = words.PAN_OF_OPENING + (words.PAN_OF_OPENING_EN if draft.language == "en" else ())
        opening = size_labels(form, finest)[0]
        form.foot_words["pan"] = dice.choice(texts).format(o=opening, u="mm")
    form.foot = ("pan",)
    return finished(draft, "pan named by an opening", "ordinary")


KINDS = (
    (one_column(words.RETAINED_MASS, "mass retained"), 12),
    (one_column(words.RETAINED_PERCENT, "percent retained"), 5),
    (one_column(words.CUMULATIVE_MASS, "cumulative mass"), 4),
    (one_column(words.CUMULATIVE_PERCENT, "cumulative percent"), 4),
    (one_column(words.PASSING_PERCENT, "percent passing"), 10),
    (several_columns, 20),
    (wash_loss_rows, 8),
    (sieve_names, 10),
    (units_in_cells, 4),
    (pan_of_opening, 5),
)
