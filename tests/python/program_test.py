"""What the program does in a process of its own."""

import json
import pickle

import exactmdm as mdm
import pytest
from support import SAND, mdm as program, sand


def test_a_generated_set_is_that_of_the_command_line():
    found = mdm.generate(beta="1,3", dmin="0.1", ratio=20, classes=4, sizes=True, seed=3, min_per_class=1, at_least=50)
    text = program("generate", "--beta", "1,3", "--dmin", "0.1", "--ratio", "20", "--classes", "4", "--sizes", "--seed", "3",
                   "--min-per-class", "1", "--at-least", "50", "--format", "json")[1]
    assert found.json() + "\n" == text and found.accessible
    assert len(found.sizes) == found.particles == sum(found.quantities) and found.sizes[0].lo <= found.sizes[0].hi
    assert pickle.loads(pickle.dumps(found)) == found


def test_a_curve_may_be_a_gradation_at_hand():
    assert mdm.generate(curve=mdm.read(SAND)).quantities == mdm.generate(curve=SAND).quantities
    assert not mdm.generate(curve=sand(), at_most=2000, at_least=2000, min_per_class=1000).accessible


@pytest.mark.parametrize("to", ["lammps", "liggghts", "yade", "vtk", "csv", "diameters", "extxyz"])
def test_a_match_is_exported(tmp_path, to):
    written = mdm.export(mdm.solve(sand()), to, tmp_path / "sample")
    (tmp_path / "sand.json").write_text(mdm.solve(sand()).json())
    other = tmp_path / "other"
    assert program("export", tmp_path / "sand.json", "--to", to, "-o", other)[0] == 0
    assert written.path.read_bytes() == other.read_bytes() != b""
    if to in ("lammps", "vtk", "csv"):
        assert mdm.verify(sand(), written.path, tolerance="1e-6", from_format=None if to != "lammps" else "lammps-data")


def test_what_the_program_refuses_is_an_input_error(tmp_path):
    for options in ({"to": "stl"}, {"to": "csv", "unit": "ft"}):
        with pytest.raises(mdm.InputError):
            mdm.export(sand(), out=tmp_path / "x", **options)
    with pytest.raises(TypeError, match="nonsense"):
        mdm.export(sand(), "csv", tmp_path / "x", nonsense=1)
    assert not (tmp_path / "x").exists()
    with pytest.raises(mdm.InputError, match="float"):
        mdm.generate(beta="1,3", dmin=0.1, ratio=20)


def test_a_packing_is_written_and_drawn(tmp_path):
    disc = mdm.pack(None, tmp_path / "discs.packing", beta="1,2", ratio=3, classes=3, at_least=200, min_per_class=5)
    assert disc.path.stat().st_size > 0
    assert "<svg" in mdm.picture(disc.path, tmp_path / "discs.svg").path.read_text()


def test_the_report_of_a_packing_has_the_format_that_is_asked_for(tmp_path):
    words = {"beta": "1,2", "ratio": 3, "classes": 3, "at_least": 50, "min_per_class": 5}
    report = json.loads(mdm.pack(None, tmp_path / "a.packing", format="json", positions=True, **words).report)
    assert len(report["positions"]) == int(report["discs"])
    with pytest.raises(mdm.InputError, match="positions: they are in the file .* only with format json"):
        mdm.pack(None, tmp_path / "b.packing", positions=True, **words)


def test_options_of_solving_go_to_an_export(tmp_path):
    written = mdm.export(sand(), "diameters", tmp_path / "sizes", tolerance=["retained:2%", "total:4%"], time_limit=7.5,
                         law="sphere")
    match = mdm.solve(sand(), tolerance=["retained:2%", "total:4%"])
    assert sum(line[0] != "#" for line in written.path.read_text().splitlines()) == match.particles
    with pytest.raises(mdm.InputError, match="time_limit"):
        mdm.export(sand(), "diameters", tmp_path / "none", time_limit=-1.5)


def test_a_picture_is_drawn(tmp_path):
    assert "<svg" in mdm.picture(sand(), tmp_path / "sand.svg", match=True).path.read_text()
    assert "<svg" in mdm.picture(sand(), tmp_path / "sand.picture", format="svg", bands="iso").path.read_text()
    beside = mdm.picture(sand(), tmp_path / "beside.svg", sample=mdm.solve(sand()), what="counts")
    assert beside.path.read_text() != mdm.picture(sand(), tmp_path / "alone.svg").path.read_text()
    with pytest.raises(mdm.InputError, match="or give format"):
        mdm.picture(sand(), tmp_path / "sand.picture")


def test_a_limit_raises_with_the_output():
    narrow = mdm.Gradation(["1", "1.00000000001", "1.00000000002"], [1, 2, 0])
    with pytest.raises((mdm.LimitReached, mdm.InputError)):
        mdm.generate(curve=narrow, method="match", time_limit="0.01")


def test_without_the_program_it_says_so(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(mdm.program, "__file__", str(tmp_path / "program.py"))
    with pytest.raises(FileNotFoundError, match="neither beside this module nor on PATH"):
        mdm.generate(beta="1,3")
