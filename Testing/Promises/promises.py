#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does every promise of Guarantees.md have tests, and are they there?

  promises.py <folder of ctest>     the build folder, whose tests are listed by ctest

exit code  0 yes, 1 no, and what is missing is printed
"""
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def promised():
    """The promises of Guarantees.md: the bold text at the head of each item."""
    text = (HERE.parents[1] / "Plugin" / "Documentation" / "Guarantees.md").read_text()
    return re.findall(r"^- \*\*(.+?)\.\*\*", text, re.MULTILINE)


def rows():
    """Promise and tests of each row of the table."""
    text = (HERE / "README.md").read_text()
    found = {}
    for promise, tests in re.findall(r"^\| (.+?) \| (`.+`) \|$", text, re.MULTILINE):
        found[promise] = re.findall(r"`(.+?)`", tests)
    return found


def tests_of(folder):
    """Names of ctest's tests."""
    listed = subprocess.run(
        ["ctest", "--test-dir", folder, "--show-only=json-v1"], stdout=subprocess.PIPE, check=True
    )
    return {test["name"] for test in json.loads(listed.stdout)["tests"]}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    table = rows()
    known = tests_of(sys.argv[1])
    missing = [f"no row for the promise: {promise}" for promise in promised() if promise not in table]
    missing += [f"a row for what Guarantees.md does not promise: {row}" for row in table if row not in promised()]
    missing += [
        f"no such test: {test} ({promise})"
        for promise, tests in table.items()
        for test in tests
        if test not in known
    ]
    if not table or not known:
        missing.append("no rows, or no tests")
    print("\n".join(missing) if missing else f"{len(table)} promises, all with tests that exist")
    sys.exit(bool(missing))


if __name__ == "__main__":
    main()
