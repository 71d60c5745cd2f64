#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures everything that is aimed at in speed, and prints tables and, last, one line a target:

  ok|short  name  value  target

Ratios are of medians measured in one run, in turns; a row that comes out short is measured once more.
Runs of one thread are pinned to one processor and timed by its CPU time. Nothing is asserted: time depends
on the machine and on what else it does. speed.sh builds the programs and calls this.

  speed.py --engine <build>/EngineBenchmark --counts <build>/EngineCounts [--before <old>/EngineBenchmark]
           [--constraints <build>/ConstraintBenchmark] [--filter <build>/FilterBenchmark]
           [--quick] [--only WORD] [--out FOLDER] [--check]    measures; with --out: Speed.json, Speed.md
  speed.py --scaling --counts <build>/EngineCounts [--quick]   counts only, for 2 to 64 threads
  speed.py --render [--out FOLDER]      Speed.md and the line of README.md from Speed.json
  speed.py --compare                    fails where they are not what --render gives
"""

import argparse
import datetime
import json
import re
import sys
from pathlib import Path

import speed_report as report
from speed_rows import SECTIONS, Plan, Row, machine, powered
from speed_run import Programs, say

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("engine", "counts", "constraints", "filter", "before"):
        parser.add_argument(f"--{name}", help="the program to run")
    parser.add_argument("--quick", action="store_true", help="few points: seconds, rough numbers")
    parser.add_argument("--only", help="rows whose line contains this word")
    parser.add_argument("--scaling", action="store_true", help="count for 2 to 64 threads, no more")
    parser.add_argument("--check", action="store_true", help="fail if a target was not measured")
    parser.add_argument("--out", type=Path, help="folder for Speed.json and Speed.md (--render: that of this file)")
    parser.add_argument("--render", action="store_true", help="Speed.md and README.md's line from Speed.json")
    parser.add_argument("--compare", action="store_true", help="are they what --render gives?")
    arguments = parser.parse_args()
    if not (arguments.render or arguments.compare or arguments.counts):
        parser.error("--engine and --counts are needed, or --render, or --compare")
    return arguments


def print_scaling(programs, plan):
    """The insertion on more threads than this machine may have: by counts."""
    threads = [2, 4, 8, 16, 32, 64]
    say(f"scaling, {powered(plan.large)} points, 2 to 64 threads, counted")
    counted = programs.count([plan.large], ["Uniform", "NestedClusters"], threads)
    print(f"\nInsertion of {powered(plan.large)} points on many threads, counted in insertions")
    print(
        f"{'':16}{'threads':>8}{'work/thread':>13}{'deferred':>10}{'critical path/work':>20}"
        f"{'implied speed-up':>18}"
    )
    for c in counted:
        print(
            f"{c['distribution']:16}{c['threads']:8}{c['attempts'] / c['threads']:13.0f}"
            f"{c['deferred'] / c['inserted']:10.2%}{c['criticalPath'] / c['inserted']:20.4f}"
            f"{c['inserted'] / c['criticalPath']:18.1f}"
        )


def cgal_version():
    header = Path("/usr/include/CGAL/version.h")
    found = re.search(r"#define CGAL_VERSION (\S+)", header.read_text()) if header.exists() else None
    return f"CGAL {found[1]}" if found else "CGAL"


def as_json(row):
    names = ("section", "name", "over", "sense", "target", "unit", "samples", "first", "note")
    return {**{name: getattr(row, name) for name in names}, "good": row.good()}


def measure(programs, plan, only):
    rows = [row for section in SECTIONS for row in section(programs, plan)]
    if only:
        rows = [row for row in rows if only in f"{row.section}: {row.name}"]
    for row in rows:
        say(f"{row.section}: {row.name}")
        row.run(once=plan.quick)
    return rows


def rendered(folder):
    data = json.loads((folder / "Speed.json").read_text())
    readme = (ROOT / "README.md").read_text()
    return {
        folder / "Speed.md": report.markdown(data),
        ROOT / "README.md": report.with_line(readme, report.readme_line(data)),
    }


def main():
    arguments = parse_arguments()
    folder = arguments.out or HERE
    if arguments.render or arguments.compare:
        for path, text in rendered(folder).items():
            if arguments.render:
                path.write_text(text)
            elif path.read_text() != text:
                sys.exit(f"speed.py: {path.name} is not what Speed.json gives: speed.py --render")
        return
    programs, plan = Programs(arguments), Plan(arguments.quick)
    if arguments.scaling:
        print_scaling(programs, plan)
        return
    rows: list[Row] = measure(programs, plan, arguments.only)
    data = {
        "date": datetime.date.today().isoformat(),
        "machine": {**machine(ROOT), "cgal": cgal_version()},
        "rows": [as_json(row) for row in rows],
    }
    if arguments.out:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "Speed.json").write_text(json.dumps(data, indent=1) + "\n")
        (folder / "Speed.md").write_text(report.markdown(data))
    for title, found in report.sections(data).items():
        print(report.table(title, found))
    print("\n".join(row.line() for row in rows), flush=True)
    missing = [row.name for row in rows if row.value() is None]
    if arguments.check and missing:
        sys.exit("speed.py: not measured: " + ", ".join(missing))


if __name__ == "__main__":
    main()
