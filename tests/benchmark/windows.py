#!/usr/bin/env python3
"""Curves of many classes within a tolerance: how far a search by windows of the mass comes, and how long its proofs are.

    windows.py MDM MDM_CHECK [--classes 30,100,300] [--time-limit S] [--gap G]

Each line: curve, classes, tolerance, particles, gap to the bound, windows and other leaves of the proof, its bytes, seconds of
CPU time of `mdm solve`, and what mdm-check says.
"""
import argparse
import json
import math
import pathlib
import random
import resource
import subprocess
import tempfile

TOLERANCES = ["retained:5%", "retained:1%", "retained:0.2%", "passing:5%", "passing:1%", "passing:0.2%",
              "total:5%", "total:1%", "total:0.2%", "laboratory"]
KINDS = ["lognormal", "bimodal", "noisy", "flat"]


def bell(x, middle, width):
    return math.exp(-0.5 * (math.log(x / middle) / width) ** 2)


def curve(kind, classes):
    """Openings from 0.5 to 2000 um in equal ratios, and masses of a kind."""
    openings = [float("%.5g" % (0.5 * 4000 ** (i / classes))) for i in range(classes + 1)]
    noise = random.Random(7)
    masses = []
    for lower, upper in zip(openings, openings[1:]):
        x = math.sqrt(lower * upper)
        masses.append({"lognormal": lambda: bell(x, 200, 0.8),
                       "bimodal": lambda: bell(x, 10, 0.7) + bell(x, 300, 0.6),
                       "noisy": lambda: bell(x, 100, 1.2) * (0.5 + noise.random()),
                       "flat": lambda: 1.0}[kind]())
    rows = zip(openings, ["%.4f" % (400 / classes * m) for m in masses] + ["0"])
    return "size_um,mass\n" + "".join(f"{x:g},{m}\n" for x, m in rows)


def cpu_time():
    """Of all programs that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mdm")
    parser.add_argument("mdm_check")
    parser.add_argument("--classes", default="30,100,300")
    parser.add_argument("--time-limit", default="10")
    parser.add_argument("--gap", help="stop at a match so close to the bound")
    options = parser.parse_args()
    limits = ["--time-limit", options.time_limit] + (["--gap", options.gap] if options.gap else [])
    with tempfile.TemporaryDirectory() as folder:
        file, proof = pathlib.Path(folder, "curve.csv"), pathlib.Path(folder, "curve.proof")
        for classes in map(int, options.classes.split(",")):
            for kind in KINDS:
                file.write_text(curve(kind, classes))
                for tolerance in TOLERANCES:
                    proof.unlink(missing_ok=True)
                    start = cpu_time()
                    run = subprocess.run([options.mdm, "solve", file, "--tolerance", tolerance, *limits, "--proof", proof, "--format", "json", "--quiet"],
                                         capture_output=True, text=True)
                    seconds = cpu_time() - start
                    if not run.stdout:
                        print(kind, classes, tolerance, run.stderr.strip())
                        continue
                    answer = json.loads(run.stdout)
                    particles = int(answer["particles"])
                    bound = int(answer.get("lower_bound", particles))
                    lines = proof.read_text().split("\n") if proof.exists() else []
                    windows, leaves = (sum(line.startswith(word) for line in lines) for word in ("window", "leaf"))
                    verdict = subprocess.run([options.mdm_check, file, proof], capture_output=True, text=True)
                    print(f"{kind:9} {classes:3} {tolerance:13} {particles:15} {(particles - bound) / particles:8.1e} "
                          f"{windows:4} {leaves:4} {proof.stat().st_size:8} {seconds:7.3f}",
                          verdict.stdout.split(":")[0], flush=True)


if __name__ == "__main__":
    main()
