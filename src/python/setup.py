"""Builds the extension and the program beside it with CMake; pyproject.toml has the rest.

EXACTMDM_BUILD may name a build folder that was configured with MDM_PYTHON: it is taken as it is.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = Path(__file__).resolve().parent
#: The project of CMake: around this folder, or in an archive of sources within it.
SOURCE = HERE / "project" if (HERE / "project").is_dir() else HERE.parents[1]


def version():
    """That of the project."""
    return re.search(r"project\(mdm VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


def compile_in(build):
    """Makes the extension and the program in a folder of their own."""
    options = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON", "MDM_TESTS": "OFF", "MDM_BENCHMARKS": "OFF",
               "MDM_PYTHON": "ON", "Python_EXECUTABLE": sys.executable}
    definitions = [f"-D{name}={value}" for name, value in options.items()]
    subprocess.run(["cmake", "-S", SOURCE, "-B", build, "-G", "Ninja", *definitions], check=True)
    subprocess.run(["cmake", "--build", build, "-t", "mdm-python-package", "-j", str(os.cpu_count())], check=True)


class BuildWithCMake(build_ext):
    """The extension is a target of the project."""

    def build_extension(self, ext):
        build = Path(os.environ.get("EXACTMDM_BUILD") or self.build_temp).resolve()
        if "EXACTMDM_BUILD" not in os.environ:
            compile_in(build)
        target = Path(self.get_ext_fullpath(ext.name)).resolve()
        (target.parent / "bin").mkdir(parents=True, exist_ok=True)
        made, = (build / "python/exactmdm").glob("_core.*so")
        shutil.copy(made, target)
        shutil.copy(build / "bin/mdm", target.parent / "bin/mdm")


class SdistWithProject(sdist):
    """An archive of sources has what CMake needs, too."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        project = Path(base_dir, "project")
        no_sources = shutil.ignore_patterns(Path(base_dir).name, "__pycache__", "*.egg-info", "build", "dist", "node_modules")
        for folder in ("include", "src"):
            shutil.copytree(SOURCE / folder, project / folder, ignore=no_sources)
        for file in ("CMakeLists.txt", "LICENSE"):
            shutil.copy(SOURCE / file, project)


setup(version=version(), ext_modules=[Extension("exactmdm._core", [])], cmdclass={"build_ext": BuildWithCMake, "sdist": SdistWithProject})
