"""Gradations made of others."""

from fractions import Fraction

import exactmdm as mdm
import pytest

SIEVES = mdm.Gradation(["0", "0.075", "0.425", "2", "20", "40"], [20, 30, 40, 9, 1, 0], id="sieves")
HYDROMETER = mdm.Gradation(["0", "0.002", "0.02", "0.075"], ["1.5", 4, "4.5", 0], id="hydrometer")


def shares(gradation):
    whole = sum(gradation.masses)
    return [Fraction(mass) / whole for mass in gradation.masses]


def test_two_analyses_are_joined():
    made = mdm.regrade(join=(SIEVES, HYDROMETER), at="75um")
    assert made.gradation.id == "sieves"
    assert shares(made.gradation) == [Fraction(n, 1000) for n in (30, 80, 90, 300, 400, 90, 10, 0)]
    assert made.history[0] == "made by mdm convert of sieves.json and hydrometer.json"
    assert "/" not in made.history[1]


def test_a_part_that_was_sieved_stands_for_the_whole(tmp_path):
    coarse = mdm.Gradation(["4", "8", "16"], [300, 700, 0], id="coarse")
    fine = mdm.Gradation(["0", "1", "4"], [20, 30, 0], id="fine")
    made = mdm.regrade(split=(coarse, fine), at="4mm", fine_mass=500)
    assert shares(made.gradation) == [Fraction(n, 1500) for n in (200, 300, 300, 700, 0)]
    file = tmp_path / "of a file.json"
    file.write_text(coarse.json(), encoding="utf-8")
    again = mdm.regrade(split=(file, fine), at="4mm", fine_mass=500)
    assert shares(again.gradation) == shares(made.gradation) and str(file) in again.history[0]


def test_changes_follow_each_other():
    made = mdm.regrade(SIEVES, scalp="above:20mm", replace="above:2mm into 0.075mm..2mm", parallel="1/2")
    assert list(made.gradation.sizes) == [Fraction(text) / 2 for text in ("0", "0.075", "0.425", "2")]
    # 9 of 99 above 2 mm go to the two classes below, in the shares 30 and 40.
    assert shares(made.gradation)[:2] == [Fraction(20, 99), Fraction(30, 99) * Fraction(79, 70)]
    assert len(made.history) == 5


def test_what_is_wrong_names_keywords():
    for keywords, part in (({"join": (SIEVES, HYDROMETER)}, "at"), ({"source": SIEVES, "fine_mass": 5}, "fine_mass"),
                           ({}, "join"), ({"source": SIEVES, "scalp": "20mm"}, "scalp"),
                           ({"source": SIEVES, "replace": "above:20mm"}, "replace"),
                           ({"source": SIEVES, "replace": "above:20mm to 2mm..20mm"}, "replace")):
        with pytest.raises(mdm.InputError) as error:
            mdm.regrade(**keywords)
        assert part in str(error.value) and "--" not in str(error.value), error.value
    with pytest.raises(mdm.InputError, match="parallel: 0.2 is a float"):
        mdm.regrade(SIEVES, parallel=0.2)
