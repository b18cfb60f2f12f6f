"""The independent checker of proofs."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Union

from exactmdm import _core
from exactmdm.exact import valid_text
from exactmdm.gradation import Gradation
from exactmdm.options import read_file


@dataclass(frozen=True)
class Verdict:
    """The verdict on a certificate. It is true if the certificate is accepted."""

    status: str  #: "accepted", "refused" or "malformed"
    proved: str  #: what was proved, with the whole question; empty if a text is malformed
    reason: str  #: why it is not accepted; empty if it is

    def __bool__(self) -> bool:
        return self.status == "accepted"

    def __repr__(self) -> str:
        return f"<Verdict: {self.status}{': ' + self.reason[:60] if self.reason else ''}>"


def check(gradation: Union[Gradation, os.PathLike[str], tuple[str, str]],
          certificate: Union[str, os.PathLike[str]]) -> Verdict:
    """Judges a certificate as `mdm-check` does, by code that shares nothing with the solver.

    Args:
        gradation: a Gradation; or a path of a file in canonical CSV or JSON, or (name, text) of one.
        certificate: its text, or a path of its file.

    Raises:
        InputError: a file cannot be read, or the gradation has no canonical CSV.
    """
    name, text = _gradation_text(gradation)
    if isinstance(certificate, str):
        proof, proof_name = certificate, "certificate"
    else:
        proof, proof_name = read_file(certificate).decode("utf-8", "replace"), os.fspath(certificate)
    return Verdict(*_core.check(valid_text(text), valid_text(name), False, valid_text(proof), valid_text(proof_name)))


def _gradation_text(gradation: Union[Gradation, os.PathLike[str], tuple[str, str]]) -> tuple[str, str]:
    if isinstance(gradation, tuple):
        return gradation
    if isinstance(gradation, Gradation):
        return gradation._source or (gradation.id or "gradation", gradation.csv())
    return os.fspath(gradation), read_file(gradation).decode("utf-8", "replace")
