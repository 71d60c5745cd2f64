#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Release wheels, each built and checked here for its system. Run by Testing/Package/wheels.sh, in its venv of tools.

    python targets.py list
    python targets.py build TARGET FOLDER [LAUNCHER]    FOLDER/dist/*.whl; LAUNCHER: of the compiler, such as ccache
"""

import glob
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import zipfile
from typing import NamedTuple

import libraries

ROOT = pathlib.Path(__file__).resolve().parents[3]
HEADERS = sorted((ROOT / "Filters/Engine/Interface").glob("ahd*.h"))


class Target(NamedTuple):
    zig: str  # as zig calls it
    system: str  # as CMake does, which calls the processor so, too
    processor: str
    platform: str  # as Python does


# By the platform tag of the wheel, which pip asks for.
TARGETS = {
    "manylinux_2_17_x86_64": Target("x86_64-linux-gnu.2.17", "Linux", "x86_64", "linux-x86_64"),
    "manylinux_2_17_aarch64": Target("aarch64-linux-gnu.2.17", "Linux", "aarch64", "linux-aarch64"),
    "win_amd64": Target("x86_64-windows-gnu", "Windows", "AMD64", "win-amd64"),
    "win_arm64": Target("aarch64-windows-gnu", "Windows", "ARM64", "win-arm64"),
    "macosx_11_0_arm64": Target("aarch64-macos.11.0", "Darwin", "arm64", "macosx-11.0-arm64"),
    "macosx_10_13_x86_64": Target("x86_64-macos.10.13", "Darwin", "x86_64", "macosx-10.13-x86_64"),
}

# As Filters/Python/_interface.py searches for it.
FILES = {
    "Linux": "libadaptivehilbertdelaunay.so",
    "Windows": "adaptivehilbertdelaunay.dll",
    "Darwin": "libadaptivehilbertdelaunay.dylib",
}
# Libraries that every system of the kind has. (For Linux auditwheel checks.)
OF_THE_SYSTEM = {
    "Windows": r"KERNEL32\.dll|api-ms-win-crt-[a-z]+-l1-1-0\.dll",  # the latter from Windows 10 on
    "Darwin": r"/usr/lib/libSystem\.B\.dylib",
}


def wrap(folder, name, *arguments):
    """A program for CMake, which needs one word, that runs zig with these. Written only where it differs: a compiler
    launcher uses its date."""
    path = folder / "bin" / name
    text = "#!/bin/sh\nexport ZIG_GLOBAL_CACHE_DIR=%s\nexec %s -m ziglang %s \"$@\"\n" % (
        shlex.quote(str(folder / "zig")), shlex.quote(sys.executable), " ".join(arguments))  # fmt: skip
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)
        path.chmod(0o755)
    return path


def make(name, folder, launcher):
    """The wheel in a folder of its own, as pip makes it."""
    target = TARGETS[name]
    settings = {
        "SYSTEM_NAME": target.system,
        "SYSTEM_PROCESSOR": target.processor,
        "C_COMPILER": wrap(folder, "cc-" + name, "cc", "-target", target.zig),
        "CXX_COMPILER": wrap(folder, "c++-" + name, "c++", "-target", target.zig),
        "AR": wrap(folder, "ar", "ar"),
        "RANLIB": wrap(folder, "ranlib", "ranlib"),
        "RC_COMPILER": wrap(folder, "rc", "rc"),
        "CXX_COMPILER_LAUNCHER": launcher,
    }
    environment = dict(os.environ, _PYTHON_HOST_PLATFORM=target.platform)
    if target.system == "Darwin":
        environment["MACOSX_DEPLOYMENT_TARGET"] = target.platform.split("-")[1]
    raw = folder / ("raw-" + name)
    shutil.rmtree(raw, ignore_errors=True)
    command = [sys.executable, "-m", "pip", "wheel", "-v", ROOT, "--no-deps", "--no-build-isolation", "-w", raw,
               "--config-settings=build-dir=%s" % (folder / ("build-" + name))]  # fmt: skip
    command += ["--config-settings=cmake.define.CMAKE_%s=%s" % setting for setting in settings.items()]
    subprocess.run(command, check=True, env=environment)
    (wheel,) = raw.glob("*.whl")
    return wheel


def check_library(name, wheel):
    target = TARGETS[name]
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(wheel) as files:
        (member,) = (file for file in files.namelist() if re.search(r"\.(so|dll|dylib)$", file))
        path = files.extract(member, folder)
        assert member == "adaptivehilbertdelaunay/" + FILES[target.system], member
        libraries.check_exports(path, HEADERS)
        others = libraries.needed(path)
        print("%s needs %s" % (member, ", ".join(sorted(others))))
        if target.system in OF_THE_SYSTEM:
            strangers = [file for file in others if not re.fullmatch(OF_THE_SYSTEM[target.system], file)]
            assert others and not strangers, strangers
        if target.system == "Darwin":
            assert libraries.least_macos(path) == target.platform.split("-")[1], libraries.least_macos(path)
        if target.system == "Darwin" and target.processor == "arm64":
            libraries.check_signature(path)


def check_name(name, wheel):
    """The tag is this target's, and pip accepts the wheel there."""
    *_, python, abi, platforms = wheel.name[: -len(".whl")].split("-")
    assert (python, abi) == ("py3", "none") and name in platforms.split("."), wheel.name  # auditwheel names several
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-m", "pip", "download", "-q", "--no-index", "--no-deps", "--only-binary=:all:",
                        "--find-links", str(wheel.parent), "--platform", name, "-d", folder,
                        wheel.name.split("-")[0]], check=True)  # fmt: skip
        assert os.listdir(folder) == [wheel.name], os.listdir(folder)


def build(name, folder, launcher=""):
    folder = pathlib.Path(folder).resolve()
    dist = folder / "dist"
    dist.mkdir(parents=True, exist_ok=True)
    for old in glob.glob("%s/*%s*.whl" % (dist, name)):
        os.remove(old)
    raw = make(name, folder, launcher)
    if TARGETS[name].system == "Linux":  # the oldest tag that fits: for another processor none can be requested
        subprocess.run([os.path.join(os.path.dirname(sys.executable), "auditwheel"), "repair", "--plat", "auto",
                        "-w", str(dist), str(raw)], check=True)  # fmt: skip
    else:
        raw.rename(dist / raw.name)
    (wheel,) = (path for path in dist.glob("*.whl") if name in path.name)
    subprocess.run([sys.executable, "-B", ROOT / "Testing/Lint/lint.py", "rounding", "--build",
                    folder / ("build-" + name)], check=True)  # fmt: skip
    check_name(name, wheel)
    check_library(name, wheel)
    print("%s, %d bytes" % (wheel, wheel.stat().st_size))


if __name__ == "__main__":
    if sys.argv[1] == "list":
        print("\n".join(TARGETS))
    else:
        build(*sys.argv[2:])
