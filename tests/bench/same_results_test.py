#!/usr/bin/env python3
"""tools/same-results finds equal builds equal, and any single bit that differs: same_results_test.py THALWEG FOLDER"""

import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from study.differences import first_array_difference, first_table_difference  # noqa: E402
from thalweg.particle_file import encoded  # noqa: E402

thalweg, scratch = (pathlib.Path(argument).resolve() for argument in (sys.argv.pop(1), sys.argv.pop(1)))

ONE = b"\x00\x00\x80\x3f"          # 1.0 as a 32-bit number, and the next larger one
NEXT = b"\x01\x00\x80\x3f"
FILE = '<DataArray type="Int64" Name="Step" format="binary">{step}</DataArray>' \
       '<DataArray type="Int64" Name="Id" format="binary">{ids}</DataArray>' \
       '<DataArray type="Float32" Name="{name}" format="binary">{values}</DataArray>'


def integers(*values):
    return encoded(b"".join(value.to_bytes(8, "little") for value in values))


class Differences(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        for side in "ab":
            (self.folder / side).mkdir(parents=True)
        self.one_sided = set()

    def particles(self, side, values, name="Pressure"):
        file = self.folder / side / "s00001.vtp"
        file.write_text(FILE.format(step=integers(7), ids=integers(30, 40), name=name, values=encoded(values)), encoding="latin-1")
        return file

    def difference(self, left, right):
        return first_array_difference(left, right, self.one_sided)

    def table(self, text_a, text_b, restarted=False):
        for side, text in (("a", text_a), ("b", text_b)):
            (self.folder / side / "history.csv").write_text(text, encoding="utf-8")
        return first_table_difference("history.csv", self.folder / "a", self.folder / "b", self.one_sided, restarted)

    def test_the_last_bit_of_one_value_is_found(self):
        found = self.difference(self.particles("a", ONE + ONE), self.particles("b", ONE + NEXT))
        self.assertEqual(found, "s00001.vtp: Pressure of particle 40 1.0 ≠ 1.0000001192092896, step 7")

    def test_minus_zero_is_not_zero(self):
        self.assertIsNotNone(self.difference(self.particles("a", ONE + bytes(4)), self.particles("b", ONE + b"\0\0\0\x80")))

    def test_an_array_that_one_side_has_is_named(self):
        self.assertIsNone(self.difference(self.particles("a", ONE + ONE), self.particles("b", ONE + ONE, "Renamed")))
        self.assertEqual(self.one_sided, {"array Pressure of s00001.vtp", "array Renamed of s00001.vtp"})

    def test_a_file_that_one_side_has_differs(self):
        self.assertIn("missing", self.difference(self.particles("a", ONE + ONE), self.folder / "b" / "s00001.vtp"))

    def test_a_cell_of_a_table_is_compared_as_text(self):
        found = self.table("time [s],step [-],dt [s]\n1,5,0.1\n", "time [s],step [-],dt [s]\n1,5,0.10\n")
        self.assertEqual(found, "history.csv: dt [s] 0.1 ≠ 0.10, step 5")

    def test_a_row_too_few_differs_but_after_a_restart(self):
        long, short = "time [s],step [-]\n1,5\n2,6\n", "time [s],step [-]\n2,6\n"
        self.assertIsNotNone(self.table(long, short))
        self.assertIsNone(self.table(long, short, restarted=True))


class WholeBuilds(unittest.TestCase):
    """On the quickest scene; a build that changes something is the same one with another density diffusion."""
    build = thalweg.parents[1]

    def compare(self, new):
        command = [ROOT / "tools/same-results", self.build, new, "--scenes", "double_sums", "--threads", "1",
                   "--instruction-sets", "baseline", "--out", scratch / "same-results"]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_a_build_equals_itself(self):
        done = self.compare(self.build)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("| double_sums |", done.stdout)

    def test_a_build_with_other_numbers_does_not(self):
        other = scratch / "other_build"
        shutil.rmtree(other, ignore_errors=True)
        (other / "bin").mkdir(parents=True)
        for program, change in (("gencase", ""), ("solver", "--set numerics.density_diffusion=0.10001")):
            file = other / "bin" / f"thalweg-{program}"
            file.write_text(f'#!/bin/sh\nexec "{self.build}/bin/thalweg-{program}" "$@" {change}\n', encoding="utf-8")
            file.chmod(0o755)
        done = self.compare(other)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("≠", done.stdout)


if __name__ == "__main__":
    unittest.main()
