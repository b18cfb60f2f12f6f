"""Options of solving, in the words of the command line."""

from __future__ import annotations

import difflib
import json
import os
from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple, Union

from exactmdm import _core
from exactmdm.errors import InputError, cannot_read
from exactmdm.exact import text_of, valid_text

#: A value of an option.
Option = Union[str, int, Decimal, Fraction, float, "os.PathLike[str]", Iterable[Any], None]

_TABLE: dict[str, list[dict[str, str]]] = json.loads(_core.option_table())


def kinds_of(command: str) -> dict[str, str]:
    """The keywords of the options of a command, each that of `mdm COMMAND` with `_` for `-`, and what their values are:
    "text", "number", "seconds", "file", "tolerances" or "flag"."""
    return {row["keyword"]: row["kind"] for row in _TABLE[command]}


class Words(NamedTuple):
    """Options as exact texts, and the tolerances."""

    values: dict[str, str]
    tolerances: list[str]


def given_of(command: str, arguments: dict[str, Any]) -> dict[str, Any]:
    """The options of a command among the arguments of a function."""
    return {name: arguments[name] for name in kinds_of(command)}


def words_of(options: dict[str, Any], command: str = "solve") -> Words:
    """The options of a command that are given as texts.

    Raises:
        TypeError: an option is unknown.
        InputError: a value is no number or text.

    >>> words_of({"tolerance": ["passing:1%", Decimal("0.5")], "at_least": 100, "time_limit": 0.5, "band": None})
    Words(values={'at_least': '100', 'time_limit': '0.5'}, tolerances=['passing:1%', '0.5'])
    """
    values: dict[str, str] = {}
    tolerances: list[str] = []
    known = kinds_of(command)
    for name, value in options.items():
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            raise TypeError(f"there is no option {name!r}" + (f": did you mean {near[0]!r}?" if near else ""))
        if value is None:
            continue
        kind = known[name]
        if kind == "flag":
            if value:
                values[name] = "yes"
        elif kind == "tolerances":
            single = isinstance(value, str) or not hasattr(value, "__iter__")
            tolerances = [text_of(one, name) for one in ([value] if single else value)]
        elif kind == "file":
            values.update(_band(value))
        else:
            # Seconds are no part of the question: floats will do.
            is_seconds = kind == "seconds" and isinstance(value, float)
            values[name] = repr(value) if is_seconds else text_of(value, name)
    return Words(values, tolerances)


def read_file(path: Union[str, os.PathLike[str]]) -> bytes:
    """The content of a file. Raises InputError if it cannot be read."""
    try:
        return Path(path).read_bytes()
    except (OSError, ValueError) as error:
        raise cannot_read(path, error) from None


def _band(path: Union[str, os.PathLike[str]]) -> dict[str, str]:
    try:
        return {"band": read_file(path).decode(), "band_name": valid_text(os.fspath(path))}
    except UnicodeDecodeError:
        raise InputError(f"{path}: it is no UTF-8 text: write an envelope as CSV", str(path)) from None
