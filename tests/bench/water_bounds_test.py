"""Water against nature: water_bounds_test.py THALWEG SCRATCH PROBLEM [--long]

Runs a problem of bench/speed_vs_error at the spacings of water_bounds.toml and holds its measures against the bounds there; with --long
the rows that are validations. To be told what a measure is, read the problem's class in problems.py or water.py.
"""

import pathlib
import shutil
import sys
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bench"), str(ROOT / "bench/speed_vs_error")]

from problems import PROBLEMS
from study.runs import Run

thalweg, scratch, problem = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
long = "--long" in sys.argv[4:]


def table(file, name):
    return tomllib.loads(file.read_text(encoding="utf-8"))[name]


class Bounds(unittest.TestCase):
    def test_measures_are_within_their_bounds(self):
        entry = next(row for row in table(ROOT / "bench/speed_vs_error/matrix.toml", "problem") if row["name"] == problem)
        rows = [row for row in table(pathlib.Path(__file__).with_name("water_bounds.toml"), "bound")
                if row["problem"] == problem and row.get("long", False) == long]
        self.assertTrue(rows, f"no row of {problem} in water_bounds.toml")
        for row in rows:
            settings = [f'numerics.spacing="{row["spacing"]}"', *entry.get("set", [])]
            run = Run(thalweg, scratch, ROOT / entry["case"], f"{problem} {row['spacing']}", settings)
            shutil.rmtree(run.folder, ignore_errors=True)
            run.compute(PROBLEMS[problem].start)
            found = PROBLEMS[problem].errors(run)
            for measure, most in row["most"].items():
                with self.subTest(spacing=row["spacing"], measure=measure):
                    self.assertLessEqual(abs(found[measure]), most, f"{row['why']} (all: {found})")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
