#!/usr/bin/env python3
"""The measurements of bench/ in miniature, so that they still run when they are needed: measurements_test.py THALWEG FOLDER

At this size the numbers mean nothing; the test asks that every row has them.
"""

import json
import math
import pathlib
import shutil
import subprocess
import sys
import unittest

thalweg, folder = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))
BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench"


class Measurements(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(folder, ignore_errors=True)

    def run_script(self, script, *options):
        """Runs a script and returns the tables of its record."""
        records = folder / pathlib.Path(script).stem
        done = subprocess.run([sys.executable, "-B", BENCH / script, thalweg, "--repeats", "1", "--out", records / "out",
                               "--records", records, *options], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = list(records.glob("*.json"))
        self.assertEqual(len(found), 1)
        content = json.loads(found[0].read_text(encoding="utf-8"))
        self.assertTrue(found[0].with_suffix(".md").read_text(encoding="utf-8").startswith("# " + content["title"]))
        return [part for part in content["parts"] if "rows" in part]

    def check_costs(self, table, column):
        at = table["columns"].index(column)
        for row in table["rows"]:
            cost = row[at]["median"] if isinstance(row[at], dict) else row[at]
            self.assertTrue(math.isfinite(cost) and cost > 0, f"{column} of {row}")

    def test_feature_costs(self):
        costs, lines = self.run_script("feature_costs/feature_costs.py", "--particles", "4000", "--spacing", "10", "--steps",
                                       "4", "--seconds", "0.01", "--start", "0.01", "--settle", "0.01")
        self.check_costs(costs, "ns a particle-step with")
        of = {(row[0], row[1]): row[3] for row in lines["rows"]}
        self.assertIn("solve_viscosity", of["sediment", "2-D, the same"])
        self.assertIn("move_walls", of["moving walls", "gate, 2-D"])

    def test_scaling(self):
        tables = self.run_script("scaling/scaling.py", "--largest", "1e4", "--work", "1e5", "--thread-particles", "5000")
        self.assertEqual(len(tables), 4)  # two in space, one in the plane, one of threads
        self.assertEqual([len(table["rows"]) for table in tables], [1, 1, 1, 3])

    def test_peer_ratio_without_the_peer(self):
        table, = self.run_script("peer_ratio/peer_ratio.py", "--two-phase", "0.01")
        self.check_costs(table, "million evaluations/CPU s")


if __name__ == "__main__":
    unittest.main()
