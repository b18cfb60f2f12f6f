"""Sieve analyses and the smallest sets of particles that match them: exactly, with proofs.

    import exactmdm as mdm
    sand = mdm.read("sand.csv")                       # or mdm.Gradation(sizes=[...], masses=[...], unit="mm")
    match = mdm.solve(sand, tolerance="retained:1%", time_limit=10)
    match.particles, match.quantities, match.sizes    # int, tuple of int, tuple of Enclosure
    match.check()                                     # the verdict of the independent checker

Numbers go in exactly, as str, int, Decimal or Fraction; floats are refused, but in samples and where exact=True says
that their binary value is meant. Out come int, Fraction, and Enclosure for what is irrational. All objects are
immutable and can be pickled; functions may be called from several threads.
"""

from exactmdm._core import versions
from exactmdm.batches import batch
from exactmdm.blending import Blend, BlendCondition, Blends, blend
from exactmdm.checking import Verdict, check
from exactmdm.description import Description, SoilFraction, describe
from exactmdm.enclosure import Enclosure
from exactmdm.errors import InputError, Interrupted, LimitReached
from exactmdm.gradation import Gradation
from exactmdm.judging import Crosscheck, JudgedAnswer, crosscheck
from exactmdm.match import Budget, Match, MatchClass, MatchScale, Spread
from exactmdm.plotting import plot
from exactmdm.program import GeneratedSet, Written, export, generate, pack, picture
from exactmdm.reading import read, read_all, read_sample
from exactmdm.regrading import Regraded, regrade
from exactmdm.solving import budget, solve
from exactmdm.specifications import JudgedLimit, JudgedSample, Judgement, judge
from exactmdm.spectra import Spectrum, spectrum
from exactmdm.suites import suite
from exactmdm.trade import Tradeoff, TradeoffRow, tradeoff
from exactmdm.verifying import Verification, VerifiedClass, verify

__version__: str = versions()["mdm"]

__all__ = [
    "Blend", "BlendCondition", "Blends", "Budget", "Crosscheck", "Description", "Enclosure", "GeneratedSet",
    "Gradation", "InputError", "Interrupted", "JudgedAnswer", "JudgedLimit", "JudgedSample", "Judgement",
    "LimitReached", "Match", "MatchClass", "MatchScale", "Regraded", "SoilFraction", "Spectrum", "Spread", "Tradeoff",
    "TradeoffRow", "Verdict", "Verification", "VerifiedClass", "Written", "batch", "blend", "budget", "check",
    "crosscheck", "describe", "export", "generate", "judge", "pack", "picture", "plot", "read", "read_all",
    "read_sample", "regrade", "solve", "spectrum", "suite", "tradeoff", "verify", "versions",
]
