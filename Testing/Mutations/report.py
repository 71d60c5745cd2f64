# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run, in Markdown."""

import collections
import pathlib
import subprocess

UNDECIDED = pathlib.Path(__file__).resolve().parent / "mutants" / "Undecided.md"
KINDS = ("caught", "equivalent", "survived", "not built", "caught though listed as equivalent")


def kind_of(mutant, result):
    """One of KINDS."""
    if "error" in result:
        return "not built"
    if result["test"]:
        return "caught though listed as equivalent" if mutant.equivalent else "caught"
    return "equivalent" if mutant.equivalent else "survived"


def is_as_listed(mutant, result):
    return kind_of(mutant, result) in ("caught", "equivalent")


def cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def rows(mutants, results):
    folder = None
    for mutant in mutants:
        result = results[mutant.name]
        kind = kind_of(mutant, result)
        outside = "the door" if mutant.is_of_engine else "the public classes"
        own = mutant.file.rpartition("/")[0] or outside
        if own != folder:
            folder = own
            yield f"\n## {folder}\n\n| mutant | file | what it breaks | caught by | seconds of test |"
            yield "|---|---|---|---|--:|"
        by = f"`{result['test']}`: {result['failure']}" if result["test"] else kind
        if kind == "equivalent":
            by = "equivalent: " + mutant.equivalent
        name = mutant.file.rpartition("/")[2]
        yield f"| {mutant.name} | {name} | {cell(mutant.breaks)} | {cell(by)} | {result['seconds']:.1f} |"


def markdown(mutants, results, usual, listed):
    compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True).stdout.splitlines()
    kinds = collections.Counter(kind_of(mutant, results[mutant.name]) for mutant in mutants)
    dates = sorted({results[mutant.name]["date"] for mutant in mutants})
    hashes = sum("Hash" in results[mutant.name]["test"] for mutant in mutants)
    plain = [seconds for test, seconds in usual.items() if not test.startswith(("asan:", "tsan:"))]
    when = " to ".join(dates[:1] + dates[1:][-1:])
    counts = ", ".join(f"{kinds[kind]} {kind}" for kind in KINDS if kinds[kind] or kind in KINDS[:3])
    number = f"{len(mutants)}" + (f" of the {listed} listed" if len(mutants) != listed else "")
    lines = [
        "# What the tests notice",
        "",
        "Written by `mutate.py --report` from the list in `mutants/`. Each mutant breaks the engine, or the VTK",
        "layer, in one place; its tests run until the first that fails: those hinted at in the list, then all",
        "others, and last those that compare hashes. Seconds are those of a machine that did other things besides.",
        "",
        f"- {when}; {compiler[0] if compiler else 'compiler unknown'}; -O1.",
        f"- Without a mutant the {len(plain)} test programs pass, in {sum(plain):.0f} s of processor time.",
        f"- {number} mutants: **{counts}**.",
        f"- Noticed by a hash of the results only: {hashes}.",
    ]
    undecided = UNDECIDED.read_text() if UNDECIDED.exists() else ""
    return "\n".join(lines + list(rows(mutants, results))) + "\n" + undecided
