# SPDX-License-Identifier: BSD-3-Clause
"""The tests of a part of the product, and how a fault is planted for them.

A part has the `names` of its tests. `measure(test, limit)` runs one without a fault and returns the lines that it
executes (lines.py); `run(test, limit)` runs it. `plant(fault)` changes a file of its copy and builds, `heal(fault)`
changes it back: the sources may change meanwhile.
"""

import dataclasses
import fnmatch
import json
import pathlib
import re
import shutil
import subprocess
import sys

import lines
import workshop

ALL_FOLDERS = (*workshop.FOLDERS, "Plugin", "Testing")
ALL_FILES = (*workshop.FILES, "paraview.plugin", "pyproject.toml", "README.md")
PYTHON = "Filters/Python"
BUILT_INTO = "_compiled.py"  # CMake writes into it
WITH_LAS = "Arrays/with_las.py --here"
MOST_TRACED = 100  # seconds of a test whose lines are told: some wait for lines that are slow then


@dataclasses.dataclass(frozen=True)
class Tests:
    """Targets and tests of a part: `programs` of GoogleTest with their filters, and tests of ctest whose names match
    `listed`.
    """

    targets: tuple
    programs: tuple = ()
    listed: str = ""


VTK_LAYER = Tests(
    ("FilterTests", "FaultsCancel", "FaultsMemory", "AdaptiveHilbertDelaunayFiltersPython",
     "AdaptiveHilbertDelaunayPythonLibrary"),
    (
        ("FilterTests", "*"),
        ("FaultsCancel", "-Long*"),
        ("FaultsMemory", "-Long*"),
    ),
    r"Filter\.Ranks\.Ranks(Compare\.2|(Sample|Gathered|Blocks|Updates)\.3)|Package\.Class\.Compiled\..*",
)
JOB = Tests(
    ("EngineCInterface", "EngineHiddenOperators", "EngineJobHashes", "EngineJobProgress", "EngineJobSurface",
     "EngineJobTrouble", "AdaptiveHilbertDelaunayPythonLibrary"),
    (),
    r"Engine\.(CInterface|HiddenOperators|Job\w+)|Package\.(Arrays|Class\.Python)\..*",
)
# By the beginning of a file's path; the longest that fits counts.
TESTS = {
    "Filters/": VTK_LAYER,
    "Filters/Ranks/": Tests(
        ("FilterTests", "FaultsRanks", "AdaptiveHilbertDelaunayFiltersPython", "AdaptiveHilbertDelaunayPythonLibrary"),
        (("FilterTests", "*Rank*"),),
        r"Filter\.Ranks\..*",
    ),
    "Filters/Engine/": Tests(("all",), (), r"Engine\.(?!Sanitized|ThreadSanitizer).*"),
    "Filters/Engine/Interface/": JOB,
    "Filters/Engine/Job/": JOB,
}


def part_for(folder, work, jobs, python, package):
    """The part that a folder of the product belongs to."""
    if folder == PYTHON or folder.startswith(PYTHON + "/"):
        return PythonPart(work / "python", jobs, python, package)
    fitting = [begin for begin in TESTS if (folder + "/").startswith(begin)]
    if not fitting:
        raise workshop.BuildError(f"{folder} is no folder of the product that has tests of its own")
    return CxxPart(work / "cxx", jobs, TESTS[max(fitting, key=len)], folder)


class PythonPart(workshop.Workshop):
    """The Python package: a copy of a built one, with the modules of the sources, and its tests without a build.

    `python` has the VTK, the PyVista and the laspy of PyPI, or the tests that need them are left out.
    """

    def __init__(self, folder, jobs, python, package):
        super().__init__(folder, jobs, ALL_FOLDERS, ALL_FILES)
        self.python = python
        self.tests_folder = self.source / "Testing/Package"
        self.place = self.folder / "package" / "adaptivehilbertdelaunay"
        self.fill_package(package)
        sys.path.insert(0, str(self.tests_folder))
        import pairs

        self.environment = pairs.suite_environment([str(self.folder / "package")])
        own = [f"{folder}/{path.name}" for folder in ("Arrays", "Class")
               for path in sorted((self.tests_folder / folder).glob("test_*.py"))]  # fmt: skip
        others = [script for script in (WITH_LAS, *pairs.FOR_ALL, *pairs.FOR_VTK) if script not in own]
        self.names = [script for script in own + others if self.can_run(script)]

    def fill_package(self, package):
        shutil.rmtree(self.folder / "package", ignore_errors=True)
        found = sorted(pathlib.Path(package).glob("**/adaptivehilbertdelaunay/libadaptivehilbertdelaunay.*"))
        if not found:
            raise workshop.BuildError(f"There is no built package below {package}")
        shutil.copytree(found[0].parent, self.place)
        for path in (self.source / PYTHON).rglob("*.py"):
            if path.name != BUILT_INTO:
                target = self.place / path.relative_to(self.source / PYTHON)
                target.parent.mkdir(exist_ok=True)
                shutil.copyfile(path, target)
        shutil.copyfile(pathlib.Path(__file__).with_name("tell_lines.py"), self.folder / "package" / "sitecustomize.py")

    def can_run(self, script):
        if script.startswith("Arrays/"):
            needed = "laspy, lazrs, rasterio" if script == WITH_LAS else "numpy"
        else:
            needed = "pyvista" if "pyvista" in script.lower() else "vtkmodules"
        return subprocess.run([self.python, "-c", "import " + needed], capture_output=True).returncode == 0

    def path(self, file):
        return self.place / pathlib.PurePosixPath(file).relative_to(PYTHON)

    def run(self, test, limit, **environment):
        script, *words = test.split()
        command = [self.python, str(self.tests_folder / script), *words]
        return workshop.execute(command, self.folder, limit, {**self.environment, **environment})

    def measure(self, test, limit):
        """How it runs without a fault, and the lines that it executes."""
        told = self.folder / "lines.txt"
        told.unlink(missing_ok=True)
        self.run(test, min(limit, MOST_TRACED), AHD_TELL_LINES=str(told))  # limits of time may fail here
        rows = told.read_text().splitlines() if told.exists() else []
        facts = lines.joined(json.loads(row) for row in rows)
        named = {kind: {f"{PYTHON}/{file}": those for file, those in files.items()} for kind, files in facts.items()}
        return self.run(test, limit), named

    def plant(self, fault):
        self.before = self.path(fault.file).read_text()
        text = fault.apply(self.before)
        try:
            compile(text, fault.file, "exec")
        except SyntaxError as error:
            raise workshop.BuildError(str(error)) from error
        self.path(fault.file).write_text(text)

    def heal(self, fault):
        self.path(fault.file).write_text(self.before)


def system_python():
    """The interpreter of ParaView's VTK, not the first of PATH."""
    return ["-DPython3_EXECUTABLE=/usr/bin/python3"] if pathlib.Path("/usr/bin/python3").exists() else []


class CxxPart(workshop.Workshop):
    """A folder of C++: a copy of all sources and one build of it as users have it, the folder `source/build`.

    A second one counts lines, so that a test is run for a fault only where it executes it.
    """

    def __init__(self, folder, jobs, tests, part):
        super().__init__(folder, jobs, ALL_FOLDERS, ALL_FILES)
        self.wanted = tests
        self.build_folder = self.source / "build"
        self.make(self.build_folder, "ccache" if shutil.which("ccache") else "")
        self.commands = self.all_commands(self.build_folder)
        self.names = list(self.commands)
        group = lines.group_of(part)
        self.counting = self.source / ("counting-" + group.rpartition("/")[2].lower())
        self.executed = lines.Executed(self.counting, self.source, group)
        self.counting_commands = {}  # built when the first is wanted

    def make(self, build, launcher, *options):
        """Configures a build if needed, and updates it."""
        if not (build / "build.ninja").exists():
            command = ["cmake", "-S", self.source, "-B", build, "-G", "Ninja", "-DBUILD_TESTING=ON", *system_python(),
                       "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON", *options]  # fmt: skip
            if launcher:
                command.append(f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}")
            workshop.run_quietly(command)
        workshop.run_quietly(["ninja", "-C", build, f"-j{self.jobs}", *self.wanted.targets])

    def make_counting(self):
        launcher = self.folder / (self.counting.name + ".sh")
        cache = "ccache" if shutil.which("ccache") else ""
        self.write(launcher, lines.LAUNCHER.format(group=self.executed.folder, cache=cache).encode())
        launcher.chmod(0o755)
        linked = [f"-DCMAKE_{kind}_LINKER_FLAGS=--coverage" for kind in ("EXE", "SHARED", "MODULE")]
        self.make(self.counting, launcher, *linked)
        self.counting_commands = self.all_commands(self.counting)

    def all_commands(self, build):
        return {**dict(self.programs(build)), **dict(self.listed(build))}

    def programs(self, build):
        """Each suite of the programs of GoogleTest by itself, and each test that wants a process of its own."""
        for program, chosen in self.wanted.programs:
            words = [build / "bin" / program, "--gtest_color=no"]
            command = [*words, "--gtest_list_tests", "--gtest_filter=" + chosen]
            suites, suite = {}, ""
            for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
                name = line.partition("#")[0].strip()
                if not line.startswith(" "):
                    suite = name
                else:
                    alone = fnmatch.fnmatch(suite + name, workshop.WANT_A_PROCESS)
                    suites.setdefault(suite + (name if alone else "*"), []).append(suite + name)
            for suite, names in suites.items():
                yield f"{program} {suite}", ([*words, "--gtest_filter=" + ":".join(names)], {})

    def listed(self, build):
        """Commands and environments of tests from ctest."""
        command = ["ctest", "--test-dir", build, "--show-only=json-v1"]
        for test in json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["tests"]:
            settings = {row["name"]: row["value"] for row in test.get("properties", [])}
            environment = dict(word.split("=", 1) for word in settings.get("ENVIRONMENT", []))
            if "command" in test and re.fullmatch(self.wanted.listed, test["name"]):
                yield test["name"], (test["command"], environment)

    def run(self, test, limit):
        return self.execute(self.commands[test], limit)

    def execute(self, words, limit):
        command, environment = words
        return workshop.execute(command, self.folder, limit, {**environment, "GTEST_FAIL_FAST": "1"})

    def measure(self, test, limit):
        """How it runs without a fault, and the lines that it executes; none where they were not counted."""
        if not self.counting_commands:
            self.make_counting()
        self.executed.forget()
        if test in self.counting_commands:
            self.execute(self.counting_commands[test], limit)  # limits of time or memory may fail here
        return self.run(test, limit), self.executed.read()

    def plant(self, fault):
        self.before = (self.source / fault.file).read_text()
        (self.source / fault.file).write_text(fault.apply(self.before))
        self.make(self.build_folder, "")

    def heal(self, fault):
        (self.source / fault.file).write_text(self.before)
