"""The independent checker, in process."""

import pickle
import subprocess
from pathlib import Path

import exactmdm as mdm
import pytest
from support import SAND, mdm as program, sand


@pytest.fixture(scope="module")
def proof(tmp_path_factory):
    """A proof in a file."""
    file = tmp_path_factory.mktemp("checking") / "sand.proof"
    program("solve", SAND, "--proof", file)
    return file


def test_files_and_texts_are_judged(proof):
    for gradation in (SAND, mdm.read(SAND), (str(SAND), SAND.read_text())):
        for certificate in (proof, proof.read_text()):
            assert mdm.check(gradation, certificate)


def test_the_verdict_is_that_of_the_program(proof):
    checker = Path(mdm.program.program()).resolve().with_name("mdm-check")
    out = subprocess.run([checker, SAND, proof], capture_output=True, text=True).stdout
    assert mdm.check(SAND, proof).proved + "\n" == out


def test_another_gradation_is_refused(proof):
    verdict = mdm.check(sand(), proof)
    assert not verdict and verdict.status == "refused" and verdict.reason


def test_a_proof_that_was_changed_is_refused(proof):
    text = proof.read_text()
    assert "819" in text and not mdm.check(SAND, text.replace("819", "818"))


@pytest.mark.parametrize("text", ["", "\0", "nonsense", "9" * 10**6, "\ud800"],
                         ids=["empty", "nul", "words", "long", "half"])
def test_nonsense_is_malformed(text):
    verdict = mdm.check(SAND, text)
    assert verdict.status == "malformed" and len(repr(verdict)) < 120


def test_what_cannot_be_read_is_refused(tmp_path, proof):
    with pytest.raises(mdm.InputError, match="cannot be read"):
        mdm.check(tmp_path / "none.csv", proof)
    with pytest.raises(mdm.InputError, match="cannot be read"):
        mdm.check(SAND, tmp_path / "none.proof")


def test_a_verdict_is_a_value(proof):
    verdict = mdm.check(SAND, proof)
    assert pickle.loads(pickle.dumps(verdict)) == verdict and repr(verdict) == "<Verdict: accepted>"
