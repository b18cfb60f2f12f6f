"""The ways in which a user may read files: the program, Python, JavaScript. Each gives an answer a file, as mdm batch."""

import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
AT_ONCE = 500  # files of one process


def lines_of(command, folder, names, environment=None):
    answers = []
    for begin in range(0, len(names), AT_ONCE):
        part = names[begin:begin + AT_ONCE]
        run = subprocess.run([*command, *part], cwd=folder, capture_output=True, text=True, timeout=600, env=environment)
        lines = run.stdout.splitlines()
        if len(lines) != len(part):
            sys.exit(f"{len(lines)} answers for {len(part)} files, exit {run.returncode}: {run.stderr[-2000:]}")
        answers += map(json.loads, lines)
    return answers


def by_program(program, folder, names, options, spelling="program"):
    """`spelling` is that of options in messages: program, or keyword as Python has them."""
    environment = {**os.environ, "MDM_OPTION_SPELLING": spelling}
    return lines_of([str(program), "batch", "--quiet", *options], folder, names, environment)


def by_python(package, folder, names, options):
    """`package` is the folder that holds the package exactmdm."""
    environment = {**os.environ, "PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"}
    return lines_of([sys.executable, str(HERE / "read_by_python.py"), *options], folder, names, environment)


def by_module(module, node, folder, names, options):
    """Workbooks, which the module leaves to the program, are not asked for."""
    return lines_of([node, str(HERE / "read_by_module.mjs"), str(module), *options], folder, names)
