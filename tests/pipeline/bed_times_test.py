#!/usr/bin/env python3
"""Profiles at times of a bed that is a surface, against measured ones: bed_times_test.py THALWEG FOLDER"""

import csv
import pathlib
import shutil
import sys
import unittest

import coarse_louvain as case

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))
ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / "tests" / "solver" / "program" / "surface_bed" / "hump.toml"


class BedTimes(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        (self.folder / "reference").mkdir(parents=True)

    def done(self, *words, status=0):
        ended = case.call([str(word) for word in (thalweg, *words)])
        self.assertEqual(ended.returncode, status, ended.stderr)
        return ended.stdout + ended.stderr

    def solved(self, end, times):
        listed = ", ".join(f'"{time} s"' for time in times)
        text = SCENE.read_text() + f'\n[compare]\nbed_times = [{listed}]\nreferences = ["reference"]\n'
        (self.folder / "case.toml").write_text(text)
        run = self.folder / "run"
        self.done("gencase", self.folder, "--out", run, "--set", f'surface_bed.end="{end} s"')
        self.done("solver", run)
        return run

    def test_profiles_carry_the_time_of_the_bed(self):
        (self.folder / "reference" / "t3.000.csv").write_text("x [m],bed [m]\n0.03,0\n0.07,0\n0.11,0\n")
        run = self.solved(4, (2, 3))
        said = self.done("postproc", run, "--no-surfaces")
        self.assertNotIn("The results end at", said)
        self.assertNotIn("no snapshot", said)
        self.assertTrue((run / "profiles" / "t2.000.csv").exists())
        with open(run / "profiles" / "t3.000.csv", newline="") as file:
            levels = {float(row["x [m]"]): float(row["bed [m]"]) for row in csv.DictReader(line for line in file if line[0] != "#")
                      if row["bed [m]"]}
        with open(run / "report" / "errors.csv", newline="") as file:
            rows = [row for row in csv.DictReader(line for line in file if line[0] != "#") if row["curve"] == "bed"]
        self.assertEqual([float(row["time [s]"]) for row in rows], [3])
        off = [min(levels.items(), key=lambda place: abs(place[0] - x))[1] for x in (0.03, 0.07, 0.11)]
        rms = (sum(level * level for level in off) / 3) ** 0.5
        self.assertAlmostEqual(float(rows[0]["rmse [m]"]), rms, delta=0.001)

    def test_a_time_that_the_bed_has_not_come_to_is_named(self):
        run = self.solved(4, (3,))
        resolved = run / "case.resolved.toml"
        text = resolved.read_text()
        self.assertIn('bed_times = ["3 s"]', text)
        resolved.write_text(text.replace('bed_times = ["3 s"]', 'bed_times = ["3 s", "3.9999 h"]').replace('end = "4 s"', 'end = "0 s"'))
        said = self.done("postproc", run, "--no-surfaces", status=1)
        self.assertIn("no snapshot at the bed's time 14399.6 s", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
