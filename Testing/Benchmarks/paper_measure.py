# SPDX-License-Identifier: BSD-3-Clause
"""Runs PaperExperiments and describes the machine."""

import datetime
import hashlib
import json
import os
import platform
import subprocess
from pathlib import Path
from statistics import median

HERE = Path(__file__).resolve().parent
PROCESSORS = sorted(os.sched_getaffinity(0))


def first_line(path, start="", default=""):
    """The rest of the first line of the file that begins with `start`."""
    try:
        for line in Path(path).read_text().splitlines():
            if line.startswith(start):
                return line[len(start) :].strip(' \t:="')
    except OSError:
        pass
    return default


def caches():
    """'L1 48 KiB, L2 2 MiB, L3 105 MiB' as far as the system tells."""
    found = []
    for folder in sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        level, kind = first_line(folder / "level"), first_line(folder / "type")
        size = int(first_line(folder / "size", default="0").rstrip("K") or 0)
        if kind != "Instruction" and size:
            found.append(f"L{level} " + (f"{size // 1024} MiB" if size >= 1024 else f"{size} KiB"))
    return ", ".join(found)


def machine():
    memory = int(first_line("/proc/meminfo", "MemTotal", "0").split()[0])
    flags = first_line("/proc/cpuinfo", "flags").split()
    return {
        "processor": first_line("/proc/cpuinfo", "model name", platform.processor()),
        "virtual": "hypervisor" in flags,
        "processors": os.cpu_count(),
        "caches": caches(),
        "memory": f"{memory / 2**20:.0f} GiB",
        "system": first_line("/etc/os-release", "PRETTY_NAME", platform.system()),
        "kernel": platform.release(),
    }


def git(*arguments):
    """The output of git about the sources; empty without git."""
    try:
        run = subprocess.run(["git", "-C", str(HERE), *arguments], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return ""
    return run.stdout.strip()


def revision():
    """The commit of the sources; with '+' if sources have been changed since."""
    changed = git("status", "--porcelain", "--", ":/Filters/Engine", ":/Testing/Support", "*.cxx", "*.py")
    return git("rev-parse", "--short=12", "HEAD") + ("+" if changed else "")


def about(program):
    """Recorded once: how the program was built, where and when it runs."""
    built = json.loads(subprocess.run([program, "--about"], capture_output=True, check=True).stdout)
    return {
        "date": datetime.date.today().isoformat(),
        "revision": revision(),
        "program": hashlib.sha256(Path(program).read_bytes()).hexdigest()[:16],
        "machine": machine(),
        "loadBefore": round(os.getloadavg()[0], 2),
        **built,
    }


def row_of(line, points, distribution):
    """A row of Results.json from a line of the program: medians, and all rounds."""
    found = json.loads(line)
    names = ("read", "sort", "insert", "extract", "total", "wall")
    rounds = {name: found[name] for name in names if name in found}
    row = {"points": points, "distribution": distribution, "configuration": found["configuration"]}
    row.update(
        {name: found[name] for name in ("triangles", "checked", "faults", "np", "nr") if name in found}
    )
    if "read" in rounds:
        rounds["grid"] = [round(a + b, 3) for a, b in zip(rounds.pop("read"), rounds.pop("sort"))]
    row.update({name: round(median(times), 3) for name, times in rounds.items()})
    row["rounds"] = rounds
    return row


def measure(program, points, distribution, configurations, rounds, validate=False):
    """(rows, errors) of one distribution and number of points, on one processor."""
    command = [
        program,
        f"--sizes={points}",
        f"--distributions={distribution}",
        "--configurations=" + ",".join(configurations),
        f"--repeat={rounds}",
    ] + (["--validate-cgal"] if validate else [])
    run = subprocess.run(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: os.sched_setaffinity(0, PROCESSORS[-1:]),
    )
    rows = [row_of(line, points, distribution) for line in run.stdout.splitlines()]
    failures = [f"{r['configuration']}: {r['faults']}" for r in rows if r["faults"]]
    if run.returncode != 0 and not failures:
        failures = [f"PaperExperiments ended with {run.returncode}: {run.stderr.strip()[-300:]}"]
    where = f"{distribution}, {points} points: "
    return rows, [where + failure for failure in failures]
