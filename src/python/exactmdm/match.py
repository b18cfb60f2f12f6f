"""The smallest match."""

from __future__ import annotations

import json
import operator
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any, Union

from exactmdm import _core
from exactmdm.checking import Verdict, check
from exactmdm.enclosure import Enclosure, optional_enclosure
from exactmdm.errors import InputError
from exactmdm.exact import column, middle, optional_int, shown
from exactmdm.figures import curve_figure, html_table
from exactmdm.gradation import Gradation, read_line
from exactmdm.options import Words
from exactmdm.value import Value

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class MatchClass:
    """A class of a match: its particles have sizes lower < x <= upper."""

    lower: Decimal  #: in the unit of the match; of irrational openings the nearest 15 digits
    upper: Decimal
    mass: Fraction  #: of the gradation, in its unit
    quantity: int  #: of particles; 0 where no match is known
    size: Enclosure | None  #: of each of them; None where there are none


@dataclass(frozen=True)
class MatchScale:
    """All scales above < s <= up_to make the quantities an exact match; `chosen` is that of the sizes.

    The masses of the sample are the scale times those of the gradation, in units of c x^(a/b); to the power `power`.
    Within a tolerance there is but `chosen`, of the shares that the match has.
    """

    above: Fraction | None
    up_to: Fraction | None
    chosen: Fraction
    margin: Decimal | None  #: least relative distance of a size to its sieves
    power: int


@dataclass(frozen=True)
class Budget:
    """The tolerance in percentage points, or the size factor, that a budget of particles chose."""

    particles: int
    tolerance: Fraction | None  #: with which it suffices; None if there is none, or a size factor was asked for
    next_finer: Fraction | None  #: with which it does not; None at the tolerance 0 and at the factor 1
    size_factor: Fraction | None = None  #: with which it suffices; None if there is none, or a tolerance was asked for


#: A gradation in a line of a file that is read when it is asked for: the line, the file's name and its number.
LaterGradation = tuple[bytes, str, int]


class Match(Value):
    """The smallest set of particles that matches a gradation, or what is known of it. `solve` makes it.

    >>> match = exactmdm.solve(exactmdm.Gradation(["1", "2", "3"], [2, 1, 0]))
    >>> match
    <Match: 4 particles, optimal, 2 classes>
    >>> match.particles, match.quantities, match.sizes[0]
    (4, (3, 1), Enclosure(Decimal('1.86944032106812'), Decimal('1.86944032106813')))
    >>> match.check()
    <Verdict: accepted>
    """

    _of_gradation: Union[Gradation, LaterGradation, None]
    #: With a budget: the match at the next finer tolerance, which proves that it needs more; or None. Of a batch it is
    #: kept with proofs=True.
    finer: Match | None
    _words: Words
    _handle_or_none: _core.Match | None
    _json: str
    _outcome: str
    _is_finer: bool
    _certificate: str | None

    @classmethod
    def _of(cls, core: _core.Match, gradation: Union[Gradation, LaterGradation, None], words: Words,
            finer: Match | None = None, *, is_finer: bool = False) -> Match:
        match = cls.__new__(cls)
        match._set(_handle_or_none=core, _of_gradation=gradation, _words=words, finer=finer, _json=core.json(),
                   _outcome=core.outcome(), _is_finer=is_finer, _certificate=None)
        return match

    @classmethod
    def _of_batch(cls, json: str, outcome: str, core: _core.Match | None, finer_core: _core.Match | None,
                  gradation: Union[Gradation, LaterGradation], words: Words) -> Match:
        finer = None if finer_core is None else cls._of(finer_core, gradation, words, is_finer=True)
        match = cls.__new__(cls)
        match._set(_handle_or_none=core, _of_gradation=gradation, _words=words, finer=finer, _json=json,
                   _outcome=outcome, _is_finer=False, _certificate=None)
        return match

    @cached_property
    def gradation(self) -> Gradation | None:
        """The gradation as it was asked about; None of a match of a band alone."""
        return read_line(*self._of_gradation) if isinstance(self._of_gradation, tuple) else self._of_gradation

    def __reduce__(self) -> tuple[Any, ...]:
        try:
            certificate: str | None = self.certificate()
        except InputError:
            certificate = None
        return _restored, ({"_of_gradation": self._of_gradation, "_words": self._words, "finer": self.finer,
                            "_json": self._json, "_outcome": self._outcome, "_is_finer": self._is_finer,
                            "_certificate": certificate},)

    @property
    def _handle(self) -> _core.Match:
        """Of a match from a batch or a pickle: solved again when it is needed."""
        if self._handle_or_none is None:
            if self._outcome == "limited":
                raise InputError("a match from a pickle that a limit ended has its JSON and its proof alone")
            core = None if self.gradation is None else self.gradation._handle
            match, finer, error = _core.solve(core, self._words.values, self._words.tolerances, True, None)
            if error is not None:
                raise error
            self._set(_handle_or_none=finer if self._is_finer else match)
        assert self._handle_or_none is not None
        return self._handle_or_none

    @cached_property
    def _answer(self) -> dict[str, Any]:
        answer: dict[str, Any] = json.loads(self._json)
        return answer

    @property
    def id(self) -> str:
        """The name of the gradation."""
        return str(self._answer["id"])

    @property
    def unit(self) -> str:
        """The unit of all lengths: "mm", "um" or "m"."""
        return str(self._answer["unit"])

    @property
    def status(self) -> str:
        """"optimal": it is the smallest. "feasible": a limit came first. "none": there is no match within at_most, or
        none at all. "unknown": a limit came before one was found."""
        return str(self._answer["status"])

    @property
    def particles(self) -> int | None:
        """The number of all particles; None without a match."""
        return optional_int(self._answer["particles"])

    @property
    def lower_bound(self) -> int:
        """No match has fewer particles."""
        return int(self._answer["lower_bound"])

    @property
    def upper_bound(self) -> int | None:
        """A match has so many particles; None if none is known."""
        bound = self._answer.get("upper_bound")
        return self.particles if bound is None else int(bound)

    @cached_property
    def classes(self) -> tuple[MatchClass, ...]:
        """Every class of the gradation, ascending, empty ones included."""
        return tuple(MatchClass(Decimal(c["lower"]), Decimal(c["upper"]), Fraction(c["mass"]),
                                optional_int(c["quantity"]) or 0, optional_enclosure(c["size"]))
                     for c in self._answer["classes"])

    @property
    def quantities(self) -> tuple[int, ...]:
        """The number of particles in each class, ascending."""
        return tuple(c.quantity for c in self.classes)

    @property
    def sizes(self) -> tuple[Enclosure | None, ...]:
        """The size of the particles of each class; None where there are none."""
        return tuple(c.size for c in self.classes)

    @cached_property
    def scale(self) -> MatchScale | None:
        """The scale; None without a match."""
        scale = self._answer["scale"]
        if scale is None:
            return None

        def bound(name: str) -> Fraction | None:
            return None if scale[name] is None else Fraction(scale[name])

        margin = None if scale["margin"] is None else Decimal(scale["margin"])
        return MatchScale(bound("above"), bound("up_to"), Fraction(scale["chosen"]), margin,
                          int(scale.get("scale_power", 1)))

    @cached_property
    def achieved(self) -> tuple[Fraction, ...] | None:
        """Within a tolerance: the share of each class in the mass of the sample; else None."""
        shares = self._answer.get("achieved")
        return None if shares is None else tuple(Fraction(share) for share in shares)

    @cached_property
    def solids_volume(self) -> Enclosure | None:
        """The volume of all particles, in the cube of the unit; of spheres alone."""
        return optional_enclosure(self._answer["solids_volume"])

    @cached_property
    def budget(self) -> Budget | None:
        """What a budget of particles chose; None if none was asked for."""
        budget = self._answer.get("budget")
        if budget is None:
            return None
        return Budget(int(budget["particles"]), _optional_fraction(budget.get("tolerance")),
                      _optional_fraction(budget["next_finer"]), _optional_fraction(budget.get("size_factor")))

    @property
    def question(self) -> str:
        """What was asked, in words; empty for the plain question."""
        return str(self._answer.get("question", ""))

    @property
    def notes(self) -> tuple[str, ...]:
        """What the reader should know."""
        return tuple(self._answer["notes"])

    def json(self) -> str:
        """The answer in the schema mdm-answer-1, as `mdm solve --format json` writes it, without an end of line."""
        return self._json

    def csv(self) -> str:
        """A row a class, as `mdm solve --format csv` writes it."""
        return self._handle.csv()

    def text(self) -> str:
        """The answer for people."""
        return self._handle.text()

    def certificate(self) -> str:
        """The proof that no match has fewer particles, in the format of mdm-check; where a limit ended the search, that
        none has fewer than `lower_bound`, or a little less where the proof of that would be too long.

        Raises:
            InputError: there is nothing to prove, the proof was not kept (max_steps above 67108864), or its numbers are beyond
                the limits of the format.
        """
        return self._handle.certificate() if self._certificate is None else self._certificate

    def vipr(self) -> str:
        """The proof in the format VIPR; at most 200 classes."""
        return self._handle.vipr()

    def check(self) -> Verdict:
        """The verdict of the independent checker on the certificate, in process.

        Raises:
            InputError: there is no certificate.
        """
        return check(self.gradation if self.gradation is not None else self._band(), self.certificate())

    def _band(self) -> tuple[str, str]:
        return self._words.values["band_name"], self._words.values["band"]

    def spread(self, seed: int = 1) -> Spread:
        """Sizes for all particles, drawn in their class so that its mass is exact, as `mdm solve --spread`.

        Raises:
            InputError: there is no match, or it has more than 10^9 particles.
        """
        return Spread(self, seed)

    def to_frame(self) -> pandas.DataFrame:
        """A pandas DataFrame with a row a class: lower, upper, mass, quantity, size with its bounds size_lo and size_hi, and
        share, what the class has of the mass of the match; floats but for the quantity, and exact numbers in a column that
        floats cannot have."""
        import pandas

        sizes = [c.size for c in self.classes]
        return pandas.DataFrame({
            "lower": column(c.lower for c in self.classes), "upper": column(c.upper for c in self.classes),
            "mass": column(c.mass for c in self.classes), "quantity": list(self.quantities), "size": column(sizes),
            "size_lo": column(None if size is None else size.lo for size in sizes),
            "size_hi": column(None if size is None else size.hi for size in sizes), "share": column(self._shares())})

    def _shares(self) -> list[Fraction | None]:
        """What each class has of the mass of the match; None where there is no match."""
        if not self:
            return [None for _ in self.classes]
        total = sum(c.mass for c in self.classes)
        return list(self.achieved) if self.achieved is not None else [c.mass / total for c in self.classes]

    def __bool__(self) -> bool:
        """True if there is a match, though perhaps not yet the smallest one."""
        return self.upper_bound is not None

    def _key(self) -> tuple[Any, ...]:
        return self.gradation, self._words.values, self._words.tolerances, self._json

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Match) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._json)

    def __repr__(self) -> str:
        name = f" {self.id[:40]!r}" if self.id else ""
        count = self.upper_bound
        if count is not None and count != self.lower_bound:
            number = f"{_short(self.lower_bound)} to {_short(count)} particles"
        elif count is None:
            number = f"at least {_short(self.lower_bound)} particles"
        else:
            number = f"{_short(count)} {'particle' if count == 1 else 'particles'}"
        classes = len(self._answer["classes"])
        return f"<Match{name}: {number}, {self.status}, {classes} {'class' if classes == 1 else 'classes'}>"

    def _repr_html_(self) -> str:
        header = [f"sizes, {self.unit} (above, up to]", "mass", "quantity", f"size, {self.unit}"]
        rows = [[f"({c.lower}, {c.upper}]", shown(c.mass), str(c.quantity), "" if c.size is None else shown(c.size)]
                for c in self.classes]
        curves = [("#1f5fa8", list(curve(self))), ("#c0562b", list(stairs(self)))]
        title = escape(repr(self)[1:-1])
        return f"<p><b>{title}</b></p>{html_table(header, rows)}{curve_figure(curves, self.unit)}"


class Spread(Value):
    """The sizes of all particles of a match, each drawn in its class. Iterating makes them: memory does not grow.

    >>> match = exactmdm.solve(exactmdm.Gradation(["1", "2", "3"], [2, 1, 0]))
    >>> [float(size) for size in match.spread(seed=1)]  # doctest: +ELLIPSIS
    [1..., 1..., 1..., 2...]
    """

    match: Match
    seed: int

    def __init__(self, match: Match, seed: int) -> None:
        if not 0 <= operator.index(seed) < 1 << 64:
            raise InputError("seed: write a whole number of 64 bits")
        self._set(match=match, seed=seed)
        _core.SpreadSizes(match._handle, seed)  # refuses what cannot be spread

    def __len__(self) -> int:
        return sum(self.match.quantities)

    def __iter__(self) -> Iterator[Enclosure]:
        sizes = _core.SpreadSizes(self.match._handle, self.seed)
        while chunk := sizes.next(4096):
            for _, lo, hi in chunk:
                yield Enclosure(Decimal(lo), Decimal(hi))

    def __repr__(self) -> str:
        return f"<Spread: {len(self)} particles, seed {self.seed}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Spread, (self.match, self.seed)


def _restored(attributes: dict[str, Any]) -> Match:
    match = Match.__new__(Match)
    match._set(_handle_or_none=None, **attributes)
    return match


def _optional_fraction(text: Union[str, None]) -> Fraction | None:
    return None if text is None else Fraction(text)


def _short(count: int) -> str:
    """A count for one line."""
    digits = count.bit_length() * 3 // 10
    return str(count) if digits < 18 else f"about 10^{digits}"


def curve(match: Match) -> Iterator[tuple[Fraction, Fraction]]:
    """The curve of the gradation of a match: size and percent passing."""
    total = sum(c.mass for c in match.classes)
    percent = Fraction(0)
    yield Fraction(match.classes[0].lower), percent
    for c in match.classes:
        percent += 100 * c.mass / total
        yield Fraction(c.upper), percent


def stairs(match: Match) -> Iterator[tuple[Fraction, Fraction]]:
    """The curve of the particles of a match, (size, percent): it rises at their sizes. Nothing without a match."""
    if match.particles is None:
        return
    total = sum(c.mass for c in match.classes)
    shares = match.achieved or tuple(c.mass / total for c in match.classes)
    percent = Fraction(0)
    yield Fraction(match.classes[0].lower), percent
    for c, share in zip(match.classes, shares):
        if c.size is not None:
            yield middle(c.size), percent
            percent += 100 * share
            yield middle(c.size), percent
