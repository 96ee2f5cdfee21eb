#!/usr/bin/env python3
"""Makes the measurements of this folder again, one after the other: run_all.py THALWEG [--only NAME ...]

Each is a script of its own that can be run alone and says what it does with --help; all write to bench/records, and summary.py
takes their figures into docs/performance.md. They want the machine to themselves for about an hour.
"""

import argparse
import pathlib
import subprocess
import sys
import time

BENCH = pathlib.Path(__file__).resolve().parent


def peer_ratio(given):
    return ["peer_ratio/peer_ratio.py", given.thalweg,
            *(["--dualsphysics", given.dualsphysics] if given.dualsphysics else [])]


def scaling(part):
    return lambda given: ["scaling/scaling.py", given.thalweg, "--part", part]


# Name -> the script and its arguments.
MEASUREMENTS = {
    "micro": lambda given: ["micro/micro.py", given.thalweg.resolve().parents[1]],  # where the program was built
    "peer": peer_ratio,
    "feature-costs": lambda given: ["feature_costs/feature_costs.py", given.thalweg],
    "space": scaling("space"),
    "plane": scaling("plane"),
    "threads": scaling("threads"),
    "traffic": scaling("traffic"),
    "speed-vs-error": lambda given: ["speed_vs_error/speed_vs_error.py", given.thalweg, "--quick", "--record"],
    "gencase": lambda given: ["gencase_speed.py", given.thalweg],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("thalweg", type=pathlib.Path, help="the program, for example build/release/bin/thalweg")
    parser.add_argument("--only", nargs="+", choices=MEASUREMENTS, default=list(MEASUREMENTS))
    parser.add_argument("--dualsphysics", type=pathlib.Path, help="folder of DualSPHysics 5.4 with its sources")
    given = parser.parse_args()
    failed = []
    for name in given.only:
        script, *arguments = MEASUREMENTS[name](given)
        if not (BENCH / script).exists():
            print(f"== {name}: left out, bench/{script} is not there", flush=True)
            continue
        begin = time.monotonic()
        print(f"== {name}", flush=True)
        done = subprocess.run([sys.executable, BENCH / script, *arguments], check=False)
        print(f"== {name}: {time.monotonic() - begin:.0f} s, exit status {done.returncode}", flush=True)
        if done.returncode != 0:
            failed.append(name)
    subprocess.run([sys.executable, BENCH / "summary.py"], check=True)
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
