# SPDX-License-Identifier: BSD-3-Clause
"""random_mutants.py plants each kind of fault, finds the tests that notice it, continues after a stop, and reports."""

import argparse
import contextlib
import dataclasses
import io
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import textwrap
import unittest

import lines
import plant_cxx
import plant_python
import planting
import random_mutants
import random_report
import workshop

PYTHON = '''\
"""Not code: 1 < 2."""
from typing import TYPE_CHECKING, List

LIMIT = 3


def take(self, rows: List[int], most=LIMIT):
    """Nor this: a and b."""
    if TYPE_CHECKING:
        self.never = 4
    if most < 5 and rows:
        self.kept = list(rows)
    with self.lock:
        self.left -= 1
    for row in rows:
        if row is None:
            break
        try:
            self.put(row, most)
        except ValueError as error:
            self.error = error
    if not rows:
        raise KeyError("none of them")
    return self.left + most
'''
CXX = """\
#include <vector> // 1 < 2
namespace n
{
constexpr int kMost = 3; /* a && b */
struct Taken
{
  int left = 0;
};
int take(Taken& taken, const std::vector<int>& rows, int most)
{
  if (most < 5 && !rows.empty())
    this->Kept = rows;
  const std::lock_guard<std::mutex> lock(mutex);
  put("a < b", most); // "
  for (int row : rows)
  {
    if (row == 0)
      break;
    put(row, most);
  }
  if (rows.empty())
    throw std::length_error("none; of them");
  return taken.left + most;
}
}
"""


def planted(finder, text):
    """(kind, the line before, the line after) of all faults; the lines without blanks around."""
    found = set()
    for begin, end, new, kind, _ in finder.sites(text):
        first, last = text.rfind("\n", 0, begin) + 1, text.find("\n", end)
        found.add((kind, text[first:last].strip(), (text[first:begin] + new + text[end:last]).strip()))
    return found


class PlacesTest(unittest.TestCase):
    def test_every_kind_in_python(self):
        found = planted(plant_python, PYTHON)
        condition = "if most < 5 and rows:"
        for kind, old, new in (
            ("off by one", condition, "if most <= 5 and rows:"),
            ("comparison flipped", condition, "if most >= 5 and rows:"),
            ("and or or", condition, "if most < 5 or rows:"),
            ("condition negated", condition, "if not (most < 5 and rows):"),
            ("constant changed", condition, "if most < 6 and rows:"),
            ("constant changed", "LIMIT = 3", "LIMIT = 4"),
            ("assignment to a member removed", "self.kept = list(rows)", "pass"),
            ("lock removed", "with self.lock:", "if True:"),
            ("assignment to a member removed", "self.left -= 1", "pass"),
            ("comparison flipped", "if row is None:", "if row is not None:"),
            ("loop left", "break", "continue"),
            ("arguments swapped", "self.put(row, most)", "self.put(most, row)"),
            ("statement removed", "self.put(row, most)", "pass"),
            ("early return", "self.put(row, most)", "return None"),
            ("exception swallowed", "self.error = error", "pass"),
            ("exception swallowed", 'raise KeyError("none of them")', "pass"),
            ("operator changed", "return self.left + most", "return self.left - most"),
        ):
            self.assertIn((kind, old, new), found)
        for word in ("Not code", "Nor this", "never", "TYPE_CHECKING", "List[int]"):
            self.assertFalse([old for _, old, new in found if word in old and "most=LIMIT" not in old], word)

    def test_every_kind_in_cxx(self):
        found = planted(plant_cxx, CXX)
        condition = "if (most < 5 && !rows.empty())"
        lock = "const std::lock_guard<std::mutex> lock(mutex);"
        for kind, old, new in (
            ("off by one", condition, "if (most <= 5 && !rows.empty())"),
            ("comparison flipped", condition, "if (most >= 5 && !rows.empty())"),
            ("and or or", condition, "if (most < 5 || !rows.empty())"),
            ("condition negated", condition, "if (!(most < 5 && !rows.empty()))"),
            ("constant changed", condition, "if (most < 4 && !rows.empty())"),
            ("assignment to a member removed", "this->Kept = rows;", ";"),
            ("lock removed", lock, ";"),
            ("arguments swapped", 'put("a < b", most); // "', 'put(most, "a < b"); // "'),
            ("statement removed", "put(row, most);", ";"),
            ("early return", "put(row, most);", "return;"),
            ("loop left", "break;", "continue;"),
            ("exception swallowed", 'throw std::length_error("none; of them");', ";"),
            ("operator changed", "return taken.left + most;", "return taken.left - most;"),
            ("early return", "return taken.left + most;", "return {};"),
        ):
            self.assertIn((kind, old, new), found)
        for word in ("#include", "kMost", "int left", "namespace"):
            self.assertFalse([old for _, old, _ in found if word in old], word)

    def test_the_products_own_files_can_be_broken_and_changed_back(self):
        for file in ("Filters/Python/_input.py", "Filters/Engine/Job/OpenInput.cxx"):
            text = (random_mutants.ROOT / file).read_text()
            those = planting.faults(file, text)
            self.assertGreater(len({fault.line for fault in those}), 50)
            for fault in those[:: len(those) // 100]:
                broken = fault.apply(text)
                self.assertNotEqual(broken, text)
                self.assertEqual(broken.replace(fault.new, fault.old), text.replace(fault.new, fault.old))

    def test_what_a_seed_draws(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "part").mkdir()
        (folder / "part" / "take.py").write_text(PYTHON)
        (folder / "part" / "take.cxx").write_text(CXX)

        def drawn(seed):
            return list(planting.draw(folder, "part", seed))

        self.assertEqual(drawn(1), drawn(1))
        self.assertNotEqual(drawn(1)[:5], drawn(2)[:5])
        self.assertEqual(len({fault.key() for fault in drawn(1)}), len(drawn(1)))
        before = {fault.key() for fault in drawn(1)}
        (folder / "part" / "take.cxx").write_text("// a line above\n" + CXX)
        self.assertEqual({fault.key() for fault in drawn(1)}, before)


# The subject of the campaign: a module of a few lines, and a test of half of it.
MODULE = '''\
def half(value):
    steps = 0
    while value > 1:
        value //= 2
        steps += 1
    return steps


def unseen(value):
    return value + 1
'''
SCRIPT = '''\
import sys, unittest
sys.path.insert(0, %r)

class HalfTest(unittest.TestCase):
    def test_half(self):
        import module
        self.assertEqual([module.half(k) for k in (1, 2, 3, 8)], [0, 1, 1, 3])

unittest.main()
'''


class Part:
    """As those of parts.py, with a module below `root`; what has a comparison with >= "does not compile"."""

    names = ["HalfTest"]

    def __init__(self, root):
        self.root = root
        self.planted = []
        self.measured = 0

    def plant(self, fault):
        self.planted.append(fault.key())
        if ">= 1" in fault.new:
            raise workshop.BuildError("as told")
        (self.root / fault.file).write_text(fault.apply(MODULE))

    def heal(self, fault):
        (self.root / fault.file).write_text(MODULE)

    def run(self, _test, limit):
        assert limit >= random_mutants.LEAST_LIMIT
        return workshop.execute([sys.executable, "-B", "script.py"], self.root, 1, {})

    def measure(self, test, limit):
        self.measured += 1
        lines = {"part/module.py": [1, 2, 3]}
        return self.run(test, limit), {"executed": lines, "counted": lines}

    def digest(self):
        return "of the same sources"


class CampaignTest(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        (self.root / "part").mkdir()
        (self.root / "part" / "module.py").write_text(MODULE)
        (self.root / "script.py").write_text(SCRIPT % str(self.root / "part"))
        self.part = Part(self.root)
        self.judged = random_mutants.Judged(self.root / "judged.toml")

    def campaign(self, count, again=None):
        campaign = random_mutants.Campaign(self.root / "work")
        faults = planting.draw(self.root, "part", 1)
        with contextlib.redirect_stdout(io.StringIO()):
            campaign.measure(self.part)
            results = campaign.run_all("part 1", count, self.part, faults, again)
        return campaign, results

    def test_what_is_noticed_and_what_is_not(self):
        campaign, results = self.campaign(60)
        self.assertGreater(len(results), 15)  # all that there are
        self.assertLess(len(results), len(self.part.planted))  # some do not compile
        for result in results:
            self.assertEqual(bool(result["test"]), result["function"] == "half", result)
        failures = {result["failure"] for result in results}
        self.assertIn("test_half", failures)
        self.assertTrue([failure for failure in failures if "time limit" in failure], failures)  # for ever
        self.assertEqual((self.root / "part" / "module.py").read_text(), MODULE)
        self.check_report(campaign, results)

    def test_a_file_that_is_not_compiled_here_has_no_faults(self):
        campaign, _ = self.campaign(0)
        fault = next(planting.draw(self.root, "part", 1))
        self.assertIsNotNone(campaign.run(self.part, fault))
        other = dataclasses.replace(fault, file="part/of_another_system.py")
        self.assertIsNone(campaign.run(self.part, other))

    def test_it_goes_on_where_it_was_stopped(self):
        _, first = self.campaign(4)
        begun = len(self.part.planted)
        campaign, more = self.campaign(6)
        self.assertEqual(more[:4], first)
        self.assertEqual(len(set(self.part.planted)), len(self.part.planted))
        self.assertGreaterEqual(len(self.part.planted), begun + 2)
        self.assertEqual(self.part.measured, 1)  # the sources are those that it was measured with
        self.part.planted.clear()
        self.campaign(6, "survivors")
        self.assertEqual(len(self.part.planted), sum(not result["test"] for result in more))
        kept = json.loads((self.root / "work" / "results.json").read_text())
        self.assertEqual(len(kept["runs"]["part 1"]), 6)

    def test_those_that_execute_the_fault_run_first(self):
        campaign, _ = self.campaign(0)
        fault = next(planting.draw(self.root, "part", 1))
        here, elsewhere, both = ({fault.file: [fault.line + k for k in more]} for more in ((0,), (99,), (0, 99)))
        facts = {
            "QuickTest": ({}, {}), "OtherTest": (elsewhere, both), "HashTest": (here, here),
            "SlowTest": (here, here), "HashesOfOthers": ({}, {}),
        }  # fmt: skip
        self.part.names = list(facts)
        for test, (executed, counted) in facts.items():
            campaign.usual[test] = [9.0 if test == "SlowTest" else 0.1, {"executed": executed, "counted": counted}]
        order = ["SlowTest", "HashTest", "QuickTest", "HashesOfOthers"]
        self.assertEqual(campaign.order(self.part, fault), order)

    def check_report(self, campaign, results):
        """It has the survivors, and why."""
        left = [result for result in results if not result["test"]]
        row = '[[fault]]\nfile = "part/module.py"\nfunction = "unseen"\nold = "%s"\nnew = "%s"\n'
        text = row % (left[0]["old"].strip(), left[0]["new"].strip()) + 'equivalent = true\nwhy = "nobody | calls it"\n'
        (self.root / "judged.toml").write_text(text)
        judged = random_mutants.Judged(self.root / "judged.toml")
        counts = random_report.counts(results, judged)
        self.assertEqual((counts.equivalent, counts.survived), (1, len(left) - 1))
        lines = random_report.markdown(campaign, judged).splitlines()
        share = 100 * counts.killed / (len(results) - 1)
        self.assertIn(
            f"| 1 | {len(results)} | {counts.killed} | 1 | {len(left) - 1} | {share:.1f} % |", lines)  # fmt: skip
        self.assertEqual(sum("not looked at" in line for line in lines), len(left) - 1)
        self.assertEqual(sum("nobody \\| calls it" in line for line in lines), 1)


TWO = """\
int taken(int value)
{
  return value +
    1;
}
int unseen(int value)
{
  return value + 2;
}
int main()
{
  return taken(-1);
}
"""

TWO_IN_PYTHON = """\
def taken(value):
    return value + 1


def threaded(value):
    value += 1
    return value


def elsewhere(value):
    return value + 1


def unseen(value):
    return (
        value + 2)
"""
CALLS = """
two.taken(1)
thread = threading.Thread(target=two.threaded, args=(1,))
thread.start()
thread.join()
elsewhere = "import adaptivehilbertdelaunay.two as two; two.elsewhere(1)"
subprocess.run([sys.executable, "-c", elsewhere], check=True)
"""


@unittest.skipUnless(shutil.which("g++") and shutil.which("gcov"), "g++ and gcov count lines")
class LinesTest(unittest.TestCase):
    def test_what_a_program_executes(self):
        root = pathlib.Path(tempfile.mkdtemp()).resolve()
        self.addCleanup(shutil.rmtree, root)
        (root / "part").mkdir()
        (root / "build").mkdir()
        (root / "part" / "two.cxx").write_text(TWO)
        command = ["g++", "--coverage", "-O0", root / "part" / "two.cxx", "-o", "two"]
        subprocess.run(command, cwd=root / "build", check=True)
        executed = lines.Executed(root / "build", root, "part")
        self.assertEqual(executed.read()["executed"], {})  # nothing has run
        for _ in range(2):
            executed.forget()
            subprocess.run([root / "build" / "two"], check=True)
            facts = executed.read()
            self.assertIn(12, facts["executed"]["part/two.cxx"])
            self.assertNotIn(8, facts["executed"]["part/two.cxx"])
        self.check_faults(facts, "part/two.cxx", TWO)

    def check_faults(self, facts, file, text):
        """Those in taken() are executed, those in unseen() are not."""
        seen = {}
        for fault in planting.faults(file, text):
            seen.setdefault(fault.function, set()).add(lines.shows(facts, fault))
        self.assertEqual((seen["taken"], seen["unseen"]), ({True}, {False}))  # of two lines, too
        other = planting.Fault("part/other.cxx", "f", 3, "constant changed", "1", "2", 0)
        self.assertTrue(lines.shows(facts, other))

    def test_what_interpreters_execute(self):
        root = pathlib.Path(tempfile.mkdtemp()).resolve()
        self.addCleanup(shutil.rmtree, root)
        package = root / "adaptivehilbertdelaunay"
        package.mkdir()
        (package / "two.py").write_text(TWO_IN_PYTHON)
        shutil.copyfile(pathlib.Path(lines.__file__).with_name("tell_lines.py"), root / "sitecustomize.py")
        told = root / "told.txt"
        environment = {**os.environ, "PYTHONPATH": str(root), "AHD_TELL_LINES": str(told)}
        code = "import subprocess, sys, threading, adaptivehilbertdelaunay.two as two\n" + CALLS
        subprocess.run([sys.executable, "-c", code], env=environment, check=True)
        rows = [json.loads(row) for row in told.read_text().splitlines()]
        self.assertEqual(len(rows), 2)
        facts = lines.joined(rows)
        self.assertEqual(facts["executed"]["two.py"], [1, 2, 5, 6, 7, 10, 11, 14])
        self.check_faults(facts, "two.py", TWO_IN_PYTHON)

    def test_what_no_test_executes(self):
        one = {"executed": {"a": [1, 3]}, "counted": {"a": [1, 2, 3, 4], "b": [7], "c": [1]}}
        two = {"executed": {"a": [4], "c": [1]}, "counted": {"a": [1, 2, 3, 4], "c": [1]}}
        self.assertEqual(lines.unexecuted([one, two]), {"a": [2], "b": [7]})

    def test_what_is_counted_together(self):
        self.assertEqual(lines.group_of("Filters/Engine"), "Filters/Engine")
        self.assertEqual(lines.group_of("Filters/Engine/Job"), "Filters/Engine")
        self.assertEqual(lines.group_of("Filters/Sampling"), "Filters")


@unittest.skipUnless(os.path.exists("/proc/self/schedstat"), "the kernel tells how long threads waited")
class WaitTest(unittest.TestCase):
    def start(self, code):
        process = subprocess.Popen([sys.executable, "-c", code], start_new_session=True)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def test_what_sleeps_is_stopped(self):
        with self.assertRaises(subprocess.TimeoutExpired):
            workshop.wait(self.start("import time; time.sleep(60)"), 1.5)

    def test_what_waits_for_a_processor_is_not(self):
        """Two processes of one processor: one of both always waits."""
        one = f"import os; os.sched_setaffinity(0, [{min(os.sched_getaffinity(0))}])\n"
        busy = "import subprocess, sys, time\nwork = 'import time\\nwhile time.process_time() < 2: pass'\n"
        two = "those = [subprocess.Popen([sys.executable, '-c', work]) for _ in 'ab']\nfor that in those: that.wait()"
        self.assertEqual(workshop.wait(self.start(one + busy + two), 3), 0)


class JudgedTest(unittest.TestCase):
    def test_each_fault_of_the_list_is_one_and_has_a_reason(self):
        for key, row in random_mutants.Judged().rows.items():
            file, function, old, new = key
            path = random_mutants.ROOT / file
            self.assertTrue(row["why"] and path.exists(), key)
            those = planting.faults(file, path.read_text())
            fits = [f for f in those if (f.function, f.old.strip(), f.new.strip()) == (function, old, new)]
            self.assertTrue(fits, textwrap.shorten(f"not in the sources any more: {key}", 400))


class CallTest(unittest.TestCase):
    def test_what_is_said_of_a_folder_without_tests(self):
        arguments = argparse.Namespace(folder="Data", work=pathlib.Path("nowhere"), jobs=1, python="", package="")
        with self.assertRaises(workshop.BuildError):
            random_mutants.parts.part_for(arguments.folder, arguments.work, 1, "", "")

    def test_faults_of_each_folder_are_found(self):
        for folder in ("Filters/Python", *(begin.rstrip("/") for begin in random_mutants.parts.TESTS)):
            files = planting.files_of(random_mutants.ROOT, folder)
            found = (planting.faults(file, (random_mutants.ROOT / file).read_text()) for file in files)
            self.assertTrue(any(found), folder)


if __name__ == "__main__":
    unittest.main()
