"""Gradations from files."""

from __future__ import annotations

import os
from typing import Any, Union

from exactmdm import _core
from exactmdm.errors import InputError, in_file
from exactmdm.exact import Number, text_of, valid_text
from exactmdm.gradation import Gradation
from exactmdm.options import given_of, read_file, words_of

#: A path of a file.
Path = Union[str, "os.PathLike[str]"]

_MOST_BYTES = 64 << 20  # as the command line
_BEGINNING = 1 << 16


def read(path: Path, *,
         # Options of convert, by src/ask/write_modules.
         specimen_id: str | None = None, columns: str | None = None, kind: str | None = None, unit: str | None = None,
         skip: Number | None = None, sheet: str | None = None, loss: Number | None = None, round: Number | None = None,
         # End of the options.
         ) -> Gradation:
    """The gradation in a file of any format that `mdm convert` reads: CSV, JSON, AGS4, DIGGS, a table or workbook of a
    laboratory, a file of an instrument. The format is told by the content; numbers are read exactly.

    Args:
        path: the file; its name without ending becomes the id.
        specimen_id: the sample of a file with several.
        columns: "SIZE,VALUE", names or numbers from 1 on.
        kind: what the values are: "passing", "retained", "cumulative", or the name of a canonical column.
        unit: what the sizes are: "mm", "um", "m", "in", "phi" or "sieve".
        skip: lines or rows above the table.
        sheet: of a workbook.
        loss: percent of a sheet's initial mass that its rows may lack, such as "2%"; 1 % where it is not given.
        round: significant digits that all masses are taken to.

    Raises:
        InputError: with the file and, where there is one, the line.
    """
    words = words_of(given_of("convert", locals()), "convert")
    name, content = _content(path)
    with in_file(name):
        if _core.is_sample(content[:_BEGINNING]):
            raise InputError(f"{name}: it holds particles, no gradation: read_sample makes one of them", name)
        core, *_, is_canonical = _core.read(content, name, words.values)
    return Gradation._of(core, (name, content.decode()) if is_canonical and _is_utf8(content) else None)


def read_all(path: Path, **reading: Any) -> tuple[Gradation, ...]:
    """All gradations of a file, such as the specimens in AGS4; the keywords are those of `read`."""
    name, content = _content(path)
    with in_file(name):
        return tuple(Gradation._of(core) for core in _core.read_all(content, name, words_of(reading, "convert").values))


def read_sample(path: Path, *, unit: str | None = None) -> Gradation:
    """The gradation that the particles in a file have: of any format that `mdm verify` reads but an answer. Spheres.

    Args:
        unit: of the sizes in the file: "mm", "um", "m" or "in"; None: as the file or its format says.
    """
    name, content = _content(path)
    with in_file(name):
        return Gradation._of(_core.read_sample(content, name, None if unit is None else text_of(unit, "unit")))


def gradation_of(gradation: Union[Gradation, Path]) -> Gradation:
    """A gradation, or that in a file."""
    if isinstance(gradation, Gradation):
        return gradation
    if isinstance(gradation, (str, os.PathLike)):
        return read(gradation)
    raise TypeError(f"{type(gradation).__name__} is no gradation: give a Gradation or the path of a file")


def _is_utf8(content: bytes) -> bool:
    try:
        content.decode()
    except UnicodeDecodeError:
        return False
    return True


def _content(path: Path) -> tuple[str, bytes]:
    content = read_file(path)
    if len(content) > _MOST_BYTES:
        raise InputError(f"{path}: it has more than 64 MB: a gradation is shorter", str(path))
    return valid_text(os.fspath(path)), content
