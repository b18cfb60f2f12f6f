"""The league's table as text, CSV, SVG and a page of HTML."""

import csv
import html
import io
from dataclasses import dataclass

#: What becomes of an answer, the verdicts of mdm crosscheck that it stands for, and its colour.
COLUMNS = {"right": (["minimal"], "#2a7f5f"), "larger": (["larger"], "#c9a227"), "not a match": (["not-a-match"], "#b3392f"),
           "infeasible": (["infeasible"], "#7b3f8c"), "gave up": (["gave-up"], "#8a9099"), "timeout": (["timeout"], "#b9bec6"),
           "failed": (["crashed", "garbage", "no-answer", "undecided"], "#4d5360")}


@dataclass
class Result:
    """A solver on the gradations of a level."""

    solver: str
    version: str
    level: str
    rows: list
    certificates: int
    accepted: int
    example: tuple | None

    def counts(self):
        return {name: sum(row["verdict"] in verdicts for row in self.rows) for name, (verdicts, _) in COLUMNS.items()}

    def line(self):
        counts = "".join(f"{n:12}" for n in self.counts().values()) if self.rows else f"   {self.version}"
        return f"{self.solver:16}{self.level:10}{counts}"

    def shown_example(self):
        """What is wrong with the shortest answer that is no match."""
        if not self.example:
            return ""
        row, gradation = self.example
        asked = f" {row['options']}" if row["options"] else ""
        return f"{self.solver}, {self.level}: {row['id']}{asked} of {len(gradation['sizes']) - 1} classes: {row['reason']}"


def text(results, terms):
    heading = f"{'solver':16}{'level':10}" + "".join(f"{name:>12}" for name in COLUMNS)
    lines = [f"The league: {terms}", "", heading, *(result.line() for result in results), ""]
    lines += [f"{solver}: {version}" for solver, version in dict.fromkeys((r.solver, r.version) for r in results)]
    certificates, accepted = (sum(getattr(r, name) for r in results) for name in ("certificates", "accepted"))
    lines += ["", f"mdm-check accepts {accepted} of {certificates} certificates of answers.", "", "Shortest answers that are no match:"]
    lines += [example for example in (r.shown_example() for r in results) if example] or ["none"]
    return "\n".join(lines) + "\n"


def table(results):
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["solver", "version", "level", "asked", *(name.replace(" ", "_") for name in COLUMNS), "certificates", "accepted"])
    for r in results:
        writer.writerow([r.solver, r.version, r.level, len(r.rows), *r.counts().values(), r.certificates, r.accepted])
    return file.getvalue()


def picture(results):
    """A bar a solver and level, of all that became of its answers."""
    run, height, left, width = [r for r in results if r.rows], 20, 190, 420
    parts = []
    for i, r in enumerate(run):
        y, x = 50 + i * height, float(left)
        parts.append(f'<text x="{left - 8}" y="{y + 13}" text-anchor="end">{html.escape(r.solver)}, {r.level}</text>')
        for name, n in r.counts().items():
            part = width * n / len(r.rows)
            parts.append(f'<rect x="{x:.2f}" y="{y}" width="{part:.2f}" height="{height - 4}" fill="{COLUMNS[name][1]}"/>')
            x += part
        parts.append(f'<text x="{left + width + 8}" y="{y + 13}">{r.counts()["right"]} of {len(r.rows)}</text>')
    for i, (name, (_, colour)) in enumerate(COLUMNS.items()):
        parts.append(f'<rect x="{20 + 98 * i}" y="16" width="12" height="12" fill="{colour}"/><text x="{36 + 98 * i}" y="27">{name}</text>')
    size = f'width="720" height="{60 + len(run) * height}" viewBox="0 0 720 {60 + len(run) * height}"'
    return (f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="12">'
            f'<rect width="100%" height="100%" fill="white"/>{"".join(parts)}</svg>\n')


def page(results, terms):
    def row(cells, tag="td"):
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in cells) + "</tr>\n"

    head, *rows = csv.reader(io.StringIO(table(results)))
    examples = "".join(f"<li>{html.escape(e)}</li>\n" for e in (r.shown_example() for r in results) if e)
    style = "body{font:15px sans-serif;margin:2em;max-width:70em}td,th{padding:.2em .6em;text-align:left;white-space:nowrap}tr:nth-child(even){background:#f3f3f1}"
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>The league of solvers</title><style>{style}</style></head>\n'
            f"<body><h1>The league of solvers</h1>\n<p>{html.escape(terms)}.</p>\n{picture(results)}<table>\n"
            + row([name.replace("_", " ") for name in head], "th") + "".join(map(row, rows))
            + f"</table>\n<h2>Shortest answers that are no match</h2>\n<ul>\n{examples}</ul></body></html>\n")


def write(folder, results, terms):
    for name, content in (("league.txt", text(results, terms)), ("league.csv", table(results)), ("league.svg", picture(results)),
                          ("league.html", page(results, terms))):
        (folder / name).write_text(content)
