# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script with PyVista, or what else the file requirements.txt beside the script names, which is installed from
PyPI, into a venv of its own, if it is not there yet.

    with_pyvista.py <folder of the venv> <script>

The exit code is the script's; 77 if PyPI is out of reach (1 if the environment says CI=true, where it must
not be).
"""

import os
import subprocess
import sys
from pathlib import Path

SECONDS = 240


def install(folder, requirements):
    """Makes the venv unless it is complete; returns the error, or None."""
    done = folder / "requirements.txt"
    wanted = requirements.read_text(encoding="utf-8")
    if done.exists() and done.read_text(encoding="utf-8") == wanted:
        return None
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    pip = [folder / "bin" / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    commands = [
        ["/usr/bin/python3", "-m", "venv", "--clear", "--system-site-packages", folder],
        [*pip, "--no-deps", "--no-compile", "--retries", "2", "--requirement", requirements],
    ]
    for command in commands:
        try:
            outcome = subprocess.run(
                [str(word) for word in command],
                env=clean,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                check=False,
                timeout=SECONDS,
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            return str(error)
        if outcome.returncode:
            return outcome.stdout
    done.write_text(wanted, encoding="utf-8")
    return None


def main():
    folder, script = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    trouble = install(folder, script.with_name("requirements.txt"))
    if trouble:
        print("what %s needs could not be installed: %s" % (script.name, trouble))
        sys.exit(1 if os.environ.get("CI") == "true" else 77)
    sys.exit(subprocess.run([str(folder / "bin" / "python"), script], check=False).returncode)


if __name__ == "__main__":
    main()
