#!/usr/bin/env python3
"""Wrong input ends with status 2 and one line that says what to do; a run that fails ends with 1:
wrong_input_test.py THALWEG FOLDER"""

import pathlib
import re
import shutil
import sys
import unittest

import coarse_louvain as case

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))


class WrongInput(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.out = self.folder / "out"

    def case_with(self, old, new):
        """The Louvain case with a piece of its text replaced, and the number of the line that changed."""
        text = (case.CASE / "case.toml").read_text()
        self.assertEqual(text.count(old), 1, old)
        (self.folder / "case.toml").write_text(text.replace(old, new))
        return text[:text.index(old)].count("\n") + 1

    def rejected(self, words, *expected):
        result = case.call(words)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        errors = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertIn(";", errors[0], "what to do is missing")
        for text in expected:
            self.assertIn(text, errors[0])
        self.assertFalse(self.out.exists() and any(self.out.rglob("*.vtp")), "particles were written all the same")

    def rejected_case(self, old, new, *expected):
        line = self.case_with(old, new)
        command = case.command(thalweg, "run", self.folder, self.out, (), ["--no-foam"])
        self.rejected(command, f"case.toml:{line}:", *expected)

    def test_unknown_key_names_the_nearest(self):
        self.rejected_case('spacing = "5 mm"', 'spacng = "5 mm"', "spacng", "spacing")

    def test_missing_unit(self):
        self.rejected_case('spacing = "5 mm"', 'spacing = "5"', "unit")

    def test_wrong_unit(self):
        self.rejected_case('spacing = "5 mm"', 'spacing = "5 kg"', "kg")

    def test_value_out_of_range(self):
        self.rejected_case("porosity = 0.47", "porosity = 1.47", "porosity", "1.47")

    def test_broken_toml(self):
        self.rejected_case('spacing = "5 mm"', 'spacing = = "5 mm"')

    def test_path_that_leaves_no_room_for_files(self):
        deep = self.folder.joinpath(*["d" * 250] * 16)
        result = case.call(case.command(thalweg, "run", case.CASE, deep, (), ["--no-foam"]))
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertRegex(result.stderr, r"(?m)^error: .* give a shorter --out$")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_more_files_than_the_case_allows(self):
        self.case_with("[output]\n", '[output]\ndisk_limit = "1 MB"\n')
        result = case.call(case.command(thalweg, "run", self.folder, self.out, (), ["--no-foam"]))
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        errors = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertRegex(errors[0], r"will take about .* and output.disk_limit is .*; lengthen output.interval")
        self.assertFalse((self.out / "snapshots").exists())

    def test_no_case(self):
        self.rejected(case.command(thalweg, "run", self.folder / "nowhere", self.out, ()), "nowhere")

    def test_setting_of_an_unknown_key(self):
        command = case.command(thalweg, "run", case.CASE, self.out, ('numerics.spacng="4 mm"',))
        self.rejected(command, "spacng", "spacing")

    def test_unknown_program(self):
        self.rejected([thalweg, "gencaes", case.CASE], "gencaes", "gencase")

    def test_unknown_option(self):
        self.rejected([thalweg, "run", case.CASE, "--out", self.out, "--colour"], "--colour")

    def test_solver_without_particles(self):
        self.rejected([thalweg, "solver", self.folder])

    def test_info_of_a_truncated_file(self):
        made = case.call(case.command(thalweg, "gencase", case.CASE, self.out))
        self.assertEqual(made.returncode, 0, made.stderr)
        content = (self.out / "particles.vtp").read_bytes()
        shutil.rmtree(self.out)
        (self.folder / "cut.vtp").write_bytes(content[:len(content) // 2])
        self.rejected([thalweg, "info", self.folder / "cut.vtp"], "cut.vtp")


class FailedRun(unittest.TestCase):
    def test_a_diverging_run_ends_with_1_and_says_why(self):
        out = scratch / "diverging"
        shutil.rmtree(out, ignore_errors=True)
        settings = (f'numerics.spacing="{case.SPACING} m"', 'numerics.maximum_speed="0.05 m/s"', 'output.end="1 s"')
        result = case.call(case.command(thalweg, "run", case.CASE, out, settings, ["--no-foam"]))
        self.assertEqual(result.returncode, 1, result.stderr)
        errors = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertRegex(errors[0], re.compile("cfl|time step|diverge|exclude", re.IGNORECASE))


if __name__ == "__main__":
    unittest.main()
