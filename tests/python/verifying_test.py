"""Samples are judged as `mdm verify` judges them."""

import itertools
import json
import pickle
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import pytest
from support import SAND, mdm as program, sand

G = mdm.Gradation(["1", "2", "3"], [8, 27, 0], id="two")


def without_names(text):
    """A report without the name of the sample and the notes."""
    report = json.loads(text)
    del report["sample"], report["notes"]
    return report


def notes(text):
    """The notes of a report."""
    return json.loads(text)["notes"]


@pytest.mark.parametrize("sample", [[2, 3], ["2", "3.0"], [Decimal(2), Fraction(3)], (2.0, 3.0), iter([3, 2]), {2, 3}],
                         ids=str)
def test_a_sample_of_any_kind_matches(sample):
    found = mdm.verify(G, sample)
    assert found and found.verdict == "match" and found.particles == 2 and found.maximum_error == 0
    assert [c.quantity for c in found.classes] == [1, 1] and found.outside == (0, 0)


def test_a_sample_that_differs_does_not():
    found = mdm.verify(G, [2, 3, 3])
    assert not found and found.classes[0].found == Fraction(8, 62) and found.classes[0].target == Fraction(8, 35)
    assert found.classes[0].error == Fraction(8, 35) - Fraction(8, 62) == found.maximum_error
    assert found.total_error == 2 * found.maximum_error


def test_a_tolerance_is_taken_as_of_the_command_line():
    assert not mdm.verify(G, [2, 3, 3], tolerance="9%") and mdm.verify(G, [2, 3, 3], tolerance=10)
    assert mdm.verify(G, [2, 3, 3], tolerance=["10%", "passing:10%"])
    with pytest.raises(mdm.InputError, match="tolerance"):
        mdm.verify(G, [2], tolerance="ten")


def test_particles_outside_are_counted():
    assert mdm.verify(G, [2, 3, 1, 4, 5]).outside == (1, 2)


def test_a_double_is_the_number_that_it_is():
    g = mdm.Gradation(["0.1", "0.3"], [1, 0])
    assert mdm.verify(g, ["0.3"]) and not mdm.verify(g, [0.1 + 0.2])
    assert mdm.verify(g, [0.1 + 0.2], snap="1e-12")


def test_radii_and_units():
    assert mdm.verify(G, [1, "1.5"], radius=True) and mdm.verify(G, ["0.002", "0.003"], size_unit="m")
    assert mdm.verify(G, [2000, 3000], size_unit="um") and mdm.verify(G, [1000, 1500], size_unit="um", radius=True)
    assert mdm.verify(G, [2, 3], diameter=True)
    with pytest.raises(mdm.InputError, match="one of them"):
        mdm.verify(G, [2], radius=True, diameter=True)
    with pytest.raises(mdm.InputError, match="size_unit"):
        mdm.verify(G, [2], size_unit="ft")


def test_sizes_in_another_unit_are_suspected():
    assert 'in m the first would: say so by size_unit' in mdm.verify(G, ["0.002", "0.003"]).notes[0]
    assert mdm.verify(G, [2, 7]).notes == ()


def test_laws_and_changes_of_the_gradation():
    assert mdm.verify(mdm.Gradation(["1", "2", "3"], [4, 9, 0]), [2, 3], law="power:2")
    assert mdm.verify(G, [20, 30], size_factor=10) and mdm.verify(G, [3], cut_below=2)


@pytest.mark.parametrize("sample", [[0], [-1], [float("nan")], [float("inf")], ["x"], [None], [True], 3, None, [1, [2]],
                                    [b"2"], ["1" * 2000]], ids=str)
def test_what_is_no_sample_is_refused(sample):
    with pytest.raises(mdm.InputError):
        mdm.verify(G, sample)


def test_a_view_with_two_dimensions_is_no_sample():
    with pytest.raises(mdm.InputError, match="one dimension, this memoryview 2"):
        mdm.verify(sand(), memoryview(bytes(4 * 8)).cast("d", (2, 2)))


def test_an_empty_sample_does_not_match():
    assert not mdm.verify(G, [])


def test_a_raising_iterable_comes_out():
    with pytest.raises(ZeroDivisionError):
        mdm.verify(G, (1 / n for n in (1, 0)))


def test_arrays_of_numpy():
    numpy = pytest.importorskip("numpy")
    for kind in ("float64", "float32", "float16", "int32", "uint8", ">f8", "longdouble"):
        assert mdm.verify(G, numpy.array([2, 3], dtype=kind)), kind
    assert mdm.verify(G, numpy.array([2.0, 9, 3, 9])[::2])
    for wrong in (numpy.zeros((2, 2)), numpy.array(["2"]), numpy.array([2j]), numpy.array([2, None]), numpy.array(2.0)):
        with pytest.raises(mdm.InputError):
            mdm.verify(G, wrong)
    many = numpy.tile([2.0, 3.0], 100000)
    assert mdm.verify(G, many).particles == 200000 and mdm.verify(G, many)


def test_a_column_of_pandas():
    pandas = pytest.importorskip("pandas")
    assert mdm.verify(G, pandas.DataFrame({"d": [2.0, 3.0]})["d"])


@pytest.mark.parametrize("name, content, options", [
    ("sizes.csv", "size_mm,quantity\n0.15,12\n0.3,4\n0.7,1\n", {}), ("packing.txt", "0 0 0 0.1\n1 1 1 0.2\n", {}),
    ("list.txt", "0.15\n0.3\n0.7\n", {"from_format": "diameters"}),
    ("list.txt", "0.1\n0.2\n", {"radius": True, "from_format": "diameters"}),
    ("list.txt", "0.00015\n0.0003\n", {"size_unit": "m", "from_format": "diameters"})])
def test_a_file_is_judged_as_by_the_command_line(tmp_path, name, content, options):
    file, gradation = tmp_path / name, tmp_path / "sand.csv"
    file.write_text(content)
    gradation.write_text(sand().csv())
    names = {"from_format": "--from", "size_unit": "--size-unit"}
    flags = [word for key, value in options.items()
             for word in (["--radius"] if key == "radius" else [names[key], value])]
    code, text, _ = program("verify", gradation, file, *flags, "--format", "json")
    found = mdm.verify(gradation, file, **options)
    assert without_names(found.json()) == without_names(text) and code == (0 if found else 1)
    assert set(found.notes) <= set(notes(text))
    assert found.text().splitlines()[1:5] == program("verify", gradation, file, *flags)[1].splitlines()[1:5]


def test_a_wrong_file_is_refused_with_its_line(tmp_path):
    file = tmp_path / "sizes.csv"
    file.write_text("size_mm,quantity\n1,3\n2,x\n")
    with pytest.raises(mdm.InputError) as caught:
        mdm.verify(G, file)
    assert caught.value.line == 3 and caught.value.file == str(file)
    for content in (b"", b"{", b"\xff\xfe\x00", b'{"schema":"mdm-answer-1"}'):
        file.write_bytes(content)
        with pytest.raises(mdm.InputError, match="sizes.csv"):
            mdm.verify(G, file)
    with pytest.raises(mdm.InputError, match="cannot be read"):
        mdm.verify(G, tmp_path / "none")
    with pytest.raises(mdm.InputError, match="from_format"):
        mdm.verify(G, file, from_format="stl")


def test_an_answer_is_judged_by_its_exact_sizes(tmp_path):
    file = tmp_path / "answer.json"
    match = mdm.solve(SAND)
    file.write_text(match.json())
    assert mdm.verify(SAND, match) and mdm.verify(SAND, file) and mdm.verify(SAND, file, from_format="answer")
    assert not mdm.verify(sand(), match)


def test_a_verification_is_a_value():
    found = mdm.verify(G, [2, 3])
    assert pickle.loads(pickle.dumps(found)) == found and hash(found) == hash(mdm.verify(G, [3, 2]))
    assert repr(found) == "<Verification: match, 2 particles, largest error 0 %>"
    assert found._repr_html_().count("<tr>") == 3 and found.smallest == (2, 2) and found.notes == found.objections == ()
    with pytest.raises(AttributeError):
        found.verdict = "no match"


def test_a_frame_has_a_row_a_class():
    pytest.importorskip("pandas")
    assert list(mdm.verify(G, [2, 3]).to_frame()["quantity"]) == [1, 1]


def test_a_long_stream_is_judged_bit_by_bit():
    stream = itertools.islice(itertools.cycle([2.0, 3.0]), 10000)
    assert mdm.verify(G, stream).particles == 10000


def test_places_are_judged_as_by_the_command_line(tmp_path):
    gradation, file = tmp_path / "sand.csv", tmp_path / "packing.txt"
    gradation.write_text(sand().csv())
    file.write_text("0 0 0 0.1\n0 0 0.25 0.2\n9 9 9 0.1\n")
    flags = ("--packing", "--box", "10x10", "--contact-gap", "0.1", "--margin", "1")
    _, text, _ = program("verify", gradation, file, *flags, "--format", "json")
    found = mdm.verify(gradation, file, packing=True, box="10x10", contact_gap="0.1", margin=1)
    assert without_names(found.json()) == without_names(text)
    assert found.packing["contacts"] == "1"
    assert mdm.verify(sand(), [0.1]).packing is None
    assert mdm.verify(gradation, file, box="10x10").packing is not None


def test_places_outside_do_not_match_and_those_that_are_no_numbers_are_refused(tmp_path):
    gradation, file = tmp_path / "sand.csv", tmp_path / "packing.txt"
    gradation.write_text(sand().csv())
    file.write_text("0 0 0 0.1\n0 0 -5 0.1\n")
    found = mdm.verify(gradation, file, box="10x10")
    assert found.verdict == "no match" and "outside the space" in found.objections[0]
    file.write_text("0 0 0 0.1\n0 0 nan 0.1\n")
    with pytest.raises(mdm.InputError, match=":2: 'nan'"):
        mdm.verify(gradation, file, from_format="xyzr")


def test_gsd_is_read_as_by_the_command_line(tmp_path):
    gradation, file = tmp_path / "sand.csv", tmp_path / "start.gsd"
    gradation.write_text(sand().csv())
    assert program("export", gradation, "--to", "gsd", "-o", file)[0] == 0
    _, text, _ = program("verify", gradation, file, "--tolerance", "1e-4%", "--format", "json")
    for found in (mdm.verify(gradation, file, tolerance="1e-4%"),
                  mdm.verify(gradation, file, tolerance="1e-4%", from_format="gsd")):
        assert found and without_names(found.json()) == without_names(text)
    assert mdm.read_sample(file).sizes
    file.write_bytes(file.read_bytes()[:-4])
    with pytest.raises(mdm.InputError, match="cut off"):
        mdm.verify(gradation, file)
