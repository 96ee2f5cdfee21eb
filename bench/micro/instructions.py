#!/usr/bin/env python3
"""Counts the instructions of every pair sweep's inner loop in a core module, or compares two modules:

    bench/micro/instructions.py CORE.so [OTHER.so]

CORE.so is for example build/release/bin/thalweg_core_openmp_avx512.so. An inner loop computes 16 pairs at a time with AVX-512,
8 with AVX2 and 4 with the baseline (single precision). "Function" is the code of a whole cluster around it. With two modules,
sweeps that have the same number of instructions in both are counted but not listed. Exit status: 0, or 1 if the two differ.
"""

import argparse
import pathlib
import sys

BENCH = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(BENCH.parent / "python"), str(BENCH / "micro")]

from disassembly import count, inner_loop, sweeps  # noqa: E402
from thalweg.tables import markdown  # noqa: E402

OF_WATER = ("ContinuitySweep", "MomentumSweep", "WallPressureSweep")  # all that a scene without sediment runs
OF_BEDS = ", true>"  # the same sweep with the terms of bed load


def counts(module, only_water):
    """{"3-D MomentumSweep<3, false>": the counts of its inner loop, and of the whole function}."""
    found = {}
    for dimension, body, code in sweeps(module):
        if not only_water or (body.startswith(OF_WATER) and not body.endswith(OF_BEDS)):
            found[f"{dimension}-D {body}"] = {**count(inner_loop(code)), "function": len(code)}
    if not found:
        sys.exit(f"error: {module}: has no pair sweeps; name a thalweg_core_openmp_*.so whose symbols were not stripped")
    return found


def cell(a, b, kind):
    """One number, or both where two modules differ or one has no such sweep."""
    mine, other = (str(side[kind]) if side else "-" for side in (a, b))
    return mine if mine == other else f"{mine} → {other}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("module", type=pathlib.Path)
    parser.add_argument("other", type=pathlib.Path, nargs="?")
    parser.add_argument("--water", action="store_true", help="only the sweeps that a scene without sediment runs")
    given = parser.parse_args()
    a = counts(given.module, given.water)
    b = counts(given.other, given.water) if given.other else a
    names = sorted(name for name in a.keys() | b.keys() if not given.other or a.get(name) != b.get(name))
    kinds = next(iter(a.values()))
    if names:
        rows = ([name, *(cell(a.get(name), b.get(name), kind) for kind in kinds)] for name in names)
        print("\n".join(markdown(["sweep", *kinds], rows)))
    if given.other:
        print(f"\n{len(a.keys() | b.keys()) - len(names)} sweeps equal, {len(names)} differ")
    return 1 if given.other and names else 0


if __name__ == "__main__":
    sys.exit(main())
