#!/usr/bin/env python3
"""Makes the measurements of this folder again, one after the other: run_all.py THALWEG [--only NAME ...]

Each is a script of its own that can be run alone and says what it does with --help; all write to bench/results. They want
the machine to themselves for about an hour.
"""

import argparse
import pathlib
import subprocess
import sys
import time

BENCH = pathlib.Path(__file__).resolve().parent
# Name -> script, its options, and what it asks for beside the program.
MEASUREMENTS = {
    "peer": ("peer_ratio/peer_ratio.py", [], "--dualsphysics"),
    "feature-costs": ("feature_costs/feature_costs.py", [], None),
    "space": ("scaling/scaling.py", ["--part", "space"], None),
    "plane": ("scaling/scaling.py", ["--part", "plane"], None),
    "threads": ("scaling/scaling.py", ["--part", "threads"], None),
    "traffic": ("scaling/scaling.py", ["--part", "traffic"], None),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("thalweg", type=pathlib.Path, help="the program, for example build/release/bin/thalweg")
    parser.add_argument("--only", nargs="+", choices=MEASUREMENTS, default=list(MEASUREMENTS))
    parser.add_argument("--dualsphysics", type=pathlib.Path, help="folder of DualSPHysics 5.4 with its sources")
    given = parser.parse_args()
    failed = []
    for name in given.only:
        script, options, extra = MEASUREMENTS[name]
        value = getattr(given, extra.removeprefix("--")) if extra else None
        begin = time.monotonic()
        print(f"== {name}", flush=True)
        done = subprocess.run([sys.executable, BENCH / script, given.thalweg, *options, *([extra, value] if value else [])],
                              check=False)
        print(f"== {name}: {time.monotonic() - begin:.0f} s, exit status {done.returncode}", flush=True)
        if done.returncode != 0:
            failed.append(name)
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
