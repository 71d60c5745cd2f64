# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of an installed package by the Python of another system, which an emulator runs here.

    elsewhere.py PYTHON FOLDER...

First Wheels/check_wheel.py, then every test_*.py of these folders of Testing/Package, each in a process of its own. A
line for each, and one for each test that was skipped, with the reason. The exit code is 1 if one failed.
PYTHON is a program of this system, such as a script that starts Wine. It runs each file, with AHD_TEST_EMULATED in the
environment, by

    PYTHON elsewhere.py --tell FILE ARGUMENT...
"""

import os
import re
import runpy
import signal
import sys
import time
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent


def tell(file, *arguments):
    """Runs a file of tests as a program; each skipped test is printed in a line."""

    def skipped(result, test, reason):
        print("\nSKIPPED %s: %s" % (test.id().replace("__main__.", ""), reason), flush=True)
        add_skip(result, test, reason)

    add_skip = unittest.TextTestResult.addSkip
    unittest.TextTestResult.addSkip = skipped
    sys.argv = [file, *arguments]
    sys.path[0] = os.path.dirname(file)
    runpy.run_path(file, run_name="__main__")


def run(python, file, *arguments):
    """Prints the outcome. Returns the numbers of tests run and skipped, and whether all passed."""
    import pairs

    begun = time.monotonic()
    environment = dict(pairs.suite_environment([]), AHD_TEST_EMULATED="1")
    code, said = pairs.called([python, HERE / "elsewhere.py", "--tell", file, *arguments], environment, seconds=1800)
    ran = re.findall(r"^Ran (\d+) tests?", said, re.M)  # the last is the file's: a test may run others
    count = int(ran[-1]) if ran else 1
    skipped = re.findall("^SKIPPED (.*)", said, re.M)
    passed = code == 0 and count > 0
    print("%-40s %s, %d of %d skipped, %.0f s" % (
        file.relative_to(HERE), "passed" if passed else "FAILED", len(skipped), count, time.monotonic() - begun))
    for each in skipped:
        print("    " + each.strip())
    if not passed:
        print("exit code %d\n%s" % (code, said))
    sys.stdout.flush()
    return count - len(skipped), len(skipped), passed


def main():
    python, folders = sys.argv[1], sys.argv[2:]
    signal.signal(signal.SIGINT, signal.default_int_handler)  # jobs in the background of a shell ignore it
    found = [run(python, HERE / "Wheels" / "check_wheel.py", HERE.parents[1] / "Data")]
    for folder in folders:
        for file in sorted((HERE / folder).glob("test_*.py")):
            found.append(run(python, file, *(["found"] if folder == "PyVista" else [])))
    ran, skipped, passed = zip(*found)
    print("%d tests ran, %d were skipped, %d of %d files failed" % (
        sum(ran), sum(skipped), passed.count(False), len(passed)))
    return 0 if all(passed) else 1


if __name__ == "__main__":
    if sys.argv[1] == "--tell":
        tell(*sys.argv[2:])
    else:
        sys.exit(main())
