"""Suites of gradations that a description and a seed make."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from typing import Any, Union

from exactmdm import _core
from exactmdm.errors import InputError, in_file
from exactmdm.exact import valid_text
from exactmdm.gradation import Gradation
from exactmdm.options import read_file

_MOST_SEED = 2**64 - 1


def suite(description: Union[Mapping[str, Any], str, "os.PathLike[str]"], *, seed: int = 1, count: int | None = None,
          lines: range | None = None) -> Iterator[Gradation]:
    """The gradations of a suite as `mdm suite` makes them: line n depends on the description, the seed and n alone.

    Args:
        description: the path of a file in JSON, schema mdm-suite-1, or a dict of the same; floats in it are the
            decimals that are printed of them.
        seed: 0 to 2^64 - 1; another seed, other gradations.
        count: lines 1 to count; None: 1000.
        lines: these lines instead, from 1 on: range(1001, 2001), or range(17, 10**9, 1000) for a shard.

    Raises:
        InputError: the description is none, or asks for what cannot be.

    >>> ties = {"schema": "mdm-suite-1", "classes": 3, "sieves": {"from": 0.5, "ratio": 2}, "masses": {"kind": "random"}}
    >>> first, second = exactmdm.suite(ties, seed=7, count=2)
    >>> first.id, second == next(exactmdm.suite(ties, seed=7, lines=range(2, 3)))
    ('g-1', True)
    """
    if count is not None and lines is not None:
        raise InputError("count and lines: give one of them")
    if not 0 <= seed <= _MOST_SEED:
        raise InputError(f"seed: {seed} is not from 0 to 2^64 - 1")
    numbers = range(1, (1000 if count is None else count) + 1) if lines is None else lines
    if numbers and (min(numbers) < 1 or max(numbers) > _MOST_SEED):
        raise InputError(f"lines: {numbers} is not from 1 to 2^64 - 1")
    return _made(_suite_of(description), seed, numbers)


def _suite_of(description: Union[Mapping[str, Any], str, "os.PathLike[str]"]) -> _core.Suite:
    if isinstance(description, Mapping):
        return _core.Suite(json.dumps(dict(description)), "description")
    name = valid_text(os.fspath(description))
    with in_file(name):
        return _core.Suite(read_file(description).decode(errors="replace"), name)


def _made(made: _core.Suite, seed: int, numbers: range) -> Iterator[Gradation]:
    for n in numbers:
        yield Gradation._of(made.line(n, seed))
