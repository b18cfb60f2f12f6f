"""Numbers that are known to lie between two decimals."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal, Inexact
from fractions import Fraction
from typing import Any, Union


#: What an enclosure is added to and compared with.
Exact = Union[int, Decimal, Fraction]


@dataclass(frozen=True)
class Enclosure:
    """A real number with lo <= x <= hi; lo = hi where it is that decimal.

    It compares and counts as an interval does: sums, differences, products and quotients enclose those of all numbers
    within, and an order that the bounds do not tell is a ValueError. `==` compares the bounds.

    >>> size = Enclosure(Decimal("0.1"), Decimal("0.3"))
    >>> size.mid, float(size), Fraction(1, 4) in size, size.is_exact
    (Decimal('0.2'), 0.2, True, False)
    >>> size + 1, 2 * size, size < 1
    (Enclosure(Decimal('1.1'), Decimal('1.3')), Enclosure(Decimal('0.2'), Decimal('0.6')), True)
    >>> 1 / Enclosure(Decimal("3"), Decimal("3"))
    Enclosure(Decimal('0.333333333333333333333333333333'), Decimal('0.333333333333333333333333333334'))
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

    def __add__(self, other: Union[Enclosure, Exact]) -> Enclosure:
        return self._with(other, lambda a, b: a + b)

    def __radd__(self, other: Exact) -> Enclosure:
        return self + other

    def __neg__(self) -> Enclosure:
        return Enclosure(self.hi.copy_negate(), self.lo.copy_negate())

    def __sub__(self, other: Union[Enclosure, Exact]) -> Enclosure:
        return self._with(other, lambda a, b: a - b)

    def __rsub__(self, other: Exact) -> Enclosure:
        return -self + other

    def __mul__(self, other: Union[Enclosure, Exact]) -> Enclosure:
        return self._with(other, lambda a, b: a * b)

    def __rmul__(self, other: Exact) -> Enclosure:
        return self * other

    def __truediv__(self, other: Union[Enclosure, Exact]) -> Enclosure:
        divisor = _bounds(other)
        if divisor is not None and divisor[0] <= 0 <= divisor[1]:
            raise ZeroDivisionError(f"{other} may be 0")
        return self._with(other, lambda a, b: a / b)

    def __rtruediv__(self, other: Exact) -> Enclosure:
        if self.lo <= 0 <= self.hi:
            raise ZeroDivisionError(f"{self} may be 0")
        return self._with(other, lambda a, b: b / a)

    def __lt__(self, other: Union[Enclosure, Exact]) -> bool:
        return self._is_below(other, lambda a, b: a < b)

    def __le__(self, other: Union[Enclosure, Exact]) -> bool:
        return self._is_below(other, lambda a, b: a <= b)

    def __gt__(self, other: Union[Enclosure, Exact]) -> bool:
        if _bounds(other) is None:
            return NotImplemented
        return not self._is_below(other, lambda a, b: a <= b)

    def __ge__(self, other: Union[Enclosure, Exact]) -> bool:
        if _bounds(other) is None:
            return NotImplemented
        return not self._is_below(other, lambda a, b: a < b)

    def _with(self, other: Any, operation: Callable[[Fraction, Fraction], Fraction]) -> Enclosure:
        """An enclosure of what the operation, monotone in each number, makes of all numbers within both."""
        bounds = _bounds(other)
        if bounds is None:
            return NotImplemented
        return _enclosing([operation(a, b) for a in (Fraction(self.lo), Fraction(self.hi)) for b in bounds])

    def _is_below(self, other: Any, holds: Callable[[Fraction, Fraction], bool]) -> bool:
        bounds = _bounds(other)
        if bounds is None:
            return NotImplemented
        always, ever = holds(Fraction(self.hi), bounds[0]), holds(Fraction(self.lo), bounds[1])
        if always != ever:
            raise ValueError(f"{self} and {other}: the bounds do not tell their order; compare `mid`, lo or hi")
        return always

    def __str__(self) -> str:
        return f"{self.lo:f}" if self.is_exact else f"[{self.lo:f}, {self.hi:f}]"

    def __repr__(self) -> str:
        return f"Enclosure({self.lo!r}, {self.hi!r})"


def _context_for(*numbers: Decimal) -> Context:
    """A context in which sums and halves of the numbers are not rounded."""
    highest = max(number.adjusted() for number in numbers)
    lowest = min(int(number.as_tuple().exponent) for number in numbers)
    return Context(prec=max(highest - lowest, 1) + 4)


#: Digits of bounds that are no decimals of few digits.
_DIGITS = 30


def _bounds(value: Any) -> tuple[Fraction, Fraction] | None:
    """The bounds of an enclosure or of an exact number, or None for anything else."""
    if isinstance(value, Enclosure):
        return Fraction(value.lo), Fraction(value.hi)
    if isinstance(value, (int, Decimal, Fraction)):
        return Fraction(value), Fraction(value)
    return None


def _enclosing(numbers: list[Fraction]) -> Enclosure:
    """Decimals below and above all of them."""
    return Enclosure(_decimal(min(numbers), ROUND_FLOOR), _decimal(max(numbers), ROUND_CEILING))


def _decimal(number: Fraction, rounding: str) -> Decimal:
    """The number where it is a decimal, else rounded to 30 digits."""
    numerator, denominator = Decimal(number.numerator), Decimal(number.denominator)
    exact = Context(prec=len(str(number.numerator)) + 4 * len(str(number.denominator)) + 1, traps=[])
    quotient = exact.divide(numerator, denominator)
    if not exact.flags[Inexact]:
        return quotient
    return Context(prec=_DIGITS, rounding=rounding).divide(numerator, denominator)


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
