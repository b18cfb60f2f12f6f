#!/usr/bin/python3
"""recipes_test.py BIN SOURCE: the recipes of SOURCE/src/cmake/recipes are those of their table, which has the packages
and versions of the build; they are written in their languages; and what they try, the programs in BIN do.

Says which recipes were not parsed, where python3-yaml, Ruby or Nix is missing.
"""

import ast
import csv
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap

try:
    import yaml
except ImportError:
    yaml = None

BIN, SOURCE = (pathlib.Path(name).resolve() for name in sys.argv[1:])
FOLDER = SOURCE / "src/cmake/recipes"
NAMES = ("recipe.yaml", "package.py", "exactmdm.rb", "package.nix")
MADE = {name: (FOLDER / name).read_text(encoding="utf-8") for name in NAMES}
TABLE = list(csv.DictReader((FOLDER / "dependencies.csv").read_text(encoding="utf-8").splitlines()))
CMAKE = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")


def make(*words):
    return subprocess.run([FOLDER / "make_recipes", *words], capture_output=True, text=True)


def check_written():
    """The recipes are what the script writes, byte for byte, and --check knows one that is not."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        assert make(folder).returncode == 0
        written = {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir()}
        assert written == MADE, "the recipes are not those of the table: src/cmake/recipes/make_recipes writes them"
        assert make("--check", folder).returncode == 0
        for damaged in NAMES:
            (folder / damaged).write_text(MADE[damaged].replace("0.1", "0.2", 1), encoding="utf-8")
            refused = make("--check", folder)
            assert refused.returncode == 1 and damaged in refused.stderr, refused
            (folder / damaged).unlink()
            assert make("--check", folder).returncode == 1
            make(folder)


def check_source():
    """The source of a release stands where the words for it did; half of it, or what is none, is refused."""
    url, digest = "https://example.org/exactmdm.tar.gz", "0123456789abcdef" * 4
    with tempfile.TemporaryDirectory() as folder:
        assert make("--source-url", url, "--sha256", digest, folder).returncode == 0
        for name, text in MADE.items():
            expected = text.replace("@SOURCE_URL@", url).replace("@SHA256@", digest)
            assert expected.count(url) == expected.count(digest) == 1, name
            assert (pathlib.Path(folder) / name).read_text(encoding="utf-8") == expected, name
        for words in (["--source-url", url], ["--sha256", digest], ["--source-url", url, "--sha256", digest[1:]],
                      ["--source-url", url + '"', "--sha256", digest], ["--source-url", "", "--sha256", digest]):
            assert make(*words, folder).returncode == 2, words


def packages_of_cmake():
    """The least version that CMakeLists.txt asks of each Debian package, empty where it asks of none."""
    asked = {"cmake": re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", CMAKE)[1]}
    for version, packages in re.findall(r"mdm_find_package\(\w+ ?([\d.]*)[^()]* DEBIAN ([^()]+)\)", CMAKE):
        asked.update({package: version for package in packages.split()})
    return asked


def check_debian_names():
    """The table has Debian's packages of the build, and those of the Python module, and no other."""
    script = (SOURCE / "src/cmake/debian_packages").read_text(encoding="utf-8")
    build, everything = (set(re.search(rf'^{name}="([^"]+)"', script, re.MULTILINE)[1].split())
                         for name in ("build", "all"))
    python = {row["debian"] for row in TABLE if row["use"] == "python"}
    others = [row["debian"] for row in TABLE if row["use"] != "python"]
    assert len(others) == len(set(others)), others
    assert set(others) == build | {"libflint-arb-dev"}, set(others) ^ (build | {"libflint-arb-dev"})
    # g++ is there wherever Debian builds packages.
    control = (SOURCE / "src/cmake/debian/control").read_text(encoding="utf-8")
    needed = re.search(r"^Build-Depends: (.*\n(?: .*\n)*)", control, re.MULTILINE)[1]
    assert set(others) - {"g++", "catch2", "libbenchmark-dev"} | python <= set(re.findall(r"[a-z][\w.+-]+", needed)), needed
    of_cmake = re.search(r"if\(MDM_PYTHON\)\n(.*?)\nendif\(\)", CMAKE, re.DOTALL)[1]
    assert python == set(re.findall(r"DEBIAN (\S+)\)", of_cmake)) <= everything, python


def check_versions():
    """Least versions are those of CMakeLists.txt; that of FLINT is of FindArb.cmake, that of Python of its package."""
    asked = packages_of_cmake()
    assert "From FLINT 3 on Arb is part of FLINT" in (SOURCE / "src/cmake/FindArb.cmake").read_text(encoding="utf-8")
    asked["libflint-dev"] = "3"
    pyproject = (SOURCE / "src/python/pyproject.toml").read_text(encoding="utf-8")
    asked["python3-dev"] = re.search(r'requires-python = ">=([\d.]+)"', pyproject)[1]
    for row in TABLE:
        assert row["version"] == asked.get(row["debian"], ""), row
    version = re.search(r"project\(mdm VERSION ([\d.]+)", CMAKE)[1]
    for name, text in MADE.items():
        assert re.findall(r'\bversion(?: = |: | |\()"([\d.]+)"', text) == [version], name
    check_changelog(version)


def check_changelog(version):
    """Debian's changelog begins with the version, in lines that lintian does not find too long."""
    lines = (SOURCE / "src/cmake/debian/changelog").read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith(f"exactmdm ({version}-1) "), lines[0]
    assert all(len(line) <= 80 for line in lines), max(lines, key=len)


def spack_packages():
    return {call.args[0].value for call in ast.walk(ast.parse(MADE["package.py"]))
            if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "depends_on"}


def check_dependencies():
    """Each recipe asks for what the table has for it, in the versions of the table where several can be had."""
    def column(manager, version="", uses=("build", "link", "headers", "optional")):
        return {row[manager] + (version.format(row["version"]) if row["version"] else "")
                for row in TABLE if row[manager] and row["use"] in uses}

    all_uses = ("build", "link", "headers", "optional", "python")
    sections = re.findall(r"  (?:build|host):\n((?:    - .*\n)+)", MADE["recipe.yaml"])
    assert len(sections) == 2
    conda = {line for section in sections for line in re.findall(r"- ([^$\n]+)\n", section)}
    assert conda == column("conda-forge", " >={}", all_uses), conda
    assert spack_packages() == column("spack", "@{}:", all_uses), spack_packages()
    assert set(re.findall(r'depends_on "([^"]+)"', MADE["exactmdm.rb"])) == column("homebrew")
    arguments, *inputs = re.findall(r"[{[]\n((?:  +\w+,?\n)+) *[}\]]", MADE["package.nix"])
    inputs = set("".join(inputs).split())
    assert inputs == set(arguments.replace(",", "").split()) - {"lib", "stdenv", "fetchurl"}, inputs
    assert inputs == column("nix"), inputs


def check_languages():
    """Each recipe is read by what reads its language."""
    ast.parse(MADE["package.py"])
    if yaml:
        assert yaml.safe_load(MADE["recipe.yaml"])["schema_version"] == 1
    else:
        print("recipe.yaml was not parsed: there is no python3-yaml")
    for program, option, name in (("ruby", "-c", "exactmdm.rb"), ("nix-instantiate", "--parse", "package.nix")):
        if shutil.which(program):
            subprocess.run([program, option, FOLDER / name], check=True, stdout=subprocess.DEVNULL)
        else:
            print(f"{name} was not parsed: there is no {program}")


def check_what_is_tried():
    """The commands by which recipes try what is installed pass with the programs, and fail without them."""
    lines = re.search(r"  - script:\n((?:      - .*\n)+)", MADE["recipe.yaml"])[1].replace("      - ", "")
    of_nix = re.search(r"    PATH=[^\n]*\n(.*?)    runHook", MADE["package.nix"], re.DOTALL)[1]
    assert lines == textwrap.dedent(of_nix), of_nix
    for path, expected in ((f"{BIN}:/usr/bin:/bin", 0), ("/usr/bin:/bin", 1)):
        with tempfile.TemporaryDirectory() as folder:
            tried = subprocess.run(["bash", "-c", lines], cwd=folder, env={"PATH": path}, capture_output=True)
            assert tried.returncode == expected, tried
    gradation, verdict = re.search(r"printf '(.*)' >", lines)[1], re.search(r"grep '(.*)'", lines)[1]
    for name in ("package.py", "exactmdm.rb"):
        assert f'"{gradation}"' in MADE[name] and f'"{verdict}"' in MADE[name], name


check_written()
check_source()
check_debian_names()
check_versions()
check_dependencies()
check_languages()
check_what_is_tried()
