"""Enclosures count and compare as intervals do, against numbers drawn within them."""

import operator
import random
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import pytest


def enclosure(lo, hi):
    return mdm.Enclosure(Decimal(lo), Decimal(hi))


def drawn(numbers):
    lo = Decimal(numbers.randint(-50, 50)) / 8
    return mdm.Enclosure(lo, lo + Decimal(numbers.randint(0, 20)) / 16)


def within(numbers, x):
    return Fraction(x.lo) + Fraction(numbers.randint(0, 8), 8) * (Fraction(x.hi) - Fraction(x.lo))


@pytest.mark.parametrize("operation", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_results_enclose_those_of_all_numbers_within(operation):
    numbers = random.Random(3)
    done = 0
    while done < 300:
        x, y = drawn(numbers), drawn(numbers)
        if operation is operator.truediv and y.lo <= 0 <= y.hi:
            with pytest.raises(ZeroDivisionError, match="may be 0"):
                operation(x, y)
            continue
        result = operation(x, y)
        for _ in range(5):
            a, b = within(numbers, x), within(numbers, y)
            assert operation(a, b) in result
            assert operation(a, b) in operation(x, b)
            assert operation(a, b) in operation(a, y)
        done += 1


def test_bounds_are_met_where_they_are_decimals():
    assert enclosure("0.1", "0.3") + enclosure("0.02", "0.02") == enclosure("0.12", "0.32")
    assert enclosure("-1", "2") * enclosure("3", "4") == enclosure("-4", "8")
    assert 1 - enclosure("0.25", "0.5") == enclosure("0.5", "0.75")
    assert enclosure("1", "1") / 8 == enclosure("0.125", "0.125")


def test_what_is_no_decimal_is_rounded_outwards():
    third = enclosure("1", "1") / 3
    assert third.lo < third.hi and Fraction(1, 3) in third and third.width < Decimal("1e-29")
    assert Fraction(2, 3) in enclosure("0", "0") + Fraction(2, 3)


def test_an_order_is_certain_or_refused():
    x = enclosure("1", "2")
    assert x < 3 and x <= 2 and not x < 1 and x > 0 and x >= 1 and not x > 2
    assert x < enclosure("2.5", "3") and enclosure("2.5", "3") > x
    for open_question in (lambda: x < Fraction(3, 2), lambda: x > enclosure("1.5", "4"), lambda: x <= 1):
        with pytest.raises(ValueError, match="do not tell their order"):
            open_question()
    assert sorted([enclosure("3", "4"), x]) == [x, enclosure("3", "4")]


@pytest.mark.parametrize("other", ["1", None, 0.5])
def test_other_things_are_no_numbers(other):
    for operation in (operator.add, operator.sub, operator.mul, operator.truediv, operator.lt, operator.ge):
        with pytest.raises(TypeError):
            operation(enclosure("1", "2"), other)
        with pytest.raises(TypeError):
            operation(other, enclosure("1", "2"))
