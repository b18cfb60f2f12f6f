"""The best mix of stockpiles."""

import itertools
import json
import subprocess
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import exactmdm as mdm
import pytest
from support import SOURCE, mdm as program

BLEND = SOURCE / "examples/08-blend"
STOCKPILES = [BLEND / f"{name}.csv" for name in "ABCD"]
COSTS = {"A": "7.00", "B": Decimal("10.82"), "C": "9.51", "D": Fraction(222, 25)}


def stockpile(name, finest, middle):
    """What passes 1 mm and 2 mm, in percent; all passes 4 mm."""
    return mdm.Gradation(["0.5", "1", "2", "4"], [finest, middle - finest, 100 - middle, 0], id=name)


def limits(folder, *rows):
    file = folder / "limits.csv"
    lines = [",".join(map(str, row)) for row in rows]
    file.write_text("\n".join(["size_mm,passing_min_percent,passing_max_percent", *lines, "4,100,100"]) + "\n")
    return file


def test_the_published_problem_has_its_answer_and_a_proof(tmp_path):
    found = mdm.blend(STOCKPILES, BLEND / "limits.csv", cost=COSTS, proof=tmp_path / "a.proof")
    assert found and found.status == "optimal" and found.aim == "cost" and found.steps == 100
    assert found.best[0].shares == dict(zip("ABCD", (Fraction(n, 100) for n in (61, 11, 27, 1))))
    assert found.real.value == Fraction(193093911, 23865550) and len(found.rounded.broken) == 2
    checker = Path(mdm.program.program()).resolve().with_name("mdm-check")
    checked = subprocess.run([checker, BLEND / "limits.csv", *STOCKPILES, tmp_path / "a.proof"], stdout=subprocess.PIPE)
    assert checked.returncode == 0, checked.stdout
    text = program("blend", *STOCKPILES, "--spec", BLEND / "limits.csv", "--cost", "A=7.00,B=10.82,C=9.51,D=8.88",
                   "--format", "json", "--quiet")[1]
    assert found.json() + "\n" == text
    assert mdm.solve(found.blended, tolerance="retained:2%")


def test_blends_are_those_of_an_enumeration(tmp_path):
    piles = [stockpile("a", 80, 90), stockpile("b", 10, 50), stockpile("c", 0, 5)]
    cost = {"a": 3, "b": 5, "c": 2}
    file = limits(tmp_path, (1, 20, 40), (2, 40, 60))
    found = mdm.blend(piles, file, cost=cost, step="5%", all=1000)
    expected = []
    for a, b in itertools.product(range(21), repeat=2):
        c = 20 - a - b
        if c >= 0 and 20 <= Fraction(80 * a + 10 * b, 20) <= 40 and 40 <= Fraction(90 * a + 50 * b + 5 * c, 20) <= 60:
            expected.append((Fraction(3 * a + 5 * b + 2 * c, 20), a, b, c))
    assert [(one.value, *(share * 20 for share in one.shares.values())) for one in found.best] == sorted(expected)
    assert found.complete and len(expected) > 10
    assert "a " in repr(found) and "<table" in found._repr_html_()


def test_a_fineness_modulus_is_limited(tmp_path):
    piles = [mdm.Gradation(["0.1", "1", "4"], [mass, 100 - mass, 0], id=name) for name, mass in (("fine", 100), ("coarse", 0))]
    found = mdm.blend(piles, limits(tmp_path, (1, 0, 100), (2, 0, 90)), limit=["FM-EN=3..4"], all=1000)
    assert found.complete and set(found.best[0].moduli) == {"FM-EN"}
    assert all(3 <= one.moduli["FM-EN"] <= 4 for one in found.best)
    free = mdm.blend(piles, limits(tmp_path, (1, 0, 100), (2, 0, 90)), all=1000)
    assert len(free.best) > len(found.best) and free.best[0].moduli == {}


def test_where_there_is_none_the_contradiction_is_told():
    found = mdm.blend([BLEND / "impossible" / f"{name}.csv" for name in "AB"], BLEND / "impossible" / "limits.csv")
    assert not found and found.status == "none" and found.best == () and found.blended is None
    assert [(c.of, c.name, c.side, c.multiplier) for c in found.contradiction] == [
        ("passing", Fraction(25, 2), "most", Fraction(9, 10)), ("passing", Fraction(3, 40), "least", 1)]
    assert found.widened.value == Fraction(19, 5)
    assert repr(found) == "<Blends: none>" and "<table" in found._repr_html_()


def test_a_target_is_met_as_well_as_can_be(tmp_path):
    piles = [stockpile("a", 100, 100), stockpile("b", 0, 0)]
    file = limits(tmp_path, (1, 0, 100))
    found = mdm.blend(piles, file, target=stockpile("wished", 30, 30), minimise="max-deviation", step="20%")
    assert found.aim == "max-deviation" and found.best[0].value == 10
    assert found.best[0].shares["a"] == Fraction(1, 5)  # 40 % are as good: the first has less
    assert mdm.blend(piles, file, target=stockpile("wished", 30, 30), share=["a=35..50%"]).best[0].shares["a"] == Fraction(7, 20)


def test_a_limit_hands_over_what_is_certain():
    with pytest.raises(mdm.LimitReached) as limit:
        mdm.blend(STOCKPILES, BLEND / "limits.csv", cost=COSTS, node_limit=1)
    assert limit.value.known.status in ("feasible", "unknown")
    assert json.loads(limit.value.known.json())["schema"] == "mdm-blend-1"


def test_messages_name_keywords(tmp_path):
    file = limits(tmp_path, (1, 0, 100))
    piles = [stockpile("a", 100, 100), stockpile("b", 0, 0)]
    for options, word in [({"at_most_stockpiles": "x"}, "at_most_stockpiles"), ({"cost": {"a": 1}}, "cost"),
                          ({"share": {"z": "1.."}}, "share"), ({"minimise": "cost"}, "minimise"), ({"step": "7%"}, "step")]:
        with pytest.raises(mdm.InputError, match=rf"(?<!-)\b{word}\b"):
            mdm.blend(piles, file, **options)
    for options in ({"cost": {"a": 0.5, "b": 1}}, {"all": 1.5}):
        with pytest.raises(mdm.InputError, match="float"):
            mdm.blend(piles, file, **options)
    with pytest.raises(mdm.InputError):
        mdm.blend(piles[:1] * 2, file)  # one name twice
    with pytest.raises(TypeError):
        mdm.blend([7], file)
