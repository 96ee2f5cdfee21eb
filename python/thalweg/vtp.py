"""VTK XML PolyData files as NumPy arrays: the particle files and surfaces of our programs (docs/file-formats.md)."""

import xml.etree.ElementTree
from dataclasses import dataclass, field

import numpy

from thalweg.faults import InputError
from thalweg.particle_file import decoded

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int8": "<i1", "UInt8": "<u1", "Int16": "<i2", "UInt16": "<u2", "Int32": "<i4", "UInt32": "<u4",
         "Int64": "<i8", "UInt64": "<u8"}
CELLS = ("Verts", "Lines", "Strips", "Polys")


@dataclass
class PolyData:
    """A file's contents, SI units.

    points: (n, 3) [m]. arrays: name → (n,) or (n, components), one entry a point. field: name → array of the whole file, or text.
    cells: Verts, Lines, Strips, Polys → list of arrays with the numbers of each cell's points.
    """
    points: numpy.ndarray
    arrays: dict
    field: dict
    cells: dict = field(default_factory=dict)

    def __getitem__(self, name):
        if name not in self.arrays:
            raise KeyError(f"there is no array {name}; there are {', '.join(sorted(self.arrays))}")
        return self.arrays[name]

    @property
    def time(self):
        """[s] of the scene."""
        return float(self.field["TimeValue"][0])

    @property
    def triangles(self):
        """(m, 3) numbers of points: the polygons of a surface, as fans of triangles."""
        fans = [(cell[0], a, b) for cell in self.cells.get("Polys", []) for a, b in zip(cell[1:], cell[2:])]
        return numpy.array(fans, dtype=numpy.int64).reshape(-1, 3)


def read_vtp(file):
    """Reads a .vtp file with inline arrays, ASCII or binary with zlib and 64-bit headers. Raises InputError naming the file."""
    try:
        root = xml.etree.ElementTree.parse(file).getroot()
        if root.get("type") != "PolyData":
            raise ValueError("it is no PolyData")
        piece = root.find("PolyData/Piece")
        points = _arrays(piece.find("Points"), root)["Points"]
        arrays = _arrays(piece.find("PointData"), root)
        whole = _arrays(root.find("PolyData/FieldData"), root)
        cells = {kind: _cells(piece.find(kind), root) for kind in CELLS if piece.find(kind) is not None}
        if any(len(values) != len(points) for values in arrays.values()):
            raise ValueError("an array has another length than the points")
    except OSError as error:
        raise InputError(f"{file}: cannot be read ({error.strerror}); give a file that is there") from error
    except Exception as error:  # whatever a damaged file may break in the decoders
        raise InputError(f"{file}: is no .vtp file of our programs ({str(error)[:80]}); write it again") from error
    return PolyData(points, arrays, whole, cells)


def _arrays(parent, root):
    if parent is None:
        return {}
    return {each.get("Name"): _values(each, root) for each in parent if each.tag in ("DataArray", "Array")}


def _values(node, root):
    kind, components = node.get("type"), int(node.get("NumberOfComponents", "1"))
    if node.get("format") == "ascii":
        values = numpy.array((node.text or "").split(), dtype=TYPES.get(kind, "<i1"))
    elif node.get("format") == "binary":
        if root.get("compressor") != "vtkZLibDataCompressor" or root.get("header_type") != "UInt64" or root.get("byte_order") != "LittleEndian":
            raise ValueError("arrays are not zlib with 64-bit headers")
        values = numpy.frombuffer(decoded((node.text or "").strip()), dtype=TYPES.get(kind, "<i1"))
    else:
        raise ValueError(f"format {node.get('format')} is not read")
    if kind == "String":
        return values.tobytes().rstrip(b"\0").decode("utf-8")
    return values.reshape(-1, components) if components > 1 else values


def _cells(node, root):
    found = _arrays(node, root)
    if not len(found.get("offsets", ())):
        return []
    return numpy.split(found["connectivity"], found["offsets"][:-1])
