#!/usr/bin/env python3
"""Measures how fast gencase fills: bench/gencase_speed.py THALWEG

Writes a table of medians to bench/records/gencase-speed.md: lattice points a second while filling (with reading of meshes,
pre-flight checks, walls, normals and closure test, without writing), CPU seconds of all threads for that, seconds of the whole
run with its files, and the memory a particle: the slope of the peak between a coarse and a fine filling.
"""

import argparse
import collections
import math
import pathlib
import re
import statistics
import struct
import tempfile
import time

from study.costs import overrides
from study.origin import ROOT, command_line
from thalweg.programs import call
from study.record import Record, common_arguments

CASES = ROOT / "cases"
Run = collections.namedtuple("Run", "points filling seconds particles peak cpu")
SCENE = """
[case]
name = "ball"
dimension = 3
[domain]
from = ["-1.2 m", "-1.2 m", "-1.2 m"]
to = ["1.2 m", "1.2 m", "1.2 m"]
[[shape]]
name = "ball"
kind = "mesh"
role = "water"
file = "ball.stl"
[numerics]
spacing = "{spacing}"
[output]
end = "1 s"
"""


def facet_count(rings):
    return 2 * rings * (2 * rings - 2)


def write_sphere(path, rings):
    """Writes a unit sphere as binary STL, facet by facet, and returns their number.

    Little memory is used, because the peak of a program that this script starts is never less than the script's own.
    """
    def point(ring, side):
        if ring in (0, rings):  # the poles are one point each, whatever the angle
            return (0.0, 0.0, 1.0 if ring == 0 else -1.0)
        polar, around = math.pi * ring / rings, math.pi * (side % (2 * rings)) / rings
        return (math.sin(polar) * math.cos(around), math.sin(polar) * math.sin(around), math.cos(polar))
    with path.open("wb") as file:
        file.write(b"sphere".ljust(80) + struct.pack("<I", facet_count(rings)))
        for ring in range(rings):
            for side in range(2 * rings):
                a, b, c, d = point(ring, side), point(ring, side + 1), point(ring + 1, side + 1), point(ring + 1, side)
                for corners in ([(a, c, b)] if ring > 0 else []) + ([(a, d, c)] if ring < rings - 1 else []):
                    file.write(struct.pack("<12fH", 0, 0, 0, *corners[0], *corners[1], *corners[2], 0))
    return facet_count(rings)


def run(thalweg, *arguments):
    """One filling."""
    begin = time.monotonic()
    used = call(thalweg, "gencase", *arguments)
    seconds = time.monotonic() - begin
    points, filling = re.search(r"(\d+) lattice points in ([\d.]+) s", used.text).groups()
    particles = int(re.search(r"(\d+) particles; the solver", used.text).group(1))
    return Run(int(points), float(filling), seconds, particles, used.peak, used.cpu)


def measured(given, name, case, work, coarse, fine):
    """A row of the table."""
    def at(spacing, *options):
        return run(given.thalweg, case, "--out", work / "out", *overrides([f"numerics.spacing={spacing}"]), *options)

    checks = [at(fine, "--check") for _ in range(given.repeats)]
    runs = [at(fine) for _ in range(given.repeats)]
    small = at(coarse)
    filling = statistics.median(r.filling for r in checks)
    slope = (runs[0].peak - small.peak) / (runs[0].particles - small.particles)
    return [name, runs[0].points, runs[0].particles, filling, runs[0].points / filling / 1e6,
            statistics.median(r.cpu for r in checks), statistics.median(r.seconds for r in runs), f"{slope:.0f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    common_arguments(parser, 3)
    parser.add_argument("--coarser", type=float, default=1, help="factor on all spacings, for a trial (default: %(default)g)")
    given = parser.parse_args()

    def length(millimetres):
        return f"{given.coarser * millimetres:g} mm"

    record = Record("gencase-speed", "How fast gencase fills", command_line("gencase_speed.py"))
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        facets = write_sphere(work / "ball.stl", 159)
        (work / "case.toml").write_text(SCENE.format(spacing="1 cm"), encoding="utf-8")
        rows = [measured(given, name, case, work, length(coarse), length(fine))
                for name, case, coarse, fine in (("louvain3d, boxes", CASES / "louvain3d", 4, 2),
                                                 (f"ball of {facets} facets", work, 20, 12),
                                                 ("pier, mesh among walls", CASES / "pier", 8, 4))]
    record.table(f"Medians of {given.repeats} runs",
                 ["scene", "lattice points", "particles", "filling, s", "million points a second", "CPU s", "whole run, s",
                  "bytes a particle"], rows)
    record.write(given.records)


if __name__ == "__main__":
    main()
