#!/usr/bin/python3
"""rooms_test.py SOURCE: no file includes one of a room below its own in the table of src/README.md.

SOURCE is the top folder of the project. A room is a folder of src and of include/mdm; a file that stands in neither's
folders is a room of its own, by its name without an ending. The table has a row a room, from the bottom of the house's
dependencies up: `| number | ... |`. Nobody includes `cli`, which alone includes CLI11. `checker` includes no room but itself; of it `python` and `cli` alone include the installed
header. What is installed is complete: a header of include/mdm includes none of src, and include/mdm/mdm.hpp includes all others but that of the checker, a library apart.
"""

import os
import pathlib
import re
import sys

SOURCE = pathlib.Path(sys.argv[1]).resolve()

# Includes that go against the table, as (file, included file); each is to go.
EXCEPTIONS = set()

FOLDERS = {SOURCE / "src": "src", SOURCE / "include/mdm": "include/mdm"}
CHECKER = SOURCE / "include/mdm/checker.hpp"
NO_ROOMS = {"precompiled", "mdm"}  # what a whole target includes, and what includes all headers


def rooms_in_order():
    """The rooms that the table names, in its order."""
    table = (SOURCE / "src/README.md").read_text(encoding="utf-8")
    return re.findall(r"^\| `([a-z_0-9]+)` \|", table, re.MULTILINE)


def room_of(path):
    """The room of a file below src or include/mdm; nothing for a file that is in none."""
    for folder in FOLDERS:
        if path.is_relative_to(folder):
            first = path.relative_to(folder).parts[0]
            room = first.partition(".")[0]
            return None if room in NO_ROOMS else room
    return None


def included(path, quote, name):
    """The file that an #include means, or nothing for a file of a library."""
    if quote == '"' and (path.parent / name).exists():
        return pathlib.Path(os.path.normpath(path.parent / name))
    for folder in (SOURCE / "include", SOURCE / "src"):
        if (folder / name).exists():
            return folder / name
    return None


def installed_failures():
    """What keeps the folder of installed headers from being complete by itself."""
    folder = SOURCE / "include/mdm"
    headers = sorted(path.relative_to(folder.parent).as_posix() for path in folder.rglob("*.hpp"))
    failures = []
    for header in headers:
        text = (folder.parent / header).read_text(encoding="utf-8")
        failures += [f"{header} includes {name}, which is not installed"
                     for name in re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.MULTILINE)]
    all_of_them = re.findall(r"#include <(.*)>", (folder / "mdm.hpp").read_text(encoding="utf-8"))
    if all_of_them != [header for header in headers if header not in ("mdm/mdm.hpp", "mdm/checker.hpp")]:
        failures.append("mdm/mdm.hpp does not include all headers beside it, in the order of their names")
    return failures


def main():
    order = rooms_in_order()
    if len(order) != len(set(order)) or "checker" not in order:
        print(f"the table of src/README.md is not understood: {order}")
        return 1
    level = {room: i for i, room in enumerate(order)}
    failures, excepted, includes, found = [], set(), 0, set()
    for folder in FOLDERS:
        for path in sorted(folder.rglob("*.[ch]pp")):
            room = room_of(path)
            if room is None:
                continue
            found.add(room)
            text = path.read_text(encoding="utf-8")
            for quote, name in re.findall(r'^\s*#\s*include\s*(["<])([^">]+)[">]', text, re.MULTILINE):
                if name.startswith("CLI/") and room != "cli":
                    failures.append(f"{path.relative_to(SOURCE)} includes {name}: CLI11 is of cli alone")
                other = included(path, quote, name)
                if other is None or room_of(other) is None:
                    continue
                includes += 1
                what = (str(path.relative_to(SOURCE)), str(other.relative_to(SOURCE)))
                # What the operating system has is of the programs and the module: the library is linked without it.
                of_program = room_of(other) == "cli" or (room_of(other) == "files" and room not in ("cli", "python"))
                apart = room != room_of(other) and ("checker" in (room, room_of(other)) or of_program)
                if room in ("python", "cli") and other == CHECKER:
                    continue
                if not apart and level.get(room_of(other), 0) <= level.get(room, 0):
                    continue
                if what in EXCEPTIONS:
                    excepted.add(what)
                else:
                    failures.append(f"{what[0]} includes {what[1]}: {room} may not use {room_of(other)}")
    failures += installed_failures()
    failures += [f"{room} is no room of src/README.md" for room in sorted(found - set(order))]
    failures += [f"{room} of src/README.md is no folder" for room in order if room not in found]
    failures += [f"no exception any more: {what}" for what in sorted(EXCEPTIONS - excepted)]
    for what in sorted(excepted):
        print("exception:", *what)
    print(f"{includes} includes between {len(found)} rooms, {len(excepted)} exceptions, {len(failures)} failures")
    print(*failures, sep="\n")
    return 1 if failures or includes < 500 else 0


sys.exit(main())
