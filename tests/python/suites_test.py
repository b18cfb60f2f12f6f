"""Suites from a description: those of the command line, and refusals."""

import json

import pytest

import exactmdm
from support import mdm as program

DESCRIPTION = {"schema": "mdm-suite-1", "classes": [2, 6], "sieves": {"series": "ISO R20/3", "from": 0.063, "to": 31.5},
               "masses": {"kind": "lognormal", "median": [0.2, 0.8], "deviation": [0.3, 1]}}


def test_lines_are_those_of_the_command_line(tmp_path):
    file = tmp_path / "description.json"
    file.write_text(json.dumps(DESCRIPTION))
    code, told, _ = program("suite", file, "--seed", "5", "--lines", "11-30")
    assert code == 0
    for description in (DESCRIPTION, file):
        made = exactmdm.suite(description, seed=5, lines=range(11, 31))
        assert "".join(gradation.json() for gradation in made) == told


def test_a_suite_has_a_thousand_lines():
    assert [gradation.id for gradation in exactmdm.suite(DESCRIPTION)][-1] == "g-1000"
    assert list(exactmdm.suite(DESCRIPTION, count=0)) == []


def test_nonsense_is_refused(tmp_path):
    file = tmp_path / "none.json"
    with pytest.raises(exactmdm.InputError, match="none.json"):
        exactmdm.suite(file)
    file.write_bytes(b"\xff\x00")
    with pytest.raises(exactmdm.InputError, match="none.json"):
        exactmdm.suite(file)
    with pytest.raises(exactmdm.InputError, match="description"):
        exactmdm.suite({"schema": "mdm-suite-1", "classes": "many"})
    with pytest.raises(exactmdm.InputError, match="seed"):
        exactmdm.suite(DESCRIPTION, seed=-1)
    with pytest.raises(exactmdm.InputError, match="lines"):
        exactmdm.suite(DESCRIPTION, lines=range(0, 3))
    with pytest.raises(exactmdm.InputError, match="one of them"):
        exactmdm.suite(DESCRIPTION, count=3, lines=range(1, 3))
