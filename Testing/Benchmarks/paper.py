#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Repeats the experiments of Su et al., Computers & Graphics 54 (2016), section 4, and writes Results.json
and from it Results.md: Tables 2 to 6 beside the paper's own figures, ablations, and the peers.
paper.sh builds the programs and calls this.

  paper.py --program <build>/PaperExperiments [--out FOLDER] [sizes...]      measures, and renders
  paper.py --render [--out FOLDER]                                           renders only
  paper.py --compare [--out FOLDER]      fails where Results.md (or README.md's table) is not what
                                         Results.json gives
"""

import argparse
import json
import re
import subprocess
import sys
import time
from pathlib import Path

import paper_measure as measure
import paper_report as report
from paper_data import ABLATED, COLUMNS, DISTRIBUTIONS, HERE, SYSTEMS, ablations

BEGIN = time.monotonic()
README = HERE.parent.parent / "README.md"
MARKS = ("<!-- paper.py --render: begin -->", "<!-- paper.py --render: end -->")
PEERS_FAILED = "peers.py ended with"
PARTS = {"tables": DISTRIBUTIONS, "ablations": ABLATED}


def say(words):
    print(f"[{time.monotonic() - BEGIN:5.0f} s] {words}", file=sys.stderr, flush=True)


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("sizes", nargs="*", type=float, help="numbers of points (2e6 4e6 6e6 8e6 1e7)")
    parser.add_argument("--program", help="the PaperExperiments to run")
    parser.add_argument("--out", type=Path, default=HERE, help="folder of Results.* (that of this file)")
    parser.add_argument("--quick", action="store_true", help="2e5 points, 2 rounds")
    parser.add_argument("--rounds", type=int, help="measurements of each (5; ablations 9)")
    parser.add_argument("--ablation-size", type=float, help="points of the ablations (1e6)")
    parser.add_argument("--resume", action="store_true", help="keep what the same build has measured here")
    parser.add_argument("--only-peers", action="store_true", help="no tables, no ablations")
    parser.add_argument("--no-peers", action="store_true", help="no peers: those there stay")
    parser.add_argument("--peers-limit", type=float, help="seconds a peer's call may take (60; quick: 10)")
    parser.add_argument("--peers-work", help="folder for the peers' files")
    parser.add_argument("--render", action="store_true", help="Results.md from Results.json")
    parser.add_argument("--compare", action="store_true", help="is Results.md what --render gives?")
    parser.add_argument("--check", action="store_true", help="fail if a row or column is missing")
    arguments = parser.parse_intermixed_args()
    if not (arguments.render or arguments.compare or arguments.program):
        parser.error("--program is needed, or --render, or --compare")
    return arguments


class Plan:
    """The measurements: parts of (kind, points, distribution), and how often."""

    def __init__(self, arguments, about):
        quick = arguments.quick
        self.sizes = [int(n) for n in arguments.sizes] or (
            [200000] if quick else [2000000, 4000000, 6000000, 8000000, 10000000]
        )
        self.ablation_size = int(arguments.ablation_size or (200000 if quick else 1000000))
        self.rounds = {
            "tables": arguments.rounds or (2 if quick else 5),
            "ablations": arguments.rounds or (2 if quick else 9),
        }
        systems = SYSTEMS if about["cgal"] else [s for s in SYSTEMS if s != "CGAL"]
        self.configurations = {"tables": systems, "ablations": ablations()}

    def parts(self):
        for points in self.sizes:
            for distribution in PARTS["tables"]:
                yield "tables", points, distribution
        for distribution in PARTS["ablations"]:
            yield "ablations", self.ablation_size, distribution

    def is_done(self, part, data):
        """Has data all rows of this part, without faults and with as many rounds?"""
        kind = part[0]
        rows = {row["configuration"]: row for row in rows_of(part, data)}
        return all(
            name in rows
            and not rows[name]["faults"]
            and len(rows[name]["rounds"]["total"]) == self.rounds[kind]
            for name in self.configurations[kind]
        )


def rows_of(part, data):
    kind, points, distribution = part
    return [r for r in data[kind] if (r["points"], r["distribution"]) == (points, distribution)]


# --- Files -----------------------------------------------------------------------------------------


def load(folder):
    return json.loads((folder / "Results.json").read_text())


def as_json(data):
    """One row a line, so that a change to a number is a change to a line."""
    rows = {kind: ",\n".join("    " + json.dumps(row) for row in data[kind]) for kind in PARTS}
    lists = ",\n".join(
        f'  "{kind}": [\n{text}\n  ]' if text else f'  "{kind}": []' for kind, text in rows.items()
    )
    rest = {key: value for key, value in data.items() if key not in PARTS}
    return json.dumps(rest, indent=2)[:-2] + ",\n" + lists + "\n}\n"


def save(folder, data):
    """Whole or not at all: a run may be stopped at any moment."""
    folder.mkdir(parents=True, exist_ok=True)
    fresh = folder / "Results.json.new"
    fresh.write_text(as_json(data))
    fresh.replace(folder / "Results.json")


def with_table(readme, data):
    """README.md with its table, between the marks, made from the data."""
    begin, end = (re.escape(mark) for mark in MARKS)
    inside = "\n\n".join((MARKS[0], report.readme_table(data), MARKS[1]))
    return re.sub(begin + ".*?" + end, lambda _: inside, readme, flags=re.DOTALL)


def outputs(folder, data):
    """{file: text} of all that is made from the data. README.md belongs to the committed results only."""
    made = {folder / "Results.md": report.render(data)}
    if folder.resolve() == HERE:
        made[README] = with_table(README.read_text(), data)
    return made


def render(folder):
    for file, text in outputs(folder, load(folder)).items():
        file.write_text(text)
        say(f"written: {file}")


def compare(folder):
    different = [f for f, text in outputs(folder, load(folder)).items() if f.read_text() != text]
    if different:
        sys.exit("paper.py: not what --render gives: " + ", ".join(map(str, different)))


# --- Measuring -------------------------------------------------------------------------------------


def begin_data(arguments, about):
    """Empty results, or the existing ones, as far as they may be kept. The peers, which have a date of their own, stay
    unless they are measured."""
    empty = {"made": about, "failures": [], "tables": [], "ablations": []}
    if not (arguments.out / "Results.json").exists():
        return empty
    found = load(arguments.out)
    if arguments.no_peers and "peers" in found:
        empty["peers"] = found["peers"]
    if not (arguments.resume or arguments.only_peers):
        return empty
    if arguments.only_peers:
        found["failures"] = [f for f in found["failures"] if not f.startswith(PEERS_FAILED)]
        return found
    same = all(found["made"][key] == about[key] for key in ("program", "machine"))
    if not same:
        say("other programs or another machine: what was measured before is dropped")
        return empty
    return {**found, "failures": []}


def measure_part(part, plan, arguments, data):
    kind, points, distribution = part
    say(f"{kind}: {distribution}, {points} points, {plan.rounds[kind]} rounds")
    rows, failures = measure.measure(
        arguments.program,
        points,
        distribution,
        plan.configurations[kind],
        plan.rounds[kind],
        validate=points == min(plan.sizes),
    )
    old = rows_of(part, data)
    kept = [row for row in data[kind] if row not in old]
    data[kind] = sorted(kept + rows, key=lambda row: (row["points"], PARTS[kind].index(row["distribution"])))
    data["failures"] += failures
    for failure in failures:
        say(failure)


def without_words(peers):
    """The programs' other output names files of this machine: it is not published."""
    for run in peers["runs"].values():
        run.pop("said", None)
    return peers


def measure_peers(arguments, data):
    """peers.py completes the file it finds."""
    out = arguments.out / "peers.json"
    if not arguments.resume:
        out.unlink(missing_ok=True)
    elif "peers" in data and not out.exists():
        out.write_text(json.dumps(data["peers"]))
    work = arguments.peers_work or str(arguments.out / "peers")
    command = [
        sys.executable,
        str(HERE / "peers" / "peers.py"),
        "--bin",
        str(Path(arguments.program).parent),
        "--work",
        work,
        "--out",
        str(out),
    ]
    command += ["--quick"] if arguments.quick else []
    command += ["--limit", str(arguments.peers_limit)] if arguments.peers_limit else []
    say("peers")
    code = subprocess.run(command).returncode
    if code != 0:
        data["failures"].append(f"{PEERS_FAILED} {code}")
    if out.exists():
        data["peers"] = without_words(json.loads(out.read_text()))
        out.unlink()


def measure_all(arguments):
    about = measure.about(arguments.program)
    data = begin_data(arguments, {**about, "quick": arguments.quick})
    plan = Plan(arguments, about)
    for part in [] if arguments.only_peers else plan.parts():
        if arguments.resume and plan.is_done(part, data):
            continue
        measure_part(part, plan, arguments, data)
        save(arguments.out, data)
    save(arguments.out, data)
    render(arguments.out)
    if not arguments.no_peers:
        measure_peers(arguments, data)
        save(arguments.out, data)
        render(arguments.out)
    return data, plan


def missing(data, plan):
    """The checks of --check: each row, each of its columns, and that it was certified."""
    gaps = []
    for part in plan.parts():
        rows = {row["configuration"]: row for row in rows_of(part, data)}
        for name in plan.configurations[part[0]]:
            row = rows.get(name, {})
            columns = ["total"] if name == "CGAL" else COLUMNS
            lacking = [c for c in columns + ["triangles", "checked"] if not row.get(c)]
            gaps += [f"{part} {name}: {', '.join(lacking)}"] if lacking else []
    return gaps


def missing_peers(peers):
    """Every peer has run on every input, every result was judged, and ours are correct. Packages missing from PyPI are
    no fault of the programs; Debian's packages are there where the tests run."""
    gaps = [] if peers.get("inputs") else ["no peers"]
    for name, peer in peers.get("peers", {}).items():
        if "missing" in peer:
            gaps += [] if peer["kind"] == "pypi" else [f"{name}: {peer['missing']}"]
            continue
        for key in peers["inputs"]:
            record = peers["runs"].get(f"{name}|{key}", {"status": "missing"})
            verdict = record.get("verdict", {})
            judged = "right" in verdict or record["status"] not in ("ok", "missing")
            right = verdict.get("right") or not name.startswith("ours")
            gaps += [] if judged and right else [f"{name}, {key}: {record['status']}, {verdict}"]
    return gaps


def main():
    arguments = parse_arguments()
    if arguments.compare:
        return compare(arguments.out)
    if arguments.render:
        return render(arguments.out)
    data, plan = measure_all(arguments)
    wrong = list(data["failures"])
    if arguments.check:
        wrong += [] if arguments.only_peers else missing(data, plan)
        wrong += [] if arguments.no_peers else missing_peers(data.get("peers", {}))
    if wrong:
        sys.exit("paper.py: " + "\n  ".join(wrong))


if __name__ == "__main__":
    main()
