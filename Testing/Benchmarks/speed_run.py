# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmark programs for speed.py and returns their measurements."""

import json
import os
import subprocess
import sys
import time

BEGIN = time.monotonic()
PROCESSORS = sorted(os.sched_getaffinity(0))


def say(text):
    print(f"[{time.monotonic() - BEGIN:4.0f} s] {text}", file=sys.stderr, flush=True)


def output_of(command, pinned, seconds=None):
    """The output of the command; None if it takes longer. Exits if it fails."""
    processors = PROCESSORS[-1:] if pinned else PROCESSORS
    try:
        run = subprocess.run(
            command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, timeout=seconds,
            preexec_fn=lambda: os.sched_setaffinity(0, processors),
        )
    except subprocess.TimeoutExpired:
        return None
    if run.returncode != 0:
        sys.exit(f"speed.py: {' '.join(command)} failed ({run.returncode}):\n{run.stdout}")
    return run.stdout


def benchmarks_of(command, pinned, seconds=None):
    """The measurements of Google Benchmark, the runs of one process in random turns; None if it took longer."""
    text = output_of(
        command + ["--benchmark_format=json", "--benchmark_enable_random_interleaving=true"], pinned, seconds
    )
    if text is None:
        return None
    if not text.strip():  # none is called so
        return []
    return [b for b in json.loads(text)["benchmarks"] if b["run_type"] == "iteration" and "triangles" in b]


class Programs:
    """The programs, and their measurements as lists of samples."""

    def __init__(self, arguments):
        self.paths = {
            name: getattr(arguments, name) for name in ("engine", "counts", "constraints", "filter", "before")
        }
        self.triangles = {}

    def has(self, name):
        return bool(self.paths[name])

    def engine(self, size, runs, repeat, cold=False, before=False, seconds=None):
        """ns a point of (engine, distribution) or (engine, distribution, size) in one process, in turns.
        None if it took longer than the seconds."""
        runs = [run if len(run) == 3 else (*run, size) for run in runs]
        text = [
            self.paths["before" if before else "engine"],
            "--engines=" + ",".join(dict.fromkeys(run[0] for run in runs)),
            "--distributions=" + ",".join(dict.fromkeys(run[1] for run in runs)),
            "--sizes=" + ",".join(str(size) for size in dict.fromkeys(run[2] for run in runs)),
            f"--repeat={repeat}",
        ]
        pinned = not any(run[0].startswith("threads") for run in runs)
        wanted = "|".join(f"{engine}/{name}/{n}/" for engine, name, n in runs).replace("*", ".")
        found = benchmarks_of(text + [f"--benchmark_filter=^({wanted})"] + ["--cold"] * cold, pinned, seconds)
        if found is None:
            return None
        samples = {run: [] for run in runs}
        for benchmark in found:
            engine, name, n = benchmark["name"].split("/")[:3]
            samples[engine, name, int(n)].append(benchmark["nsPerPoint"])
            self._compare(engine, (name, int(n)), benchmark["triangles"])
        return samples

    def _compare(self, engine, points, triangles):
        """All engines triangulate the same points: if they differ, one of them is wrong."""
        if engine == "float":
            return
        has_some = triangles > 0 or points[0] == "Collinear"
        if not has_some or self.triangles.setdefault(points, triangles) != triangles:
            sys.exit(f"speed.py: {engine}: {triangles:.0f} triangles of {points}, which is wrong")

    def features(self, size, names, threads=1, repeat=1, cold=False):
        """Lists of (CPU, wall) ns a point by name of a feature, of one process."""
        command = [
            self.paths["filter"], f"--points={size}", f"--threads={threads}", "--features=" + ",".join(names),
            f"--benchmark_repetitions={repeat}",
        ]
        samples = {name: [] for name in names}
        for benchmark in benchmarks_of(command + ["--cold"] * cold, pinned=threads == 1):
            name = benchmark["name"].split("/")[0]
            samples[name].append((benchmark["nsPerPoint"], benchmark["wallNsPerPoint"]))
        return samples

    def shape(self, size, name, repeat):
        """The measurements of ConstraintBenchmark for one shape: {engine: [its counters, real_time in ms]}."""
        command = [
            self.paths["constraints"], f"--points={size}", f"--repeat={repeat}",
            f"--benchmark_filter=^[a-z]+/{name}/",
        ]
        found = {}
        for benchmark in benchmarks_of(command, pinned=True):
            found.setdefault(benchmark["name"].split("/")[0], []).append(benchmark)
        return found

    def count(self, sizes, distributions, threads):
        text = output_of(
            [
                self.paths["counts"], "--sizes=" + ",".join(map(str, sizes)),
                "--distributions=" + ",".join(distributions), "--threads=" + ",".join(map(str, threads)),
            ], pinned=False,
        )
        return [json.loads(line) for line in text.splitlines()]
