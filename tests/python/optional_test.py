"""Without numpy, pandas and matplotlib everything else works."""

import subprocess
import sys

from support import SAND, python_environment

SCRIPT = """
import sys
for name in ("numpy", "pandas", "matplotlib"):
    sys.modules[name] = None
import exactmdm as mdm
match = mdm.solve(sys.argv[1])
assert match.check() and mdm.verify(sys.argv[1], match) and mdm.verify(sys.argv[1], [0.1, 0.2]).particles == 2
assert match._repr_html_() and mdm.tradeoff(sys.argv[1], tolerances=[0])._repr_html_()
for call in (match.to_frame, lambda: mdm.plot(match)):
    try:
        call()
    except ModuleNotFoundError as error:
        print(error)
"""

IMPORTS = """
import sys
import exactmdm
print([name for name in ("numpy", "pandas", "matplotlib") if name in sys.modules])
"""


def python(script):
    """What a script prints in a Python of its own."""
    done = subprocess.run([sys.executable, "-c", script, SAND], capture_output=True, text=True, env=python_environment())
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_they_are_not_needed():
    frame, plot = python(SCRIPT)
    assert "pandas" in frame and plot == "matplotlib is not installed: exactmdm.picture draws without it"


def test_they_are_imported_when_used():
    assert python(IMPORTS) == ["[]"]
