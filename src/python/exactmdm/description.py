"""What soil mechanics says of a gradation."""

from __future__ import annotations

import json
import operator
import os
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, Union

from exactmdm import _core
from exactmdm.enclosure import Enclosure, enclosure_of, optional_enclosure
from exactmdm.errors import InputError
from exactmdm.exact import Number, shown
from exactmdm.figures import html_table
from exactmdm.gradation import Gradation
from exactmdm.options import given_of, words_of
from exactmdm.reading import gradation_of


@dataclass(frozen=True)
class SoilFraction:
    """A named part of a soil: its sizes are above < x <= up_to, in mm."""

    name: str
    above: Decimal
    up_to: Decimal | None  #: None: all larger ones
    percent: Enclosure | None  #: of the mass


@dataclass(frozen=True)
class Description:
    """Index numbers and fractions of a soil, sizes in mm. What is not available is None; the notes say why."""

    id: str
    d10: Enclosure | None
    d30: Enclosure | None
    d50: Enclosure | None
    d60: Enclosure | None
    c_u: Enclosure | None  #: D60 / D10
    c_c: Enclosure | None  #: D30^2 / (D10 D60)
    span: Enclosure | None  #: (D90 - D10) / D50
    d32: Enclosure | None  #: D[3,2], whatever the sizes within the classes
    d43: Enclosure | None  #: D[4,3], in the same way
    fineness_modulus: Enclosure | None  #: of ASTM C125
    fineness_modulus_en: Enclosure | None  #: of EN 12620
    k_hazen: Enclosure | None  #: hydraulic conductivity, m/s
    k_kozeny_carman: Enclosure | None  #: the same, of a void ratio, whatever the sizes within the classes
    diameters: dict[Decimal, Enclosure | None]  #: those asked for, by their percents
    i_gs: Enclosure | None  #: grain size index of Erguler (2016)
    i_c: Enclosure | None  #: Arnold's index of curvature
    phi_1: Enclosure | None  #: Arnold, Eq. 15
    zeta_1: Enclosure | None  #: Arnold, Eq. 16
    group: str | None  #: symbol of ASTM D2487, such as "SP"
    group_name: str | None
    aashto: str | None  #: group of AASHTO M 145, such as "A-2-6"
    aashto_index: int | None  #: its group index; None where it needs limits of the fines that are not known
    iso_name: str | None  #: symbol after ISO 14688-2:2004, such as "saGr"
    uscs: tuple[SoilFraction, ...]
    iso_14688: tuple[SoilFraction, ...]
    notes: tuple[str, ...]
    _json: str

    def json(self) -> str:
        """In the schema mdm-describe-1, without an end of line."""
        return self._json

    def __repr__(self) -> str:
        return f"<Description {self.id[:40]!r}: {self.group or 'no group'}, D50 {_shown(self.d50)} mm>"

    def _repr_html_(self) -> str:
        rows = [[label, _shown(value)] for label, value in (
            ("D10, mm", self.d10), ("D30, mm", self.d30), ("D50, mm", self.d50), ("D60, mm", self.d60),
            ("Cu", self.c_u), ("Cc", self.c_c), ("span", self.span), ("IGS", self.i_gs), ("IC", self.i_c), ("phi 1", self.phi_1),
            ("zeta 1", self.zeta_1))]
        rows.append(["group", f"{self.group or ''} {self.group_name or ''}"])
        rows.append(["AASHTO", self.aashto or ""])
        rows.append(["ISO 14688-2", self.iso_name or ""])
        return html_table(["index", "value"], rows)


def describe(gradation: Union[Gradation, str, "os.PathLike[str]"], *,
             # Options of describe, by src/ask/write_modules.
             d: str | None = None, void_ratio: Number | None = None, liquid_limit: Number | None = None,
             plastic_limit: Number | None = None, pan_size: Number | None = None, extrapolate: bool = False,
             # End of the options.
             digits: int = 15) -> Description:
    """Index numbers, fractions and the soil groups of a gradation, as `mdm describe`.

    Args:
        d: more diameters, as `"5,16,84,95"`: the sizes that so many percent of the mass pass.
        liquid_limit, plastic_limit: of the fines, percent; without them they are low-plasticity silt.
        pan_size: takes the pan as a sieve of this size.
        extrapolate: continues the line through the two finest sieves into a pan at size 0.
        digits: significant digits.
        void_ratio: also the hydraulic conductivity after Kozeny and Carman at this void ratio.

    Source: ASTM D2487, AASHTO M 145, ISO 14688, ISO 9276-2, ASTM C125, EN 12620, Erguler (2016), Arnold Eq. 15 and 16.

    >>> exactmdm.describe(exactmdm.Gradation(["0.1", "0.2", "0.4"], [1, 1, 0])).d50
    Enclosure(Decimal('0.2'), Decimal('0.2'))
    """
    words = words_of(given_of("describe", locals()), "describe")
    if not 1 <= operator.index(digits) <= 1000:
        raise InputError(f"digits: {digits} is not from 1 to 1000")
    return _read(_core.describe(gradation_of(gradation)._handle, words.values, digits))


def _read(report: str) -> Description:
    tree: dict[str, Any] = json.loads(report)

    def index(name: str) -> Enclosure | None:
        return optional_enclosure(tree[name])

    group, aashto = tree["uscs"] or {}, tree["aashto"] or {}
    return Description(
        id=tree["id"], d10=index("D10"), d30=index("D30"), d50=index("D50"), d60=index("D60"), c_u=index("Cu"),
        c_c=index("Cc"), span=index("span"), d32=index("D32"), d43=index("D43"), fineness_modulus=index("FM"),
        fineness_modulus_en=index("FM_EN"), k_hazen=index("kHazen"),
        k_kozeny_carman=optional_enclosure(tree.get("kKozenyCarman")),
        diameters={Decimal(at["percent"]): optional_enclosure(at["size"]) for at in tree["diameters"]},
        i_gs=index("IGS"), i_c=index("IC"), phi_1=index("phi1"), zeta_1=index("zeta1"),
        group=group.get("symbol"), group_name=group.get("name"), aashto=aashto.get("symbol"),
        aashto_index=None if aashto.get("index") is None else int(aashto["index"]),
        iso_name=(tree["iso_14688"] or {}).get("symbol"), uscs=_fractions(tree["uscs_fractions"]),
        iso_14688=_fractions(tree["iso_14688_fractions"]), notes=tuple(tree["notes"]), _json=report)


def _fractions(entries: list[dict[str, Any]]) -> tuple[SoilFraction, ...]:
    return tuple(SoilFraction(entry["name"], Decimal(entry["above"]),
                          None if entry["up_to"] is None else Decimal(entry["up_to"]),
                          None if entry["percent"] is None else enclosure_of(entry["percent"]))
                 for entry in entries)


def _shown(value: Enclosure | None) -> str:
    return "" if value is None else shown(value)
