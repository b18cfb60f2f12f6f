"""What runs the program `mdm` in a process of its own, with exact texts in and out: sets, packings, exports, pictures.

The program is the one beside this module (`exactmdm/bin/mdm`), or else the first on PATH.
"""

from __future__ import annotations

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Union

from exactmdm.enclosure import Enclosure, enclosure_of
from exactmdm.errors import InputError, LimitReached
from exactmdm.exact import Number, optional_int, text_of
from exactmdm.gradation import Gradation
from exactmdm.match import Match
from exactmdm.options import given_of, kinds_of
from exactmdm.reading import Path
from exactmdm.solving import Tolerance
from exactmdm.value import Value

#: Exit codes of `mdm`.
_BAD_INPUT, _LIMITED = 2, 3

#: What a command reads: a file, or what stands for one.
Source = Union[Gradation, Match, str, "os.PathLike[str]"]


def program() -> str:
    """The path of the program `mdm`. Raises FileNotFoundError if there is none."""
    beside = pathlib.Path(__file__).with_name("bin") / "mdm"
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


def called(command: str, *arguments: str) -> tuple[int, str]:
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


def flags_of(options: dict[str, Any], command: str | None = None) -> list[str]:
    """Keywords as options of the command line: True is a flag, None and False are left out, what has several values
    repeats it. With a command, what is seconds there may be a float.

    >>> flags_of({"void_ratio": "0.6", "spread": True, "seed": None, "tolerance": ["1%", "passing:2%"]})
    ['--void-ratio', '0.6', '--spread', '--tolerance', '1%', '--tolerance', 'passing:2%']
    """
    kinds = {} if command is None else kinds_of(command)
    flags: list[str] = []
    for name, value in options.items():
        option = "--" + name.rstrip("_").replace("_", "-")
        if value is True:
            flags.append(option)
        elif value is None or value is False:
            continue
        elif kinds.get(name) == "seconds" and isinstance(value, float):
            flags += [option, repr(value)]
        else:
            several = hasattr(value, "__iter__") and not isinstance(value, str)
            flags += [word for one in (value if several else [value]) for word in (option, _word(one, name))]
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
        path = pathlib.Path(folder, f"{name}.json")
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


def generate(*, curve: Source | None = None,
             # Options of generate, by src/ask/write_modules.
             beta: str | None = None, dmin: Number | None = None, dmax: Number | None = None,
             span: Number | None = None, ratio: Number | None = None, between: str | None = None,
             pan_size: Number | None = None, classes: Number | None = None, classing: str | None = None,
             min_per_class: Number | None = None, largest_share: Number | None = None, at_least: Number | None = None,
             at_most: Number | None = None, dimension: Number | None = None, method: str | None = None,
             match_digits: Number | None = None, time_limit: Union[Number, float, None] = None, sizes: bool = False,
             seed: Number | None = None, spread: bool = False, quantiles: bool = False, points: Number | None = None,
             table: Number | None = None, digits: Number | None = None, specimen_id: str | None = None,
             columns: str | None = None, kind: str | None = None, unit: str | None = None, skip: Number | None = None,
             sheet: str | None = None, loss: Number | None = None, round: Number | None = None,
             # End of the options.
             ) -> GeneratedSet:
    """A representative set of particles from a grading curve. Runs `mdm generate`.

    Args:
        curve: a gradation, or a file of one; or give `beta` with sizes.
        beta: "A,B", the cumulative beta curve, a and b from 0.001 to 1000; "1,1" is uniform by volume.
        dmin, dmax, span, ratio: smallest and largest size of it, (dmax - dmin) / (dmax + dmin), and dmax / dmin: as many
            as are needed.
        at_most: more particles are not accessible.
        match_digits: significant digits of bounds and volumes for method="match", 6.
        time_limit: seconds for method="match", 60.
        sizes: with the size of every particle.
        between: what the curve of a file does between sieves: linear in log size (log, the default) or in size
            (linear), or constant (stair).
        pan_size: take the pan of a file as a sieve of this size.
        classes: number of size classes (10).
        classing: classes of equal widths (regular), equal ratios (geometric, the default), equal volumes (isochoric;
            with a or b near 0.001 some 0.2 s a class), or between the sieves (sieves, the default of curve without
            classes).
        min_per_class: particles in the scarcest class (10).
        largest_share: no particle has more than P % of the volume of its class, counted with its median size (the paper's
            second criterion).
        at_least: particles in all (2000).
        dimension: 2, discs, or 3, spheres (3).
        method: counts by rounding (paper), or the smallest set whose class volumes are exact (match).
        seed: draw sizes at random, by the counter-based generator Philox 4x32-10.
        spread: for method match: sizes drawn uniform by volume in their class by seed (1), and enough particles for
            that; JSON and CSV have them, as with sizes.
        quantiles: draw sizes without randomness (the default).
        points: sizes, equally spaced in log size, at which the set's curve is compared (C_r; 100 for up to 10^6
            particles, if given up to 10^7 in 1 GB); 0: no quality.
        table: h, V, F and f of the set, and h of the curve, at K equally spaced sizes.
        digits: significant digits of enclosures (15).
        specimen_id: the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them.
        columns: the columns of sizes and masses: names, or numbers from 1 on.
        kind: what the values are: passing, retained, cumulative, or a name as in canonical CSV.
        unit: what the sizes are: mm, um, m, in, phi or sieve.
        skip: leave out the first N lines or rows.
        sheet: the sheet of a workbook (the first).
        loss: what the rows of a sheet may lack of its initial mass (1%).
        round: take all masses, or the values of a column that passes or is cumulative, to D significant digits before
            anything else.

    Returns:
        The set. It is accessible if it has no more particles than was asked.

    Raises:
        InputError: an option or the curve is wrong.
        LimitReached: a limit came before the end; `known` is the report in JSON with what is certain.

    >>> exactmdm.generate(beta="1,3", dmin="0.1", ratio=20, classes=4)
    <GeneratedSet: 9939 particles in 4 classes>
    """
    flags = [*flags_of(given_of("generate", locals()), "generate"), "--format", "json", "--quiet"]
    if curve is None:
        code, text = called("generate", *flags)
    else:
        with file_of(curve) as path:
            code, text = called("generate", "--curve", path, *flags)
    return GeneratedSet._of(text.rstrip("\n"), code == 0)


@dataclass(frozen=True)
class Written:
    """A file that the program wrote, and what it said."""

    path: pathlib.Path
    report: str


def pack(sizes: Source | None, out: Path, *,
         # Options of pack, by src/ask/write_modules.
         spread: bool = False, beta: str | None = None, dmin: Number | None = None, dmax: Number | None = None,
         span: Number | None = None, ratio: Number | None = None, classes: Number | None = None,
         classing: str | None = None, min_per_class: Number | None = None, at_least: Number | None = None,
         specimen_id: str | None = None, columns: str | None = None, kind: str | None = None, unit: str | None = None,
         skip: Number | None = None, sheet: str | None = None, loss: Number | None = None, round: Number | None = None,
         apollonian: str | None = None, smallest: Number | None = None, count_only: bool = False,
         width: Number | None = None, periodic: bool = False, walls: bool = False, floor: str | None = None,
         rule: str | None = None, order: str | None = None, seed: Number | None = None, positions: bool = False,
         # End of the options.
         format: str = "text") -> Written:
    """A packing of discs, written to `out`. Runs `mdm pack`.

    Args:
        sizes: a file of sizes; a Gradation, or a file of one, with spread=True; or None with `beta` or `apollonian`.
        out: the file of the packing: a header, then x, y and r of each disc.
        spread: sizes are a gradation: the discs of its smallest match with masses x^2, of a size each by `seed`.
        positions: with format="json": centre and radius of every disc.
        format: of the report: "text", "json" or "csv".
        beta: discs of the cumulative beta curve, a and b from 0.001 to 1000, drawn by seed.
        dmin: smallest size of a beta curve (1 where span or ratio is alone).
        dmax: largest size of a beta curve.
        span: (dmax - dmin) / (dmax + dmin), between 0 and 1.
        ratio: dmax / dmin, above 1.
        classes: number of size classes of a beta curve (10).
        classing: classes of equal widths (regular), ratios (geometric, the default) or volumes (isochoric).
        min_per_class: discs in the scarcest class (10; of a gradation 1).
        at_least: discs in all, of which the floors of Eq. 9 may lose some (2000; of a gradation 1).
        specimen_id: the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them.
        columns: the columns of sizes and masses: names, or numbers from 1 on.
        kind: what the values are: passing, retained, cumulative, or a name as in canonical CSV.
        unit: what the sizes are: mm, um, m, in, phi or sieve.
        skip: leave out the first N lines or rows.
        sheet: the sheet of a workbook (the first).
        loss: what the rows of a sheet may lack of its initial mass (1%).
        round: take all masses, or the values of a column that passes or is cumulative, to D significant digits before
            anything else.
        apollonian: no deposit: the Apollonian packing around three circles of radius 1 (equal), or of the four whole
            curvatures, the outer circle's below 0.
        smallest: radius of the smallest circles of an Apollonian packing, as 0.001 or 1/1000; the outer circle is not
            counted.
        count_only: of an Apollonian packing: the number of circles alone.
        width: of the box, 3 of the largest discs or more (as wide as the packing is high).
        periodic: the box repeats itself to both sides (the default).
        walls: the box has walls.
        floor: a disc for which the floor is bare goes to the left end of the first bare piece (left), or to its middle
            (centred, the default).
        rule: each disc goes to the lowest place that is reached from above (lowest, the default), or is dropped in a
            random column and rolls to rest (drop).
        order: of the discs: shuffled by seed (the default), or as given.
        seed: of drawn sizes, of the order and of random columns (1).

    Raises:
        InputError: an option or a file is wrong.
    """
    return _written("pack", sizes, out, {**given_of("pack", locals()), "format": format})


def export(source: Source | None, to: str, out: Path, *,
           # Options of export, by src/ask/write_modules.
           unit: str | None = None, gradation: Union[str, "os.PathLike[str]", None] = None,
           density: Number | None = None, mass_error: Number | None = None, yes_huge: bool = False,
           yes_units: bool = False, size_unit: str | None = None, size_column: str | None = None, radius: bool = False,
           diameter: bool = False, timestep: Number | None = None, box: str | None = None, start: str | None = None,
           sides: str | None = None, seed: Number | None = None, model: str | None = None, dimension: str | None = None,
           steps: Number | None = None, stress: Number | None = None, axial_strain: Number | None = None,
           constant: str | None = None, target_tolerance: Number | None = None, friction: Number | None = None,
           friction_while_filling: Number | None = None, rolling_friction: Number | None = None,
           surface_energy: Number | None = None, cohesion_energy_density: Number | None = None, periodic: bool = False,
           unjammed: bool = False, types: str | None = None, material: Union[str, "os.PathLike[str]", None] = None,
           young: Number | None = None, poisson: Number | None = None, spread: bool = False,
           tolerance: Tolerance = None, band: Union[str, "os.PathLike[str]", None] = None,
           particles: Number | None = None, by: str | None = None, grid: Number | None = None,
           min_per_class: Number | None = None, at_least: Number | None = None, specimen: str | None = None,
           void_ratio: Number | None = None, solids_volume: Number | None = None, at_most: Number | None = None,
           law: str | None = None, size_factor: Number | None = None, cut_below: Number | None = None,
           pan_size: Number | None = None, scale: str | None = None, max_steps: Number | None = None,
           node_limit: Number | None = None, time_limit: Union[Number, float, None] = None, gap: Number | None = None,
           specimen_id: str | None = None, columns: str | None = None, kind: str | None = None,
           skip: Number | None = None, sheet: str | None = None, loss: Number | None = None,
           round: Number | None = None,
           # End of the options.
           ) -> Written:
    """A particle file or a model for a DEM code, written to `out`. Runs `mdm export`.

    Args:
        source: a Match, a Gradation that is to be solved, or a file that `mdm export` reads; None with a band alone.
        to: the format: "lammps", "liggghts", "yade", "mercurydpm", "vtk", "esys", "lethe", "kratos", "dem-engine",
            "musen", "extxyz", "pfc", "csv" or "diameters".
        out: the file; that of a model has others beside it.
        spread: sizes for all particles: exact masses of the classes.
        unit: unit of lengths in the file: m (default), mm, um or in.
        size_unit: unit of FILE where it is a file of particles: as in mdm verify.
        density: of the grains in kg/m^3 (2650); a class's factor, where there is one, multiplies it.
        mass_error: relative error of the mass of a class that rounded sizes may make (1e-9; 2e-7 for gsd and
            dem-engine, which have floats).
        yes_huge: more than 10000000 particles are wanted.
        yes_units: sizes below 1 um and boxes above 100 m are right: the units are no mistake.
        box: footprint of the start, and its height, in the answer's unit (lammps, yade, vtk, models); without it the
            specimen's, a square in it for a cylinder, or a square that makes the start as high as wide.
        start: layers, a slab for each class; mixed, at random places of a higher box; or deposit, a dense one, dropped
            and rolled to rest (lammps, yade, vtk, models; layers, but mixed for a model of up to 1000000 particles, and
            a deposit for one with a density to reach).
        sides: of the start's box: walls; cylinder, in a box as long as wide, the default for such a specimen but in
            layers; or periodic, of a deposit, repeated in x and y (models: lammps, liggghts).
        seed: of the places of the start, and of a spread's sizes (1).
        model: settle: a complete model that lets the particles settle in the specimen, for liggghts, lammps or yade,
            and beside it the files that it reads; with void_ratio or stress it compacts them.
        steps: time steps of the model while particles settle, at most; without it three times as long as a fall from
            the top of the box.
        stress: pressure in Pa to which the model compacts the particles, by a lid or the faces of a periodic box;
            void_ratio is another such target.
        target_tolerance: of void_ratio, or of stress as a part of it (0.01).
        friction: coefficient of friction of a model's particles (0.5).
        friction_while_filling: the same while they settle and are compacted, and of walls: less makes denser beds
            (friction).
        rolling_friction: coefficient of rolling friction of a model's particles and walls: the most moment of a contact
            over its normal force and effective radius; none without it (liggghts, lammps).
        periodic: a model in a box that is repeated on all sides: nothing settles, its faces compress it to void_ratio
            or stress (lammps, yade).
        types: class: each class has a type of its own, walls the next; else one (lammps, models; YADE has a material a
            class).
        material: CSV: the material of each class in a model: columns class (number) or lower_mm, and some of
            young_modulus, poisson, friction, restitution; implies types class.
        young: Young's modulus for the time step, in Pa (7e10; a model is softer, and says so).
        poisson: Poisson's ratio for the time step (0.25).
        tolerance: the smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points),
            retained:file, passing:file (column tolerance_percent), laboratory, rounding; may be repeated.
        band: the smallest match within the envelope in FILE: CSV with passing_min_percent and passing_max_percent of
            each sieve, or a table with columns such as Lower and Upper.
        min_per_class: at least R particles in every class with mass.
        at_least: the smallest match with at least N particles.
        at_most: no match if the smallest has more than N particles.
        specimen: at least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, or in
            the answer's unit (the file's; mm for inches, phi and sieve names).
        void_ratio: void ratio e of the specimen.
        solids_volume: at least this volume of solids, in the cube of the answer's unit.
        law: mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or
            table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows.
        size_factor: multiply every size of the gradation by K.
        cut_below: leave out the classes below the sieve SIZE, as 63um or in the file's unit (before size_factor).
        pan_size: count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before size_factor).
        max_steps: stop after so many steps (67108864), with what is certain.
        node_limit: stop after so many nodes of the search for a tolerance.
        time_limit: stop after so many seconds.
        gap: within a tolerance, stop at a match that has at most this part of its particles more than are certain, for
            example 1e-6.
        scale: robust (sizes far from the sieves) or upper (largest sizes).
        specimen_id: the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them.
        columns: the columns of sizes and masses: names, or numbers from 1 on.
        kind: what the values are: passing, retained, cumulative, or a name as in canonical CSV.
        skip: leave out the first N lines or rows.
        sheet: the sheet of a workbook (the first).
        loss: what the rows of a sheet may lack of its initial mass (1%).
        round: take all masses, or the values of a column that passes or is cumulative, to D significant digits before
            anything else.
        gradation: whose classes the particles of FILE are in, where it is a file of particles: their numbers, materials
            and densities; without it a class has sizes up to 1.41 times its smallest.
        unjammed: a model's result may be grains that are not at rest, or that do not carry each other; without it the
            engine stops there with what it measures.
        axial_strain: of a triaxial model at its end, 1 - h/h0, up to 0.5 (0.2).
        constant: while a triaxial model is sheared: sigma_3, on its sides (default), or p, the mean (sigma_1 + 2
            sigma_3)/3.
        size_column: its column of sizes where that has a name of its own, such as c_r: as in mdm verify.
        radius: its sizes are radii, whatever their name.
        diameter: its sizes are diameters, whatever their name.
        timestep: its timestep, instead of the last: as in mdm verify.
        dimension: 3, spheres (the default), or 2, discs of one length: a model in which they settle between two walls;
            masses are by law power:2, and box is width x height (lammps, yade).
        surface_energy: cohesion of a model's particles by the law of Johnson, Kendall and Roberts, in J/m^2: two part
            at a tension of 3 pi G and their effective radius; walls and particles have none (lammps).
        cohesion_energy_density: the same by the law SJKR, in J/m^3: a contact has a tension of K times its area
            (liggghts).
        particles: the least tolerance with which N particles suffice, of the kind that tolerance names without a value:
            retained (as without it), passing or total.
        by: what particles chooses: tolerance, or size-factor, the least factor with which N particles of a specimen
            suffice (tolerance).
        grid: the steps of that tolerance in percentage points, or of that factor from 1 on (0.001).

    Raises:
        InputError: an option or the source is wrong, or it cannot be written in that format.
        LimitReached: a limit came before there was a match.
    """
    return _written("export", source, out, {"to": to, **given_of("export", locals())})


def picture(source: Source, out: Path, *,
            # Options of plot, by src/ask/write_modules.
            match: bool = False, what: str | None = None, band: Union[str, "os.PathLike[str]", None] = None,
            bands: str | None = None, sieve_names: str | None = None, coarse_left: bool = False,
            colour: str | None = None, texture: str | None = None, size_unit: str | None = None,
            width: Number | None = None, language: str | None = None, caption: str | None = None, bare: bool = False,
            liquid_limit: Number | None = None, plastic_limit: Number | None = None, pan_size: Number | None = None,
            extrapolate: bool = False, tolerance: Tolerance = None, particles: Number | None = None,
            by: str | None = None, grid: Number | None = None, min_per_class: Number | None = None,
            at_least: Number | None = None, specimen: str | None = None, void_ratio: Number | None = None,
            solids_volume: Number | None = None, at_most: Number | None = None, law: str | None = None,
            size_factor: Number | None = None, cut_below: Number | None = None, scale: str | None = None,
            max_steps: Number | None = None, node_limit: Number | None = None,
            time_limit: Union[Number, float, None] = None, gap: Number | None = None, specimen_id: str | None = None,
            columns: str | None = None, kind: str | None = None, unit: str | None = None, skip: Number | None = None,
            sheet: str | None = None, loss: Number | None = None, round: Number | None = None,
            # End of the options.
            sample: Source | None = None, format: str | None = None) -> Written:
    """A picture of a gradation or of a packing, written to `out` (.svg, .png or .pdf). Runs `mdm plot`; `plot`
    draws with matplotlib.

    Args:
        source: a gradation, or a file that `mdm plot` reads: of a gradation, of particles, or a packing of `pack`.
        out: the file of the picture.
        sample: particles to show beside it: a Match, or a file of particles.
        format: "svg", "png" or "pdf"; None: as `out` ends.
        match: show the smallest match: solve now.
        what: curve, counts or both; both where there are particles, else curve; or section: of a SAMPLE with places,
            the curve and an upright cut through its middle, coloured by class.
        band: show an envelope: CSV with passing_min_percent,passing_max_percent, or a table with columns such as Lower
            and Upper.
        bands: size bands: uscs, iso (14688) or none (uscs).
        sieve_names: at the sieves: astm (No. 200, 3/8 in), iso (their openings, the default), or none (the default of
            particles).
        coarse_left: coarse sizes on the left, as in the United States.
        colour: of a packing, whose discs are drawn at scale: by their size (the default), by the number of others that
            they touch (contacts), or of the cells of the contact graph by their corners (cells).
        size_unit: unit of SAMPLE where it is a file of particles: as in mdm verify.
        liquid_limit: of the fines, in percent; without limits they are low-plasticity silt.
        plastic_limit: of the fines, in percent.
        pan_size: take the pan as a sieve of this size.
        extrapolate: continue the line through the two finest sieves into a pan at size 0.
        specimen_id: the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them.
        columns: the columns of sizes and masses: names, or numbers from 1 on.
        kind: what the values are: passing, retained, cumulative, or a name as in canonical CSV.
        unit: what the sizes are: mm, um, m, in, phi or sieve.
        skip: leave out the first N lines or rows.
        sheet: the sheet of a workbook (the first).
        loss: what the rows of a sheet may lack of its initial mass (1%).
        round: take all masses, or the values of a column that passes or is cumulative, to D significant digits before
            anything else.
        width: width of the picture in pt, from 200 to 5000; letters stay as large as they are.
        language: language of the picture's own words: en (the default) or de; names and notes stay as they are.
        caption: a sentence to stand below the picture, before the notes.
        bare: the diagram with its legend alone, without title, index numbers and notes: for a page that has them.
        texture: the triangle of textures with the gradation as a point in it: folk (mud, sand, gravel), shepard or usda
            (sand, silt, clay).
        tolerance: the smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points),
            retained:file, passing:file (column tolerance_percent), laboratory, rounding; may be repeated.
        particles: the least tolerance with which N particles suffice, of the kind that tolerance names without a value:
            retained (as without it), passing or total.
        by: what particles chooses: tolerance, or size-factor, the least factor with which N particles of a specimen
            suffice (tolerance).
        grid: the steps of that tolerance in percentage points, or of that factor from 1 on (0.001).
        min_per_class: at least R particles in every class with mass.
        at_least: the smallest match with at least N particles.
        specimen: at least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, or in
            the file's unit (mm for sieve names and phi; beside inches a unit is needed).
        void_ratio: void ratio e of the specimen.
        solids_volume: at least this volume of solids, in the cube of the answer's unit.
        at_most: no match if the smallest has more than N particles.
        law: mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or
            table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows.
        size_factor: multiply every size of the gradation by K.
        cut_below: leave out the classes below the sieve SIZE, as 63um or in the file's unit (before size_factor).
        max_steps: stop after so many steps (67108864), with what is certain.
        node_limit: stop after so many nodes of the search for a tolerance.
        time_limit: stop after so many seconds.
        gap: within a tolerance, stop at a match that has at most this part of its particles more than are certain, for
            example 1e-6.
        scale: robust (sizes far from the sieves) or upper (largest sizes).

    Raises:
        InputError: an option or a file is wrong, or neither `out` nor `format` says what it is to be.
        LimitReached: match=True, and there was none within some seconds.
    """
    options = {**given_of("plot", locals()), "format": format}
    if sample is None:
        return _written("plot", source, out, options)
    with file_of(sample) as file:
        return _written("plot", source, out, options, file)


def _written(command: str, source: Source | None, out: Path, options: dict[str, Any], *further: str) -> Written:
    arguments = [*further, *flags_of(options, command), "-o", os.fspath(out)]
    if source is None:
        return Written(pathlib.Path(out), called(command, *arguments)[1])
    with file_of(source) as file:
        return Written(pathlib.Path(out), called(command, file, *arguments)[1])


def _word(value: object, name: str) -> str:
    return str(os.fspath(value)) if isinstance(value, os.PathLike) else text_of(value, name)
