"""Many gradations."""

from __future__ import annotations

import operator
import os
import time
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any, Literal, Union, overload

from exactmdm import _core
from exactmdm.errors import InputError, cannot_read, located
from exactmdm.exact import valid_text
from exactmdm.gradation import Gradation, read_line
from exactmdm.match import LaterGradation, Match
from exactmdm.options import Words, words_of

_MOST_AT_ONCE = 4096
#: Longer waits than this make the next chunk shorter.
_SECONDS = 0.2

#: A gradation, or a line of JSON with its number.
_Item = Union[Gradation, tuple[bytes, int]]


_Gradations = Union[Iterable[Gradation], str, "os.PathLike[str]"]


@overload
def batch(gradations: _Gradations, *, threads: int = 1, proofs: bool = False, errors: Literal["raise"] = "raise",
          **options: Any) -> Iterator[Match]: ...
@overload
def batch(gradations: _Gradations, *, threads: int = 1, proofs: bool = False, errors: Literal["yield"],
          **options: Any) -> Iterator[Union[Match, InputError]]: ...
def batch(gradations: _Gradations, *, threads: int = 1, proofs: bool = False, errors: str = "raise",
          **options: Any) -> Union[Iterator[Match], Iterator[Union[Match, InputError]]]:
    """The matches of many gradations, in order, as they are found; memory does not grow with their number.

    A match that a limit ended comes like the others: see its status.

    Args:
        gradations: any iterable, or the path of a suite: JSON Lines, a gradation each.
        threads: that solve at the same time.
        proofs: keep what `certificate` and `check` need; else they solve again.
        errors: "raise" an InputError, or "yield" it in its place and go on.
        options: those of `solve` but `progress`; time_limit is of each gradation.

    Raises:
        InputError: an option or a gradation is wrong.

    >>> sands = [exactmdm.Gradation(["1", "2", "3"], [mass, 1, 0]) for mass in (1, 2, 3)]
    >>> [match.particles for match in exactmdm.batch(sands, threads=2)]
    [3, 4, 5]
    """
    if errors not in ("raise", "yield"):
        raise InputError(f"errors: {errors!r} is neither raise nor yield")
    if not 1 <= operator.index(threads) <= 1024:
        raise InputError(f"threads: {threads} is not from 1 to 1024")
    words = words_of(options)
    found = _answers(gradations, words, threads, proofs)
    return found if errors == "yield" else _raised(found)


def _answers(gradations: _Gradations, words: Words, threads: int, proofs: bool) -> Iterator[Union[Match, InputError]]:
    items: Iterator[_Item]
    if isinstance(gradations, (str, os.PathLike)):
        items, file = _lines(gradations), valid_text(os.fspath(gradations))
    else:
        items, file = _checked(gradations), ""
    run = _core.BatchRun(file, words.values, words.tolerances, proofs, threads)
    at_once = threads
    solving: list[_Item] = []
    failure: Exception | None = None
    while True:
        chunk: list[_Item] = []
        if failure is None:
            chunk, failure = _taken(items, at_once)
        began = time.monotonic()
        results = run.next([item if isinstance(item, tuple) else item._handle for item in chunk])
        # While this thread hands answers out the others solve on.
        at_once = min(2 * at_once, _MOST_AT_ONCE) if time.monotonic() - began < _SECONDS else max(at_once // 2, threads)
        for item, (json, outcome, core, finer, error) in zip(solving, results):
            if error:
                yield located(error, file) if file else InputError(error)
            else:
                yield Match._of_batch(json, outcome, core, finer, _read_later(item, file), words)
        solving = chunk
        if not chunk:
            break
    if failure is not None:
        raise failure


def _taken(items: Iterator[_Item], most: int) -> tuple[list[_Item], Exception | None]:
    """The next gradations, and what the iterator raised behind them."""
    chunk: list[_Item] = []
    try:
        for item in islice(items, most):
            chunk.append(item)
    except Exception as error:
        return chunk, error
    return chunk, None


def _read_later(item: _Item, file: str) -> Union[Gradation, LaterGradation]:
    return (item[0], file, item[1]) if isinstance(item, tuple) else item


def _raised(answers: Iterator[Union[Match, InputError]]) -> Iterator[Match]:
    for answer in answers:
        if isinstance(answer, InputError):
            raise answer
        yield answer


def suite(gradations: Union[Iterable[Gradation], str, "os.PathLike[str]"]) -> Iterator[Gradation]:
    """The gradations, or those in the lines of a file, which are read one by one."""
    if not isinstance(gradations, (str, os.PathLike)):
        yield from _checked(gradations)
        return
    file = valid_text(os.fspath(gradations))
    for line, number in _lines(gradations):
        yield read_line(line, file, number)


def _checked(gradations: Iterable[Gradation]) -> Iterator[Gradation]:
    for gradation in gradations:
        if not isinstance(gradation, Gradation):
            raise TypeError(f"{type(gradation).__name__} is no Gradation: see exactmdm.read")
        yield gradation


def _lines(path: Union[str, "os.PathLike[str]"]) -> Iterator[tuple[bytes, int]]:
    """The lines of a suite, blank ones left out."""
    try:
        file = open(path, "rb")
    except (OSError, ValueError) as error:
        raise cannot_read(path, error) from None
    with file:
        for number, line in enumerate(file, 1):
            if stripped := line.strip():
                yield stripped, number
