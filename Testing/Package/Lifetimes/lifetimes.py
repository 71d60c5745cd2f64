#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random sequences of what programs do to triangulations, filters and pipelines; each result is that of a new one.

    lifetimes.py arrays                                  NumPy's arrays
    lifetimes.py pipelines --class python|compiled       VTK's classes, in Python or compiled
    lifetimes.py program --program LifetimeFuzz          the same in C++ (Testing/Fuzz), where all is watched

    --sequences N    how many; --first N: the number of the first; --length N: steps of each; by default those of the
                     quick suite (--quick), behind the corpus
    --minutes N      go on with further sequences for so long
    --steps TEXT     this sequence only, as it was printed
    --corpus FILE    sequences to be run first, one a line, each behind the name of its world; # begins a comment
    --watched DIR    the libraries of Testing/Fuzz/Watched.cmake, which the address sanitizer watches; without it
                     memory that is freed is overwritten
    --without NAME   leave this step out; can be repeated

Sequences run in a process of their own. Of one that fails, or ends the process, steps are left out as long as it
fails; then the command that shows the fault is printed. exit code 0: none failed; 1: one did; 2: wrong use.
"""

import argparse
import contextlib
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

from shrinking import shrink

HERE = pathlib.Path(__file__).resolve()
FAILED = 3  # exit code of a child whose result is wrong
CORPUS = HERE.parents[3] / "Data" / "Corpus" / "Fuzz" / "lifetimes.txt"
#: The quick suite's sequences, and steps of each: a minute or less.
QUICK = {"arrays": (24, 60), "pipelines": (20, 40), "program": (50, 40)}
SECONDS = 600  # the longest that a child may take: nothing hangs


class Program:
    """The world of Testing/Fuzz/LifetimeFuzz: a step is four bytes, in hexadecimal."""

    STEPS = 34  # the program's kinds

    @classmethod
    def sequence(cls, seed, count, without=()):
        rng, made = random.Random("program %s" % seed), []
        while len(made) < count:
            kind = rng.randrange(cls.STEPS)
            token = "%02x%06x" % (kind, rng.randrange(1 << 24))
            if str(kind) not in without:
                made.append(token)
        return ",".join(made)


def world_of(name):
    if name == "program":
        return Program
    if name == "arrays":
        from arrays import Arrays

        return Arrays
    from pipelines import Pipelines

    return Pipelines


def parse(given=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("world", choices=("arrays", "pipelines", "program"))
    parser.add_argument("--program")
    parser.add_argument("--class", dest="kind", choices=("python", "compiled"), default="python")
    parser.add_argument("--sequences", type=int)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--length", type=int)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--minutes", type=float, default=0)
    parser.add_argument("--steps")
    parser.add_argument("--corpus")
    parser.add_argument("--watched")
    parser.add_argument("--without", action="append", default=[])
    parser.add_argument("--child", help=argparse.SUPPRESS)  # a file of sequences, one a line
    parser.add_argument("--list", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args(given)
    sequences, length = QUICK[options.world]
    options.sequences, options.length = options.sequences or sequences, options.length or length
    options.corpus = options.corpus or (options.quick and CORPUS)
    return options


# --- The process that runs sequences ------------------------------------------------------------------------


def list_sequences(options):
    """The texts of the requested sequences."""
    world, numbers = world_of(options.world), range(options.first, options.first + options.sequences)
    return [world.sequence(number, options.length, options.without) for number in numbers]


def run_child(options):
    """Runs the sequences of a file, and prints the current one to stdout."""
    world = world_of(options.world)
    for number, sequence in enumerate(pathlib.Path(options.child).read_text().splitlines()):
        print(number, flush=True)
        try:
            world().run(sequence)
        except BaseException:
            import traceback

            traceback.print_exc()
            sys.stderr.flush()
            os._exit(FAILED)
    print("done", flush=True)


# --- The process that monitors it ----------------------------------------------------------------------------


class Runner:
    """Starts children, with checked memory."""

    def __init__(self, options):
        self.options, self.environment = options, dict(os.environ, PYTHONFAULTHANDLER="1", PYTHONUNBUFFERED="1")
        if options.world == "program":
            self.environment["AHD_FUZZ_SHOW"] = "1"
        elif options.watched:
            self._watch(pathlib.Path(options.watched))
        else:
            self.environment.update(MALLOC_PERTURB_="165")

    def _watch(self, folder):
        given = self.environment
        given["LD_PRELOAD"] = (folder / "runtime.txt").read_text().strip()
        given["ADAPTIVEHILBERTDELAUNAY_LIBRARY"] = str(folder / "libadaptivehilbertdelaunay.so")
        if self.options.kind == "compiled":
            given["LD_LIBRARY_PATH"] = "%s:%s" % (folder, given.get("LD_LIBRARY_PATH", ""))
        given["PYTHONMALLOC"] = "malloc"
        given["ASAN_OPTIONS"] = (
            "detect_leaks=0:print_legend=0:detect_odr_violation=0:alloc_dealloc_mismatch=0:handle_segv=1:"
            "allocator_may_return_null=1:max_free_fill_size=65536:malloc_context_size=8:quarantine_size_mb=64:"
            "detect_stack_use_after_return=0")
        given["UBSAN_OPTIONS"] = "print_stacktrace=1"

    def run(self, sequences):
        """None if all passed; else the number of the failed sequence and its output."""
        options = self.options
        with tempfile.TemporaryDirectory() as folder:
            if options.world == "program":
                files = []
                for number, sequence in enumerate(sequences):
                    files.append(pathlib.Path(folder, "sequence-%d" % number))
                    files[-1].write_bytes(bytes.fromhex(sequence.replace(",", "")))
                code, out, said = self._start([options.program, "-timeout=60", "-artifact_prefix=%s/" % folder, *files])
                numbers = re.findall(r"^Running: \S*sequence-(\d+)$", said, re.MULTILINE)
                isDone = True
            else:
                file = pathlib.Path(folder, "sequences")
                file.write_text("".join(sequence + "\n" for sequence in sequences))
                code, out, said = self._start(
                    [sys.executable, str(HERE), options.world, "--class", options.kind, "--child", str(file)])
                numbers, isDone = re.findall(r"^\d+$", out, re.MULTILINE), out.endswith("done\n")
        if code == "0" and isDone:
            return None
        return int(numbers[-1] if numbers else 0), "exit code %s\n%s" % (code, shortened(said))

    def list(self, first):
        """As list_sequences() has them: in a process with the libraries that the package loads."""
        options = self.options
        command = [sys.executable, str(HERE), options.world, "--class", options.kind, "--list", "--first", str(first),
                   "--sequences", str(options.sequences), "--length", str(options.length)]
        for name in options.without:
            command += ["--without", name]
        code, out, said = self._start(command)
        if code != "0":
            raise SystemExit("lifetimes.py: the package cannot be loaded\n" + said)
        return out.splitlines()

    def _start(self, command):
        """Exit code, stdout and stderr of a command."""
        # To files: the sanitizer's symbolizer may outlive the child, and would keep pipes open.
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as said:
            child = subprocess.Popen(command, env=self.environment, stdout=out, stderr=said, start_new_session=True)
            try:
                code = str(child.wait(SECONDS))
            except subprocess.TimeoutExpired:
                code = "none, it hangs"
            with contextlib.suppress(ProcessLookupError):
                os.killpg(child.pid, signal.SIGKILL)
            child.wait()
            texts = []
            for file in (out, said):
                file.seek(0)
                texts.append(file.read().decode(errors="replace"))
        return (code, *texts)

    def command(self, sequence):
        options = self.options
        if options.world == "program":
            return "%s %s program --program %s --steps %s" % (sys.executable, HERE, options.program, sequence)
        watched = " --watched %s" % options.watched if options.watched else ""
        return "PYTHONPATH=%s %s %s %s --class %s%s --steps %s" % (
            os.environ.get("PYTHONPATH", ""), sys.executable, HERE, options.world, options.kind, watched, sequence)


def shortened(said):
    """With only the first frames of a sanitizer's stacks."""
    lines = [line[:2000] for line in said.splitlines() if not re.match(r" +#(1[2-9]|[2-9]\d)", line)]
    return re.sub(r"Shadow bytes around.*?(?===|$)", "", "\n".join(lines), flags=re.DOTALL)[-6000:]


def kind_of(said):
    """The failure in short: the sanitizer's summary, or the exception and the beginning of its text."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    summaries = [line.split(":")[0] for line in lines if "not what a new" in line]
    summaries += [line for line in lines if line.startswith("SUMMARY:")]
    return summaries[0] if summaries else lines[-1].split(":")[0] if len(lines) > 1 else lines[0]


def report(runner, sequences, failed):
    """Prints the shortest sequence found that fails in the same way, and the command to repeat it."""
    number, said = failed
    sequence, kind = sequences[number], kind_of(said)

    def fails(steps):
        again = runner.run([",".join(steps)])
        return again is not None and kind_of(again[1]) == kind

    print(said)
    print("\nFailed: %s" % sequence)
    if runner.run([sequence]) is None:
        print("Alone it passes. It fails behind others, --first and --sequences as here: %d of them" % (number + 1))
        return
    shortest = ",".join(shrink(sequence.split(","), fails))
    again = runner.run([shortest])
    print(again[1] if again else "")
    print("\nTo see it again:\n  %s" % runner.command(shortest))


def corpus_of(options):
    if not options.corpus:
        return []
    lines = [line.split("#")[0].split() for line in pathlib.Path(options.corpus).read_text().splitlines()]
    return [line[1] for line in lines if line and line[0] == options.world]


def main():
    options = parse()
    os.environ["AHD_TEST_CLASS"] = options.kind
    if options.child:
        run_child(options)
        return 0
    if options.list:
        print("\n".join(list_sequences(options)))
        return 0
    runner = Runner(options)
    if options.steps:
        sequences = [options.steps]
        failed = runner.run(sequences)
        if failed:
            print(failed[1])
        return 1 if failed else 0
    first, end = options.first, time.monotonic() + 60 * options.minutes
    sequences = corpus_of(options)
    while True:
        sequences += runner.list(first)
        failed = runner.run(sequences)
        if failed:
            report(runner, sequences, failed)
            return 1
        first += options.sequences
        if time.monotonic() >= end:
            break
        sequences = []
    print("%d sequences of %d steps" % (first - options.first, options.length))
    return 0


if __name__ == "__main__":
    sys.exit(main())
