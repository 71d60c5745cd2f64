#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts faults back that the sources had (faults.toml), one at a time, and asks whether the quick suite's sequences
(lifetimes.py --quick) find them.

    faults.py --check                       does each fit the sources?
    faults.py --work DIR [--vtk DIR] [NAME...]
                                            is each found? In a copy of the sources, with libraries that the address
                                            sanitizer watches; PYTHONPATH leads to VTK. --vtk: CMake's folder of VTK

exit code 0: yes; 1: no.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]


def load():
    return tomllib.loads((HERE / "faults.toml").read_text())["fault"]


def mutated(fault, root):
    """The files of a fault and their texts with it. ValueError if it does not fit the sources."""
    texts = {}
    for edit in fault["edits"]:
        path = pathlib.Path(root, "Filters", edit["file"])
        text = texts.get(path) or path.read_text()
        if text.count(edit["old"]) != 1:
            raise ValueError("%s: %d times in %s: %r" % (fault["name"], text.count(edit["old"]), path, edit["old"]))
        texts[path] = text.replace(edit["old"], edit["new"])
    return texts


class Workshop:
    """A copy of the sources, its package, and a build under sanitizers."""

    def __init__(self, folder, vtk):
        self.tree = folder / "tree"
        self.build = self.tree / "build" / "fuzz" / "build"  # as in fuzz.sh, so that a compiler cache has it
        if not self.tree.exists():
            for part in ("Filters", "Testing"):
                shutil.copytree(ROOT / part, self.tree / part)
            (self.tree / "Data").symlink_to(ROOT / "Data")
            shutil.copy(ROOT / "CMakeLists.txt", self.tree)
        self.package = folder / "package"
        self.package.mkdir(exist_ok=True)
        if not (self.package / "adaptivehilbertdelaunay").exists():
            (self.package / "adaptivehilbertdelaunay").symlink_to(self.tree / "Filters" / "Python")
        if not (self.build / "CMakeCache.txt").exists():
            given = ["-DVTK_DIR=" + vtk] if vtk else []
            subprocess.run(["cmake", "-S", self.tree / "Testing" / "Fuzz", "-B", self.build, "-G", "Ninja", *given],
                           env=dict(os.environ, CXX=os.environ.get("CXX", "clang++")), check=True,
                           stdout=subprocess.DEVNULL)  # fmt: skip
        self.make()

    def make(self):
        command = ["ninja", "-C", self.build, "LifetimeFuzz", "ahd_watched_c"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

    def run(self, world):
        """Exit code and output of the sequences of the quick suite."""
        watched = self.build / "watched"
        environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1",
                           PYTHONPATH="%s:%s" % (self.package, os.environ.get("PYTHONPATH", "")),
                           ADAPTIVEHILBERTDELAUNAY_LIBRARY=str(watched / "libadaptivehilbertdelaunay.so"))
        ended = subprocess.run(
            [sys.executable, HERE / "lifetimes.py", world, "--quick", "--watched", watched,
             "--program", self.build / "LifetimeFuzz"],
            env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)  # fmt: skip
        return ended.returncode, ended.stdout

    def is_found(self, fault):
        """Plants it, runs, and removes it again."""
        texts = mutated(fault, self.tree)
        before = {path: path.read_text() for path in texts}
        is_compiled = any(path.suffix != ".py" for path in texts)
        try:
            for path, text in texts.items():
                path.write_text(text)
            if is_compiled:
                self.make()
            begin = time.monotonic()
            code, said = self.run(fault["world"])
        finally:
            for path, text in before.items():
                path.write_text(text)
        steps = [line for line in said.splitlines() if "--steps" in line]
        isFound = code == 1 and bool(steps)
        print("%-14s %-10s %s, %.0f s: %s" % (
            fault["name"], fault["world"], "found" if isFound else "NOT FOUND (%d)" % code, time.monotonic() - begin,
            steps[-1].split("--steps")[-1].strip() if steps else said[-300:]), flush=True)  # fmt: skip
        return isFound


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--vtk")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    faults = [fault for fault in load() if not options.names or fault["name"] in options.names]
    if options.check or not options.work:
        for fault in faults:
            mutated(fault, ROOT)
        print("%d faults fit the sources" % len(faults))
        return 0
    options.work.mkdir(parents=True, exist_ok=True)
    workshop = Workshop(options.work.resolve(), options.vtk)
    for world in sorted({fault["world"] for fault in faults}):
        code, said = workshop.run(world)
        if code:
            print("%s fails without a fault:\n%s" % (world, said))
            return 1
    return 0 if all([workshop.is_found(fault) for fault in faults]) else 1


if __name__ == "__main__":
    sys.exit(main())
