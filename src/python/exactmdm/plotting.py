"""Figures by matplotlib, where it is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Union

from exactmdm.gradation import Gradation
from exactmdm.match import Match, stairs
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
        ModuleNotFoundError: matplotlib is not installed: `picture` draws with gnuplot.
    """
    if ax is None:
        try:
            from matplotlib import pyplot
        except ModuleNotFoundError:
            raise ModuleNotFoundError("matplotlib is not installed: exactmdm.picture draws with gnuplot") from None
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


def _curve(gradation: Gradation, ax: Axes, style: dict[str, Any]) -> None:
    points = [(float(size), float(percent)) for size, percent in zip(gradation.sizes, gradation.passing)
              if float(size) > 0]
    ax.plot(*zip(*points), marker="o", **{"label": gradation.id or "gradation", **style})
    _size_axes(ax, gradation.unit)


def _match(match: Match, ax: Axes, style: dict[str, Any]) -> None:
    percent, curve = 0.0, [(float(match.classes[0].lower), 0.0)]
    total = sum(float(c.mass) for c in match.classes)
    for c in match.classes:
        percent += 100 * float(c.mass) / total
        curve.append((float(c.upper), percent))
    ax.plot(*zip(*[(size, y) for size, y in curve if size > 0]), marker="o", label=match.id or "gradation")
    drawn = [(size, y) for size, y in stairs(match) if size > 0]
    if drawn:
        ax.plot(*zip(*drawn), **{"label": f"{match.particles} particles", **style})
    _size_axes(ax, match.unit)
    ax.legend()


def _tradeoff(tradeoff: Tradeoff, ax: Axes, style: dict[str, Any]) -> None:
    def known(row: TradeoffRow) -> bool:
        return row.particles is not None

    rows = [row for row in tradeoff.by_tolerance if known(row)]
    ax.step([float(row.tolerance) for row in rows], [float(row.particles or 0) for row in rows],
            **{"where": "post", "marker": "o", "label": tradeoff.id, **style})
    ax.set_yscale("log")
    ax.set_xlabel(f"tolerance on what is {tradeoff.kind}, percentage points")
    ax.set_ylabel("particles of the smallest match")
