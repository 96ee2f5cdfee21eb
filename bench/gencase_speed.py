#!/usr/bin/env python3
"""Measures how fast gencase fills: bench/gencase_speed.py PROGRAM [REPEATS]

PROGRAM is thalweg-gencase. Prints a table of medians: lattice points a second while filling (reading of meshes, pre-flight,
walls, normals and closure test included, writing not), CPU seconds of all threads for that, seconds of the whole run with
its files, and the memory a particle: the slope of the peak between a coarse and a fine filling.
"""

import collections
import math
import pathlib
import re
import statistics
import struct
import subprocess
import sys
import tempfile
import time

CASES = pathlib.Path(__file__).resolve().parent.parent / "cases"
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


def write_sphere(path, rings):
    """A sphere of 2 rings (2 rings - 2) facets in binary STL."""
    def place(ring, side):
        if ring in (0, rings):  # the poles are one point each, whatever the angle
            return (0.0, 0.0, 1.0 if ring == 0 else -1.0)
        polar, around = math.pi * ring / rings, math.pi * (side % (2 * rings)) / rings
        return (math.sin(polar) * math.cos(around), math.sin(polar) * math.sin(around), math.cos(polar))
    facets = []
    for ring in range(rings):
        for side in range(2 * rings):
            a, b, c, d = place(ring, side), place(ring, side + 1), place(ring + 1, side + 1), place(ring + 1, side)
            if ring > 0:
                facets.append((*a, *c, *b))
            if ring < rings - 1:
                facets.append((*a, *d, *c))
    data = b"sphere".ljust(80) + struct.pack("<I", len(facets))
    data += b"".join(struct.pack("<12fH", 0, 0, 0, *facet, 0) for facet in facets)
    path.write_bytes(data)
    return len(facets)


def run(program, *arguments):
    """One run, timed by a process of its own, so that its figures are those of the program alone."""
    begin = time.monotonic()
    timed = ["/usr/bin/env", "python3", "-c",
             "import resource, subprocess, sys; s = subprocess.run(sys.argv[1:]).returncode; "
             "u = resource.getrusage(resource.RUSAGE_CHILDREN); "
             "print('used', u.ru_maxrss, u.ru_utime + u.ru_stime); sys.exit(s)"]
    text = subprocess.run([*timed, program, *arguments], check=True, capture_output=True, text=True).stdout
    seconds = time.monotonic() - begin
    points, filling = re.search(r"(\d+) lattice points in ([\d.]+) s", text).groups()
    particles = int(re.search(r"(\d+) particles; the solver", text).group(1))
    peak, cpu = re.search(r"used (\d+) ([\d.]+)", text).groups()
    return Run(int(points), float(filling), seconds, particles, 1024 * int(peak), float(cpu))


def measure(name, program, repeats, coarse, fine):
    """A row of the table."""
    checks = [run(program, *fine, "--check") for _ in range(repeats)]
    runs = [run(program, *fine) for _ in range(repeats)]
    small = run(program, *coarse)
    filling = statistics.median(r.filling for r in checks)
    cpu = statistics.median(r.cpu for r in checks)
    whole = statistics.median(r.seconds for r in runs)
    slope = (runs[0].peak - small.peak) / (runs[0].particles - small.particles)
    print(f"| {name} | {runs[0].points} | {runs[0].particles} | {filling:.2f} | {runs[0].points / filling / 1e6:.1f} "
          f"| {cpu:.2f} | {whole:.1f} | {slope:.0f} |", flush=True)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        facets = write_sphere(work / "ball.stl", 159)
        print("| scene | lattice points | particles | filling, s | million points a second | CPU s | whole run, s "
              "| bytes a particle |\n|---|---|---|---|---|---|---|---|", flush=True)
        at = lambda spacing: ["--set", f"numerics.spacing={spacing}"]
        out = ["--out", str(work / "out")]
        flume = str(CASES / "louvain3d")
        measure("louvain3d at 2 mm, boxes", program, repeats, [flume, *out, *at("4 mm")], [flume, *out, *at("2 mm")])
        (work / "case.toml").write_text(SCENE.format(spacing="1 cm"))
        ball = str(work)
        measure(f"ball of {facets} facets", program, repeats, [ball, *out, *at("20 mm")], [ball, *out, *at("12 mm")])
        pier = str(CASES / "pier")
        measure("pier at 4 mm, mesh among walls", program, repeats, [pier, *out, *at("8 mm")], [pier, *out, *at("4 mm")])


if __name__ == "__main__":
    main()
