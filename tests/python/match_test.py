"""Matches: the answers of the command line, as values of Python."""

import json
import multiprocessing
import pickle
import threading
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import pytest
from support import SAND, SANDS, SOURCE, mdm as program, python_environment, sand

BAND = SOURCE / "examples/gradations/c33-fine-aggregate-limits.csv"

QUESTIONS = [
    {}, {"at_least": 2000}, {"min_per_class": 10}, {"at_most": 10}, {"law": "power:5/2"}, {"law": "sphere"},
    {"size_factor": "2.5"}, {"cut_below": "0.15"}, {"cut_below": "150um"}, {"digits": 40}, {"scale": "upper"},
    {"max_steps": 1}, {"solids_volume": "100"}, {"specimen": "cylinder:50x100", "void_ratio": "0.6"},
    {"specimen": "box:5mmx5mmx1mm", "void_ratio": Decimal("0.7")}, {"tolerance": "retained:1%"}, {"tolerance": 1},
    {"tolerance": Fraction(1, 2)}, {"tolerance": ["retained:1%", "passing:0.5%"]}, {"tolerance": "total:2%"},
    {"tolerance": "laboratory"}, {"tolerance": "rounding"}, {"tolerance": "1%", "gap": "0.1"},
    {"particles": 300}, {"particles": 100, "tolerance": "passing", "grid": "0.01"}]


def flags(question):
    """The options of the command line."""
    words = []
    for name, value in question.items():
        for one in value if isinstance(value, list) else [value]:
            words += ["--" + name.replace("_", "-"), str(Decimal("0.5")) if isinstance(one, Fraction) else str(one)]
    return words


@pytest.mark.parametrize("question", QUESTIONS, ids=str)
def test_the_answer_is_that_of_the_command_line(question):
    code, text, _ = program("solve", SAND, *flags(question), "--format", "json")
    try:
        match = mdm.solve(mdm.read(SAND), **question)
    except mdm.LimitReached as limit:
        match = limit.known
        assert code == 3
    else:
        assert code == (1 if match.status == "none" else 0)
    assert match.json() == text.rstrip("\n")
    assert match.csv() == program("solve", SAND, *flags(question), "--format", "csv")[1]
    assert program("solve", SAND, *flags(question), "--verbose")[1].startswith(match.text()[:40])


@pytest.mark.parametrize("path", SANDS, ids=lambda path: path.stem)
def test_sands_of_the_examples_are_solved_and_checked(path, tmp_path):
    match = mdm.solve(path)
    proof = tmp_path / "sand.proof"
    assert program("solve", path, "--proof", proof, "--format", "json")[1] == match.json() + "\n"
    assert match.certificate() == proof.read_text()
    verdict = match.check()
    assert verdict and verdict.status == "accepted" and f"N = {match.particles} " in verdict.proved
    assert mdm.verify(path, match)


def test_the_parts_of_a_match():
    match = mdm.solve(sand())
    answer = json.loads(match.json())
    assert match.particles == sum(match.quantities) == match.lower_bound == match.upper_bound == 6
    assert [str(c.quantity) for c in match.classes] == [c["quantity"] for c in answer["classes"]]
    assert all(c.lower < c.size.lo <= c.size.hi <= c.upper for c in match.classes)
    assert [Fraction(c["mass"]) for c in answer["classes"]] == [20, 30, 50]
    assert match.scale.above < match.scale.chosen <= match.scale.up_to and match.scale.power == 1
    assert match.achieved is None and match.budget is None and match.finer is None and match.question == ""
    assert match.solids_volume.lo < match.solids_volume.hi
    assert match.gradation == sand() and match.id == "sand" and match.unit == "mm" and match.notes == ()


def test_an_empty_class_has_no_size():
    match = mdm.solve(mdm.Gradation(["1", "2", "3", "4"], [1, 0, 1, 0]))
    assert match.quantities[1] == 0 and match.sizes[1] is None
    match.to_frame()


def test_a_tolerance_has_shares_that_are_within_it():
    match = mdm.solve(sand(), tolerance="retained:2%")
    assert sum(match.achieved) == 1
    assert all(abs(found - asked) <= Fraction(2, 100) for found, asked in zip(match.achieved, sand().shares))
    assert match.scale.above is None and match.check()


def test_a_band_alone_is_solved_and_checked():
    match = mdm.solve(band=BAND)
    assert match.json() == program("solve", "--band", BAND, "--format", "json")[1].rstrip("\n")
    assert match.gradation is None and match.check()
    assert pickle.loads(pickle.dumps(match)).check()


def test_a_budget_says_its_tolerance_and_that_the_next_finer_needs_more():
    match = mdm.budget(SAND, 300)
    assert match.particles <= 300 < match.finer.lower_bound
    assert match.budget.next_finer < match.budget.tolerance and match.budget.particles == 300
    assert match.check() and match.finer.check()
    again = pickle.loads(pickle.dumps(match))
    assert again.csv() == match.csv() and again.finer.csv() == match.finer.csv() and again.finer.check()
    with pytest.raises(mdm.InputError, match="particles"):
        mdm.budget(SAND, 0)


def test_a_budget_buys_the_least_size_factor_of_a_specimen():
    question = {"specimen": "cylinder:50mmx100mm", "void_ratio": "0.6"}
    match = mdm.solve(SAND, particles=20000, by="size-factor", **question)
    budget = match.budget
    assert budget.tolerance is None and budget.next_finer < budget.size_factor
    assert match.particles <= 20000 < match.finer.lower_bound
    assert mdm.solve(SAND, size_factor=budget.size_factor, **question).particles == match.particles
    assert mdm.solve(SAND, size_factor=budget.next_finer, **question).particles == match.finer.lower_bound
    row = mdm.tradeoff(SAND, tolerances=[0], particles=[20000], **question).by_size_factor[-1]
    assert (row.size_factor, row.particles) == (budget.size_factor, match.particles)
    with pytest.raises(mdm.InputError, match="^by: "):
        mdm.solve(SAND, by="size-factor")


@pytest.mark.parametrize("question, what", [
    ({"tolerance": "retained:x"}, "tolerance: "), ({"tolerance": "none"}, "tolerance: "), ({"law": "cube"}, "law: "),
    ({"at_least": -1}, "at_least: "), ({"at_least": "1.5"}, "at_least: "), ({"at_least": 1.0}, "float"),
    ({"size_factor": 0}, "size_factor: "), ({"void_ratio": "1"}, "belong together"), ({"gap": "1"}, "gap: "),
    ({"specimen": "ball:3", "void_ratio": 1}, "^specimen: "), ({"cut_below": "7ft"}, "cut_below: "),
    ({"cut_below": "0.111"}, "cut|sieve|opening"), ({"digits": 0}, "digits: "), ({"digits": 10**9}, "digits: "),
    ({"scale": "big"}, "scale: "), ({"scale": "upper", "tolerance": 1}, "scale: "), ({"grid": 1}, "grid: "),
    ({"particles": 5, "at_most": 3}, "at_most: "), ({"particles": 5, "tolerance": "1%"}, "tolerance: "),
    ({"max_steps": 1, "tolerance": 1}, "max_steps: "), ({"node_limit": 1}, "node_limit: "),
    ({"time_limit": -1}, "time_limit: "), ({"time_limit": float("nan")}, "time_limit: "), ({"band": "none.csv"}, "none.csv"),
    ({"tolerance": [1, 0.5]}, "float"), ({"tolerance": "retained:file"}, "tolerance"), ({"law": "power:9999"}, "law: ")],
    ids=str)
def test_a_wrong_question_is_refused(question, what):
    with pytest.raises(mdm.InputError, match=what):
        mdm.solve(SAND, **question)


def test_a_match_is_made_by_solving_alone():
    for made in (mdm.Match, mdm.Verification, mdm.GeneratedSet):
        with pytest.raises(TypeError, match="call them"):
            made()


def test_nothing_to_solve_is_refused():
    with pytest.raises(mdm.InputError, match="a gradation is missing"):
        mdm.solve()
    with pytest.raises(TypeError, match="int is no gradation"):
        mdm.solve(3)
    with pytest.raises(TypeError, match="tolerence"):
        mdm.solve(SAND, tolerence=1)


def test_a_match_is_a_value():
    match = mdm.solve(sand())
    again = pickle.loads(pickle.dumps(match))
    assert again == match and hash(again) == hash(match) and again.json() == match.json()
    assert again.check() and again.certificate() == match.certificate()
    assert again.csv() == match.csv() and again.text() == match.text() and list(again.spread(3)) == list(match.spread(3))
    assert match != mdm.solve(sand(), at_least=7)
    with pytest.raises(AttributeError, match="does not change"):
        match.finer = match


def test_an_answer_within_no_limits_is_none():
    match = mdm.solve(sand(), at_most=5)
    assert match.status == "none" and match.particles is None and match.lower_bound == 6
    assert match.check() and match.scale is None and match.solids_volume is None
    assert "none" in repr(match) and match._repr_html_()
    with pytest.raises(mdm.InputError, match="no match to spread"):
        match.spread()


def test_a_spread_is_that_of_the_command_line():
    text = program("solve", SAND, "--spread", "--seed", "7", "--format", "csv")[1]
    rows = [line.split(",")[2:] for line in text.splitlines()[1:]]
    spread = mdm.solve(SAND).spread(7)
    assert [[str(size.lo), str(size.hi)] for size in spread] == rows and len(spread) == len(rows)
    assert list(pickle.loads(pickle.dumps(spread))) == list(spread)
    for seed in (-1, 1 << 64):
        with pytest.raises(mdm.InputError, match="seed"):
            mdm.solve(sand()).spread(seed)


def test_it_shows_itself():
    match = mdm.solve(sand())
    assert repr(match) == "<Match 'sand': 6 particles, optimal, 3 classes>"
    html = match._repr_html_()
    assert html.count("<tr>") == 4 and html.count("<polyline") == 2
    huge = mdm.solve(sand(), at_least=10**900)
    assert len(repr(huge)) < 100 and "about 10^" in repr(huge) and huge._repr_html_()


def test_a_frame_has_a_row_a_class():
    pytest.importorskip("pandas")
    frame = mdm.solve(sand()).to_frame()
    assert list(frame["quantity"]) == list(mdm.solve(sand()).quantities) and frame["size"].notna().all()


def test_the_proof_in_vipr_is_that_of_the_command_line(tmp_path):
    proof = tmp_path / "sand.vipr"
    program("solve", SAND, "--vipr", proof)
    assert mdm.solve(SAND).vipr() == proof.read_text()


def test_threads_solve_at_once():
    found = []
    threads = [threading.Thread(target=lambda: found.append(mdm.solve(SAND, tolerance=1).particles)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 4 and len(set(found)) == 1


def test_processes_hand_matches_over(monkeypatch):
    for name, value in python_environment().items():
        monkeypatch.setenv(name, value)
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        matches = pool.map(mdm.solve, [sand(), mdm.read(SAND)])
    assert [match.particles for match in matches] == [6, 1485] and all(match.check() for match in matches)
