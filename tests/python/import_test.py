#!/usr/bin/env python3
"""`thalweg import` on definitions of every kind, and meshes as FreeCAD writes them: import_test.py THALWEG FOLDER"""

import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tomllib
import unittest

from definitions import DAM, SPACE, TANK, WATER, bound, box, column, definition, fluid

thalweg, scratch = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))


def call(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, stdin=subprocess.DEVNULL)


def metres(value):
    return [metres(each) for each in value] if isinstance(value, list) else float(value.split()[0])


class Import(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def run_import(self, text, *options):
        self.file = self.folder / "Scene_Def.xml"
        self.file.write_text(text, encoding="utf-8")
        return call(thalweg, "import", self.file, "-o", self.folder / "scene", *options)

    def imported(self, text, *options, fills=True):
        """The case of a definition, which gencase has to fill; its remarks are in self.remarks."""
        result = self.run_import(text, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.remarks = result.stdout.splitlines()[:-1]
        content = (self.folder / "scene/case.toml").read_text(encoding="utf-8")
        if fills:
            self.check = call(thalweg, "gencase", self.folder / "scene", "--check")
            self.assertEqual(self.check.returncode, 0, self.check.stderr + content)
            self.assertRegex(self.check.stdout, "no leak|enters or leaves on purpose")
        return tomllib.loads(content)

    def shapes(self, case, role):
        return [shape for shape in case["shape"] if shape["role"] == role]

    def refused(self, text, *options):
        result = self.run_import(text, *options)
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertNotIn("Traceback", result.stderr)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertLessEqual(len(lines[0]), 310)
        self.assertIn(";", lines[0])
        self.assertFalse((self.folder / "scene").exists())
        return lines[0]

    def test_dam_break_in_the_plane_runs(self):
        case = self.imported(definition(DAM))
        self.assertEqual(self.remarks, [])
        self.assertEqual(case["case"]["dimension"], 2)
        wall, = self.shapes(case, "wall")
        self.assertEqual((wall["side"], wall["open"]), ("outside", ["+z"]))
        water, = self.shapes(case, "water")
        self.assertEqual((metres(water["from"]), metres(water["to"])), ([0, 0], [0.4, 0.3]))
        # 20 x 15 particles of 2 cm fill 0.4 m x 0.3 m exactly.
        self.assertIn("300 particles", self.check.stdout)
        result = call(thalweg, "run", self.folder / "scene", "--no-foam", "--out", self.folder / "run", "--threads", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((self.folder / "run/report/index.html").is_file())

    def test_building_in_a_tank_in_space(self):
        building = "<setmkvoid />" + box("solid", (0.6, 0.1, 0), (0.1, 0.2, 0.5)) + bound(1) + \
            box("top | left | right | front | back", (0.6, 0.1, 0), (0.1, 0.2, 0.5)) + bound(2) + box("left", (0.6, 0.1, 0), (0.1, 0.2, 0.5))
        case = self.imported(definition(SPACE + building, flat=False))
        tank, house = self.shapes(case, "wall")
        self.assertEqual((tank["side"], tank["open"]), ("outside", ["+z"]))
        self.assertNotIn("side", house, "no water is inside: a solid body, and its face of another mk is part of it")
        self.assertEqual((metres(house["from"]), metres(house["to"])), ([0.6, 0.1, 0], [0.7, 0.3, 0.5]))

    def test_round_bodies(self):
        bodies = bound(1) + '<drawcylinder radius="0.05"><point x="0.6" y="-1" z="0.2" /><point x="0.6" y="1" z="0.2" /></drawcylinder>' + \
            bound(2) + '<drawsphere radius="0.1"><point x="0.8" y="0.06" z="0.3" /></drawsphere>'
        case = self.imported(definition(DAM + bodies))
        cylinder, sphere = self.shapes(case, "wall")[1:]
        self.assertEqual((cylinder["kind"], metres(cylinder["center"]), metres(cylinder["radius"])), ("cylinder", [0.6, 0.2], 0.05))
        # The plane y = 0 cuts the sphere 6 cm off its centre: sqrt(10^2 - 6^2) = 8 cm.
        self.assertAlmostEqual(metres(sphere["radius"]), 0.08)
        case = self.imported(definition(SPACE + bodies.replace('y="-1"', 'y="0.1"').replace('y="1"', 'y="0.3"'), flat=False), "--force")
        self.assertEqual([shape["kind"] for shape in self.shapes(case, "wall")], ["box", "cylinder", "sphere"])

    def test_thin_walls_grow_away_from_the_water(self):
        walls = bound() + box("solid", (-0.02, -1, -0.02), (1.04, 2, 0.02)) + box("solid", (-0.02, -1, 0), (0.02, 2, 0.5)) + \
            box("solid", (1, -1, 0), (0.02, 2, 0.5))
        case = self.imported(definition(WATER + walls))
        floor, left, right = self.shapes(case, "wall")
        self.assertEqual([metres(each[end])[axis] for each, end, axis in ((floor, "to", 1), (left, "to", 0), (right, "from", 0))], [0, 0, 1])
        for each, axis in ((floor, 1), (left, 0), (right, 0)):
            self.assertAlmostEqual(metres(each["to"])[axis] - metres(each["from"])[axis], 0.08)  # four spacings

    def test_filling_from_a_seed_stops_at_walls(self):
        piston = bound(10) + box("solid", (0.2, -1, 0), (0.02, 2, 0.6))
        filled = fluid() + '<fillbox x="0.6" y="0" z="0.1"><modefill>void</modefill><point x="-1" y="-1" z="-1" />' \
            '<size x="4" y="2" z="1.3" /></fillbox>'
        paddle = '<wavepaddles><piston><mkbound value="10" /><depth value="0.3" /><waveheight value="0.02" /><waveperiod value="1" />' \
            '<ramp value="1" /></piston></wavepaddles>'
        still = '<motion><objreal ref="10"><begin mov="1" start="0" /><mvnull id="1" /></objreal></motion>'
        case = self.imported(definition(TANK + piston + filled, casedef=still, special=paddle))
        water, = self.shapes(case, "water")
        self.assertEqual((metres(water["from"]), metres(water["to"])), ([0.22, 0], [1, 0.3]))
        self.assertEqual(self.shapes(case, "moving wall")[0]["motion"], "mk 10")
        self.assertEqual(case["motion"][0]["direction"], [1, 0])

    def test_slopes_and_turned_boxes(self):
        beach = bound(1) + '<drawlines><point x="0.6" y="0" z="0" /><point x="1" y="0" z="0.3" /></drawlines>'
        turned = bound(2) + '<rotateline ang="45"><point x="0.5" y="0" z="0.45" /><point x="0.5" y="1" z="0.45" /></rotateline>' + \
            box("solid", (0.45, -1, 0.4), (0.1, 2, 0.1)) + "<matrixreset />"
        case = self.imported(definition(DAM + beach + turned))
        slope, square = self.shapes(case, "wall")[1:]
        self.assertEqual((slope["kind"], square["kind"]), ("prism", "prism"))
        corners = sorted(metres(point) for point in square["polygon"])
        self.assertAlmostEqual(corners[0][0], 0.5 - 0.05 * math.sqrt(2), places=6)  # the left corner of a square on its tip
        self.assertTrue(all(z <= 0.3 + 1e-9 and z <= 0.75 * (x - 0.6) + 1e-9 for x, z in map(metres, slope["polygon"])),
                        "the slope's body lies below its line")

    def test_bodies_moved_after_they_are_drawn(self):
        square = bound(1) + box("solid", (0.6, -1, 0.2), (0.1, 2, 0.1))
        turn = '<initials><rotateaxis mkbound="1" angle="-45" anglesunits="degrees"><axisp1 x="0.65" y="0" z="0.25" />' \
            '<axisp2 x="0.65" y="1" z="0.25" /></rotateaxis><move mkbound="1" x="0.1" y="0" z="0" /></initials>'
        body = self.shapes(self.imported(definition(DAM + square, casedef=turn)), "wall")[1]
        self.assertAlmostEqual(max(metres(point)[0] for point in body["polygon"]), 0.75 + 0.05 * math.sqrt(2), places=6)

    def test_surfaces_become_meshes(self):
        roof = bound(1) + '<drawprism><point x="0.6" y="0.1" z="0" /><point x="0.8" y="0.1" z="0" /><point x="0.7" y="0.1" z="0.2" />' \
            '<point x="0.6" y="0.3" z="0" /><point x="0.8" y="0.3" z="0" /><point x="0.7" y="0.3" z="0.2" /></drawprism>'
        case = self.imported(definition(SPACE + roof, flat=False))
        mesh = self.shapes(case, "wall")[1]
        self.assertEqual((mesh["kind"], mesh.get("side")), ("mesh", None))
        content = (self.folder / "scene" / mesh["file"]).read_bytes()
        self.assertEqual(len(content), 84 + 50 * struct.unpack("<I", content[80:84])[0])

    def test_files(self):
        cube = cube_ascii_stl("tank", 0.1)
        (self.folder / "cube.stl").write_text(cube)
        draw = bound(1) + '<drawfilestl file="cube.stl" autofill="true"><drawmove x="0.6" y="0.1" z="0" />' \
            '<drawscale x="2" y="1" z="1" /></drawfilestl><drawfilestl file="not_there.stl" />'
        text = definition(SPACE + draw, flat=False)
        case = self.imported(text)
        mesh = self.shapes(case, "wall")[1]
        self.assertIn("not_there.stl is not there", self.remarks[0])
        self.assertIn(f":{column(text, 'drawfilestl')[0]}: ", self.remarks[0])
        points = [struct.unpack_from("<3f", (self.folder / "scene" / mesh["file"]).read_bytes(), 84 + 12 + 12 * k) for k in range(3)]
        self.assertTrue(all(0.6 - 1e-6 <= p[0] <= 0.8 + 1e-6 for p in points))

    def test_lists_variables_and_placements(self):
        lists = '<list name="water"><drawbox><boxfill>solid</boxfill><point x="0" y="-1" z="0" />' \
            '<size x="#2*side" y="2" z="#max(side,3*Dp)" /></drawbox></list>'
        commands = '<newvar side="0.1+0.1" />' + fluid() + '<move x="0.2" y="0" z="0" /><runlist name="water" /><matrixreset />' + TANK
        water, = self.shapes(self.imported(definition(commands, lists=lists)), "water")
        self.assertEqual((metres(water["from"]), metres(water["to"])), ([0.2, 0], [0.6, 0.2]))

    def test_motions(self):
        gate = bound(1) + box("solid", (0.4, -1, 0.02), (0.08, 2, 0.4)) + bound(2) + box("solid", (0.7, -1, 0.3), (0.06, 2, 0.2))
        motion = '<motion><objreal ref="1"><begin mov="1" start="0.02" /><mvrect id="1" duration="0.04" next="2"><vel x="0" y="0" z="1" />' \
            '</mvrect><mvrect id="2" duration="0.02"><vel x="0" y="0" z="0.5" /></mvrect></objreal>' \
            '<objreal ref="2"><begin mov="1" start="0" /><mvrot id="1" duration="-1" anglesunits="degrees"><vel ang="90" />' \
            '<axisp1 x="0.7" y="0" z="0.4" /><axisp2 x="0.7" y="1" z="0.4" /></mvrot></objreal></motion>'
        case = self.imported(definition(DAM + gate, casedef=motion))
        lift, turn = case["motion"]
        self.assertEqual((lift["kind"], lift["direction"]), ("piecewise linear", [0, 1]))
        self.assertEqual(metres(lift["times"]), [0, 0.02, 0.06, 0.08])
        for found, known in zip(metres(lift["displacements"]), [0, 0, 0.04, 0.05]):
            self.assertAlmostEqual(found, known)
        # GenCase turns left-handed: about +y x goes to z, which is counter-clockwise seen with x to the right and z upwards.
        self.assertEqual((turn["kind"], metres(turn["angular_speed"]), metres(turn["center"])), ("rotation", 90, [0.7, 0.4]))

    def test_a_sine_ends_where_it_should(self):
        paddle = bound(1) + box("solid", (-0.08, -1, 0), (0.08, 2, 0.6))
        tank = bound() + box("bottom | right", (-0.3, -1, 0), (1.3, 2, 0.6))
        motion = '<motion><objreal ref="1"><begin mov="1" start="0" /><mvrectsinu id="1" duration="10" anglesunits="degrees">' \
            '<freq x="2.5" y="0" z="0" /><ampl x="0.02" y="0" z="0" /><phase x="-90" y="0" z="0" /></mvrectsinu></objreal></motion>'
        motion, = self.imported(definition(WATER + tank + paddle, casedef=motion))["motion"]
        rows = list(zip(metres(motion["times"]), metres(motion["displacements"])))
        # x = a (sin(2 pi f t - 90 deg) + 1); after a quarter of the period of 0.4 s it is a.
        self.assertAlmostEqual(rows[-1][0], 0.1)
        self.assertAlmostEqual(rows[-1][1], 0.02, places=6)

    def test_openings_of_a_channel(self):
        channel = fluid() + box("solid", (0, -1, 0), (1, 2, 0.2)) + fluid(1) + box("left", (0, -1, 0), (1, 2, 0.2)) + \
            bound() + box("bottom", (-0.1, -1, 0), (1.2, 2, 0.4))
        zones = '<inout><inoutzone><zone2d><particles mkfluid="1" direction="right" /></zone2d><imposevelocity mode="0">' \
            '<velocity v="0.5" /></imposevelocity><imposezsurf mode="2" /></inoutzone>' \
            '<inoutzone><zone2d><line><point x="1" z="0" /><point2 x="1" z="0.4" /><direction x="-1" z="0" /></line></zone2d>' \
            '<imposevelocity mode="2" /><imposezsurf mode="0"><zsurf value="0.2" /></imposezsurf></inoutzone></inout>'
        case = self.imported(definition(channel, special=zones))
        inlet, outlet = case["inlet"][0], case["outlet"][0]
        self.assertEqual((inlet["surface"], metres(inlet["velocity"]), inlet["direction"]), ("follow", 0.5, [1, 0]))
        self.assertEqual((outlet["kind"], metres(outlet["level"]), outlet["direction"]), ("level", 0.2, [1, 0]))

    def test_a_profile_has_its_mean(self):
        channel = fluid() + box("solid", (0, -1, 0), (1, 2, 0.2)) + bound() + box("bottom | top", (-0.2, -1, 0), (1.4, 2, 0.2))
        zones = '<inout><inoutzone><zone2d><line><point x="0" z="0" /><point2 x="0" z="0.2" /><direction x="1" z="0" /></line></zone2d>' \
            '<imposevelocity mode="0"><velocity3 v="0" v2="0.3" v3="0" z="0" z2="0.1" z3="0.2" /></imposevelocity></inoutzone>' \
            '<inoutzone><zone2d><line><point x="1" z="0" /><point2 x="1" z="0.2" /><direction x="-1" z="0" /></line></zone2d>' \
            '<imposevelocity mode="2" /></inoutzone></inout>'
        case = self.imported(definition(channel, special=zones), fills=False)
        inlet = case["inlet"][0]
        self.assertEqual(inlet["surface"], "full")
        self.assertAlmostEqual(metres(inlet["velocity"]), 0.2, delta=0.004)  # 2/3 of the largest, by trapezes

    def test_gauges(self):
        gauges = '<gauges><default><output value="true" /></default><velocity name="v 1"><point x="0.2" y="0" z="0.1" /></velocity>' \
            '<swl name="level"><point0 x="0.3" y="0" z="0" /><point2 x="0.3" y="0" z="0.5" /></swl>' \
            '<swl name="flat"><point0 x="0" y="0" z="0.1" /><point2 x="1" y="0" z="0.1" /></swl></gauges>'
        text = definition(DAM, special=gauges)
        case = self.imported(text)
        self.assertEqual([(gauge["name"], gauge["kind"]) for gauge in case["gauge"]], [("v_1", "velocity"), ("level", "water level")])
        self.assertEqual(len(self.remarks), 1)
        self.assertIn("flat is not understood", self.remarks[0])

    def test_what_is_not_understood_is_listed_by_line(self):
        text = definition(DAM + '\n<redrawnear targettp="void" bordertp="bound" />\n<drawdragon />\n',
                          casedef='<initials>\n<velocity mkfluid="0" x="1" y="0" z="0" /></initials>')
        case = self.imported(text)
        self.assertEqual(len(case["shape"]), 2)
        lines = [int(remark.split(".xml:")[1].split(":")[0]) for remark in self.remarks]
        self.assertEqual(lines, [*column(text, "redrawnear"), *column(text, "drawdragon"), *column(text, "velocity")])
        self.assertIn(f"#   line {lines[0]}: ", (self.folder / "scene/case.toml").read_text())

    def test_floating_bodies_are_refused_by_name(self):
        body, floats = bound(3) + box("solid", (0.6, -1, 0.2), (0.1, 2, 0.1)), '<floatings><floating mkbound="3" rhopbody="500" /></floatings>'
        self.assertIn("mk 3 floats", self.refused(definition(DAM + body, casedef=floats)))
        case = self.imported(definition(DAM + body, casedef=floats), "--rigid")
        self.assertEqual(len(self.shapes(case, "wall")), 2)
        self.assertIn("fixed wall", self.remarks[0])

    def test_bad_input_is_one_line(self):
        good = definition(DAM)
        self.assertIn("not well-formed", self.refused(good.replace("</mainlist>", "</mainlist <")))
        self.assertIn("mismatched tag", self.refused(good.replace("</mainlist>", "</main>")))
        self.assertIn("document type", self.refused(good.replace("<case>", '<!DOCTYPE case [<!ENTITY a "b"><!ENTITY c "&a;&a;">]><case>', 1)))
        self.assertIn("nested", self.refused(good.replace("<setmkfluid", "<a>" * 100 + "<setmkfluid", 1)))
        self.assertIn("not <case>", self.refused("<html></html>"))
        self.assertIn("draws no fluid", self.refused(definition(TANK)))
        self.assertIn("__import__ is not known", self.refused(definition(DAM).replace('dp="0.02"', 'dp="#__import__(1)"')))
        self.assertIn("is no number", self.refused(definition(DAM).replace('dp="0.02"', 'dp="#9**9**9"')))
        self.assertIn("dp is 0 m", self.refused(definition(DAM).replace('dp="0.02"', 'dp="0"')))
        self.assertIn("there is no face lid", self.refused(definition(DAM.replace("bottom", "lid"))))
        self.assertIn("in a circle", self.refused(definition(DAM + '<runlist name="a" />', lists='<list name="a"><runlist name="a" /></list>')))
        self.assertIn("cannot be read", call(thalweg, "import", self.folder / "none.xml").stderr)
        self.assertIn("is a folder", call(thalweg, "import", self.folder).stderr)
        self.file.write_text(good, encoding="utf-8")
        self.assertIn("cannot be written", call(thalweg, "import", self.file, "-o", self.file / "below").stderr)

    def test_a_case_is_not_overwritten(self):
        self.imported(definition(DAM), fills=False)
        result = self.run_import(definition(DAM))
        self.assertEqual(result.returncode, 2)
        self.assertIn("--force", result.stderr)


CUBE = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def cube_points(side):
    return [(side * (k & 1), side * (k >> 1 & 1), side * (k >> 2 & 1)) for k in range(8)]


def cube_ascii_stl(name, side):
    p = cube_points(side)
    facets = "".join("  facet normal 0 0 0\n    outer loop\n" + "".join(f"      vertex {p[k][0]} {p[k][1]} {p[k][2]}\n" for k in each)
                     + "    endloop\n  endfacet\n" for each in CUBE)
    return f"solid {name}\n{facets}endsolid {name}\n"


class FreeCad(unittest.TestCase):
    """Meshes as FreeCAD's exporters write them (docs/import.md): millimetres, normals, objects and groups."""

    CASE = """[case]
name = "cad"
dimension = 3
[domain]
from = ["-0.2 m", "-0.2 m", "-0.2 m"]
to = ["0.8 m", "0.6 m", "0.6 m"]
[[shape]]
name = "tank"
kind = "box"
role = "wall"
side = "outside"
open = ["+z"]
from = ["0 m", "0 m", "0 m"]
to = ["0.6 m", "0.4 m", "0.4 m"]
[[shape]]
name = "block"
kind = "mesh"
role = "wall"
file = "{file}"
scale = 0.001
move = ["0.3 m", "0.1 m", "0 m"]
[[shape]]
name = "water"
kind = "level"
role = "water"
level = "0.2 m"
[numerics]
spacing = "0.02 m"
[output]
end = "0.1 s"
"""

    def fills(self, name, content):
        folder = scratch / "freecad" / name.replace(".", "_")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder / name).write_bytes(content)
        (folder / "case.toml").write_text(self.CASE.format(file=name))
        result = call(thalweg, "gencase", folder, "--check")
        self.assertEqual(result.returncode, 0, result.stderr)
        # 30 x 20 x 10 nodes hold water, less 5 x 5 x 5 of the block of 100 mm.
        self.assertIn(f"{30 * 20 * 10 - 125} particles", result.stdout)

    def test_binary_stl(self):
        p = cube_points(100.0)
        facets = b"".join(struct.pack("<12fH", 0, 0, 0, *p[a], *p[b], *p[c], 0) for a, b, c in CUBE)
        self.fills("block.stl", b"MESH-" * 16 + struct.pack("<I", len(CUBE)) + facets)

    def test_ascii_stl(self):
        self.fills("block.stl", cube_ascii_stl("Mesh", 100.0).encode())

    def test_obj(self):
        points = "".join(f"v {x} {y} {z}\n" for x, y, z in cube_points(100.0))
        normals = "".join("vn 0.0 0.0 1.0\n" for _ in CUBE)
        faces = "".join("f " + " ".join(f"{k + 1}//{i}" for k in each) + "\n" for i, each in enumerate(CUBE, 1))
        self.fills("block.obj", ("# Created by FreeCAD\nmtllib block.mtl\no Body\ng Body\n" + points + normals + "usemtl Grey\n" + faces).encode())


if __name__ == "__main__":
    unittest.main()
