"""Sheets as files: text with separators, or a workbook."""

import dataclasses
import io

try:
    import openpyxl
except ImportError:
    openpyxl = None


@dataclasses.dataclass
class Style:
    """How the cells become bytes."""
    medium: str = "comma"  # comma, semicolon, tab, workbook
    sign: str = "."
    newline: str = "\n"
    encoding: str = "utf-8"
    quotes: bool = False  # around every text
    padded: bool = False  # every row as wide as the widest, as spreadsheets write them


def style_of(language, dice):
    """What programs of that country write."""
    medium = dice.choices(("comma", "semicolon", "tab", "workbook"), (5, 5, 4, 1))[0]
    if openpyxl is None and medium == "workbook":
        medium = "tab"
    comma_country = language != "en"
    sign = "," if medium == "semicolon" and comma_country else "."
    if medium == "tab":
        sign = "," if comma_country else "."
    return Style(medium, sign, dice.choice(("\n", "\r\n")),
                 dice.choices(("utf-8", "utf-8-sig", "cp1252", "utf-16"), (6, 3, 3, 1))[0], dice.random() < 0.15,
                 dice.random() < 0.5)


SEPARATOR = {"comma": ",", "semicolon": ";", "tab": "\t"}


def field(cell, separator, quotes):
    if cell and (quotes or separator in cell or '"' in cell or cell != cell.strip()):
        return '"' + cell.replace('"', '""') + '"'
    return cell


def text_of(lines, style):
    separator = SEPARATOR[style.medium]
    width = max(map(len, lines))
    rows = []
    for cells in lines:
        cells = [field(cell, separator, style.quotes) for cell in cells]
        if style.padded:
            cells += [""] * (width - len(cells))
        rows.append(separator.join(cells))
    return (style.newline.join(rows) + style.newline).encode(style.encoding, "replace")


def workbook_of(lines):
    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("PSD")
    for cells in lines:
        sheet.append([number_or_text(cell) for cell in cells])
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def number_or_text(cell):
    try:
        return (float(cell) if "." in cell else int(cell)) if cell else None
    except ValueError:
        return cell


def printed(lines, style):
    return workbook_of(lines) if style.medium == "workbook" else text_of(lines, style)
