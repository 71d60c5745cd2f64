# SPDX-License-Identifier: BSD-3-Clause
"""Runs a peer in a process of its own, under limits of time and memory, and returns the outcome."""
import json
import os
import re
import resource
import select
import signal
import subprocess
import time

ASIDE_SECONDS = 300  # for untimed work: imports and reading before the call, writing after it
TEXT_LENGTH = 300


def memory_limit():
    """Bytes a peer may have: nine tenths of the machine's memory."""
    return int(0.9 * os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))


def run(command, env, limit, core=None, folder="."):
    """Runs a command that speaks as PeerFiles.h says: "call", "called", "done {figures}".

    Returns a dict: `status`, which is
      ok      it ended well; the figures are there
      error   it gave up by itself; `detail` is the last thing it said
      memory  it ran out of memory
      crash   a signal ended it; `detail` names it
      hang    the call took longer than `limit` seconds
    and `processSeconds`, `peakMemory` (bytes), `said` (what stderr has, shortened).
    """
    errors = os.path.join(folder, f"stderr-{os.getpid()}-{time.monotonic_ns()}")
    begun = time.monotonic()
    with open(errors, "wb") as stderr:
        process = subprocess.Popen(command, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=stderr, preexec_fn=lambda: _prepare(core))
    try:
        reached, figures, late = _listen(process, limit)
    except BaseException:
        process.kill()
        process.wait()
        raise
    if late:
        process.kill()
    process.stdout.close()
    _, code, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(code)
    said = _said(errors)
    record = {"processSeconds": time.monotonic() - begun, "said": said,
              "peakMemory": max(1024 * usage.ru_maxrss, figures.get("peakBefore", 0))}
    record["status"], record["detail"] = _ending(process.returncode, reached, late, said, limit)
    if record["status"] == "ok":
        record.update(cpu=figures["cpu"], wall=figures["wall"],
                      callMemory=max(0, figures["peak"] - figures["held"]))
    return record


def _prepare(core):
    """In the child, before the peer begins."""
    if core is not None:
        os.sched_setaffinity(0, {core})
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (memory_limit(), memory_limit()))


def _listen(process, limit):
    """Reads to the end of the output: its last word, its figures, and whether it was late."""
    reached, figures, pending = "", {}, b""
    deadline = time.monotonic() + ASIDE_SECONDS
    while True:
        ready, _, _ = select.select([process.stdout], [], [], max(0.0, deadline - time.monotonic()))
        if not ready:
            return reached, figures, True
        chunk = os.read(process.stdout.fileno(), 65536)
        if not chunk:
            return reached, figures, False
        *lines, pending = (pending + chunk).split(b"\n")
        for line in lines:
            word, _, rest = line.decode(errors="replace").partition(" ")
            if word in ("call", "called", "done"):
                reached = word
                deadline = time.monotonic() + (limit if word == "call" else ASIDE_SECONDS)
            if word == "done":
                figures = json.loads(rest)


def _said(file):
    with open(file, "rb") as stream:
        text = stream.read(200000).decode(errors="replace")
    os.remove(file)
    return re.sub(r"\x1b\[[0-9;]*m", "", text).strip()


def last_words(said):
    """The cause of a program's end, if printed: the exception of a traceback, else the last line."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    exceptions = [line for line in lines if re.match(r"[\w.]*(Error|Exception)\b", line)]
    return (exceptions or lines or [""])[-1][:TEXT_LENGTH]


def _ending(code, reached, late, said, limit):
    last = last_words(said)
    if late:
        if reached == "call":
            return "hang", f"the call took longer than {limit:g} s and was ended"
        what = "its triangles were not written" if reached else "the call had not begun"
        return "error", f"{what} after {ASIDE_SECONDS} s"
    if re.search(r"MemoryError|bad_alloc|[Oo]ut of memory|Unable to allocate|insufficient memory", said):
        return "memory", last
    if code == -signal.SIGKILL:
        return "memory", "killed, as the system does to the largest process when memory runs out"
    if code < 0:
        when = {"": "before the call", "call": "in the call", "called": "giving its triangles"}
        return "crash", f"{signal.Signals(-code).name} {when.get(reached, 'when it ended')}"
    if code or reached != "done":
        return "error", last or f"exit code {code}"
    return "ok", ""


def judge(program, files):
    """The verdict on a peer's files (points, triangles, vertices; TriangleJudge.h), a dict."""
    present = [file for file in files if os.path.exists(file)]
    done = subprocess.run([str(program), *present], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{program} failed ({done.returncode}): {done.stderr.strip()[:TEXT_LENGTH]}")
    return json.loads(done.stdout)
