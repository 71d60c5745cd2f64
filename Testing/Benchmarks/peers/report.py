# SPDX-License-Identifier: BSD-3-Clause
"""Renders peers.json: peers, times, faults, memory. Every figure comes from the data."""
import statistics

FAILURES = {"hang": "over the limit", "crash": "crash", "error": "gave up", "memory": "out of memory"}
OURS = "ours"


class Results:
    """peers.json, easier to ask."""

    def __init__(self, data):
        self.settings = data["settings"]
        self.peers = data["peers"]
        self.there = [name for name, about in self.peers.items() if "missing" not in about]
        self.inputs = data["inputs"]
        self.runs = data["runs"]
        self.counts = [about["points"] for about in self.inputs.values()]
        self.sizes = sorted({about["size"] for about in self.inputs.values() if about["size"]})

    def run(self, peer, key):
        """The peer's run on the input with this key, or an empty dict."""
        return self.runs.get(f"{peer}|{key}", {})

    def keys(self, size):
        """The inputs of a size, in the order in which they were run; None: the real files."""
        return [key for key, about in self.inputs.items() if about["size"] == size]

    def seconds(self, peer, key):
        """CPU time of runs on one thread, wall-clock time of the others; None where it failed."""
        run = self.run(peer, key)
        return run["wall" if self.peers[peer]["threads"] else "cpu"] if run.get("status") == "ok" else None

    def ratio(self, peer, key):
        theirs, ours = self.seconds(peer, key), self.seconds(OURS, key) if OURS in self.peers else None
        return theirs / ours if theirs is not None and ours else None

    def unoptimised(self, peer):
        return (self.peers[peer].get("frameShare") or 0.0) > 0.1

    def tried(self, peer):
        """{input: run} of the runs that were begun."""
        begun = {key: self.run(peer, key) for key in self.inputs}
        return {key: run for key, run in begun.items() if run.get("status") in ("ok", *FAILURES)}

    def certified(self, peer, key):
        return bool(self.run(peer, key).get("verdict", {}).get("right"))

    def ended(self, peer):
        return [key for key, run in self.tried(peer).items() if run["status"] == "ok"]


def markdown(data):
    """The whole section, Markdown, with its heading (of the second level)."""
    results = Results(data)
    parts = ["## The peers", "\n".join(f"- {sentence}" for sentence in sentences(results)), who(results)]
    for size in [*results.sizes, None]:
        if results.keys(size):
            parts.append(times(results, size))
    parts += [fault_summary(results), fault_details(results), memory(results)]
    return "\n\n".join(part for part in parts if part)


def summary(data):
    """A short table: for each peer how often it was correct, its speed, and its largest loss."""
    results = Results(data)
    rows = []
    for peer in results.there:
        tried = results.tried(peer)
        if peer.startswith(OURS) or results.peers[peer]["threads"] or not tried:
            continue
        right = sum(results.certified(peer, key) for key in tried)
        ratios = [ratio for ratio in (results.ratio(peer, key) for key in tried) if ratio]
        slow = results.unoptimised(peer) or not ratios
        over = sum(run["status"] == "hang" for run in tried.values())
        rows.append([results.peers[peer]["title"], f"{right} of {len(tried)}", over or "",
                     most_lost(results, peer), "" if slow else times_of(statistics.median(ratios))])
    limit = f"over {results.settings['limit']:g} s"
    told = (f"Other libraries, each on up to {len(results.inputs)} inputs of {min(results.counts):,} to "
            f"{max(results.counts):,} points, one core; certified: exactly the Delaunay triangulation, whole:")
    columns = ["", "runs certified", limit, "most points lost", "time over ours, median of all that ended"]
    return told + "\n\n" + table(columns, rows)


FIRST_PAGE = {"soundings.csv": "{:,} soundings along ship tracks", "Uniform|100000": "{:,} uniform random points",
              "OnCircle|100000": "{:,} points on a circle"}


def first_page(data, other="vtk97"):
    """The table of README.md: a peer and this engine on three inputs, as far as both were run on them."""
    results = Results(data)
    rows = []
    for key, words in FIRST_PAGE.items():
        if not (results.run(other, key).get("verdict") and results.run(OURS, key).get("verdict")):
            continue
        row = [words.format(results.inputs[key]["points"])]
        for peer in (other, OURS):
            verdict = results.run(peer, key)["verdict"]
            row += ["yes" if verdict["right"] else "no", duration(results.seconds(peer, key)), f"{verdict['lost']:,}"]
        rows.append(row)
    theirs = results.peers[other]["title"] if other in results.peers else other
    return table(["", f"{theirs}: right", "time", "points lost", "here: right", "time", "points lost"], rows)


def most_lost(results, peer):
    """The largest share of the points that a run of the peer lost, or an empty text."""
    lost = [(run["verdict"]["lost"] / run["verdict"]["places"], run["verdict"])
            for run in results.tried(peer).values() if run.get("verdict", {}).get("lost")]
    worst = max(lost, key=lambda entry: entry[0], default=None)
    return share(worst[1]["lost"], worst[1]["places"]) if worst else ""


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "/") for cell in line) + " |" for line in lines)


def duration(seconds):
    return f"{1e3 * seconds:.3g} ms" if seconds < 0.9995 else f"{seconds:.3g} s"


def times_of(ratio):
    return f"{ratio:.2f}" if ratio < 10 else f"{ratio:.1f}" if ratio < 100 else f"{ratio:,.0f}"


def share(part, whole):
    percent = 100.0 * part / whole if whole else 0.0
    return f"{percent:.2g} %" if percent < 99.5 else f"{percent:.4g} %"


def titles(results, peers):
    return "; ".join(results.peers[peer]["title"] for peer in peers)


def counted(number, thing):
    """"1 point", "2,000 points"."""
    return f"{number:,} {thing}" + ("" if number == 1 else "s")


def key_title(results, key):
    about = results.inputs[key]
    return about["name"] if about["size"] is None else f"{about['name']} {about['size']:,}"


# Sentences ----------------------------------------------------------------------------------------


def sentences(results):
    yield scope(results)
    if OURS in results.there:
        yield from ours(results)
    yield from others(results)
    yield from losses(results)
    yield from failures(results)
    yield from optimisation(results)


def scope(results):
    """The runs, and, if the settings have one, the remark on them."""
    tried = sum(len(results.tried(peer)) for peer in results.there)
    right = sum(results.certified(peer, key) for peer in results.there for key in results.tried(peer))
    settings = results.settings
    pinned = "pinned to one core" if settings["pinned"] else "not pinned to a core"
    dated = f", {settings['date']}" if "date" in settings else ""
    left = sum(not results.run(peer, key) for peer in results.there for key in results.inputs)
    left = f" {left:,} more were left out of this measurement: their cells are empty." if left else ""
    together = "" if settings["atATime"] == 1 else f", {settings['atATime']} at a time: no figure counts"
    return (f"{len(results.there)} ways to triangulate, {len(results.inputs)} inputs, {tried} runs, each in "
            f"a process of its own, {pinned} unless it has threads, the call limited to "
            f"{settings['limit']:g} s{together}. Certified by the judge: {right}.{left} "
            f"Processor: {settings['processor']}, {settings['cores']} cores{dated}."
            + (f" {settings['remark']}" if "remark" in settings else ""))


def ours(results):
    tried = results.tried(OURS)
    right = sum(results.certified(OURS, key) for key in tried)
    speeds = []
    for size in results.sizes:
        spent = [1e9 * results.seconds(OURS, key) / results.inputs[key]["points"]
                 for key in results.keys(size) if results.seconds(OURS, key)]
        if spent:
            low, high = (f"{nanoseconds:.0f}" for nanoseconds in (min(spent), max(spent)))
            speeds.append((low if low == high else f"{low} to {high}") + f" for {size:,} points")
    yield (f"This engine on one thread: {right} of {len(tried)} runs certified; nanoseconds per point, cold: "
           f"{', '.join(speeds)}.")


def others(results):
    rivals = [peer for peer in results.there if not peer.startswith("ours")]
    always = [p for p in rivals if results.ended(p) and
              all(results.certified(p, key) for key in results.tried(p))]
    if always:
        yield "Certified in every run that was begun: " + titles(results, always) + "."
    mostly = [p for p in rivals if p not in always and results.ended(p) and
              all(results.certified(p, key) for key in results.ended(p))]
    if mostly:
        yield ("Certified wherever they came to an end, but not everywhere did they: "
               + titles(results, mostly) + ".")
    spans = []
    for peer in rivals:
        found = [results.ratio(peer, key) for key in results.tried(peer) if results.certified(peer, key)]
        found = [ratio for ratio in found if ratio]
        if found and not results.unoptimised(peer) and not results.peers[peer]["threads"]:
            spans.append((statistics.median(found), min(found), max(found), peer))
    if spans:
        told = [f"{results.peers[peer]['title']} {times_of(middle)} ({times_of(low)} to {times_of(high)})"
                for middle, low, high, peer in sorted(spans)]
        yield ("Time over that of this engine, one thread each, where both results are certified, median "
               "(range): " + "; ".join(told) + ".")
    never = [p for p in rivals if results.ended(p) and
             not any(results.certified(p, key) for key in results.ended(p))]
    if never:
        yield "Never certified: " + titles(results, never) + "."


def losses(results):
    told = []
    for peer in results.there:
        verdicts = [(run["verdict"]["lost"] / run["verdict"]["places"], key)
                    for key, run in results.tried(peer).items() if "verdict" in run]
        worst, key = max(verdicts, default=(0.0, ""))
        if worst > 0:
            lost = results.run(peer, key)["verdict"]
            told.append(f"{results.peers[peer]['title']} up to {share(lost['lost'], lost['places'])} "
                        f"({key_title(results, key)})")
    if told:
        yield "Points lost without being duplicates: " + "; ".join(told) + "."


def failures(results):
    for status, words in (("crash", "Crashed"), ("memory", "Ran out of memory"), ("error", "Gave up")):
        told = []
        for peer in results.there:
            runs = results.tried(peer).items()
            where = [key_title(results, key) for key, run in runs if run["status"] == status]
            if where:
                more = f" and {len(where) - 3} more" if len(where) > 3 else ""
                told.append(f"{results.peers[peer]['title']} ({', '.join(where[:3])}{more})")
        if told:
            yield f"{words}: {'; '.join(told)}."


def optimisation(results):
    known = [p for p in results.there if results.peers[p].get("frameShare") is not None]
    libraries = list({results.peers[p]["version"]: p for p in reversed(known)}.values())[::-1]
    if not libraries:
        return
    told = [f"{results.peers[p]['title']} {100 * results.peers[p]['frameShare']:.1f} %" for p in libraries]
    slow = [peer for peer in libraries if results.unoptimised(peer)]
    verdict = (f"compiled without optimisation, so in brackets below and no measure of speed: "
               f"{titles(results, slow)}" if slow else "none was compiled without optimisation")
    yield ("Instructions of `vtkDelaunay2D::RequestData` that address the stack frame, where unoptimised "
           f"code keeps every variable: {', '.join(told)}. {verdict[0].upper() + verdict[1:]}.")


# Tables -------------------------------------------------------------------------------------------


def who(results):
    rows = []
    for peer, about in results.peers.items():
        version = about.get("version") or f"not there: {about.get('missing', '')}"
        rows.append([about["title"], version, about["licence"], about["options"], about["gives"]])
    return "### Who is compared\n\n" + table(
        ["", "version", "licence", "set", "there when the clock stops"], rows)


def times(results, size):
    keys = results.keys(size)
    rows = []
    for peer in results.there:
        if not any(results.run(peer, key) for key in keys):
            continue
        spent = [1e9 * results.seconds(peer, key) / results.inputs[key]["points"] for key in keys
                 if results.seconds(peer, key)]
        ratios = [r for r in (results.ratio(peer, key) for key in keys) if r]
        slow = results.unoptimised(peer)
        rows.append([results.peers[peer]["title"],
                     f"{statistics.median(spent):.0f}" if spent and not slow else "",
                     times_of(statistics.median(ratios)) if ratios and not slow else "",
                     *(time_cell(results, peer, key) for key in keys)])
    title = "the real files" if size is None else f"{size:,} points"
    names = [results.inputs[key]["name"] + ("" if size else f", {results.inputs[key]['points']:,}")
             for key in keys]
    note = ("Time of the call (CPU; on the wall where it has threads) and its ratio to this engine on one "
            "thread; ✗: the result is not certified. First the medians over what came to an end.")
    return f"### Time, {title}\n\n{note}\n\n" + table(["", "ns per point", "ratio", *names], rows)


def time_cell(results, peer, key):
    run = results.run(peer, key)
    status = run.get("status", "")
    if status == "hang":
        return f"> {run.get('limit', results.settings['limit']):g} s"
    if status in FAILURES:
        return "**" + FAILURES[status] + "**"
    if status != "ok":
        return run.get("detail", "") if status == "not run" else ""
    seconds, ratio = results.seconds(peer, key), results.ratio(peer, key)
    mark = "" if results.certified(peer, key) else " ✗"
    if results.unoptimised(peer):
        return f"({duration(seconds)}){mark}"
    return duration(seconds) + (f" · {times_of(ratio)}" if ratio and peer != OURS else "") + mark


def fault_summary(results):
    rows = []
    for peer in results.there:
        runs = results.tried(peer)
        if not runs:
            continue
        counts = [sum(run["status"] == status for run in runs.values()) for status in FAILURES]
        right = sum(results.certified(peer, key) for key in runs)
        wrong = len(results.ended(peer)) - right
        verdicts = [run["verdict"] for run in runs.values() if "verdict" in run]
        edges = max((v["notDelaunay"] for v in verdicts), default=0)
        hulls = sum(not v["hullComplete"] for v in verdicts)
        skipped = sum(results.run(peer, key).get("status") == "not run" for key in results.inputs)
        cells = [right, wrong, *counts, skipped, hulls]
        rows.append([results.peers[peer]["title"], len(runs), *(cell or "" for cell in cells),
                     most_lost(results, peer),
                     f"{edges:,}" if edges else ""])
    head = ["", "runs", "certified", "wrong", *FAILURES.values(), "not begun", "hull not whole",
            "most points lost", "most edges not Delaunay"]
    note = ("Numbers of runs. Wrong: it came to an end with one of the faults of the table after this. Over "
            "the limit: too slow, or hanging; what the size before took is in that table. Not begun: the "
            "time for the size before, times the ratio of the sizes, is over the limit; or the size before was "
            "over the limit, or the two sizes before failed; or another input of this size was over the limit "
            "that had taken less for the size before.")
    return f"### Faults\n\n{note}\n\n" + table(head, rows)


def fault_details(results):
    rows = []
    columns = [*results.sizes, None] if results.keys(None) else results.sizes
    for peer in results.there:
        for name in dict.fromkeys(about["name"] for about in results.inputs.values()):
            keys = {about["size"]: key for key, about in results.inputs.items() if about["name"] == name}
            cells = [fault_text(results.run(peer, keys[size])) if size in keys else "" for size in columns]
            if any(cells):
                rows.append([results.peers[peer]["title"], name, *cells])
    if not rows:
        return "Nothing was wrong with any result."
    sizes = [f"{size:,}" if size else "real file" for size in columns]
    return "What was wrong:\n\n" + table(["", "input", *sizes], rows)


def fault_text(run):
    if run.get("status") == "hang":
        before = run.get("before")
        told = f" ({duration(before['seconds'])} for {before['size']:,})" if before else ""
        return FAILURES["hang"] + told
    if run.get("status") in FAILURES:
        return f"{FAILURES[run['status']]}: {run['detail']}"
    verdict = run.get("verdict")
    if not verdict or verdict["right"]:
        return ""
    told = []
    if verdict["lost"]:
        lost = share(verdict["lost"], verdict["places"])
        told.append(counted(verdict["lost"], "point") + f" lost ({lost})")
    if verdict["notDelaunay"]:
        told.append(counted(verdict["notDelaunay"], "edge") + " not Delaunay")
    if verdict["overlaps"]:
        told.append(counted(verdict["overlaps"], "edge") + " used twice from one side")
    if verdict["degenerate"]:
        told.append(counted(verdict["degenerate"], "triangle") + " without area")
    if 0 < verdict["clockwise"] < verdict["triangles"]:
        told.append(f"{verdict['clockwise']:,} of {verdict['triangles']:,} triangles clockwise")
    if verdict["invented"]:
        told.append(counted(verdict["invented"], "triangle") + " with a corner that is no input point")
    if not verdict["hullComplete"]:
        told.append(hull_text(verdict["areaShare"]))
    if not told:
        told.append(f"{verdict['triangles']:,} triangles, not {verdict['expected']:,}")
    return "; ".join(told)


def hull_text(covered):
    if covered > 1.0:
        return f"triangles cover {100 * covered:.6g} % of the hull"
    missing = 100 * (1 - covered)
    return (f"{missing:.3g} %" if missing > 1e-4 else "a sliver") + " of the hull not covered"


def memory(results):
    rows = []
    for peer in results.there:
        cells, peaks = [], [run["peakMemory"] for run in results.tried(peer).values()]
        for size in results.sizes:
            found = [results.run(peer, key)["callMemory"] / results.inputs[key]["points"]
                     for key in results.keys(size) if results.run(peer, key).get("status") == "ok"]
            cells.append(f"{statistics.median(found):.0f}" if found else "")
        if peaks:
            rows.append([results.peers[peer]["title"], *cells, f"{max(peaks) / 1e6:,.0f}"])
    head = ["", *(f"{size:,}" for size in results.sizes), "whole process, MB"]
    note = ("Bytes per point by which the process grew at most during the call, its result included and the "
            "points it was given not; median over the inputs. Last the largest process of all runs, points, "
            "interpreter and failed runs included.")
    return f"### Memory\n\n{note}\n\n" + table(head, rows)
