#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of peers.py: each way a peer can fail is simulated by a small program, and must be reported as such.

    test_peers.py FOLDER [unittest's options]      FOLDER: PeerInputs, PeerJudge and PeerOurs, built
"""
import contextlib
import io
import json
import os
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import catalogue
import peers
import runs

PROGRAMS = ""
FIGURES = {"cpu": 0.25, "wall": 0.5, "held": 1000, "peak": 3000, "peakBefore": 2000}
DONE = f"print('called'); print('done ' + {json.dumps(FIGURES)!r}, flush=True)\n"
CALL = "print('call', flush=True)\n"


def play(text, limit=20.0):
    """runs.run on a peer that is this Python text."""
    with tempfile.TemporaryDirectory() as folder:
        return runs.run([sys.executable, "-c", text], dict(os.environ), limit, None, folder)


class Endings(unittest.TestCase):
    """The reported end of a process."""

    def check(self, text, status, words, limit=20.0):
        record = play(text, limit)
        self.assertEqual(record["status"], status, record)
        self.assertIn(words, record["detail"])
        self.assertNotIn("wall", record)

    def test_well(self):
        record = play(CALL + DONE)
        self.assertEqual((record["status"], record["cpu"], record["wall"]), ("ok", 0.25, 0.5))
        self.assertEqual(record["callMemory"], 2000)
        self.assertGreater(record["peakMemory"], 1e6)

    def test_noise_on_stdout_is_not_heard(self):
        text = "print('calling all')\n" + CALL + "print('x' * 100000)\n" + DONE
        self.assertEqual(play(text)["status"], "ok")

    def test_exception(self):
        text = "import sys\ndef f(): raise ValueError('two points coincide')\n" + CALL + "f()"
        self.check(text, "error", "ValueError: two points coincide")

    def test_exit_code(self):
        self.check(CALL + "raise SystemExit(7)", "error", "exit code 7")

    def test_silent_end(self):
        self.check(CALL, "error", "exit code 0")

    def test_crash_in_the_call(self):
        self.check("import os\n" + CALL + "os.kill(os.getpid(), 11)", "crash", "SIGSEGV in the call")

    def test_abort_before_the_call(self):
        self.check("import os; os.abort()", "crash", "SIGABRT before the call")

    def test_crash_at_the_end(self):
        text = "import os\n" + CALL + DONE + "os.kill(os.getpid(), 11)"
        self.check(text, "crash", "SIGSEGV when it ended")

    def test_hang(self):
        begun = time.monotonic()
        self.check("import time\n" + CALL + "time.sleep(60)", "hang", "longer than 0.5 s", limit=0.5)
        self.assertLess(time.monotonic() - begun, 30)

    def test_the_limit_is_for_the_call_alone(self):
        wait = "time.sleep(1.5)\n"
        text = "import time\n" + wait + CALL + "print('called', flush=True)\n" + wait + DONE
        self.assertEqual(play(text, limit=1.2)["status"], "ok")

    def test_out_of_memory(self):
        with mock.patch.object(runs, "memory_limit", lambda: 10**9):
            self.check(CALL + "x = bytearray(10**10)", "memory", "MemoryError")

    def test_killed(self):
        self.check("import os\n" + CALL + "os.kill(os.getpid(), 9)", "memory", "killed")


class Sessions(unittest.TestCase):
    """Whole runs of peers.py, of our programs and of simulated peers."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def session(self, *more, only="ours", sizes="2000"):
        work = self.folder.name
        options = peers.arguments(["--bin", PROGRAMS, "--work", work, "--out", work + "/peers.json",
                                   "--limit", "20", "--no-install", "--only", only, "--sizes", sizes, *more])
        session = peers.Session(options)
        with contextlib.redirect_stdout(io.StringIO()):
            session.run_all()
        return json.loads(Path(work, "peers.json").read_text(encoding="utf-8"))

    def played(self, text):
        """Replaces every peer's command by this Python text; its arguments are the files."""
        def command(_places, _peer, files):
            return [sys.executable, "-c", "import sys, struct\n" + text, *files]
        return mock.patch.object(catalogue.Places, "command", command)

    def test_ours_is_certified_everywhere(self):
        data = self.session("--data", self.folder.name, only="ours,ours-threads")
        self.assertEqual(len(data["runs"]), 2 * len(catalogue.INPUTS))
        for record in data["runs"].values():
            self.assertEqual(record["status"], "ok", record)
            self.assertTrue(record["verdict"]["right"], record)
        text = peers.markdown(data)
        self.assertIn(f"{len(catalogue.INPUTS)} of {len(catalogue.INPUTS)} runs certified", text)
        self.assertIn("Nothing was wrong with any result.", text)
        self.assertNotIn(" ✗ |", text)
        self.assertNotIn("this engine", peers.summary(data))  # others only, and on one thread

    def test_real_files(self):
        text = "x,y,z\n0,0,5\n1,0,5\n0,1.5,5\n0,0,6\n"
        Path(self.folder.name, "lidar.csv").write_text(text, encoding="utf-8")
        data = self.session("--data", self.folder.name, "--inputs", "lidar.csv,soundings.csv")
        self.assertEqual(list(data["runs"]), ["ours|lidar.csv"])
        verdict = data["runs"]["ours|lidar.csv"]["verdict"]
        self.assertEqual((verdict["points"], verdict["places"], verdict["triangles"]), (4, 3, 1))

    def test_wrong_output_is_told(self):
        text = CALL + "open(sys.argv[2], 'wb').write(struct.pack('3i', 0, 1, 2))\n" + DONE
        with self.played(text):
            data = self.session("--inputs", "Uniform")
        verdict = data["runs"]["ours|Uniform|2000"]["verdict"]
        self.assertEqual((verdict["lost"], verdict["triangles"], verdict["right"]), (1997, 1, False))
        rendered = peers.markdown(data)
        self.assertIn("250 ms ✗", rendered)
        self.assertIn("1,997 points lost (99.85 %)", rendered)
        data["peers"]["other"] = data["peers"]["ours"]
        data["runs"]["other|Uniform|2000"] = data["runs"]["ours|Uniform|2000"]
        self.assertIn("| 0 of 1 |  | 99.85 % | 1.00 |", peers.summary(data))

    def test_what_is_run_again(self):
        with self.played("import time\n" + CALL + "time.sleep(9)"):
            self.session("--inputs", "Uniform", "--limit", "0.2")
        done = CALL + "open(sys.argv[2], 'wb')\n" + DONE
        with self.played(done):
            data = self.session("--inputs", "Uniform", "--limit", "0.1")
            self.assertEqual(data["runs"]["ours|Uniform|2000"]["status"], "hang", "the limit is not higher")
            data = self.session("--inputs", "Uniform")
            self.assertEqual(data["runs"]["ours|Uniform|2000"]["status"], "ok")
        with self.played("sys.exit(1)"), mock.patch.object(peers.Session, "programs", return_value="others"):
            data = self.session("--inputs", "Uniform")
        self.assertEqual(data["runs"]["ours|Uniform|2000"]["status"], "error", "built anew")

    def test_what_was_left_out_is_told(self):
        data = self.session("--inputs", "Uniform,Line", only="ours,ours-threads")
        self.assertNotIn("left out", peers.markdown(data))
        del data["runs"]["ours-threads|Line|2000"]
        self.assertIn(" 1 more were left out", peers.markdown(data))

    def test_failures_are_told(self):
        with self.played("import os\n" + CALL + "os.kill(os.getpid(), 11)"):
            data = self.session("--inputs", "Uniform", sizes="1000,2000,4000")
        states = [record["status"] for record in data["runs"].values()]
        self.assertEqual(states, ["crash", "crash", "not run"])
        rendered = peers.markdown(data)
        self.assertIn("**crash**", rendered)
        self.assertIn("crash: SIGSEGV in the call", rendered)
        self.assertIn("failed for 1,000 and for 2,000", rendered)

    def test_what_would_take_too_long_is_not_begun(self):
        slow = dict(FIGURES, cpu=3.0)
        text = CALL + "print('called')\nprint('done ' + " + repr(json.dumps(slow)) + ", flush=True)\n"
        with self.played(text + "open(sys.argv[2], 'wb')"):
            data = self.session("--inputs", "Uniform", sizes="1000,10000")
        self.assertEqual(data["runs"]["ours|Uniform|10000"]["status"], "not run")
        self.assertIn("> 20 s (3.0 s for 1,000)", peers.markdown(data))

    def test_a_hang_is_told_with_what_the_size_before_took(self):
        slow = "import os, time\nif os.path.getsize(sys.argv[1]) > 16000: time.sleep(60)\n"
        with self.played(CALL + slow + "open(sys.argv[2], 'wb')\n" + DONE):
            data = self.session("--inputs", "Uniform", "--limit", "3", sizes="1000,2000")
        self.assertEqual(data["runs"]["ours|Uniform|2000"]["status"], "hang")
        self.assertIn("over the limit (250 ms for 1,000)", peers.markdown(data))

    def test_what_is_slower_than_a_hang_is_not_begun(self):
        slow = "import os, time\nif os.path.getsize(sys.argv[1]) > 16000: time.sleep(60)\n"
        for later, status in ((0.6, "not run"), (0.1, "hang")):
            with self.subTest(later=later), self.played(CALL + slow + "open(sys.argv[2], 'wb')\n" + DONE):
                self.session("--inputs", "Uniform", "--limit", "2", "--again", sizes="1000,2000")
                self.session("--inputs", "Line", "--limit", "2", "--again", sizes="1000")
                file = Path(self.folder.name, "peers.json")
                data = json.loads(file.read_text(encoding="utf-8"))
                data["runs"]["ours|Line|1000"]["cpu"] = later  # the first input took 0.25 s
                file.write_text(json.dumps(data), encoding="utf-8")
                data = self.session("--inputs", "Line", "--limit", "2", sizes="2000")
                self.assertEqual(data["runs"]["ours|Line|2000"]["status"], status)

    def test_quick_runs_do_not_wait_twice_for_a_peer(self):
        slow = "import os, time\nif os.path.getsize(sys.argv[1]) > 16000: time.sleep(60)\n"
        with self.played(CALL + slow + "open(sys.argv[2], 'wb')\n" + DONE):
            data = self.session("--quick", "--limit", "3", sizes="10000")
        states = {key: record["status"] for key, record in data["runs"].items()}
        self.assertEqual(states, {"ours|Uniform|1000": "ok", "ours|Uniform|10000": "hang",
                                  "ours|DecimalLattice|10000": "not run", "ours|Utm|10000": "not run"})

    def test_after_a_hang_the_next_size_is_not_begun(self):
        with self.played("import time\n" + CALL + "time.sleep(60)"):
            data = self.session("--inputs", "Uniform", "--limit", "0.3", sizes="1000,2000")
        self.assertEqual([r["status"] for r in data["runs"].values()], ["hang", "not run"])
        self.assertIn("> 0.3 s", peers.markdown(data))

    def test_runs_are_not_repeated(self):
        first = self.session("--inputs", "Uniform")
        self.assertEqual(self.session("--inputs", "Uniform")["runs"], first["runs"])
        both = self.session("--inputs", "Uniform,Line")["runs"]
        self.assertEqual(both["ours|Uniform|2000"], first["runs"]["ours|Uniform|2000"])
        self.assertEqual(both["ours|Line|2000"]["status"], "ok")
        again = self.session("--inputs", "Uniform", "--again")["runs"]
        self.assertNotEqual(again["ours|Uniform|2000"], first["runs"]["ours|Uniform|2000"])

    def test_who_is_not_there_does_not_stop_the_rest(self):
        data = self.session("--inputs", "Uniform", only="ours,scipy")
        self.assertEqual(data["runs"]["scipy|Uniform|2000"]["status"], "not there")
        self.assertEqual(data["runs"]["ours|Uniform|2000"]["status"], "ok")
        self.assertIn("not there: ", peers.markdown(data))

    def test_unknown_names_are_refused(self):
        with contextlib.redirect_stderr(io.StringIO()) as said, self.assertRaises(SystemExit):
            self.session(only="nobody")
        self.assertIn("unknown: nobody", said.getvalue())


class Reports(unittest.TestCase):
    """Figures are those of the data."""

    def test_ratios_memory_and_faults(self):
        right = {"right": True, "places": 1000, "triangles": 1990, "lost": 0, "notDelaunay": 0,
                 "hullComplete": True}
        faults = dict.fromkeys(("overlaps", "degenerate", "clockwise", "invented"), 0)
        wrong = {**right, **faults, "right": False, "lost": 10, "notDelaunay": 3, "hullComplete": False,
                 "areaShare": 0.75}

        def ran(seconds, verdict):
            return {"status": "ok", "cpu": seconds, "wall": 9.0, "callMemory": 84000, "peakMemory": 5e6,
                    "verdict": verdict}

        about = {"version": "1", "licence": "", "options": "", "gives": "", "threads": False}
        data = {"settings": {"limit": 60.0, "cores": 2, "processor": "P", "pinned": True, "atATime": 1},
                "inputs": {"Uniform|1000": {"name": "Uniform", "size": 1000, "points": 1000}},
                "peers": {"ours": {**about, "title": "us"},
                          "a": {**about, "title": "slow", "version": "2", "frameShare": 0.3},
                          "b": {**about, "title": "wrong", "version": "3", "frameShare": 0.001}},
                "runs": {"ours|Uniform|1000": ran(0.0002, right), "a|Uniform|1000": ran(0.0008, right),
                         "b|Uniform|1000": ran(0.001, wrong)}}
        text = peers.markdown(data)
        self.assertIn("| us | 200 | 1.00 | 0.2 ms |", text)
        self.assertIn("| slow |  |  | (0.8 ms) |", text)
        self.assertIn("| wrong | 1000 | 5.00 | 1 ms · 5.00 ✗ |", text)
        self.assertIn("10 points lost (1 %); 3 edges not Delaunay; 25 % of the hull not covered", text)
        self.assertIn("Certified by the judge: 2.", text)
        self.assertIn("Never certified: wrong.", text)
        self.assertIn("| us | 84 | 5 |", text)
        self.assertIn("slow 30.0 %, wrong 0.1 %", text)
        self.assertIn("no measure of speed: slow.", text)
        self.assertNotIn("slow 4.00", text)
        self.assertEqual(len(peers.first_page(data, "b").splitlines()), 2)  # none of its inputs was run
        data["inputs"]["Uniform|100000"] = {"name": "Uniform", "size": 100000, "points": 100000}
        data["runs"].update({"ours|Uniform|100000": ran(0.02, right), "b|Uniform|100000": ran(1.0, wrong)})
        self.assertIn("| 100,000 uniform random points | no | 1 s | 10 | yes | 20 ms | 0 |",
                      peers.first_page(data, "b"))


if __name__ == "__main__":
    PROGRAMS = sys.argv.pop(1)
    unittest.main()
