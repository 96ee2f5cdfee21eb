"""Particle files (docs/file-formats.md) without a library: reads the program's files and writes files that it reads."""

import base64
import re
import struct
import zlib

WALL, MOVING_WALL, WATER, SEDIMENT = range(4)  # of the array Type
FORMATS = {"Float32": "f", "Float64": "d", "UInt8": "B", "Int32": "i", "Int64": "q"}
SEAL = re.compile(r"<!-- crc32 \w+ of all above -->\n$")
ARRAY = re.compile(r'<DataArray type="(\w+)" Name="(\w+)"[^>]*>\s*([^<]*?)\s*<', re.DOTALL)


def decoded(text):
    """The bytes of an inline DataArray: a header of 64-bit sizes, then zlib blocks, each part base64."""
    blocks = struct.unpack("<Q", base64.b64decode(text[:12])[:8])[0]
    size = 8 * (3 + blocks)
    end = 4 * ((size + 2) // 3)
    header = struct.unpack(f"<{3 + blocks}Q", base64.b64decode(text[:end])[:size])
    data, plain, at = base64.b64decode(text[end:]), b"", 0
    for length in header[3:]:
        plain += zlib.decompress(data[at:at + length])
        at += length
    return plain


def encoded(plain):
    """The text of a DataArray with these bytes, in one zlib block; decoded() reads it."""
    packed = zlib.compress(plain)
    header = struct.pack("<4Q", 1, len(plain), len(plain), len(packed))
    return (base64.b64encode(header) + base64.b64encode(packed)).decode()


def numbers(kind, plain):
    """Unpacks the bytes of an array of this VTK type into a flat tuple."""
    code = FORMATS[kind]
    return struct.unpack(f"<{len(plain) // struct.calcsize(code)}{code}", plain)


def arrays(file, wanted):
    """The arrays of these names as flat tuples; "Points" are the positions, three numbers a particle [m]."""
    return {name: numbers(kind, decoded(text))
            for kind, name, text in ARRAY.findall(file.read_text(encoding="latin-1")) if name in wanted}


def stored_arrays(file):
    """The VTK type and the bytes of every array, by name; the cells' topology and what tells of the run's costs are left out."""
    return {name: (kind, decoded(text)) for kind, name, text in ARRAY.findall(file.read_text(encoding="latin-1"))
            if name not in ("connectivity", "offsets", "Case", "Arrays", "RunCounts")}


def replace_arrays(file, replacements):
    """Puts other values into arrays that the file has; their number stays. The seal goes, which would not fit any more."""
    text = file.read_text(encoding="latin-1")
    missing = set(replacements) - {name for _, name, _ in ARRAY.findall(text)}
    if missing:
        raise ValueError(f"{file}: has no array {', '.join(sorted(missing))}")

    def exchanged(match):
        kind, name, old = match.groups()
        if name not in replacements:
            return match.group()
        values = replacements[name]
        if len(values) * struct.calcsize(FORMATS[kind]) != len(decoded(old)):
            raise ValueError(f"{file}: {name} has another number of values")
        return match.group().replace(old, encoded(struct.pack(f"<{len(values)}{FORMATS[kind]}", *values)))

    file.write_text(SEAL.sub("", ARRAY.sub(exchanged, text)), encoding="latin-1")


def of_fluid(particles):
    """Numbers of the particles that are water or sediment."""
    return [i for i, kind in enumerate(particles["Type"]) if kind in (WATER, SEDIMENT)]
