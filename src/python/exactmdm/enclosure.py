"""Numbers that are known to lie between two decimals."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Context, Decimal
from fractions import Fraction
from typing import Any, Union


@dataclass(frozen=True)
class Enclosure:
    """A real number with lo <= x <= hi; lo = hi where it is that decimal.

    >>> size = Enclosure(Decimal("0.1"), Decimal("0.3"))
    >>> size.mid, float(size), Fraction(1, 4) in size, size.is_exact
    (Decimal('0.2'), 0.2, True, False)
    """

    lo: Decimal
    hi: Decimal

    def __post_init__(self) -> None:
        if not isinstance(self.lo, Decimal) or not isinstance(self.hi, Decimal):
            raise TypeError("an enclosure is of two Decimals")
        if not self.lo <= self.hi:
            raise ValueError(f"an enclosure from {self.lo} to {self.hi} is empty: give lo <= hi")

    @property
    def is_exact(self) -> bool:
        """True if the number is known to be a decimal, lo."""
        return self.lo == self.hi

    @property
    def mid(self) -> Decimal:
        """The middle, exactly."""
        context = _context_for(self.lo, self.hi)
        return context.divide(context.add(self.lo, self.hi), Decimal(2))

    @property
    def width(self) -> Decimal:
        """hi - lo, exactly."""
        return _context_for(self.lo, self.hi).subtract(self.hi, self.lo)

    def __float__(self) -> float:
        return float(self.mid)

    def __contains__(self, value: Decimal | Fraction | int) -> bool:
        return Fraction(self.lo) <= value <= Fraction(self.hi)

    def __str__(self) -> str:
        return f"{self.lo:f}" if self.is_exact else f"[{self.lo:f}, {self.hi:f}]"

    def __repr__(self) -> str:
        return f"Enclosure({self.lo!r}, {self.hi!r})"


def _context_for(*numbers: Decimal) -> Context:
    """A context in which sums and halves of the numbers are not rounded."""
    highest = max(number.adjusted() for number in numbers)
    lowest = min(int(number.as_tuple().exponent) for number in numbers)
    return Context(prec=max(highest - lowest, 1) + 4)


def enclosure_of(bounds: list[str]) -> Enclosure:
    """Of the two decimals that the library wrote."""
    lo, hi = bounds
    return Enclosure(Decimal(lo), Decimal(hi))


def optional_enclosure(bounds: list[str] | None) -> Enclosure | None:
    """The same, or None."""
    return None if bounds is None else enclosure_of(bounds)


def exact_or_enclosed(value: Any) -> Union[Fraction, Enclosure]:
    """A fraction, or two decimals around what is none."""
    return enclosure_of(value) if isinstance(value, list) else Fraction(value)
