#!/usr/bin/env python3
"""Nothing that a run has written is lost, whatever ends it: durable_test.py THALWEG FOLDER

tools/durability-check does the same many times over, and cuts the power.
"""

import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

import coarse_louvain as case

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))

SETTINGS = ('numerics.spacing="20 mm"', 'output.end="0.2 s"', 'output.interval="0.01 s"', "compare.times=[]")
ENDLESS = ('numerics.spacing="20 mm"', 'output.end="1000 s"', 'output.interval="0.01 s"', "compare.times=[]")
PATIENCE = 60  # [s]


def tables_and_snapshots(run):
    """Contents of what a run shows: history.csv and all snapshots of the series."""
    return (run / "history.csv").read_text(), [(time, file.read_bytes()) for time, file in case.series(run)]


class Durable(unittest.TestCase):
    def setUp(self):
        self.run = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(scratch / self.run.name, ignore_errors=True)
        shutil.rmtree(f"{self.run} moved", ignore_errors=True)

    def fill(self, settings):
        filled = case.call(case.command(thalweg, "gencase", case.CASE, self.run, settings))
        self.assertEqual(filled.returncode, 0, filled.stderr)

    def solver(self, *options, **more):
        words = [str(word) for word in (thalweg, "solver", self.run, *options)]
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, **more)

    def ends(self, process, status):
        out, err = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, status, out + err)
        return out + err

    def one_error(self, text):
        errors = [line for line in text.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, text)
        self.assertLessEqual(len(errors[0]), 300)
        return errors[0]

    def wait_for(self, condition):
        deadline = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), deadline, "waited in vain")
            time.sleep(0.01)

    def parts(self):
        return sorted(self.run.rglob("*.part*"))

    def test_a_full_disk_is_one_line_and_the_run_goes_on_from_there(self):
        """A limit on the size of files, which no user's right is needed for, fails the write as a full disk does."""
        self.fill(SETTINGS)
        straight = self.run.with_name("straight")
        shutil.rmtree(straight, ignore_errors=True)
        shutil.copytree(self.run, straight)
        self.assertEqual(case.call([thalweg, "solver", straight]).returncode, 0)
        room = 60_000  # [bytes] some snapshots fit, no checkpoint does
        text = self.ends(self.solver(preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (room, resource.RLIM_INFINITY))), 1)
        self.assertIn("File too large", self.one_error(text))
        self.assertEqual(self.parts(), [])
        self.assertGreater(len(case.series(self.run)), 1)
        self.ends(self.solver("--restart", "latest"), 0)
        self.assertEqual([time for time, _ in tables_and_snapshots(self.run)[1]],
                         [time for time, _ in tables_and_snapshots(straight)[1]])

    def test_kill_and_resume_give_the_files_of_a_run_without_a_break(self):
        settings = (*SETTINGS, 'output.checkpoint_interval="0.01 s"')
        self.fill(settings)
        straight = self.run.with_name("unbroken")
        shutil.rmtree(straight, ignore_errors=True)
        shutil.copytree(self.run, straight)
        self.assertEqual(case.call([thalweg, "solver", straight]).returncode, 0)
        process = self.solver()
        self.wait_for((self.run / "checkpoint.previous.vtp").exists)
        process.kill()
        process.communicate()
        (self.run / ".s00099.999999999.part.vtp").write_text("of a program that has died")
        self.ends(self.solver("--restart", "latest"), 0)
        self.assertEqual(self.parts(), [])
        self.assertEqual(tables_and_snapshots(self.run)[1], tables_and_snapshots(straight)[1])

    def test_signals_from_the_first_moment_on_leave_a_run_that_goes_on(self):
        self.fill(ENDLESS)
        for number, delay in ((signal.SIGTERM, 0.02), (signal.SIGHUP, 0.05), (signal.SIGXCPU, 0.3)):
            process = self.solver("--restart", "latest")
            time.sleep(delay)
            process.send_signal(number)
            out, err = process.communicate(timeout=PATIENCE)
            self.assertIn(process.returncode, (128 + number, -number), out + err)
            self.assertEqual(self.parts(), [])
        checked = case.call([thalweg, "info", self.run / "checkpoint.vtp"])
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_a_user_signal_writes_and_the_run_goes_on(self):
        self.fill(ENDLESS)
        process = self.solver()
        self.wait_for(lambda: (self.run / "snapshots.pvd").exists())
        self.assertFalse((self.run / "checkpoint.vtp").exists())
        process.send_signal(signal.SIGUSR1)
        self.wait_for((self.run / "checkpoint.vtp").exists)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGTERM)
        self.ends(process, 143)
        # What the log warned of stays for the report; that the run was stopped, its snapshots tell.
        self.assertEqual([line.split(":")[0] for line in (self.run / "warnings/solver.txt").read_text().splitlines()],
                         ["every snapshot ends a time step"])

    def test_a_folder_that_moves_away_ends_the_run(self):
        self.fill(ENDLESS)
        process = self.solver()
        self.wait_for(lambda: (self.run / "snapshots.pvd").exists())
        moved = pathlib.Path(f"{self.run} moved")
        self.run.rename(moved)
        self.assertIn("moved, deleted or exchanged", self.one_error(self.ends(process, 1)))
        self.assertFalse(self.run.exists())
        self.assertGreaterEqual(len(case.series(moved)), 1)

    def test_a_second_program_is_refused(self):
        self.fill(ENDLESS)
        process = self.solver()
        self.wait_for(lambda: (self.run / "snapshots.pvd").exists())
        for program in (("solver", self.run, "--force"), ("gencase", case.CASE, "--out", self.run, "--force")):
            second = case.call([thalweg, *program])
            self.assertEqual(second.returncode, 2, second.stderr)
            self.assertIn(f"process {process.pid} on", self.one_error(second.stderr))
        process.send_signal(signal.SIGTERM)
        self.ends(process, 143)

    def test_closed_streams_take_no_lines_into_files(self):
        self.fill(SETTINGS)

        def close_all():
            for descriptor in (0, 1, 2):
                os.close(descriptor)
        words = [str(thalweg), "solver", str(self.run)]
        self.assertEqual(subprocess.run(words, preexec_fn=close_all, timeout=PATIENCE).returncode, 0)
        for name in ("history.csv", "summary.csv", "timing.csv"):
            self.assertNotIn("[info]", (self.run / name).read_text())

    def test_output_that_nobody_can_take_is_an_error(self):
        with open("/dev/full", "w") as full:
            words = [str(thalweg), "explain"]
            shown = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
        self.assertEqual(shown.returncode, 1, shown.stderr)
        self.one_error(shown.stderr)


if __name__ == "__main__":
    unittest.main()
