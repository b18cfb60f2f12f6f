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
