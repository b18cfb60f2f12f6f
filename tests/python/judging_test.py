"""Solvers are judged as by `mdm crosscheck`."""

import json
import pickle

import exactmdm as mdm
import pytest
from support import SUITE, mdm as program, sand, suite


def verdict(solver, gradation=None):
    return mdm.crosscheck([gradation or sand()], solver).rows[0]


def test_the_library_is_minimal_in_every_form():
    best = mdm.solve(sand())
    for answer in (best, list(best.quantities), best.quantities, (best.quantities, best.sizes),
                   {"quantities": [str(n) for n in best.quantities]}, (best.quantities, [float(s) for s in best.sizes])):
        row = verdict(lambda g: answer)
        assert row.verdict == "minimal" and row.particles == row.minimum == 6 and row.ratio == 1, answer


def test_a_larger_match_is_told_from_none():
    more = mdm.solve(sand(), at_least=20)
    row = verdict(lambda g: more)
    assert row.verdict == "larger" and row.minimum == 6 and row.particles == more.particles
    row = verdict(lambda g: [1, 1, 1])
    assert row.verdict == "not-a-match" and row.reason and not mdm.crosscheck([sand()], lambda g: [1, 1, 1])


def test_wrong_sizes_are_no_match():
    best = mdm.solve(sand())
    assert verdict(lambda g: (best.quantities, ["0.15", "0.3", "0.7"])).verdict == "not-a-match"


@pytest.mark.parametrize("answer", [3, "x", [1.5], [[1]], {"quantities": "x"}, [-1, 1, 1], object(), [], {"a": object()}, b"1"],
                         ids=str)
def test_nonsense_is_garbage_or_no_match(answer):
    assert verdict(lambda g: answer).verdict in ("garbage", "not-a-match", "no-answer")


def test_none_is_no_answer_and_an_exception_a_crash():
    assert verdict(lambda g: None).verdict == "no-answer"
    row = verdict(lambda g: 1 / 0)
    assert row.verdict == "crashed" and row.reason == "ZeroDivisionError: division by zero"


def test_a_call_that_takes_too_long_is_killed_and_the_next_one_asked():
    import os
    import time

    def solver(gradation):
        if gradation.id == "slow":
            time.sleep(60)
        if gradation.id == "dies":
            os._exit(3)
        return [3, 1] if gradation.id == "right" else 1 / 0

    small = [mdm.Gradation(["1", "2", "3"], [2, 1, 0], id=id) for id in ("slow", "dies", "right", "raises")]
    judged = mdm.crosscheck(small, solver, time_limit=2)
    assert [row.verdict for row in judged.rows] == ["timeout", "crashed", "minimal", "crashed"]
    assert judged.rows[0].reason == "killed after 2 s"
    assert judged.rows[1].reason == "its process ended without an answer"
    with pytest.raises(mdm.InputError, match="is not above 0"):
        mdm.crosscheck(small, solver, time_limit=0)


@pytest.mark.parametrize("solver", ["./solver", None, 3])
def test_what_is_no_function_is_refused(solver):
    with pytest.raises(mdm.InputError, match="is no function: give one"):
        mdm.crosscheck([sand()], solver)


def test_ctrl_c_in_a_solver_is_no_crash():
    def solver(gradation):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        mdm.crosscheck([sand()], solver)


def test_rows_are_those_of_the_command_line(tmp_path):
    file, answers = tmp_path / "suite.jsonl", tmp_path / "answers.jsonl"
    lines = suite(40)
    file.write_text("".join(json.dumps(line) + "\n" for line in lines))

    def solver(gradation):
        best = mdm.solve(gradation).quantities
        return [2 * n for n in best] if best[0] % 2 else [n + 1 for n in best]

    found = mdm.crosscheck(file, solver)
    gradations = mdm.batch(file)
    answers.write_text("".join(json.dumps({"id": m.id, "quantities": [str(n) for n in solver(m.gradation)]}) + "\n"
                               for m in gradations))
    rows = json.loads(program("crosscheck", file, answers, "--format", "json")[1])["rows"]
    assert [(row.id, row.verdict, str(row.minimum)) for row in found.rows] == [
        (row["id"], row["verdict"], row["minimum"]) for row in rows]
    assert len(found.counts) == 2 and sum(found.counts.values()) == 40
    assert pickle.loads(pickle.dumps(found)) == found and "40" in repr(found) or found.counts


@pytest.mark.parametrize("options, what", [({"size_tolerance": 1}, "size_tolerance"),
                                           ({"size_tolerance": "-1"}, "size_tolerance"), ({"max_steps": "x"}, "max_steps")], ids=str)
def test_wrong_options_are_refused(options, what):
    with pytest.raises(mdm.InputError, match=what):
        mdm.crosscheck([sand()], lambda g: [1], **options)


def test_what_is_no_gradation_is_refused():
    with pytest.raises(TypeError, match="int is no Gradation"):
        mdm.crosscheck([3], lambda g: [1])


def test_a_bad_suite_is_refused(tmp_path):
    file = tmp_path / "suite.jsonl"
    file.write_text("{}\n")
    with pytest.raises(mdm.InputError, match="suite.jsonl:1"):
        mdm.crosscheck(file, lambda g: None)


def test_a_table_has_a_row_an_answer():
    found = mdm.crosscheck([sand(), sand()], lambda g: None)
    assert found._repr_html_().count("<tr>") == 3 and repr(found) == "<Crosscheck: 2 no-answer>"
    pytest.importorskip("pandas")
    assert list(found.to_frame()["verdict"]) == ["no-answer"] * 2


def test_an_answer_within_a_tolerance_is_judged_by_the_question():
    gradation = mdm.Gradation(["0.1", "0.2", "0.4", "0.8"], [20, 30, 50, 0], id="sand")
    asked = {"tolerance": "retained:2%"}
    minimal = mdm.solve(gradation, **asked)
    assert minimal.particles == 5
    assert mdm.crosscheck([gradation], lambda _: minimal.quantities).rows[0].verdict == "not-a-match"
    row = mdm.crosscheck([gradation], lambda _: minimal.quantities, **asked).rows[0]
    assert (row.verdict, row.particles, row.minimum) == ("minimal", 5, 5)
    exact = mdm.solve(gradation)
    row = mdm.crosscheck([gradation], lambda _: exact.quantities, **asked).rows[0]
    assert (row.verdict, row.particles, row.minimum) == ("larger", 6, 5)


def test_other_parts_of_the_question_are_judged_too(tmp_path):
    gradation = mdm.Gradation(["1", "2", "3"], [2, 1, 0], id="sand")
    band = tmp_path / "band.csv"
    band.write_text("size_mm,passing_min_percent,passing_max_percent\n1,0,0\n2,40,60\n3,100,100\n")
    for asked in ({"min_per_class": 5}, {"at_least": 12}, {"band": band}, {"size_factor": 2}, {"law": "power:2"}):
        match = mdm.solve(gradation, **asked)
        row = mdm.crosscheck([gradation], lambda _, match=match: match.quantities, **asked).rows[0]
        assert (row.verdict, row.minimum) == ("minimal", match.particles), asked


def test_a_solver_may_say_that_there_is_no_match():
    gradation = mdm.Gradation(["1", "2", "3"], [2, 1, 0], id="sand")
    row = mdm.crosscheck([gradation], lambda _: {"status": "infeasible"}).rows[0]
    assert row.verdict == "infeasible"


@pytest.mark.parametrize("asked, keyword", [({"tolerance": "often"}, "tolerance"), ({"specimen": "box:1x2x3"}, "void_ratio"),
                                            ({"size_tolerance": 2}, "size_tolerance"), ({"node_limit": "x"}, "node_limit")])
def test_a_wrong_question_is_refused_by_its_keyword(asked, keyword):
    with pytest.raises(mdm.InputError, match=keyword):
        mdm.crosscheck([mdm.Gradation(["1", "2", "3"], [2, 1, 0])], lambda _: [3, 1], **asked)
