"""The price of fewer particles."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Union

from exactmdm import _core
from exactmdm.exact import Number, column, optional_int, shown, text_of
from exactmdm.figures import html_table
from exactmdm.gradation import Gradation
from exactmdm.options import words_of
from exactmdm.reading import gradation_of
from exactmdm.solving import Progress, raise_ended

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class TradeoffRow:
    """A sample that a modeller may choose."""

    tolerance: Fraction  #: percentage points; 0: exact
    smallest: Decimal  #: the smallest sieve that is kept
    lost: Fraction  #: share of the mass below it
    status: str  #: as of a Match
    particles: int | None
    lower_bound: int


@dataclass(frozen=True)
class SizeFactorRow:
    """A specimen whose particles are magnified."""

    size_factor: Fraction
    status: str  #: as of a Match
    particles: int | None
    lower_bound: int
    coarsest: int | None  #: particles of the coarsest class
    specimen_over_largest: Fraction | None  #: the shortest length of the specimen over the coarsest opening


@dataclass(frozen=True)
class Tradeoff:
    """The number of particles against the tolerance, against the smallest sieve that is kept, and, with a specimen and
    `particles`, against a size factor."""

    id: str
    unit: str
    kind: str  #: of the tolerances: "retained", "passing" or "total"
    by_tolerance: tuple[TradeoffRow, ...]
    by_sieve: tuple[TradeoffRow, ...]
    _json: str
    by_size_factor: tuple[SizeFactorRow, ...] = ()

    @property
    def complete(self) -> bool:
        """True if no limit ended a row."""
        return all(row.status in ("optimal", "none") for row in self.by_tolerance + self.by_sieve + self.by_size_factor)

    def json(self) -> str:
        """In the schema mdm-tradeoff-1, without an end of line."""
        return self._json

    def to_frame(self) -> pandas.DataFrame:
        """A pandas DataFrame with a row a point: by, tolerance, smallest, lost, particles, lower_bound, status."""
        import pandas

        rows = [("tolerance", row) for row in self.by_tolerance] + [("sieve", row) for row in self.by_sieve]
        return pandas.DataFrame({
            "by": [by for by, _ in rows], "tolerance": column(row.tolerance for _, row in rows),
            "smallest": column(row.smallest for _, row in rows), "lost": column(row.lost for _, row in rows),
            "particles": [row.particles for _, row in rows], "lower_bound": [row.lower_bound for _, row in rows],
            "status": [row.status for _, row in rows]})

    def __repr__(self) -> str:
        return f"<Tradeoff {self.id[:40]!r}: {len(self.by_tolerance)} tolerances, {len(self.by_sieve)} sieves>"

    def _repr_html_(self) -> str:
        def cells(row: TradeoffRow, by: object) -> list[str]:
            return [shown(by), str(row.particles if row.particles is not None else f">= {row.lower_bound}"), row.status]

        return (html_table([f"{self.kind}, percentage points", "particles", "status"],
                           [cells(row, row.tolerance) for row in self.by_tolerance])
                + html_table([f"smallest sieve, {self.unit}", "particles", "status"],
                             [cells(row, row.smallest) for row in self.by_sieve]))


def tradeoff(gradation: Union[Gradation, str, "os.PathLike[str]"], *, kind: str = "retained",
             tolerances: Iterable[Number] = ("0", "0.1", "0.2", "0.5", "1", "2", "5"),
             particles: Union[Iterable[Number], str] = (), grid: Number | None = None, progress: Progress | None = None,
             **options: Any) -> Tradeoff:
    """The smallest number of particles over the tolerance, and over the smallest sieve that is kept.

    Args:
        kind: what the tolerances are of: "retained", "passing" or "total".
        tolerances: percentage points; 0 is the exact match.
        particles: budgets, of each of which the least tolerance is added, and with a specimen the least size factor;
            "all": 1, 2, 5, 10, ...
        grid: the steps of those tolerances in percentage points, and of those factors (0.001).
        options: others of `solve`; limits are of each row. Rows that a limit ends say so.

    Raises:
        InputError: the question does not fit the gradation.
        Interrupted: Ctrl-C; `known` is the Tradeoff with what is certain.

    >>> sand = exactmdm.Gradation(["0.1", "0.2", "0.4", "0.8"], [20, 30, 50, 0])
    >>> [row.particles for row in exactmdm.tradeoff(sand, tolerances=[0, 1, 5]).by_tolerance]
    [6, 5, 5]
    """
    words = words_of(options)
    budgets = "all" if particles == "all" else ",".join(text_of(value, "particles") for value in particles)
    own = {"kind": text_of(kind, "kind"), "tolerances": ",".join(text_of(value, "tolerances") for value in tolerances)}
    if budgets:
        own["particles"] = budgets
    if grid is not None:
        own["grid"] = text_of(grid, "grid")
    report, error = _core.tradeoff(gradation_of(gradation)._handle, words.values, words.tolerances, own, progress)
    found = _read(report)
    raise_ended(found, error, False)
    return found


def _read(report: str) -> Tradeoff:
    tree = json.loads(report)

    def rows(name: str) -> tuple[TradeoffRow, ...]:
        return tuple(TradeoffRow(Fraction(row["tolerance"]), Decimal(row["smallest"]), Fraction(row["lost"]),
                                 row["status"], optional_int(row["particles"]), int(row["lower_bound"]))
                     for row in tree[name])

    return Tradeoff(tree["id"], tree["unit"], tree["kind"], rows("by_tolerance"), rows("by_sieve"), report,
                    tuple(SizeFactorRow(Fraction(row["size_factor"]), row["status"], optional_int(row["particles"]),
                                        int(row["lower_bound"]), optional_int(row["coarsest"]),
                                        None if row["specimen_over_largest"] is None
                                        else Fraction(row["specimen_over_largest"]))
                          for row in tree.get("by_size_factor", [])))
