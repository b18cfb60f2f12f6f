"""Gradations: made, read, shown, pickled."""

import pickle
from fractions import Fraction

import exactmdm as mdm
import pytest
from support import SAND, SANDS, SOURCE, mdm as program, sand


def test_a_gradation_says_what_it_holds():
    g = sand()
    assert len(g) == 3 and g.unit == "mm" and g.id == "sand"
    assert g.sizes == (Fraction(1, 10), Fraction(1, 5), Fraction(2, 5), Fraction(4, 5))
    assert g.passing == (0, 20, 50, 100) and g.shares == (Fraction(1, 5), Fraction(3, 10), Fraction(1, 2))


def test_sizes_may_descend():
    assert mdm.Gradation(["3", "2", "1"], [0, 5, 7]) == mdm.Gradation(["1", "2", "3"], [7, 5, 0])


@pytest.mark.parametrize("sizes, masses, what", [
    (["1", "2"], [1, 2], "retain"), (["1", "1"], [1, 0], "ascend|size"), (["1", "2"], [-1, 0], "negative"),
    (["1", "2"], [0, 0], "mass"), (["1"], [0], "two|least|size"), (["1", "2"], [1], "mass"), ([], [], "size"),
    (["-1", "2"], [1, 0], "size"), ("12", [1, 0], "text is no list"), (3, [1, 0], "no list")])
def test_what_is_no_gradation_is_refused(sizes, masses, what):
    with pytest.raises(mdm.InputError, match=what):
        mdm.Gradation(sizes, masses)


def test_a_unit_that_is_unknown_is_refused():
    with pytest.raises(mdm.InputError, match="'ft' is unknown: use mm, um or m"):
        mdm.Gradation(["1", "2"], [1, 0], "ft")


@pytest.mark.parametrize("path", SANDS, ids=lambda path: path.stem)
def test_read_gives_what_convert_writes(path):
    assert program("convert", path)[1] == mdm.read(path).csv()
    assert program("convert", path, "--format", "json")[1] == mdm.read(path).json()


FORMATS = sorted(path for path in (SOURCE / "examples/gradations/formats").iterdir() if path.name != "README.md")


@pytest.mark.parametrize("path", FORMATS, ids=lambda path: path.name)
def test_every_format_of_the_examples_is_read(path):
    code, csv, error = program("convert", path)
    if code == 0:
        assert mdm.read(path).csv() == csv
    else:
        with pytest.raises(mdm.InputError):
            mdm.read(path)
        assert error


def test_the_words_of_reading_are_keywords(tmp_path):
    file = tmp_path / "table.csv"
    file.write_text("a,b,c\n0.1,x,30\n0.2,x,20\n0.4,x,0\n")
    assert mdm.read(file, columns="1,3", kind="retained", unit="mm").masses == (30, 20, 0)
    with pytest.raises(mdm.InputError):
        mdm.read(file)
    file.write_text("Size (mm),Mass (g)\n0.1,30\n0.2,20\n0.4,0\n")
    with pytest.raises(mdm.InputError, match=":1: unit um: the column 'Size \\(mm\\)' is in mm"):
        mdm.read(file, unit="um")
    with pytest.raises(mdm.InputError, match=":1: kind passing: the column 'Mass \\(g\\)' is what each sieve retains"):
        mdm.read(file, kind="passing")
    with pytest.raises(TypeError, match="unexpected keyword"):
        mdm.read(file, colums="1,3")


def test_an_error_has_its_file_and_line(tmp_path):
    file = tmp_path / "bad.csv"
    file.write_text("size_mm,mass\n1,2\n2,x\n3,0\n")
    with pytest.raises(mdm.InputError) as caught:
        mdm.read(file)
    assert caught.value.file == str(file) and caught.value.line == 3 and isinstance(caught.value, ValueError)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (str(again), again.file, again.line) == (str(caught.value), str(file), 3)


@pytest.mark.parametrize("content", [b"", b"\x00\xff\xfe", b"{", b"[]", b"size_mm,mass", b"PK\x03\x04junk", b"\n" * 1000])
def test_nonsense_in_a_file_is_refused(tmp_path, content):
    file = tmp_path / "nonsense"
    file.write_bytes(content)
    with pytest.raises(mdm.InputError, match="nonsense") as caught:
        mdm.read(file)
    assert caught.value.file == str(file)


def test_a_file_that_is_not_there_is_refused(tmp_path):
    for path in (tmp_path / "none.csv", tmp_path, "a\0b"):
        with pytest.raises(mdm.InputError, match="cannot be read"):
            mdm.read(path)


def test_particles_are_no_gradation_but_have_one(tmp_path):
    file = tmp_path / "sizes.csv"
    file.write_text("size_mm,quantity\n1,3\n2,1\n")
    with pytest.raises(mdm.InputError, match="read_sample"):
        mdm.read(file)
    assert mdm.read_sample(file).csv() == program("convert", file)[1]


def test_a_gradation_is_a_value():
    g = mdm.read(SAND)
    again = pickle.loads(pickle.dumps(g))
    assert again == g and hash(again) == hash(g) and again.csv() == g.csv() and again.notes == g.notes
    assert g != sand() and g != "sand"
    with pytest.raises(AttributeError, match="does not change"):
        g.id = "other"
    with pytest.raises(AttributeError, match="does not change"):
        del g.id


def test_half_phi_is_enclosed_and_survives_a_pickle(tmp_path):
    file = tmp_path / "phi.csv"
    file.write_text("size_phi,mass\n1.5,20\n0.5,30\n-0.5,0\n")
    g = mdm.read(file)
    assert all(isinstance(size, mdm.Enclosure) for size in g.sizes)
    assert pickle.loads(pickle.dumps(g)) == g
    match = mdm.solve(g)
    assert match.check() and match.status == "optimal"


def test_it_shows_itself():
    g = sand()
    assert repr(g) == "<Gradation 'sand': 3 classes, 0.1 to 0.8 mm>"
    html = g._repr_html_()
    assert html.count("<tr>") == 4 and "<svg" in html and html.count("<polyline") == 1
    assert "<script>" not in mdm.Gradation(["0", "1"], [1, 0], id="<script>")._repr_html_()


def test_a_frame_has_a_row_a_class():
    pytest.importorskip("pandas")
    frame = sand().to_frame()
    assert list(frame.columns) == ["lower", "upper", "mass", "share"] and len(frame) == 3
