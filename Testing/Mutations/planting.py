# SPDX-License-Identifier: BSD-3-Clause
"""Faults at random places of the sources, and how they are drawn."""

import dataclasses
import hashlib
import random

import plant_cxx
import plant_python

SITES = {".py": plant_python.sites, ".cxx": plant_cxx.sites, ".h": plant_cxx.sites}


@dataclasses.dataclass(frozen=True)
class Fault:
    """One fault: `old` becomes `new` in the lines `line` and following of `file`, a path below the root.

    Both are whole lines. It is identified by its text and not its line, so that it is found again where other parts of
    the file changed: `at` distinguishes it from others of the same text in the same function, from 0.
    """

    file: str
    function: str
    line: int
    kind: str
    old: str
    new: str
    at: int

    def key(self):
        text = "\0".join([self.file, self.function, self.old, self.new, str(self.at)])
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def apply(self, text):
        """The text of the file with the fault."""
        lines = text.splitlines(keepends=True)
        count = self.old.count("\n") + 1
        before, after = lines[: self.line - 1], lines[self.line - 1 + count :]
        assert "".join(lines[self.line - 1 : self.line - 1 + count]).rstrip("\n") == self.old, self
        return "".join(before) + self.new + "\n" + "".join(after)


def faults(file, text):
    """All faults that can be planted in a file, in the order of its lines."""
    found, seen = [], {}
    for begin, end, replacement, kind, function in sorted(SITES["." + file.rpartition(".")[2]](text)):
        first = text.rfind("\n", 0, begin) + 1
        last = text.find("\n", end)
        last = len(text) if last < 0 else last
        old, new = text[first:last], text[first:begin] + replacement + text[end:last]
        if old == new:
            continue
        same = (function, old, new)
        at = seen.get(same, 0)
        seen[same] = at + 1
        found.append(Fault(file, function, text.count("\n", 0, first) + 1, kind, old, new, at))
    return found


def files_of(root, folder):
    """The files of a folder that faults can be planted in, as paths below the root."""
    paths = sorted(path for path in (root / folder).rglob("*") if path.suffix in SITES)
    return [path.relative_to(root).as_posix() for path in paths]


def draw(root, folder, seed):
    """All faults, none twice, in an order that the seed decides: each line that can have one is as likely as any
    other, and so is each kind of those that it can have.
    """
    by_line = {}
    for file in files_of(root, folder):
        for fault in faults(file, (root / file).read_text()):
            by_line.setdefault((file, fault.line), {}).setdefault(fault.kind, []).append(fault)
    chosen = random.Random(f"{seed} {folder}")
    lines = sorted(by_line)
    while lines:
        line = chosen.choice(lines)
        kind = chosen.choice(sorted(by_line[line]))
        those = by_line[line][kind]
        yield those.pop(chosen.randrange(len(those)))
        if not those:
            del by_line[line][kind]
        if not by_line[line]:
            lines.remove(line)
