"""Samples beside a gradation."""

from __future__ import annotations

import json
import os
from array import array
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property
from html import escape
from itertools import islice
from typing import TYPE_CHECKING, Any, Union

from exactmdm import _core
from exactmdm.enclosure import Enclosure, exact_or_enclosed
from exactmdm.errors import InputError, cannot_read, in_file
from exactmdm.exact import Number, column, middle, shown, text_of, valid_text
from exactmdm.figures import html_table
from exactmdm.gradation import Gradation
from exactmdm.match import Match
from exactmdm.options import given_of, words_of
from exactmdm.reading import gradation_of
from exactmdm.solving import Tolerance
from exactmdm.value import Value

if TYPE_CHECKING:
    import pandas

_AT_ONCE = 1 << 16


@dataclass(frozen=True)
class VerifiedClass:
    """A class of a gradation, lower < x <= upper, with the particles of a sample in it."""

    lower: Decimal
    upper: Decimal
    quantity: int
    target: Fraction  #: share of the mass that the gradation has
    found: Union[Fraction, Enclosure]  #: that the sample has
    error: Union[Fraction, Enclosure]  #: target - found


class Verification(Value):
    """Whether a sample matches a gradation. It is true if it does; `verify` makes it."""

    _verdict: str
    _json: str
    _text: str

    @classmethod
    def _of(cls, verdict: str, json: str, text: str) -> Verification:
        verification = cls.__new__(cls)
        verification._set(_verdict=verdict, _json=json, _text=text)
        return verification

    def __reduce__(self) -> tuple[Any, ...]:
        return Verification._of, (self._verdict, self._json, self._text)

    @cached_property
    def _report(self) -> dict[str, Any]:
        report: dict[str, Any] = json.loads(self._json)
        return report

    @property
    def verdict(self) -> str:
        """"match", "no match", or "undecided" where an irrational law leaves it open."""
        return self._verdict

    def __bool__(self) -> bool:
        return self._verdict == "match"

    @property
    def particles(self) -> int:
        """The number of particles of the sample."""
        return int(self._report["particles"])

    @property
    def smallest(self) -> tuple[int, int]:
        """Bounds of the number of particles of the smallest exact match; mostly equal."""
        lo, hi = self._report["smallest"]
        return int(lo), int(hi)

    @property
    def outside(self) -> tuple[int, int]:
        """The numbers of particles below and above all classes."""
        outside = self._report["outside"]
        return int(outside["below"]), int(outside["above"])

    @cached_property
    def classes(self) -> tuple[VerifiedClass, ...]:
        """Every class, ascending."""
        return tuple(VerifiedClass(Decimal(c["lower"]), Decimal(c["upper"]), int(c["quantity"]),
                                   Fraction(c["target"]), exact_or_enclosed(c["found"]), exact_or_enclosed(c["error"]))
                     for c in self._report["classes"])

    @property
    def maximum_error(self) -> Union[Fraction, Enclosure]:
        """The largest absolute error of a share, of 1."""
        return exact_or_enclosed(self._report["maximum_error"])

    @property
    def total_error(self) -> Union[Fraction, Enclosure]:
        """The sum of all absolute errors of shares."""
        return exact_or_enclosed(self._report["total_error"])

    @property
    def packing(self) -> dict[str, Any] | None:
        """What the places of the particles say, as in the JSON; None where they have none, or were not judged."""
        found: dict[str, Any] | None = self._report["packing"]
        return found

    @property
    def objections(self) -> tuple[str, ...]:
        """What is wrong with an answer apart from its shares."""
        return tuple(self._report["objections"])

    @property
    def notes(self) -> tuple[str, ...]:
        """What the reader should know."""
        return tuple(self._report["notes"])

    def json(self) -> str:
        """The report in the schema mdm-verify-1, without an end of line."""
        return self._json

    def text(self) -> str:
        """The report for people."""
        return self._text

    def to_frame(self) -> pandas.DataFrame:
        """A pandas DataFrame with a row a class: lower, upper, quantity, target, found, error; as floats,
        or as exact numbers in a column that floats cannot have."""
        import pandas

        return pandas.DataFrame({
            "lower": column(c.lower for c in self.classes), "upper": column(c.upper for c in self.classes),
            "quantity": [c.quantity for c in self.classes], "target": column(c.target for c in self.classes),
            "found": column(c.found for c in self.classes), "error": column(c.error for c in self.classes)})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Verification) and self._json == other._json

    def __hash__(self) -> int:
        return hash(self._json)

    def __repr__(self) -> str:
        return (f"<Verification: {self.verdict}, {self.particles} particles, largest error "
                f"{shown(100 * middle(self.maximum_error), 3)} %>")

    def _repr_html_(self) -> str:
        header = [f"sizes, {self._report['unit']} (above, up to]", "quantity", "target, %", "found, %"]
        rows = [[f"({c.lower}, {c.upper}]", str(c.quantity), shown(100 * c.target), shown(100 * middle(c.found))]
                for c in self.classes]
        return f"<p><b>{escape(repr(self)[1:-1])}</b></p>{html_table(header, rows)}"


def verify(gradation: Union[Gradation, str, "os.PathLike[str]"], sample: Any, *,
           # Options of verify, by src/ask/write_modules.
           tolerance: Tolerance = None, band: Union[str, "os.PathLike[str]", None] = None, snap: Number | None = None,
           from_format: str | None = None, radius: bool = False, diameter: bool = False, size_column: str | None = None,
           size_unit: str | None = None, timestep: Number | None = None, law: str | None = None,
           size_factor: Number | None = None, cut_below: Number | None = None, pan_size: Number | None = None,
           digits: Number | None = None, packing: bool = False, box: str | None = None, specimen: str | None = None,
           periodic: str | None = None, contact_gap: Number | None = None, margin: Number | None = None,
           # End of the options.
           ) -> Verification:
    """Whether particles match a gradation, as `mdm verify` judges. Memory does not grow with their number, but
    for ids, some 5 bits each where they mostly follow each other.

    Args:
        gradation: a Gradation, or the path of a file.
        sample: diameters, as a numpy array of float64 with one dimension (each taken as the binary number that it is)
            or any iterable of numbers, floats included; a Match; or the path of a file of particles, of any format of
            `mdm verify` but a set of `mdm generate`.
        tolerance, band: what shares may differ by, as in `solve`; none is 0.
        snap: takes a size within this part of a sieve as that sieve: "1e-12" for sizes computed in double.
        radius, diameter: what the sizes are, whatever a file calls them.
        size_unit: unit of the sizes, "mm", "um", "m" or "in"; None: the gradation's, or that of the file. One that
            contradicts the file is refused.
        from_format: the format of a file, as `--from`; None: told by its content.
        timestep: of a dump or of GSD; None: the last. Of several of that number the last counts.
        law, size_factor, cut_below, pan_size: as in `solve`.
        digits: significant digits of percents in reports, 6.
        packing: judge the places in a file of more than 20000 particles too: void ratio, contacts, overlaps, heights
            of the classes; see `packing` of the result.
        box, specimen, periodic, contact_gap, margin: of that judgement, as `mdm verify --box` and so on; each asks for
            it. Particles with their centre outside the box of the file, or this one, do not match.
        size_column: the column of sizes in a dump or CSV where it has a name of its own, such as c_r; with radius or
            diameter; other columns that are not known are then passed over.

    Raises:
        InputError: the gradation, an option or a particle is wrong.

    Source: Arnold, Eq. 9 to 13.

    >>> sand = exactmdm.Gradation(["1", "2", "3"], [8, 27, 0])
    >>> exactmdm.verify(sand, ["2", "3"])
    <Verification: match, 2 particles, largest error 0 %>
    >>> exactmdm.verify(sand, [2.0, 3.0, 3.0]).classes[0].error
    Fraction(108, 1085)
    """
    words = words_of(given_of("verify", locals()), "verify")
    if radius and diameter:
        raise InputError("radius and diameter: give one of them")
    verifier = _core.Verifier(gradation_of(gradation)._handle, words.values, words.tolerances)
    if isinstance(sample, Match):
        name = "match"
        verifier.add_answer(sample.json(), name)
    elif isinstance(sample, (str, os.PathLike)):
        name = valid_text(os.fspath(sample))
        with in_file(name):
            _add_file(verifier, sample, name, from_format)
    else:
        name = "sample"
        for chunk in _chunks(sample):
            if isinstance(chunk, list):
                verifier.add_texts(chunk)
            else:
                verifier.add_doubles(chunk)
    return Verification._of(*verifier.result(name))


def _chunks(sample: Any) -> Iterator[Any]:
    """Buffers of doubles, and lists of exact texts."""
    if hasattr(sample, "dtype") and hasattr(sample, "ndim"):
        yield from _array_chunks(sample.to_numpy() if hasattr(sample, "to_numpy") else sample)
        return
    if isinstance(sample, memoryview) and sample.ndim != 1:
        raise InputError(f"a sample has one dimension, this memoryview {sample.ndim}: give one row of sizes")
    try:
        entries = iter(sample)
    except TypeError:
        raise InputError(f"a sample is no {type(sample).__name__}: give an array or an iterable of sizes") from None
    while chunk := list(islice(entries, 4096)):
        if all(type(size) is float for size in chunk):
            yield array("d", chunk)
        else:
            yield [text_of(size, "sample", exact=True) for size in chunk]


def _array_chunks(sample: Any) -> Iterator[Any]:
    if sample.ndim != 1:
        raise InputError(f"a sample has one dimension, this array {sample.ndim}: give its column of sizes")
    if sample.dtype.kind not in "fiu":
        raise InputError(f"a sample is no array of {sample.dtype}: give float64")
    for first in range(0, len(sample), _AT_ONCE):
        chunk = sample[first:first + _AT_ONCE]
        if sample.dtype.kind != "f":
            yield [str(size) for size in chunk.tolist()]
        elif sample.dtype.itemsize > 8:
            yield [text_of(size, "sample", exact=True) for size in chunk]
        else:
            yield array("d", chunk.astype("=f8").tobytes())


def _add_file(verifier: _core.Verifier, path: Union[str, os.PathLike[str]], name: str, from_format: str | None) -> None:
    try:
        with open(path, "rb") as file:
            if from_format == "gsd" or (from_format is None and file.peek(8)[:8] == _GSD):
                verifier.add_gsd(file.read(), name)
                return
            first = file.readline()
            if from_format == "answer" or (from_format is None and first.lstrip(b"\xef\xbb\xbf \t\r")[:1] == b"{"):
                verifier.add_answer((first + file.read()).decode(), name)
                return
            verifier.add_lines([first.rstrip(b"\r\n")] if first else [], name)
            _add_lines(verifier, file, name)
    except UnicodeDecodeError:
        raise InputError(f"{name}: it is no UTF-8 text", name) from None
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise cannot_read(name, error) from None


#: The first bytes of a file of GSD.
_GSD = bytes.fromhex("df65df65df65df65")


def _add_lines(verifier: _core.Verifier, file: Iterable[bytes], name: str) -> None:
    lines = iter(file)
    while chunk := [line.rstrip(b"\r\n") for line in islice(lines, 4096)]:
        verifier.add_lines(chunk, name)
