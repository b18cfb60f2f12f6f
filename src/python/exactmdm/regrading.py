"""Gradations made of others: two analyses joined, grains above a sieve left out or replaced, parallel gradations."""

from __future__ import annotations

import os
import pathlib
import tempfile
from contextlib import ExitStack
from dataclasses import dataclass

from exactmdm.errors import InputError
from exactmdm.exact import Number, text_of
from exactmdm.gradation import Gradation
from exactmdm.program import Source, called, file_of
from exactmdm.reading import read


@dataclass(frozen=True)
class Regraded:
    """A gradation that was made of others, exactly, and how."""

    gradation: Gradation
    history: tuple[str, ...]  #: what was done, with the masses that were moved


def regrade(source: Source | None = None, *, join: tuple[Source, Source] | None = None,
            split: tuple[Source, Source] | None = None, at: str | None = None, fine_mass: Number | None = None,
            scalp: str | None = None, replace: str | None = None, parallel: Number | None = None) -> Regraded:
    """Joins two analyses of one sample, or changes one gradation; what is asked for is done in the order of the keywords.
    Runs `mdm convert`.

    Args:
        source: what is changed; without it, `join` or `split` has the two that are joined.
        join: two analyses of one sample, coarse and fine: sieves above the joint, the other, as of a hydrometer, below.
        split: composite sieving, coarse and fine: the fine one is of a part of what passed the finest sieve of the coarse one.
        at: where the two are joined, a sieve of both: "75um".
        fine_mass: of split, the mass of all that passed, where the coarse one has no row for its pan.
        scalp: leave out the grains above a sieve: "above:20mm".
        replace: replace the grains above a sieve by as much mass between two, in the shares there:
            "above:20mm into 5mm..20mm".
        parallel: the parallel gradation: all sizes times this, as "1/5".

    Raises:
        InputError: a keyword or a file is wrong, or no exact gradation is what was asked for.

    >>> sieves = exactmdm.Gradation(["0", "0.075", "0.425", "2"], [20, 30, 50, 0], id="sieves")
    >>> hydrometer = exactmdm.Gradation(["0", "0.002", "0.075"], [10, 90, 0], id="hydrometer")
    >>> made = exactmdm.regrade(join=(sieves, hydrometer), at="75um")
    >>> [str(mass) for mass in made.gradation.masses]
    ['2', '18', '30', '50', '0']
    >>> made.history[1]
    'joined at 0.075 mm: sieves.json above, hydrometer.json below'
    """
    with ExitStack() as stack:
        files: list[str] = []
        folders: list[str] = []

        def path_of(one: Source) -> str:
            files.append(stack.enter_context(file_of(one)))
            if not isinstance(one, (str, os.PathLike)):
                folders.append(os.path.join(os.path.dirname(files[-1]), ""))
            return files[-1]

        words = [] if source is None else [path_of(source)]
        for name, pair in (("join", join), ("split", split)):
            if pair is not None:
                words += [f"--{name}", *map(path_of, pair)]
        for name, value in (("at", at), ("fine-mass", fine_mass), ("scalp", scalp), ("parallel", parallel)):
            if value is not None:
                words += [f"--{name}", text_of(value, name.replace("-", "_"))]
        if replace is not None:
            parts = replace.split()
            if len(parts) != 3:
                raise InputError(f"replace: {replace!r} is no replacement: write 'above:20mm into 5mm..20mm'")
            words += ["--replace", *parts]
        _, text = called("convert", *words, "--format=csv", "--quiet")
        file = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()), f"{pathlib.Path(files[0]).stem}.csv")
        file.write_text(text, encoding="utf-8")
        history = [line[2:] for line in text.splitlines() if line.startswith("# ")]
        for folder in folders:
            history = [line.replace(folder, "") for line in history]
        made = Regraded(read(file), tuple(history))
    return made
