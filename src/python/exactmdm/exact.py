"""Numbers on their way in and out: exact, or refused."""

from __future__ import annotations

import operator
import sys
from collections.abc import Iterable
from decimal import Context, Decimal
from fractions import Fraction
from typing import Any, Union

from exactmdm.errors import InputError

#: What is taken as a number: text as in a file, int, Decimal or Fraction.
Number = Union[str, int, Decimal, Fraction]

#: Some more than 1000 digits, which is what the library reads.
_MOST_BITS = 4000


def text_of(value: object, name: str, exact: bool = False, takes_exact: bool = False) -> str:
    """A number as exact text: a decimal, or `p/q` where it is none.

    A float is refused, as its decimal is not what it holds: with `exact` its binary value itself is taken. `takes_exact`
    says that who calls has such a keyword, for the message.

    >>> text_of(Fraction(1, 8), "size"), text_of(Fraction(1, 3), "size"), text_of("0.1", "size")
    ('0.125', '1/3', '0.1')
    >>> text_of(0.1, "size")
    Traceback (most recent call last):
        ...
    exactmdm.errors.InputError: size: 0.1 is a float: write repr(x) for the decimal that is shown, or Fraction(x) ...
    """
    if isinstance(value, str):
        if valid_text(value) != value:
            raise InputError(f"{name}: {value!r} has half a character in it: give whole ones")
        return value
    if isinstance(value, Decimal):
        if not value.is_finite():
            raise InputError(f"{name}: {value} is no number: give a finite one")
        return str(value)
    if isinstance(value, Fraction):
        return _text_of_fraction(value)
    if isinstance(value, bool):
        raise InputError(f"{name}: {value} is no number: give str, int, Decimal or Fraction")
    try:
        return _text_of_fraction(Fraction(operator.index(value)))  # type: ignore[arg-type]
    except TypeError:
        pass
    ratio = getattr(value, "as_integer_ratio", None)
    if ratio is None:
        raise InputError(f"{name}: {type(value).__name__} is no number: give str, int, Decimal or Fraction")
    if not exact:
        itself = "exact=True" if takes_exact else "Fraction(x)"
        raise InputError(f"{name}: {value} is a float: write repr(x) for the decimal that is shown, or {itself} for the "
                         "binary number itself")
    try:
        return _text_of_fraction(Fraction(*ratio()))
    except (ValueError, OverflowError):
        raise InputError(f"{name}: {value} is no number: give a finite one") from None


def valid_text(text: str) -> str:
    """A text with ? for what UTF-8 cannot have, such as the odd bytes of a file name."""
    return text.encode("utf-8", "replace").decode()


def entries_of(values: Iterable[object], name: str) -> list[object]:
    """The values as a list, which a text is not."""
    if isinstance(values, str):
        raise InputError(f"{name}: a text is no list of numbers: give a list")
    try:
        return list(values)
    except (TypeError, NotImplementedError):  # the second is of views with several dimensions
        raise InputError(f"{name}: {type(values).__name__} is no list of numbers: give a list") from None


def texts_of(values: Iterable[object], name: str, exact: bool = False) -> list[str]:
    """All of some numbers, which are named by their place in errors."""
    return [text_of(value, f"{name}[{i}]", exact, True) for i, value in enumerate(entries_of(values, name))]


def _text_of_fraction(value: Fraction) -> str:
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > _MOST_BITS:
        raise InputError("a number has too many digits: at most 1000 are read")
    if value.denominator == 1:
        return str(value.numerator)
    places = _decimal_places(value.denominator)
    if places is None:
        return f"{value.numerator}/{value.denominator}"
    digits = str(abs(value.numerator) * 10**places // value.denominator).rjust(places + 1, "0")
    return f"{'-' if value < 0 else ''}{digits[:-places]}.{digits[-places:]}"


def _decimal_places(denominator: int) -> int | None:
    """Digits after the point of 1/denominator, or None if it is no decimal."""
    places = {2: 0, 5: 0}
    for prime in places:
        while denominator % prime == 0:
            denominator //= prime
            places[prime] += 1
    most = max(places.values())
    return most if denominator == 1 else None


def fraction_of(text: str) -> Fraction:
    """The value of a decimal or of `p/q` that the library wrote."""
    return Fraction(text)


def optional_int(text: str | None) -> int | None:
    """The value of a whole number, or None."""
    return None if text is None else int(text)


def optional_fraction(text: str | None) -> Fraction | None:
    """The value of an exact number, or None."""
    return None if text is None else Fraction(text)


def middle(value: Any) -> Fraction:
    """A number as a fraction, an Enclosure by its middle."""
    return Fraction(getattr(value, "mid", value))


def fits_float(value: Any) -> bool:
    """True if a float has the number to the digits that floats have: it is neither too large nor too near to 0.

    >>> fits_float(Fraction(1, 3)), fits_float(Decimal("1e400")), fits_float(Decimal("1e-400"))
    (True, False, False)
    """
    try:
        number = float(value)
    except OverflowError:
        return False
    return middle(value) == 0 or sys.float_info.min <= abs(number) <= sys.float_info.max


def column(values: Iterable[Any]) -> list[Any]:
    """Numbers for a table, None for none: floats, or the exact numbers themselves where floats cannot have all of them."""
    entries = list(values)
    if all(value is None or fits_float(value) for value in entries):
        return [float("nan") if value is None else float(value) for value in entries]
    return entries


def decimal_of(value: Any, digits: int) -> Decimal:
    """A number, rounded to so many significant digits."""
    exact = middle(value)
    return Context(prec=digits).divide(Decimal(exact.numerator), Decimal(exact.denominator))


def shown(value: Any, digits: int = 4) -> str:
    """A number for people, in at most some ten characters.

    >>> shown(Fraction(1, 3)), shown(Decimal("1e400")), shown(Decimal("1e-400"))
    ('0.3333', '1e+400', '1e-400')
    """
    number = float(value) if fits_float(value) else decimal_of(value, digits).normalize()
    return f"{number:.{digits}g}"
