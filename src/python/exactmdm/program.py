"""What runs the program `mdm` in a process of its own, with exact texts in and out: sets, packings, exports, pictures.

The program is the one beside this module (`exactmdm/bin/mdm`), or else the first on PATH.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Union

from exactmdm.enclosure import Enclosure, enclosure_of
from exactmdm.errors import InputError, LimitReached
from exactmdm.exact import optional_int, text_of
from exactmdm.gradation import Gradation
from exactmdm.match import Match
from exactmdm.value import Value

#: Exit codes of `mdm`.
_BAD_INPUT, _LIMITED = 2, 3

#: What a command reads: a file, or what stands for one.
Source = Union[Gradation, Match, str, "os.PathLike[str]"]


def program() -> str:
    """The path of the program `mdm`. Raises FileNotFoundError if there is none."""
    beside = Path(__file__).with_name("bin") / "mdm"
    found = str(beside) if os.access(beside, os.X_OK) else shutil.which("mdm")
    if found is None:
        raise FileNotFoundError("the program mdm is neither beside this module nor on PATH: install exactmdm")
    return found


def run(command: str, *arguments: str) -> tuple[int, str]:
    """Runs `mdm COMMAND ARGUMENTS`.

    Returns:
        The exit code, 0 or 1 (a negative verdict), and what was written to standard output.

    Raises:
        InputError: exit code 2, with the program's message.
        LimitReached: exit code 3; `known` is the output.
    """
    return _done(command, arguments, None)


def _called(command: str, *arguments: str) -> tuple[int, str]:
    """The same for a function of this package: messages name keywords, `void_ratio`, and no `--void-ratio`."""
    return _done(command, arguments, {**os.environ, "MDM_OPTION_SPELLING": "keyword"})


def _done(command: str, arguments: tuple[str, ...], environment: dict[str, str] | None) -> tuple[int, str]:
    done = subprocess.run([program(), command, *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          encoding="utf-8", errors="replace", env=environment)
    if done.returncode == _BAD_INPUT:
        raise InputError(done.stderr.strip())
    if done.returncode == _LIMITED:
        raise LimitReached(f"a limit was reached: {done.stderr.strip() or 'see known'}", done.stdout)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"mdm {command} ended with {done.returncode}: {done.stderr.strip()}")
    return done.returncode, done.stdout


def flags_of(options: dict[str, Any]) -> list[str]:
    """Keywords as options of the command line: True is a flag, None and False are left out, a list repeats it.

    >>> flags_of({"void_ratio": "0.6", "spread": True, "seed": None, "tolerance": ["1%", "passing:2%"]})
    ['--void-ratio', '0.6', '--spread', '--tolerance', '1%', '--tolerance', 'passing:2%']
    """
    flags: list[str] = []
    for name, value in options.items():
        option = "--" + name.rstrip("_").replace("_", "-")
        if value is True:
            flags.append(option)
        elif value is None or value is False:
            continue
        elif isinstance(value, (list, tuple)):
            flags += [word for one in value for word in (option, _word(one, name))]
        else:
            flags += [option, _word(value, name)]
    return flags


@contextmanager
def file_of(source: Source) -> Iterator[str]:
    """The path of a source; of what is no file a file for a while, in a folder of its own."""
    if isinstance(source, (str, os.PathLike)):
        yield os.fspath(source)
        return
    if not isinstance(source, (Gradation, Match)):
        raise TypeError(f"{type(source).__name__} is no source: give a Gradation, a Match or the path of a file")
    with tempfile.TemporaryDirectory() as folder:
        name = re.sub(r"[^\w.-]", "_", source.id)[:60] or "gradation"
        text = source.json()
        path = Path(folder, f"{name}.json")
        path.write_text(text, encoding="utf-8")
        yield str(path)


class GeneratedSet(Value):
    """A representative set of particles; `generate` makes it."""

    _json: str
    #: True if the set is within what was asked.
    accessible: bool

    @classmethod
    def _of(cls, json: str, accessible: bool) -> GeneratedSet:
        generated = cls.__new__(cls)
        generated._set(_json=json, accessible=accessible)
        return generated

    def __reduce__(self) -> tuple[Any, ...]:
        return GeneratedSet._of, (self._json, self.accessible)

    @cached_property
    def _set_in_json(self) -> dict[str, Any]:
        tree: dict[str, Any] = json.loads(self._json)
        return tree

    @property
    def particles(self) -> int | None:
        """The number of particles, where it is certain."""
        return optional_int(self._set_in_json["particles"])

    @cached_property
    def quantities(self) -> tuple[int | None, ...]:
        """The number of particles in each class, ascending."""
        return tuple(optional_int(c["quantity"]) for c in self._set_in_json["classes"])

    @cached_property
    def sizes(self) -> tuple[Enclosure, ...]:
        """The sizes of all particles, with sizes=True or spread=True; else none."""
        return tuple(enclosure_of(size) if isinstance(size, list) else enclosure_of([size, size])
                     for size in self._set_in_json.get("sizes") or ())

    def json(self) -> str:
        """In the schema mdm-generate-1."""
        return self._json

    def __eq__(self, other: object) -> bool:
        return isinstance(other, GeneratedSet) and self._json == other._json

    def __hash__(self) -> int:
        return hash(self._json)

    def __repr__(self) -> str:
        return f"<GeneratedSet: {self.particles} particles in {len(self.quantities)} classes>"


def generate(*, curve: Source | None = None, **options: Any) -> GeneratedSet:
    """A representative set of particles from a grading curve. Runs `mdm generate`.

    Args:
        curve: a gradation; or give `beta` with sizes.
        options: of `mdm generate`, with _ for -, as beta="1,3", dmin="0.1", ratio=20, sizes=True, seed=1.

    >>> exactmdm.generate(beta="1,3", dmin="0.1", ratio=20, classes=4)
    <GeneratedSet: 9939 particles in 4 classes>
    """
    if curve is None:
        code, text = _called("generate", *flags_of(options), "--format", "json", "--quiet")
    else:
        with file_of(curve) as path:
            code, text = _called("generate", "--curve", path, *flags_of(options), "--format", "json", "--quiet")
    return GeneratedSet._of(text.rstrip("\n"), code == 0)


@dataclass(frozen=True)
class Written:
    """A file that the program wrote, and what it said."""

    path: Path
    report: str


def pack(sizes: Source | None, out: Union[str, "os.PathLike[str]"], **options: Any) -> Written:
    """A packing of discs, written to `out`. Runs `mdm pack`.

    Args:
        sizes: a file of sizes; a Gradation with spread=True; or None with `beta` or `apollonian`.
        options: of `mdm pack`, with _ for -.
    """
    return _written("pack", sizes, out, options)


def export(source: Source, to: str, out: Union[str, "os.PathLike[str]"], **options: Any) -> Written:
    """A particle file or a model for a DEM code, written to `out`. Runs `mdm export`.

    Args:
        source: a Match, a Gradation that is to be solved, or a file that `mdm export` reads.
        to: the format: "lammps", "liggghts", "yade", "mercurydpm", "vtk", "esys", "lethe", "kratos", "dem-engine",
            "musen", "extxyz", "pfc", "csv" or "diameters".
        options: of `mdm export`, with _ for -, as box="5x5", start="mixed", seed=1.
    """
    return _written("export", source, out, {"to": to, **options})


def picture(source: Source, out: Union[str, "os.PathLike[str]"], **options: Any) -> Written:
    """A picture of a gradation or of a packing, written to `out` (.svg, .png or .pdf). Runs `mdm plot`; `plot`
    draws with matplotlib."""
    return _written("plot", source, out, options)


def _written(command: str, source: Source | None, out: Union[str, "os.PathLike[str]"],
             options: dict[str, Any]) -> Written:
    path = Path(out)
    arguments = [*flags_of(options), "-o", os.fspath(out)]
    if source is None:
        return Written(path, _called(command, *arguments)[1])
    with file_of(source) as file:
        return Written(path, _called(command, file, *arguments)[1])


def _word(value: object, name: str) -> str:
    return str(os.fspath(value)) if isinstance(value, os.PathLike) else text_of(value, name)
