#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks the engine and the VTK layer on purpose, in one way after the other, and sees whether tests notice.

The ways are listed in mutants/*.toml. Each is applied to a copy of the sources, below the work folder;
the test programs of what it breaks are built and run until the first test that fails: those hinted at first,
then all others, the shortest first, and last those that compare hashes of results, so that a test which
says what is wrong is named where there is one. The VTK layer is tested by FilterTests, FaultsCancel and
FaultsMemory, with ParaView's VTK. For mutants listed as equivalent the tests hinted at have
to do. What was found is kept in the work folder; a mutant that has a result is not run again, unless --again
is given.

exit code  0 every mutant was caught, but for those listed as equivalent; 1 not so; 2 could not run
"""

import argparse
import datetime
import json
import pathlib
import subprocess
import sys

import mutants
import report
import workshop

LEAST_LIMIT = 6  # seconds of processor time
TIMES_USUAL = 3
SANITIZED_LIMIT = 300
SUITE_LIMIT = 40  # the longest suite of the filter takes a tenth


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("names", nargs="*", help="mutants to run (default: all)")
    parser.add_argument("--check", action="store_true", help="only see whether the list fits the sources")
    parser.add_argument("--list", action="store_true", help="only print the names")
    parser.add_argument("--work", default="build/mutations", help="folder for copy, builds and results")
    parser.add_argument("--again", action="store_true", help="run also those that have a result")
    parser.add_argument("--only-hints", action="store_true", help="run hinted tests only, keep what they caught")
    parser.add_argument("--jobs", type=int, default=2, help="compilers at a time")
    parser.add_argument("--report", help="write the Markdown report of all results here")
    return parser.parse_args()


class Campaign:
    """Runs mutants, and keeps the results."""

    def __init__(self, work, jobs):
        self.shop = workshop.Workshop(work, jobs)
        self.file = pathlib.Path(work) / "results.json"
        kept = json.loads(self.file.read_text()) if self.file.exists() else {}
        self.results = kept.get("mutants", {})
        self.usual = kept.get("usual", {})  # seconds of processor time of each test program

    def keep(self):
        self.file.write_text(json.dumps({"mutants": self.results, "usual": self.usual}, indent=1))

    def measure(self, tests):
        """Runs each test on the unchanged engine. Raises BuildError if one does not build or pass."""
        for test in tests:
            if test not in self.usual:
                run = self.shop.run(test, self.shop.build(test), 3000)
                if run.failure:
                    raise workshop.BuildError(f"{test} fails without a mutant: {run.failure}")
                self.usual[test] = round(run.cpu, 2)
                print(f"{test}: {run.cpu:.1f} s", flush=True)
                self.keep()

    def order(self, mutant, only_hints):
        if not mutant.is_of_engine:
            hinted = [f"{mutants.FILTER}:{name}" for name in mutant.hints]
            rest = [test for test in self.shop.tests(of_engine=False) if test not in hinted]
            return hinted if only_hints or mutant.equivalent else hinted + rest
        hinted = [test for test in mutant.hints if test.rpartition(":")[2] in self.shop.tests()]
        if only_hints or mutant.equivalent:
            return hinted
        others = [test for test in self.shop.tests() if test not in hinted]
        return hinted + sorted(others, key=lambda test: ("Hash" in test, self.usual[test]))

    def limit(self, test):
        if test in self.usual:
            return max(LEAST_LIMIT, TIMES_USUAL * self.usual[test])
        return SUITE_LIMIT if test.startswith(mutants.FILTER + ":") else SANITIZED_LIMIT

    def is_known(self, mutant):
        known = self.results.get(mutant.name)
        return known is not None and known["fingerprint"] == mutant.fingerprint()

    def run(self, mutant, only_hints=False):
        """The result of one mutant; the copy is as before afterwards."""
        path = mutant.path(self.shop.source)
        original = path.read_bytes()
        result = {"fingerprint": mutant.fingerprint(), "test": "", "failure": "", "seconds": 0.0}
        try:
            path.write_text(mutant.apply(original.decode()))
            for test in self.order(mutant, only_hints):
                run = self.shop.run(test, self.shop.build(test), self.limit(test))
                result["seconds"] = round(result["seconds"] + run.seconds, 1)
                if run.failure:
                    result.update(test=test, failure=run.failure)
                    break
        except workshop.BuildError as error:
            result["error"] = str(error)
        finally:
            path.write_bytes(original)
        if not only_hints or result["test"] or mutant.equivalent:
            result["date"] = datetime.date.today().isoformat()
            self.results[mutant.name] = result
            self.keep()
        return result


def say(mutant, result):
    if "error" in result:
        text = "DOES NOT BUILD\n" + result["error"]
    elif result["test"]:
        wrong = ", BUT IS LISTED AS EQUIVALENT" if mutant.equivalent else ""
        text = f"caught by {result['test']}: {result['failure']}{wrong}"
    else:
        text = "equivalent, as listed" if mutant.equivalent else "SURVIVED"
    print(f"{mutant.name}: {text} ({result['seconds']} s)", flush=True)


def main():
    arguments = parse_arguments()
    try:
        listed = mutants.load()
    except mutants.ListError as error:
        print(error)
        return 2
    complaints = mutants.check(listed)
    if unknown := set(arguments.names) - {mutant.name for mutant in listed}:
        complaints.append("no such mutant: " + ", ".join(sorted(unknown)))
    if complaints or arguments.check or arguments.list:
        names = [mutant.name for mutant in listed] if arguments.list else []
        print("\n".join(complaints + names or [f"{len(listed)} mutants apply."]))
        return 2 if complaints else 0
    try:
        campaign = Campaign(arguments.work, arguments.jobs)
        wanted = [m for m in listed if not arguments.names or m.name in arguments.names]
        for of_engine in sorted({m.is_of_engine for m in wanted}, reverse=True):
            campaign.measure(campaign.shop.tests(of_engine))
    except (workshop.BuildError, subprocess.CalledProcessError) as error:
        print(error)
        return 2
    for mutant in listed:
        is_wanted = not arguments.names or mutant.name in arguments.names
        if is_wanted and (arguments.again or not campaign.is_known(mutant)):
            say(mutant, campaign.run(mutant, arguments.only_hints))
    known = [mutant for mutant in listed if campaign.is_known(mutant)]
    if arguments.report:
        text = report.markdown(known, campaign.results, campaign.usual, len(listed))
        pathlib.Path(arguments.report).write_text(text)
    bad = [m.name for m in known if not report.is_as_listed(m, campaign.results[m.name])]
    print(f"{len(known)} of {len(listed)} mutants have a result; not as listed: {', '.join(bad) or 'none'}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
