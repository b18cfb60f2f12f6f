"""The module is installed by pip into a virtual environment, and works there."""

import os
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


@pytest.mark.skipif(not (BUILD / "CMakeCache.txt").exists(), reason="the module is none of a build folder")
def test_pip_installs_the_module(tmp_path):
    pytest.importorskip("setuptools")
    # Where setuptools leaves its own files; the build itself is there already.
    project = tmp_path / "src/python"
    shutil.copytree(SOURCE / "src/python", project)
    shutil.copy(SOURCE / "CMakeLists.txt", tmp_path)
    venv.create(tmp_path / "venv", system_site_packages=True, with_pip=True)
    python = tmp_path / "venv/bin/python"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-index", "--no-deps", project],
                   check=True, env={**environment, "EXACTMDM_BUILD": str(BUILD)})
    done = subprocess.run([python, "-c", SCRIPT, SAND], cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 0 and sys.version_info >= (3, 11)
