# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server: starts the server, runs ClientScript.py against it, reads what both print.

    RunClientServer.py RANKS COMMAND...    the command that starts the server, e.g. mpiexec -n 2 pvserver

Run by plain Python: an mpiexec started from pvpython, which is an MPI process itself, does not work.
"""

import os
import re
import subprocess
import sys
import time

from pluginsupport import check_equal, outputs_of_ranks, run, scratch


def read_log():
    """The server's output, one rank after the other."""
    with open(scratch("server.log"), errors="replace") as log:
        return "\n".join([log.read()] + outputs_of_ranks())


def start_server(command):
    """Starts a server on a port of its choice and waits until it listens there. Returns both."""
    outputs_of_ranks(forget=True)
    with open(scratch("server.log"), "w") as log:
        server = subprocess.Popen(
            command + ["--dr", "--server-port=0", "--hostname=localhost"],
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
        )
    for _ in range(600):
        listening = re.search(r"Accepting connection.*:(\d+)", read_log())
        if listening:
            return server, listening.group(1)
        if server.poll() is not None:
            break
        time.sleep(0.1)
    stop_server(server)
    raise AssertionError("the server ended, or did not listen after a minute:\n" + read_log())


def stop_server(server):
    """A server ends when its client leaves; one that does not is killed."""
    for make_it_end in (lambda: None, server.terminate, server.kill):
        make_it_end()
        try:
            return server.wait(10)
        except subprocess.TimeoutExpired:
            pass
    raise AssertionError("the server does not end")


def main(ranks, command):
    server, port = start_server(command)
    try:
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "ClientScript.py")
        status, client_log = run([os.environ["AHD_PVPYTHON"], "--dr", script, port])
    finally:
        ended = stop_server(server)
        print(read_log())
    check_equal(status, 0, "exit status of the client")
    check_equal(ended, 0, "exit status of the server")

    for where, printed in (("client", client_log), ("server", read_log())):
        warnings = [line for line in printed.splitlines() if "triangulates its own points" in line]
        check_equal(len(warnings), 1 if ranks > 1 else 0, "warnings about %d ranks printed by the %s" % (ranks, where))
        # CountWork and others; the plugin in Python works on each rank alone
        warnings = [line for line in printed.splitlines() if "is computed on one rank" in line]
        one_does_all = ranks > 1 and not os.environ["AHD_PLUGIN"].endswith(".py")
        check_equal(len(warnings), int(one_does_all), "warnings of %d ranks about one, by the %s" % (ranks, where))
    print("passed: client and server")


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2:])
