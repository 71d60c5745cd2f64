# SPDX-License-Identifier: BSD-3-Clause
"""The report of faults at random places, in Markdown."""

import collections
import dataclasses

from report import cell


@dataclasses.dataclass
class Counts:
    planted: int
    killed: int
    equivalent: int

    @property
    def survived(self):
        return self.planted - self.killed - self.equivalent

    def share(self):
        """Of those that are not equivalent, in percent."""
        judged = self.planted - self.equivalent
        return 100 * self.killed / judged if judged else 100.0

    def said(self):
        return (
            f"{self.planted} planted, {self.killed} noticed, {self.equivalent} equivalent, {self.survived} survived: "
            f"{self.share():.1f} %"
        )


def is_equivalent(result, judged):
    return not result["test"] and judged.of(result).get("equivalent", False)


def counts(results, judged):
    killed = sum(bool(result["test"]) for result in results)
    return Counts(len(results), killed, sum(is_equivalent(result, judged) for result in results))


def place(result):
    return f"`{result['file'].rpartition('/')[2]}`, `{result['function']}`"


def change(result):
    """The lines before and after, in one cell."""
    old, new = (" ".join(result[name].split()) for name in ("old", "new"))
    if new in (";", "pass"):
        return f"`{old}` removed"
    return f"`{old}` → `{new}`"


def folder_lines(folder, runs, judged):
    """The section of a folder. `runs`: results by seed."""
    yield f"\n## {folder}\n\n| seed | planted | noticed | equivalent | survived | of those not equivalent |"
    yield "|--:|--:|--:|--:|--:|--:|"
    distinct = {}
    for seed, results in sorted(runs.items()):
        own = counts(results, judged)
        yield f"| {seed} | {own.planted} | {own.killed} | {own.equivalent} | {own.survived} | {own.share():.1f} % |"
        distinct.update((repr(sorted(result.items())), result) for result in results)
    own = counts(list(distinct.values()), judged)
    yield f"| all | {own.planted} | {own.killed} | {own.equivalent} | {own.survived} | {own.share():.1f} % |"
    by = collections.Counter(result["test"] for result in distinct.values() if result["test"])
    if by:
        first = ", ".join(f"{name} ({number})" for name, number in by.most_common(12))
        yield f"\nNoticed by {first}{', …' if len(by) > 12 else ''}."
    left = [result for result in distinct.values() if not result["test"]]
    for title, kind in (("Survived", False), ("Equivalent", True)):
        those = [result for result in left if bool(is_equivalent(result, judged)) == kind]
        if those:
            yield f"\n### {title}\n\n| where | fault | why |\n|---|---|---|"
        for result in those:
            why = judged.of(result).get("why", "not looked at")
            yield f"| {place(result)} | {cell(change(result))} | {cell(why)} |"


def markdown(campaign, judged):
    folders, dates = {}, set()
    for name, keys in campaign.runs.items():
        folder, _, seed = name.rpartition(" ")
        results = [campaign.results[key] for key in keys]
        dates |= {result["date"] for result in results}
        folders.setdefault(folder, {})[int(seed)] = results
    lines = [
        "# What the tests notice of faults at random places",
        "",
        "Written by `random_mutants.py --report`. Each fault is planted alone, and the tests of its folder run until",
        "the first that fails. What is equivalent, and why something survived, is said in `judged.toml`.",
        "",
        "- " + " to ".join(sorted(dates)[:1] + sorted(dates)[1:][-1:]),
    ]
    for folder, runs in sorted(folders.items()):
        lines += folder_lines(folder, runs, judged)
    return "\n".join(lines) + "\n"
