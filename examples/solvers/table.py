"""The league's table as text, CSV, SVG and a page of HTML."""

import csv
import html
import io
from dataclasses import dataclass

#: What becomes of an answer, the verdicts of mdm crosscheck that it stands for, its colour and what it means. An answer
#: that is no match and has fewer particles than the smallest match is impossible.
COLUMNS = {
    "right": (["minimal"], "#2a7f5f", "a smallest match"),
    "larger": (["larger"], "#8cc5a2", "a match, and there is a smaller one"),
    "not a match": (["not-a-match"], "#b3392f", "no sizes in the classes have the shares that were asked for"),
    "impossible": (["impossible"], "#e08e45", "no match either, with fewer particles than the smallest match has"),
    "infeasible": (["infeasible"], "#7b3f8c", "there is no match, says the solver; there always is one"),
    "gave up": (["gave-up"], "#98a0a8", "no answer, for example because numbers are beyond the solver's limits"),
    "timeout": (["timeout"], "#c9cdd2", "nothing within the time limit"),
    "new": (["undecided"], "#d4b106", "of an open problem a smaller match than any that is known"),
    "failed": (["crashed", "garbage", "no-answer"], "#3d434d", "a crash, or no answer"),
}


def fate(row):
    """The column of an answer."""
    verdict = row["verdict"]
    if verdict == "not-a-match" and row["minimum"] and int(row["particles"]) < int(row["minimum"]):
        verdict = "impossible"
    return next(name for name, (verdicts, _, _) in COLUMNS.items() if verdict in verdicts)


def cut(text, most):
    return text if len(text) <= most else text[:most - 3].rstrip() + "..."


@dataclass
class Result:
    """A solver on the gradations of a level. A note says why it was not asked."""

    solver: str
    version: str
    options: str
    level: str
    note: str
    rows: list
    certificates: int
    accepted: int

    def counts(self):
        fates = [fate(row) for row in self.rows]
        return {name: fates.count(name) for name in COLUMNS}

    def line(self):
        counts = "".join(f"{n:12}" for n in self.counts().values()) if not self.note else f"   {self.note}"
        return f"{self.solver:26}{self.level:10}{counts}"

    def example(self):
        """The shortest answer that is no match: what it is an answer to, its counts, and what is wrong with it."""
        wrong = [row for row in self.rows if row["verdict"] == "not-a-match"]
        if not wrong:
            return "", "", ""
        row = min(wrong, key=lambda row: len(row["gradation"]["sizes"]))
        asked = f"{row['id']} {row['options']}".strip()
        return (f"{asked}, {len(row['gradation']['sizes']) - 1} classes", cut(" ".join(row["quantities"]), 120),
                f"N = {row['particles']}, of the smallest match {row['minimum'] or 'open'}: {cut(row['reason'], 300)}")

    def excuse(self):
        """Why the first answer that is missing is."""
        missing = [row for row in self.rows if fate(row) in ("gave up", "failed") and row["reason"]]
        return f"{fate(missing[0])}: {cut(missing[0]['reason'], 160)}" if missing else ""


def examples(results):
    """Lines on the shortest answers that are no match."""
    found = [(f"{r.solver}, {r.level}", *r.example()) for r in results]
    lines = [f"{who}: {question}. Answer {counts}; {wrong}" for who, question, counts, wrong in found if question]
    return lines or ["none"]


def excuses(results):
    """Lines on why answers are missing."""
    return [f"{r.solver}, {r.level}: {r.excuse()}" for r in results if r.excuse()] or ["none"]


def certificates(results):
    answers, made, accepted = (sum(counts) for counts in zip(*(
        (sum(bool(row["particles"]) for row in r.rows), r.certificates, r.accepted) for r in results)))
    return (f"Of {answers} answers {made} have a certificate, that they match or with which errors they do not; "
            f"mdm-check accepts {accepted}.")


def text(results, terms):
    heading = f"{'solver':26}{'level':10}" + "".join(f"{name:>12}" for name in COLUMNS)
    lines = [f"The league: {terms}", "", heading, *(result.line() for result in results), ""]
    lines += [f"{name}: {meaning}" for name, (_, _, meaning) in COLUMNS.items()] + ["", certificates(results), ""]
    lines += list(dict.fromkeys(f"{r.solver}: {r.version}" + (f"; {r.options}" if r.options else "") for r in results))
    lines += ["", "Shortest answers that are no match:", *examples(results)]
    lines += ["", "Why answers are missing, the first of each:", *excuses(results)]
    return "\n".join(lines) + "\n"


def table(results):
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    counted = [name.replace(" ", "_") for name in COLUMNS]
    writer.writerow(["solver", "version", "options", "level", "note", "asked", *counted, "certificates", "accepted",
                     "example", "example_answer", "example_reason"])
    for r in results:
        writer.writerow([r.solver, r.version, r.options, r.level, r.note, len(r.rows), *r.counts().values(),
                         r.certificates, r.accepted, *r.example()])
    return file.getvalue()


def bar(r, x, y, width, height):
    """All that became of a solver's answers to a level, each in its share of the width, or why it was not asked."""
    if r.note:
        return f'<text x="{x}" y="{y + 13}" fill="#667" font-style="italic">{html.escape(r.note)}</text>\n'
    parts = [f'<text x="{x + width + 6}" y="{y + 13}">{r.counts()["right"]}/{len(r.rows)}</text>\n']
    at = float(x)
    for name, n in r.counts().items():
        part = width * n / len(r.rows)
        if n:
            parts.append(f'<rect x="{at:.2f}" y="{y}" width="{part:.2f}" height="{height}" fill="{COLUMNS[name][1]}">'
                         f"<title>{html.escape(r.solver)}, {r.level}: {n} {name}</title></rect>\n")
        at += part
    return "".join(parts)


def picture(results):
    """A row a solver, with a bar a level."""
    solvers, levels = (list(dict.fromkeys(getattr(r, key) for r in results)) for key in ("solver", "level"))
    left, width, step, height = 180, 130, 190, 22
    size = f'width="{left + step * len(levels)}" height="{76 + height * len(solvers)}"'
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="12">\n'
             f'<title>The league of solvers</title>\n<rect width="100%" height="100%" fill="white"/>\n']
    for i, (name, (_, colour, _)) in enumerate(COLUMNS.items()):
        parts.append(f'<rect x="{12 + 100 * i}" y="14" width="12" height="12" fill="{colour}"/>'
                     f'<text x="{29 + 100 * i}" y="25">{name}</text>\n')
    for i, level in enumerate(levels):
        parts.append(f'<text x="{left + step * i}" y="56" font-weight="bold">{level}</text>\n')
    for i, solver in enumerate(solvers):
        parts.append(f'<text x="{left - 10}" y="{77 + height * i}" text-anchor="end">{html.escape(solver)}</text>\n')
    for r in results:
        x, y = left + step * levels.index(r.level), 64 + height * solvers.index(r.solver)
        parts.append(bar(r, x, y, width, height - 5))
    return "".join(parts) + "</svg>\n"


STYLE = """body { font: 15px sans-serif; margin: 2em; max-width: 84em; line-height: 1.4 }
table { border-collapse: collapse; display: block; overflow-x: auto }
td, th { padding: .2em .5em; text-align: right; white-space: nowrap }
td:nth-child(-n+2), th:nth-child(-n+2), .versions td, .versions th { text-align: left }
tr:nth-child(even) { background: #f3f3f1 }
svg { max-width: 100% }
li { margin: .4em 0; overflow-wrap: anywhere }
i { display: inline-block; width: .8em; height: .8em }
"""


def page(results, terms):
    def row(cells, tag="td"):
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in cells) + "</tr>\n"

    def listed(lines):
        return "<ul>\n" + "".join(f"<li>{html.escape(line)}</li>\n" for line in lines) + "</ul>\n"

    def counted(r):
        if not r.note:
            return row([r.solver, r.level, *r.counts().values(), r.certificates, r.accepted])
        return (f'<tr><td>{html.escape(r.solver)}</td><td>{r.level}</td><td colspan="{len(COLUMNS) + 2}" '
                f'style="text-align: left">{html.escape(r.note)}</td></tr>\n')

    meanings = "".join(f'<li><i style="background: {colour}"></i> {name}: {meaning}</li>\n'
                       for name, (_, colour, meaning) in COLUMNS.items())
    head = row(["solver", "level", *COLUMNS, "certificates", "accepted"], "th")
    versions = "".join(row(cells) for cells in dict.fromkeys((r.solver, r.version, r.options) for r in results))
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>The league of solvers</title>\n'
            f"<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>The league of solvers</h1>\n"
            f"<p>{html.escape(terms)}. {certificates(results)}</p>\n{picture(results)}<ul>\n{meanings}</ul>\n"
            f"<table>\n{head}{''.join(map(counted, results))}</table>\n<h2>Versions and options</h2>\n"
            f"<table class=\"versions\">\n{row(['solver', 'version', 'options'], 'th')}{versions}</table>\n"
            f"<h2>Shortest answers that are no match</h2>\n{listed(examples(results))}"
            f"<h2>Why answers are missing, the first of each</h2>\n{listed(excuses(results))}</body>\n</html>\n")


def write(folder, results, terms):
    for ending, content in {"txt": text(results, terms), "csv": table(results), "svg": picture(results),
                            "html": page(results, terms)}.items():
        (folder / f"league.{ending}").write_text(content, encoding="utf-8")
