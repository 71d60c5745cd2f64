# SPDX-License-Identifier: BSD-3-Clause
"""Filters/Engine alone as a package: configured, installed, and its C library used through its .pc file.

    python3 engine_alone.py CMAKE GENERATOR BUILD CONFIG STATIC SHARED FOLDER

It would compile the same as the build, with the same commands: that is checked, and so the build's libraries (STATIC,
SHARED) are installed. Afterwards FOLDER/staged/moved holds what would be in /usr/local.
"""

import glob
import json
import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ENGINE = os.path.normpath(os.path.join(HERE, "..", "..", "Filters", "Engine"))


def compile_commands(build):
    """The compile options of each source of the engine's libraries, without output paths."""
    commands = {}
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        for entry in json.load(file):
            command, target = entry["command"], re.search(r"AdaptiveHilbertDelaunay(Engine|C)\.dir", entry["command"])
            if entry["file"].startswith(ENGINE) and target:
                commands[entry["file"]] = sorted(set(re.findall(r" (-[^o\s]\S*)", command)) - {"-Werror"})
    return commands


def check_same_commands(mine, build):
    wanted = compile_commands(build)
    assert wanted and compile_commands(mine) == wanted, "the engine is compiled otherwise than in the project"


def try_pkg_config(prefix, folder):
    """The C program of OutsideC/, compiled without CMake."""
    (file,) = glob.glob(os.path.join(prefix, "lib*", "**", "adaptivehilbertdelaunay.pc"), recursive=True)
    environment = {**os.environ, "PKG_CONFIG_PATH": os.path.dirname(file)}
    asked = ["pkg-config", "--cflags", "--libs", "adaptivehilbertdelaunay"]
    words = subprocess.check_output(asked, env=environment, text=True).split()
    program = os.path.join(folder, "OutsideC")
    subprocess.run(["cc", os.path.join(HERE, "OutsideC", "OutsideC.c"), "-o", program, *words], check=True)
    (library,) = {word[2:] for word in words if word.startswith("-L")}
    assert os.path.realpath(library).startswith(os.path.realpath(prefix)), library
    subprocess.run([program], check=True, env={**os.environ, "LD_LIBRARY_PATH": library})


def main():
    cmake, generator, build, config, static, shared, folder = sys.argv[1:]
    shutil.rmtree(folder, ignore_errors=True)
    mine, staged = os.path.join(folder, "build"), os.path.join(folder, "staged")
    subprocess.run(
        [cmake, "-S", ENGINE, "-B", mine, "-G", generator, "-DCMAKE_BUILD_TYPE=" + config], check=True,
        stdout=subprocess.DEVNULL)  # fmt: skip
    check_same_commands(mine, build)
    for library in [static, *glob.glob(re.sub(r"\.so.*", ".so*", shared))]:
        shutil.copy(library, mine, follow_symlinks=False)
    subprocess.run([sys.executable, os.path.join(HERE, "stage.py"), cmake, mine, config, "", staged], check=True)
    if shutil.which("pkg-config") and shutil.which("cc"):
        try_pkg_config(os.path.join(staged, "moved"), folder)


if __name__ == "__main__":
    main()
