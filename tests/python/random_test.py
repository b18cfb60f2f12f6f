"""Random gradations have the answers of the command line, byte for byte, and survive every way round."""

import json
import pickle
from decimal import Decimal
from fractions import Fraction

import exactmdm as mdm
import hypothesis
from hypothesis import given
from hypothesis import strategies as st
from support import mdm as program

SIZES = st.lists(st.decimals("0.001", "999", places=3), min_size=2, max_size=9, unique=True).map(sorted)


@st.composite
def gradations(draw):
    """Gradations of a few classes, of which some may be empty."""
    sizes = draw(SIZES)
    masses = [draw(st.decimals(0, 100, places=draw(st.integers(0, 4)))) for _ in sizes[1:]]
    hypothesis.assume(any(masses))
    return mdm.Gradation(sizes, [*masses, 0], draw(st.sampled_from(["mm", "um", "m"])),
                         draw(st.text(st.characters(blacklist_categories=("Cs", "Cc")), max_size=8)))


QUESTIONS = st.sampled_from([{}, {"at_least": 50}, {"min_per_class": 3}, {"law": "power:2"}, {"size_factor": "1.5"},
                             {"digits": 30}, {"tolerance": "retained:3%", "gap": "0.5"}])


@given(gradations())
def test_a_gradation_survives_pickle_json_and_csv(g):
    assert pickle.loads(pickle.dumps(g)) == g
    tree = json.loads(g.json())
    assert mdm.Gradation(tree["sizes"], tree["masses"], tree["unit"], tree["id"]) == g
    assert [Fraction(size) for size in tree["sizes"]] == list(g.sizes)


@given(gradations(), QUESTIONS)
def test_the_answer_is_that_of_the_command_line(g, question):
    try:
        match = mdm.solve(g, max_steps=None if "tolerance" in question else 10**6, **question)
    except mdm.LimitReached as limit:
        match = limit.known
    flags = [word for name, value in question.items() for word in ("--" + name.replace("_", "-"), str(value))]
    limit_flags = [] if "tolerance" in question else ["--max-steps", "1000000"]
    code, text, _ = program("batch", *flags, *limit_flags, stdin=g.json())
    assert text == match.json() + "\n"
    if match.status in ("optimal", "none"):
        assert match.check() and pickle.loads(pickle.dumps(match)) == match
    if match.particles is not None:
        changes = {name: question[name] for name in ("law", "size_factor", "tolerance") if name in question}
        assert mdm.verify(g, match, **changes)


@given(st.lists(st.floats(1, 3), min_size=1, max_size=50))
def test_doubles_are_judged_exactly(sample):
    g = mdm.Gradation(["1", "2", "3"], [1, 1, 0])
    inside = [Fraction(x) for x in sample if 1 < x <= 3]
    hypothesis.assume(inside)
    found = mdm.verify(g, sample)
    fine, all_of_them = sum(x**3 for x in inside if x <= 2), sum(x**3 for x in inside)
    assert found.classes[0].found == fine / all_of_them and found.outside == (len(sample) - len(inside), 0)
    assert mdm.verify(g, [Decimal(x) for x in sample]) == found
