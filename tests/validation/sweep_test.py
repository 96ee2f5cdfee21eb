#!/usr/bin/env python3
"""`thalweg sweep` on a small case: combinations, repeats, resuming, runs that fail, wrong input: sweep_test.py THALWEG FOLDER"""

import csv
import shutil
import sys
import unittest
import xml.etree.ElementTree

import small_case

thalweg, scratch = small_case.arguments(sys.argv)
FALLING = small_case.CASE.replace('to = ["0.2 m", "0.1 m"]', 'to = ["0.1 m", "0.1 m"]')


class Sweep(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.out = self.folder / "out"
        self.tank = small_case.write(self.folder / "tank", case=FALLING)

    def sweep(self, *options):
        return small_case.call(thalweg, "sweep", self.tank, "-o", self.out, *options)

    def rows(self):
        lines = [line for line in (self.out / "sweep.csv").read_text().splitlines() if not line.startswith("#")]
        return list(csv.DictReader(lines))

    def test_all_combinations_with_repeats_go_on_where_they_were(self):
        options = ("--vary", "numerics.spacing=20,14.2857,10mm", "--vary", "model.wall_friction=none,smooth", "--repeats", "2",
                   "--measure", "front", "--measure", "history.csv:kinetic_energy:largest")
        result = self.sweep(*options)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        rows = self.rows()
        self.assertEqual(len(rows), 3 * 2 * 2)
        self.assertEqual({row["numerics.spacing [mm]"] for row in rows}, {"20", "14.2857", "10"})
        self.assertEqual([row["spacing [m]"] for row in rows if row["numerics.spacing [mm]"] == "10"], ["0.01"] * 4)
        equal = [float(row["front [m]"]) for row in rows if row["numerics.spacing [mm]"] == "10" and row["model.wall_friction"] == "none"]
        self.assertNotEqual(equal[0], equal[1], "repeats have the same start")
        self.assertAlmostEqual(equal[0], equal[1], delta=0.02)
        page = (self.out / "sweep.md").read_text()
        self.assertIn("## Convergence in the spacing", page)
        self.assertIn("| front | model.wall_friction none | 10, 14.2857, 20 |", page)
        for picture in ("front.svg", "history.csv_kinetic_energy_largest.svg"):
            xml.etree.ElementTree.parse(self.out / picture)

        summaries = {file: file.stat().st_mtime_ns for file in self.out.glob("runs/*/summary.csv")}
        self.assertEqual(len(summaries), 12)
        lost = next(iter(summaries))
        shutil.rmtree(lost.parent)
        again = self.sweep(*options, "--resume")
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        self.assertIn("12 runs, 11 of them finished", again.stdout)
        changed = [file for file, time in summaries.items() if file.stat().st_mtime_ns != time]
        self.assertEqual(changed, [lost])
        self.assertEqual([row["front [m]"] for row in self.rows()], [row["front [m]"] for row in rows])

    def test_a_run_that_fails_is_a_row_with_its_reason(self):
        result = self.sweep("--vary", "numerics.maximum_speed=0.02,1.5 m/s", "--set", 'output.end="1 s"', "--measure", "front")
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        soft, stiff = self.rows()
        self.assertEqual((soft["state"], soft["front [m]"], stiff["state"]), ("failed", "", "finished"))
        self.assertTrue(soft["note"])
        self.assertIn("FAILED: maximum_speed 0.02 m/s", result.stderr)
        self.assertIn("front", (self.out / "sweep.md").read_text())


class WrongInput(unittest.TestCase):
    def refused(self, *options, case=FALLING):
        folder = scratch / self.id().rsplit(".", 1)[-1]
        tank, out = small_case.write(folder / "tank", case=case), folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        error = small_case.error_of(small_case.call(thalweg, "sweep", tank, "-o", out, *options), self)
        self.assertFalse(out.exists(), "something ran")
        return error

    def test_one_wrong_value_among_right_ones(self):
        self.assertIn("spacing -5 mm", self.refused("--vary", "numerics.spacing=20,10,-5mm"))

    def test_key_that_is_unknown(self):
        self.assertIn("spacng", self.refused("--vary", "numerics.spacng=20,10mm"))

    def test_no_values(self):
        self.assertIn("KEY=VALUE", self.refused("--vary", "numerics.spacing"))

    def test_value_twice(self):
        self.assertIn("twice", self.refused("--vary", "numerics.spacing=10,10mm"))

    def test_key_twice(self):
        self.assertIn("twice", self.refused("--vary", "numerics.spacing=10,20mm", "--vary", "numerics.spacing=5,8mm"))

    def test_too_many_runs(self):
        self.assertIn("1000", self.refused("--vary", "numerics.spacing=10,20mm", "--repeats", "900"))

    def test_statistic_that_is_unknown(self):
        self.assertIn("mean", self.refused("--vary", "numerics.spacing=10,20mm", "--measure", "history.csv:kinetic_energy:meen"))

    def test_no_runs(self):
        self.assertIn("--repeats", self.refused("--vary", "numerics.spacing=10,20mm", "--repeats", "0"))

    def test_case_that_is_no_toml(self):
        self.assertIn("case.toml:2", self.refused("--vary", "numerics.spacing=10,20mm", case="[case]\nname = = 1\n"))

    def test_case_that_is_absent(self):
        error = small_case.error_of(small_case.call(thalweg, "sweep", scratch / "nowhere", "--vary", "numerics.spacing=10,20mm"), self)
        self.assertIn("case.toml", error)


if __name__ == "__main__":
    unittest.main()
