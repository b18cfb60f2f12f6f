#!/usr/bin/python3
"""options_test.py TABLE PROGRAM SOURCE: the table of options is what the program and the modules have.

TABLE prints the table in JSON, PROGRAM is mdm, SOURCE the top folder of the project. A row that is added to the table
reaches Python's keywords and JavaScript's types; that it reaches the program is in tests/cli/option_tables_test.cpp.
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
             "verify": ("verifying.py", "verify"), "tradeoff": ("trade.py", "tradeoff"),
             "describe": ("description.py", "describe"), "convert": ("reading.py", "read"),
             "generate": ("program.py", "generate"), "pack": ("program.py", "pack"), "export": ("program.py", "export"),
             "plot": ("program.py", "picture"), "suite": ("suites.py", "suite"), "blend": ("blending.py", "blend")}
#: Functions that take options of `solve` beside their own by any keyword, which they look up in the table.
TAKE_MORE = {"tradeoff"}


def written(table, source, *options):
    return subprocess.run([sys.executable, WRITE, *options, source], input=json.dumps(table), capture_output=True,
                          text=True)


def keywords(source, command):
    """The keywords of a function of the package with their types, and what its docstring explains."""
    file, function = FUNCTIONS[command]
    tree = ast.parse(pathlib.Path(source, "src/python/exactmdm", file).read_text(encoding="utf-8"))
    found = next(node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == function)
    assert (found.args.kwarg is not None) == (command in TAKE_MORE), function
    return {one.arg: ast.unparse(one.annotation) for one in found.args.kwonlyargs}, ast.get_docstring(found)


def members(source, command):
    """The options of an interface of JavaScript with their types; nothing where the module has no such function."""
    text = pathlib.Path(source, "src/web/module/index.d.ts").read_text(encoding="utf-8")
    if f"export function {command}(" not in text:
        assert f"{command.capitalize()}Words" not in text
        return None
    interface = re.search(rf"^export interface {command.capitalize()}Words \{{\n(.*?)^\}}", text, re.M | re.S)[1]
    return dict(re.findall(r"^  (\w+)\?: (.*);$", interface, re.M))


def check_modules(table, source):
    for command, rows in table.items():
        python, explained = keywords(source, command)
        javascript = members(source, command)
        for row in rows:
            assert row["keyword"] in python, (command, row)
            assert re.search(rf"^ *[\w, ()]*\b{row['keyword']}\b[\w, ()]*:", explained, re.M), (command, row)
        if javascript is not None:
            assert list(javascript) == [row["member"] for row in rows], (command, javascript)


def check_program(table):
    """Each row is an option of its command, with its value and its help."""
    for command, rows in table.items():
        told = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True)
        help_text = " ".join(told.stdout.split())
        for row in rows:
            # Its choices, and what it excludes, may stand before its help.
            name = f"--{row['name']} {row['values']}".strip()
            between = "(:{[^}]*})?( [.]{3})?( Excludes: --[a-z-]+)? "
            words = re.escape(name) + between + re.escape(" ".join(row["help"].split()))
            assert re.search(words, help_text), (command, words)


def check_added_row(table, command):
    """One more row is one more keyword and one more member, with their types and their help; one less is refused too."""
    row = {"name": "mystery-gap", "keyword": "mystery_gap", "member": "mysteryGap", "kind": "number", "values": "G",
           "choices": [],
           "help": "a gap beside --at-least (exit 3)"}
    with tempfile.TemporaryDirectory() as folder:
        for part in ("src/python/exactmdm", "src/web/module"):
            shutil.copytree(pathlib.Path(SOURCE, part), pathlib.Path(folder, part))
        added = {**table, command: table[command] + [row]}
        assert written(added, folder, "--check").returncode == 1
        assert written(added, folder).returncode == 0
        assert written(added, folder, "--check").returncode == 0
        check_modules(added, folder)
        python, explained = keywords(folder, command)
        assert python["mystery_gap"] == "Number | None", python
        assert "mystery_gap: a gap beside at_least.\n" in explained, explained
        javascript = members(folder, command)
        if javascript is not None:
            assert javascript["mysteryGap"] == "number | string"
            text = pathlib.Path(folder, "src/web/module/index.d.ts").read_text(encoding="utf-8")
            assert "/** A gap beside atLeast. */" in text
        assert written(table, folder, "--check").returncode == 1
        assert written(table, folder).returncode == 0
        assert "mystery_gap" not in keywords(folder, command)[0]


def main():
    table = json.loads(subprocess.run([TABLE], capture_output=True, check=True).stdout)
    assert sum(map(len, table.values())) > 50
    stale = written(table, SOURCE, "--check")
    assert stale.returncode == 0, stale.stdout + stale.stderr
    check_modules(table, SOURCE)
    check_program(table)
    for command in ("solve", "generate", "pack", "export", "plot"):
        check_added_row(table, command)
    print("the table, the program and the modules agree")


main()
