"""The archive for any Linux whose C library is glibc, as new as that of the machine that it is made on.

bin has the programs, lib the shared libraries that they need and that are not glibc's. They are found by paths relative
to the programs, and where these are the linker learns from /proc. licenses has what Debian says of each of these libraries,
and the licences that it names. What `mdm solve --coq` names is not here: Coq's development is in the source archive.
"""
import pathlib
import re
import shutil
import subprocess

from . import archives, libraries

PROGRAMS = ("mdm", "mdm-check", "mdm-check-verified", "mdm-check-verified-binary")
COMMON_LICENSES = pathlib.Path("/usr/share/common-licenses")


def run(*words):
    subprocess.run(words, check=True)


def install_programs(build, source, folder):
    """The programs and what is shared with the packages, without the development of Coq and the site."""
    run("cmake", "--install", build, "--prefix", folder / "all", "--component", "programs")
    (folder / "bin").mkdir()
    for name in PROGRAMS:
        shutil.copy(folder / "all/bin" / name, folder / "bin")
        run("strip", folder / "bin" / name)
    shutil.move(folder / "all/share", folder / "share")
    for left_out in ("all", "share/doc", "share/exactmdm/coq"):
        shutil.rmtree(folder / left_out)
    shutil.copy(source / "LICENSE", folder)


def copy_licenses(package, folder):
    """What Debian says of the package's licences, and those whose text it has in another place; where its sources are."""
    text = package.copyright_file().read_text(encoding="utf-8", errors="replace")
    note = f"Debian's package {package.name} {package.version}, of its source package {package.source}.\n\n"
    (folder / package.name).write_text(note + text, encoding="utf-8")
    for name in set(re.findall(r"/usr/share/common-licenses/([A-Z][\w.-]*\w)", text)):
        if (COMMON_LICENSES / name).exists():
            shutil.copy(COMMON_LICENSES / name, folder / f"text-of-{name}")


def carry_libraries(folder):
    """Copies the libraries that are not glibc's, with what is said of their licences."""
    programs = sorted((folder / "bin").iterdir())
    (folder / "lib").mkdir()
    (folder / "licenses").mkdir()
    shared = libraries.shared_libraries(programs)
    packages = libraries.packages_of(shared.values())
    for name, path in shared.items():
        package = packages[path]
        if libraries.is_of_glibc(package):
            continue
        shutil.copy(path, folder / "lib" / name)
        copy_licenses(package, folder / "licenses")
        # RPATH, and not RUNPATH: it also holds for what a library needs.
        run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN", folder / "lib" / name)
    for program in programs:
        run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/../lib", program)


def make_archive(build, source, version, dist, work, time):
    """Makes the archive in the folder `dist`; returns the folder that it holds."""
    machine = subprocess.run(["uname", "-m"], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    folder = pathlib.Path(work, f"exactmdm-{version}-linux-{machine}")
    folder.mkdir(parents=True)
    install_programs(build, source, folder)
    carry_libraries(folder)
    archives.pack(folder, dist / f"{folder.name}.tar.xz", time)
    return folder
