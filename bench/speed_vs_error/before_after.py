#!/usr/bin/env python3
"""Compares errors and seconds before and after a change of the program: before_after.py BEFORE.csv AFTER.csv [AFTER.csv …]

Prints a table of the points (points.csv of speed_vs_error.py, or its record) that both have with the case's own numerics.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from thalweg.tables import markdown, read_table  # noqa: E402


def points(file):
    return {(row["problem"], row["spacing"]): row for row in read_table(pathlib.Path(file)) if row["changed"] == ""}


def figures(row):
    further = str(row["further"]).replace(";", ",")
    return f"{row['error']:.4g}" + (f", {further}" if further else "")


def main():
    before = points(sys.argv[1])
    after = {key: row for file in sys.argv[2:] for key, row in points(file).items()}
    rows = [[*key, old["measure"], figures(old), figures(after[key]), f"{old['cpu']:.3g}", f"{after[key]['cpu']:.3g}"]
            for key, old in before.items() if key in after and "" not in (old["error"], after[key]["error"])]
    columns = ["problem", "spacing", "measure", "before", "after", "CPU s before", "after"]
    print("\n".join(markdown(columns, rows)))


if __name__ == "__main__":
    main()
