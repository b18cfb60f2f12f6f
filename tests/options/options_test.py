#!/usr/bin/python3
"""options_test.py TABLE PROGRAM SOURCE: the table of options is what the program and the modules have.

TABLE prints the table in JSON, PROGRAM is mdm, SOURCE the top folder of the project. A row that is added to the table reaches
Python's keywords and JavaScript's types; that it reaches the program is in tests/cli/option_tables_test.cpp.
"""

import ast
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TABLE, PROGRAM, SOURCE = sys.argv[1:]
WRITE = pathlib.Path(SOURCE, "src/ask/write_modules")
FUNCTIONS = {"solve": ("solving.py", "solve"), "crosscheck": ("judging.py", "crosscheck"),
             "verify": ("verifying.py", "verify"),
             "describe": ("description.py", "describe"), "convert": ("reading.py", "read")}


def written(table, source, *options):
    return subprocess.run([sys.executable, WRITE, *options, source], input=json.dumps(table), capture_output=True, text=True)


def keywords(source, command):
    """The keywords of a function of the package with their types, and what its docstring explains."""
    file, function = FUNCTIONS[command]
    tree = ast.parse(pathlib.Path(source, "src/python/exactmdm", file).read_text(encoding="utf-8"))
    found = next(node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == function)
    return {one.arg: ast.unparse(one.annotation) for one in found.args.kwonlyargs}, ast.get_docstring(found)


def members(source, command):
    """The options of an interface of JavaScript with their types."""
    text = pathlib.Path(source, "src/web/module/index.d.ts").read_text(encoding="utf-8")
    interface = re.search(rf"^export interface {command.capitalize()}Words \{{\n(.*?)^\}}", text, re.M | re.S)[1]
    return dict(re.findall(r"^  (\w+)\?: (.*);$", interface, re.M))


def check_modules(table, source):
    for command, rows in table.items():
        python, explained = keywords(source, command)
        javascript = members(source, command)
        for row in rows:
            assert row["keyword"] in python, (command, row)
            assert re.search(rf"^ *[\w, ()]*\b{row['keyword']}\b[\w, ()]*:", explained, re.M), (command, row)
        assert list(javascript) == [row["member"] for row in rows], (command, javascript)


def check_program(table):
    """Each row is an option of its command, with its value and its help."""
    for command, rows in table.items():
        help_text = " ".join(subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout.split())
        for row in rows:
            # What it excludes may stand before its help.
            name = f"--{row['name']} {row['values']}".strip()
            words = re.escape(name) + "( [.]{3})?( Excludes: --[a-z]+)? " + re.escape(" ".join(row["help"].split()))
            assert re.search(words, help_text), (command, words)


def check_added_row(table):
    """One more row is one more keyword and one more member, with their types and their help."""
    row = {"name": "mystery-gap", "keyword": "mystery_gap", "member": "mysteryGap", "kind": "number", "values": "G",
           "help": "a gap beside --at-least (exit 3)"}
    with tempfile.TemporaryDirectory() as folder:
        for part in ("src/python/exactmdm", "src/web/module"):
            shutil.copytree(pathlib.Path(SOURCE, part), pathlib.Path(folder, part))
        added = {**table, "solve": table["solve"] + [row]}
        assert written(added, folder, "--check").returncode == 1
        assert written(added, folder).returncode == 0
        assert written(added, folder, "--check").returncode == 0
        check_modules(added, folder)
        python, explained = keywords(folder, "solve")
        assert python["mystery_gap"] == "Number | None", python
        assert "mystery_gap: a gap beside at_least.\n" in explained, explained
        assert members(folder, "solve")["mysteryGap"] == "number | string"
        text = pathlib.Path(folder, "src/web/module/index.d.ts").read_text(encoding="utf-8")
        assert "/** A gap beside atLeast. */" in text
        assert written(table, folder).returncode == 0
        assert "mystery_gap" not in keywords(folder, "solve")[0]


def main():
    table = json.loads(subprocess.run([TABLE], capture_output=True, check=True).stdout)
    assert sum(map(len, table.values())) > 50
    stale = written(table, SOURCE, "--check")
    assert stale.returncode == 0, stale.stdout + stale.stderr
    check_modules(table, SOURCE)
    check_program(table)
    check_added_row(table)
    print("the table, the program and the modules agree")


main()
