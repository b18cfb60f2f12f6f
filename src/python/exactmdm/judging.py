"""Answers of other solvers, judged."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Union

from exactmdm import _core
from exactmdm.batches import suite
from exactmdm.errors import InputError
from exactmdm.exact import Number, column, text_of
from exactmdm.figures import html_table
from exactmdm.gradation import Gradation
from exactmdm.match import Match

if TYPE_CHECKING:
    import pandas

#: A solver: from a gradation to the quantities of its classes, ascending (all classes or those with mass); or
#: (quantities, sizes); or a Match; or an object as `mdm crosscheck` reads it from JSON.
Solver = Callable[[Gradation], Any]


@dataclass(frozen=True)
class JudgedAnswer:
    """The judgement of one answer."""

    id: str
    verdict: str  #: "minimal", "larger", "not-a-match", "undecided", "no-answer", "garbage" or "crashed"
    particles: int | None  #: of the answer
    minimum: int | None  #: the smallest number of any match
    ratio: Fraction | None  #: particles over minimum, of a match
    max_error: Fraction | None  #: the largest error of a share, where sizes are stated
    reason: str  #: why it is no match, or cannot be judged


@dataclass(frozen=True)
class Crosscheck:
    """The judgement of a solver on a suite of gradations. It is true if every answer is a match."""

    rows: tuple[JudgedAnswer, ...]

    @property
    def counts(self) -> dict[str, int]:
        """The number of answers with each verdict that there is."""
        return dict(Counter(row.verdict for row in self.rows))

    def __bool__(self) -> bool:
        return all(row.verdict in ("minimal", "larger") for row in self.rows)

    def to_frame(self) -> pandas.DataFrame:
        """A pandas DataFrame with a row an answer; ratio and max_error as floats, or exact where those
        cannot have them."""
        import pandas

        return pandas.DataFrame({
            "id": [row.id for row in self.rows], "verdict": [row.verdict for row in self.rows],
            "particles": [row.particles for row in self.rows], "minimum": [row.minimum for row in self.rows],
            "ratio": column(row.ratio for row in self.rows),
            "max_error": column(row.max_error for row in self.rows), "reason": [row.reason for row in self.rows]})

    def __repr__(self) -> str:
        return f"<Crosscheck: {', '.join(f'{count} {verdict}' for verdict, count in self.counts.items())}>"

    def _repr_html_(self) -> str:
        return html_table(["id", "verdict", "particles", "minimum", "reason"],
                          [[row.id, row.verdict, str(row.particles), str(row.minimum), row.reason]
                           for row in self.rows])


def crosscheck(gradations: Union[Iterable[Gradation], str, "os.PathLike[str]"], solver: Solver, *,
               size_tolerance: Number = "1e-9", max_steps: int | None = None) -> Crosscheck:
    """Judges a solver, a Python callable, on gradations of spheres, as `mdm crosscheck` judges programs.

    An Exception that the solver raises is the verdict "crashed" of that gradation; None is "no-answer". Sizes that are
    floats count as the decimals that are printed of them; they are in the gradation's unit.

    Args:
        gradations: any iterable, or the path of a suite: JSON Lines, a gradation each.
        size_tolerance: how far sizes may be off, as a part of the size as stated.
        max_steps: of the search for the smallest match; then the verdict is "undecided".

    Raises:
        InputError: a gradation or an option is wrong, or the solver is no function.

    >>> sand = exactmdm.Gradation(["1", "2", "3"], [2, 1, 0], id="sand")
    >>> exactmdm.crosscheck([sand], lambda gradation: [3, 1]).rows[0].verdict
    'minimal'
    """
    if not callable(solver):
        raise InputError(f"solver: {type(solver).__name__} is no function: give one that is called with a Gradation; "
                         "exactmdm.program.run(\"crosscheck\", SUITE, solver=COMMAND) judges programs")
    steps = None if max_steps is None else text_of(max_steps, "max_steps")
    tolerance = text_of(size_tolerance, "size_tolerance")
    return Crosscheck(tuple(_judged(gradation, solver, tolerance, steps) for gradation in suite(gradations)))


def _judged(gradation: Gradation, solver: Solver, size_tolerance: str, max_steps: str | None) -> JudgedAnswer:
    judge = _core.Judge(gradation._handle, max_steps)
    try:
        answer = solver(gradation)
    except Exception as error:
        return _row(judge.failed("crashed", f"{type(error).__name__}: {error}"))
    if answer is None:
        return _row(judge.failed("no-answer", "the solver returned None"))
    try:
        line = _line(answer, gradation.unit)
    except (InputError, TypeError, ValueError) as error:
        return _row(judge.failed("garbage", str(error)))
    return _row(judge.judge(line, size_tolerance))


def _row(row: tuple[str, str, int | None, int | None, str | None, str | None, str]) -> JudgedAnswer:
    id, verdict, particles, minimum, ratio, max_error, reason = row
    return JudgedAnswer(id, verdict, particles, minimum, None if ratio is None else Fraction(ratio),
                        None if max_error is None else Fraction(max_error), reason)


def _line(answer: Any, unit: str) -> str:
    """The answer in JSON."""
    if isinstance(answer, Match):
        return answer.json()
    if isinstance(answer, dict):
        return json.dumps(answer)
    has_sizes = isinstance(answer, tuple) and len(answer) == 2 and _is_list(answer[0])
    quantities, sizes = answer if has_sizes else (answer, None)
    members: dict[str, Any] = {"quantities": [text_of(q, "quantities") for q in quantities]}
    if sizes is not None:
        members.update(sizes=[_size(size) for size in sizes], unit=unit)
    return json.dumps(members)


def _is_list(value: object) -> bool:
    return hasattr(value, "__iter__") and not isinstance(value, str)


def _size(size: Any) -> str | list[str] | None:
    if size is None:
        return None
    if hasattr(size, "lo"):
        return [str(size.lo), str(size.hi)]
    return repr(float(size)) if isinstance(size, float) else text_of(size, "sizes")
