#!/usr/bin/env python3
"""The bed of one run becomes that of another case: bed_survey_test.py THALWEG FOLDER

A bed that is a surface becomes one of particles, and back: the grains stay, to what a lattice can hold.
"""

import csv
import pathlib
import re
import shutil
import sys
import unittest

import coarse_louvain as case

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))
ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "tests" / "solver" / "program" / "surface_bed"
SURVEYED = """
[[shape]]
name = "bed"
kind = "bathymetry"
role = "sediment"
file = "bed.csv"
base = "{base} m"
"""


def without(text, name):
    """The case without a shape."""
    return re.sub(rf'\[\[shape\]\]\nname = "{name}".*?(?=\n\[)', "", text, count=1, flags=re.S)


class BedSurvey(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def done(self, *words):
        ended = case.call([str(word) for word in (thalweg, *words)])
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return ended.stdout + ended.stderr

    def run_of(self, case_folder, name, end):
        run = self.folder / name
        self.done("gencase", case_folder, "--out", run, "--set", f'output.end="{end} s"')
        self.done("solver", run)
        return run

    def surveyed(self, name, text, base, run):
        """A case whose bed is that of a run."""
        folder = self.folder / name
        folder.mkdir()
        self.done("postproc", run, "--no-surfaces", "--bed-survey", folder / "bed.csv")
        (folder / "case.toml").write_text(text + SURVEYED.format(base=base))
        return folder

    def last(self, run, column):
        with open(run / "history.csv", newline="") as file:
            return float(list(csv.DictReader(file))[-1][column])

    def check_there_and_back(self, scene, base, water_from, porosity, density):
        text = (SCENES / scene).read_text()
        (self.folder / "slow").mkdir()
        (self.folder / "slow" / "case.toml").write_text(text)
        slow = self.run_of(self.folder / "slow", "out_slow", 0.6)
        grains = self.last(slow, "bed_grains [m^3]")

        # The water goes down to the ground, and the bed takes its place from it.
        bare = water_from(without(text, "bed"))
        violent = re.sub(r"\[surface_bed\].*?(?=\n\[)", "", bare.replace('sediment = "surface"', 'sediment = "three-state"'), flags=re.S)
        dug = self.run_of(self.surveyed("violent", violent, base, slow), "out_violent", 0.002)
        filled = self.last(dug, "sediment_mass [kg]") / density
        self.assertAlmostEqual(filled * (1 - porosity), grains, delta=0.03 * grains)

        again = self.run_of(self.surveyed("again", bare, base, dug), "out_again", 0.002)
        self.assertAlmostEqual(self.last(again, "bed_grains [m^3]"), grains, delta=0.05 * grains)

    def test_in_space_around_a_pier(self):
        self.check_there_and_back("pier.toml", -0.06, lambda text: text.replace('from = ["0 m", "0 m", "0 m"]', 'from = ["0 m", "0 m", "-0.06 m"]'),
                                  porosity=0.4, density=0.6 * 2650 + 0.4 * 1000)

    def test_a_run_without_a_bed_says_so(self):
        run = self.folder / "run"
        self.done("gencase", ROOT / "cases" / "dam_break", "--out", run, "--set", 'output.end="0.01 s"', "--set", 'numerics.spacing="10 mm"',
                  "--set", "compare.times=[]")
        self.done("solver", run)
        ended = case.call([str(thalweg), "postproc", str(run), "--bed-survey", str(self.folder / "bed.csv")])
        self.assertEqual(ended.returncode, 2)
        self.assertIn("has no bed", ended.stderr)


if __name__ == "__main__":
    unittest.main()
