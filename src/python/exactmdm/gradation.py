"""Grain size distributions."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any, Union

from exactmdm import _core
from exactmdm.enclosure import Enclosure
from exactmdm.errors import InputError
from exactmdm.exact import column, entries_of, shown, text_of
from exactmdm.figures import curve_figure, html_table
from exactmdm.tables import core_of, exact_texts, masses_of_passing, notes_of, order_of
from exactmdm.value import Value

if TYPE_CHECKING:
    import pandas


class Gradation(Value):
    """A grain size distribution: sieves, and the mass retained on each (Arnold, Eq. 5 to 8).

    Class j holds the particles with sizes[j] < x <= sizes[j + 1] and has the mass masses[j]. The sizes ascend or
    descend; a size 0 is the pan; the largest sieve must retain nothing. Only the ratios of the masses count: where one is
    no decimal, such as 1/3, all are multiplied by the least whole number that makes them decimals, and a note says so.

    Args:
        sizes: n openings, in `unit`, decimals as in files and proofs: Fraction(1, 3) is refused.
        masses: n masses, in any unit; that of the largest size is 0.
        unit: "mm", "um", "m", "in", "phi", or "sieve" for names such as "No. 200".
        id: a name for reports.
        factors: n densities or shape factors above 0, one a class (that of the largest size is not used).
        tolerances: n percentage points, for tolerance="retained:file" and "passing:file".
        exact: take floats too, as the binary numbers that they are.
        floats: "shortest" takes each as the shortest decimal that means it, with a note; "binary" is exact=True.

    Raises:
        InputError: a number is a float, or the numbers are no gradation.

    >>> sand = Gradation(sizes=["0.1", "0.2", "0.4"], masses=[1, Fraction(5, 2), 0], id="sand")
    >>> sand
    <Gradation 'sand': 2 classes, 0.1 to 0.4 mm>
    >>> sand.sizes[0], sand.passing
    (Fraction(1, 10), (Fraction(0, 1), Fraction(200, 7), Fraction(100, 1)))
    """

    _handle: _core.Gradation
    #: Name and text of a file that the proof checker reads as it is, or None.
    _source: tuple[str, str] | None

    def __init__(self, sizes: Iterable[object], masses: Iterable[object], unit: str = "mm", id: str = "", *,
                 factors: Iterable[object] = (), tolerances: Iterable[object] = (), exact: bool = False,
                 floats: str | None = None) -> None:
        how = "binary" if exact and floats is None else floats
        given = {name: entries_of(values, name) for name, values in (
            ("sizes", sizes), ("masses", masses), ("factors", factors), ("tolerances", tolerances))}
        columns = [exact_texts(values, name, how) for name, values in given.items()]
        core = core_of(columns[0], columns[1], text_of(unit, "unit"), text_of(id, "id"), columns[2], columns[3],
                       notes_of(given.values(), how))
        self._set(_handle=core, _source=None)

    @classmethod
    def from_frame(cls, frame: pandas.DataFrame, *, size: str, mass: str | None = None, passing: str | None = None,
                   unit: str = "mm", id: str = "", floats: str | None = None) -> Gradation:
        """The gradation in a pandas DataFrame, a row a sieve in any order.

        Args:
            frame: or whatever has columns by their names.
            size: the column of the openings, in `unit`.
            mass: the column of the masses retained on each; that of the largest is 0.
            passing: instead of it the column of the percents that pass each; 100 of the largest. What passes the finest one
                is in the pan.
            unit, id, floats: as Gradation. Columns of pandas are mostly floats: say "shortest" for the decimals that they
                show.

        >>> Gradation.from_frame({"d": ["1", "2", "4"], "p": [0, 40, 100]}, size="d", passing="p").masses
        (Fraction(40, 1), Fraction(60, 1), Fraction(0, 1))
        """
        if (mass is None) == (passing is None):
            raise InputError("give mass or passing, the column that says how much there is")
        amount = str(passing if mass is None else mass)
        sizes, amounts = entries_of(frame[size], size), entries_of(frame[amount], amount)
        if len(sizes) != len(amounts):
            raise InputError(f"{size} and {amount} must be as long as each other: {len(sizes)} and {len(amounts)}")
        if mass is not None:
            order = order_of(exact_texts(sizes, size, floats), unit)
            return cls([sizes[i] for i in order], [amounts[i] for i in order], unit, id, floats=floats)
        kept, masses = masses_of_passing(exact_texts(sizes, size, floats), exact_texts(amounts, amount, floats), unit)
        return cls._of(core_of(kept, masses, text_of(unit, "unit"), text_of(id, "id"), [], [],
                               notes_of([sizes, amounts], floats)))

    @classmethod
    def _of(cls, core: _core.Gradation, source: tuple[str, str] | None = None) -> Gradation:
        gradation = cls.__new__(cls)
        gradation._set(_handle=core, _source=source)
        return gradation

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._parts, self._source)

    @cached_property
    def _parts(self) -> tuple[Any, ...]:
        return self._handle.parts()

    @property
    def id(self) -> str:
        """The name."""
        return self._handle.id()

    @property
    def unit(self) -> str:
        """The unit of the sizes: "mm", "um" or "m"."""
        return self._handle.unit()

    @cached_property
    def sizes(self) -> tuple[Union[Fraction, Enclosure], ...]:
        """The n openings, ascending. An opening of phi that is no whole number is irrational: an Enclosure."""
        return tuple(Fraction(lo) if lo == hi else Enclosure(Decimal(lo), Decimal(hi))
                     for lo, hi in self._handle.openings())

    @cached_property
    def masses(self) -> tuple[Fraction, ...]:
        """The n masses retained, of which the last is 0."""
        return tuple(Fraction(mass) for mass in self._handle.masses())

    @cached_property
    def factors(self) -> tuple[Fraction, ...]:
        """The n density or shape factors, or none."""
        return tuple(Fraction(factor) for factor in self._handle.factors())

    @cached_property
    def tolerances(self) -> tuple[Fraction, ...]:
        """The n tolerances in percentage points, or none."""
        return tuple(Fraction(tolerance) for tolerance in self._handle.tolerances())

    @cached_property
    def shares(self) -> tuple[Fraction, ...]:
        """The mass of each of the n - 1 classes over that of all."""
        total = sum(self.masses)
        return tuple(mass / total for mass in self.masses[:-1])

    @cached_property
    def passing(self) -> tuple[Fraction, ...]:
        """The percent of the mass that passes each of the n sizes."""
        passing = [Fraction(0)]
        for share in self.shares:
            passing.append(passing[-1] + 100 * share)
        return tuple(passing)

    @property
    def notes(self) -> tuple[str, ...]:
        """What was assumed where it was read."""
        return tuple(self._handle.notes())

    def __len__(self) -> int:
        """The number of classes, n - 1."""
        return len(self.sizes) - 1

    def csv(self) -> str:
        """Canonical CSV, which the proof checker reads."""
        return self._handle.csv()

    def json(self) -> str:
        """Canonical JSON, a line with its end."""
        return self._handle.json()

    def to_frame(self) -> pandas.DataFrame:
        """A pandas DataFrame with a row a class: lower, upper, mass, share, as floats, or as exact numbers in a column that
        floats cannot have."""
        import pandas

        sizes = column(self.sizes)
        return pandas.DataFrame({"lower": sizes[:-1], "upper": sizes[1:], "mass": column(self.masses[:-1]),
                                 "share": column(self.shares)})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Gradation) and self._parts == other._parts

    def __hash__(self) -> int:
        return hash((tuple(self._handle.masses()), self.id))

    def __repr__(self) -> str:
        name = f" {self.id[:40]!r}" if self.id else ""
        classes = "1 class" if len(self) == 1 else f"{len(self)} classes"
        return (f"<Gradation{name}: {classes}, {shown(self.sizes[0])} to {shown(self.sizes[-1])} {self.unit}>")

    def _repr_html_(self) -> str:
        header = [f"sizes, {self.unit} (above, up to]", "mass", "passes, %"]
        rows = [[f"({shown(self.sizes[j])}, {shown(self.sizes[j + 1])}]", shown(self.masses[j]),
                 shown(self.passing[j + 1])] for j in range(len(self))]
        curves = [("#1f5fa8", list(zip(self.sizes, self.passing)))]
        return f"<p><b>{escape(self.id)}</b></p>{html_table(header, rows)}{curve_figure(curves, self.unit)}"


def read_line(line: bytes, file: str, number: int) -> Gradation:
    """The gradation in a line of a suite."""
    return Gradation._of(_core.read_line(line, f"{file}:{number}", str(number)))


def _restored(parts: tuple[Any, ...], source: tuple[str, str] | None) -> Gradation:
    return Gradation._of(_core.Gradation(*parts), source)
