"""Limits, signals and callbacks: what is certain, and never an abort."""

import pickle
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path

import exactmdm as mdm
import pytest
from support import SAND, endless, python_environment, sand


def test_a_limit_raises_with_what_is_certain():
    with pytest.raises(mdm.LimitReached) as caught:
        mdm.solve(endless(), max_steps=100)
    known = caught.value.known
    assert known.status == "feasible" and 1 < known.lower_bound < known.particles
    again = pickle.loads(pickle.dumps(caught.value)).known
    assert again.json() == known.json()
    for match in (known, again):
        assert f" exactly is between {known.lower_bound} and {known.particles} (" in match.check().proved
    with pytest.raises(mdm.InputError, match="its JSON and its proof alone"):
        again.csv()


@pytest.mark.parametrize("seconds", [0, 0.2, "0.2"])
def test_a_time_limit_ends_an_endless_search(seconds):
    began = time.monotonic()
    with pytest.raises(mdm.LimitReached) as caught:
        mdm.solve(endless(), time_limit=seconds, max_steps=10**15)
    assert time.monotonic() - began < 60 and caught.value.known.lower_bound >= 1
    with pytest.raises(mdm.InputError, match="proof was not kept"):
        caught.value.known.check()
    with pytest.raises(mdm.InputError, match="proof was not kept"):
        caught.value.known.vipr()


def test_within_a_gap_is_no_limit():
    assert mdm.solve(SAND, tolerance="passing:1%", gap=1).status in ("feasible", "optimal")


def test_progress_is_told_and_what_it_raises_comes_out():
    calls = []

    def progress(steps, lower_bound, particles):
        calls.append((steps, lower_bound, particles))
        raise ZeroDivisionError("enough")

    with pytest.raises(ZeroDivisionError, match="enough"):
        mdm.solve(endless(), max_steps=10**15, progress=progress)
    steps, lower_bound, particles = calls[0]
    assert len(calls) == 1 and steps > 0 and lower_bound > 0 and (particles is None or particles >= lower_bound)


def test_what_is_no_function_comes_out_as_an_exception():
    with pytest.raises(TypeError, match="not callable"):
        mdm.solve(endless(), max_steps=10**15, progress=3)


def test_other_threads_run_while_one_solves():
    ticks = []

    def tick():
        while not done:
            ticks.append(time.monotonic())
            time.sleep(0.01)

    done = []
    thread = threading.Thread(target=tick)
    thread.start()
    with pytest.raises(mdm.LimitReached):
        mdm.solve(endless(), time_limit=1, max_steps=10**15)
    done.append(True)
    thread.join()
    assert len(ticks) > 10


PROGRAM = """
    import sys
    sys.path.insert(0, {tests!r})
    import exactmdm as mdm
    from support import endless, SAND
    print("ready", flush=True)
    try:
        {call}
    except mdm.Interrupted as stop:
        print("interrupted", stop.known, isinstance(stop, KeyboardInterrupt))
    except KeyboardInterrupt:
        print("interrupted without")
"""


@pytest.mark.parametrize("call, known", [
    ("mdm.solve(endless(), max_steps=10**15)", "<Match"),
    ("mdm.tradeoff(endless(), tolerances=[0], max_steps=10**15)", "<Tradeoff"),
    ("list(mdm.batch([endless()] * 2, threads=2, max_steps=10**15))", "without"),
    ("mdm.verify(SAND, iter(lambda: 0.5, 0))", "without"),
    ("mdm.crosscheck(mdm.read(SAND) for _ in iter(int, 1)) if 0 else mdm.crosscheck(iter(lambda: mdm.read(SAND), 0), "
     "lambda g: [1])", "without")], ids=["solve", "tradeoff", "batch", "verify", "crosscheck"])
def test_ctrl_c_ends_it_with_what_is_known(call, known):
    code = textwrap.dedent(PROGRAM.format(tests=str(Path(__file__).parent), call=call))
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, env=python_environment()) as process:
        assert process.stdout.readline() == "ready\n"
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
    assert out.startswith("interrupted") and known in out and process.returncode == 0


def test_a_signal_in_a_solve_that_ended_leaves_nothing_behind():
    assert mdm.solve(sand()).particles == 6


@pytest.mark.parametrize("sizes, masses", [
    (["1e-400", "1e400"], [1, 0]), (["0", "1"], [1, 0]), ([str(i) for i in range(3000)], [1] * 2999 + [0]),
    (["1", "1." + "0" * 990 + "1"], ["1e400", 0])], ids=["wide", "pan", "many", "narrow"])
def test_extreme_gradations_give_an_answer_or_a_limit(sizes, masses):
    try:
        match = mdm.solve(mdm.Gradation(sizes, masses), time_limit=5)
    except mdm.LimitReached as limit:
        match = limit.known
    assert match.lower_bound >= 1 and len(repr(match)) < 120
