# SPDX-License-Identifier: BSD-3-Clause
"""mypy --strict, which is fetched from PyPI into a venv of its own with NumPy's newest types, passes on the package and
finds what is wrong in typed_program.py, and nothing else.

    with_mypy.py <folder of the venv>

77 if PyPI is out of reach.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import adaptivehilbertdelaunay
import arraysupport
from with_scipy import reached

PROGRAM = pathlib.Path(__file__).with_name("typed_program.py")
FOLDER = pathlib.Path(adaptivehilbertdelaunay.__file__).parent.parent
PYTHON = []


def checked(*options):
    """What mypy says."""
    with tempfile.TemporaryDirectory() as cache:
        done = subprocess.run(
            [*PYTHON, "-m", "mypy", "--cache-dir", cache, *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env={**os.environ, "MYPYPATH": str(FOLDER)}, text=True, cwd=cache, check=False)  # fmt: skip
    return done.stdout


class TypesTest(unittest.TestCase):
    def test_the_package(self):
        config = os.path.join(arraysupport.ROOT, "pyproject.toml")
        said = checked("--config-file", config, "--package", "adaptivehilbertdelaunay")
        self.assertIn("Success: no issues found", said)

    def test_a_program(self):
        said = checked("--strict", "--follow-imports", "silent", str(PROGRAM))
        found = re.findall(r"py:(\d+): error: .*\[([\w-]+)\]$", said, re.MULTILINE)
        lines = PROGRAM.read_text(encoding="utf-8").splitlines()
        wrong = [(str(k), line.split("# wrong: ")[1]) for k, line in enumerate(lines, 1) if "# wrong: " in line]
        self.assertGreater(len(wrong), 15)
        self.assertEqual(found, wrong, said)

    def test_the_program_runs(self):
        subprocess.run([sys.executable, str(PROGRAM)], check=True, stdout=subprocess.DEVNULL, timeout=60)


if __name__ == "__main__":
    PYTHON.append(reached(os.path.abspath(sys.argv.pop(1)), "import mypy, numpy", ("mypy>=1.11", "numpy>=2"), ()))
    if PYTHON == [None]:
        sys.exit(1 if os.environ.get("CI") == "true" else 77)
    unittest.main()
