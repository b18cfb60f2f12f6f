"""Answers of other solvers, judged."""

from __future__ import annotations

import json
import multiprocessing
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
from exactmdm.options import given_of, words_of
from exactmdm.solving import Tolerance

if TYPE_CHECKING:
    import pandas

#: A solver: from a gradation to the quantities of its classes, ascending (all classes or those with mass); or
#: (quantities, sizes); or a Match; or an object as `mdm crosscheck` reads it from JSON.
Solver = Callable[[Gradation], Any]


MOST_SECONDS = 10**6  #: that may be waited for an answer


@dataclass(frozen=True)
class JudgedAnswer:
    """The judgement of one answer."""

    id: str
    verdict: str  #: "minimal", "larger", "not-a-match", "undecided", "no-answer", "garbage", "crashed", ...
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
               time_limit: float | None = None,
               # Options of crosscheck, by src/ask/write_modules.
               size_tolerance: Number | None = None, tolerance: Tolerance = None,
               band: Union[str, "os.PathLike[str]", None] = None, min_per_class: Number | None = None,
               at_least: Number | None = None, specimen: str | None = None, void_ratio: Number | None = None,
               solids_volume: Number | None = None, law: str | None = None, size_factor: Number | None = None,
               cut_below: Number | None = None, pan_size: Number | None = None, max_steps: Number | None = None,
               node_limit: Number | None = None,
               # End of the options.
               ) -> Crosscheck:
    """Judges a solver, a Python callable, on gradations, as `mdm crosscheck` judges programs: on exact matches of spheres,
    or on any question of `solve`. That the question was asked is yours to tell the solver.

    An Exception that the solver raises is the verdict "crashed" of that gradation; None is "no-answer"; with a time limit
    each call is a process of its own, forked from this one, and one that is killed is "timeout". Sizes that are floats
    count as the decimals that are printed of them; they are in the gradation's unit.

    Args:
        gradations: any iterable, or the path of a suite: JSON Lines, a gradation each.
        time_limit: seconds after which a call of the solver is killed (not on Windows).
        size_tolerance: how far sizes may be off, as a part of the size as stated (1e-9).
        max_steps, node_limit: of the search for the smallest match; then the verdict is "undecided".
        tolerance: the smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points),
            retained:file, passing:file (column tolerance_percent), laboratory, rounding; may be repeated.
        band: the smallest match within the envelope in FILE: CSV with passing_min_percent and passing_max_percent of
            each sieve, or a table with columns such as Lower and Upper.
        min_per_class: at least R particles in every class with mass.
        at_least: the smallest match with at least N particles.
        specimen: at least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, or in
            the answer's unit (the file's; mm for inches, phi and sieve names).
        void_ratio: void ratio e of the specimen.
        solids_volume: at least this volume of solids, in the cube of the answer's unit.
        law: mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or
            table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows.
        size_factor: multiply every size of the gradation by K.
        cut_below: leave out the classes below the sieve SIZE, as 63um or in the file's unit (before size_factor).
        pan_size: count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before size_factor).

    Raises:
        InputError: a gradation or an option is wrong, or the solver is no function.

    >>> sand = exactmdm.Gradation(["1", "2", "3"], [2, 1, 0], id="sand")
    >>> exactmdm.crosscheck([sand], lambda gradation: [3, 1]).rows[0].verdict
    'minimal'
    >>> exactmdm.crosscheck([sand], lambda gradation: [1, 1], tolerance="retained:20%").rows[0].verdict
    'minimal'
    """
    words = words_of(given_of("crosscheck", locals()), "crosscheck")
    if not callable(solver):
        raise InputError(f"solver: {type(solver).__name__} is no function: give one that is called with a Gradation; "
                         "exactmdm.program.run(\"crosscheck\", SUITE, \"--solver\", COMMAND) judges programs")
    if time_limit is not None and not 0 < time_limit < MOST_SECONDS:
        raise InputError(f"time_limit: {time_limit} is not above 0, or too long: give seconds")
    question = _core.JudgedQuestion(words.values, words.tolerances)
    return Crosscheck(tuple(_judged(question.judge_of(gradation._handle), gradation, solver, time_limit)
                            for gradation in suite(gradations)))


def _judged(judge: _core.Judge, gradation: Gradation, solver: Solver, time_limit: float | None) -> JudgedAnswer:
    verdict, text = _answered(gradation, solver) if time_limit is None else _answered_within(gradation, solver, time_limit)
    return _row(judge.failed(verdict, text) if verdict else judge.judge(text))


def _answered(gradation: Gradation, solver: Solver) -> tuple[str, str]:
    """The verdict of a failure and its reason, or "" and the answer in JSON."""
    try:
        answer = solver(gradation)
    except Exception as error:
        return "crashed", f"{type(error).__name__}: {error}"
    if answer is None:
        return "no-answer", "the solver returned None"
    try:
        return "", _line(answer, gradation.unit)
    except (InputError, TypeError, ValueError) as error:
        return "garbage", str(error)


def _answered_within(gradation: Gradation, solver: Solver, seconds: float) -> tuple[str, str]:
    """The same by a process of its own, which is killed after so many seconds."""
    try:
        forking = multiprocessing.get_context("fork")
    except ValueError:
        raise InputError("time_limit: this system has no fork, by which a call can be killed: leave it out") from None
    receiver, sender = forking.Pipe(duplex=False)
    process = forking.Process(target=lambda: sender.send(_answered(gradation, solver)))
    process.start()
    sender.close()
    try:
        if not receiver.poll(seconds):
            return "timeout", f"killed after {seconds} s"
        verdict, text = receiver.recv()
        return verdict, text
    except (EOFError, OSError):
        return "crashed", "its process ended without an answer"
    finally:
        process.kill()
        process.join()
        receiver.close()


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
