"""The module is installed by pip into a virtual environment, and works there."""

import os
import re
import shutil
import subprocess
import sys
import venv
from pathlib import Path

import exactmdm
import pytest
from support import SAND, SOURCE

BUILD = Path(exactmdm.__file__).parents[2]

SCRIPT = """
import sys
import exactmdm as mdm
assert sys.prefix in mdm.__file__ and sys.prefix in mdm.program.program(), mdm.__file__
match = mdm.solve(sys.argv[1])
assert match.check() and match.particles == 1485 and mdm.__version__
print(mdm.generate(beta="1,3", dmin="0.1", ratio=20).particles)
"""

needs_build = pytest.mark.skipif(not (BUILD / "CMakeCache.txt").exists(), reason="the module is none of a build folder")
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}


def project_in(folder):
    """The project's sources, where setuptools leaves files of its own."""
    for name in ("include", "src"):
        shutil.copytree(SOURCE / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "node_modules"))
    for name in ("CMakeLists.txt", "LICENSE"):
        shutil.copy(SOURCE / name, folder)
    return folder / "src/python"


def check_installed(source, folder):
    """pip installs the source without a network; what it would build is there already."""
    venv.create(folder / "venv", system_site_packages=True, with_pip=True)
    python = folder / "venv/bin/python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-index", "--no-deps", source],
                   check=True, env={**ENVIRONMENT, "EXACTMDM_BUILD": str(BUILD)})
    done = subprocess.run([python, "-c", SCRIPT, SAND], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 0 and sys.version_info >= (3, 11)


@needs_build
def test_pip_installs_the_module(tmp_path):
    pytest.importorskip("setuptools")
    check_installed(project_in(tmp_path), tmp_path)


@needs_build
def test_pip_installs_an_archive_of_sources(tmp_path):
    pytest.importorskip("setuptools")
    (tmp_path / "project").mkdir()
    folder = project_in(tmp_path / "project")
    subprocess.run([sys.executable, "setup.py", "-q", "sdist", "-d", tmp_path], cwd=folder, env=ENVIRONMENT, check=True)
    archive, = tmp_path.glob("exactmdm-*.tar.gz")
    shutil.rmtree(tmp_path / "project")
    check_installed(archive, tmp_path)
    # All that CMake builds the module of is in it.
    shutil.unpack_archive(archive, tmp_path / "unpacked")
    source, = (tmp_path / "unpacked").glob("exactmdm-*/project")
    subprocess.run(["cmake", "-S", source, "-B", tmp_path / "build", "-G", "Ninja", "-D", "MDM_PYTHON=ON", "-D",
                    "MDM_TESTS=OFF", "-D", "MDM_BENCHMARKS=OFF"], check=True, stdout=subprocess.DEVNULL)


LOADED = """
import bz2, decimal, hashlib, json, lzma, sys, typing  # with what they need
def loaded():
    return {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line and "/lib-dynload/" not in line}
before = loaded()
import exactmdm as mdm
assert mdm.solve(sys.argv[1]).particles == 1485
print(*sorted(loaded() - before), sep="\\n")
"""


@needs_build
def test_a_wheel_with_its_libraries_needs_none_of_the_system(tmp_path):
    pytest.importorskip("setuptools")
    if not shutil.which("patchelf") and not os.environ.get("MDM_REQUIRE_TOOLS"):
        pytest.skip("patchelf is not there")
    (tmp_path / "project").mkdir()
    subprocess.run([sys.executable, "setup.py", "-q", "bdist_wheel", "-d", tmp_path], cwd=project_in(tmp_path / "project"),
                   env={**ENVIRONMENT, "EXACTMDM_BUILD": str(BUILD), "EXACTMDM_LIBRARIES": "1"}, check=True)
    wheel, = tmp_path.glob("exactmdm-*-manylinux_*.whl")
    installed = tmp_path / "installed"
    shutil.unpack_archive(wheel, installed, "zip")
    own = installed / "exactmdm"
    (own / "bin/mdm").chmod(0o755)
    done = subprocess.run([sys.executable, "-c", LOADED, SAND], env={**ENVIRONMENT, "PYTHONPATH": str(installed)},
                          stdout=subprocess.PIPE, text=True, check=True)
    of_program = subprocess.run(["ldd", own / "bin/mdm"], stdout=subprocess.PIPE, text=True, check=True).stdout
    libraries = {*done.stdout.split(), *re.findall("=> (/[^ ]+)", of_program)}
    of_others = {Path(path).name.split(".so")[0] for path in libraries if not Path(path).resolve().is_relative_to(own)}
    assert of_others <= {"libc", "libm", "libpthread", "libstdc++", "libgcc_s"}
    assert any(Path(path).name.startswith("libgmp.so") for path in libraries)
