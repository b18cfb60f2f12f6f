#!/usr/bin/python3
"""pages_test.py MDM MDM-CHECK SOURCE: the pages beside the sources show what the programs print, the diagrams are what their
script draws, and the version is the same wherever it stands."""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import textwrap

MDM, MDM_CHECK, SOURCE = (pathlib.Path(name).resolve() for name in sys.argv[1:])


def run(program, *words, cwd):
    return subprocess.run([program, *words], cwd=cwd, check=True, capture_output=True, text=True).stdout


def blocks(page):
    """The indented texts of a page, without their indent."""
    lines, found = page.read_text(encoding="utf-8").split("\n"), []
    inside = False
    for line in lines + ["end"]:
        if line.startswith("    "):
            if not inside:
                found.append([])
            inside = True
            found[-1].append(line)
        elif line or not inside:
            inside = False
        else:
            found[-1].append(line)
    return [textwrap.dedent("\n".join(block)).strip("\n") + "\n" for block in found]


def check_three_classes():
    """The worked example of src/match/README.md."""
    shown = blocks(SOURCE / "src/match/README.md")
    session, tree, verdict = (next(block for block in shown if block.startswith(beginning))
                              for beginning in ("$ cat three.csv\n", "split 1 1\n", "accepted: "))
    cat, solve = session.removeprefix("$ cat three.csv\n").split("$ mdm ")
    command, table = solve.split("\n", 1)
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "three.csv").write_text(cat, encoding="utf-8")
        printed = run(MDM, *shlex.split(command), "--quiet", cwd=folder)
        assert printed.rstrip("\n") == table.rstrip("\n"), printed
        proof = pathlib.Path(folder, "three.proof").read_text(encoding="utf-8")
        assert proof.endswith("\n" + tree), proof
        assert run(MDM_CHECK, "three.csv", "three.proof", cwd=folder) == verdict


def check_diagrams():
    """The pictures of src/packing/README.md, byte for byte, and no other."""
    script = SOURCE / "src/packing/diagrams/draw.py"
    with tempfile.TemporaryDirectory() as folder:
        run(sys.executable, "-B", script, folder, cwd=folder)
        drawn = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
    kept = {path.name: path.read_bytes() for path in script.parent.glob("*.svg")}
    assert drawn == kept, f"draw.py writes {sorted(drawn)}: {sorted(kept)} differ: python3 {script} {script.parent}"
    page = (SOURCE / "src/packing/README.md").read_text(encoding="utf-8")
    for name in drawn:
        assert f"diagrams/{name}" in page, name


def check_versions():
    """The version of CMakeLists.txt is that of all others."""
    places = {"CMakeLists.txt": r"project\(mdm VERSION ([\d.]+)", "CITATION.cff": r"^version: ([\d.]+)$",
              "CHANGELOG.md": r"^## ([\d.]+)$", "src/web/package.json": r'"version": "([\d.]+)"',
              "src/web/package-lock.json": r'"version": "([\d.]+)"',
              "src/cmake/debian/changelog": r"\Aexactmdm \(([\d.]+)-\d+\)"}
    found = {place: re.search(pattern, (SOURCE / place).read_text(encoding="utf-8"), re.MULTILINE)[1]
             for place, pattern in places.items()}
    assert len(set(found.values())) == 1, found
    assert run(MDM, "--version", cwd=SOURCE).split()[1] == found["CMakeLists.txt"]


check_three_classes()
check_diagrams()
check_versions()
