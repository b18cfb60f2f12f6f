"""Samples judged by the limits of a specification."""

import json
from fractions import Fraction

import exactmdm as mdm
import pytest

SIEVES = ["9.5", "4.75", "2.36", "1.18", "0.6", "0.3", "0.15"]


def report(folder, percents, name="sand.csv"):
    file = folder / name
    rows = [f"{size},{percent}" for size, percent in zip(SIEVES, percents)]
    file.write_text("size_mm,passing_percent\n" + "\n".join(rows) + "\n")
    return file


def test_a_report_stands_for_all_curves_that_round_to_it(tmp_path):
    good = mdm.judge(report(tmp_path, [100, 97, 85, 67, 45, 20, 5]), "astm-c33-fine")
    assert good and good.verdict == "pass" and good.samples[0].rounded and good.samples[0].within is None
    edge = mdm.judge(report(tmp_path, [100, 97, 85, 85, 45, 20, 5]), "astm-c33-fine")
    sample = edge.samples[0]
    assert not edge and sample.verdict == "hangs"
    at = {limit.name: limit for limit in sample.limits}[Fraction("1.18")]
    assert (at.verdict, at.max, at.least.lo, at.most.hi) == ("hangs", 85, Fraction(169, 2), Fraction(85 + Fraction(1, 2)))
    assert sample.within[Fraction("1.18")] <= 85 < sample.outside[Fraction("1.18")]
    assert mdm.judge(report(tmp_path, [100, 97, 85, 85, 45, 20, 5]), "astm-c33-fine", rounding="none")


def test_limits_beside_the_sieves(tmp_path):
    file = report(tmp_path, [100, 97, 85, 67, 45, 20, 5])
    found = mdm.judge(file, "astm-c33-fine", limit=["FM=2.3..3.1", "retained=..45%"], rounding=0)
    numbers = {limit.name: limit for limit in found.samples[0].limits if isinstance(limit.name, str)}
    assert found and numbers["FM"].value.lo == numbers["FM"].value.hi == Fraction(281, 100)
    assert len(numbers) == 7 and numbers["FM"].min == Fraction(23, 10)
    assert mdm.judge(file, "astm-c33-fine", limit="FM=..2.8", rounding=0).verdict == "fail"


def test_several_samples_and_a_file_of_limits(tmp_path):
    limits = tmp_path / "limits.csv"
    limits.write_text("size_mm,passing_min_percent,passing_max_percent\n9.5,100,100\n0.6,40,50\n")
    one = report(tmp_path, [100, 97, 85, 67, 45, 20, 5], "one.csv")
    two = mdm.Gradation(["0.6", "9.5"], [100, 0], id="two")
    found = mdm.judge([one, two], limits)
    assert [(s.id, s.verdict) for s in found.samples] == [("one", "pass"), ("two", "fail")] and found.verdict == "fail"
    assert json.loads(found.json())["schema"] == "mdm-judge-1"
    assert "two fail" in repr(found) and "<table" in found._repr_html_()
    assert any("taken as exact" in note for note in found.samples[1].notes)


def test_what_is_wrong_names_keywords(tmp_path):
    file = report(tmp_path, [100, 97, 85, 67, 45, 20, 5])
    for keywords, part in (({"limit": "FM=2"}, "limit"), ({"rounding": -1}, "rounding"), ({"rounding": "x"}, "rounding")):
        with pytest.raises(mdm.InputError) as error:
            mdm.judge(file, "astm-c33-fine", **keywords)
        assert part in str(error.value) and "--" not in str(error.value), error.value
    with pytest.raises(mdm.InputError):
        mdm.judge(file, tmp_path / "no file")
