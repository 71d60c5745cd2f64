# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of the Python package on pairs of a Python and a VTK from PyPI, each in a venv of its own.

    pairs.py --package <wheel, or folder that holds the package> [--work <folder>] [--keep] [--list] [<pair>...]

A pair is written python3.11:vtk==9.7.2:pyvista==0.49.1; without any, all of PAIRS. One line for each: passed, FAILED,
or why it was not run (no such Python here, no such wheel on PyPI). The exit code is 1 if one failed; 77 if none was run
because PyPI is out of reach (1 if the environment says CI=true).
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
SECONDS = 600
CVISTA = "cvista[all]==9.7.0.5"  # it comes in parts
PYVISTA = "pyvista==0.49.1"
# Versions of VTK in use: pip's newest, the oldest that PyVista 0.49 takes, Debian's, and cvista, which PyVista prefers;
# by itself, the oldest.
PAIRS = tuple(
    "%s:%s:%s" % (python, vtk, pyvista)
    for python in ("python3.9", "python3.10", "python3.11", "python3.12", "python3.13", "python3.14")
    for vtk, pyvista in (
        ("vtk==9.3.1", "pyvista==0.44.2"), ("vtk==9.3.1", PYVISTA), ("vtk==9.5.2", PYVISTA), ("vtk==9.6.2", PYVISTA),
        ("vtk==9.7.2", PYVISTA), (CVISTA, PYVISTA))
    if not (python == "python3.9" and pyvista == PYVISTA)) + ("python3.9:vtk==9.1.0",)
# Each script says at its top what it tests. Those of DropIn/ name vtkmodules, the others use the VTK of the pair.
FOR_ALL = ("Class/test_settings.py", "Class/test_hashes.py", "Class/test_cases.py", "Class/test_behaviour.py",
           "Class/test_interpolation.py", "Class/test_quality.py", "Class/test_kept.py", "Class/test_pipeline.py",
           "Class/test_few_points.py", "Class/test_interrupts.py", "Class/test_layouts.py", "Class/test_transforms.py",
           "Class/test_words.py",
           "PyVista/test_accessor.py", "PyVista/test_rasters.py", "PyVista/test_refined.py",
           "PyVista/test_refusals.py", "PyVista/test_simplified.py", "DropIn/test_pyvista.py")
FOR_VTK = ("../Filters/test_filter.py", "../Filters/test_source.py", "DropIn/test_drop_in.py", "DropIn/test_callers.py",
           "DropIn/test_old_scripts.py")


class NotHere(Exception):
    """Why a pair cannot be run here."""


class OutOfReach(NotHere):
    """PyPI is."""


def called(command, environment=None, seconds=SECONDS):
    """Exit code and output; the code is 1 where it takes longer or cannot be started."""
    try:
        done = subprocess.run(
            [str(word) for word in command], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, check=False, timeout=seconds)
    except (OSError, subprocess.TimeoutExpired) as error:
        return 1, str(error)
    return done.returncode, done.stdout


def interpreter(name):
    """A Python of this version, of PATH or of pyenv, that works."""
    found = [shutil.which(name)] + sorted(str(path) for path in Path.home().glob(
        ".pyenv/versions/%s.*/bin/%s" % (name.replace("python", ""), name)))
    for path in filter(None, found):
        code, said = called([path, "-c", "import sys, venv, ensurepip; print('python%d.%d' % sys.version_info[:2])"])
        if code == 0 and said.strip() == name:
            return path
    raise NotHere("no %s here" % name)


def clean_environment(**more):
    kept = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYVISTA_VTK_BACKEND")}
    return dict(kept, PYTHONDONTWRITEBYTECODE="1", **more)


def make_venv(folder, pair, package):
    """The Python of a venv with this pair, and with the wheel, if the package is one."""
    name, *wanted = pair.split(":")
    program = interpreter(name)
    python = folder / "bin" / "python"
    stamp = folder / "pair.txt"
    if not (stamp.exists() and stamp.read_text(encoding="utf-8") == pair):
        code, said = called([program, "-m", "venv", "--clear", folder], clean_environment())
        if code:
            raise NotHere("no venv: " + said.strip().splitlines()[-1])
        install(python, ["--only-binary", ":all:", *wanted, "numpy", "tqdm"], pair)
        if wanted[0].startswith("cvista"):
            called([python, "-m", "pip", "uninstall", "--quiet", "--yes", "vtk"], clean_environment())
        stamp.write_text(pair, encoding="utf-8")
    if package.suffix == ".whl":
        install(python, ["--no-deps", "--force-reinstall", package], pair)
    return python


def install(python, what, pair):
    code, said = called(
        [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", "--retries", "2",
         *what], clean_environment())
    if code == 0:
        return
    if re.search("No matching distribution|Could not find a version", said):
        if "none)" in said and "from versions" in said and "vtk" not in said:
            raise OutOfReach("PyPI is out of reach")
        raise NotHere("PyPI has no wheels for %s" % pair)
    if re.search("[Cc]onnection|resolve|[Tt]imed out|Retrying", said):
        raise OutOfReach("PyPI is out of reach")
    raise NotHere("pip: " + said.strip().splitlines()[-1])


def suite_environment(folders, is_vtk=True):
    """The environment of the scripts, with the package in the first of the folders that has it."""
    return clean_environment(
        PYTHONPATH=os.pathsep.join(folders + [str(HERE.parent / "Filters")]),
        AHD_TEST_VTK="vtkmodules" if is_vtk else "cvista", AHD_TEST_CLASS="python")


def run_suites(python, pair, package):
    """The number of tests, and the output of those that failed."""
    is_vtk = pair.split(":")[1].startswith("vtk")
    environment = suite_environment([] if package.suffix == ".whl" else [str(package)], is_vtk)
    count, failed = 0, []
    for script in FOR_ALL + (FOR_VTK if is_vtk else ()):
        if "pyvista" in script.lower() and "pyvista" not in pair:
            continue
        found = package.suffix == ".whl" and script.startswith("PyVista/") and "pyvista==0.44" not in pair
        code, said = called([python, HERE / script, *(["found"] if found else [])], environment)
        ran = re.search(r"^Ran (\d+) test", said, re.M)
        count += int(ran.group(1)) if ran else 0
        if code or not ran or int(ran.group(1)) == 0:
            failed.append("--- %s: exit code %d\n%s" % (script, code, said))
    return count, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", type=Path, help="a wheel, or a folder that holds the package")
    parser.add_argument("--work", type=Path, default=Path("build/pairs"), help="where the venvs are made")
    parser.add_argument("--keep", action="store_true", help="keep them for the next time; about 600 MB each")
    parser.add_argument("--list", action="store_true", help="print the pairs and do nothing")
    parser.add_argument("pairs", nargs="*")
    options = parser.parse_args()
    if options.list:
        print("\n".join(PAIRS))
        return 0
    package = options.package.resolve()
    ran = broken = 0
    reached = True
    for pair in options.pairs or PAIRS:
        begun = time.monotonic()
        folder = options.work.resolve() / re.sub("[^a-z0-9.]+", "-", pair)
        try:
            count, failed = run_suites(make_venv(folder, pair, package), pair, package)
        except NotHere as error:
            reached = reached and not isinstance(error, OutOfReach)
            print("%-55s not run: %s" % (pair, error), flush=True)
            continue
        finally:
            if not options.keep:
                shutil.rmtree(folder, ignore_errors=True)
        ran += 1
        broken += bool(failed)
        print("%-55s %s, %d tests, %.0f s" % (
            pair, "FAILED" if failed else "passed", count, time.monotonic() - begun), flush=True)
        for text in failed:
            print(text, flush=True)
    if ran == 0:
        return 1 if os.environ.get("CI") == "true" or reached else 77
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
