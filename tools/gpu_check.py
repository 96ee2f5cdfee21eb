#!/usr/bin/env python3
"""Checks and measures the solver on the GPU of this machine, in one go.

usage: tools/gpu-check [--bundle DIR] [--out DIR] [--skip-flume] [--quick]

Needs the folder of the target `bundle` (default: the one this script lies in, else build/release/bundle) and nothing else:
    cmake --preset release && cmake --build --preset release --target bundle
It runs, in this order,
  tests       the backend's tests on the GPU: verbs, steps against the CPU, restart, creep
  agreement   200 steps of whole cases against the CPU, particle by particle, and conservation
  sanitizer   compute-sanitizer's memcheck and racecheck on a tiny scene, where that tool is
  benchmark   the 3-D flume with 0.1, 1, 3.09 and 20 million particles: nanoseconds per particle-step, pairs a second,
              share of every heading, bytes a particle
  flume       the paper's run, 3.09 million particles, 1 s of the flow
and leaves gpu-check.json, gpu-check.md and the logs in --out. Exit status: 0 all passed, 1 something failed, 2 no GPU.
"""

import argparse
import csv
import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import time

# Fluid and wall particles of cases/louvain3d together, by spacing [m].
SIZES = [("0.1 M", "6.6 mm", 400), ("1 M", "2.95 mm", 200), ("3.09 M", "2 mm", 100), ("20 M", "1.05 mm", 20)]


def find_bundle(given):
    here = pathlib.Path(__file__).resolve().parent
    for folder in filter(None, (given, here, here.parent / "build" / "release" / "bundle")):
        if (pathlib.Path(folder) / "bin" / "thalweg-solver").exists():
            return pathlib.Path(folder).resolve()
    sys.exit("error: no bundle found; build the target `bundle` or name its folder with --bundle")


def run(command, log, timeout=None, **environment):
    """Exit status and wall seconds of a command; its output goes to a file."""
    start = time.monotonic()
    with open(log, "w", encoding="utf-8") as output:
        output.write("$ " + " ".join(map(str, command)) + "\n")
        output.flush()
        try:
            status = subprocess.run(command, stdout=output, stderr=subprocess.STDOUT, timeout=timeout,
                                    env={**os.environ, **environment}).returncode
        except subprocess.TimeoutExpired:
            status = "timeout"
    return status, time.monotonic() - start


def text_of(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=60).stdout.strip()
    except (OSError, subprocess.TimeoutExpired):
        return ""


def table(file):
    """quantity → value of a run's summary.csv, heading → seconds of its timing.csv."""
    with open(file, encoding="utf-8") as rows:
        return {row[0]: row[1] for row in csv.reader(rows)}


def fill(bundle, case, folder, log, *settings):
    overrides = [word for s in settings for word in ("--set", s)]
    return run([bundle / "bin" / "thalweg-gencase", bundle / "cases" / case, "--out", folder, *overrides], log)[0]


def solve(bundle, folder, log, *options, wrap=(), timeout=None):
    return run([*wrap, bundle / "bin" / "thalweg-solver", folder, "--backend", "cuda", *options], log, timeout)


def sanitizer(bundle, out):
    tool = shutil.which("compute-sanitizer") or "/usr/local/cuda/bin/compute-sanitizer"
    if not os.path.exists(tool):
        return {"skipped": "compute-sanitizer is not on this machine"}
    folder = out / "tiny"
    fill(bundle, "louvain", folder, out / "tiny-gencase.log", 'numerics.spacing="20 mm"', "compare.times=[]")
    result = {}
    for check in ("memcheck", "racecheck"):
        wrap = (tool, "--tool", check, "--error-exitcode", "99")
        result[check] = solve(bundle, folder, out / f"{check}.log", "--until", "5 ms", wrap=wrap, timeout=400)[0]
    return result


def benchmark(bundle, out, sizes):
    results = []
    for name, spacing, steps in sizes:
        folder = out / f"flume-{name.replace(' ', '')}"
        row = {"size": name, "spacing": spacing}
        results.append(row)
        row["gencase"] = fill(bundle, "louvain3d", folder, out / f"{folder.name}-gencase.log",
                              f'numerics.spacing="{spacing}"', "compare.times=[]")
        if row["gencase"] != 0:
            continue
        for mode, options in (("plain", ()), ("profile", ("--profile",))):
            log = out / f"{folder.name}-{mode}.log"
            row[mode], seconds = solve(bundle, folder, log, "--benchmark", str(steps), *options, timeout=300)
            if row[mode] != 0:
                continue
            summary = table(folder / "summary.csv")
            stepped = float(summary["wall_seconds"])
            rate = float(summary["fluid_particles"]) * float(summary["steps_since_restart"]) / stepped
            row[mode + "_figures"] = {
                "particles": int(summary["particles"]), "fluid_particles": int(summary["fluid_particles"]),
                "steps": int(summary["steps_since_restart"]), "wall_seconds": stepped, "program_seconds": seconds,
                "fluid_particle_steps_per_second": rate, "ns_per_fluid_particle_step": 1e9 / rate,
                "neighbours_mean": float(summary["neighbours_mean"]),
                "bytes_per_particle": float(summary["bytes_per_particle"]),
                "viscous_iterations_per_step": float(summary["viscous_iterations_per_step"]),
                "headings": {k: float(v) for k, v in table(folder / "timing.csv").items() if k != "heading"},
            }
        shutil.rmtree(folder / "snapshots", ignore_errors=True)
    return results


def flume(bundle, out):
    folder = out / "flume-1s"
    status = fill(bundle, "louvain3d", folder, out / "flume-1s-gencase.log", 'numerics.spacing="2 mm"')
    if status != 0:
        return {"gencase": status}
    status, seconds = solve(bundle, folder, out / "flume-1s.log", timeout=1500)
    result = {"status": status, "program_seconds": seconds}
    if (folder / "summary.csv").exists():
        result["summary"] = table(folder / "summary.csv")
    return result


def report(result):
    lines = ["# The solver on a GPU", "", f"{result['device']}, driver {result['driver']}; {result['when']}; "
             f"`tools/gpu-check`, code {result['code']}", "", "| check | outcome |", "|---|---|"]
    for check in ("tests", "agreement", "sanitizer"):
        lines.append(f"| {check} | {result.get(check, 'not run')} |")
    lines += ["", "| particles | fluid | steps | ns per fluid particle-step | M fluid particle-steps/s | G pairs/s in all "
              "sweeps | neighbours | CG iterations | B/particle |", "|---|---|---|---|---|---|---|---|---|"]
    for row in result.get("benchmark", []):
        f = row.get("plain_figures")
        if not f:
            lines.append(f"| {row['size']} | failed: {row} |")
            continue
        sweeps = 2 + 1 + f["viscous_iterations_per_step"] * 0.5  # rates, forces, coefficients; the solve sees half
        pairs = f["fluid_particle_steps_per_second"] * f["neighbours_mean"] * sweeps
        lines.append(f"| {f['particles']} | {f['fluid_particles']} | {f['steps']} | {f['ns_per_fluid_particle_step']:.3g} "
                     f"| {f['fluid_particle_steps_per_second'] / 1e6:.4g} | {pairs / 1e9:.3g} | "
                     f"{f['neighbours_mean']:.1f} | {f['viscous_iterations_per_step']:.1f} | {f['bytes_per_particle']:.0f} |")
    for row in result.get("benchmark", []):
        f = row.get("profile_figures")
        if not f:
            continue
        total = sum(f["headings"].values())
        lines += ["", f"Shares at {row['size']} (each heading waited for):", "", "| heading | share |", "|---|---|"]
        lines += [f"| {k} | {100 * v / total:.1f} % |" for k, v in sorted(f["headings"].items(), key=lambda kv: -kv[1])]
    if "flume" in result:
        lines += ["", f"The paper's flume, 1 s at 2 mm: {result['flume']}"]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bundle")
    parser.add_argument("--out", default="gpu-check")
    parser.add_argument("--quick", action="store_true", help="the two small sizes of the benchmark only, no flume")
    parser.add_argument("--skip-flume", action="store_true")
    arguments = parser.parse_args()
    bundle = find_bundle(arguments.bundle)
    out = pathlib.Path(arguments.out).resolve()
    out.mkdir(parents=True, exist_ok=True)
    device = text_of(["nvidia-smi", "--query-gpu=name,driver_version,memory.total", "--format=csv,noheader"])
    if not device:
        print("error: no NVIDIA GPU here (nvidia-smi lists none); run this where one is", file=sys.stderr)
        return 2

    name, driver = device.splitlines()[0].split(", ")[:2]
    result = {"device": name, "driver": driver, "host": platform.processor() or platform.machine(),
              "when": time.strftime("%Y-%m-%d"),
              "code": text_of([bundle / "bin" / "thalweg-solver", "--version"])}

    def note(check, outcome):
        result[check] = outcome
        print(f"{check}: {outcome}", flush=True)
        (out / "gpu-check.json").write_text(json.dumps(result, indent=1))
        (out / "gpu-check.md").write_text(report(result))

    cases = {"THALWEG_CASES": str(bundle / "cases"), "THALWEG_TEST_BACKEND": "cuda"}
    note("tests", run([bundle / "bin" / "cuda_test"], out / "tests.log", 600)[0])
    note("agreement", run([bundle / "bin" / "case_agreement_test"], out / "agreement.log", 600, **cases)[0])
    note("sanitizer", sanitizer(bundle, out))
    note("benchmark", benchmark(bundle, out, SIZES[:2] if arguments.quick else SIZES))
    if not arguments.quick and not arguments.skip_flume:
        note("flume", flume(bundle, out))

    good = result["tests"] == 0 and result["agreement"] == 0
    good = good and all(v == 0 for k, v in result["sanitizer"].items() if k != "skipped")
    good = good and all(row.get("plain") == 0 for row in result["benchmark"])
    good = good and result.get("flume", {"status": 0}).get("status") == 0
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
