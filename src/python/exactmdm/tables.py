"""Gradations from columns of numbers."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from exactmdm import _core
from exactmdm.errors import InputError
from exactmdm.exact import entries_of, text_of, texts_of

#: Sizes that the reader of files turns into mm, by their column in a file.
_COLUMNS = {"in": "size_in", "phi": "size_phi", "sieve": "sieve"}

FLOATS = (None, "shortest", "binary")
_NOTE = "floats were taken as the shortest decimals that mean them"


def exact_texts(values: Iterable[object], name: str, floats: str | None) -> list[str]:
    """All of some numbers as exact texts, floats as `floats` says: refused (None), "shortest" or "binary".

    >>> exact_texts([0.1, 3], "masses", "shortest")
    ['0.1', '3']
    """
    if floats not in FLOATS:
        raise InputError(f"floats: {floats!r} is unknown: give \"shortest\", for the shortest decimal that means each, or "
                         "\"binary\", for the binary number itself")
    if floats != "shortest":
        return texts_of(values, name, floats == "binary")
    return [text_of(_shortest(value, f"{name}[{i}]"), f"{name}[{i}]")
            for i, value in enumerate(entries_of(values, name))]


def notes_of(values: Iterable[Iterable[object]], floats: str | None) -> list[str]:
    """What is to be said of floats among the values."""
    some = floats == "shortest" and any(_is_float(value) for column in values for value in column)
    return [_NOTE] if some else []


def core_of(sizes: list[str], masses: list[str], unit: str, id: str, factors: list[str], tolerances: list[str],
            notes: list[str]) -> _core.Gradation:
    """The gradation of exact texts; sizes in mm, um, m, in, phi, or names of sieves."""
    if unit not in _COLUMNS:
        return _core.Gradation(sizes, masses, unit, id, factors, tolerances, [], notes, 1)
    columns = {_COLUMNS[unit]: sizes, "mass": _whole(masses)}
    columns.update({name: values for name, values in (("factor", factors), ("tolerance_percent", tolerances)) if values})
    if len({len(values) for values in columns.values()}) != 1:
        raise InputError("sizes, masses and what else is given must be as long as each other")
    file = io.StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(columns)
    rows.writerows(zip(*columns.values()))
    core, *_ = _core.read(file.getvalue().encode(), "sizes", {})
    parts = list(core.parts())
    parts[3], parts[7] = id, [*parts[7], *notes]
    return _core.Gradation(*parts)


def order_of(sizes: list[str], unit: str) -> list[int]:
    """The places of the sizes, ascending; those of names of sieves as they stand, which the reader compares."""
    places = range(len(sizes))
    if unit == "sieve":
        return list(places)
    return sorted(places, key=lambda i: Fraction(sizes[i]), reverse=unit == "phi")


def masses_of_passing(sizes: list[str], passing: list[str], unit: str) -> tuple[list[str], list[str]]:
    """The sizes, ascending by what passes them, with the mass retained on each."""
    order = sorted(order_of(sizes, unit), key=lambda i: Fraction(passing[i])) if unit == "sieve" else order_of(sizes, unit)
    percents = [Fraction(passing[i]) for i in order]
    for i in range(len(percents) - 1):
        if percents[i] > percents[i + 1]:
            raise InputError(f"passing: {percents[i]} percent pass {sizes[order[i]]}, and {percents[i + 1]} percent the larger "
                             f"{sizes[order[i + 1]]}: what passes must not fall")
    if not percents or percents[-1] != 100:
        raise InputError("passing: all must pass the largest size, 100 percent")
    masses = [later - one for one, later in zip(percents, percents[1:])] + [Fraction(0)]
    kept = [sizes[i] for i in order]
    if percents[0] != 0:  # what passes the finest sieve is in the pan
        if unit in ("phi", "sieve"):
            raise InputError(f"passing: {percents[0]} percent pass the finest size, {kept[0]}, below which there is no size: "
                             "give sizes in mm with the pan as 0")
        kept, masses = ["0", *kept], [percents[0], *masses]
    return kept, [text_of(mass, "passing") for mass in masses]


def _whole(masses: list[str]) -> list[str]:
    """The masses times what makes decimals of them."""
    fractions = [Fraction(mass) for mass in masses]
    if all("/" not in mass for mass in masses):
        return masses
    factor = math.lcm(*(mass.denominator for mass in fractions))
    return [str(mass * factor) for mass in fractions]


def _is_float(value: object) -> bool:
    return isinstance(value, float) or getattr(getattr(value, "dtype", None), "kind", "") == "f"


def _shortest(value: Any, name: str) -> object:
    """The shortest decimal that means a float, in its own precision; what is none as it is."""
    if not _is_float(value):
        return value
    if not math.isfinite(value):
        raise InputError(f"{name}: {value} is no number: give a finite one")
    return repr(float(value)) if isinstance(value, float) else str(value)
