"""Particle files as text, small and by hand, so that a test can spoil any part of them."""


def array(name, kind, components, values, more=""):
    """A data array of a list of numbers, row by row."""
    numbers = " ".join(str(value) for value in values)
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}"{more} format="ascii">'
            f"{numbers}</DataArray>\n")


def fact(name, kind, value):
    return array(name, kind, 1, [value], ' NumberOfTuples="1"')


class Particles:
    """Water and walls of a plane scene, two by two. Every part may be changed before text() is taken."""

    def __init__(self, spacing=0.01, count=4):
        self.count = count
        self.facts = {"TimeValue": ("Float64", 0), "Step": ("Int64", 0), "Dimension": ("Int32", 2),
                      "Spacing": ("Float64", spacing), "SmoothingLength": ("Float64", 1.5 * spacing)}
        self.points = [[spacing * (i + 0.5), 0, spacing * 0.5] for i in range(count)]
        self.id = list(range(count))
        self.type = ([0] + [2] * count)[:count]  # wall, water
        self.density = [1000.0] * count
        self.mass = [1000 * spacing**2] * count
        self.velocity = [[0, 0, 0] for _ in range(count)]

    def text(self):
        flat = lambda rows: [value for row in rows for value in row]
        facts = "".join(fact(name, kind, value) for name, (kind, value) in self.facts.items())
        data = (array("Id", "Int64", 1, self.id) + array("Type", "UInt8", 1, self.type) +
                array("Velocity", "Float32", 3, flat(self.velocity)) + array("Density", "Float32", 1, self.density) +
                array("Mass", "Float32", 1, self.mass))
        places = range(self.count)
        verts = array("connectivity", "Int64", 1, places) + array("offsets", "Int64", 1, (i + 1 for i in places))
        return ('<?xml version="1.0"?>\n'
                '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n<PolyData>\n'
                f'<FieldData>\n{facts}</FieldData>\n<Piece NumberOfPoints="{self.count}" NumberOfVerts="{self.count}" '
                'NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">\n'
                f'<PointData>\n{data}</PointData>\n<Points>\n{array("Points", "Float64", 3, flat(self.points))}</Points>\n'
                f'<Verts>\n{verts}</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n')
