# SPDX-License-Identifier: BSD-3-Clause
"""Gets the peers: PyPI's in a venv, Debian's VTK 9.1 unpacked. Missing ones are reported, not fatal."""
import json
import os
import re
import subprocess
from pathlib import Path

from catalogue import HERE

ROOT = HERE.parents[2]
PIP_SECONDS = 600


def run(command, **options):
    """Runs; returns (success, the last line printed)."""
    try:
        done = subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, **options)
    except (OSError, subprocess.TimeoutExpired) as error:
        return False, str(error)
    lines = [line for line in done.stdout.splitlines() if line.strip()]
    telling = [line for line in lines if "error" in line.lower()]
    return done.returncode == 0, (telling or lines or [""])[-1].strip()[:300]


def requirements():
    """{package: its line in requirements.txt}."""
    lines = (HERE / "requirements.txt").read_text(encoding="utf-8").splitlines()
    wanted = [line.strip() for line in lines if line.strip() and not line.startswith("#")]
    return {line.split("==")[0]: line for line in wanted}


def make_venv(folder, packages):
    """A venv with these packages of requirements.txt; {package: why it is missing}."""
    folder = Path(folder)
    python = folder / "bin" / "python"
    if not python.exists():
        worked, why = run(["/usr/bin/python3", "-m", "venv", folder])
        if not worked:
            return {package: f"no venv (Debian: python3-venv): {why}" for package in packages}
    done = subprocess.run([str(python), "-m", "pip", "list", "--format=freeze"], text=True,
                          stdout=subprocess.PIPE, check=False).stdout.lower().split()
    missing = {}
    for package, line in requirements().items():
        if line.lower() in done or (package != "numpy" and package not in packages):
            continue
        print(f"installing {line}", flush=True)
        worked, why = run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check",
                           "--retries", "1", line], timeout=PIP_SECONDS)
        if not worked:
            missing[package] = why
    return missing


def find_vtk91(work, fetch):
    """Where Debian's VTK 9.1 is unpacked, as Testing/test.sh does it; if nowhere, fetched into `work`."""
    build = Path(os.environ.get("AHD_BUILD_DIR", ROOT / "build"))
    fetched = Path(work) / "vtk91" / "root"
    for root in (build / "vtk91" / "root", ROOT / "build" / "vtk91" / "root", fetched):
        if list(root.glob("usr/lib/*/libvtkFiltersCore-9.1.so.1")):
            return root
    if not fetch:
        return fetched
    archives = fetched.parent / "archives"
    archives.mkdir(parents=True, exist_ok=True)
    print("fetching Debian's VTK 9.1", flush=True)
    run(["apt-get", "-q", "-o", "APT::Sandbox::User=root", "download", "libvtk9.1", "python3-vtk9"],
        cwd=archives, timeout=PIP_SECONDS)
    for archive in archives.glob("*.deb"):
        run(["dpkg", "-x", archive, fetched])
        archive.unlink()
    return fetched


def about(command, env):
    """A peer's output for --version: a dict with `version`, or with `missing`, the reason."""
    try:
        done = subprocess.run(command, env=env, text=True, capture_output=True, timeout=120, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        return {"missing": str(error)}
    answer = done.stdout.strip()
    if done.returncode or not answer:
        said = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
        return {"missing": said[-1][:300]}
    return json.loads(answer) if answer.startswith("{") else {"version": answer}


def frame_share(library):
    """How much of vtkDelaunay2D::RequestData's code goes through the frame pointer, 0 to 1, or None.

    A compiler that optimises hardly uses it; one that does not keeps every variable there.
    """
    symbol = "_ZN13vtkDelaunay2D11RequestDataEP14vtkInformationPP20vtkInformationVectorS3_"
    try:
        table = subprocess.run(["nm", "-DS", library], text=True, capture_output=True, check=True).stdout
        found = re.search(rf"^([0-9a-f]+) ([0-9a-f]+) T {symbol}$", table, re.MULTILINE)
        if not found:
            return None
        start, size = (int(number, 16) for number in found.groups())
        code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", f"--start-address={start}",
                               f"--stop-address={start + size}", library],
                              text=True, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return None
    lines = [line for line in code.splitlines() if re.match(r"\s+[0-9a-f]+:\t", line)]
    return sum("(%rbp)" in line for line in lines) / len(lines) if lines else None
