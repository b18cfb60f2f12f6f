"""Memory does not grow with the number of solves, nor with the length of a sample."""

import resource
from array import array
from itertools import repeat
from pathlib import Path

import exactmdm as mdm
from support import SAND, sand


def resident():
    """Bytes of memory now."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize()


def growth(work, times):
    """Bytes that so many rounds of work add after as many to begin with."""
    for _ in range(times):
        work()
    before = resident()
    for _ in range(times):
        work()
    return resident() - before


def test_solves_leave_nothing():
    def work():
        match = mdm.solve(sand(), tolerance="retained:2%")
        match.check()
        mdm.solve(sand()).csv()

    assert growth(work, 400) < 4 << 20


def test_errors_leave_nothing():
    def work():
        try:
            mdm.Gradation(["1", "2"], ["x", 0])
        except mdm.InputError:
            pass
        try:
            mdm.solve(SAND, tolerance="x")
        except mdm.InputError:
            pass

    assert growth(work, 1000) < 4 << 20


def test_a_batch_leaves_nothing():
    assert growth(lambda: [None for _ in mdm.batch(repeat(sand(), 500), threads=2)], 10) < 8 << 20


def test_a_long_sample_is_judged_in_constant_memory():
    chunk = array("d", [0.15, 0.3, 0.7] * 10000)

    def work():
        mdm.verify(sand(), (x for _ in range(10) for x in chunk))

    work()
    before = resident()
    work()
    assert resident() - before < 4 << 20
