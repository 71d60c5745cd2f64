#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs EngineBenchmark and prints what the numbers say about the three goals for speed:

  uniform points at least 2 times as fast as CGAL,
  every distribution of the paper within 1.3 times uniform,
  4e6 points within 1.15 times the time per point of 1e6.

Nothing is asserted: time depends on the machine and on what else it does.

  speed.py <build>/EngineBenchmark [--sizes SMALL LARGE] [--all] [--repeat N] [--json FILE]
"""

import argparse
import json
import subprocess
import sys
import tempfile

PAPER = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed"]
OTHERS = ["Lattice", "DecimalLattice", "Utm", "KuzminDisc", "NestedClusters"]


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program", help="the EngineBenchmark to run")
    parser.add_argument(
        "--sizes", nargs=2, type=int, default=[1000000, 4000000], metavar=("SMALL", "LARGE"),
        help="numbers of points (default: 1000000 4000000)",
    )
    parser.add_argument("--all", action="store_true", help="also lattices, UTM and strong clusters")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each; the fastest counts")
    parser.add_argument("--json", help="also keep Google Benchmark's own report in this file")
    return parser.parse_args()


def run(program, sizes, distributions, engines, repeat):
    """Benchmarks by name, e.g. "ours/Uniform/1000000"."""
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        command = [
            program,
            "--sizes=" + ",".join(str(size) for size in sizes),
            "--distributions=" + ",".join(distributions),
            "--engines=" + ",".join(engines),
            f"--repeat={repeat}",
            f"--benchmark_out={report.name}",
            "--benchmark_out_format=json",
        ]
        print(" ".join(command), file=sys.stderr)
        if subprocess.run(command, stdout=sys.stderr).returncode != 0:
            sys.exit("speed.py: EngineBenchmark failed, see above.")
        with open(report.name) as text:
            result = json.load(text)
    benchmarks = {"/".join(b["name"].split("/")[:3]): b for b in result["benchmarks"]}
    return benchmarks, result


def number(benchmarks, name, counter):
    return benchmarks.get(name, {}).get(counter)


def shown(value, form):
    width = int(form.split(".")[0])
    return "-".rjust(width) if value is None else format(value, form + "f")


def ratio(a, b):
    return a / b if a and b else None


def print_table(benchmarks, distributions, size):
    uniform = number(benchmarks, f"ours/Uniform/{size}", "nsPerPoint")
    print(f"\n{size} points, CPU ns per point")
    print("distribution        ours    CGAL  CGAL/ours  ours/uniform     NP     NR")
    for name in distributions:
        ours = number(benchmarks, f"ours/{name}/{size}", "nsPerPoint")
        cgal = number(benchmarks, f"cgal/{name}/{size}", "nsPerPoint")
        print(
            f"{name:16}"
            f"{shown(ours, '8.1')}{shown(cgal, '8.1')}{shown(ratio(cgal, ours), '11.2')}"
            f"{shown(ratio(ours, uniform), '14.2')}"
            f"{shown(number(benchmarks, f'ours/{name}/{size}', 'NP'), '7.2')}"
            f"{shown(number(benchmarks, f'ours/{name}/{size}', 'NR'), '7.2')}"
        )


def print_goals(benchmarks, small, large):
    def per_point(engine, name, size):
        return number(benchmarks, f"{engine}/{name}/{size}", "nsPerPoint")

    uniform = per_point("ours", "Uniform", small)
    worst = max(PAPER, key=lambda name: per_point("ours", name, small))
    print("\nGoals")
    cgal = ratio(per_point("cgal", "Uniform", small), uniform)
    if cgal is not None:
        print(f"  uniform, CGAL / ours               {cgal:6.2f}   goal: at least 2")
    else:
        print("  uniform, CGAL / ours                    -   built without CGAL")
    print(
        f"  worst of the paper's / uniform     {ratio(per_point('ours', worst, small), uniform):6.2f}"
        f"   goal: at most 1.3   ({worst})"
    )
    growth = ratio(per_point("ours", "Uniform", large), uniform)
    print(f"  uniform, {large} / {small} points   {growth:6.2f}   goal: at most 1.15")


def check_triangles(benchmarks):
    """Both engines triangulate the same points: a different count means one of them is wrong."""
    for name, benchmark in benchmarks.items():
        other = number(benchmarks, name.replace("ours/", "cgal/", 1), "triangles")
        if "triangles" not in benchmark:
            sys.exit(f"speed.py: {name} gave no result: {benchmark.get('error_message')}")
        if other not in (None, benchmark["triangles"]):
            sys.exit(f"speed.py: {name}: {benchmark['triangles']} triangles, CGAL has {other}")


def main():
    arguments = parse_arguments()
    small, large = arguments.sizes
    distributions = PAPER + (OTHERS if arguments.all else [])
    benchmarks, report = run(
        arguments.program, [small], distributions, ["ours", "cgal"], arguments.repeat
    )
    more, _ = run(arguments.program, [large], ["Uniform"], ["ours"], arguments.repeat)
    benchmarks.update(more)
    check_triangles(benchmarks)
    report["benchmarks"] = list(benchmarks.values())
    if arguments.json:
        with open(arguments.json, "w") as text:
            json.dump(report, text, indent=1)
    print_table(benchmarks, distributions, small)
    print_table(benchmarks, ["Uniform"], large)
    print_goals(benchmarks, small, large)


if __name__ == "__main__":
    main()
