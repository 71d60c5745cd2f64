# SPDX-License-Identifier: BSD-3-Clause
"""Reads lcov files and prints, for the files of a folder, how many lines were reached, and those not.

uncovered.py <folder> <file.lcov>...

Files below a folder "engine" of a build are taken for copies of those of the folder, line by line.
"""

import os
import sys


def name_of(path, folder):
    """The path relative to the folder, or to that of the copies; None for other files."""
    for root in (os.path.realpath(folder), path.partition("/build-small/engine/")[0] + "/build-small/engine"):
        name = os.path.relpath(os.path.realpath(path), root)
        if not name.startswith(".."):
            return name
    return None


def read_counts(path, folder, counts):
    """Adds to counts, by file of the folder and line number, how often it was run."""
    lines = {}
    with open(path, encoding="utf-8") as lcov:
        for entry in lcov:
            kind, _, value = entry.strip().partition(":")
            if kind == "SF":
                name = name_of(value, folder)
                lines = counts.setdefault(name, {}) if name else {}
            elif kind == "DA":
                number, count = (int(part) for part in value.split(",")[:2])
                lines[number] = lines.get(number, 0) + count


def main():
    folder = sys.argv[1]
    counts = {}
    for path in sys.argv[2:]:
        read_counts(path, folder, counts)
    for name in sorted(counts):
        missed = sorted(number for number, count in counts[name].items() if count == 0)
        if missed:
            with open(os.path.join(folder, name), encoding="utf-8") as source:
                text = source.read().splitlines()
            print(f"{name}: {len(missed)} of {len(counts[name])} lines not reached")
            for number in missed:
                print(f"  {number:4d}  {text[number - 1].rstrip()}")
    total = sum(len(lines) for lines in counts.values())
    reached = sum(count > 0 for lines in counts.values() for count in lines.values())
    if total == 0:
        sys.exit("no line of the folder is in the files")
    print(f"{reached} of {total} lines reached: {100 * reached / total:.1f} %")


if __name__ == "__main__":
    main()
