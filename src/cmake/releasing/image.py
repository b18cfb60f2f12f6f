"""The image for containers: the programs for Linux, and nothing that they do not need.

It has the folder of the archive for Linux as /exactmdm, the files of the C library that the programs need where the linker
looks for them, and the folder /data, in which commands run. There is no shell and no other program in it.
"""
import shutil
import time as clock

from . import libraries, linux, oci_layout

ARCHITECTURES = {"x86_64": "amd64", "aarch64": "arm64"}  # where the image's name for a machine is another one


def add_file(path, root):
    """A file of this machine, where it is here."""
    target = root / path.relative_to("/")
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, target)


def add_c_library(root):
    """The linker and the libraries that the folder of programs does not have, and what is said of their licences."""
    programs = sorted((root / "exactmdm/bin").iterdir())
    linkers = {libraries.linker(program) for program in programs}
    shared = [path for path in libraries.shared_libraries(programs).values() if not path.is_relative_to(root)]
    for path in {*linkers, *shared}:
        add_file(path, root)
    for package in set(libraries.packages_of(shared).values()):
        linux.copy_licenses(package, root / "exactmdm/licenses")


def configuration(machine, time):
    created = clock.strftime("%Y-%m-%dT%H:%M:%SZ", clock.gmtime(time))
    return {"created": created, "architecture": ARCHITECTURES.get(machine, machine), "os": "linux",
            "config": {"Env": ["PATH=/exactmdm/bin"], "WorkingDir": "/data", "Cmd": ["mdm", "--help"]},
            "history": [{"created": created, "created_by": "src/cmake/release"}]}


def make_image(carried, version, dist, work, time):
    """Makes the image in the folder `dist`. \\param carried the folder that the archive for Linux holds"""
    root = work / "root"
    shutil.copytree(carried, root / "exactmdm")
    (root / "data").mkdir()
    add_c_library(root)
    machine = carried.name.rpartition("-")[2]
    oci_layout.write(dist / f"{carried.name}.oci.tar", root, f"exactmdm:{version}", configuration(machine, time), time)
