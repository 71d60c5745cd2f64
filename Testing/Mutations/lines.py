# SPDX-License-Identifier: BSD-3-Clause
"""Which lines of a folder each test executes, counted by a build of its own."""

import bisect
import json
import subprocess

import workshop


class Executed:
    """The lines of `folder` that tests execute, by gcov's counters in the objects below `build`."""

    def __init__(self, build, source, folder):
        self.build, self.source, self.folder = build, source, folder
        self.counted = {}  # by file: the lines that have a counter, in order

    def forget(self):
        for path in self.build.rglob("*.gcda"):
            path.unlink()

    def read(self):
        """`file:line` of all that was executed since forget(); nothing where no program of this build ended."""
        executed = set()
        counters = [str(path) for path in self.build.rglob("*.gcda")]
        if not counters:
            return executed
        command = ["gcov", "--json-format", "--stdout", *counters]
        done = subprocess.run(command, cwd=self.build, capture_output=True, text=True)
        if done.returncode != 0:
            raise workshop.BuildError("gcov: " + done.stderr[-2000:])
        for text in done.stdout.splitlines():
            for file in json.loads(text)["files"] if text.startswith("{") else ():
                name = self.name_of(file["file"])
                if name:
                    self.add(name, file["lines"], executed)
        return executed

    def name_of(self, path):
        """The path below the sources of a file of the folder; empty for others."""
        begin = f"{self.source}/"
        name = path.removeprefix(begin) if path.startswith(begin) else ""
        return name if name.startswith(self.folder + "/") else ""

    def add(self, name, lines, executed):
        known = self.counted.setdefault(name, [])
        for line in lines:
            number = line["line_number"]
            at = bisect.bisect_left(known, number)
            if at == len(known) or known[at] != number:
                known.insert(at, number)
            if line["count"]:
                executed.add(f"{name}:{number}")

    def around(self, fault):
        """The lines with a counter that show whether a fault is executed: its own, or if there are none the next ones
        before and after, as a statement of several lines may have one in its first or its last only. Empty if its file
        has none.
        """
        known = self.counted.get(fault.file, [])
        first = bisect.bisect_left(known, fault.line)
        last = bisect.bisect_right(known, fault.line + fault.old.count("\n"))
        lines = known[first:last] or known[max(first - 1, 0) : last + 1]
        return {f"{fault.file}:{line}" for line in lines}
