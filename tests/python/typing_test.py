"""Types and stubs are right, and everything that users see is explained."""

import inspect
import os
import subprocess
import sys
from pathlib import Path

import exactmdm as mdm
import pytest

PACKAGE = Path(mdm.__file__).parent


def tool(*arguments, cwd):
    """Runs a Python tool on the package."""
    environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
    return subprocess.run([sys.executable, "-m", *arguments], cwd=cwd, env=environment, capture_output=True, text=True)


def test_mypy_is_content(tmp_path):
    pytest.importorskip("mypy")
    done = tool("mypy", "--strict", "--ignore-missing-imports", "--cache-dir", str(tmp_path), "-p", "exactmdm", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


USES = """
from collections.abc import Iterator
from typing import Union, assert_type
import exactmdm as mdm
assert_type(mdm.batch([]), Iterator[mdm.Match])
assert_type(mdm.batch([], errors="raise", threads=2, tolerance="retained:1%"), Iterator[mdm.Match])
assert_type(mdm.batch([], errors="yield"), Iterator[Union[mdm.Match, mdm.InputError]])
"""


def test_types_of_a_batch_are_those_that_were_asked_for(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "uses.py").write_text(USES)
    done = tool("mypy", "--strict", "--ignore-missing-imports", "--cache-dir", str(tmp_path), "uses.py", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_of_the_extension_are_right(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "mypy.ini").write_text("[mypy]\nignore_missing_imports = True\n")
    # Classes of pybind11 have a metaclass of its own; matches and judges are made by functions alone.
    (tmp_path / "allowed").write_text("exactmdm\\._core\\.[A-Z][A-Za-z]+\nexactmdm\\._core\\.(Match|Judge)\\.__init__\n")
    done = tool("mypy.stubtest", "exactmdm._core", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_package_says_that_it_has_types():
    assert (PACKAGE / "py.typed").exists()


@pytest.mark.parametrize("name", mdm.__all__)
def test_every_name_is_explained(name):
    what = getattr(mdm, name)
    assert inspect.getdoc(what)
    if inspect.isclass(what) and what.__module__.startswith("exactmdm"):
        for member, value in vars(what).items():
            if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member}"
