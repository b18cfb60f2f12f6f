"""Tables and small figures for notebooks."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from exactmdm.exact import decimal_of, middle, shown

#: Rows of a table at most; what is left out is said.
_MOST_ROWS = 60
_WIDTH, _HEIGHT, _MARGIN = 420, 220, 38


def html_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of texts."""
    lines = ["<table><thead><tr>", *(f"<th>{escape(cell)}</th>" for cell in header), "</tr></thead><tbody>"]
    for row in rows[:_MOST_ROWS]:
        lines.append("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>")
    if len(rows) > _MOST_ROWS:
        lines.append(f'<tr><td colspan="{len(header)}">... {len(rows) - _MOST_ROWS} more</td></tr>')
    return "".join([*lines, "</tbody></table>"])


def curve_figure(curves: Sequence[tuple[str, Sequence[tuple[Any, Any]]]], unit: str) -> str:
    """Curves of percent passing over the logarithm of the size, as SVG: (colour, points (size, percent)) each, of exact
    numbers of any magnitude.

    Points at size 0, the pan, have no place on such an axis.
    """
    sizes = [middle(size) for _, points in curves for size, _ in points if middle(size) > 0]
    if not sizes:
        return ""
    smallest, largest = min(sizes), max(sizes)
    low, high = _log10(smallest), _log10(largest)
    span = high - low or 1.0

    def across(size: Any) -> float:
        return _MARGIN + (_log10(size) - low) / span * (_WIDTH - 2 * _MARGIN)

    def down(percent: Any) -> float:
        return _HEIGHT - _MARGIN - float(percent) / 100 * (_HEIGHT - 2 * _MARGIN)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{_HEIGHT}" '
             'font-family="sans-serif" font-size="11" fill="#444">']
    for percent in (0, 50, 100):
        y = down(percent)
        parts.append(f'<line x1="{_MARGIN}" x2="{_WIDTH - _MARGIN}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
                     f'<text x="{_MARGIN - 4}" y="{y + 4:.1f}" text-anchor="end">{percent}</text>')
    for size in (smallest, largest):
        parts.append(f'<text x="{across(size):.1f}" y="{_HEIGHT - _MARGIN + 16}" text-anchor="middle">'
                     f'{shown(size, 3)}</text>')
    parts.append(f'<text x="{_WIDTH / 2}" y="{_HEIGHT - 6}" text-anchor="middle">size, {escape(unit)}</text>'
                 f'<text x="{_MARGIN}" y="{_MARGIN - 12}">percent passing</text>')
    for colour, points in curves:
        drawn = " ".join(f"{across(size):.1f},{down(percent):.1f}" for size, percent in points
                         if middle(size) > 0)
        parts.append(f'<polyline points="{drawn}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
    return "".join([*parts, "</svg>"])


def _log10(size: Any) -> float:
    return float(decimal_of(size, 20).log10())
