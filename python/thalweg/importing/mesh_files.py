"""Triangles of STL files and of legacy VTK files (ASCII or binary polydata), and STL files of triangles. Lengths as in the file."""

import math
import re
import struct

MOST_TRIANGLES = 2_000_000


def read_mesh(file):
    """Triangles of a mesh file as triples of points; None for a kind or content that is not read here."""
    content = file.read_bytes()
    try:
        if content.startswith(b"# vtk DataFile"):
            return _legacy_vtk(content)
        return _stl(content) if file.suffix.lower() == ".stl" else _ascii_ply(content) if file.suffix.lower() == ".ply" else None
    except (ValueError, IndexError, struct.error, UnicodeError):
        return None


def _stl(content):
    count = struct.unpack("<I", content[80:84])[0] if len(content) >= 84 else 0
    if len(content) == 84 + 50 * count and count:
        if count > MOST_TRIANGLES:
            return None
        return [tuple(zip(*[iter(struct.unpack_from("<9f", content, 84 + 50 * i + 12))] * 3)) for i in range(count)]
    numbers = [float(word) for found in re.finditer(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", content, re.IGNORECASE) for word in found.groups()]
    points = list(zip(*[iter(numbers)] * 3))
    return list(zip(*[iter(points)] * 3)) or None


def _ascii_ply(content):
    head, _, body = content.decode("ascii").partition("end_header")
    if "format ascii" not in head:
        return None
    points, faces = (int(re.search(rf"element {name} (\d+)", head).group(1)) for name in ("vertex", "face"))
    lines = body.strip().splitlines()
    vertices = [tuple(map(float, line.split()[:3])) for line in lines[:points]]
    polygons = [[int(word) for word in line.split()[1:1 + int(line.split()[0])]] for line in lines[points:points + faces]]
    return _fans(vertices, polygons)


def _fans(points, polygons):
    return [(points[p[0]], points[a], points[b]) for p in polygons for a, b in zip(p[1:], p[2:])]


def _legacy_vtk(content):
    head = content[:400].split(b"\n")
    binary = b"BINARY" in head[2].upper()
    if b"POLYDATA" not in content[:600].upper():
        return None
    found = re.search(rb"POINTS\s+(\d+)\s+(\w+)\s*?\n", content)
    count, kind = int(found.group(1)), found.group(2).decode()
    cells = re.search(rb"\nPOLYGONS\s+(\d+)\s+(\d+)\s*?\n", content)
    polygons, size = int(cells.group(1)), int(cells.group(2))
    if binary:
        code = {"float": "f", "double": "d"}[kind]
        numbers = struct.unpack_from(f">{3 * count}{code}", content, found.end())
        indices = struct.unpack_from(f">{size}i", content, cells.end())
    else:
        numbers = list(map(float, content[found.end():].split(None, 3 * count)[:3 * count]))
        indices = list(map(int, content[cells.end():].split(None, size)[:size]))
    points, faces, at = list(zip(*[iter(numbers)] * 3)), [], 0
    for _ in range(polygons):
        faces.append(indices[at + 1:at + 1 + indices[at]])
        at += 1 + indices[at]
    return _fans(points, faces)


def stl(triangles, name):
    """The bytes of a binary STL file."""
    parts = [f"thalweg import: {name}".encode()[:80].ljust(80), struct.pack("<I", len(triangles))]
    for a, b, c in triangles:
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        normal = [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]
        length = math.sqrt(sum(n * n for n in normal)) or 1.0
        parts.append(struct.pack("<12fH", *(n / length for n in normal), *a, *b, *c, 0))
    return b"".join(parts)
