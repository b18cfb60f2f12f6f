#!/usr/bin/python3
"""windows_test.py MDM MDM_CHECK WINDOWS SOURCE: the programs for Windows, in the folder WINDOWS, under wine.

Each command is run by the programs of this machine and by those for Windows, in folders of their own: exit codes, outputs and the
bytes of all files are the same, but for the versions of Arb and FLINT: see `without_arb`. Names of files have umlauts. Exits with
77 where there is no wine, unless MDM_REQUIRE_TOOLS is set in the environment.
"""

import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

MDM, MDM_CHECK, WINDOWS, SOURCE = (pathlib.Path(name).resolve() for name in sys.argv[1:5])
GRADATIONS = SOURCE / "examples/gradations"
BLEND = SOURCE / "examples/08-blend"
REFERENCE = SOURCE / "examples/reference/average/suite-2750.jsonl"

# In this order: some read what others wrote.
COMMANDS = """
mdm --help
mdm help
mdm solve --help
mdm verify --help
mdm-check --help
mdm completion bash
mdm solve sand.csv
mdm solve sand.csv --proof sand.proof
mdm-check sand.csv sand.proof
mdm-check --print sand.csv sand.proof
mdm solve sand.csv --format json -o sand.json
mdm solve sand.csv --format csv -o sizes.csv
mdm solve sand.csv --tolerance retained:1% --proof tolerant.proof
mdm-check sand.csv tolerant.proof
mdm solve sand.csv --proof packed.proof.zst
mdm-check sand.csv packed.proof.zst
mdm solve Größe.csv --proof Größe.proof -o Übersicht.json --format json
mdm-check Größe.csv Größe.proof
mdm verify sand.csv sizes.csv --proof sizes.proof
mdm-check sand.csv sizes.csv sizes.proof
mdm describe sand.csv
mdm describe sand.csv Größe.csv --format csv
mdm judge sand.csv --spec astm-c33-fine
mdm plot sand.csv -o sand.svg
mdm plot Größe.csv -o -
mdm report sand.csv --spec astm-c33-fine -o sand.html
mdm tradeoff sand.csv
mdm blend A.csv B.csv C.csv D.csv --spec limits.csv --blended mix.csv --proof mix.proof
mdm-check limits.csv A.csv B.csv C.csv D.csv mix.proof
mdm convert sand.csv --format json -o line.jsonl
mdm convert sand.csv --problem lp
mdm convert table.xlsx --format csv
mdm batch line.jsonl -o answers.jsonl --proofs proofs
mdm-check --suite line.jsonl proofs --answers answers.jsonl
mdm batch line.jsonl -o Prüfung.jsonl --proofs Prüfung
mdm-check --suite line.jsonl Prüfung --answers Prüfung.jsonl
mdm batch suite.jsonl -j 2 -o all.csv --proofs all.proofs
mdm-check --suite suite.jsonl all.proofs -j 2
mdm batch reference.jsonl -j 2 -o reference.csv --proofs reference.proofs
mdm-check --suite reference.jsonl reference.proofs --answers reference.csv -j 2
mdm batch suite.jsonl --shard 1/2 -o first.jsonl --proofs first.proofs
mdm batch suite.jsonl --shard 2/2 -o second.jsonl --proofs second.proofs
mdm merge first.jsonl second.jsonl -o both.jsonl --proofs both.proofs
mdm batch suite.jsonl --shard 1/1 -o ganz.jsonl --proofs Übersicht.proofs
mdm merge ganz.jsonl -o Übersicht.jsonl
mdm export sand.csv --size-factor 5 --to liggghts --model settle -o settled.in
mdm export sand.csv --size-factor 5 --to liggghts --model settle -o Körner.in
mdm export sand.csv --to lammps -o grains.data
mdm generate --curve fuller:8mm --classes 5 --format csv
mdm pack sand.csv -o packing.csv
mdm solve missing.csv
mdm solve sand.csv -o sand.csv
mdm solve SAND
mdm solve sand.csv --no-such-option
mdm solve sand.csv --coq Größe.v
mdm solve sand.csv -o Länge/sand.json
mdm-check sand.csv
mdm-check Größe.csv sand.proof
"""


def skip_without_wine():
    if shutil.which("wine"):
        return
    print("missing, of Debian's packages: wine wine64")
    sys.exit(1 if "MDM_REQUIRE_TOOLS" in os.environ else 77)


class Started:
    """A program that runs. Its outputs are files: a pipe would be open as long as the services of wine that it has started."""

    def __init__(self, command, stdout, **options):
        self.printed, self.errors = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=stdout or self.printed, stderr=self.errors, **options)

    def end(self, given=b""):
        """What it printed, after it was given the last of its input."""
        self.process.communicate(given, timeout=1200)
        for file in (self.printed, self.errors):
            file.seek(0)
        with self.printed, self.errors:
            return subprocess.CompletedProcess(self.process.args, self.process.returncode, self.printed.read(), self.errors.read())


class Place:
    """A folder with the inputs, and the programs that are run in it."""

    def __init__(self, folder, before, programs, environment):
        self.folder, self.before, self.programs, self.environment = folder, before, programs, environment
        folder.mkdir()
        shutil.copy(GRADATIONS / "athabasca-sand.csv", folder / "sand.csv")
        shutil.copy(GRADATIONS / "hostun-rf-sand.csv", folder / "Größe.csv")
        shutil.copy(only(GRADATIONS / "formats", "*.xlsx"), folder / "table.xlsx")
        shutil.copy(REFERENCE, folder / "reference.jsonl")
        for path in BLEND.glob("*.csv"):
            shutil.copy(path, folder)

    def start(self, words, stdout=None):
        return Started([*self.before, self.programs[words[0]], *words[1:]], stdout, cwd=self.folder, env=self.environment)

    def run(self, words, given=b"", stdout=None):
        return self.start(words, stdout).end(given)

    def files(self):
        return {path.relative_to(self.folder).as_posix(): path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}


def only(folder, pattern):
    return sorted(folder.glob(pattern))[0]


failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def without_arb(text):
    """What a program without Arb, and thus without FLINT, writes of its versions."""
    return re.sub(rb'"(?:arb|flint)":"[\d.]+",', b"", text)


def totals_of(content):
    """How totals name the bytes of a file."""
    return f'"bytes":"{len(content)}","sha256":"{hashlib.sha256(content).hexdigest()}"'.encode()


def expected_of_windows(files):
    """The files of this machine as the programs for Windows are to write them. They have no Arb, on which no answer here
    depends: versions lack it, in answers and in totals of batches, and these have the digests of such answers."""
    expected = {name: without_arb(content) for name, content in files.items()}
    for name in (name for name in files if name.endswith(".totals")):
        answers = json.loads(files[name])["answers"]["file"]
        check(totals_of(files[answers]) in files[name], f"{name} has the digest of {answers}")
        expected[name] = expected[name].replace(totals_of(files[answers]), totals_of(expected[answers]))
    return expected


def compare(linux, windows):
    """All commands, by both."""
    for line in COMMANDS.strip().splitlines():
        words = shlex.split(line)
        one, other = linux.run(words), windows.run(words)
        check(one.returncode == other.returncode, f"{line}: exit codes {one.returncode}, {other.returncode}: {other.stderr}")
        check(one.stdout == other.stdout, f"{line}: {difference(one.stdout, other.stdout)}")
        check(one.stderr == other.stderr, f"{line}: errors {difference(one.stderr, other.stderr)}")
    ours, theirs = expected_of_windows(linux.files()), windows.files()
    check(ours.keys() == theirs.keys(), f"files {sorted(ours.keys() ^ theirs.keys())}")
    for name in sorted(ours.keys() & theirs.keys()):
        check(ours[name] == theirs[name], f"the file {name}: {difference(ours[name], theirs[name])}")
    return len(ours)


def difference(one, other):
    """The first lines that differ."""
    lines = [pair for pair in zip(one.splitlines(True), other.splitlines(True)) if pair[0] != pair[1]]
    return f"{lines[0][0]!r} is {lines[0][1]!r}" if lines else f"{len(one)} and {len(other)} bytes"


def check_own(windows):
    """What Windows alone has, and has not."""
    sand = (windows.folder / "sand.csv").read_bytes()
    for folder in ("Länge und Breite", "sub"):
        (windows.folder / folder).mkdir()
    done = windows.run(["mdm", "solve", "sand.csv", "-o", r"Länge und Breite\Prüfung.json", "--format", "json"])
    check(done.returncode == 0 and (windows.folder / "Länge und Breite/Prüfung.json").exists(), f"a path of Windows: {done.stderr}")
    (windows.folder / "sub/sand.csv").write_bytes(sand)
    done = windows.run(["mdm", "solve", r"sub\sand.csv"])
    check(done.stdout.startswith(b"sand: 1485 particles"), f"the name of a sample: {done.stdout[:100]}")
    done = windows.run(["mdm", "solve", "-"], sand)
    check(b"1485 particles" in done.stdout, f"standard input: {done.stderr}")
    done = windows.run(["mdm", "solve", "sand.csv", "-o", r".\sand.csv"])
    check(done.returncode == 2 and b"would be overwritten" in done.stderr, f"an input as output: {done.stderr}")
    done = windows.run(["mdm", "crosscheck", "suite.jsonl", "--solver", "cat"])
    check(done.returncode == 2 and b"on Windows" in done.stderr, f"other programs: {done.stderr}")
    done = windows.run(["mdm", "--version"])
    check(done.returncode == 0 and b"gmp" in done.stdout.lower(), f"versions: {done.stdout}")
    check(not any(path.suffix in (".tmp", ".lock") for path in windows.folder.rglob("*")), "nothing is left beside files")


def check_held(windows):
    """What another program has open is not replaced: the command is refused, and leaves the file as it is."""
    held = windows.folder / "held.jsonl"
    shutil.copy(windows.folder / "line.jsonl", held)
    before = held.read_bytes()
    holder = windows.start(["mdm-check", "--suite", "held.jsonl", "proofs", "--answers", "-"])  # waits for the answers
    writing = ["mdm", "convert", "sand.csv", "--format", "json", "-o", "held.jsonl"]
    attempts = (windows.run(writing) for _ in range(100))  # until the holder has it open
    refused = next((done for done in attempts if done.returncode), None)
    check(refused is not None and refused.returncode == 2 and b"held.jsonl: cannot be written" in refused.stderr, f"held: {refused}")
    check(held.read_bytes() == before, "a held file is as it was")
    holder.end()
    done = windows.run(writing)
    check(done.returncode == 0, f"no longer held: {done.stderr}")


def wait_for(windows, pattern):
    """Until a command has made such a file."""
    for _ in range(1000):
        if any(windows.folder.glob(pattern)):
            return
        time.sleep(0.1)
    check(False, f"there is no {pattern}")


def check_locked(windows):
    """Two runs do not write the same files."""
    shard = ["mdm", "batch", "--shard", "1/1", "-o", "locked.jsonl"]
    first = windows.start(shard)  # waits for the suite
    wait_for(windows, "locked.jsonl.lock")
    second = windows.run(shard)
    check(second.returncode == 2 and b"another run writes these files" in second.stderr, f"locked: {second}")
    line = (windows.folder / "line.jsonl").read_bytes()
    done = first.end(line)
    check(done.returncode == 0 and (windows.folder / "locked.jsonl").exists(), f"the run that has the lock: {done}")


def uneven_gradation():
    """Three hundred classes, on which no search within a tolerance ends within seconds."""
    rows = "".join(f"{10 ** (j / 100):.6f},{100 + j * 7919 % 1901}\n" for j in range(300))
    return f"size_um,mass\n{rows}1000,0\n"


def check_interrupts(windows):
    """Ctrl-C ends a search with what is certain, and any other run with nothing left of it."""
    (windows.folder / "uneven.csv").write_text(uneven_gradation(), encoding="utf-8")
    search = windows.start(["mdm", "solve", "uneven.csv", "--tolerance", "total:0.2%", "--format", "json", "-o", "stopped.json"])
    wait_for(windows, "stopped.json.*.tmp")
    time.sleep(3)  # it is searching by now
    search.process.send_signal(signal.SIGINT)
    done = search.end()
    answer = windows.folder / "stopped.json"
    check(done.returncode == 3 and answer.exists() and b"the search was interrupted" in answer.read_bytes(), f"Ctrl-C: {done}")
    batch = windows.start(["mdm", "batch", "-o", "never.jsonl"])
    wait_for(windows, "never.jsonl.*.tmp")
    batch.process.send_signal(signal.SIGINT)
    batch.process.wait(timeout=300)
    check(batch.process.returncode != 0 and not any(windows.folder.glob("never.jsonl*")), f"Ctrl-C: {batch.end()}")


def check_closed_pipe(windows):
    """Where the reader has gone, the program ends silently."""
    reader, writer = os.pipe()
    os.close(reader)
    for words in (["mdm", "solve", "sand.csv"], ["mdm", "--help"]):
        done = windows.run(words, stdout=writer)
        check(done.returncode == 2 and done.stderr == b"", f"a closed pipe: {done}")
    os.close(writer)


def check_runs_alone():
    """The programs need what is part of Windows, and nothing else."""
    parts = {"kernel32.dll", "msvcrt.dll", "advapi32.dll", "bcrypt.dll", "ucrtbase.dll", "user32.dll"}
    for name in ("mdm.exe", "mdm-check.exe"):
        printed = subprocess.run(["objdump", "-p", WINDOWS / name], check=True, capture_output=True, text=True).stdout
        needed = {line.split()[-1].lower() for line in printed.splitlines() if "DLL Name:" in line}
        check(needed <= parts, f"{name} needs {needed - parts}")


def check_all(folder):
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    in_wine = {**environment, "WINEPREFIX": str(folder / "wine"), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml="}
    linux = Place(folder / "linux", [], {"mdm": MDM, "mdm-check": MDM_CHECK}, environment)
    windows = Place(folder / "windows", ["wine"], {"mdm": WINDOWS / "mdm.exe", "mdm-check": WINDOWS / "mdm-check.exe"}, in_wine)
    sands = sorted(GRADATIONS.glob("*-sand.csv"))
    suite = b"".join(subprocess.run([MDM, "convert", sand, "--quiet", "--format", "json"], check=True, capture_output=True).stdout
                     for sand in sands)
    for place in (linux, windows):
        (place.folder / "suite.jsonl").write_bytes(suite)
    # Wine makes a Windows of its own at its first start.
    subprocess.run(["wine", WINDOWS / "mdm-check.exe", "--version"], env=in_wine, check=True, capture_output=True, timeout=300)
    try:
        print(compare(linux, windows), "files are compared")
        check_held(windows)
        check_locked(windows)
        check_interrupts(windows)
        check_closed_pipe(windows)
        check_own(windows)
    finally:
        subprocess.run(["wineserver", "-k", "-w"], env=in_wine, check=False)
    check_runs_alone()


skip_without_wine()
with tempfile.TemporaryDirectory() as name:
    check_all(pathlib.Path(name))
sys.exit(1 if failures else 0)
