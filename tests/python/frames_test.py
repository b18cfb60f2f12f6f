"""Gradations from tables: columns of floats, units of all kinds."""

from fractions import Fraction

import exactmdm as mdm
import pytest

pandas = pytest.importorskip("pandas")
numpy = pytest.importorskip("numpy")


def test_a_frame_with_percent_passing_is_a_gradation():
    frame = pandas.DataFrame({"opening": [2.0, 0.425, 0.075], "p": [100, 45.5, 12]})
    g = mdm.Gradation.from_frame(frame, size="opening", passing="p", floats="shortest", id="sand")
    assert g.sizes == (0, Fraction("0.075"), Fraction("0.425"), 2)
    assert g.passing == (0, 12, Fraction("45.5"), 100) and g.id == "sand"
    assert g.notes == ("floats were taken as the shortest decimals that mean them",)


def test_a_frame_with_masses_is_a_gradation_in_any_order():
    frame = pandas.DataFrame({"d": ["0.4", "0.1", "0.2"], "m": [0, 3, 5]})
    g = mdm.Gradation.from_frame(frame, size="d", mass="m", unit="um")
    assert g.masses == (3, 5, 0) and g.unit == "um" and g.notes == ()


def test_columns_of_different_lengths_are_refused():
    for amount in ("mass", "passing"):
        with pytest.raises(mdm.InputError, match="d and p must be as long as each other: 3 and 2"):
            mdm.Gradation.from_frame({"d": ["1", "2", "4"], "p": [0, 100]}, size="d", **{amount: "p"})


def test_floats_are_refused_where_nothing_is_said_of_them():
    frame = pandas.DataFrame({"d": [0.1, 0.2], "m": [1, 0]})
    with pytest.raises(mdm.InputError, match="is a float"):
        mdm.Gradation.from_frame(frame, size="d", mass="m")
    with pytest.raises(mdm.InputError, match="floats: 'near' is unknown"):
        mdm.Gradation.from_frame(frame, size="d", mass="m", floats="near")
    binary = mdm.Gradation.from_frame(frame, size="d", mass="m", floats="binary")
    assert binary.sizes[0] == Fraction(0.1) and binary == mdm.Gradation([0.1, 0.2], [1, 0], exact=True)


def test_floats_of_32_bits_are_the_decimals_that_they_show():
    g = mdm.Gradation(numpy.array([0.1, 0.2], dtype=numpy.float32), [1, 0], floats="shortest")
    assert g.sizes == (Fraction(1, 10), Fraction(1, 5))


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_what_is_no_number_in_a_frame_is_refused(value):
    frame = pandas.DataFrame({"d": [0.1, value], "m": [1, 0]})
    with pytest.raises(mdm.InputError, match=r"d\[1\]: .* is no number"):
        mdm.Gradation.from_frame(frame, size="d", mass="m", floats="shortest")


def test_passing_that_is_none_is_refused():
    def read(passing, **words):
        return mdm.Gradation.from_frame({"d": ["1", "2", "4"], "p": passing}, size="d", passing="p", **words)

    with pytest.raises(mdm.InputError, match="must not fall"):
        read([0, 50, 40])
    with pytest.raises(mdm.InputError, match="100 percent"):
        read([0, 50, 90])
    with pytest.raises(mdm.InputError, match="below which there is no size"):
        mdm.Gradation.from_frame({"d": ["1", "0"], "p": [10, 100]}, size="d", passing="p", unit="phi")
    with pytest.raises(mdm.InputError, match="give mass or passing"):
        mdm.Gradation.from_frame({"d": ["1"], "p": [0]}, size="d")
    assert read([10, 50, 100]).sizes[0] == 0 and read([0, 50, 100]).sizes[0] == 1


def test_sizes_in_inches_phi_and_names_of_sieves():
    assert mdm.Gradation(["0.5", "1"], [1, 0], "in").sizes == (Fraction("12.7"), Fraction("25.4"))
    assert mdm.Gradation([2, 0, -1], [1, Fraction(1, 3), 0], "phi").sizes == (Fraction(1, 4), 1, 2)
    half = mdm.Gradation(["1.5", "0.5"], [1, 0], "phi", "half")
    assert all(isinstance(size, mdm.Enclosure) for size in half.sizes) and half.id == "half"
    named = mdm.Gradation(["No. 200", "No. 4", "3/8 in"], [1, 2, 0], "sieve")
    assert named.sizes == (Fraction("0.075"), Fraction("4.75"), Fraction("9.5"))
    with pytest.raises(mdm.InputError, match="sieve"):
        mdm.Gradation(["No. 1000", "No. 4"], [1, 0], "sieve")
    with pytest.raises(mdm.InputError, match="as long as each other"):
        mdm.Gradation(["1", "2"], [1], "in")


def test_a_match_is_true_where_there_is_one():
    sand = mdm.Gradation(["1", "2", "3"], [2, 1, 0])
    assert mdm.solve(sand) and not mdm.solve(sand, at_most=1)


def test_the_frame_of_a_match_has_bounds_and_shares():
    frame = mdm.solve(mdm.Gradation(["1", "2", "3"], [2, 1, 0])).to_frame()
    assert list(frame["share"]) == [2 / 3, 1 / 3]
    assert all(frame["size_lo"] <= frame["size"]) and all(frame["size"] <= frame["size_hi"])
    near = mdm.solve(mdm.Gradation(["1", "2", "3"], [2, 1, 0]), tolerance="retained:20%")
    assert list(near.to_frame()["share"]) == [float(share) for share in near.achieved]
