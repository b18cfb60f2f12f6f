#!/usr/bin/python3
"""man_test.py MDM FOLDER: each command of the program MDM has a page in FOLDER with all of its --help; groff takes it.

Exits with 77 where groff is missing, unless MDM_REQUIRE_TOOLS is set in the environment.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

MDM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])

if shutil.which("groff") is None:
    print("groff is not installed (Debian: groff-base)")
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)


def help_of(*command):
    return subprocess.run([MDM, *command, "--help"], capture_output=True, text=True, check=True).stdout


def words_of(page):
    """The words of a page as it is read, without its formatting."""
    groff = ["groff", "-man", "-ww", "-Tascii", "-P-cbou", "-rLL=2000n", page]
    shown = subprocess.run(groff, capture_output=True, text=True)
    return shown.stdout.split(), shown.stderr


def main():
    failures = []
    commands = re.findall(r"^  ([a-z]+) ", help_of().split("Subcommands:")[1].split("\n\n")[0], re.MULTILINE)
    helps = {"mdm": help_of(), **{f"mdm-{command}": help_of(command) for command in commands}}
    pages = {path.stem: path for path in FOLDER.glob("*.1")}
    if set(pages) != set(helps) | {"mdm-check"}:
        failures.append(f"pages {sorted(pages)}, but commands {sorted(helps)}")
    for name, page in pages.items():
        words, complaints = words_of(page)
        if complaints:
            failures.append(f"{page}: {complaints}")
        if not {"NAME", "SYNOPSIS", "EXAMPLES", "ALSO"} <= set(words):
            failures.append(f"{page}: a part is missing")
        body = re.sub(r"^[A-Z][a-z ]*:$", "", helps.get(name, "").partition("Usage:")[2], flags=re.MULTILINE)
        for word in body.split():
            if word not in words:
                failures.append(f"{page}: {word} of --help is missing")
    print(f"{len(pages)} pages, {len(failures)} failures", *failures, sep="\n")
    return 1 if failures else 0


sys.exit(main())
