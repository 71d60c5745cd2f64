#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The budget of instructions: counts what the engine executes per point, phase by phase, under
valgrind's callgrind, and compares with instructions.json beside this file. Counts do not depend on
the machine or on what else it does, only on the code, the compiler and its flags.

  instructions.py <build>/InstructionCounts [--update] [--valgrind PROGRAM]
                  [--built-by COMPILER TYPE FLAGS]

exit code  0 within the budget (or written, with --update), 1 not, 77 built in another way than the
           budget is for
"""

import argparse
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

BUDGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "instructions.json")
INPUTS = [("Uniform", 100000), ("Lattice", 40000), ("NestedClusters", 40000)]
PHASES = ["read", "sort", "insert", "extract"]
SLACK = 0.03  # of the whole and of each phase,
LEAST = 2.0  # or so many instructions per point
COMPILER = re.compile(r"GNU 12\..* x86_64$")  # Debian 12's
FLAGS = ["-O3", "-DNDEBUG"]


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program", help="the InstructionCounts to run")
    parser.add_argument("--update", action="store_true", help="write the budget instead")
    parser.add_argument("--valgrind", default="valgrind", help="the valgrind to run it with")
    parser.add_argument(
        "--built-by", nargs=3, metavar=("COMPILER", "TYPE", "FLAGS"),
        help="how the program was built; nothing is judged if not as the budget wants it",
    )
    return parser.parse_args()


def obstacle(built_by):
    """Why the budget does not apply to a program built so, or None."""
    if built_by is None:
        return None
    compiler, build_type, flags = built_by
    if not COMPILER.match(compiler):
        return f"the compiler is {compiler}, not GNU 12 for x86_64"
    if build_type != "Release" or flags.split() != FLAGS:
        return f"the build is {build_type} with {flags.strip()}, not Release with {' '.join(FLAGS)}"
    return None


def dumps(folder):
    """(phase, instructions) of each file callgrind wrote."""
    for name in glob.glob(os.path.join(folder, "out*")):
        with open(name) as text:
            dump = text.read()
        trigger = re.search(r"^desc: Trigger: Client Request: (\w+)", dump, re.MULTILINE)
        cost = re.search(r"^(?:totals|summary): (\d+)", dump, re.MULTILINE)
        if trigger and cost:
            yield trigger.group(1), int(cost.group(1))


def count(valgrind, program, distribution, points):
    """Instructions per point of each phase, and in all."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            valgrind, "--tool=callgrind", f"--callgrind-out-file={folder}/out",
            program, distribution, str(points),
        ]
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if run.returncode != 0:
            sys.exit(f"instructions.py: {' '.join(command)} failed:\n{run.stdout}")
        found = dict.fromkeys(PHASES, 0.0)
        for phase, cost in dumps(folder):
            found[phase] += cost / points
    result = {phase: round(cost, 1) for phase, cost in found.items()}
    result["total"] = round(sum(found.values()), 1)
    return result


def main():
    arguments = parse_arguments()
    reason = obstacle(arguments.built_by)
    if reason:
        print(f"Skipped: {reason}.")
        sys.exit(77)
    measured = {
        f"{distribution}/{points}": count(arguments.valgrind, arguments.program, distribution, points)
        for distribution, points in INPUTS
    }
    if arguments.update:
        with open(BUDGET, "w") as text:
            json.dump(measured, text, indent=1)
            text.write("\n")
    with open(BUDGET) as text:
        budget = json.load(text)
    print("instructions per point       budget  counted")
    outside = 0
    for name, phases in measured.items():
        for phase, counted in phases.items():
            allowed = budget[name][phase]
            beyond = abs(counted - allowed) > max(LEAST, SLACK * allowed)
            outside += beyond
            print(f"{name:21}{phase:8}{allowed:8.1f} {counted:8.1f}{'  <-- outside' if beyond else ''}")
    if outside:
        sys.exit(
            f"{outside} counts are not within {SLACK:.0%} of {BUDGET}.\n"
            "If the engine got faster, or slower for a good reason, update it and commit it with the change:\n"
            f"  {sys.argv[0]} --update {arguments.program}"
        )


if __name__ == "__main__":
    main()
