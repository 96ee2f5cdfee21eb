#!/usr/bin/env python3
"""Writes pier.stl, the pier of this case as a CAD program would export it (binary STL, millimetres): make_pier.py FILE"""

import math
import pathlib
import struct
import sys

RADIUS = 30.0  # mm
BOTTOM, TOP = -30.0, 300.0  # mm; from below the flume's floor to above its rim
SIDES = 72  # facets leave the circle by 0.03 mm


def facets():
    """Triangles, corners counter-clockwise seen from outside."""
    ring = [(RADIUS * math.cos(2 * math.pi * k / SIDES), RADIUS * math.sin(2 * math.pi * k / SIDES))
            for k in range(SIDES)]
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        a, b, c, d = (x0, y0, BOTTOM), (x1, y1, BOTTOM), (x1, y1, TOP), (x0, y0, TOP)
        yield from ((a, b, c), (a, c, d), ((0, 0, BOTTOM), b, a), ((0, 0, TOP), d, c))


def stl():
    triangles = list(facets())
    data = b"Thalweg pier, millimetres".ljust(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        # The normal is left to the reader (0, 0, 0), which the format allows.
        data += struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *corner) for corner in triangle) + b"\0\0"
    return data


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_bytes(stl())
