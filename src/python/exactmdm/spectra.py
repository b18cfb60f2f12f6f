"""All numbers of particles that have an exact match."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Union

from exactmdm.gradation import Gradation
from exactmdm.solving import raise_ended, solve


@dataclass(frozen=True)
class Spectrum:
    """The numbers of particles with which a gradation can be matched: `n in spectrum`."""

    intervals: tuple[tuple[int, int], ...]  #: closed, ascending, with gaps between them
    all_from: int  #: every number from here on; where it is not complete, nothing is known from here on
    complete: bool

    def __contains__(self, particles: int) -> bool:
        return (self.complete and particles >= self.all_from) or any(lo <= particles <= hi for lo, hi in self.intervals)

    def __repr__(self) -> str:
        shown = ", ".join(f"{lo}" if lo == hi else f"{lo}-{hi}" for lo, hi in self.intervals[:5])
        more = ", ..." if len(self.intervals) > 5 else ""
        rest = f"{'all' if self.complete else 'unknown'} from {self.all_from}"
        return f"<Spectrum: {shown}{more}{'; ' if shown else ''}{rest}>"


def spectrum(gradation: Union[Gradation, str, "os.PathLike[str]"], *, max_steps: int | None = None,
             time_limit: Union[int, float, None] = None, **options: Any) -> Spectrum:
    """All numbers of particles that have an exact match, as `mdm solve --spectrum`.

    Args:
        max_steps, time_limit: of the smallest match, and again of the spectrum.
        options: others of `solve`, without a tolerance and a band.

    Raises:
        LimitReached: `known` is the Spectrum up to the limit.
        Interrupted: the same, at Ctrl-C.

    Source: proofs/README.md, Theorem 8.

    >>> sand = exactmdm.Gradation(["10", "11", "12", "13"], [1, 1, 1, 0])
    >>> exactmdm.spectrum(sand)
    <Spectrum: 9, 12-13; all from 15>
    >>> 10 in exactmdm.spectrum(sand), 12 in exactmdm.spectrum(sand)
    (False, True)
    """
    match = solve(gradation, max_steps=max_steps, time_limit=time_limit, **options)
    limits = {name: value for name, value in match._words.values.items() if name in ("max_steps", "time_limit")}
    intervals, all_from, complete, error = match._handle.spectrum(limits, None)
    found = Spectrum(tuple(intervals), all_from, complete)
    raise_ended(found, error, not complete)
    return found
