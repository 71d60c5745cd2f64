#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plants faults at random places of a folder of the product, one at a time, and sees whether its tests notice.

    random_mutants.py SEED COUNT FOLDER      e.g. 1 30 Filters/Python, or 1,2,3 for three seeds
    random_mutants.py SEED COUNT FOLDER --unexecuted    the lines of the folder where each fault would survive
    random_mutants.py --report FILE          only writes the Markdown report of all results

A fault is a comparison flipped, a bound off by one, a condition negated, a statement, an assignment to a member or a
lock removed, a constant or an operator changed, an early return, arguments swapped, `and` for `or`, an exception
swallowed. Each line that is executed is as likely as any other; the seed decides. What does not compile is drawn
again. Of the tests of that folder (parts.py) those run that execute the line, first those that are quick and noticed
most before, until the first that fails; more than three times the usual processor time, or thirty times on the clock
without waiting for a processor, is noticed too. Python is tested in a copy of a built package, C++ in a build of its
own. Results, and what each test executes, are kept in the work folder as they come: what has a result is not run
again.
judged.toml lists which faults change nothing that is promised, and why.

exit code  0 every fault was noticed but the equivalent ones; 1 not so; 2 could not run
"""

import argparse
import collections
import dataclasses
import datetime
import json
import pathlib
import sys
import tomllib
import urllib.parse

import lines
import parts
import planting
import random_report
import workshop
from mutants import ROOT
from mutate import LEAST_LIMIT, TIMES_USUAL

JUDGED = pathlib.Path(__file__).resolve().parent / "judged.toml"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("seeds", metavar="seed", nargs="?", type=lambda text: [int(word) for word in text.split(",")])
    parser.add_argument("count", nargs="?", type=int, help="so many that compile")
    parser.add_argument("folder", nargs="?", type=lambda text: text.strip("/"), help="below the project's")
    parser.add_argument("--list", action="store_true", help="only print the faults; some may not compile")
    parser.add_argument("--unexecuted", action="store_true", help="only print the lines that no test executes")
    parser.add_argument("--again", choices=["survivors", "all"], help="run these once more")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/mutations/random", help="copies and results")
    parser.add_argument("--jobs", type=int, default=2, help="compilers at a time")
    parser.add_argument("--python", default=sys.executable, help="has NumPy, and PyPI's VTK and PyVista")
    parser.add_argument("--package", default=ROOT / "build/lib", help="folder with the built package below it")
    parser.add_argument("--report", type=pathlib.Path, help="write the Markdown report of all results here")
    arguments = parser.parse_args()
    if arguments.folder is None and not arguments.report:
        parser.error("SEED COUNT FOLDER, or --report")
    return arguments


class Judged:
    """Judgements by hand, by a fault's text: whether it is equivalent, and why it is not noticed."""

    def __init__(self, path=JUDGED):
        rows = tomllib.loads(path.read_text()).get("fault", []) if path.exists() else []
        self.rows = {tuple(row[name].strip() for name in ("file", "function", "old", "new")): row for row in rows}

    def of(self, fault):
        return self.rows.get((fault["file"], fault["function"], fault["old"].strip(), fault["new"].strip()), {})


class Campaign:
    """Plants faults, and keeps the results."""

    def __init__(self, work):
        work.mkdir(parents=True, exist_ok=True)
        self.file = work / "results.json"
        kept = json.loads(self.file.read_text()) if self.file.exists() else {}
        self.results = kept.get("results", {})  # by the fault's key
        self.runs = kept.get("runs", {})  # by folder and seed: keys of faults
        self.usual = {}  # by test: seconds of processor time, and the lines of the product that it executes

    def keep(self):
        text = json.dumps({"results": self.results, "runs": self.runs}, indent=1)
        self.file.with_suffix(".new").write_text(text)
        self.file.with_suffix(".new").replace(self.file)

    def measure(self, part):
        """Runs each test without a fault, unless that is known of the same sources. Raises BuildError if one does not
        pass.
        """
        known = self.file.parent / "measured" / part.digest()
        known.mkdir(parents=True, exist_ok=True)
        for test in part.names:
            file = known / (urllib.parse.quote(test, safe="") + ".json")
            if not file.exists():
                ran, facts = part.measure(test, 3000)
                if ran.failure:
                    raise workshop.BuildError(f"{test} fails without a fault: {ran.failure}")
                file.write_text(json.dumps([ran.cpu, facts]))
                print(f"{test}: {ran.cpu:.1f} s", flush=True)
            self.usual[test] = json.loads(file.read_text())

    def order(self, part, fault):
        """The tests that can notice: those that execute the fault before those of which that is not known; in each the
        quick ones and those that noticed most first, those of hashes last.
        """
        noticed = collections.Counter(result["test"] for result in self.results.values() if result)

        def rank(test):
            cpu, facts = self.usual[test]
            return not lines.executes(facts, fault), "hash" in test.lower(), cpu / (1 + noticed[test])

        return sorted((test for test in part.names if lines.shows(self.usual[test][1], fault)), key=rank)

    def run(self, part, fault):
        """The result of a fault: `test` and `failure` are empty if it survived; None if it does not compile, or if
        nothing of its file is compiled or loaded here.
        """
        if not any(fault.file in facts["counted"] for _, facts in self.usual.values()):
            return None
        result = {**dataclasses.asdict(fault), "test": "", "failure": "", "seconds": 0.0}
        result["date"] = datetime.date.today().isoformat()
        try:
            part.plant(fault)
            order = self.order(part, fault)
            result["tests"] = len(order)
            for test in order:
                ran = part.run(test, max(LEAST_LIMIT, TIMES_USUAL * self.usual[test][0]))
                result["seconds"] = round(result["seconds"] + ran.seconds, 1)
                if ran.failure:
                    result.update(test=test, failure=ran.failure)
                    break
        except workshop.BuildError:
            return None
        finally:
            part.heal(fault)
        return result

    def run_all(self, name, count, part, faults, again):
        """Runs faults until `count` have compiled. `name`: of the run."""
        chosen = []
        for fault in faults:
            if len(chosen) == count:
                break
            key, known = fault.key(), self.results.get(fault.key(), "none")
            wanted = known == "none" or again == "all" or (again and known and not known["test"])
            if wanted:
                known = self.results[key] = self.run(part, fault)
            if known is not None:
                chosen.append(key)
            if wanted:
                self.runs[name] = max(chosen, self.runs.get(name, []), key=len)
                self.keep()
                say(len(chosen), known, fault)
        self.runs[name] = chosen
        self.keep()
        return [self.results[key] for key in chosen]


def say(number, result, fault):
    if result is None:
        print(f"   {fault.file}:{fault.line} does not compile", flush=True)
        return
    by = f"noticed by {result['test']}: {result['failure']}" if result["test"] else f"SURVIVED {result['tests']} tests"
    print(f"{number:3} {fault.file}:{fault.line} {fault.kind}: {by} ({result['seconds']} s)", flush=True)
    if not result["test"]:
        print(f"    - {fault.old.strip()}\n    + {fault.new.strip()}", flush=True)


def say_unexecuted(part, left, folder):
    for file, numbers in left.items():
        text = (part.source / file).read_text().splitlines() if file.startswith(folder + "/") else []
        for number in numbers if text else ():
            print(f"{file}:{number}: {text[number - 1].strip()}")


def plant(arguments, campaign, judged):
    """The exit code of a run."""
    if arguments.list:
        for fault, _ in zip(planting.draw(ROOT, arguments.folder, arguments.seeds[0]), range(arguments.count)):
            print(f"{fault.file}:{fault.line} {fault.function} {fault.kind}\n  - {fault.old}\n  + {fault.new}")
        return 0
    try:
        part = parts.part_for(
            arguments.folder, arguments.work, arguments.jobs, arguments.python, arguments.package)  # fmt: skip
        campaign.measure(part)
    except (workshop.BuildError, OSError) as error:
        print(error)
        return 2
    if arguments.unexecuted:
        say_unexecuted(part, lines.unexecuted(facts for _, facts in campaign.usual.values()), arguments.folder)
        return 0
    good = True
    for seed in arguments.seeds:
        name = f"{arguments.folder} {seed}"
        faults = planting.draw(part.source, arguments.folder, seed)
        results = campaign.run_all(name, arguments.count, part, faults, arguments.again)
        counts = random_report.counts(results, judged)
        print(f"{name}: {counts.said()}")
        good = good and counts.survived == 0 and counts.planted == arguments.count
    return 0 if good else 1


def main():
    arguments = parse_arguments()
    campaign, judged = Campaign(arguments.work), Judged()
    code = plant(arguments, campaign, judged) if arguments.folder else 0
    if arguments.report:
        arguments.report.write_text(random_report.markdown(campaign, judged))
    return code


if __name__ == "__main__":
    sys.exit(main())
