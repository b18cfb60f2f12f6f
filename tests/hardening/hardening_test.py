#!/usr/bin/python3
"""hardening_test.py PROGRAM...: what src/cmake/MdmHardening.cmake asks for is in the programs."""
import shutil
import subprocess
import sys

if shutil.which("readelf") is None:
    print("readelf is not installed")
    sys.exit(77)

failures = []


def told(option, program):
    return subprocess.run(["readelf", "-W", option, program], capture_output=True, text=True, check=True).stdout


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


for program in sys.argv[1:]:
    symbols = told("--symbols", program)
    check("DYN (Position-Independent" in told("--file-header", program), f"{program}: addresses differ from run to run")
    check("GNU_RELRO" in told("--segments", program), f"{program}: tables become read-only")
    check("NOW" in told("--dynamic", program), f"{program}: they are so before the program begins")
    check("__stack_chk_fail" in symbols, f"{program}: stacks are guarded")
    check("_chk@" in symbols.replace("__stack_chk_fail@", ""), f"{program}: functions of the C library are checked")
sys.exit(1 if failures else 0)
