"""Samples judged by the limits of a specification."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from contextlib import ExitStack
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Union

from exactmdm.enclosure import Enclosure, enclosure_of
from exactmdm.errors import LimitReached
from exactmdm.exact import Number, optional_fraction, text_of
from exactmdm.figures import html_table
from exactmdm.gradation import Gradation
from exactmdm.match import Match
from exactmdm.program import Source, called, file_of
from exactmdm.reading import Path


@dataclass(frozen=True)
class JudgedLimit:
    """The verdict at a sieve, or on a number beside them."""

    name: Union[Fraction, str]  #: the sieve (mm), or "FM", "FM-EN", "retained between 0.3 and 0.6 mm"
    verdict: str  #: "pass": for all curves that round to the report; "fail": for none; "hangs"; "undecided"
    min: Fraction | None  #: percent that is to pass, or the least number
    max: Fraction | None
    value: Enclosure | None  #: of the reported curve; None where the sample does not tell it
    least: Enclosure  #: the least and the most of the curves that round to the report
    most: Enclosure


@dataclass(frozen=True)
class JudgedSample:
    """The verdict on a sample. It is true if the sample passes."""

    id: str
    verdict: str  #: as of a limit, of all together
    rounded: bool  #: percents of the report stand for all numbers that round to them
    limits: tuple[JudgedLimit, ...]  #: at the sieves, ascending, then those beside them
    within: dict[Fraction, Fraction] | None  #: where it hangs: a curve that keeps all limits, percent by sieve (mm)
    outside: dict[Fraction, Fraction] | None  #: and one that does not
    notes: tuple[str, ...]

    def __bool__(self) -> bool:
        return self.verdict == "pass"


@dataclass(frozen=True)
class Judgement:
    """The verdicts on samples. It is true if all pass."""

    specification: str
    verdict: str  #: the worst of the samples'
    samples: tuple[JudgedSample, ...]
    about: tuple[str, ...]  #: where the limits are from
    _json: str

    def __bool__(self) -> bool:
        return self.verdict == "pass"

    def json(self) -> str:
        """In the schema mdm-judge-1."""
        return self._json

    def __repr__(self) -> str:
        told = ", ".join(f"{sample.id} {sample.verdict}" for sample in self.samples[:5])
        return f"<Judgement: {self.specification}: {told}{', ...' if len(self.samples) > 5 else ''}>"

    def _repr_html_(self) -> str:
        return html_table(["sample", "verdict", "limits that do not pass"],
                          [[s.id, s.verdict, ", ".join(f"{_shown(c.name)} {c.verdict}" for c in s.limits
                                                       if c.verdict != "pass")] for s in self.samples])


def judge(samples: Union[Source, Iterable[Source]], specification: Path, *, limit: Union[str, Iterable[str]] = (),
          rounding: Number | None = None) -> Judgement:
    """Whether samples keep a specification, whatever was rounded in their reports. Runs `mdm judge`.

    A percent in a file stands for all numbers that round to it. A Gradation has lost what was printed: it is exact, and a
    note says so, unless `rounding` is given.

    Args:
        samples: gradations, or files of them; or one.
        specification: a file of limits: CSV with passing_min_percent and passing_max_percent, or another envelope; or the
            name of one that comes with mdm, as "astm-c33-fine".
        limit: what it asks besides: "FM=2.3..3.1", the fineness modulus of ASTM C125, "FM-EN=..", that of EN 12620;
            "retained=..45%", what passes a sieve of it and stays on the next.
        rounding: one unit of the last digit of all percents, or "none".

    Raises:
        InputError: a keyword or a file is wrong.
        LimitReached: 1,200 digits do not tell a percent from its limit; `known` is the Judgement.

    >>> sieves = ["0.15", "0.3", "0.6", "1.18", "2.36", "4.75", "9.5"]
    >>> sand = exactmdm.Gradation(sieves, [15, 25, 22, 18, 12, 3, 0], id="sand")
    >>> exactmdm.judge(sand, "astm-c33-fine", limit="FM=..2.5")
    <Judgement: astm-c33-fine: sand fail>
    """
    sources = [samples] if isinstance(samples, (str, os.PathLike, Gradation, Match)) else list(samples)
    limits = [limit] if isinstance(limit, str) else list(limit)
    with ExitStack() as stack:
        words = [stack.enter_context(file_of(source)) for source in sources]
        for text in limits:
            words += ["--limit", text]
        if rounding is not None:
            words += ["--rounding", text_of(rounding, "rounding")]
        try:
            _, report = called("judge", *words, "--spec", os.fspath(specification), "--format=json", "--quiet")
        except LimitReached as reached:
            raise LimitReached(str(reached), _read(reached.known)) from None
    return _read(report)


def _read(report: str) -> Judgement:
    tree = json.loads(report)
    specification = tree["specification"]
    allowed = {sieve["size"]: sieve for sieve in specification["sieves"]}
    return Judgement(specification["id"], tree["verdict"], tuple(_sample(sample, allowed) for sample in tree["samples"]),
                     tuple(specification["about"]), report.rstrip("\n"))


def _sample(sample: dict[str, Any], allowed: dict[str, dict[str, Any]]) -> JudgedSample:
    sieves = [_limit(Fraction(s["size"]), s, allowed[s["size"]]["passing_min_percent"],
                     allowed[s["size"]]["passing_max_percent"], s["percent"]) for s in sample["sieves"]]
    further = [_limit(one["name"], one, one["min"], one["max"], one["value"]) for one in sample["limits"]]
    return JudgedSample(sample["id"], sample["verdict"], sample["rounded"], tuple(sieves + further),
                        _curve(sample["within"]), _curve(sample["outside"]), tuple(sample["notes"]))


def _limit(name: Union[Fraction, str], told: dict[str, Any], least: str | None, most: str | None,
           value: Any) -> JudgedLimit:
    return JudgedLimit(name, told["verdict"], optional_fraction(least), optional_fraction(most),
                       None if value is None else enclosure_of(value), enclosure_of(told["least"]),
                       enclosure_of(told["most"]))


def _curve(points: list[dict[str, str]] | None) -> dict[Fraction, Fraction] | None:
    return None if points is None else {Fraction(p["size"]): Fraction(p["percent"]) for p in points}


def _shown(name: Union[Fraction, str]) -> str:
    return name if isinstance(name, str) else f"{float(name):g} mm"
