"""The best mix of stockpiles within a specification, or why there is none."""

from __future__ import annotations

import json
import os
import pathlib
import re
import tempfile
from collections.abc import Iterable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Union

from exactmdm.errors import LimitReached
from exactmdm.exact import Number, optional_fraction, shown, text_of
from exactmdm.figures import html_table
from exactmdm.gradation import Gradation
from exactmdm.options import given_of
from exactmdm.program import Source, called, file_of, flags_of
from exactmdm.reading import Path, read

#: Targets that are computed.
_COMPUTED = re.compile("(power45|fuller|andreasen|bolomey):")


@dataclass(frozen=True)
class Blend:
    """Shares of the mass, and what they give."""

    shares: dict[str, Fraction]  #: of each stockpile by its name, 0 to 1
    passing: dict[Fraction, Fraction]  #: percent that passes each sieve (mm)
    value: Fraction  #: of what is minimised; 0 without an aim
    broken: tuple[str, ...]  #: the limits that it does not keep, in words
    moduli: dict[str, Fraction]  #: the fineness moduli that are limited, by their names
    coarseness: Fraction | None  #: the coarseness factor, where it is limited and something stays on 2.36 mm


@dataclass(frozen=True)
class BlendCondition:
    """A limit with its multiplier: a price, or its part in a contradiction."""

    of: str  #: "passing", "modulus", "coarseness", "target", "share" or "sum"
    #: the sieve (mm), the modulus, the stockpile, the limit c of the coarseness factor, or None of the sum of all shares
    name: Union[Fraction, str, None]
    side: str  #: "least", "most" or "equal"
    #: of a modulus the mean percent that passes its sieves; of a factor what passes 9.5 mm less c / 100 of 2.36 mm
    value: Fraction
    multiplier: Fraction


@dataclass(frozen=True)
class Blends:
    """The best blends, or why there is none. It is true if there is one."""

    status: str  #: "optimal", "feasible" (a limit came first), "none" or "unknown"
    aim: str  #: "none", "cost", "deviation", "max-deviation" or "squares"
    steps: int  #: shares are whole numbers of so many parts
    best: tuple[Blend, ...]  #: the best one first
    complete: bool  #: there are no blends besides
    bound: Fraction | None  #: no blend in steps has a lower value
    real: Blend | None  #: the best with any real shares
    prices: tuple[BlendCondition, ...]  #: how much the value changes a unit of a limit, near the real optimum
    rounded: Blend | None  #: the real optimum rounded to steps, and what that breaks
    contradiction: tuple[BlendCondition, ...]  #: the limits that no real shares keep together, as few as can be
    widened: Blend | None  #: where there is none: the shares in steps for which limits are widened least
    blended: Gradation | None  #: the gradation of the best blend
    notes: tuple[str, ...]
    _json: str

    def __bool__(self) -> bool:
        return bool(self.best)

    def json(self) -> str:
        """In the schema mdm-blend-1, without an end of line."""
        return self._json

    def __repr__(self) -> str:
        if not self.best:
            return f"<Blends: {self.status}>"
        shares = ", ".join(f"{name} {shown(100 * share)} %" for name, share in self.best[0].shares.items() if share)
        return f"<Blends: {self.status}, {shares}>"

    def _repr_html_(self) -> str:
        if not self.best:
            return html_table(["status", "limits that contradict each other"],
                              [[self.status, f"{c.of} {shown(c.name)}: {c.side} {shown(c.value)}"]
                               for c in self.contradiction])
        return html_table(["stockpile", "share, %"],
                          [[name, shown(100 * share)] for name, share in self.best[0].shares.items()])


def blend(stockpiles: Iterable[Source], specification: Path, *, target: Source | None = None,
          # Options of blend, by src/ask/write_modules.
          minimise: str | None = None, cost: Iterable[str] | None = None, step: str | None = None,
          share: Iterable[str] | None = None, limit: Iterable[str] | None = None,
          at_most_stockpiles: Number | None = None, all: Number | None = None, relax: Number | None = None,
          bailey: str | None = None, node_limit: Number | None = None, time_limit: Union[Number, float, None] = None,
          specimen_id: str | None = None, columns: str | None = None, kind: str | None = None, unit: str | None = None,
          skip: Number | None = None, sheet: str | None = None, loss: Number | None = None, round: Number | None = None,
          # End of the options.
          proof: Path | None = None) -> Blends:
    """The best mix of stockpiles within the limits of a specification, exactly. Runs `mdm blend`.

    Args:
        stockpiles: gradations, or files of them; the id of a gradation is the stockpile's name.
        specification: a file of limits: CSV with passing_min_percent and passing_max_percent, or another envelope.
        target: the curve that is wished for: a gradation, or one that is computed: "power45:19mm", "fuller:31.5mm",
            "andreasen:16mm,q=0.25,dmin=0.063mm" or "bolomey:31.5mm,a=10".
        cost: of a unit of mass of each stockpile: {"A": "12.5", "B": 9}, or texts as "A=12.5".
        share: limits of shares: {"A": "10..40%"}, or texts as "A=10..40%".
        proof: the file of a proof, for `mdm-check` with the files of the specification and of the stockpiles.
        minimise: what a blend is to have least of: cost, deviation (the sum of the distances from the target),
            max-deviation (the largest of them), squares (the sum of their squares) or none; without it cost where there is
            cost, deviation where there is target.
        step: shares are whole numbers of steps: 1% (without this option), 0.5%, or masses as '5kg of 1000kg'.
        at_most_stockpiles: so many stockpiles at most have a share.
        all: the N best blends.
        relax: where there is no blend, by how much the limits of the sieve SIZE alone must be widened; without it all
            limits by the same.
        node_limit: stop after so many splits of the search, 1000000 without it.
        time_limit: stop after so many seconds.
        specimen_id: the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them.
        columns: the columns of sizes and masses: names, or numbers from 1 on.
        kind: what the values are: passing, retained, cumulative, or a name as in canonical CSV.
        unit: what the sizes are: mm, um, m, in, phi or sieve.
        skip: leave out the first N lines or rows.
        sheet: the sheet of a workbook (the first).
        loss: what the rows of a sheet may lack of its initial mass (1%).
        round: take all masses, or the values of a column that passes or is cumulative, to D significant digits before
            anything else.
        limit: limits of the blend's fineness modulus, FM=2.3..3.1 of ASTM C125 or FM-EN=2.4..3.0 of EN 12620, or of its
            coarseness factor, CF=45..75: of what stays on 2.36 mm the percent that stays on 9.5 mm; either end may be left
            out.
        bailey: report the ratios of the Bailey method, CA, FAc and FAf, for this nominal maximum particle size: 37.5mm,
            25mm, 19mm, 12.5mm, 9.5mm or 4.75mm.

    Raises:
        InputError: an option or a file is wrong.
        LimitReached: a limit came before the end of the search; `known` are the Blends with what is certain.

    >>> sand = exactmdm.Gradation(["0.1", "1", "10"], [80, 20, 0], id="sand")
    >>> gravel = exactmdm.Gradation(["0.1", "1", "10"], [10, 90, 0], id="gravel")
    >>> limits = pathlib.Path(tempfile.mkdtemp(), "limits.csv")
    >>> _ = limits.write_text("size_mm,passing_min_percent,passing_max_percent\\n1,30,40\\n10,100,100\\n")
    >>> exactmdm.blend([sand, gravel], limits, cost={"sand": 5, "gravel": 9})
    <Blends: optimal, sand 42 %, gravel 58 %>
    """
    options = given_of("blend", locals())
    for name in ("cost", "share"):
        if isinstance(options[name], Mapping):
            options[name] = [f"{stockpile}={text_of(value, name)}" for stockpile, value in options[name].items()]
    with ExitStack() as stack:
        files = [stack.enter_context(file_of(source)) for source in stockpiles]
        words = [*flags_of(options, "blend"), "--format=json", "--quiet", "--spec", os.fspath(specification)]
        if isinstance(target, str) and _COMPUTED.match(target):
            words += ["--target", target]
        elif target is not None:
            words += ["--target", stack.enter_context(file_of(target))]
        if proof is not None:
            words += ["--proof", os.fspath(proof)]
        blended = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()), "blend.json")
        try:
            _, text = called("blend", *files, *words, "--blended", str(blended))
        except LimitReached as limit:
            raise LimitReached(str(limit), _read(limit.known, _gradation_in(blended))) from None
        found = _read(text, _gradation_in(blended))
    return found


def _gradation_in(path: pathlib.Path) -> Gradation | None:
    return read(path) if path.exists() else None


def _read(report: str, blended: Gradation | None) -> Blends:
    tree = json.loads(report)
    names = [stockpile["name"] for stockpile in tree["stockpiles"]]
    sieves = [Fraction(sieve["size"]) for sieve in tree["sieves"]]
    moduli = [modulus["name"] for modulus in tree["moduli"]]

    def one(found: dict[str, Any] | None) -> Blend | None:
        return None if found is None else Blend(
            dict(zip(names, map(Fraction, found["shares"]))), dict(zip(sieves, map(Fraction, found["passing"]))),
            Fraction(found["value"]), tuple(found["broken"]), dict(zip(moduli, map(Fraction, found["moduli"]))),
            optional_fraction(found.get("coarseness")))

    def conditions(found: list[dict[str, Any]]) -> tuple[BlendCondition, ...]:
        return tuple(BlendCondition(c["of"], Fraction(c["name"]) if c["of"] in ("passing", "target", "coarseness") else c["name"],
                                    c["side"], Fraction(c["value"]), Fraction(c["multiplier"])) for c in found)

    return Blends(tree["status"], tree["aim"], int(tree["steps"]),
                  tuple(found for found in map(one, tree["blends"]) if found), tree["all"],
                  optional_fraction(tree["bound"]), one(tree["real"]), conditions(tree["prices"]), one(tree["rounded"]),
                  conditions((tree["contradiction"] or {"limits": []})["limits"]), one(tree["widened"]), blended,
                  tuple(tree["notes"]), report.rstrip("\n"))
