#!/usr/bin/env python3
"""bench/micro/instructions.py finds the pair sweeps of the core modules as compiled: instructions_test.py THALWEG"""

import pathlib
import subprocess
import sys
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "bench/micro/instructions.py"
core = pathlib.Path(sys.argv.pop(1)).with_name("thalweg_core_openmp_baseline.so")


def rows(text):
    """{name of the sweep: number of instructions of its inner loop}"""
    cells = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    return {name: int(number) for name, number, *_ in cells[1:]}


class Instructions(unittest.TestCase):
    def run_script(self, *words):
        return subprocess.run([sys.executable, "-B", SCRIPT, *words], capture_output=True, text=True, check=False)

    def test_every_sweep_of_water_is_found_in_both_dimensions(self):
        done = self.run_script(core, "--water")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = rows(done.stdout)
        for dimension in (2, 3):
            for body in (f"ContinuitySweep<{dimension}>", f"MomentumSweep<{dimension}, false>", f"WallPressureSweep<{dimension}>"):
                self.assertGreater(found[f"{dimension}-D {body}"], 30, "fewer cannot compute four pairs")
        self.assertGreater(found["3-D MomentumSweep<3, false>"], found["2-D MomentumSweep<2, false>"])

    def test_a_module_equals_itself(self):
        done = self.run_script(core, core)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"\d+ sweeps equal, 0 differ")

    def test_single_and_double_precision_differ(self):
        done = self.run_script(core, core.with_name("thalweg_core_openmp_baseline_double.so"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(" → ", done.stdout)


if __name__ == "__main__":
    unittest.main()
