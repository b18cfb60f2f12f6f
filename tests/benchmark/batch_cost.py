#!/usr/bin/python3
"""batch_cost.py MDM CHECK [LINES...]: the cost of answers with proofs by the number of gradations.

MDM and CHECK are the programs; LINES are numbers of gradations (1000 10000 100000 1000000), those of the paper's study
one after the other. For each, 8 shards are solved two at a time, joined and checked, all compressed; ten programs are
killed on the way, and what is joined is compared with what one process writes. Prints a table, and the line through the
last row to 10^9: CPU times are those of all programs that were not killed, memory is the largest of any.
"""

import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

MDM, CHECK = sys.argv[1:3]
LINES = [int(number) for number in sys.argv[3:]] or [10**3, 10**4, 10**5, 10**6]
SUITE = pathlib.Path(__file__).resolve().parents[2] / "examples/reference/average/suite-2750.jsonl"
SHARDS, AT_ONCE, KILLS = 8, 2, 10


class Cost:
    """CPU seconds, wall seconds and the largest memory of some programs."""

    def __init__(self):
        self.cpu, self.wall, self.mib = 0.0, 0.0, 0.0

    def add(self, usage):
        self.cpu += usage.ru_utime + usage.ru_stime
        self.mib = max(self.mib, usage.ru_maxrss / 1024)


def started(command):
    return subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def cost_of(*command):
    cost, begin = Cost(), time.monotonic()
    process = started(command)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{command}: {os.waitstatus_to_exitcode(status)}: {process.stderr.read().decode()}")
    process.stderr.close()
    cost.add(usage)
    cost.wall = time.monotonic() - begin
    return cost


def shard(folder, number):
    name = f"shard-{number:07}"
    return [MDM, "batch", folder / "suite.jsonl", "--shard", f"{number}/{SHARDS}", "-o", folder / f"{name}.jsonl.zst",
            "--proofs", folder / f"{name}.proofs.zst", "--quiet"]


def solve_shards(folder, kills):
    """Solves all shards, some at a time; kills as many programs at random."""
    cost, begin = Cost(), time.monotonic()
    waiting, running, chance = list(range(1, SHARDS + 1)), {}, random.Random(19)
    while waiting or running:
        while waiting and len(running) < AT_ONCE:
            number = waiting.pop(0)
            process = started(shard(folder, number))
            running[process.pid] = (number, process)
        if kills:
            time.sleep(chance.random() * 0.4)
            os.kill(chance.choice(list(running)), signal.SIGKILL)
            kills -= 1
        pid, status, usage = os.wait4(-1, 0)
        number, process = running.pop(pid)
        process.stderr.close()
        if os.WIFSIGNALED(status):
            waiting.append(number)
        elif status != 0:
            sys.exit(f"shard {number}: {os.waitstatus_to_exitcode(status)}")
        else:
            cost.add(usage)
    cost.wall = time.monotonic() - begin
    return cost


def measured(lines, folder):
    """Costs of solving, joining and checking, and the bytes that are left."""
    once = SUITE.read_bytes().splitlines(keepends=True)
    with open(folder / "suite.jsonl", "wb") as suite:
        for begin in range(0, lines, len(once)):
            suite.writelines(once[:lines - begin])
    solving = solve_shards(folder, KILLS)
    shards = sorted(folder.glob("shard-*.jsonl.zst"))
    answers, proofs = folder / "answers.jsonl.zst", folder / "all.proofs.zst"
    joining = cost_of(MDM, "merge", *shards, "-o", answers, "--proofs", proofs)
    checking = cost_of(CHECK, "--suite", folder / "suite.jsonl", proofs, "-j", AT_ONCE)
    whole, whole_proofs = folder / "whole.jsonl.zst", folder / "whole.proofs.zst"
    cost_of(MDM, "batch", folder / "suite.jsonl", "-o", whole, "--proofs", whole_proofs, "-j", AT_ONCE)
    for one, other in ((answers, whole), (proofs, whole_proofs), (f"{proofs}.index", f"{whole_proofs}.index")):
        if subprocess.run(["cmp", one, other]).returncode != 0:
            sys.exit(f"{one} is not {other}")
    sizes = [(folder / "suite.jsonl").stat().st_size, answers.stat().st_size, proofs.stat().st_size,
             pathlib.Path(f"{proofs}.index").stat().st_size]
    return [solving, joining, checking], sizes


def duration(seconds):
    return f"{seconds:.2f} s" if seconds < 100 else f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


def size(count):
    for unit in ("kB", "MB", "GB"):
        count /= 1000
        if count < 1000:
            return f"{count:.3g} {unit}"
    return f"{count / 1000:.3g} TB"


def row(first, costs, sizes, factor=1):
    memory = [f"{cost.mib:.0f} MiB" for cost in costs] if factor == 1 else ["the same"] * 3
    cells = [first] + [cell for cost, mib in zip(costs, memory) for cell in (duration(cost.cpu * factor), mib)]
    print("|", " | ".join(cells + [size(count * factor) for count in sizes]), "|", flush=True)


def main():
    if resource.getrlimit(resource.RLIMIT_NOFILE)[0] < 100:
        sys.exit("too few files may be open")
    print("| gradations | solving | its memory | joining | its memory | checking | its memory | suite | answers | proofs "
          "| index |\n|" + "---|" * 11)
    for lines in LINES:
        with tempfile.TemporaryDirectory(prefix="mdm-cost-") as folder:
            costs, sizes = measured(lines, pathlib.Path(folder))
        row(f"{lines:,}", costs, sizes)
    row("10^9, by the last row", costs, sizes, 10**9 / lines)
    print(f"\n{KILLS} programs were killed at each number, and what was joined is what one process writes. A second and a core: "
          + ", ".join(f"{lines / cost.cpu:,.0f} {what}" for cost, what in zip(costs, ("solved", "joined", "checked"))))


main()
