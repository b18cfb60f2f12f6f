"""From a gradation and a question to the smallest match."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import Any, Union

from exactmdm import _core
from exactmdm.errors import Interrupted, LimitReached
from exactmdm.exact import Number
from exactmdm.gradation import Gradation
from exactmdm.match import Match
from exactmdm.options import given_of, words_of
from exactmdm.reading import gradation_of

#: Called some times a second while a search goes on, with its steps, a lower bound on the particles, and the particles
#: of the smallest match so far or None. What it raises ends the search.
Progress = Callable[[int, int, Union[int, None]], object]

#: A tolerance as `mdm solve --tolerance` takes it, or percentage points of what each class retains; or several.
Tolerance = Union[Number, Iterable[Number], None]


def solve(gradation: Union[Gradation, str, "os.PathLike[str]", None] = None, *,
          # Options of solve, by src/ask/write_modules.
          tolerance: Tolerance = None, band: Union[str, "os.PathLike[str]", None] = None,
          particles: Number | None = None, by: str | None = None, grid: Number | None = None,
          min_per_class: Number | None = None, at_least: Number | None = None, specimen: str | None = None,
          void_ratio: Number | None = None, solids_volume: Number | None = None, at_most: Number | None = None,
          law: str | None = None, size_factor: Number | None = None, cut_below: Number | None = None,
          pan_size: Number | None = None, digits: Number | None = None, scale: str | None = None,
          max_steps: Number | None = None, node_limit: Number | None = None,
          time_limit: Union[Number, float, None] = None, gap: Number | None = None,
          # End of the options.
          progress: Progress | None = None) -> Match:
    """The smallest set of particles that matches a gradation: exactly, or within a tolerance. Each keyword is an option
    of `mdm solve`.

    Args:
        gradation: a Gradation, or the path of a file; None with a band alone.
        tolerance: "retained:1%", "passing:0.5%", "total:1%" (percentage points), "retained:file", "passing:file",
            "laboratory", "rounding", or percentage points of what is retained; of several all hold. With `particles`
            its kind alone: "retained", "passing" or "total".
        band: path of an envelope, CSV with passing_min_percent and passing_max_percent of each sieve, or a
            table with columns such as Lower and Upper.
        particles, by, grid: a budget: the least tolerance with which so many particles suffice, in steps of so many percentage
            points (0.001); or by "size-factor" the least factor from 1 on with which they suffice for the specimen.
        min_per_class: particles in every class with mass, at least.
        at_least: particles in all, at least.
        at_most: more particles are no match: the status is "none".
        specimen, void_ratio: "cylinder:DxH" or "box:AxBxC", lengths as "50mm" or in the unit of the gradation, and the
            void ratio e in it: the least volume of solids.
        solids_volume: that volume itself, in the cube of the gradation's unit.
        law: mass of a particle of size x: "sphere" (x^3), "power:a/b", "sum:2*x^3+0.5*x^2" with x in mm, or
            "table:FILE"; the text of the table may stand in the place of its path.
        size_factor: multiplies every size of the gradation.
        cut_below: leaves out the classes below this sieve.
        pan_size: takes the pan as this size, instead of 0.
        digits: significant digits of sizes, 15.
        scale: "robust" (sizes far from the sieves) or "upper" (largest sizes).
        max_steps, node_limit, time_limit (seconds), gap (relative): end the search; the first is of exact matches, the
            second and the last of those within a tolerance.
        progress: called some times a second while the search goes on.

    Returns:
        The match. Its status is "none" if there is none within what was asked.

    Raises:
        InputError: the question does not fit the gradation.
        LimitReached: a limit came before the end; `known` is the Match with what is certain.
        Interrupted: Ctrl-C, within a second; `known` is the same.

    Source: the least match is proofs/README.md, Theorem 3; within a tolerance, Theorem 17 and after.

    >>> sand = exactmdm.Gradation(["0.1", "0.2", "0.4", "0.8"], [20, 30, 50, 0])
    >>> exactmdm.solve(sand)
    <Match: 6 particles, optimal, 3 classes>
    >>> exactmdm.solve(sand, tolerance="retained:2%").particles
    5
    """
    words = words_of(given_of("solve", locals()))
    of = None if gradation is None else gradation_of(gradation)
    core, finer_core, error = _core.solve(None if of is None else of._handle, words.values, words.tolerances, True,
                                          progress)
    finer = None if finer_core is None else Match._of(finer_core, of, words, is_finer=True)
    match = Match._of(core, of, words, finer)
    raise_ended(match, error, core.outcome() == "limited")
    return match


def budget(gradation: Union[Gradation, str, "os.PathLike[str]"], particles: Number, *, tolerance: str = "retained",
           **options: Any) -> Match:
    """The smallest match within the least tolerance with which so many particles suffice: `solve` with `particles`.

    Args:
        particles: the budget, 1 or more.
        tolerance: the kind: "retained", "passing" or "total".
        options: `grid` (percentage points, 0.001) and others of `solve`.

    >>> sand = exactmdm.Gradation(["0.1", "0.2", "0.4", "0.8"], [20, 30, 50, 0])
    >>> exactmdm.budget(sand, 4).budget.tolerance
    Fraction(6001, 1000)
    """
    return solve(gradation, particles=particles, tolerance=tolerance, **options)


def raise_ended(known: Any, error: BaseException | None, is_limited: bool) -> None:
    """Raises what ended a search before its end, with what is known."""
    if isinstance(error, KeyboardInterrupt):
        raise Interrupted(f"the search was interrupted: {known!r}", known) from None
    if error is not None:
        raise error
    if is_limited:
        raise LimitReached(f"a limit was reached: {known!r}", known)
