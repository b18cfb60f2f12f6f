"""Spectra, trade-offs and descriptions: those of the command line."""

import json
import pickle
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import pytest
from support import SAND, SANDS, endless, mdm as program, sand

NARROW = mdm.Gradation(["10", "11", "12", "13"], [1, 1, 1, 0], id="narrow")


@pytest.mark.parametrize("options", [{}, {"particles": [100, 500]}, {"kind": "passing", "tolerances": ["0.5", 3]},
                                     {"kind": "total", "tolerances": ["0.5%"], "size_factor": 3}], ids=str)
def test_a_tradeoff_is_that_of_the_command_line(options):
    words = {"particles": lambda v: ",".join(map(str, v)), "tolerances": lambda v: ",".join(map(str, v))}
    flags = [word for key, value in options.items()
             for word in ("--" + key.replace("_", "-"), str(words.get(key, str)(value)))]
    text = program("tradeoff", SAND, *flags, "--format", "json")[1]
    found = mdm.tradeoff(SAND, **options)
    assert found.json() + "\n" == text and found.complete
    assert [row.particles for row in found.by_sieve] == [int(row["particles"]) for row in json.loads(text)["by_sieve"]]


def test_a_tradeoff_is_a_value_and_a_table():
    found = mdm.tradeoff(sand(), tolerances=[0, 1])
    assert pickle.loads(pickle.dumps(found)) == found and hash(found) == hash(mdm.tradeoff(sand(), tolerances=[0, 1]))
    assert found.by_sieve[1].lost == Fraction(1, 5) and found.by_sieve[0].smallest == Decimal("0.1")
    assert found._repr_html_().count("<tr>") == 7 and repr(found) == "<Tradeoff 'sand': 2 tolerances, 3 sieves>"
    pytest.importorskip("pandas")
    assert len(found.to_frame()) == 5


@pytest.mark.parametrize("options, what", [
    ({"kind": "other"}, "tolerances: "), ({"tolerances": ["x"]}, "tolerances: "), ({"tolerances": [0.5]}, "float"),
    ({"particles": [0]}, "particles: "), ({"particles": [5], "tolerance": 1}, "leave out"),
    ({"grid": 1}, "grid: ")], ids=str)
def test_a_wrong_tradeoff_is_refused(options, what):
    with pytest.raises(mdm.InputError, match=what):
        mdm.tradeoff(sand(), **options)


def test_rows_that_a_limit_ends_say_so():
    found = mdm.tradeoff(endless(), tolerances=[0], time_limit="0.1")
    assert not found.complete and found.by_tolerance[0].status in ("feasible", "unknown")


def test_a_spectrum_is_that_of_the_command_line(tmp_path):
    file = tmp_path / "narrow.csv"
    file.write_text(NARROW.csv())
    found = mdm.spectrum(file)
    answer = json.loads(program("solve", file, "--spectrum", "--format", "json")[1])["spectrum"]
    assert [list(map(str, interval)) for interval in found.intervals] == answer["intervals"]
    assert str(found.all_from) == answer["all_from"] and found.complete
    assert [n for n in range(20) if n in found] == [9, 12, 13, 15, 16, 17, 18, 19]
    assert pickle.loads(pickle.dumps(found)) == found


def test_a_spectrum_has_limits():
    with pytest.raises(mdm.LimitReached) as caught:
        mdm.spectrum(mdm.Gradation(["1000", "1001", "1002"], [1, 1, 0]), max_steps=2)
    assert isinstance(caught.value.known, (mdm.Spectrum, mdm.Match))
    with pytest.raises(mdm.InputError, match="exact match"):
        mdm.spectrum(sand(), tolerance=1)


@pytest.mark.parametrize("path", SANDS, ids=lambda path: path.stem)
def test_a_description_is_that_of_the_command_line(path):
    found = mdm.describe(path)
    assert found.json() + "\n" == program("describe", path, "--format", "json")[1]
    assert found.d10 is None or found.d10.lo <= found.d60.hi
    assert {part.name for part in found.uscs} >= {"gravel", "sand", "fines"}
    assert pickle.loads(pickle.dumps(found)) == found and found._repr_html_()


def test_a_description_takes_the_limits_of_the_fines():
    g = mdm.Gradation(["0", "0.075", "2"], [80, 20, 0])
    assert mdm.describe(g, liquid_limit=60, plastic_limit=20).group == "CH"
    assert mdm.describe(g, pan_size="0.001").d50 is not None
    for options in ({"liquid_limit": 30}, {"liquid_limit": 20, "plastic_limit": 30}, {"digits": 0}, {"digits": -1},
                    {"digits": 1001}, {"pan_size": 3}):
        with pytest.raises(mdm.InputError):
            mdm.describe(g, **options)


def test_a_description_has_what_is_asked_for():
    found = mdm.describe(mdm.Gradation(["0.2", "0.4"], [1, 0]), d="5,50,90", void_ratio="0.6")
    assert set(found.diameters) == {5, 90} and found.d43.lo == Decimal("0.2") and found.d43.hi == Decimal("0.4")
    assert found.k_kozeny_carman.lo < found.k_kozeny_carman.hi and found.aashto == "A-3" and found.aashto_index == 0 and found.iso_name == "Sa"
    assert found.fineness_modulus is not None and found.k_hazen.is_exact is False and 0 < float(found.span) < 1
    assert mdm.describe(mdm.Gradation(["0.2", "0.4"], [1, 0])).k_kozeny_carman is None
