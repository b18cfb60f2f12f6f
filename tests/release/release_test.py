#!/usr/bin/python3
"""release_test.py BUILD SOURCE [--deb]: src/cmake/release of SOURCE's files and of what BUILD has, made twice, in two folders,
at two times, with another umask, time zone and home, has the same bytes; and each thing that is in it is used.

Files that are not committed yet are tested as if they were: the release is that of a copy, which is a clone of its own. With
--deb Debian's packages are made as well, and lintian has no error and no warning. Exits with 77 where a tool is missing,
unless MDM_REQUIRE_TOOLS is set in the environment.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

BUILD, SOURCE = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
DEB = sys.argv[3:] == ["--deb"]
SAND = SOURCE / "examples/gradations/athabasca-sand.csv"
TOOLS = {"git": "git", "npm": "npm", "node": "nodejs", "patchelf": "patchelf", "faketime": "faketime",
         "buildah": "buildah"}
DEBIAN_TOOLS = {"dh": "debhelper", "dh_python3": "dh-python", "lintian": "lintian"}
AUTHOR = {f"GIT_{who}_{what}": value for who in ("AUTHOR", "COMMITTER")
          for what, value in (("NAME", "nobody"), ("EMAIL", "nobody"), ("DATE", "1790000000 +0000"))}

# In a build folder for /usr/local, which has no folder of libraries for each processor.
IN_USR_LOCAL = "pkg-config-unavailable-for-cross-compilation"

PYTHON = """
import sys
import exactmdm as mdm
assert sys.prefix in mdm.__file__ and sys.prefix in mdm.program.program(), mdm.__file__
match = mdm.solve(sys.argv[1])
assert match.check()
print(match.particles)
"""

JAVASCRIPT = """
import { readFileSync } from "node:fs";
import { check, solve } from "exactmdm";
const sand = readFileSync(process.argv[2], "utf8");
const { answer, proof } = await solve(sand, { proof: true });
console.log(answer.particles, (await check(sand, proof)).verdict);
"""


def run(*words, **options):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def skip_without_tools():
    missing = [package for tool, package in {**TOOLS, **(DEBIAN_TOOLS if DEB else {})}.items() if not shutil.which(tool)]
    if missing:
        print("missing, of Debian's packages:", *missing)
        sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)


def copied(folder):
    """SOURCE's files as a clone with one commit."""
    if (SOURCE / ".git").exists():
        names = run("git", "-C", SOURCE, "ls-files", "-z", "-c", "-o", "--exclude-standard").split("\0")
        for name in names:
            if name and (SOURCE / name).exists():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(SOURCE / name, folder / name)
    else:
        shutil.copytree(SOURCE, folder, ignore=shutil.ignore_patterns("build*", "__pycache__"))
    git = ["git", "-C", folder, "-c", "core.hooksPath=/dev/null"]
    run(*git, "init", "-q")
    run(*git, "add", "-A")
    run(*git, "commit", "-q", "-m", "All of it", env={**os.environ, **AUTHOR})
    return folder


def release(clone, dist, **options):
    words = [clone / "src/cmake/release", dist, "--build", BUILD, *(["--deb"] if DEB else [])]
    return subprocess.run(options.pop("before", []) + words, capture_output=True, text=True, **options)


def check_refusals(clone, folder):
    (clone / "README.md").open("a").write("One more line.\n")
    refused = release(clone, folder / "refused")
    assert refused.returncode == 1 and "README.md" in refused.stderr, refused
    run("git", "-C", clone, "checkout", "-q", "README.md")
    (folder / "is there").mkdir()
    refused = release(clone, folder / "is there")
    assert refused.returncode == 1 and "is there" in refused.stderr, refused
    assert not (folder / "refused").exists() and not any((folder / "is there").iterdir())


def check_bytes(one, other):
    names = sorted(path.name for path in one.iterdir())
    assert names == sorted(path.name for path in other.iterdir()), names
    differing = [name for name in names if (one / name).read_bytes() != (other / name).read_bytes()]
    assert not differing, f"made twice, {differing} differ in {one} and {other}"
    return names


def only(folder, pattern):
    found, = folder.glob(pattern)
    return found


def check_source(dist, clone, folder):
    archive, = (path for path in dist.glob("*.tar.xz") if "-linux-" not in path.name)
    shutil.unpack_archive(archive, folder)
    run("diff", "-r", "--exclude=.git", clone, folder / archive.name.removesuffix(".tar.xz"))
    with tarfile.open(archive) as tar:
        assert {(entry.uid, entry.gid, entry.mtime) for entry in tar} == {(0, 0, 1790000000)}


def root_of_glibc(folder, programs):
    """A folder with the files of the C library that the programs need, and nothing else."""
    for program in programs:
        for path in re.findall(r"(/\S+/(?:lib(?:c|m|dl|pthread|rt)|ld-linux[\w-]*)\.so\.\d+)", run("ldd", program)):
            (folder / path[1:]).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, folder / path[1:])


def check_linux(dist, folder):
    """The programs run where there is nothing but the C library and /proc."""
    archive = only(dist, "*-linux-*.tar.xz")
    shutil.unpack_archive(archive, folder)
    name = archive.name.removesuffix(".tar.xz")
    programs = sorted((folder / name / "bin").iterdir())
    assert [program.name for program in programs] == ["mdm", "mdm-check", "mdm-check-verified", "mdm-check-verified-binary"]
    root_of_glibc(folder, programs)
    shutil.copy(SAND, folder / "sand.csv")
    # The linker of the C library asks /proc where a program is. Without rights of root, in a namespace where one has them.
    (folder / "proc").mkdir()
    chroot = ["unshare", "--mount", *([] if os.geteuid() == 0 else ["--map-root-user"]), "sh", "-c",
              'mount --rbind /proc "$0/proc" && exec chroot "$0" "$@"', folder]
    solved = run(*chroot, f"/{name}/bin/mdm", "solve", "/sand.csv", "--proof", "/sand.proof")
    assert "1485 particles" in solved, solved
    for checker in ("mdm-check", "mdm-check-verified", "mdm-check-verified-binary"):
        verdict = run(*chroot, f"/{name}/bin/{checker}", "/sand.csv", "/sand.proof")
        assert verdict.startswith("accepted: N = 1485 "), verdict
    run(*chroot, f"/{name}/bin/mdm", "plot", "/sand.csv", "-o", "/sand.pdf")
    assert (folder / "sand.pdf").read_bytes().startswith(b"%PDF")
    for file in ("LICENSE", "share/exactmdm/exactmdm.html", "share/man/man1/mdm-solve.1", "share/man/man1/mdm-check-verified.1"):
        assert (folder / name / file).exists(), file
    carried = {path.name for path in (folder / name / "lib").iterdir()}
    assert {"libgmp.so.10", "libstdc++.so.6"} <= carried and "libc.so.6" not in carried, carried
    return carried


def check_image(dist, folder):
    """buildah reads the image and runs its programs, which find their files in /data; without rights of root, in a namespace
    where one has them. Storage and isolation are those that need least of the machine."""
    (folder / "data").mkdir(parents=True)
    shutil.copy(SAND, folder / "data/sand.csv")
    before = [] if os.geteuid() == 0 else ["buildah", "unshare"]
    buildah = [*before, "buildah", "--root", folder / "root", "--runroot", folder / "run", "--storage-driver", "vfs"]
    archive = only(dist, "exactmdm-*-linux-*.oci.tar")
    run(*buildah, "pull", "--quiet", f"oci-archive:{archive}")
    container = run(*buildah, "from", "--pull-never", f"exactmdm:{archive.name.split('-')[1]}").strip()
    for words, said in ((["mdm", "solve", "sand.csv", "--proof", "sand.proof"], "sand: 1485 particles: "),
                        (["mdm-check", "sand.csv", "sand.proof"], "accepted: N = 1485 "),
                        (["mdm-check-verified", "sand.csv", "sand.proof"], "accepted: N = 1485 ")):
        printed = run(*buildah, "run", "--isolation", "chroot", "--volume", f"{folder / 'data'}:/data", container, "--", *words)
        assert printed.startswith(said), printed
    image, = json.loads(run(*buildah, "images", "--json"))
    assert image["createdatraw"] == "2026-09-21T14:13:20Z", image


def check_windows(dist, folder):
    """The programs for Windows as they were built, and the licences of what is in them; `windows`, another test, runs them."""
    archive = only(dist, "*-windows-x86_64.zip")
    shutil.unpack_archive(archive, folder)
    inside = folder / archive.stem
    assert [path.name for path in folder.iterdir()] == [inside.name]
    for name in ("mdm.exe", "mdm-check.exe"):
        assert (inside / name).read_bytes() == (BUILD / "windows/bin" / name).read_bytes(), name
    for name in ("LICENSE", "README.md"):
        assert (inside / name).read_bytes() == (SOURCE / name).read_bytes(), name
    licenses = {path.name for path in (inside / "licenses").iterdir()}
    assert {"libgmp10", "libmpfr6", "libz-mingw-w64-dev", "mingw-w64-x86-64-dev", "text-of-LGPL-3"} <= licenses, licenses


def check_bill(dist, carried):
    """Each library of the programs is in the bill, and the bill is of the form that SPDX asks for."""
    bill = json.loads(only(dist, "*.spdx.json").read_text(encoding="utf-8"))
    assert bill["spdxVersion"] == "SPDX-2.3" and bill["creationInfo"]["created"] == "2026-09-21T14:13:20Z", bill["creationInfo"]
    packages = {package["SPDXID"]: package for package in bill["packages"]}
    assert len(packages) == len(bill["packages"])
    assert all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name) for name in packages)
    for relation in bill["relationships"]:
        assert {relation["spdxElementId"], relation["relatedSpdxElement"]} <= {*packages, "SPDXRef-DOCUMENT"}, relation
    linked = {relation["relatedSpdxElement"] for relation in bill["relationships"]}
    assert linked == set(packages)
    named = re.findall(r"lib[\w+.-]+\.so[.\d]*", " ".join(package.get("comment", "") for package in packages.values()))
    needed = run("ldd", BUILD / "bin/mdm", BUILD / "bin/mdm-check", BUILD / "bin/mdm-check-verified",
                 *(BUILD / "python/exactmdm").glob("_core.*so"))
    assert set(re.findall(r"(lib\S+) => /", needed)) | carried <= set(named), named
    installed = run("dpkg-query", "-W", "-f", "${Version}", "libgmp10")
    gmp = packages["SPDXRef-libgmp10-debian"]
    assert gmp["versionInfo"] == installed and gmp["licenseDeclared"] == "GPL-2.0-or-later OR LGPL-3.0-or-later", gmp
    assert any(package["name"].startswith("libboost") for package in packages.values())


def check_python(dist, folder):
    run("/usr/bin/python3", "-m", "venv", folder)
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    wheel = only(dist, "*-manylinux_*.whl")
    run(folder / "bin/pip", "install", "--quiet", "--no-index", "--no-deps", "--disable-pip-version-check", wheel, env=environment)
    assert run(folder / "bin/python", "-c", PYTHON, SAND, env=environment, cwd=folder) == "1485\n"
    licenses = {path.name for path in (folder / "lib").rglob("*.dist-info/LICENSE*")}
    assert {"LICENSE", "LICENSE.libgmp10", "LICENSE.text-of-LGPL-3"} <= licenses, licenses
    with tarfile.open(only(dist, "exactmdm-*.tar.gz")) as sdist:
        names = {entry.name.partition("/")[2] for entry in sdist}
    assert {"pyproject.toml", "setup.py", "exactmdm/__init__.py", "project/CMakeLists.txt", "project/src/cli/main.cpp"} <= names


def check_javascript(dist, folder):
    folder.mkdir()
    (folder / "package.json").write_text("{}\n", encoding="utf-8")
    (folder / "solve.mjs").write_text(JAVASCRIPT, encoding="utf-8")
    run("npm", "install", "--silent", "--offline", "--no-audit", "--no-fund", "--cache", folder / "cache",
        only(dist, "exactmdm-*.tgz").resolve(), cwd=folder)
    printed = run("node", "solve.mjs", SAND, cwd=folder)
    assert printed == "1485 accepted\n", printed


def check_debian(dist):
    """lintian, from its most important to its pedantic words, has no error and no warning."""
    packages = sorted(dist.glob("*.deb"))
    assert [path.name.partition("_")[0] for path in packages] == ["exactmdm", "libexactmdm-dev", "python3-exactmdm"]
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    suppressed = ["--suppress-tags", IN_USR_LOCAL] if "CMAKE_INSTALL_PREFIX:PATH=/usr/local\n" in cache else []
    done = subprocess.run(["lintian", "--pedantic", "--allow-root", "--fail-on", "error,warning", *suppressed, *packages],
                          capture_output=True, text=True)
    print(done.stdout, end="")
    assert done.returncode == 0, done.stderr


def check_all(folder):
    clone = copied(folder / "clone")
    check_refusals(clone, folder)
    other = folder / "in another place"
    run("git", "clone", "-q", clone, other)
    (folder / "home").mkdir()
    for done in (release(clone, folder / "dist", umask=0o022, env={**os.environ, "TZ": "UTC"}),
                 release(other, folder / "again/dist", umask=0o077, before=["faketime", "-f", "+400d"],
                         env={**os.environ, "TZ": "Pacific/Chatham", "LC_ALL": "C", "HOME": str(folder / "home")})):
        assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    dist = folder / "dist"
    print(*check_bytes(dist, folder / "again/dist"), sep="\n")
    run("sha256sum", "-c", "--quiet", "--strict", "SHA256SUMS", cwd=dist)
    listed = {line.split("  ")[1] for line in (dist / "SHA256SUMS").read_text(encoding="utf-8").splitlines()}
    assert listed | {"SHA256SUMS"} == {path.name for path in dist.iterdir()}
    check_source(dist, clone, folder / "source")
    check_bill(dist, check_linux(dist, folder / "root"))
    check_image(dist, folder / "image")
    check_windows(dist, folder / "windows")
    check_python(dist, folder / "venv")
    check_javascript(dist, folder / "npm")
    assert (dist / "exactmdm.html").read_bytes() == (BUILD / "web/exactmdm.html").read_bytes()
    if DEB:
        check_debian(dist)


skip_without_tools()
with tempfile.TemporaryDirectory() as name:
    check_all(pathlib.Path(name))
