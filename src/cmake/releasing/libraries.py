"""The libraries that programs need, and the Debian packages that they are of."""
import dataclasses
import os
import pathlib
import re
import subprocess
import sys


@dataclasses.dataclass(frozen=True, order=True)
class Package:
    """A Debian package that is installed."""
    name: str
    version: str
    architecture: str
    source: str

    def copyright_file(self):
        return pathlib.Path("/usr/share/doc", self.name, "copyright")


def told(*words, **options):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def shared_libraries(programs):
    """The paths of all shared libraries that the programs need, by the names that they call them."""
    found = {}
    # What is loaded into every program is none of its libraries.
    environment = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
    for program in programs:
        printed = told("ldd", program, env=environment)
        if "not found" in printed:
            sys.exit(f"release: {program} lacks libraries:\n{printed}")
        found.update((name, pathlib.Path(path)) for name, path in re.findall(r"(\S+) => (/\S+)", printed))
    return dict(sorted(found.items()))


def linker(program):
    """The path of the linker that a program names."""
    return pathlib.Path(told("patchelf", "--print-interpreter", program).strip())


def names_of(path):
    """The file's names on a merged /usr: dpkg knows it by the one or by the other."""
    path = path.resolve()
    inside = path.relative_to("/usr") if path.is_relative_to("/usr") else path.relative_to("/")
    return [f"/{inside}", f"/usr/{inside}"]


def packages_of(paths):
    """The package that each file is of."""
    files = {name: path for path in paths for name in names_of(path)}
    asked = subprocess.run(["dpkg-query", "-S", *files], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    owners = {files[name]: owner for owner, name in re.findall(r"^([^ ,]+): (/.*)$", asked.stdout, re.MULTILINE)}
    missing = [str(path) for path in files.values() if path not in owners]
    if missing:
        sys.exit(f"release: {missing[0]} is of no Debian package: a release is made of Debian's libraries")
    form = "${binary:Package}\t${Package}\t${Version}\t${Architecture}\t${source:Package}\n"
    shown = told("dpkg-query", "-W", "-f", form, *set(owners.values()))
    packages = {words[0]: Package(*words[1:]) for words in (line.split("\t") for line in shown.splitlines())}
    return {path: packages[owner] for path, owner in owners.items()}


def is_of_glibc(package):
    return package.source == "glibc"
