"""Messages and notes name options as keywords: `size_unit`, and no `--size-unit` but in a command, `mdm ...`."""

import re

import exactmdm as mdm
import pytest
from support import sand

LABORATORY = "Sieve size (mm),Retained (g)\n2,0\n1,30\n0.5,20\npan,5\n"


def hyphens_of(message):
    """The options that a message has as the command line does; what follows the name of the program is a command."""
    return re.findall(r"(?<![\w-])--[a-z][a-z-]*", re.sub(r"mdm [^;:,()]*", "", message))


def check(message, *keywords):
    assert not hyphens_of(message), message
    for keyword in keywords:
        assert re.search(rf"(?<![\w-]){keyword}\b", message), f"{keyword}: {message}"


def refusal(call):
    with pytest.raises(mdm.InputError) as found:
        call()
    return str(found.value)


def test_what_counts_as_an_option_of_the_command_line():
    assert hyphens_of("leave out --size-unit") == ["--size-unit"]
    assert hyphens_of("see mdm solve --help; leave out --law") == ["--law"]
    assert not hyphens_of("see mdm convert --help: a -- b, 1--2, leave out size_unit")


READINGS = [
    ("a,b\n1,2\n2,3\n", {}, ["columns", "kind", "unit", "skip"]),
    ("Sieve size,Retained (g)\n2,0\n1,30\n", {}, ["unit"]),
    ("Opening (mm),Retained (g)\n4,0\n2,5\n1,9\n0.5,20\n0.25,31\n0.125,40\n", {}, ["kind"]),
    ("Sieve size (mm),Passing\n2,1\n1,0.5\n0.5,0.2\n", {}, []),
    ("size_mm,passing_min_percent,passing_max_percent\n1,0,10\n2,100,100\n", {}, ["band"]),
    ("size_mm,passing_percent\n1,50\n2,99.99\n", {}, ["round"]),
    ("size_mm,mass\n1,1\n2,0\n", {"specimen_id": "BH1"}, ["specimen_id"]),
    ("size_mm,mass\n1,1\n2,0\n", {"sheet": "1"}, ["sheet"]),
    ("size_mm,mass\n1,1\n2,0\n", {"round": "x"}, ["round"]),
    ('{"sizes": ["1", "2"], "masses": ["1", "0"]}', {"loss": "2%"}, ["columns", "kind", "unit", "skip", "loss"]),
    (LABORATORY, {"columns": "1"}, ["columns"]),
    (LABORATORY, {"columns": "1,1"}, ["columns"]),
    (LABORATORY, {"columns": "1,x"}, ["columns"]),
    (LABORATORY, {"kind": "weight"}, ["kind"]),
    (LABORATORY, {"kind": "passing"}, ["kind", "columns"]),
    (LABORATORY, {"unit": "um"}, ["unit"]),
    (LABORATORY, {"unit": "km"}, ["unit"]),
    (LABORATORY, {"skip": "x"}, ["skip"]),
    (LABORATORY, {"loss": "x"}, ["loss"]),
]


@pytest.mark.parametrize("content, options, keywords", READINGS)
def test_readings(tmp_path, content, options, keywords):
    path = tmp_path / "sheet.csv"
    path.write_text(content)
    check(refusal(lambda: mdm.read(path, **options)), *keywords)


QUESTIONS = [
    ({"solids_volume": 5, "law": "power:2"}, ["law"]),
    ({"tolerance": "often"}, ["tolerance"]),
    ({"tolerance": "x%"}, ["tolerance"]),
    ({"tolerance": "file"}, []),
    ({"min_per_class": "0.5"}, ["min_per_class"]),
    ({"at_least": "-1"}, ["at_least"]),
    ({"at_most": "x"}, ["at_most"]),
    ({"specimen": "ball:3"}, ["specimen"]),
    ({"specimen": "box:1x2x3"}, ["void_ratio"]),
    ({"void_ratio": "0.5"}, ["void_ratio", "specimen"]),
    ({"specimen": "box:1x2x3", "void_ratio": "0.5", "solids_volume": "1"}, []),
    ({"solids_volume": "x"}, ["solids_volume"]),
    ({"law": "cube"}, ["law"]),
    ({"size_factor": "0"}, ["size_factor"]),
    ({"cut_below": "x"}, ["cut_below"]),
    ({"cut_below": "99"}, []),
    ({"pan_size": "1"}, []),
    ({"digits": "0"}, ["digits"]),
    ({"scale": "middle"}, ["scale"]),
    ({"max_steps": "x"}, ["max_steps"]),
    ({"node_limit": "x"}, ["node_limit"]),
    ({"time_limit": "x"}, ["time_limit"]),
    ({"gap": "x"}, ["gap"]),
]


@pytest.mark.parametrize("options, keywords", QUESTIONS)
def test_questions(options, keywords):
    check(refusal(lambda: mdm.solve(sand(), **options)), *keywords)


SAMPLES = [
    ("size_mm,quantity\n0.1,2\n", {"size_unit": "m"}, ["size_unit"]),
    ("size_mm,quantity\n0.1,2\n", {"size_unit": "km"}, ["size_unit"]),
    ("0.3\n0.3 1\n", {}, ["from_format"]),
    ("0.3\n", {"timestep": 2}, ["timestep"]),
    ("0.3\n", {"from_format": "stl"}, ["from_format"]),
    ("0.3\n", {"box": "5x5"}, []),
    ("0.3\n", {"margin": "2"}, []),
    ("0.3\n", {"periodic": "x"}, ["periodic"]),
    ("0.3\n", {"contact_gap": "x"}, ["contact_gap"]),
    ("0.3\n", {"snap": "-1"}, ["snap"]),
    ("0.3\n", {"tolerance": "often"}, ["tolerance"]),
    ("0.3\n", {"digits": "0"}, ["digits"]),
]


@pytest.mark.parametrize("content, options, keywords", SAMPLES)
def test_samples(tmp_path, content, options, keywords):
    path = tmp_path / "sample.csv"
    path.write_text(content)
    check(refusal(lambda: mdm.verify(sand(), path, **options)), *keywords)


def test_programs_behind_functions(tmp_path):
    for options, keywords in [
            ({"to": "csv", "mass_error": "1e-60"}, ["mass_error", "unit", "scale"]),
            ({"to": "lammps", "box": "0.0001x1"}, ["box"]),
            ({"to": "lammps", "start": "deposit", "box": "0.0001x1"}, ["start", "box"]),
    ]:
        check(refusal(lambda: mdm.export(sand(), out=tmp_path / "x", **options)), *keywords)
    out = tmp_path / "x.packing"
    check(refusal(lambda: mdm.pack(None, out, apollonian="equal", width=3)), "apollonian")
    check(refusal(lambda: mdm.pack(None, out, count_only=True)), "smallest", "count_only", "apollonian")
    check(refusal(lambda: mdm.picture(sand(), tmp_path / "x.svg", size_unit="m")), "size_unit")
    check(refusal(lambda: mdm.picture(sand(), tmp_path / "x.svg", colour="size")), "colour")
    check(refusal(lambda: mdm.generate(curve=mdm.Gradation(["0", "1"], [1, 0]))), "pan_size")
    with pytest.raises(mdm.InputError, match="with --pan-size"):  # a command line is the caller's own
        path = tmp_path / "pan.csv"
        path.write_text("size_mm,mass\n0,1\n1,0\n")
        mdm.program.run("generate", "--curve", str(path))


def test_notes(tmp_path):
    path = tmp_path / "sheet.csv"
    path.write_text("Sieve size (mm),Retained (g),Remark\n2,0,a\n1,30,b\n0.5,20,c\npan,5,d\n")
    check("\n".join(mdm.read(path).notes), "columns")
    path.write_text("size_mm,mass\n1,0.30000000000000004\n2,0\n")
    check("\n".join(mdm.read(path).notes), "round")
    fines = mdm.Gradation(["0", "0.075", "2"], [60, 40, 0])
    check("\n".join(mdm.describe(fines).notes), "extrapolate", "pan_size", "liquid_limit", "plastic_limit")
    narrow = mdm.Gradation(["1", "1.00000000001", "1.00000000002"], [1, 2, 0])
    try:
        match = mdm.solve(narrow, max_steps=10)
    except mdm.LimitReached as limit:
        match = limit.known
    check("\n".join(match.notes))
    dump = "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id radius\n1 0.0001\n"
    path = tmp_path / "two.dump"
    path.write_text(dump.format(1) + dump.format(2))
    check("\n".join(mdm.verify(sand(), path).notes), "timestep")
