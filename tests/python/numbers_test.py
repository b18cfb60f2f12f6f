"""Numbers go in and come out exactly."""

import pickle
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import pytest
from hypothesis import given
from hypothesis import strategies as st


@pytest.mark.parametrize("mass", ["0.1", Decimal("0.1"), Fraction(1, 10)])
def test_text_decimal_and_fraction_are_the_same_number(mass):
    assert mdm.Gradation(["1", "2"], [mass, 0]).masses == (Fraction(1, 10), Fraction(0))


def test_a_float_is_refused_with_the_remedies():
    with pytest.raises(mdm.InputError, match=r"masses\[0\]: 0.1 is a float: write repr.* or exact=True"):
        mdm.Gradation(["1", "2"], [0.1, 0])


def test_a_float_in_an_option_is_refused_with_remedies_that_there_are():
    gradation = mdm.Gradation(["1", "2", "3"], [2, 1, 0])
    with pytest.raises(mdm.InputError, match=r"tolerance: 0.1 is a float: write repr.* or Fraction\(x\)"):
        mdm.solve(gradation, tolerance=0.1)
    assert mdm.solve(gradation, tolerance=Fraction(0.1)).particles == mdm.solve(gradation, tolerance="0.1").particles


def test_numbers_of_options_are_those_of_the_command_line():
    gradation = mdm.Gradation(["1", "2", "3"], [2, 1, 0])
    for number in (10000, "10000", "1e4", "10_000", Decimal("1E4")):
        assert mdm.solve(gradation, at_least=number).particles == mdm.solve(gradation, at_least=10000).particles
    for number in ("1_", "1__0", "1.5", "ten"):
        with pytest.raises(mdm.InputError, match="at_least: .* is not a whole number"):
            mdm.solve(gradation, at_least=number)


def test_views_with_two_dimensions_are_no_lists():
    view = memoryview(bytes(4 * 8)).cast("d", (2, 2))
    with pytest.raises(mdm.InputError, match="sizes: memoryview is no list of numbers"):
        mdm.Gradation(view, [1, 0], exact=True)


def test_factors_and_tolerances_that_are_no_decimals_are_refused():
    for name in ("factors", "tolerances"):
        with pytest.raises(mdm.InputError, match=f"{name}.*1/3 is no decimal"):
            mdm.Gradation(["1", "2"], [1, 0], **{name: [Fraction(1, 3), 1]})


def test_exact_takes_the_double_itself():
    assert mdm.Gradation(["1", "2"], [0.1, 0], exact=True).masses[0] == Fraction(0.1) != Fraction(1, 10)


def test_an_array_is_taken_only_where_exact_is_said():
    numpy = pytest.importorskip("numpy")
    with pytest.raises(mdm.InputError, match="float"):
        mdm.Gradation(numpy.array([1.0, 2.0]), [1, 0])
    assert mdm.Gradation(numpy.array([1.0, 2.0]), numpy.array([1, 0]), exact=True).sizes == (1, 2)


@pytest.mark.parametrize("mass", [True, None, 1j, "1e", "", "1,5", "nan", Decimal("nan"), Decimal("-inf"), b"1", [1]])
def test_what_is_no_number_is_refused(mass):
    with pytest.raises(mdm.InputError, match=r"masses\[0\]: "):
        mdm.Gradation(["1", "2"], [mass, 0])


@pytest.mark.parametrize("mass", [float("nan"), float("inf")])
def test_doubles_that_are_no_numbers_are_refused(mass):
    with pytest.raises(mdm.InputError, match="no number"):
        mdm.Gradation(["1", "2"], [mass, 0], exact=True)


@pytest.mark.parametrize("mass", [10**5000, Fraction(1, 3**5000), Fraction(1, 2**3000), "9" * 2000, Decimal("1e999999")],
                         ids=["long", "thirds", "places", "digits", "exponent"])
def test_huge_numbers_are_refused(mass):
    with pytest.raises(mdm.InputError):
        mdm.Gradation(["1", "2"], [mass, 0])


def test_masses_that_are_no_decimals_keep_their_ratios():
    thirds = mdm.Gradation(["1", "2", "3"], [Fraction(1, 3), Fraction(1, 6), 0])
    assert thirds.shares == (Fraction(2, 3), Fraction(1, 3))
    assert mdm.solve(thirds).quantities == mdm.solve(mdm.Gradation(["1", "2", "3"], [2, 1, 0])).quantities
    assert "multiplied by 3" in thirds.notes[0]


def test_sizes_that_are_no_decimals_are_refused():
    with pytest.raises(mdm.InputError, match="size 1/3 is no decimal"):
        mdm.Gradation([Fraction(1, 3), 2], [1, 0])


@given(st.fractions(min_value=Fraction(1, 10**9), max_denominator=10**9))
def test_a_mass_comes_out_as_it_went_in(mass):
    out = mdm.Gradation(["1", "2", "3"], [mass, 1, 0]).masses
    assert out[0] / out[1] == mass


@given(st.decimals(allow_nan=False, allow_infinity=False), st.decimals(min_value=0, max_value=10**6))
def test_the_middle_of_an_enclosure_is_exact(lo, width):
    enclosure = mdm.Enclosure(min(lo, width), max(lo, width))
    assert Fraction(enclosure.mid) * 2 == Fraction(lo) + Fraction(width)
    assert Fraction(enclosure.width) == abs(Fraction(lo) - Fraction(width))
    assert lo in mdm.Enclosure(lo, lo)


def test_an_enclosure_is_a_value():
    size = mdm.Enclosure(Decimal("0.1"), Decimal("0.2"))
    assert pickle.loads(pickle.dumps(size)) == size and hash(size) == hash(mdm.Enclosure(Decimal("0.10"), Decimal("0.2")))
    assert str(size) == "[0.1, 0.2]" and float(size) == 0.15 and not size.is_exact
    with pytest.raises(AttributeError):
        size.lo = Decimal(0)
    with pytest.raises(ValueError, match="empty"):
        mdm.Enclosure(Decimal(2), Decimal(1))
