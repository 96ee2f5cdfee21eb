"""Reads the particle files of the programs: arrays as the writer of common/io/particle_file.cpp lays them down."""

import base64
import re
import struct
import zlib

WALL, WATER, SEDIMENT = 0, 2, 3  # ParticleType of common/particles.hpp
FORMATS = {"Float32": "f", "Float64": "d", "UInt8": "B", "Int64": "q"}
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


def arrays(file, wanted):
    """The arrays of these names, as tuples of numbers; Points and Velocity hold three a particle."""
    found = {}
    for kind, name, text in ARRAY.findall(file.read_text(encoding="latin-1")):
        if name in wanted:
            plain = decoded(text)
            code = FORMATS[kind]
            found[name] = struct.unpack(f"<{len(plain) // struct.calcsize(code)}{code}", plain)
    return found
