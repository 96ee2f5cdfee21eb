#!/usr/bin/env python3
"""tools/gpu-check on a machine that is made up: gpu_check_test.py

The GPU is a script in place of nvidia-smi, the bundle's programs are scripts that write what the real ones would. What is
tested is what the check does with them: rows, budget, going on, refusals, the tables.
"""

import json
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

NVIDIA_SMI = """#!/bin/sh
case "$*" in
  *query-compute-apps*) cat "$FAKE/others" 2>/dev/null ;;
  *utilization*) cat "$FAKE/used" 2>/dev/null || echo 0 ;;
  *name,driver*) cat "$FAKE/gpus" 2>/dev/null || echo "NVIDIA Made-up 9000, 999.1, 80000" ;;
esac
"""
TEST_PROGRAM = """#!/bin/sh
echo "$0 $*" >> "$FAKE/asked"
echo "[  FAILED  ] Made.Up"
[ ! -e "$FAKE/tests_fail" ]
"""
GENCASE = """#!/bin/sh
[ "$2" = --out ] || exit 9
mkdir -p "$3" && touch "$3/case.resolved.toml" "$3/particles.vtp"
"""
# Steps take a millisecond each on a million particles, after half a second at the start.
SOLVER = """#!/usr/bin/env python3
import os, pathlib, sys, time
arguments = sys.argv[1:]
if "--version" in arguments:
    print("thalweg-solver 0.1 made up"); sys.exit()
folder, fake = pathlib.Path(arguments[0]), pathlib.Path(os.environ["FAKE"])
with open(fake / "asked", "a") as log:
    log.write("solver " + " ".join(arguments) + " " + os.environ.get("THALWEG_PAIR_COEFFICIENTS", "") + "\\n")
if (fake / "solver_hangs").exists() and "--benchmark" not in arguments:
    (folder / "checkpoint.vtp").write_text("half way")
    (folder / "summary.csv").write_text("quantity,value,unit\\nphysical_time,0.4,s\\nwall_seconds,7,s\\n")
    time.sleep(300)
if (fake / "solver_fails").exists():
    print("error: made up"); sys.exit(1)
cuda = arguments[arguments.index("--backend") + 1] == "cuda"
count = fake / "runs"
runs = int(count.read_text()) + 1 if count.exists() else 1
count.write_text(str(runs))
energy = 1.0 if cuda else 1.001
if (fake / "cpu_differs").exists() and not cuda: energy = 2.0
if (fake / "runs_differ").exists(): energy += runs * 1e-9
if (fake / "ranks_differ").exists() and "--ranks" in arguments:
    energy += int(arguments[arguments.index("--ranks") + 1]) * 1e-9
(folder / "history.csv").write_text("time [s],kinetic_energy [J],potential_energy [J],water_mass [kg],sediment_mass [kg]\\n"
                                    f"0.1,{energy},5,1,0\\n")
(folder / "checkpoint.vtp").write_text("state")
steps = int(arguments[arguments.index("--benchmark") + 1]) if "--benchmark" in arguments else 300
rows = {"physical_time": 0.12, "wall_seconds": 0.5 + 0.001 * steps, "particles": 1200000, "fluid_particles": 1000000,
        "list_rebuilds": 1 + steps // 10, "neighbours_mean": 99.5, "list_entries_per_particle": 52.6, "bytes_per_particle": 600,
        "viscous_iterations_per_step": 8.5, "fixed_launches": 0.86, "repeated_launches": 0.7}
(folder / "summary.csv").write_text("quantity,value,unit\\n" + "".join(f"{k},{v},-\\n" for k, v in rows.items()))
(folder / "timing.csv").write_text("heading,seconds [s]\\nkick,1\\ndrift,3\\n")
"""


class GpuCheck(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="gpu_check_"))
        self.addCleanup(subprocess.run, ["rm", "-r", str(self.folder)], check=True)
        self.fake, self.out, self.bundle = (self.folder / name for name in ("fake", "out", "bundle"))
        self.script(self.fake / "nvidia-smi", NVIDIA_SMI)
        self.script(self.fake / "mpirun", "#!/bin/sh\nexit 9\n")
        self.script(self.bundle / "bin" / "thalweg-gencase", GENCASE)
        self.script(self.bundle / "bin" / "thalweg-solver", SOLVER)
        for program in ("cuda_test", "case_agreement_test"):
            self.script(self.bundle / "bin" / program, TEST_PROGRAM)

    @staticmethod
    def script(file, text):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        file.chmod(0o755)

    def say(self, name, text=""):
        (self.fake / name).write_text(text, encoding="utf-8")

    def check(self, *options, gpu=True):
        path = os.environ["PATH"] if not gpu else f"{self.fake}:{os.environ['PATH']}"
        done = subprocess.run([sys.executable, "-B", ROOT / "tools" / "gpu-check", "--bundle", self.bundle, "--out", self.out,
                               *options], capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": path, "FAKE": str(self.fake)})
        self.assertEqual(done.stderr, "" if gpu else done.stderr)
        return done

    def rows(self):
        return json.loads((self.out / "gpu-check.json").read_text(encoding="utf-8"))["rows"]

    def asked(self):
        file = self.fake / "asked"
        return file.read_text(encoding="utf-8").splitlines() if file.exists() else []

    def test_says_that_there_is_no_gpu(self):
        (self.fake / "nvidia-smi").unlink()
        self.script(self.fake / "nvidia-smi", "#!/bin/sh\nexit 9\n")
        path = f"{self.fake}:{os.environ['PATH']}"
        done = subprocess.run([sys.executable, "-B", ROOT / "tools" / "gpu-check", "--bundle", self.bundle, "--out", self.out],
                              capture_output=True, text=True, check=False, env={**os.environ, "PATH": path})
        self.assertEqual(done.returncode, 2)
        self.assertIn("no NVIDIA GPU here", done.stderr)

    def test_runs_every_part_and_measures_the_steps_after_the_first(self):
        done = self.check()
        self.assertEqual(done.returncode, 0, done.stdout)
        rows = self.rows()
        self.assertEqual({row["part"] for row in rows.values()}, {"tests", "sanitizer", "bench", "ncu", "flume"})
        nccl = "NCCL: three states in space"
        for name, row in rows.items():
            needs_more = name == nccl or row["part"] in ("sanitizer", "ncu")  # tools that not every machine has
            self.assertTrue(row["passed"] or (needs_more and row["skipped"]), name)
        self.assertIn(f"{nccl}: skipped: needs two GPUs", done.stdout)
        self.assertRegex(done.stdout, f"\nskipped, which this machine cannot run: .*{nccl}")
        figures = rows["flume 3.55 M"]["figures"]
        # 100 steps of 1 ms on a million particles: 1 ns; the half second of the start is not in it.
        self.assertAlmostEqual(figures["ns_per_fluid_particle_step"], 1.0, places=6)
        self.assertEqual(figures["list_rebuilds"], 10)
        page = (self.out / "gpu-check.md").read_text(encoding="utf-8")
        self.assertIn(f"| {nccl} | skipped: needs two GPUs | 0 |", page)
        self.assertIn("NVIDIA Made-up 9000", page)
        self.assertIn("| flume 3.55 M | 1200000 | 1000000 | 0.12 s | 100 | 1 | 1000 | 99.5 | 52.6 | 10.0 | 8.5 | 86 % | 600 |", page)
        self.assertIn("| drift | 75.0 % |", page)
        models = [name for name in rows if name.startswith("model: ")]
        for word in ("states", "bed load", "current", "inlet", "surface bed", "mixture", "suspended", "pore pressure", "moving"):
            self.assertTrue(any(word in name for name in models), word)

    def test_says_that_ranks_differ(self):
        self.check("--only", "tests")
        self.assertTrue(self.rows()["ranks: surface bed"]["passed"])
        self.assertTrue(any("--ranks 3" in line for line in self.asked()))
        self.say("ranks_differ")
        self.check("--only", "tests", "--anew")
        row = self.rows()["ranks: surface bed"]
        self.assertFalse(row["passed"])
        self.assertEqual(row["why"], "ranks_surface_bed_2 differs from one rank in history.csv")

    def test_sends_by_nccl_where_there_are_two_gpus(self):
        row = "NCCL: three states in space"
        self.check("--only", "tests")
        self.assertEqual(self.rows()[row]["why"], "needs two GPUs")
        self.say("gpus", 2 * "NVIDIA Made-up 9000, 999.1, 80000\n")
        self.check("--only", "tests", "--anew")
        self.assertEqual(self.rows()[row]["why"], "the bundle was built without NCCL")
        self.assertFalse(any("nccl" in line for line in self.asked()))
        self.script(self.bundle / "bin" / "thalweg_link_nccl.so", "")
        self.check("--only", "tests", "--anew")
        self.assertTrue(self.rows()[row]["passed"])
        self.assertEqual(self.rows()[row]["why"], "")
        self.assertTrue(any("--ranks 2 --device-messages nccl" in line for line in self.asked()))
        self.say("ranks_differ")
        self.check("--only", "tests", "--anew")
        self.assertEqual(self.rows()[row]["why"], "nccl_three_states_in_space_2 differs from one rank in history.csv")

    def test_notes_every_row_at_once_and_goes_on_where_it_ended(self):
        done = self.check("--only", "tests", "--budget", "130")
        self.assertEqual(done.returncode, 3, done.stdout)
        first = self.rows()
        self.assertIn("cuda_test OnDevice", first)
        self.assertNotIn("cases against the CPU", first)  # may take 240 s
        self.assertIn("cases against the CPU", done.stdout)
        with tarfile.open(self.out / "logs.tar.gz") as tar:
            self.assertIn("logs/cuda_test-OnAGpu_OnDevice_.log", tar.getnames())
        before = len(self.asked())
        self.assertEqual(self.check("--only", "tests").returncode, 0)
        again = self.asked()[before:]
        self.assertFalse(any("OnDevice*" in line and "Steps" not in line for line in again), "it had passed")
        self.assertTrue(any("case_agreement_test" in line for line in again))
        self.check("--only", "tests", "--anew", "--budget", "130")
        self.assertEqual(len(self.rows()), len(first))

    def test_fails_where_a_test_or_a_run_fails_and_tries_it_again(self):
        self.say("tests_fail")
        done = self.check("--only", "tests", "--quick")
        self.assertEqual(done.returncode, 1)
        self.assertIn("FAILED", self.rows()["cuda_test OnDevice"]["why"])
        self.assertTrue(self.rows()["model: water"]["passed"])
        (self.fake / "tests_fail").unlink()
        self.assertEqual(self.check("--only", "tests", "--quick").returncode, 0)
        self.say("solver_fails")
        self.assertEqual(self.check("--only", "bench", "--quick").returncode, 1)
        self.assertIn("error: made up", self.rows()["flume 0.15 M"]["why"])

    def test_holds_two_runs_against_each_other_and_the_cpu(self):
        self.say("runs_differ")
        self.assertEqual(self.check("--only", "tests").returncode, 1)
        self.assertIn("two runs on the GPU differ", self.rows()["model: water"]["why"])
        (self.fake / "runs_differ").unlink()
        self.say("cpu_differs")
        self.assertEqual(self.check("--only", "tests").returncode, 1)
        self.assertIn("kinetic_energy: 1 on the GPU, 2 on the CPU", self.rows()["model: water"]["why"])

    def test_refuses_figures_of_a_busy_gpu(self):
        self.say("others", "4711, python3, 900\n")
        self.assertEqual(self.check("--only", "bench", "--quick").returncode, 1)
        self.assertIn("another process computes on the GPU: 4711", self.rows()["flume 0.15 M"]["why"])
        self.assertNotIn("figures", self.rows()["flume 0.15 M"])
        (self.fake / "others").unlink()
        self.say("used", "42\n")
        self.check("--only", "bench", "--quick")
        self.assertIn("42 % busy", self.rows()["flume 0.15 M"]["why"])
        (self.fake / "used").unlink()
        self.assertEqual(self.check("--only", "bench", "--quick").returncode, 0)

    def test_measures_both_ways_of_the_viscous_solve(self):
        self.assertEqual(self.check("--only", "bench").returncode, 0)
        self.assertEqual(self.rows()["flume 3.55 M, stored"]["figures"]["coefficients"], "stored")
        self.assertTrue(any(line.endswith(" stored") for line in self.asked()))
        self.assertTrue(any(line.endswith(" computed") for line in self.asked()))

    def test_leaves_the_flume_half_done_and_goes_on_with_it(self):
        self.say("solver_hangs")
        start = time.monotonic()
        done = self.check("--only", "flume", "--budget", "31")
        self.assertLess(time.monotonic() - start, 60)
        row = self.rows()["flume, 1 s at 2 mm"]
        self.assertIsNone(row["passed"])
        self.assertEqual(row["flow_seconds"], 0.4)
        self.assertEqual(done.returncode, 3, "not finished")
        (self.fake / "solver_hangs").unlink()
        self.assertEqual(self.check("--only", "flume").returncode, 0)
        self.assertTrue(self.rows()["flume, 1 s at 2 mm"]["passed"])
        self.assertIn("--restart latest", self.asked()[-1])


if __name__ == "__main__":
    unittest.main()
