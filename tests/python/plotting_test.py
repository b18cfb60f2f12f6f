"""Figures by matplotlib."""

import exactmdm as mdm
import pytest
from support import SAND, sand

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


@pytest.fixture
def ax():
    figure, ax = pyplot.subplots()
    yield ax
    pyplot.close(figure)


def test_a_curve_is_what_passes(ax):
    assert mdm.plot(sand(), ax, color="red") is ax
    line, = ax.get_lines()
    assert list(line.get_ydata()) == [0, 20, 50, 100] and line.get_color() == "red" and ax.get_xscale() == "log"


def test_a_match_rises_at_its_sizes(ax):
    match = mdm.solve(SAND)
    mdm.plot(match, ax)
    curve, stairs = ax.get_lines()
    assert abs(stairs.get_ydata()[-1] - 100) < 1e-9 and {float(s) for s in match.sizes} <= set(stairs.get_xdata())


def test_a_match_of_nothing_is_a_curve_alone(ax):
    mdm.plot(mdm.solve(sand(), at_most=1), ax)
    assert len(ax.get_lines()) == 1


def test_a_tradeoff_falls(ax):
    mdm.plot(mdm.tradeoff(SAND), ax)
    counts = list(ax.get_lines()[0].get_ydata())
    assert counts == sorted(counts, reverse=True) and counts[0] == 1485


def test_a_pan_has_no_place_on_the_axis(ax):
    mdm.plot(mdm.Gradation(["0", "1", "2"], [1, 1, 0]), ax)
    assert min(ax.get_lines()[0].get_xdata()) == 1


def test_other_things_are_refused(ax):
    with pytest.raises(TypeError, match="int is not drawn"):
        mdm.plot(3, ax)


def test_the_current_axes_are_taken():
    assert mdm.plot(sand()) is pyplot.gca()
    pyplot.close("all")
