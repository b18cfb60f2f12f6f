"""Figures by matplotlib, where it is installed."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Union

from exactmdm.errors import InputError
from exactmdm.exact import fits_float, middle, shown
from exactmdm.gradation import Gradation
from exactmdm.match import Match, curve, stairs
from exactmdm.trade import Tradeoff, TradeoffRow

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plot(what: Union[Gradation, Match, Tradeoff], ax: Axes | None = None, **style: Any) -> Axes:
    """Draws a grading curve, a match beside its gradation, or the particles of a trade-off over the tolerance.

    Args:
        what: a Gradation, a Match or a Tradeoff.
        ax: matplotlib axes to draw into; None: the current ones.
        style: of the lines, as matplotlib takes it.

    Returns:
        The axes.

    Raises:
        InputError: a size or a number of particles is beyond floats, which are what matplotlib draws.
        ModuleNotFoundError: matplotlib is not installed: `picture` draws without it.
    """
    if ax is None:
        try:
            from matplotlib import pyplot
        except ModuleNotFoundError:
            raise ModuleNotFoundError("matplotlib is not installed: exactmdm.picture draws without it") from None
        ax = pyplot.gca()
    if isinstance(what, Gradation):
        _curve(what, ax, style)
    elif isinstance(what, Match):
        _match(what, ax, style)
    elif isinstance(what, Tradeoff):
        _tradeoff(what, ax, style)
    else:
        raise TypeError(f"{type(what).__name__} is not drawn: give a Gradation, a Match or a Tradeoff")
    return ax


def _size_axes(ax: Axes, unit: str) -> None:
    ax.set_xscale("log")
    ax.set_xlabel(f"size, {unit}")
    ax.set_ylabel("percent passing")


def _drawn(points: Iterable[tuple[Any, Any]], unit: str) -> list[tuple[float, float]]:
    """Points (size, percent) as floats, without those at size 0."""
    exact = [(middle(size), percent) for size, percent in points if middle(size) > 0]
    return list(zip(_floats([size for size, _ in exact], unit), [float(percent) for _, percent in exact]))


def _floats(values: Iterable[Any], what: str) -> list[float]:
    for value in (entries := list(values)):
        if not fits_float(value):
            raise InputError(f"{shown(value)} {what} is beyond what matplotlib draws: choose another unit")
    return [float(value) for value in entries]


def _curve(gradation: Gradation, ax: Axes, style: dict[str, Any]) -> None:
    points = _drawn(zip(gradation.sizes, gradation.passing), gradation.unit)
    ax.plot(*zip(*points), marker="o", **{"label": gradation.id or "gradation", **style})
    _size_axes(ax, gradation.unit)


def _match(match: Match, ax: Axes, style: dict[str, Any]) -> None:
    ax.plot(*zip(*_drawn(curve(match), match.unit)), marker="o", label=match.id or "gradation")
    drawn = _drawn(stairs(match), match.unit)
    if drawn:
        ax.plot(*zip(*drawn), **{"label": f"{match.particles} particles", **style})
    _size_axes(ax, match.unit)
    ax.legend()


def _tradeoff(tradeoff: Tradeoff, ax: Axes, style: dict[str, Any]) -> None:
    def known(row: TradeoffRow) -> bool:
        return row.particles is not None

    rows = [row for row in tradeoff.by_tolerance if known(row)]
    ax.step(_floats([row.tolerance for row in rows], "percentage points"),
            _floats([row.particles for row in rows], "particles"),
            **{"where": "post", "marker": "o", "label": tradeoff.id, **style})
    ax.set_yscale("log")
    ax.set_xlabel(f"tolerance on what is {tradeoff.kind}, percentage points")
    ax.set_ylabel("particles of the smallest match")
