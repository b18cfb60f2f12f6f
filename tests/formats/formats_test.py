#!/usr/bin/python3
"""formats_test.py MDM MDM_CHECK SOURCE: files as laboratories and instruments have them, against other readers of them.

The files of examples/gradations/formats are read by python3-openpyxl, xlsx2csv, python3-pandas and Python's own XML and
text readers; mdm convert must give the same canonical table. Hostile files must be refused within seconds and little
memory. Exits with 77 where a reader is missing, unless MDM_REQUIRE_TOOLS is set in the environment.
"""

import csv
import decimal
import io
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import typing
import xml.etree.ElementTree
import zipfile

try:
    import openpyxl
    import pandas
    XLSX2CSV = shutil.which("xlsx2csv")
    if XLSX2CSV is None:
        raise ImportError("xlsx2csv is not installed")
except ImportError as error:
    print(error)
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)

MDM = str(pathlib.Path(sys.argv[1]).resolve())
MDM_CHECK = str(pathlib.Path(sys.argv[2]).resolve())
FORMATS = pathlib.Path(sys.argv[3]).resolve() / "examples/gradations/formats"
D = decimal.Decimal
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def mdm(*arguments):
    return subprocess.run([MDM, *map(str, arguments)], capture_output=True, text=True, timeout=60)


def converted(*arguments):
    """The canonical table, by size."""
    run = mdm("convert", *arguments, "--quiet", "--format", "csv")
    check(run.returncode == 0, f"{arguments}: {run.stderr}")
    rows = list(csv.reader(io.StringIO(run.stdout)))[1:]
    return {D(size): D(mass) for size, mass in rows}


def same(ours, theirs, what):
    theirs = {D(str(size)): D(str(mass)) for size, mass in theirs.items()}
    check(ours == theirs, f"{what}:\n{ours}\n{theirs}")


def masses_of_passing(passing):
    """The masses in percent of a table of percent passing, with the pan that is implied."""
    sizes = sorted(passing)
    masses = {a: passing[b] - passing[a] for a, b in zip(sizes, sizes[1:])}
    masses[sizes[-1]] = D(0)
    if passing[sizes[0]] != 0:
        masses[D(0)] = passing[sizes[0]]
    return masses


def number(text):
    return D(text.replace(",", ".").rstrip("%"))


def test_workbook():
    path = FORMATS / "workbook.xlsx"
    ours = converted(path)
    sheet = openpyxl.load_workbook(path)["Grain size"]
    rows = [row for row in sheet.iter_rows(min_row=5, max_row=12, values_only=True)]
    same(ours, {opening or 0: repr(mass) for _, opening, mass, _ in rows}, "openpyxl")
    text = subprocess.run([XLSX2CSV, path], capture_output=True, text=True, check=True).stdout
    rows = [row for row in csv.reader(io.StringIO(text)) if row and (row[0].startswith("No. ") or row[0] == "Pan")]
    same(ours, {"%.15g" % float(row[1] or 0): "%.15g" % float(row[2]) for row in rows}, "xlsx2csv")
    frame = pandas.read_excel(path, sheet_name="Grain size", skiprows=3).iloc[:8]
    same(ours, {(0 if size != size else size): mass for size, mass in zip(frame.iloc[:, 1], frame.iloc[:, 2])}, "pandas")
    passing = {D(str(row[1])): D("%.15g" % (row[3] * 100)) for row in sheet.iter_rows(5, 11, values_only=True)}
    same(converted(path, "--columns", "Opening (mm),% passing"), masses_of_passing(passing), "percent in cells")


def test_german_csv():
    frame = pandas.read_csv(FORMATS / "siebung.csv", sep=";", decimal=",", skiprows=5, encoding="cp1252", header=None)
    rows = {("0" if size == "Schale" else number(size)): mass for size, mass in zip(frame[0], frame[1]) if size != "Summe"}
    rows.pop("Siebweite [mm]", None)
    same(converted(FORMATS / "siebung.csv"), rows, "German CSV")


def test_hydrometer():
    passing, unit = {}, D(1)
    for line in (FORMATS / "sieve-and-hydrometer.txt").read_text(encoding="utf-8").splitlines():
        cells = line.split("\t")
        if "Diameter (µm)" in cells:
            unit = D("0.001")
        elif len(cells) == 3 and cells[2].endswith("%"):
            passing[number(cells[1]) * unit] = number(cells[2])
    same(converted(FORMATS / "sieve-and-hydrometer.txt"), masses_of_passing(passing), "hydrometer")


def test_instruments():
    frame = pandas.read_csv(FORMATS / "mastersizer.csv", header=None)
    first = list(frame.iloc[0]).index("Result Between User Sizes (Sizes in um)")
    sizes = [D(str(x)) for x in frame.iloc[1, first:]]
    for row, name in ((2, "Silt A"), (3, "Silt B")):
        masses = [D(0) if x != x else D(str(x)) for x in frame.iloc[row, first:]]
        ours = converted(FORMATS / "mastersizer.csv", "--specimen-id", name)
        same(ours, dict(zip(sizes, masses)), name)
    text = (FORMATS / "camsizer.xle").read_bytes().decode("utf-16")
    rows = [line.split("\t") for line in text.split("p3 [%]")[1].split("Form")[0].splitlines()[1:] if line]
    theirs = {number(row[0]): number(row[2]) for row in rows}
    theirs[number(rows[-1][1])] = D(0)
    same(converted(FORMATS / "camsizer.xle"), theirs, "CAMSIZER")
    text = (FORMATS / "coulter.$ls").read_text(encoding="latin-1")
    section = lambda name: [D(x) for x in text.split(f"[{name}]")[1].split("[")[0].split()]
    theirs = dict(zip(section("#Bindiam"), section("#Binheight")))
    same(converted(FORMATS / "coulter.$ls"), theirs, "Coulter")


def test_ground_investigations():
    geo = "{http://diggsml.org/schemas/2.6/geotechnical}"
    tree = xml.etree.ElementTree.parse(FORMATS / "diggs.xml")
    passing = {D(g.find(geo + "particleSize").text): D(g.find(geo + "percentPassing").text)
               for g in tree.iter(geo + "Grading")}
    same(converted(FORMATS / "diggs.xml"), masses_of_passing(passing), "DIGGS")
    rows = list(csv.reader((FORMATS / "site.ags").open(encoding="utf-8", newline="")))
    for name in ("BH1", "S204"):
        passing = {D(row[8]): D(row[9]) for row in rows if row and row[0] == "DATA" and name in row}
        same(converted(FORMATS / "site.ags", "--specimen-id", name), masses_of_passing(passing), name)


def test_proofs(folder):
    for name, more in (("siebung.csv", []), ("workbook.xlsx", []), ("site.ags", ["--specimen-id", "BH1"]),
                       ("camsizer.xle", []), ("../athabasca-sand.csv", ["--round", "2"])):
        proof = folder / "a proof"
        run = mdm("solve", FORMATS / name, *more, "--proof", proof)
        check(run.returncode == 0 and f"{proof}.gradation.csv" in run.stdout, f"{name}: {run.stdout}{run.stderr}")
        verdict = subprocess.run([MDM_CHECK, f"{proof}.gradation.csv", proof], capture_output=True, timeout=60)
        check(verdict.returncode == 0, f"{name}: {verdict.stdout}")
        run = mdm("solve", f"{proof}.gradation.csv", "--proof", folder / "another")
        check(run.returncode == 0 and ".gradation.csv.gradation" not in run.stdout, f"{name}: canonical again")


def refused(path, part, *options):
    """Exit 2 within seconds and 600 MiB of address space, with one line that says why."""
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (600 << 20, 600 << 20))
    begin = time.monotonic()
    run = subprocess.run([MDM, "convert", str(path), *options], capture_output=True, text=True, timeout=60,
                         preexec_fn=None if os.environ.get("ASAN_OPTIONS") else limit)
    check(run.returncode == 2 and part in run.stderr and run.stderr.count("\n") == 1 and not run.stdout,
          f"{path.name}: exit {run.returncode}, {run.stderr}, expected {part}")
    check(time.monotonic() - begin < 10, f"{path.name}: {time.monotonic() - begin} s")


class Repeated(typing.NamedTuple):
    """Much of the same."""
    begin: bytes
    part: bytes
    times: int


def workbook_with(path, replaced):
    """The example with other files in it."""
    with zipfile.ZipFile(FORMATS / "workbook.xlsx") as old, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        for name in old.namelist():
            content = replaced.get(name, old.read(name))
            if isinstance(content, Repeated):
                with new.open(name, "w") as out:
                    out.write(content.begin)
                    for _ in range(content.times):
                        out.write(content.part)
            elif content is not None:
                new.writestr(name, content)
    return path


def sheet(rows):
    return ('<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>' + rows +
            "</sheetData></worksheet>")


def cells(rows):
    """A sheet of rows of cells: numbers, texts, True and False, or (number, index of a style)."""
    def cell(value):
        if isinstance(value, bool):
            return f"<c t='b'><v>{int(value)}</v></c>"
        if isinstance(value, str):
            return f"<c t='inlineStr'><is><t>{value}</t></is></c>"
        number, style = value if isinstance(value, tuple) else (value, 0)
        return f"<c s='{style}'><v>{number}</v></c>"
    return sheet("".join("<row>" + "".join(map(cell, row)) + "</row>" for row in rows))


def formats(*codes):
    """Styles 1, 2, ... with these formats."""
    numbered = list(enumerate(codes, 200))
    escaped = lambda code: code.replace("<", "&lt;").replace('"', "&quot;")
    return ("<styleSheet><numFmts>" + "".join(f'<numFmt numFmtId="{i}" formatCode="{escaped(c)}"/>' for i, c in numbered) +
            '</numFmts><cellXfs><xf numFmtId="0"/>' + "".join(f'<xf numFmtId="{i}"/>' for i, _ in numbered) +
            "</cellXfs></styleSheet>")


def test_cells_of_workbooks(folder):
    """A text, a truth value and a format say what the sheet shows."""
    header = ["Size (mm)", "Mass (g)"]
    first = "xl/worksheets/sheet1.xml"
    path = folder / "cells.xlsx"
    write = lambda rows, *codes: workbook_with(path, {first: cells([header, *rows]), "xl/styles.xml": formats(*codes)})
    table = lambda rows, *codes: converted(write(rows, *codes))
    refused(write([[4, 0], [2, "1.250"], [1, 850]]), "the number '1.250' may have a decimal point or thousands")
    refused(write([[4, 0], [2, "1.250"], [1, 0.5]]), "the number '1.250' may have a decimal point or thousands")
    check(table([[4, 0], [2, "1.25"], [1, 850]]) == {D(4): D(0), D(2): D("1.25"), D(1): D(850)}, "a text with a point")
    check(table([[4, 0], [0.5, "1,25"], [0.25, 8.5]]) == {D(4): D(0), D("0.5"): D("1.25"), D("0.25"): D("8.5")},
          "a text with a comma beside numbers")
    check(table([[4, 0], [2, 20.5], ["Pan", 5.049]]) == {D(4): D(0), D(2): D("20.5"), D(0): D("5.049")},
          "a number that is stored has no thousands")
    refused(write([[4, 0], [2, 20.5], ["Dry mass", "25.500"]]), "may have a decimal point or thousands")
    refused(write([[4, 0], [(45359, 1), 5], [1, 3]], "d/m/yyyy"), "a date stands where a sieve belongs")
    refused(write([[4, 0], [2, True], [1, 3]]), "'TRUE' in the column 'Mass (g)' is not a number")
    refused(write([[4, 0], [True, 2], [0.5, 3]]), "'TRUE' is no sieve")
    um = '0.0" um"'
    check(table([[2, 0], [1.18, 2], [(75, 1), 3]], um) == {D(2): D(0), D("1.18"): D(2), D("0.075"): D(3)}, "um of a format")
    check(table([[(2, 1), 0], [(1, 1), 2]], "0.00 \\m\\m") == {D(2): D(0), D(1): D(2)}, "mm of a format")
    check(table([[2, 0], [1, (2.5, 1)]], '#,##0.00_-" g";-#,##0.00') == {D(2): D(0), D(1): D("2.5")}, "g of a format")
    check(table([[2, 0], [1, (2.5, 1)]], "[Red]0.00E+00") == {D(2): D(0), D(1): D("2.5")}, "a colour")
    refused(write([[2, 0], [1, (2.5, 1)]], '0.0"%"'), "'2.5%' has another unit than the column 'Mass (g)'")
    refused(write([[2, 0], [(1, 1), 2]], '"<"0'), "'<1' is of what passes 1 mm, and the finest sieve is 2 mm")
    refused(write([[2, 0], [1, (2500, 1)]], "0.0,"), "'2500 in thousands' in the column")
    refused(write([[2, 0], [1, (2.5, 1)]], '[<1]0.0" g";0.0" kg"'), "on a condition g' in the column")
    named = [["Sieve", "Mass (g)"], [(4, 1), 0], [(10, 1), 2]]
    workbook_with(path, {first: cells(named), "xl/styles.xml": formats('"No. "0')})
    check(converted(path) == {D("4.75"): D(0), D(2): D(2)}, "numbers of sieves")


def test_hidden_rows_are_named(folder):
    begin, *rows = cells([["Size (mm)", "Mass (g)"], [4, 0], [2, 3], [1, 5], ["Pan", 2]]).split("<row>")
    opened = ["<row>", "<row>", '<row hidden="1">', "<row>", '<row hidden="1">']
    rows = begin + "".join(tag + row for tag, row in zip(opened, rows))
    run = mdm("convert", workbook_with(folder / "hidden.xlsx", {"xl/worksheets/sheet1.xml": rows}))
    check("Rows that the sheet hides were read too: '2', 'Pan'." in run.stderr, f"hidden rows: {run.stderr}")


def test_what_a_workbook_does_not_hold_or_strikes_out_is_refused(folder):
    first, header = "xl/worksheets/sheet1.xml", ["Size (mm)", "Mass (g)"]
    path = folder / "cells.xlsx"
    formula = sheet("<row><c t='inlineStr'><is><t>Size (mm)</t></is></c><c t='inlineStr'><is><t>Mass (g)</t></is></c></row>"
                    "<row><c><v>4</v></c><c><v>0</v></c></row><row><c><v>2</v></c><c{}><f>A1</f><v></v></c></row>"
                    "<row><c><v>1</v></c><c><v>3</v></c></row>")
    refused(workbook_with(path, {first: formula.format("")}), "a cell has a formula without its value")
    refused(workbook_with(path, {first: formula.format(" t='str'")}), "the size '2' has no value")
    styles = ("<styleSheet><fonts><font/><font><strike/></font><font><strike val='0'/></font></fonts><cellXfs><xf/>"
              "<xf fontId='1'/><xf fontId='2'/></cellXfs></styleSheet>")
    write = lambda rows: workbook_with(path, {first: cells([header, *rows]), "xl/styles.xml": styles})
    refused(write([[4, 0], [2, (3, 1)], [1, 5]]), "'3 (struck out)' in the column 'Mass (g)' is not a number")
    refused(write([[4, 0], [(2, 1), 3], [1, 5]]), "'2 (struck out)'")
    check(converted(write([[4, 0], [(2, 2), (3, 2)]])) == {D(4): D(0), D(2): D(3)}, "a strike that is off")


def test_a_sheet_that_is_hidden_is_not_taken(folder):
    rows = cells([["Size (mm)", "Mass (g)"], [2, 0], [1, 3]])
    book = zipfile.ZipFile(workbook_with(folder / "b.xlsx", {})).read("xl/workbook.xml").decode()
    hidden = re.sub(r"<sheet (?=[^>]*Grain size)", '<sheet state="hidden" ', book, count=1)
    check(hidden != book, "no sheet to hide")
    path = workbook_with(folder / "hidden.xlsx", {"xl/worksheets/sheet2.xml": rows, "xl/workbook.xml": hidden})
    run = mdm("convert", path)
    check(run.stdout.split() == ["size_mm,mass", "1,3", "2,0"] and "not read: 'Grain size'" in run.stderr,
          f"a hidden sheet: {run.stdout}{run.stderr}")


def test_other_sheets_of_limits_are_named(folder):
    limits = cells([["Sieve (mm)", "Lower", "Upper"], [4, 90, 100], [1, 10, 90]])
    path = workbook_with(folder / "limits.xlsx", {"xl/worksheets/sheet1.xml": limits, "xl/worksheets/sheet2.xml": limits})
    run = mdm("judge", FORMATS.parent / "athabasca-sand.csv", "--spec", path)
    check("Other sheets of the workbook are not read: 'Remarks'" in run.stdout + run.stderr, f"limits: {run.stdout}{run.stderr}")


def test_sheets_have_ids(folder):
    path = workbook_with(folder / "two.xlsx", {"xl/worksheets/sheet2.xml": cells([["Size (mm)", "Mass (g)"], [2, 0], [1, 3]])})
    for name in ("Grain size", "Remarks"):
        run = mdm("convert", path, "--sheet", name, "--format", "json")
        check(f'"id": "two/{name}"' in run.stdout or f'"id":"two/{name}"' in run.stdout, f"{name}: {run.stdout}{run.stderr}")


def test_a_batch_has_all_written_sheets(folder):
    second = "xl/worksheets/sheet2.xml"
    table = cells([["Size (mm)", "Mass (g)"], [2, 0], [1, 3]])
    for rows, more, ids in ((table, [], ["two/Grain size", "two/Remarks"]), (sheet(""), [], ["two/Grain size"]),
                            (table, ["--sheet", "Remarks"], ["two/Remarks"])):
        run = mdm("batch", workbook_with(folder / "two.xlsx", {second: rows}), *more)
        check([json.loads(line)["id"] for line in run.stdout.splitlines()] == ids, f"{ids}: {run.stdout}{run.stderr}")
    run = mdm("batch", workbook_with(folder / "two.xlsx", {second: cells([["Remarks"], ["none"]])}))
    statuses = [json.loads(line)["status"] for line in run.stdout.splitlines()]
    check(run.returncode == 2 and statuses == ["optimal", "error"], f"a sheet of remarks: {run.stdout}{run.stderr}")


def test_a_workbook_is_one_whenever_it_was_saved(folder):
    """At some moments the bytes of its time are a new line with a brace, as of a gradation in JSON."""
    path = folder / "moment.xlsx"
    with zipfile.ZipFile(FORMATS / "workbook.xlsx") as old, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        for name in old.namelist():
            new.writestr(zipfile.ZipInfo(name, (2026, 11, 27, 1, 20, 0)), old.read(name))
    check(b"\n{" in path.read_bytes()[:16], "the moment is another")
    run = mdm("batch", path)
    statuses = [json.loads(line)["status"] for line in run.stdout.splitlines()]
    check(statuses[:1] == ["optimal"], f"a workbook of that moment: {run.stdout[:300]}{run.stderr}")
    same(converted(path), converted(FORMATS / "workbook.xlsx"), "a workbook of that moment")


def test_all_sheets_are_samples_where_that_is_asked_for(folder):
    path = workbook_with(folder / "two.xlsx", {"xl/worksheets/sheet2.xml": cells([["Size (mm)", "Mass (g)"], [2, 0], [1, 3]])})
    named = ["two/Grain size", "two/Remarks"]
    run = mdm("describe", path, "--all-sheets", "--format", "json")
    check([json.loads(line)["id"] for line in run.stdout.splitlines()] == named, f"describe: {run.stdout}{run.stderr}")
    run = mdm("judge", path, "--all-sheets", "--spec", "astm-c33-fine", "--format", "json")
    check([sample["id"] for sample in json.loads(run.stdout)["samples"]] == named, f"judge: {run.stdout}{run.stderr}")
    run = mdm("report", path, FORMATS.parent / "athabasca-sand.csv", "--all-sheets", "--format", "json")
    ids = [sample["id"] for sample in json.loads(run.stdout)["descriptions"]]
    check(ids == [*named, "athabasca-sand"], f"report: {ids}{run.stderr}")
    site = FORMATS / "site.ags"
    run = mdm("describe", site, "--all-sheets", "--format", "json")
    check(len(run.stdout.splitlines()) > 1, f"specimens: {run.stdout}{run.stderr}")
    run = mdm("describe", path, "--all-sheets", "--sheet", "Remarks")
    check(run.returncode == 2 and "--all-sheets reads all: leave out --sheet" in run.stderr, f"--sheet: {run.stderr}")


def test_other_sheets_are_named(folder):
    table = cells([["Size (mm)", "Mass (g)"], [2, 0], [1, 3]])
    words = "Other sheets of the workbook are not read: 'Remarks'; --sheet chooses one."
    for rows, more, said in ((table, [], True), (sheet(""), [], False), (table, ["--sheet", "Grain size"], False)):
        run = mdm("solve", workbook_with(folder / "two.xlsx", {"xl/worksheets/sheet2.xml": rows}), *more)
        check(run.returncode == 0 and (words in run.stdout) == said, f"{more}: {run.stdout}{run.stderr}")


def test_hostile_workbooks(folder):
    first = "xl/worksheets/sheet1.xml"
    cases = {
        "bomb": ({first: Repeated(b"<worksheet>", b" " * (1 << 20), 1500)}, "unpacks to more than 64 MiB"),
        "bomb of strings": ({"xl/sharedStrings.xml": Repeated(b"<sst>", b"<si/>" * (1 << 18), 100)}, "more than 64 MiB"),
        "many tags": ({first: sheet("<row r='1'/>" * (2 << 20))}, "more than 1048576 XML tags"),
        "million columns": ({first: sheet("<row r='1'>" + "<c><v>1</v></c>" * 200000 + "</row>")}, "beyond column 16384"),
        "far column": ({first: sheet("<row r='1'><c r='ZZZZ1'><v>1</v></c></row>")}, "beyond column 16384"),
        "wide rows": ({first: sheet("".join(f"<row r='{i}'><c r='XFD{i}'><v>1</v></c></row>" for i in range(1, 2000)))},
                      "more than 2097152 cells"),
        "far row": ({first: sheet("<row r='99999999999'/>")}, "not in order"),
        "entities": ({first: '<!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><worksheet>&b;</worksheet>'},
                     "document type (DTD)"),
        "external": ({"xl/workbook.xml": '<!DOCTYPE x SYSTEM "file:///etc/passwd"><workbook/>'}, "document type (DTD)"),
        "no string": ({first: sheet("<row r='1'><c r='A1' t='s'><v>99</v></c></row>")}, "is not in the workbook"),
        "no book": ({"xl/workbook.xml": None}, "is no workbook"),
        "no sheet": ({first: None}, "is not in the workbook"),
        "no XML": ({first: "<worksheet><row>"}, "no sound XML"),
    }
    for name, (replaced, part) in cases.items():
        refused(workbook_with(folder / (name + ".xlsx"), replaced), part)
    whole = (FORMATS / "workbook.xlsx").read_bytes()
    inside = whole.index(b"xl/worksheets/sheet1.xml") + 60
    for name, content in (("cut", whole[:-300]), ("damaged", whole[:inside] + b"xxxxxxxx" + whole[inside + 8:])):
        (folder / (name + ".xlsx")).write_bytes(content)
        refused(folder / (name + ".xlsx"), "workbook")


def test_hostile_texts(folder):
    deep = "<a>" * 500000
    wide = "size (mm);mass (g)\n" + ";".join("1" for _ in range(1000000)) + "\n"
    many = "\t".join("1" for _ in range(999)) + "\n"
    cases = {
        "deep.xml": (deep.encode(), "no sound XML"),
        "lol.xml": (b'<!DOCTYPE l [<!ENTITY a "l">]><Diggs>&a;</Diggs>', "document type (DTD)"),
        "none.xml": (b"<Diggs/>", "no ParticleSizeTest"),
        "wide.csv": (wide.encode(), "1000 cells or more"),
        "cells.csv": ((many * 3000).encode(), "more than 2097152 cells"),
        "cut.csv": ("Siebweite [mm]\tRückstand [g]\n1\t2\n".encode("utf-16")[:-1], "in the middle of a character"),
        "old.xls": (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "Excel 97 to 2003"),
        "page.pdf": (b"%PDF-1.7\n\xb5\xb5", "this is a PDF"),
    }
    for name, (content, part) in cases.items():
        (folder / name).write_bytes(content)
        refused(folder / name, part)


with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    test_workbook()
    test_german_csv()
    test_hydrometer()
    test_instruments()
    test_ground_investigations()
    test_proofs(work)
    test_cells_of_workbooks(work)
    test_sheets_have_ids(work)
    test_a_batch_has_all_written_sheets(work)
    test_a_workbook_is_one_whenever_it_was_saved(work)
    test_all_sheets_are_samples_where_that_is_asked_for(work)
    test_other_sheets_are_named(work)
    test_hidden_rows_are_named(work)
    test_hostile_workbooks(work)
    test_hostile_texts(work)
print("failures:", len(failures))
sys.exit(1 if failures else 0)
