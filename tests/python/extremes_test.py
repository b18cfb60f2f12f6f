"""Numbers that no float has: they are shown, tabulated and drawn as what they are, or refused."""

import re
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import pytest


def huge():
    return mdm.Gradation(["1", "1e399", "1e400"], ["2e400", "1e400", 0], id="huge")


def tiny():
    return mdm.Gradation(["1e-400", "2e-400", "3e-400"], [2, 1, 0], id="tiny")


def test_a_gradation_shows_its_sizes():
    assert repr(huge()) == "<Gradation 'huge': 2 classes, 1 to 1e+400 mm>"
    assert repr(tiny()) == "<Gradation 'tiny': 2 classes, 1e-400 to 3e-400 mm>"
    assert "(1e+399, 1e+400]" in huge()._repr_html_() and "2e+400" in huge()._repr_html_()
    assert "(1e-400, 2e-400]" in tiny()._repr_html_()


def test_the_figure_of_a_gradation_has_its_curve():
    for gradation in (huge(), tiny()):
        points = re.search(r'polyline points="([^"]*)"', gradation._repr_html_())[1].split()
        across = [float(point.split(",")[0]) for point in points]
        assert len(points) == 3 and across == sorted(set(across))


def test_a_table_has_exact_numbers_where_floats_have_none():
    pytest.importorskip("pandas")
    frame = huge().to_frame()
    assert list(frame["upper"]) == [Fraction(10**399), Fraction(10**400)] and list(frame["lower"]) == [1, 10**399]
    assert frame["share"].dtype == float and frame["share"][1] == 1 / 3
    assert list(tiny().to_frame()["lower"]) == [Fraction(1, 10**400), Fraction(2, 10**400)]
    match = mdm.solve(tiny())
    assert list(match.to_frame()["size"]) == list(match.sizes)


def test_a_match_shows_its_sizes():
    match = mdm.solve(tiny())
    assert "1e-400" in match._repr_html_().lower() and match.particles == 4
    assert "inf" not in mdm.solve(huge(), at_most=10)._repr_html_()


def test_floats_that_round_to_a_few_digits_are_no_floats_of_a_table():
    pytest.importorskip("pandas")
    frame = mdm.Gradation(["0", "1e-320", "1"], [1, 1, 0]).to_frame()
    assert list(frame["lower"]) == [0, Fraction(1, 10**320)]


def test_what_matplotlib_cannot_draw_is_refused():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib.figure import Figure
    for what in (huge(), tiny(), mdm.solve(tiny())):
        with pytest.raises(mdm.InputError, match=r"e[+-]\d* mm is beyond what matplotlib draws: choose another unit"):
            mdm.plot(what, Figure().subplots())


def test_a_description_has_its_sizes():
    described = mdm.describe(mdm.Gradation(["1e399", "1e400"], [1, 0], id="huge"))
    assert "inf" not in repr(described) and re.search(r"D50 \d[.\d]*e\+399 mm", repr(described))
    assert "inf" not in described._repr_html_()


def test_a_verification_has_its_shares():
    pytest.importorskip("pandas")
    judged = mdm.verify(tiny(), ["2e-400", "3e-400"])
    assert list(judged.to_frame()["upper"]) == [Decimal("2e-400"), Decimal("3e-400")]
    assert "%" in repr(judged) and "<table>" in judged._repr_html_()
