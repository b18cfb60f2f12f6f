"""What is linked into the programs and modules of a release, as a document of SPDX 2.3 in JSON.

Versions and licences are what this machine's packages say of themselves. A licence that Debian's copyright file does
not state for all files, or by a name that has no certain counterpart among those of SPDX, is NOASSERTION.
"""
import datetime
import json
import pathlib
import re
import urllib.parse

from . import libraries, linux, windows

NAMES = {"Apache-2.0": "Apache-2.0", "BSD-3-clause": "BSD-3-Clause", "BSL-1.0": "BSL-1.0", "Expat": "MIT", "FTL": "FTL",
         "GPL-2": "GPL-2.0-only", "GPL-2+": "GPL-2.0-or-later", "LGPL-2.1+": "LGPL-2.1-or-later",
         "LGPL-3+": "LGPL-3.0-or-later", "MIT": "MIT", "Zlib": "Zlib"}

# What is compiled into the programs and modules, by a file of its package.
COMPILED_IN = {
    "headers, in the programs": ("/usr/include/boost/version.hpp", "/usr/include/nlohmann/json.hpp",
                                 "/usr/include/CLI/CLI.hpp", "/usr/include/fmt/core.h"),
    "headers, in the Python module": ("/usr/include/pybind11/pybind11.h",),
    "the runtime of mdm-check-verified": ("/usr/lib/ocaml/libasmrun.a", "/usr/lib/ocaml/zarith/zarith.a"),
    "the runtime of the JavaScript module and of the page": ("/usr/bin/emcc", "/usr/bin/js_of_ocaml"),
}

# What src/web/libraries has built as WebAssembly, and src/windows/libraries for Windows: the header that says the version, and
# how.
HEADERS = {
    "gmp": ("gmp.h", r"#define __GNU_MP_VERSION +(\d+)\n#define __GNU_MP_VERSION_MINOR +(\d+)\n"
                     r"#define __GNU_MP_VERSION_PATCHLEVEL +(\d+)"),
    "mpfr": ("mpfr.h", r'#define MPFR_VERSION_STRING "([\d.]+)"'),
    "pugixml": ("pugixml.hpp", r"define PUGIXML_VERSION \d+ // ([\d.]+)"),
    "libzip": ("zipconf.h", r'#define LIBZIP_VERSION "([\d.]+)"'),
    "zstd": ("zstd.h", r"#define ZSTD_VERSION_MAJOR +(\d+)\n#define ZSTD_VERSION_MINOR +(\d+)\n"
                       r"#define ZSTD_VERSION_RELEASE +(\d+)"),
}
IN_WEBASSEMBLY = ("gmp", "mpfr", "pugixml")
IN_WINDOWS = tuple(HEADERS)


def license_in_debian(copyright_file):
    """What the file states for `Files: *`; nothing where it is not written so."""
    text = copyright_file.read_text(encoding="utf-8", errors="replace") if copyright_file.exists() else ""
    found = re.search(r"^Files: *\*\n(?:\S.*\n|[ \t].*\n)*?License: *(\S.*)\n", text, re.MULTILINE)
    return found[1].strip() if found else None


def license_in_spdx(debian):
    words = re.split(r" (or|and) ", debian or "")
    if any(name not in NAMES for name in words[::2]):
        return "NOASSERTION"
    return " ".join(NAMES[word] if i % 2 == 0 else word.upper() for i, word in enumerate(words))


def identifier(*words):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", "-".join(words))


def described(name, version, license_name, words, **more):
    return {"SPDXID": identifier(name, *words), "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", "licenseDeclared": license_name,
            "copyrightText": "NOASSERTION", **more}


def debian_package(package, comment):
    """A Debian package; its address is a package URL."""
    stated = license_in_debian(package.copyright_file())
    address = (f"pkg:deb/debian/{urllib.parse.quote(package.name)}@{urllib.parse.quote(package.version)}"
               f"?arch={package.architecture}")
    said = {"licenseComments": f"Debian's copyright file says: {stated}"} if stated else {}
    return described(package.name, package.version, license_in_spdx(stated), ("debian",), comment=comment,
                     sourceInfo=f"Debian's source package {package.source}", **said,
                     externalRefs=[{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                    "referenceLocator": address}])


def shared(programs):
    """The packages of all libraries that the programs need, carried in the archives or not."""
    found = libraries.shared_libraries(programs)
    packages = libraries.packages_of(found.values())
    files = {}
    for name, path in found.items():
        files.setdefault(packages[path], []).append(name)
    return [debian_package(package, f"shared: {', '.join(names)}") for package, names in sorted(files.items())]


def compiled_in():
    comments = {pathlib.Path(path): comment for comment, paths in COMPILED_IN.items() for path in paths}
    comments |= {path: "in the programs for Windows" for path in windows.mingw_files()}
    packages = {package: comments[path] for path, package in libraries.packages_of(comments).items()}
    return [debian_package(package, comment) for package, comment in sorted(packages.items())]


def built_for(machine, variable, names, comment, build):
    """Libraries that the build has made from Debian's sources, in the folder that a variable of its cache names."""
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    headers = pathlib.Path(re.search(rf"^{variable}:PATH=(.*)$", cache, re.MULTILINE)[1], "include")
    found = []
    for name in names:
        header, pattern = HEADERS[name]
        version = re.search(pattern, (headers / header).read_text(encoding="utf-8"))
        found.append(described(name, ".".join(version.groups()), "NOASSERTION", (machine,), comment=comment))
    return found


def in_webassembly(build):
    return built_for("webassembly", "MDM_WEB_LIBRARIES", IN_WEBASSEMBLY, "in the JavaScript module and in the page", build)


def in_windows(build):
    return built_for("windows", "MDM_WINDOWS_LIBRARIES", IN_WINDOWS, "in the programs for Windows", build)


def write(file, version, commit, time, build):
    """Writes what the programs and modules of the build folder are linked with, at the given time."""
    project = described("exactmdm", version, "Apache-2.0", (), sourceInfo=f"commit {commit}")
    programs = [*(build / "bin" / name for name in linux.PROGRAMS), *(build / "python/exactmdm").glob("_core.*so")]
    dynamic, static = shared(programs), compiled_in() + in_webassembly(build) + in_windows(build)

    def relation(kind, one, other):
        return {"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}

    linked = [relation(kind, project["SPDXID"], package["SPDXID"])
              for kind, packages in (("DYNAMIC_LINK", dynamic), ("STATIC_LINK", static)) for package in packages]
    created = datetime.datetime.fromtimestamp(time, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"exactmdm-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/exactmdm-{version}-{commit}",
        "creationInfo": {"created": created, "creators": ["Organization: The exactmdm authors", "Tool: src/cmake/release"]},
        "packages": [project, *dynamic, *static],
        "relationships": [relation("DESCRIBES", "SPDXRef-DOCUMENT", project["SPDXID"]), *linked],
    }
    file.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
