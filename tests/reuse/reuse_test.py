#!/usr/bin/python3
"""reuse_test.py SOURCE: every file has an owner and a licence, as the REUSE Specification asks for.

SOURCE is a clone of the project. What is said of its files stands in .reuse/dep5, the texts of the licences are LICENSE
and those of .reuse; `reuse lint` looks for texts in a folder LICENSES, which a copy of the project is given. Exits with
77 where reuse is missing or SOURCE is no clone.
"""

import fnmatch
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()
DEP5 = (SOURCE / ".reuse/dep5").read_text(encoding="utf-8")


def skip_without(what):
    print(f"there is no {what}")
    sys.exit(77)


def files_of_project():
    listed = subprocess.run(["git", "-C", SOURCE, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout
    return [name for name in listed.split("\0") if name and (SOURCE / name).exists()]


def copied(names, folder):
    """The project in a folder, with the texts of its licences where reuse looks for them."""
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(SOURCE / name, folder / name)
    (folder / "LICENSES").mkdir()
    shutil.copy(SOURCE / "LICENSE", folder / "LICENSES/Apache-2.0.txt")
    for text in (SOURCE / ".reuse").glob("LicenseRef-*.txt"):
        shutil.copy(text, folder / "LICENSES")


def lint(folder):
    return subprocess.run(["reuse", "lint"], cwd=folder, capture_output=True, text=True)


def check_lint(names):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        copied(names, folder)
        passed = lint(folder)
        assert passed.returncode == 0, passed.stdout
        # A file that says another licence of itself has its text missing.
        (folder / "strange.txt").write_text("SPDX-" "License-Identifier: MIT\n", encoding="utf-8")
        refused = lint(folder)
        assert refused.returncode == 1 and "MIT" in refused.stdout, refused.stdout


def check_patterns(names):
    """What .reuse/dep5 names is there, and all else is under the licence of CITATION.cff."""
    for files in re.findall(r"^Files: (.+\n(?: .+\n)*)", DEP5, re.MULTILINE):
        for pattern in files.split():
            assert fnmatch.filter(names, pattern), pattern
    citation = (SOURCE / "CITATION.cff").read_text(encoding="utf-8")
    cited = re.search(r"^license: (.+)$", citation, re.MULTILINE)[1]
    assert f"Files: *\nCopyright: The exactmdm authors\nLicense: {cited}\n" in DEP5, cited


if not shutil.which("reuse"):
    skip_without("program reuse (Debian: reuse)")
if not (SOURCE / ".git").exists():
    skip_without("clone of the project, which knows its files")
project = files_of_project()
check_patterns(project)
check_lint(project)
