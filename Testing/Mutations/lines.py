# SPDX-License-Identifier: BSD-3-Clause
"""Which lines of the product each test executes.

The facts of a test: `executed` and `counted`, by file the lines that it executes and those that have a counter.
"""

import bisect
import json
import subprocess

import workshop

# Launches the compilers of a build that counts the lines of the VTK layer or of the engine; all else is compiled as
# users have it, so that its objects come from the cache.
LAUNCHER = """\
#!/bin/sh
for source; do :; done
case "$source" in
  *Testing/*) ;;
  *Filters/Engine/*) [ {group} = Filters/Engine ] && set -- "$@" -O0 -w --coverage ;;
  *Filters/*) [ {group} = Filters ] && set -- "$@" -O0 -w --coverage ;;
esac
exec {cache} "$@"
"""


def group_of(folder):
    """What is counted together: the engine, or all else of the product."""
    return "Filters/Engine" if (folder + "/").startswith("Filters/Engine/") else "Filters"


def joined(several):
    """The facts of programs that ran one after the other."""
    all_of = {"executed": {}, "counted": {}}
    for facts in several:
        for kind, files in facts.items():
            for file, lines in files.items():
                all_of[kind].setdefault(file, set()).update(lines)
    return {kind: {file: sorted(lines) for file, lines in files.items()} for kind, files in all_of.items()}


def around(counted, fault):
    """Those of a file's lines with a counter that show whether a fault is executed: its own, or if there are none the
    next ones before and after, as a statement of several lines may have one in its first or its last only.
    """
    first = bisect.bisect_left(counted, fault.line)
    last = bisect.bisect_right(counted, fault.line + fault.old.count("\n"))
    return counted[first:last] or counted[max(first - 1, 0) : last + 1]


def executes(facts, fault):
    """Does a test execute a fault, as far as lines were counted?"""
    lines = around(facts["counted"].get(fault.file, []), fault)
    return not set(facts["executed"].get(fault.file, [])).isdisjoint(lines)


def shows(facts, fault):
    """Can a test notice a fault? So it may be where nothing was counted, of it or of the file."""
    uncounted = not facts["executed"] or not around(facts["counted"].get(fault.file, []), fault)
    return uncounted or executes(facts, fault)


def unexecuted(tests):
    """By file, the lines with a counter that none of the tests with these facts executes: any fault there survives."""
    facts = joined(tests)
    left = {file: set(lines) - set(facts["executed"].get(file, [])) for file, lines in facts["counted"].items()}
    return {file: sorted(lines) for file, lines in sorted(left.items()) if lines}


class Executed:
    """The lines of `folder` that tests execute, by gcov's counters in the objects below `build`."""

    def __init__(self, build, source, folder):
        self.build, self.source, self.folder = build, source, folder

    def forget(self):
        for path in self.build.rglob("*.gcda"):
            path.unlink()

    def read(self):
        """The facts of all that ran since forget(); empty where no program of this build ended."""
        return joined(self.counters())

    def counters(self):
        counters = [str(path) for path in self.build.rglob("*.gcda")]
        if not counters:
            return
        command = ["gcov", "--json-format", "--stdout", *counters]
        done = subprocess.run(command, cwd=self.build, capture_output=True, text=True)
        if done.returncode != 0:
            raise workshop.BuildError("gcov: " + done.stderr[-2000:])
        for text in done.stdout.splitlines():
            for file in json.loads(text)["files"] if text.startswith("{") else ():
                name = self.name_of(file["file"])
                if name:
                    counted = [line["line_number"] for line in file["lines"]]
                    executed = [line["line_number"] for line in file["lines"] if line["count"]]
                    yield {"counted": {name: counted}, "executed": {name: executed} if executed else {}}

    def name_of(self, path):
        """The path below the sources of a file of the folder; empty for others."""
        begin = f"{self.source}/"
        path = str((self.build / path).resolve())
        name = path.removeprefix(begin) if path.startswith(begin) else ""
        return name if name.startswith(self.folder + "/") else ""
