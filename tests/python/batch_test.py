"""Batches: the answers of `mdm batch`, in order, as they come."""

import itertools
import json
import time

import exactmdm as mdm
import pytest
from support import SUITE, endless, mdm as program, sand, suite


@pytest.fixture(scope="module")
def some(tmp_path_factory):
    """A part of the suite in a file."""
    file = tmp_path_factory.mktemp("batch") / "suite.jsonl"
    file.write_text("\n\n".join(json.dumps(line) for line in suite(300)) + "\n")
    return file


@pytest.mark.parametrize("question", [{}, {"at_least": 1000}, {"tolerance": "retained:2%", "gap": "0.2"},
                                      {"particles": 40, "tolerance": "passing", "grid": "0.5"}], ids=str)
@pytest.mark.parametrize("threads", [1, 2])
def test_answers_are_those_of_the_command_line(some, question, threads):
    flags = [word for name, value in question.items() for word in ("--" + name.replace("_", "-"), str(value))]
    text = program("batch", some, *flags)[1]
    matches = list(mdm.batch(some, threads=threads, **question))
    assert "".join(match.json() + "\n" for match in matches) == text


def test_gradations_at_hand_and_a_file_are_the_same(some):
    gradations = [mdm.Gradation(line["sizes"], line["masses"], line.get("unit", "mm"), line["id"])
                  for line in suite(20)]
    assert [m.particles for m in mdm.batch(gradations)] == [m.particles for m in itertools.islice(mdm.batch(some), 20)]


def test_proofs_are_kept_where_they_are_asked_for():
    kept, = mdm.batch([sand()], proofs=True)
    assert kept.check() and kept.gradation == sand()
    again, = mdm.batch([sand()])
    assert again == kept and again.certificate() == kept.certificate() and again.check() and again.csv() == kept.csv()
    unkept, = mdm.batch([endless()], max_steps=100)
    with pytest.raises(mdm.InputError, match="not kept"):
        unkept.certificate()
    bounds, = mdm.batch([endless()], max_steps=100, proofs=True)
    assert f" between {bounds.lower_bound} and " in bounds.check().proved
    with pytest.raises(mdm.InputError, match="not kept"):
        mdm.solve(sand(), max_steps=10**9).certificate()


def test_a_budget_in_a_batch_keeps_the_finer_match_with_the_proofs():
    kept, = mdm.batch([sand()], particles=4, tolerance="retained", proofs=True)
    alone = mdm.budget(sand(), 4)
    assert kept == alone and kept.budget == alone.budget and kept.finer == alone.finer
    assert kept.finer.check() and kept.finer.lower_bound == 5
    unkept, = mdm.batch([sand()], particles=4, tolerance="retained")
    assert unkept == kept and unkept.finer is None and unkept.check()


def test_an_endless_iterator_is_taken_bit_by_bit():
    taken = itertools.count()
    gradations = (sand() for _ in taken)
    assert [m.particles for m in itertools.islice(mdm.batch(gradations, threads=2), 5)] == [6] * 5
    assert next(taken) < 2000


def test_a_bad_gradation_is_an_error_in_its_place(tmp_path):
    file = tmp_path / "suite.jsonl"
    good = '{"sizes": ["1", "2"], "masses": ["1", "0"]}\n'
    file.write_text(good + '{"sizes": [}\n' + good)
    first, bad, last = mdm.batch(file, errors="yield")
    assert first.particles == last.particles == 1 and first.id == "1" and last.id == "3"
    assert isinstance(bad, mdm.InputError) and bad.file == str(file) and bad.line == 2
    with pytest.raises(mdm.InputError, match=":2: "):
        list(mdm.batch(file))


def test_a_limit_is_of_each_gradation():
    matches = list(mdm.batch([sand(), endless(), sand()], threads=2, time_limit=0.3, max_steps=10**15))
    assert [match.status for match in matches] == ["optimal", "unknown", "optimal"] or matches[1].status == "feasible"


@pytest.mark.parametrize("arguments, what", [
    ({"threads": 0}, "threads"), ({"threads": 5000}, "threads"), ({"errors": "skip"}, "errors"),
    ({"particles": 0}, "particles"), ({"grid": 1}, "grid"), ({"at_least": -1}, "at_least"), ({"tolerance": "x"}, "tolerance")], ids=str)
def test_wrong_arguments_are_refused(arguments, what):
    with pytest.raises(mdm.InputError, match=what):
        list(mdm.batch([sand()], **arguments))


def test_what_is_no_gradation_is_refused():
    with pytest.raises(TypeError, match="int is no Gradation"):
        list(mdm.batch([3]))
    with pytest.raises(TypeError, match="did you mean 'at_least'"):
        mdm.batch([sand()], atleast=3)
    with pytest.raises(mdm.InputError, match="cannot be read"):
        list(mdm.batch("no such file"))
    assert list(mdm.batch([])) == []


def test_an_iterator_that_raises_ends_the_batch():
    def gradations():
        yield sand()
        raise ZeroDivisionError

    for threads in (1, 2):
        matches = mdm.batch(gradations(), threads=threads)
        assert next(matches).particles == 6
        with pytest.raises(ZeroDivisionError):
            next(matches)


def test_a_batch_may_be_left_while_it_solves():
    began = time.monotonic()
    matches = mdm.batch(itertools.chain([sand()], itertools.repeat(endless())), threads=1, max_steps=10**15)
    assert next(matches).particles == 6
    matches.close()
    assert time.monotonic() - began < 30


def test_the_whole_suite_is_solved():
    assert sum(1 for match in mdm.batch(SUITE, threads=2) if match.status == "optimal") == 2750
