# SPDX-License-Identifier: BSD-3-Clause
"""The sitecustomize.py of the interpreters that run tests: says which lines of the package they execute.

At its end each appends a line of JSON to the file that AHD_TELL_LINES names: by file, the lines that were executed and
all that can be. Without that variable it does nothing.
"""

import atexit
import json
import os
import sys
import threading

PLACE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "adaptivehilbertdelaunay", "")
EXECUTED, COUNTED = {}, {}


def count(code):
    COUNTED.setdefault(code.co_filename, set()).update(line for _, _, line in code.co_lines() if line)
    for const in code.co_consts:
        if hasattr(const, "co_lines"):
            count(const)


def trace(frame, _event, _argument):
    file = frame.f_code.co_filename
    if not file.startswith(PLACE):
        return None
    if frame.f_code.co_name == "<module>":
        count(frame.f_code)
    executed = EXECUTED.setdefault(file, set())
    executed.add(frame.f_lineno or 1)

    def follow(inner, _event, _argument):
        executed.add(inner.f_lineno)
        return follow

    return follow


def tell(told):
    sys.settrace(None)
    text = json.dumps({
        "executed": {file[len(PLACE):]: sorted(lines) for file, lines in EXECUTED.copy().items()},
        "counted": {file[len(PLACE):]: sorted(lines) for file, lines in COUNTED.copy().items()}})  # fmt: skip
    with open(told, "a") as out:
        out.write(text + "\n")


if os.environ.get("AHD_TELL_LINES"):
    atexit.register(tell, os.environ["AHD_TELL_LINES"])
    threading.settrace(trace)
    sys.settrace(trace)
