#!/usr/bin/env python3
"""A run on several processes of MPI: ranks_test.py THALWEG FOLDER

It gives the same files as a run on one, and nothing is lost when a process dies.
"""

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

SETTINGS = ('numerics.spacing="15 mm"', 'output.end="0.15 s"', 'output.interval="0.03 s"', "compare.times=[]")
ENDLESS = ('numerics.spacing="15 mm"', 'output.end="1000 s"', 'output.interval="0.05 s"', "compare.times=[]",
           'output.checkpoint_interval="0.2 s"')
PATIENCE = 60  # [s]


def files_of(run):
    """History and snapshots."""
    return (run / "history.csv").read_bytes(), [(time, file.read_bytes()) for time, file in case.series(run)]


class Ranks(unittest.TestCase):
    def setUp(self):
        self.run = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.run, ignore_errors=True)

    def fill(self, settings):
        filled = case.call(case.command(thalweg, "gencase", case.CASE, self.run, settings))
        self.assertEqual(filled.returncode, 0, filled.stderr)

    def solver(self, *options):
        words = [str(word) for word in (thalweg, "solver", self.run, "--threads", 1, *options)]
        return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def ends(self, process, status=0):
        out, err = process.communicate(timeout=PATIENCE)
        if status is not None:
            self.assertEqual(process.returncode, status, out + err)
        return out + err

    def snapshots(self):
        """Of the series, which is not there at first."""
        return case.series(self.run) if (self.run / "snapshots.pvd").exists() else []

    def wait_for(self, condition):
        deadline = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), deadline, "waited in vain")
            time.sleep(0.02)

    def test_the_files_are_those_of_one_process(self):
        self.fill(SETTINGS)
        self.ends(self.solver())
        alone = files_of(self.run)
        for ranks in (2, 3):
            said = self.ends(self.solver("--force", "--ranks", ranks))
            self.assertIn(f"{ranks} ranks of OpenMP", said)
            self.assertEqual(said.count("snapshots to come"), 1, said)
            several = files_of(self.run)
            self.assertEqual(alone[0], several[0])
            self.assertEqual([at for at, _ in alone[1]], [at for at, _ in several[1]])
            for (at, one), (_, other) in zip(alone[1], several[1]):
                self.assertEqual(one, other, f"snapshot of t = {at} s on {ranks} ranks")

    def test_a_damaged_file_is_refused_by_all_with_one_line(self):
        self.fill(SETTINGS)
        file = self.run / "particles.vtp"
        whole = file.read_bytes()
        file.write_bytes(whole[:len(whole) // 2] + b"A" + whole[len(whole) // 2 + 1:])
        said = self.ends(self.solver("--ranks", 3), status=2)
        self.assertEqual(said.count("error:"), 1, said)
        self.assertIn("is damaged: its checksum does not fit its contents", said)

    def test_a_process_that_dies_ends_the_run_which_goes_on_from_its_checkpoint(self):
        for victim in (0, 1):
            shutil.rmtree(self.run, ignore_errors=True)
            self.fill(ENDLESS)
            process = self.solver("--ranks", 2)
            self.wait_for(lambda: len(self.snapshots()) > 2 and (self.run / "checkpoint.vtp").exists())
            ranks = case.solvers_under(process.pid)
            self.assertEqual(len(ranks), 2)
            begun = time.monotonic()
            os.kill(ranks[victim], signal.SIGKILL)
            self.ends(process, None)
            self.assertNotEqual(process.returncode, 0)
            self.assertLess(time.monotonic() - begun, 10)
            last = case.series(self.run)[-1][0]
            self.ends(self.solver("--restart", "latest", "--ranks", 3, "--until", f"{last + 0.11} s"))
            self.assertGreaterEqual(case.series(self.run)[-1][0], last + 0.05)

    def test_a_signal_leaves_a_checkpoint(self):
        self.fill(ENDLESS)
        process = self.solver("--ranks", 2)
        self.wait_for(lambda: len(self.snapshots()) > 1)
        process.send_signal(signal.SIGTERM)
        self.ends(process, None)
        self.assertTrue((self.run / "checkpoint.vtp").exists())
        self.ends(self.solver("--restart", "latest", "--until", f"{case.series(self.run)[-1][0] + 0.06} s"))

    def test_the_programs_say_that_they_found_mpi(self):
        told = case.call([str(thalweg), "--version"]).stdout.splitlines()
        self.assertIn("MPI       found", told)

    def test_what_does_not_run_on_several_ranks_is_one_line(self):
        self.fill(SETTINGS)
        os.environ["CUDA_VISIBLE_DEVICES"] = ""
        said = self.ends(self.solver("--ranks", 2, "--backend", "cuda"), 2)
        errors = [line for line in said.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, said)
        self.assertIn("rank 0: --backend cuda: ", errors[0])
        for way, why in (("nccl", "the ranks compute on CPU cores"), ("pigeon", "no such way")):
            said = self.ends(self.solver("--ranks", 2, "--device-messages", way), 2)
            errors = [line for line in said.splitlines() if line.startswith("error: ")]
            self.assertEqual(len(errors), 1, said)
            self.assertIn(f"--device-messages {way}: {why}", errors[0])
        said = self.ends(self.solver("--ranks", 2, "--restart", "nowhere.vtp"), 2)
        self.assertEqual(sum(line.startswith("error: ") for line in said.splitlines()), 1, said)


if __name__ == "__main__":
    if shutil.which("mpirun") is None or not (thalweg.parent / "thalweg_ranks_mpi.so").exists():
        print("no MPI: skipped")
        sys.exit(77)
    unittest.main()
