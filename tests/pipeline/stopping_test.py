#!/usr/bin/env python3
"""A run that is stopped leaves whole files and says how it ended: stopping_test.py THALWEG FOLDER"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import coarse_louvain as case

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))

# Long enough that no machine finishes it before it is stopped; snapshots come quickly.
ENDLESS = (f'numerics.spacing="{case.SPACING} m"', 'output.end="1000 s"', 'output.interval="0.005 s"')
PATIENCE = 120  # [s]


class Stopped(unittest.TestCase):
    def setUp(self):
        self.run = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.run, ignore_errors=True)
        self.run.parent.mkdir(parents=True, exist_ok=True)
        self.log = open(f"{self.run}.log", "w+")
        self.addCleanup(self.log.close)
        # A session of its own, so that a signal to the group reaches every stage as Ctrl-C on a terminal does.
        command = case.command(thalweg, "run", case.CASE, self.run, ENDLESS, ["--no-foam"])
        self.process = subprocess.Popen(command, stdout=self.log, stderr=self.log, stdin=subprocess.DEVNULL,
                                        start_new_session=True)
        self.addCleanup(self.end_group)
        self.wait_for_snapshots(3)

    def end_group(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()

    def said(self):
        self.log.seek(0)
        return self.log.read()

    def wait_for_snapshots(self, count):
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            self.assertIsNone(self.process.poll(), self.said())
            if (self.run / "snapshots.pvd").is_file() and len(case.series(self.run)) >= count:
                return
            time.sleep(0.02)
        self.fail(f"no {count} snapshots after {PATIENCE} s: {self.said()}")

    def check_files(self):
        """The series is complete XML and everything it names can be read to the end."""
        entries = case.series(self.run)
        self.assertGreaterEqual(len(entries), 3)
        for _, file in (*entries[-3:], (0, self.run / "particles.vtp")):
            result = case.call([thalweg, "info", file])
            self.assertEqual(result.returncode, 0, result.stderr)
        rows = case.table(self.run / "history.csv")
        self.assertTrue(all(None not in row.values() for row in rows), "a row is cut off")

    def check_ending(self, status):
        self.assertEqual(self.process.wait(PATIENCE), status, self.said())
        self.check_files()
        result = case.call([thalweg, "info", self.run / "checkpoint.vtp"])
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_sigterm_finishes_the_step_and_writes_a_checkpoint(self):
        self.process.send_signal(signal.SIGTERM)
        self.check_ending(143)
        with self.assertRaises(ProcessLookupError, msg="a stage lives on"):
            os.killpg(self.process.pid, 0)

    def test_interrupt_from_the_terminal_does_the_same(self):
        os.killpg(self.process.pid, signal.SIGINT)
        self.check_ending(130)

    def test_kill_leaves_whole_files(self):
        for _ in range(3):
            self.wait_for_snapshots(len(case.series(self.run)) + 1)
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.check_files()


if __name__ == "__main__":
    unittest.main()
