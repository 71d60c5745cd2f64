#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The sentences of Results.md follow from any numbers."""

import argparse
import json
import tempfile
import unittest
from pathlib import Path

import paper
import paper_data as data
import paper_report as report
import paper_verdicts as verdicts


def row(points, distribution, configuration, total, **more):
    return {
        "points": points,
        "distribution": distribution,
        "configuration": configuration,
        "total": total,
        "checked": "same bytes",
        "faults": "",
        **more,
    }


def tables(times, sizes=(1000, 2000)):
    """Rows of Uniform and Line with these times per point."""
    return data.Rows(
        row(n, d, system, time * n, np=time, nr=time, grid=0.1 * n, insert=time * n)
        for n in sizes
        for d in ("Uniform", "Line", "Mixed")
        for system, time in times.items()
    )


def nmax_rows(totals):
    """The same total of each Nmax in all six cases."""
    return data.Rows(
        row(1000, d, data.by_nmax(order, nmax), total)
        for order in ("MG", "HG")
        for d in data.ABLATED
        for nmax, total in zip(data.NMAX, totals)
    )


class Numbers(unittest.TestCase):
    def test_zero_has_no_sign(self):
        self.assertEqual(data.span([-0.001, 0.001], "{:+.2f}"), "0.00")
        self.assertEqual(data.span([-0.07, 0.02], "{:+.2f}"), "-0.07 to +0.02")
        self.assertEqual(data.span([]), "-")

    def test_gain(self):
        rows = tables({"HG": 3, "CGAL": 4})
        self.assertAlmostEqual(data.gain(rows, (1000, "Line"), "HG", "CGAL"), 25)
        self.assertAlmostEqual(data.gain(rows, (1000, "Line"), "CGAL", "HG"), -100 / 3)
        self.assertIsNone(data.gain(rows, (1000, "Line"), "HG", "RG"))

    def test_exponent(self):
        rows = data.Rows(row(n, "Line", "HG", 7 * n**1.25) for n in (1000, 3000, 10000))
        self.assertAlmostEqual(data.exponent(rows, "Line", "HG"), 1.25)
        self.assertIsNone(data.exponent(data.Rows(rows.all[:1]), "Line", "HG"))

    def test_tolerance(self):
        noisy = [row(1, "Line", "HG", 100, rounds={"total": [90, 100, 110]})]
        self.assertAlmostEqual(data.tolerance(data.Rows(noisy)), 20)
        quiet = [row(1, "Line", "HG", 100, rounds={"total": [100, 100, 100]})]
        self.assertAlmostEqual(data.tolerance(data.Rows(quiet)), 1)


class Sentences(unittest.TestCase):
    def test_less_or_more(self):
        self.assertEqual(verdicts.less_or_more([3.0, 4.5]), "3.0 to 4.5 % less time")
        self.assertEqual(verdicts.less_or_more([-3.0, -4.5]), "3.0 to 4.5 % more time")
        self.assertEqual(verdicts.less_or_more([-3.0, 4.5]), "from 3.0 % more to 4.5 % less time")
        self.assertEqual(verdicts.less_or_more([]), "not measured")

    def test_nmax(self):
        def last(totals):
            return verdicts.nmax_sentences(nmax_rows(totals), 1000)[-1]

        self.assertIn("holds in all 6 cases", last([120, 110, 100, 101, 102, 130]))
        self.assertIn("holds in all 6 cases", last([100, 100, 100, 100, 100, 100]))
        contradicted = last([90, 110, 100, 101, 102, 130])
        self.assertIn("does not hold", contradicted)
        self.assertIn("10.0 % faster", contradicted)
        mixed = nmax_rows([120, 110, 100, 101, 102, 130])
        mixed.row(1000, "Line", "HG:nmax=400")["total"] = 80
        sentence = verdicts.nmax_sentences(mixed, 1000)[-1]
        self.assertIn("holds in 5 of 6 cases", sentence)
        self.assertIn("20.0 % faster (HG, Line)", sentence)

    def test_effect(self):
        rows = data.Rows(
            row(1000, d, data.by_control("one", genes), 10, insert=insert, np=np, nr=4.0)
            for d in data.ABLATED
            for genes, insert, np in (("on", 8.0, 2.0), ("off", 10.0, 2.5))
        )
        sentence = verdicts.gene_sentences(rows, 1000)[1]
        self.assertIn("insertion took 20.0 % less time (faster in all, slower in none", sentence)
        self.assertIn("NP changed by -0.50, NR changed by 0.00", sentence)
        self.assertIn("not measured", verdicts.gene_sentences(rows, 1000)[0])

    def test_claims_for_and_against(self):
        paper_tables = data.paper_rows()
        good = verdicts.claim_rows(tables({"RG": 5, "MG": 4, "HG": 3, "CGAL": 3.5}), paper_tables)
        bad = verdicts.claim_rows(tables({"RG": 3, "MG": 4, "HG": 5, "CGAL": 3.5}), paper_tables)
        for claim, _, here in good[:6]:
            self.assertTrue(here.startswith("in all 6 cases"), (claim, here))
        for claim, _, here in bad[:6]:
            self.assertTrue(here.startswith("in none of 6 cases"), (claim, here))

    def test_the_papers_own_tables(self):
        claims = {claim: theirs for claim, theirs, _ in verdicts.claim_rows(data.Rows([]), data.paper_rows())}
        self.assertIn("in all 30 cases; 9.2 to 21.0 % less time", claims["HG is faster than CGAL"])
        self.assertIn("not for Line, Cross", claims["HG has the lowest NR of RG, MG and HG"])


class PaperTables(unittest.TestCase):
    def test_every_cell(self):
        rows = data.paper_rows()
        self.assertEqual(len(rows.all), 5 * 6 * 4)
        for points, distribution in rows.cases():
            for system in ("RG", "MG", "HG"):
                found = rows.row(points, distribution, system)
                rest = found["total"] - found["grid"] - found["insert"]
                self.assertTrue(0 <= rest <= 0.035 * found["total"], found)
                self.assertTrue(3 < found["np"] < 30 and 4 < found["nr"] < 7, found)


class Report(unittest.TestCase):
    MADE = {
        "date": "2000-01-01",
        "revision": "abc+",
        "loadBefore": 0.0,
        "compiler": "c",
        "flags": "f",
        "cgal": "5",
        "quick": False,
        "machine": {
            "processor": "p",
            "virtual": False,
            "processors": 2,
            "caches": "",
            "memory": "",
            "system": "s",
            "kernel": "k",
        },
    }

    def data(self, **more):
        return {"made": self.MADE, "failures": [], "tables": [], "ablations": [], **more}

    def test_whatever_is_missing(self):
        self.assertIn("# The paper's experiments", report.render(self.data()))
        one = [row(2000000, "Line", "HG", 100.0, np=2.0)]
        text = report.render(self.data(tables=one, ablations=one, failures=["Line: crashed"]))
        self.assertIn("Line: crashed", text)
        self.assertIn("100 / 2574", text)

    def test_file_and_back(self):
        some = self.data(tables=[row(1, "Line", "HG", 1.0), row(1, "Line", "RG", 2.0)])
        self.assertEqual(json.loads(paper.as_json(some)), some)
        self.assertEqual(json.loads(paper.as_json(self.data())), self.data())

    def test_readme(self):
        some = self.data(tables=[row(10000000, "Line", s, t) for s, t in (("HG", 2.0), ("CGAL", 5.0))])
        self.assertEqual(report.render(some).count("| 2.50 / 1.14 |"), 1)
        readme = paper.README.read_text()
        self.assertEqual(paper.with_table(readme, paper.load(data.HERE)), readme)
        self.assertEqual(readme.count("soundings along ship tracks | no |"), 1)
        self.assertNotIn("soundings along", paper.with_table(readme, some))

    def test_new_peers_clear_what_was_wrong_with_the_old(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder)
            paper.save(out, self.data(failures=["peers.py ended with 1", "Line: crashed"]))
            asked = argparse.Namespace(out=out, resume=False, only_peers=True, no_peers=False)
            self.assertEqual(paper.begin_data(asked, {})["failures"], ["Line: crashed"])

    def test_peers_stay_where_they_are_not_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder)
            paper.save(out, self.data(peers={"runs": {}}))
            for no_peers in (True, False):
                asked = argparse.Namespace(out=out, resume=False, only_peers=False, no_peers=no_peers)
                self.assertEqual("peers" in paper.begin_data(asked, {}), no_peers)

    def test_what_check_finds(self):
        peers = {
            "peers": {
                "ours": {"kind": "program"},
                "far": {"kind": "pypi", "missing": "no network"},
                "near": {"kind": "vtk91"},
            },
            "inputs": {"Line|1": {}},
            "runs": {
                "ours|Line|1": {"status": "ok", "verdict": {"right": True}},
                "near|Line|1": {"status": "crash"},
            },
        }
        self.assertEqual(paper.missing_peers(peers), [])
        peers["runs"]["ours|Line|1"]["verdict"]["right"] = False
        self.assertEqual(len(paper.missing_peers(peers)), 1)
        del peers["runs"]["near|Line|1"]
        self.assertEqual(len(paper.missing_peers(peers)), 2)
        peers["peers"]["near"]["missing"] = "not unpacked"
        self.assertEqual(len(paper.missing_peers(peers)), 2)
        self.assertEqual(len(paper.missing_peers({})), 1)


if __name__ == "__main__":
    unittest.main()
