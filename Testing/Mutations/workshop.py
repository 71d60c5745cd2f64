# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the sources to break, and its builds."""

import contextlib
import dataclasses
import hashlib
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time

from mutants import FILTER, FILTER_PROGRAMS, ROOT, engine_tests

# The sources of the tests of the engine and of the VTK layer. Parts of Testing/ not listed are not configured.
FOLDERS = ("Filters", "Testing/Engine", "Testing/Filters", "Testing/Support", "Data")
FILES = ("CMakeLists.txt", "Testing/CMakeLists.txt", ".ci/mpi.env", ".ci/unquoted.txt")
PARTS_OF_FILTER_TESTS = ("*-*Hashes*", "*Hashes*")  # hashes last
WANT_A_PROCESS = "Messages.RunningOut*"  # of FilterTests: memory kept by others is enough for them
SANITIZERS = {"": "", "asan": "address,undefined", "tsan": "thread"}  # by prefix of a test's name
GIBIBYTE = 1 << 30


class BuildError(Exception):
    """The copy could not be built."""


@dataclasses.dataclass
class Run:
    """How a test program ended: `failure` is empty if it passed, else which test failed and how."""

    failure: str
    seconds: float
    cpu: float


class Workshop:
    """Sources and builds below `folder`. Only changed files are copied, so builds stay incremental."""

    def __init__(self, folder, jobs, folders=FOLDERS, files=FILES):
        self.folder = pathlib.Path(folder).resolve()
        self.source = self.folder / "source"
        self.jobs = jobs
        self.folders, self.files = folders, files
        self.configured = set()
        self.copy()

    def copy(self):
        """Updates the copy from the sources."""
        for name in self.folders:
            here, there = ROOT / name, self.source / name
            wanted = {path.relative_to(here) for path in here.rglob("*") if path.is_file()}
            for path in list(there.rglob("*")):
                if path.is_file() and path.relative_to(there) not in wanted:
                    path.unlink()
            for path in wanted:
                self.write(there / path, (here / path).read_bytes())
        for name in self.files:
            self.write(self.source / name, (ROOT / name).read_bytes())

    def digest(self):
        """Of all copied sources but these tools."""
        whole = hashlib.sha256()
        for name in (*self.folders, *self.files):
            top = self.source / name
            for path in sorted(top.rglob("*")) if top.is_dir() else [top]:
                if path.is_file() and "Mutations" not in path.parts:
                    whole.update(f"{path.relative_to(self.source)} {len(path.read_bytes())} ".encode())
                    whole.update(path.read_bytes())
        return whole.hexdigest()[:16]

    def write(self, path, content):
        """Writes a file unless it holds that already."""
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)

    def tests(self, of_engine=True):
        """All tests, by name. Of the VTK layer: parts of FilterTests, and programs beside it."""
        if of_engine:
            return engine_tests(self.source)
        first, last = PARTS_OF_FILTER_TESTS
        return [f"{FILTER}:{name}" for name in (first, *FILTER_PROGRAMS, last)]

    def binary(self, sanitizer):
        """The build folder of plain code or of a sanitizer, configured."""
        build = self.folder / ("build-" + (sanitizer or "plain"))
        if sanitizer not in self.configured:
            top = self.source if sanitizer == FILTER else self.source / "Testing/Engine"
            command = ["cmake", "-S", top, "-B", build, "-G", "Ninja"]
            # Without warnings (-w): code that a mutant leaves unused is no error.
            if sanitizer == FILTER:
                command += ["-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1 -DNDEBUG -w", *filter_options()]
            elif sanitizer:
                command += ["-DAHD_SANITIZE=" + SANITIZERS[sanitizer], "-DCMAKE_CXX_FLAGS=-w"]
            else:
                command += ["-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1 -DNDEBUG -w"]
            if shutil.which("ccache"):
                command += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
            run_quietly(command)
            self.configured.add(sanitizer)
        return build

    def build(self, test):
        """Builds the program of a test, and returns its path. Raises BuildError."""
        sanitizer, _, name = test.partition(":") if ":" in test else ("", "", test)
        build = self.binary(sanitizer)
        if sanitizer == FILTER:
            program = name if name in FILTER_PROGRAMS else "FilterTests"
            run_quietly(["ninja", "-C", build, f"-j{self.jobs}", program])
            return build / "bin" / program
        run_quietly(["ninja", "-C", build, f"-j{self.jobs}", "Engine" + name])
        return build / ("Engine" + name)

    def run(self, test, program, cpu_limit):
        """Runs the quick tests of a program until the first that fails.

        Each is stopped after so many seconds of processor time, or ten times as many on the clock (execute())."""
        sanitizer, _, name = test.partition(":") if ":" in test else ("", "", test)
        chosen = "-Long*"
        if sanitizer == FILTER and name not in FILTER_PROGRAMS:
            chosen = name if "*" in name else name + ".*"
            chosen += (":" if "-" in chosen else "-") + WANT_A_PROCESS
        command = [program, "--gtest_filter=" + chosen, "--gtest_fail_fast", "--gtest_color=no"]
        is_limited = sanitizer not in ("asan", "tsan")  # these reserve terabytes
        return execute(command, self.folder, cpu_limit, {"TSAN_OPTIONS": "halt_on_error=1"}, is_limited)


def execute(command, folder, cpu_limit, environment, is_limited=True):
    """Runs a command in a folder, stopped, and all that it started, after so many seconds of processor time, or ten
    times as many on the clock in which it did not wait for a processor. `is_limited`: with 12 GiB of addresses at most.
    """

    def limit():
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # a shell's background jobs ignore it
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (int(cpu_limit), int(cpu_limit) + 5))
        if is_limited:
            resource.setrlimit(resource.RLIMIT_AS, (12 * GIBIBYTE, 12 * GIBIBYTE))

    before, used = time.monotonic(), children_cpu()
    with open(folder / "output.txt", "w+b") as output:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            preexec_fn=limit,
            start_new_session=True,
            cwd=folder,
            env={**os.environ, **environment},
        )
        try:
            code = wait(process, 10 * cpu_limit)
        except subprocess.TimeoutExpired:
            code = -signal.SIGXCPU
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        output.seek(0)
        text = output.read().decode(errors="replace")
    return Run(failure_in(text, code), time.monotonic() - before, children_cpu() - used)


def wait(process, limit):
    """The exit code of the first process of a session. Raises TimeoutExpired after so many seconds on the clock, less
    all that threads of the session waited for a processor, so that other work on the machine does not count.
    """
    begin, waited = time.monotonic(), {}
    while True:
        with contextlib.suppress(subprocess.TimeoutExpired):
            return process.wait(timeout=1)
        waited.update(waits_for_processors(process.pid))
        if time.monotonic() - begin - sum(waited.values()) > limit:
            raise subprocess.TimeoutExpired(process.args, limit)


def waits_for_processors(session):
    """By thread of a session's processes, the seconds that it was ready to run and did not."""
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):  # it ended meanwhile
            if int(stat.read_text().rpartition(")")[2].split()[3]) != session:
                continue
            for thread in stat.parent.glob("task/*/schedstat"):
                yield str(thread), int(thread.read_text().split()[1]) / 1e9


def filter_options():
    """How the VTK layer is configured: without plugin and Python, with ParaView's VTK if there is no other."""
    found = sorted(pathlib.Path("/usr/lib").glob("*/cmake/paraview-*/vtk"))
    return ["-DAHD_BUILD_PARAVIEW_PLUGIN=OFF", "-DAHD_WRAP_PYTHON=OFF"] + [f"-DVTK_DIR={path}" for path in found[-1:]]


def children_cpu():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def failure_in(text, code):
    """The test that failed, and how, from the program's output and exit; empty if none did."""
    if code == 0:
        return ""
    failed = re.findall(r"^\[  FAILED  \] ([^\s,(]+)|^(?:FAIL|ERROR): (\w+) \(", text, re.MULTILINE)
    if code > 0 and failed:
        return "".join(failed[0])
    begun = re.findall(r"^\[ RUN      \] (\S+)", text, re.MULTILINE)
    where = begun[-1] if begun else "before the first test"
    if code > 0:
        return where + " (sanitizer)" if "anitizer" in text or "runtime error" in text else where + " (exit)"
    if -code in (signal.SIGXCPU, signal.SIGKILL):
        return where + " (time limit)"
    return f"{where} ({signal.Signals(-code).name})"


def run_quietly(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise BuildError(done.stdout.decode(errors="replace")[-4000:])
