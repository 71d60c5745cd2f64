#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs everybody who makes Delaunay triangulations on the same points, side by side, and judges all.

    peers.py --bin FOLDER --work FOLDER --out peers.json [--quick] [options]

Each peer runs in a process of its own, on one core, cold; the call that triangulates is timed and measured
inside the process, and its triangles are judged exactly (PeerJudge). peers.json is written after each run;
what it has is not run again, unless --again is given. The module functions markdown(data),
summary(data) and first_page(data) render it.
"""
import argparse
import concurrent.futures
import csv
import datetime
import hashlib
import json
import os
import platform
import statistics
import sys
import threading
from array import array
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import install
import runs
from catalogue import BY_NAME, INPUTS, PEERS, QUICK_INPUTS, REAL_FILES, Places
from report import first_page, markdown, summary  # noqa: F401 (for those who import this file)

FAILED = ("error", "memory", "crash")
FINAL = ("ok",) + FAILED  # runs that are not repeated when the file is completed
SHORT_SECONDS = 0.3  # a call that takes less is measured three times, of which the median counts


def arguments(given=None):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--bin", required=True, help="folder of PeerInputs, PeerJudge, PeerOurs, PeerCgal")
    parser.add_argument("--work", required=True, help="folder for the venv and for points and triangles")
    parser.add_argument("--out", required=True, help="the results, JSON")
    parser.add_argument("--quick", action="store_true", help="few points, two peers at a time: a minute")
    parser.add_argument("--sizes", help="numbers of points (1e5,1e6,1e7; quick: 2e5)")
    parser.add_argument("--limit", type=float, help="seconds a call may take (60; quick: 10)")
    parser.add_argument("--data", default=os.environ.get("AHD_DATA"),
                        help="folder with " + ", ".join(REAL_FILES) + " (default: AHD_DATA, or none)")
    parser.add_argument("--only", help="these peers only: " + ",".join(BY_NAME))
    parser.add_argument("--inputs", help="these inputs only: " + ",".join(INPUTS + REAL_FILES))
    parser.add_argument("--again", action="store_true", help="run again what the file already has")
    parser.add_argument("--vtk91", help="root in which Debian's VTK 9.1 is unpacked (default: looked for)")
    parser.add_argument("--no-install", action="store_true", help="use what is there, fetch nothing")
    options = parser.parse_args(given)
    options.sizes = [int(float(size)) for size in (options.sizes or default_sizes(options.quick)).split(",")]
    options.limit = options.limit or (10.0 if options.quick else 60.0)
    options.only = options.only.split(",") if options.only else list(BY_NAME)
    inputs = QUICK_INPUTS if options.quick else INPUTS + REAL_FILES
    options.inputs = options.inputs.split(",") if options.inputs else inputs
    unknown = set(options.only) - set(BY_NAME) | set(options.inputs) - set(INPUTS + REAL_FILES)
    if unknown:
        parser.error("unknown: " + ", ".join(sorted(unknown)))
    return options


def default_sizes(quick):
    return "2e5" if quick else "1e5,1e6,1e7"


class Session:
    """The runs of one call of this program, and the file they go to."""

    def __init__(self, options):
        self.options = options
        self.work = Path(options.work)
        self.work.mkdir(parents=True, exist_ok=True)
        self.places = Places(options.bin, self.work / "venv", options.vtk91 or self.work / "vtk91/root")
        self.lock = threading.Lock()
        self.file = Path(options.out)
        self.data = {"peers": {}, "inputs": {}, "runs": {}}
        if self.file.exists():
            self.data.update(json.loads(self.file.read_text(encoding="utf-8")))
            self.drop_other_builds()
        cores = sorted(os.sched_getaffinity(0))
        self.jobs = min(2, len(cores)) if options.quick else 1
        self.core = cores[-1] if len(cores) > 1 and self.jobs == 1 else None
        self.data["settings"] = {
            "limit": options.limit, "quick": options.quick, "sizes": options.sizes, "cores": len(cores),
            "date": datetime.date.today().isoformat(), "processor": processor(),
            "pinned": self.core is not None, "atATime": self.jobs,
            "memoryLimit": runs.memory_limit(), "programs": self.programs()}

    def programs(self):
        """A fingerprint of what was built here."""
        made = hashlib.sha256()
        for name in ("PeerOurs", "PeerCgal"):
            file = Path(self.options.bin) / name
            made.update(file.read_bytes() if file.exists() else b"")
        return made.hexdigest()[:16]

    def drop_other_builds(self):
        """Runs of programs that have been built anew since do not belong beside those to come."""
        if self.data.get("settings", {}).get("programs", self.programs()) != self.programs():
            self.data["runs"] = {key: run for key, run in self.data["runs"].items()
                                 if BY_NAME[key.split("|")[0]].kind != "program"}

    def save(self):
        draft = self.file.with_suffix(".draft")
        draft.write_text(json.dumps(self.data, indent=1), encoding="utf-8")
        draft.replace(self.file)

    def prepare(self):
        """Finds or fetches the peers, and records their versions."""
        chosen = [BY_NAME[name] for name in self.options.only]
        missing = {}
        if not self.options.no_install:
            missing = install.make_venv(self.work / "venv", {peer.package for peer in chosen} - {""})
        if any(peer.kind == "vtk91" for peer in chosen) and not self.options.vtk91:
            self.places.vtk91 = install.find_vtk91(self.work, not self.options.no_install)
        for peer in chosen:
            said = {"version": "this repository"} if peer.name.startswith("ours") else install.about(
                self.places.command(peer, ["--version"]), self.places.environment(peer))
            if "missing" in said and missing.get(peer.package):
                said["missing"] = missing[peer.package]
            library = said.pop("library", "")
            if library and "flower" not in peer.name:
                said["frameShare"] = install.frame_share(library)
            self.data["peers"][peer.name] = {"title": peer.title, "licence": peer.licence,
                                             "options": peer.options, "gives": peer.gives,
                                             "threads": peer.threads, "kind": peer.kind, **said}
        self.save()

    def points_of(self, name, size):
        """The file with an input's points; None if it is missing. Made anew each time."""
        file = self.work / "points"
        if name in REAL_FILES:
            source = Path(self.options.data or "") / name
            if not self.options.data or not source.exists():
                return None
            convert_csv(source, file)
        else:
            done = install.run([Path(self.options.bin) / "PeerInputs", name, size, file])
            if not done[0]:
                raise RuntimeError(f"PeerInputs failed: {done[1]}")
        return file

    def run_input(self, name, size, peers):
        """All peers on one input. `size` is None for real files."""
        left = [peer for peer in peers if self.wants(peer, name, size)]
        points = self.points_of(name, size) if left else None
        if points is None:
            return
        count = os.path.getsize(points) // 16
        key = name if size is None else f"{name}|{size}"
        self.data["inputs"][key] = {"name": name, "size": size, "points": count}
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            waiting = [pool.submit(self.run_peer, peer, name, size, points) for peer in left]
            for done in waiting:
                done.result()
        points.unlink()

    def key(self, peer, name, size):
        return f"{peer.name}|{name}" if size is None else f"{peer.name}|{name}|{size}"

    def wants(self, peer, name, size):
        record = self.data["runs"].get(self.key(peer, name, size))
        if self.options.again or record is None:
            return True
        if record["status"] == "hang":
            return record.get("limit", self.options.limit) < self.options.limit
        return record["status"] not in FINAL

    def run_peer(self, peer, name, size, points):
        why = self.reason_not_to(peer, name, size)
        if why:
            record = {"status": "not there" if "missing" in self.data["peers"][peer.name] else "not run",
                      "detail": why}
        else:
            record = self.measure(peer, points)
            record["limit"] = self.options.limit
            before = self.smaller(peer, name, size) if record["status"] == "hang" and size else []
            if before and before[0][1]["status"] == "ok":  # was it to be expected?
                record["before"] = {"size": before[0][0], "seconds": seconds_of(peer, before[0][1])}
        with self.lock:
            self.data["runs"][self.key(peer, name, size)] = record
            self.save()
            verdict = record.get("verdict", {})
            judged = "" if not verdict else ("right" if verdict["right"] else "WRONG")
            seconds = f"{record['wall']:.3f} s" if "wall" in record else record["detail"]
            what = f"{peer.name:26} {name:16} {size or '':>9} {record['status']:9}"
            print(what, seconds, judged, flush=True)

    def reason_not_to(self, peer, name, size):
        """Why a run is left out, or an empty text."""
        missing = self.data["peers"][peer.name].get("missing")
        if missing or size is None:
            return missing or ""
        before = self.smaller(peer, name, size)
        taken = seconds_of(peer, before[0][1]) if before else 0.0
        elsewhere = self.over_the_limit(peer, size, taken)
        if elsewhere:
            return f"> {self.options.limit:g} s for {elsewhere}"
        if not before:
            return ""
        smaller, record = before[0]
        if record["status"] == "hang":
            return f"> {self.options.limit:g} s for {smaller:,}"
        if record["status"] == "not run":
            return record["detail"]
        if taken * size / smaller > self.options.limit:
            return f"> {self.options.limit:g} s ({taken:.1f} s for {smaller:,})"
        if len(before) > 1 and all(r["status"] in FAILED for _, r in before[:2]):
            return f"failed for {before[1][0]:,} and for {smaller:,}"
        return ""

    def over_the_limit(self, peer, size, taken):
        """An input of this size that was too much for the peer, or an empty text. In a full run one that
        for the size before took less than the one in question, which took `taken`."""
        for (who, kind, count), record in self.sized_runs():
            if (who, count, record["status"]) == (peer.name, size, "hang"):
                if self.options.quick:
                    return kind
                if record.get("before", {"seconds": taken})["seconds"] < taken:
                    return f"{kind}, which took less for the size before"
        return ""

    def smaller(self, peer, name, size):
        """The peer's runs on smaller inputs of this kind, or else of any: (size, record), largest first."""
        found = {}
        for (who, kind, count), record in self.sized_runs():
            if who == peer.name and count < size and record["status"] != "not there":
                found.setdefault(kind, []).append((count, record))
        runs_of_kind = found.get(name) or next(iter(found.values()), [])
        return sorted(runs_of_kind, key=lambda entry: -entry[0])

    def sized_runs(self):
        """((peer, input, size), record) of all runs so far, those on real files left out."""
        with self.lock:
            entries = [(key.split("|"), record) for key, record in self.data["runs"].items()]
        return [((*key[:2], int(key[2])), record) for key, record in entries if len(key) == 3]

    def measure(self, peer, points):
        """Runs, judges, and if it was short runs twice more for the time."""
        made = [str(self.work / f"{peer.name}.{kind}") for kind in ("triangles", "vertices")]
        files = [str(points), *made]
        core = None if peer.threads else self.core

        def once():
            for file in made:
                Path(file).unlink(missing_ok=True)
            return runs.run(self.places.command(peer, files), self.places.environment(peer),
                            self.options.limit, core, str(self.work))

        record = once()
        if record["status"] == "ok":
            record["verdict"] = runs.judge(Path(self.options.bin) / "PeerJudge", files)
            others = [] if record["wall"] > SHORT_SECONDS or self.options.quick else [once(), once()]
            for figure in ("cpu", "wall"):
                record[figure + "s"] = [r[figure] for r in [record] + others if figure in r]
                record[figure] = statistics.median(record[figure + "s"])
        for file in made:
            Path(file).unlink(missing_ok=True)
        return record

    def run_all(self):
        """The sizes one after the other; in a quick run, one small input first shows who is too slow."""
        self.prepare()
        peers = [peer for peer in PEERS if peer.name in self.options.only]
        if self.options.quick:
            self.run_input(self.options.inputs[0], min(self.options.sizes) // 10, peers)
        for name in self.options.inputs:
            if name in REAL_FILES:
                self.run_input(name, None, peers)
        for size in sorted(self.options.sizes):
            for name in self.options.inputs:
                if name not in REAL_FILES:
                    self.run_input(name, size, peers)


def seconds_of(peer, record):
    """The time of a run: CPU time on one thread, else time on the wall; 0 if it failed."""
    return record.get("wall" if peer.threads else "cpu", 0.0)


def processor():
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
        return next(line.split(":")[1].strip() for line in text.splitlines() if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def convert_csv(source, file):
    """The first two columns of a .csv with a header, as doubles."""
    numbers = array("d")
    with open(source, newline="", encoding="utf-8") as stream:
        rows = csv.reader(stream)
        next(rows)
        for row in rows:
            numbers.extend((float(row[0]), float(row[1])))
    with open(file, "wb") as stream:
        numbers.tofile(stream)


def main():
    session = Session(arguments())
    try:
        session.run_all()
    except KeyboardInterrupt:
        sys.exit("stopped; what was measured is in " + str(session.file))


if __name__ == "__main__":
    main()
