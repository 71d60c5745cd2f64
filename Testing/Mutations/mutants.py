# SPDX-License-Identifier: BSD-3-Clause
"""The list of mutants: reads and checks it."""

import dataclasses
import hashlib
import pathlib
import re
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parent.parent
ENGINE = "Filters/Engine"
FILTER = "filter"  # before the tests of the VTK layer
FILTER_PROGRAMS = ("FaultsCancel", "FaultsMemory")  # beside FilterTests, whose suites are tests
FUSED = "PredicatesFma"  # all tests of the predicates; exists where the processor has fused multiply-adds
FIELDS = {"name", "file", "old", "new", "at", "breaks", "hints", "equivalent"}


class ListError(Exception):
    """The list does not fit the sources."""


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One way to break the engine or the VTK layer.

    `old` becomes `new` in `file` (a path below `folder`, that of its list: Filters/Engine by default). `old` occurs
    there once; else `at` is the number of the occurrence, from 1. `hints` are the tests likely to notice, best first.
    Of the engine: names without "Engine."; "asan:" or "tsan:" before one means its run under sanitizers. Of the VTK
    layer: suites of FilterTests, or programs beside it. `equivalent` is empty, or the reason why nothing that is
    promised changes.
    """

    name: str
    file: str
    old: str
    new: str
    breaks: str
    hints: tuple = ()
    at: int = 0
    equivalent: str = ""
    folder: str = ENGINE

    @property
    def is_of_engine(self):
        return self.folder == ENGINE

    def fingerprint(self):
        text = "\0".join([self.file, self.old, self.new, str(self.at)])
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def path(self, root):
        return pathlib.Path(root) / self.folder / self.file

    def apply(self, text):
        """The mutated text of the file. Raises ListError where `old` is not found so."""
        count = text.count(self.old)
        if count == 0:
            raise ListError(f"{self.name}: not found in {self.file}: {self.old!r}")
        if (count > 1) != (self.at > 0) or self.at > count:
            raise ListError(f"{self.name}: {count} times in {self.file}, `at` is {self.at}: {self.old!r}")
        begin = -1
        for _ in range(max(1, self.at)):
            begin = text.index(self.old, begin + 1)
        return text[:begin] + self.new + text[begin + len(self.old) :]


def load():
    """All mutants, in the order of the files and of their lines. Raises ListError."""
    mutants, names = [], set()
    for path in sorted((FOLDER / "mutants").glob("*.toml")):
        content = tomllib.loads(path.read_text())
        for row in content["mutant"]:
            if unknown := set(row) - FIELDS:
                raise ListError(f"{path.name}: {row.get('name')}: what is {sorted(unknown)}?")
            row["hints"] = tuple(row.get("hints", ()))
            mutant = Mutant(**row, folder=content.get("folder", ENGINE))
            if mutant.name in names:
                raise ListError(f"{mutant.name}: twice in the list")
            if mutant.old == mutant.new:
                raise ListError(f"{mutant.name}: changes nothing")
            names.add(mutant.name)
            mutants.append(mutant)
    return mutants


def engine_tests(root=ROOT):
    """The tests of the engine: one a file, and one of several."""
    return sorted({path.stem for path in (pathlib.Path(root) / "Testing/Engine").rglob("*.cxx")} | {FUSED})


def filter_suites(root=ROOT):
    """The suites of FilterTests."""
    texts = (path.read_text() for path in (pathlib.Path(root) / "Testing/Filters").rglob("*.cxx"))
    return {suite for text in texts for suite in re.findall(r"^TEST(?:_[PF])?\((\w+),", text, re.MULTILINE)}


def check(mutants, root=ROOT):
    """Complaints: mutants that do not apply to the sources, hints that are no tests."""
    complaints = []
    of_engine = engine_tests(root)
    filter_tests = filter_suites(root).union(FILTER_PROGRAMS)
    for mutant in mutants:
        try:
            mutant.apply(mutant.path(root).read_text())
        except (ListError, OSError) as error:
            complaints.append(str(error))
        tests = of_engine if mutant.is_of_engine else filter_tests
        for hint in mutant.hints:
            if hint.split(":")[-1] not in tests:
                complaints.append(f"{mutant.name}: there is no test {hint}")
    return complaints
