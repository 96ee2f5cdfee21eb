#!/usr/bin/env python3
"""Measures one problem of problems.py at some spacings, with some keys changed, and prints what was found.

    measure.py build/release/bin/thalweg standing_wave --spacing "10 mm" "5 mm" --set numerics.smoothing_ratio=2

Runs are kept below OUT and are not repeated. The case, its `set` and its spacings come from matrix.toml.
"""

import argparse
import pathlib
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from problems import PROBLEMS
from study import runs


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("thalweg", help="the program, build/release/bin/thalweg")
    arguments.add_argument("problem", choices=sorted(PROBLEMS))
    arguments.add_argument("--spacing", nargs="+", metavar="LENGTH", help='as in the case file: "5 mm"; default: those of matrix.toml')
    arguments.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="changes a key of the case; may be repeated")
    arguments.add_argument("--out", type=pathlib.Path, default="out/measure", help="where runs go (default: %(default)s)")
    given = arguments.parse_args()
    table = tomllib.loads(pathlib.Path(__file__).with_name("matrix.toml").read_text(encoding="utf-8"))
    problem = next(entry for entry in table["problem"] if entry["name"] == given.problem)
    measure = PROBLEMS[given.problem]
    for spacing in given.spacing or problem["spacings"]:
        settings = [f'numerics.spacing="{spacing}"', *problem.get("set", []), *given.set]
        name = " ".join([given.problem, spacing, *given.set])
        run = runs.Run(pathlib.Path(given.thalweg).resolve(), given.out.resolve(), ROOT / problem["case"], name, settings)
        run.compute(measure.start, postproc=given.problem == "louvain")
        found = "  ".join(f"{key} {value:.5g}" for key, value in measure.errors(run).items())
        print(f"{name}: {found}  cpu {run.cpu_seconds():.1f} s", flush=True)


if __name__ == "__main__":
    try:
        main()
    except RuntimeError as error:
        sys.exit(str(error))
