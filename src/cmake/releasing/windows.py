"""The archive for Windows on x86-64: the programs, each of which runs alone, and the licences of what is linked into them.

The libraries are built by src/windows/libraries, from the sources of those Debian packages that the programs of this machine
are linked with; what of the compiler is in the programs, and zlib, are Debian's packages for mingw-w64.
"""
import pathlib
import shutil

from . import archives, libraries, linux

PROGRAMS = ("mdm.exe", "mdm-check.exe")
BUILT = {"gmp", "mpfr4", "pugixml", "libzip", "libzstd"}  # source packages
MINGW = pathlib.Path("/usr/x86_64-w64-mingw32/lib")
COMPILER = "x86_64-w64-mingw32-g++-posix"


def built_packages(build):
    """The packages of this machine that are of the same sources as the libraries built for Windows."""
    shared = libraries.shared_libraries([build / "bin/mdm"])
    return sorted(package for package in set(libraries.packages_of(shared.values()).values()) if package.source in BUILT)


def mingw_files():
    """A file of each package for mingw-w64 that is linked into the programs."""
    runtime = libraries.told(COMPILER, "-print-file-name=libstdc++.a").strip()
    return [pathlib.Path(runtime), MINGW / "libmingw32.a", MINGW / "libz.a"]


def mingw_packages():
    return sorted(set(libraries.packages_of(mingw_files()).values()))


def make_archive(build, source, version, dist, work, time):
    """Makes the archive in the folder `dist`."""
    folder = work / f"exactmdm-{version}-windows-x86_64"
    (folder / "licenses").mkdir(parents=True)
    for name in PROGRAMS:
        shutil.copy(build / "windows/bin" / name, folder)
    for name in ("LICENSE", "README.md"):
        shutil.copy(source / name, folder)
    for package in [*built_packages(build), *mingw_packages()]:
        linux.copy_licenses(package, folder / "licenses")
    archives.pack_zip(folder, dist / f"{folder.name}.zip", time)
