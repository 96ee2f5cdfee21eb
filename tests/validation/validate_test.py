#!/usr/bin/env python3
"""`thalweg validate` on a case whose answer is known: verdicts, tables, wrong input, resuming: validate_test.py THALWEG FOLDER"""

import csv
import json
import shutil
import signal
import subprocess
import sys
import time
import unittest

import small_case
from small_case import level

thalweg, scratch = small_case.arguments(sys.argv)


class Validate(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.out = self.folder / "out"

    def validate(self, expected, *options, case=small_case.CASE):
        tank = small_case.write(self.folder / "tank", expected, case)
        return small_case.call(thalweg, "validate", tank, "--out", self.out, *options)

    def rows(self):
        lines = [line for line in (self.out / "validation.csv").read_text().splitlines() if not line.startswith("#")]
        return list(csv.DictReader(lines))

    def test_a_figure_within_its_limit_passes(self):
        result = self.validate(level())
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        row, = self.rows()
        self.assertEqual((row["verdict"], row["known"], row["spacing [m]"], row["scatter"]), ("pass", "0.1", "0.01", ""))
        self.assertAlmostEqual(float(row["computed"]), 0.1, delta=0.0025)
        self.assertAlmostEqual(float(row["judged_error"]), float(row["computed"]) - 0.1, delta=1e-6)
        page = (self.out / "validation.md").read_text()
        report = page[page.index("[report](") + len("[report]("):]
        self.assertTrue((self.out / report[:report.index(")")]).is_file(), "the page's link leads nowhere")
        self.assertEqual(json.loads((self.out / "validation.json").read_text())["figures"][0]["verdict"], "pass")

    def test_a_page_keeps_the_sections_of_other_cases(self):
        page = self.folder / "page.md"
        self.folder.mkdir(parents=True)
        others = ("# Validation\n\n## pier\n\n5 figures: 2 pass, 1 known misfits, 1 fail, 1 without a verdict. `thalweg validate cases/pier`, "
                  "program thalweg 0.1.0, commit abc, 40 s of processor time in the solver.\n\n| run |\n|---|\n")
        page.write_text(others + "\n" + others.replace("# Validation\n\n", "").replace("pier", "tank"))
        result = self.validate(level(), "--page", page, "--add")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        text = page.read_text()
        self.assertIn("**6 figures: 3 pass, 1 known misfits, 1 fail, 1 without a verdict**", text)  # with the tank's own, in place of five
        self.assertEqual((text.count("## pier\n"), text.count("## tank\n"), text.count("| run |\n")), (1, 1, 1))
        self.validate(level(), "--page", page, "--resume")
        self.assertNotIn("## pier", page.read_text())
        refused = self.validate(level(), "--add", "--resume")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--add goes with --page", refused.stderr)

    def test_quiet_says_nothing_and_json_is_one_object(self):
        result = self.validate(level(), "--quiet")
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        result = self.validate(level(value=0.12), "--json", "--resume")
        told = json.loads(result.stdout)
        self.assertEqual((told["status"], told["pass"], told["fail"]), (1, 0, 1))
        self.assertIn("1 figures", result.stderr)
        refused = json.loads(self.validate("[level]\n", "--json", "--force").stdout)
        self.assertEqual(refused["status"], 2)
        self.assertIn("measure is missing", refused["errors"][0]["message"])

    def test_a_figure_beyond_its_limit_fails(self):
        result = self.validate(level(value=0.12))
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertEqual(self.rows()[0]["verdict"], "fail")

    def test_a_declared_misfit_is_shown_as_such_and_never_as_pass(self):
        result = self.validate(level(value=0.12, more='known_misfit = "the tank leaks"\nmisfit_limit = 0.03'))
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(self.rows()[0]["verdict"], "known misfit")
        self.assertIn("the tank leaks", (self.out / "validation.md").read_text())
        self.assertIn("0 pass, 1 known misfits", result.stdout)

    def test_a_misfit_that_has_become_worse_fails(self):
        result = self.validate(level(value=0.14, more='known_misfit = "the tank leaks"\nmisfit_limit = 0.03'))
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)

    def test_a_figure_without_a_limit_has_no_verdict(self):
        entry = level().replace("limit = 0.0025\n", "").replace("value = 0.1\n", "")
        result = self.validate(entry)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual((self.rows()[0]["verdict"], self.rows()[0]["known"]), ("no verdict", ""))

    def test_repeats_give_a_scatter_and_spacings_an_order(self):
        pressure = ('[pressure]\nmeasure = "hydrostatic pressure"\nlayers = [[0.1, 1000]]\nunit = "Pa"\nerror = "rmse"\nrelative_to = "rms"\n'
                    'limit = 0.2\nreason = "kernel sums at the surface"\n')
        runs = ('[[run]]\nname = "coarse"\nset = [\'numerics.spacing="20 mm"\']\n[[run]]\nname = "fine"\nrepeats = 1\n'
                '[[run]]\nname = "finest"\nset = [\'numerics.spacing="5 mm"\']\nfull = true\n')
        result = self.validate(runs + pressure)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        coarse, fine = self.rows()  # the one that is full is not made
        self.assertEqual((coarse["scatter_runs [-]"], fine["scatter_runs [-]"]), ("1", "2"))
        self.assertGreater(float(fine["scatter"]), 0)
        errors = float(coarse["judged_error"]), float(fine["judged_error"])
        self.assertGreater(errors[0], errors[1])
        self.assertGreater(float(fine["order [-]"]), 0)

    def test_a_run_that_fails_is_a_failed_verdict_with_its_reason(self):
        runs = '[[run]]\nname = "soft"\nset = [\'numerics.maximum_speed="0.02 m/s"\', \'output.end="1 s"\']\n[[run]]\nname = "stiff"\n'
        falling = small_case.CASE.replace('to = ["0.2 m", "0.1 m"]', 'to = ["0.1 m", "0.1 m"]')
        result = self.validate(runs + level(limit=1), case=falling)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        soft, stiff = self.rows()
        self.assertEqual((soft["verdict"], stiff["verdict"]), ("fail", "pass"))
        self.assertIn("the run failed: ", soft["note"])

    def test_a_case_with_long_runs_only_is_told_and_not_run(self):
        result = self.validate('[[run]]\nname = "long"\nfull = true\n\n' + level())
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("tank: all its runs are long; make them with --full", result.stdout)
        self.assertFalse(self.out.exists())

    def test_a_column_over_another_clock(self):
        # After 40 steps and more some of 0.1 s have passed; after step 1 next to none.
        entry = level(value=0, limit=0.01, more='file = "history.csv"\nclock = "step"\nat = 1\n')
        entry = entry.replace('file = "gauges.csv"\n', "", 1).replace('"middle.level"', '"time"').replace('statistic = "mean"\n', "")
        result = self.validate(entry)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        row, = self.rows()
        self.assertLess(float(row["computed"]), 0.01)

    def test_resume_makes_no_finished_run_again(self):
        self.assertEqual(self.validate(level()).returncode, 0)
        summary = self.out / "runs/tank/as_it_is/summary.csv"
        before = summary.stat().st_mtime_ns
        small_case.error_of(small_case.call(thalweg, "validate", self.folder / "tank", "--out", self.out), self)
        again = self.validate(level(), "--resume")
        self.assertEqual((again.returncode, summary.stat().st_mtime_ns), (0, before), again.stderr)
        changed = small_case.CASE.replace('end = "0.1 s"', 'end = "0.15 s"')
        other = self.validate(level(), "--resume", case=changed)
        self.assertEqual(other.returncode, 0, other.stderr)
        self.assertIn("made again, because the case has changed", other.stdout + other.stderr)
        self.assertNotEqual(summary.stat().st_mtime_ns, before, "the run of another case was taken for this one's")

    def test_an_interrupted_run_goes_on_from_its_checkpoint(self):
        tank = small_case.write(self.folder / "tank", level(limit=1), small_case.CASE.replace('end = "0.1 s"', 'end = "6 s"'))
        process = subprocess.Popen([thalweg, "validate", tank, "--out", self.out], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        run = self.out / "runs/tank/as_it_is"
        for _ in range(600):
            if (run / "snapshots/s00003.vtp").exists():
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60), 128 + signal.SIGTERM)
        for _ in range(600):
            if (run / "checkpoint.vtp").exists():
                break
            time.sleep(0.05)
        self.assertFalse((run / "made_by.json").exists())
        result = small_case.call(thalweg, "validate", tank, "--out", self.out, "--resume")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        facts = dict(line.split(",")[:2] for line in (run / "summary.csv").read_text().splitlines())
        self.assertGreaterEqual(int(facts["restarts"]), 1)


class WrongInput(unittest.TestCase):
    def refused(self, expected, *words, out=None):
        name = self.id().rsplit(".", 1)[-1]
        tank = small_case.write(scratch / name / "tank", expected)
        out = scratch / name / "out"
        shutil.rmtree(out, ignore_errors=True)
        error = small_case.error_of(small_case.call(thalweg, "validate", tank, "--out", out), self)
        for word in words:
            self.assertIn(word, error)
        return out

    def refused_before_any_run(self, expected, *words):
        self.assertFalse(self.refused(expected, *words).exists())

    def test_key_that_is_unknown(self):
        self.refused_before_any_run(level(more="limt = 3"), "expected.toml:10:", "limt", "limit")

    def test_measure_that_is_unknown(self):
        self.refused_before_any_run(level().replace('"column"', '"colum"'), "expected.toml:2:", "colum")

    def test_measure_that_is_missing(self):
        self.refused_before_any_run(level().replace('measure = "column"\n', ""), "expected.toml:1:", "measure")

    def test_reason_that_is_missing(self):
        self.refused_before_any_run(level().replace('reason = "a quarter of a spacing"\n', ""), "expected.toml:1:", "reason")

    def test_limit_that_is_a_text(self):
        self.refused_before_any_run(level(limit='"small"'), "expected.toml:8:", "a number")

    def test_limit_of_nothing_known(self):
        self.refused_before_any_run(level().replace("value = 0.1\n", ""), "expected.toml:7:", "value")

    def test_statistic_that_is_unknown(self):
        self.refused_before_any_run(level().replace('"mean"', '"meen"'), "expected.toml:5:", "mean")

    def test_misfit_without_its_limit(self):
        self.refused_before_any_run(level(more='known_misfit = "leaks"'), "expected.toml:10:", "misfit_limit")

    def test_table_that_is_absent(self):
        entry = level().replace("value = 0.1\n", 'reference = "reference/no.csv"\nreference_at = "time"\nreference_column = "h"\n')
        self.refused_before_any_run(entry, "expected.toml:6:", "reference/no.csv")

    def test_run_that_is_unknown(self):
        self.refused_before_any_run('[[run]]\nname = "fine"\n' + level(more='runs = ["fein"]'), "expected.toml:12:", "fine")

    def test_setting_that_gencase_refuses(self):
        self.refused_before_any_run('\n[[run]]\nname = "a"\nset = ["numerics.spacng=1"]\n' + level(), "expected.toml:2:", "spacng")

    def test_runs_that_would_share_a_folder(self):
        self.refused_before_any_run('[[run]]\nname = "a b"\n[[run]]\nname = "a_b"\n' + level(), "a_b", "expected.toml")

    def test_broken_toml(self):
        self.refused_before_any_run("[level]\nvalue = = 1\n", "expected.toml:2:")

    def test_value_outside_of_a_table(self):
        self.refused_before_any_run("limit = 1\n" + level(), "expected.toml:1:", "[limit]")

    def test_column_that_the_run_does_not_have(self):
        self.refused(level().replace("middle.level", "midle.level"), "expected.toml:4:", "middle.level")

    def test_clock_that_the_run_does_not_have(self):
        self.refused(level(more='clock = "moon_time"'), "expected.toml:10:", "moon_time")

    def test_case_that_is_absent(self):
        error = small_case.error_of(small_case.call(thalweg, "validate", scratch / "nowhere", "--out", scratch / "none"), self)
        self.assertIn("case.toml", error)

    def test_option_that_is_unknown(self):
        self.assertIn("--colour", small_case.error_of(small_case.call(thalweg, "validate", "--colour"), self))


if __name__ == "__main__":
    unittest.main()
