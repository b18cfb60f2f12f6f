"""Builds the extension and the program beside it with CMake; pyproject.toml has the rest.

EXACTMDM_BUILD may name a build folder that was configured with MDM_PYTHON: it is taken as it is.
EXACTMDM_LIBRARIES=1 puts the shared libraries that they need into the wheel, so that it runs where those are not installed;
that needs ldd and patchelf.
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
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
#: The project of CMake: around this folder, or in an archive of sources within it.
SOURCE = HERE / "project" if (HERE / "project").is_dir() else HERE.parents[1]
with_libraries = os.environ.get("EXACTMDM_LIBRARIES") == "1"
#: Of the C library and of g++; Python itself needs them, or the package manager.
ON_EVERY_LINUX = r"(lib(c|m|dl|rt|pthread|util|stdc\+\+|gcc_s)|ld-linux.*)\.so"


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


def needed_libraries(file):
    """The shared libraries that a file needs, in paths, but those that every Linux with Python has."""
    # What is loaded into every program is none of its libraries.
    environment = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
    printed = subprocess.run(["ldd", file], stdout=subprocess.PIPE, text=True, check=True, env=environment).stdout
    if "not found" in printed:
        sys.exit(f"{file} lacks libraries:\n{printed}")
    found = (Path(path) for path in re.findall(r"=> (/\S+)", printed))
    return [path for path in found if not re.match(ON_EVERY_LINUX, path.name)]


def bundle(package, files):
    """Copies what the files need into the package's folder libraries, where they and the libraries themselves look for it."""
    folder = package / "libraries"
    folder.mkdir(exist_ok=True)
    for library in {path for file in files for path in needed_libraries(file)}:
        shutil.copy(library, folder)
    for file in [*files, *folder.iterdir()]:
        way = os.path.relpath(folder, file.parent)
        # RPATH, and not RUNPATH: it also holds for what a library of the folder needs.
        subprocess.run(["patchelf", "--force-rpath", "--set-rpath", f"$ORIGIN/{way}", file], check=True)


class WheelForEveryLinux(bdist_wheel):
    """A wheel with its libraries runs with the C library that it was built with, and later ones."""

    def get_tag(self):
        *python, platform = super().get_tag()
        if not with_libraries:
            return *python, platform
        major, minor = os.confstr("CS_GNU_LIBC_VERSION").split()[1].split(".")[:2]
        return *python, platform.replace("linux_", f"manylinux_{major}_{minor}_")


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
        if with_libraries:
            bundle(target.parent, [target, target.parent / "bin/mdm"])


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


setup(version=version(), ext_modules=[Extension("exactmdm._core", [])],
      cmdclass={"build_ext": BuildWithCMake, "bdist_wheel": WheelForEveryLinux, "sdist": SdistWithProject})
