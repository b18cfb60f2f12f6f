#!/usr/bin/python3
"""ledger_test.py PROGRAMS: that the ledger of speed catches a loss, and that each loss in ledger.csv has its reason."""
import importlib.machinery
import importlib.util
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HOME = pathlib.Path(__file__).resolve().parent
loader = importlib.machinery.SourceFileLoader("ledger", str(HOME / "ledger"))
ledger = importlib.util.module_from_spec(importlib.util.spec_from_loader("ledger", loader))
loader.exec_module(ledger)
PROGRAMS = pathlib.Path(sys.argv.pop(1))
RUN = "exact: half phi"


class Ledger(unittest.TestCase):
    def counted(self, times):
        with tempfile.TemporaryDirectory() as folder:
            ledger.make_inputs(pathlib.Path(folder))
            return {RUN: ledger.count(PROGRAMS, RUN, pathlib.Path(folder), times)}

    def test_finds_work_that_is_a_little_more_than_the_last_line(self):
        once = self.counted(1)
        self.assertEqual(ledger.losses(once, once), [])
        more = self.counted(1.05)  # starting the program is a part of it that does not grow
        self.assertLess(more[RUN], 1.05 * once[RUN])
        self.assertEqual(ledger.losses(more, once), [RUN])

    def test_takes_three_percent_and_not_a_hundredth_more(self):
        last = {run: "1000000" for run in ledger.RUNS}
        self.assertEqual(ledger.losses({run: 1030000 for run in ledger.RUNS}, last), [])
        self.assertEqual(ledger.losses({RUN: 1030100}, last), [RUN])
        self.assertEqual(ledger.losses({RUN: 500000}, last), [])

    def test_every_line_says_why(self):
        lines = ledger.read_ledger()
        self.assertTrue(lines)
        for line in lines:
            self.assertTrue(line["why"].strip(), line["date"])

    def test_totals_are_shifted_geometric_means_by_group(self):
        counts = {run: 15 * 10**6 if run == "exact: the suite" else 0 for run in ledger.RUNS}
        counts["exact: half phi"] = 30 * 10**6
        totals = ledger.totals(counts)
        self.assertAlmostEqual(totals["exact"], (25 * 40 * 10) ** (1 / 3) - 10)
        self.assertAlmostEqual(totals["reading"], 0)
        self.assertAlmostEqual(totals["all"], (25 * 40 * 10**8) ** 0.1 - 10)


unittest.main()
