#!/usr/bin/env python3
"""Bad particle files, series, tables and surveys, each of which a program refuses with status 2, one line of at most 300
characters, in less than 2 s and 300 MB: bad_files_test.py THALWEG FOLDER"""

import base64
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import time
import unittest
import zlib

import coarse_louvain as case
from vtp_text import Particles

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))
TESTS = pathlib.Path(__file__).resolve().parents[1]
LONGEST, SLOWEST, LARGEST = 300, 2.0, 300e6  # [characters], [s], [bytes]


def stored(numbers, kind="d", header="<Q", announced=None):
    data = struct.pack(f"<{len(numbers)}{kind}", *numbers)
    return base64.b64encode(struct.pack(header, len(data) if announced is None else announced) + data).decode()


def packed(data, blocks=1, block=32768, last=None, size=None):
    """An array's compressed bytes with the header that is asked for."""
    body = zlib.compress(data)
    sizes = [size if size is not None else len(body)] * min(blocks, 100)
    head = struct.pack(f"<{3 + len(sizes)}Q", blocks, block, len(data) if last is None else last, *sizes)
    return (base64.b64encode(head) + base64.b64encode(body)).decode()


GOOD = Particles().text()
POINTS = re.search(r"<Points>\n<DataArray.*\n", GOOD).group(0)


def points(attributes, contents):
    return POINTS, f"<Points>\n<DataArray {attributes}>{contents}</DataArray>\n"


def compressed(contents):
    """The good file, compressed by name, with other points; its arrays in text stay as they are."""
    other = points('type="Float64" Name="Points" NumberOfComponents="3" format="binary"', contents)
    return GOOD.replace('header_type="UInt64"', 'header_type="UInt64" compressor="vtkZLibDataCompressor"').replace(*other)


PLACES = struct.pack("<12d", *range(12))
WORD = 'type="Float64" Name="Points" NumberOfComponents="3" format='

# The structure: a replacement in the good file, or a whole file; and a word of the message.
STRUCTURE = [
    ("", "is not complete XML"), ("x,y,z\n1,2,3\n", "is not complete XML"), (GOOD[:700], "is not complete XML"),
    (GOOD + "<a/>", "is not complete XML"), (GOOD.replace("</Piece>", "</Peace>"), "is not complete XML"),
    ('<!DOCTYPE a [<!ENTITY b "' + 99 * "b" + '"><!ENTITY c "&b;&b;&b;">]><VTKFile>&c;</VTKFile>', "document type"),
    (60_000 * "<a>", "nested deeper"), ("<a>" + 210_000 * "<b/>" + "</a>", "more than 200000 elements"),
    ("<a " + " ".join(f'b{n}="1"' for n in range(99)) + "/>", "64 attributes"),
    (("VTKFile type", "VTKFile a='1' typ"), "holds a "), (("PolyData\" version", "UnstructuredGrid\" version"), "holds a"),
    (GOOD.replace("VTKFile", "File"), "no file of VTK"), (("LittleEndian", "MiddleEndian"), "byte order"),
    (('header_type="UInt64"', 'header_type="UInt16"'), "header type"),
    (('header_type="UInt64"', 'header_type="UInt64" compressor="vtkGZip"'), "compressed with the unknown"),
    (("<PolyData>", '<PolyData TimeValues="0 1">'), "several times"), (("<FieldData>", "<Fields><FieldData>"), "XML"),
    (("<Piece ", "<Piece><Inner/></Piece><Piece "), "has no place here"), (("<Verts>", "<Cells>"), "XML"),
    (('NumberOfPoints="4"', 'NumberOfPoints="-5"'), "is no number"), (('NumberOfPoints="4"', 'NumberOfPoints="9e9"'), "is no number"),
    (('NumberOfPoints="4"', 'NumberOfPoints="99999999999999999999"'), "is no number"),
    (('NumberOfPoints="4"', 'NumberOfPoints="1000000000"'), "holds 4 numbers"), (('NumberOfPoints="4"', 'NumberOfPoints="2"'), "holds 4"),
    (('NumberOfVerts="4"', 'NumberOfVerts="3"'), "3 cells announced"), (('NumberOfPolys="0"', 'NumberOfPolys="7"'), "announces Polys"),
    (('NumberOfLines="0"', 'NumberOfLines="-1"'), "is no number"),
    (('type="Float64" Name="Points"', 'type="Int12" Name="Points"'), "unknown type"), (('type="UInt8"', 'type=""'), "unknown type"),
    (('type="Float64" Name="Points"', 'type="String" Name="Points"'), "texts stand in <Array>"),
    (('Name="Density" NumberOfComponents="1"', 'Name="Density" NumberOfComponents="0"'), "no components"),
    (('Name="Density" NumberOfComponents="1"', 'Name="Density" NumberOfComponents="-1"'), "is no number"),
    (('Name="Density" NumberOfComponents="1"', 'Name="Density" NumberOfComponents="2000000000"'), "is no number"),
    (('Name="Density" NumberOfComponents="1"', 'Name="Density" NumberOfComponents="3"'), "it needs 4 times 3"),
    (('Name="Density"', 'Name=""'), "has no name"), (('Name="Density"', 'Name="Mass"'), "two arrays are named"),
    (('Name="Density" NumberOfComponents="1"', 'Name="' + 9000 * "D" + '" NumberOfComponents="3"'), "it needs 4 times 3"),
    (('Name="Density"', 'TimeStep="1" Name="Density"'), "several times"),
    (points(WORD + '"ascii"', "1 2 3"), "holds 3 numbers"), (points('type="Float64" Name="Points" format="ascii"', "1 2"), "three coordinates"),
    (points(WORD + '"binary"', "!!!!"), "announces more bytes"), (points(WORD + '"binary"', "AAAA"), "announces more bytes"),
    (points(WORD + '"binary"', stored(range(12), announced=2**63)), "announces more bytes"),
    (points(WORD + '"binary"', stored(range(12), announced=2**20)), "announces more bytes"),
    (points(WORD + '"binary"', stored(range(11))), "holds 11 numbers"), (points(WORD + '"appended" offset="0"', ""), "nothing is"),
    (points(WORD + '"raw"', ""), "unknown format"), (("<Points>", "<Points></Points><Points>"), "needs one array"),
    (compressed(packed(PLACES, blocks=2**61)), "more blocks"), (compressed(packed(PLACES, blocks=9)), "announces more bytes"),
    (compressed(packed(PLACES, block=2**40)), "impossible sizes"), (compressed(packed(PLACES, last=2**20)), "impossible sizes"),
    (compressed(packed(PLACES, size=2**50)), "announces more bytes"), (compressed(packed(PLACES, last=90)), "cannot be decompressed"),
    (compressed(packed(PLACES)[:-24] + 24 * "A"), "cannot be decompressed"),
    (compressed(packed(PLACES, blocks=5, block=2**25, last=0, size=4)), "more than 40 times"),
    (("0 1 2 3</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\"", "0 1 2 9</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\""), "a corner is point 9"),
    (("0 1 2 3</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\"", "0 1 2 -3</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\""), "a corner is point -3"),
    (("1 2 3 4</DataArray>", "1 3 2 4</DataArray>"), "do not rise"), (("1 2 3 4</DataArray>", "1 2 3 9</DataArray>"), "have 9 corners"),
    (('Name="connectivity"', 'Name="offsets"'), "once"), (('type="Int64" Name="offsets"', 'type="Float64" Name="offsets"'), "whole numbers"),
    (('Name="Id"', 'Name="Number"'), "no point array Id"), (('Name="Type"', 'Name="Kind"'), "no point array Type"),
    (('Name="Velocity" NumberOfComponents="3"', 'Name="Velocity" NumberOfComponents="1"'), "it needs 4 times 1"),
    ((TESTS / "fuzz/inputs/vtp/cell_data_checksum.vtp").read_text(), "cannot be decompressed"),
    ((TESTS / "fuzz/inputs/vtp/cell_data_number_too_large.vtp").read_text(), 'holds "24294967296", which is no number of the type Int32'),
    (points(WORD.replace("Float64", "Float32") + '"ascii"', "0 0 0 1e300 0 0 0 0 1 1 0 1"), "no number of the type Float32"),
    (GOOD + "<!-- crc32 00000000 of all above -->\n", "is damaged"),
    (GOOD.replace("</PolyData>\n</VTKFile>", '</PolyData>\n<AppendedData encoding="odd">_</AppendedData></VTKFile>'), "encoding"),
    (GOOD.replace("</PolyData>\n</VTKFile>", '</PolyData>\n<AppendedData encoding="raw">abc</AppendedData></VTKFile>'), "underscore"),
]


def changed(change):
    particles = Particles()
    change(particles)
    return particles.text()


def put(name, index, value):
    return lambda p: getattr(p, name).__setitem__(index, value)


def set_fact(name, kind, value):
    return lambda p: p.facts.__setitem__(name, (kind, value))


# Contents, as the solver reads them.
CONTENTS = [
    (put("points", 1, ["nan", 0, 0.1]), "not finite"), (put("points", 1, ["inf", 0, 0.1]), "not finite"),
    (put("points", 1, ["1e30", 0, 0.1]), "from the origin"), (put("points", 2, [0.015, 0, 0.005]), "in the place of particle"),
    (lambda p: p.points.__setitem__(slice(1, 3), [[0.015, 0.3, 0.005], [0.025, 0, 0.015]]), "several y"), (put("id", 2, 1), "two particles have the id 1"), (put("id", 2, -4), "has the id -4"), (put("density", 2, "heavy"), "which is no number"),
    (put("type", 1, 9), "array Type holds 9"), (lambda p: setattr(p, "type", [0, 0, 1, 0]), "neither water nor sediment"),
    (put("mass", 2, "nan"), "its mass"), (put("mass", 2, -1), "its mass"), (put("mass", 2, 0), "its mass"),
    (put("density", 1, "inf"), "its density"), (put("density", 1, 0), "its density"), (put("velocity", 1, ["nan", 0, 0]), "its velocity"),
    (set_fact("TimeValue", "Float64", -1), "TimeValue"), (set_fact("TimeValue", "Float64", "nan"), "TimeValue in the field data is no finite number"),
    (set_fact("TimeValue", "Float64", 0.1), "no step has been taken"), (set_fact("Step", "Int64", -7), "Step"),
    (set_fact("Dimension", "Int32", 3), "dimensions"), (set_fact("Dimension", "Int32", 7), "Dimension"),
    (set_fact("Spacing", "Float64", "nan"), "Spacing in the field data is no finite number"), (set_fact("Spacing", "Float64", -0.01), "Spacing"),
    (set_fact("Spacing", "Float64", 0.02), "spacing"), (lambda p: p.facts.pop("Spacing"), "Spacing"),
    (set_fact("NumberOfParticles", "Int64", 8), "holds 4 particles, and 8 were written"),
    (set_fact("LatticeNode", "Float64", 1), "LatticeNode"), (lambda p: p.__init__(count=0), "no particles"),
]

SERIES = [
    ("", "XML"), ("time,file\n", "XML"), ("<VTKFile>", "XML"), ("<VTKFile/>", "no Collection"), (60_000 * "<Collection>", "nested"),
    ("<!DOCTYPE a><VTKFile/>", "document type"),
    *((f"<VTKFile><Collection><DataSet {attributes}/></Collection></VTKFile>", text) for attributes, text in (
        ('file="a"', "time"), ('timestep="0"', "names no file"), ('timestep="nan" file="a"', "time"), ('timestep="inf" file="a"', "time"),
        ('timestep="1e999" file="a"', "time"), ('timestep="0 s" file="a"', "time"), ('timestep="1,5" file="a"', "time"), ('timestep="' + 9000 * "1" + 'x" file="a"', "time"))),
]

# Profiles given to --compare.
TABLES = [
    ("", "no heading"), ("0,1\n2,3\n", "no heading"), ("# a comment\n", "no heading"), ("bed [m]\n1\n", 'no column "x"'),
    ("x [mm]\n1\n", "is not in m"), ("x\n1\n", "is not in m"), ("x [m],x [m]\n1,2\n", "twice"), ("x [m],grass [m]\n1,2\n", "unknown column"),
    ("x [m],bed [m]\n1\n", "1 cells"), ("x [m],bed [m]\n1,2,3\n", "3 cells"), ("x [m]\n1\n1\n", "does not increase"), ("x [m]\n2\n1\n", "does not increase"),
    ("x [m],bed [m]\n,1\n", "x is missing"), ("x [m]\nnan\n", "is no number"), ("x [m]\ninf\n", "is no number"), ("x [m]\n1e999\n", "is no number"),
    ("x [m];bed [m]\n0,5;1\n", "decimal comma"), ("x [m],bed [m]\n1 2,3\n", "is no number"), ('x [m],bed [m]\n"1,2\n', "quotes"), ("x [m]\n0x10\n", "is no number"),
    ("x [m]\n" + 5_000_000 * "9" + "z\n", "is no number"), (5_000_000 * "a" + ",b\n1,2\n", 'no column "x"'), ("a," * 9000 + "b\n", "twice"), ("x [m]\0\n1\n", "x"),
]

# Surveys for a shape of the kind "bathymetry": extension, contents.
SURVEYS = [
    (".csv", "x [m],y [m]\n0,0\n", 'no column "z"'), (".csv", "x [m],y [m],z [m]\n0,0,nan\n1,0,0\n0,1,0\n", "is no number"),
    (".csv", "x [m],y [m],z [m]\n0,0,\n", "missing"), (".csv", "x [m],y [m],z [m]\n0,0,1e300\n1,0,0\n0,1,0\n", "larger than 1e+12"),
    (".xyz", "0 0\n", "2 numbers"), (".xyz", "0 0 nan\n1 0 0\n", "is no number"), (".xyz", "0 0 1e200\n", "larger than"), (".xyz", "0,5 0,5 0,1\n", "decimal comma"),
    (".asc", "", "ncols"), (".asc", "ncols 2\nnrows 2\n1 2\n3 4\n", "cellsize"), (".asc", "ncols 0\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1\n", "whole numbers"),
    (".asc", "ncols 2\nnrows -2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n", "whole numbers"), (".asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0\n1 2\n3 4\n", "whole numbers"),
    (".asc", "ncols 1e9\nnrows 1e9\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n", "announces"), (".asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 two\n", "is no number"),
    (".asc", "ncols 2 2\n", "no word and number"),
]


def refusal_of(words):
    """Status, seconds, largest memory [bytes] and the lines on stderr of a program."""
    begin = time.monotonic()
    child = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                             stdin=subprocess.DEVNULL)
    said = child.stderr.read()
    child.stderr.close()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss, said.splitlines()


class BadFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = scratch / "in"
        shutil.rmtree(scratch, ignore_errors=True)
        cls.folder.mkdir(parents=True)
        cls.filled = scratch / "run"
        made = case.call(case.command(thalweg, "gencase", case.CASE, cls.filled))
        assert made.returncode == 0, made.stderr

    def refused(self, words, text, name):
        status, seconds, memory, said = refusal_of(words)
        with self.subTest(name=name, said=[line[:400] for line in said[:3]]):
            self.assertEqual(status, 2)
            self.assertEqual(len(said), 1)
            shown = said[0].replace(str(scratch), "")  # the test's own folder may lie deep
            self.assertLessEqual(len(shown), LONGEST)
            self.assertTrue(shown.startswith("error: "))
            self.assertIn(";", shown)
            self.assertIn(text, shown)
            self.assertLess(seconds, SLOWEST)
            self.assertLess(memory, LARGEST)

    def write(self, name, contents):
        file = self.folder / name
        file.write_bytes(contents if isinstance(contents, bytes) else contents.encode())
        return file

    def test_the_files_that_are_spoilt_are_good(self):
        result = case.call([thalweg, "info", self.write("good.vtp", GOOD)])
        self.assertEqual(result.returncode, 0, result.stderr)
        result = case.call([thalweg, "info", self.write("packed.vtp", compressed(packed(PLACES)))])
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_structure_of_particle_files(self):
        for number, (change, text) in enumerate(STRUCTURE):
            if isinstance(change, tuple):
                self.assertIn(change[0], GOOD)
            contents = change if isinstance(change, str) else GOOD.replace(*change, 1)
            self.refused([thalweg, "info", self.write("bad.vtp", contents)], text, f"structure {number}: {text}")

    def test_contents_of_particle_files(self):
        particles = self.filled / "particles.vtp"
        for number, (change, text) in enumerate(CONTENTS):
            particles.write_text(changed(change))
            self.refused([thalweg, "solver", self.filled], text, f"contents {number}: {text}")

    def test_series(self):
        for number, (contents, text) in enumerate(SERIES):
            self.refused([thalweg, "info", self.write("bad.pvd", contents)], text, f"series {number}: {text}")

    def test_tables(self):
        for number, (contents, text) in enumerate(TABLES):
            file = self.write("t0.100.csv", contents)
            self.refused([thalweg, "postproc", self.filled, "--compare", file], text, f"table {number}: {text}")
        for argument, text in (("/dev/zero", "neither a plain file"), (5000 * "L" + "=" + str(file), "5000 characters"),
                               ("=" + str(file), "0 characters"), (5000 * "L", "no such file or folder")):
            self.refused([thalweg, "postproc", self.filled, "--compare", argument], text, f"argument: {text}")

    def test_surveys(self):
        scene = (TESTS / "gencase" / "bad_geometry" / "scene.toml").read_text()
        for number, (extension, contents, text) in enumerate(SURVEYS):
            survey = self.write("survey" + extension, contents)
            self.write("scene.toml", scene)
            shutil.copy(TESTS / "gencase" / "bad_geometry" / "box.off", self.folder)
            words = [thalweg, "gencase", self.folder / "scene.toml", "--check"]
            for key in ("kind=bathymetry", "base=-0.3 m", f"file={survey.name}"):
                words += ["--set", f"shape.pier.{key}"]
            self.refused(words, text, f"survey {number}: {text}")

    def test_all_kinds_together_are_many(self):
        """Beside these stand the cases and geometries of the unit tests, whose messages are tested word for word."""
        here = sum(map(len, (STRUCTURE, CONTENTS, SERIES, TABLES, SURVEYS)))
        cases = len(list((TESTS / "case" / "bad_cases").glob("*.toml")))
        geometries = len(list((TESTS / "gencase" / "bad_geometry").glob("*.set")))
        self.assertGreaterEqual(here + cases + geometries, 250, (here, cases, geometries))


if __name__ == "__main__":
    unittest.main()
