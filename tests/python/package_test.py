#!/usr/bin/env python3
"""The package `thalweg` on a finished run, made-up files and cases: package_test.py THALWEG RUN FOLDER"""

import importlib.util
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
THALWEG, RUN, SCRATCH = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(3))
sys.path.insert(0, str(ROOT / "python"))
os.environ["THALWEG"] = str(THALWEG)

import thalweg
from thalweg import particle_file
from thalweg.units import unit


class Files(unittest.TestCase):
    def test_particles_are_those_that_the_plain_reader_finds(self):
        run = thalweg.Run(RUN)
        last = run.particles()
        plain = particle_file.arrays(run.folder / f"snapshots/s{len(run.times) - 1:05d}.vtp", {"Points", "Type", "Velocity"})
        self.assertEqual(last.points.shape, (len(plain["Type"]), 3))
        numpy.testing.assert_array_equal(last.points.ravel(), plain["Points"])
        numpy.testing.assert_array_equal(last["Velocity"].ravel(), plain["Velocity"])
        self.assertEqual(last["Type"].dtype, numpy.uint8)
        self.assertAlmostEqual(last.time, run.times[-1])
        self.assertEqual(last.field["CaseName"], "louvain")
        self.assertEqual(int(last.field["NumberOfParticles"][0]), len(last.points))
        # One vertex cell a particle.
        self.assertEqual([list(cell) for cell in last.cells["Verts"][:2]], [[0], [1]])
        self.assertEqual(len(last.cells["Verts"]), len(last.points))

    def test_surfaces_and_profiles_agree(self):
        run = thalweg.Run(RUN)
        bed = run.surface("bed", 0.25)
        self.assertTrue(bed.cells["Lines"])
        profile = run.profile(0.25)
        at = numpy.nanargmax(profile["bed"])
        near = numpy.abs(bed.points[:, 0] - profile["x"][at]) < run.spacing
        self.assertAlmostEqual(bed.points[near, 2].max(), profile["bed"][at], delta=run.spacing)
        self.assertEqual(profile.units["bed"], "m")

    def test_tables(self):
        run = thalweg.Run(RUN)
        self.assertTrue(numpy.all(numpy.diff(run.history["time"]) > 0))
        self.assertEqual(run.history.units["time"], "s")
        self.assertIn("kinetic_energy", run.history)
        with self.assertRaisesRegex(KeyError, "has no column depth; there are "):
            run.series["depth"]
        self.assertGreater(int(run.summary["particles"]), 1000)
        self.assertAlmostEqual(run.spacing, 0.01)

    def test_empty_cells_and_texts(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.csv")
            file.write_text("# a remark\ntime [s],x [m],who\n0,,a\n1,2.5,\n")
            table = thalweg.Table(file)
        self.assertTrue(math.isnan(table["x"][0]))
        self.assertEqual((table["x"][1], list(table["who"]), table.units), (2.5, ["a", ""], {"time": "s", "x": "m", "who": ""}))

    def test_triangles_of_a_written_surface(self):
        text = """<?xml version="1.0"?><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
        <Piece NumberOfPoints="4"><PointData><DataArray type="Float32" Name="h" format="ascii">1 2 3 4</DataArray></PointData>
        <Points><DataArray type="Float64" NumberOfComponents="3" Name="Points" format="ascii">0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points>
        <Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
        <DataArray type="Int64" Name="offsets" format="ascii">4</DataArray></Polys></Piece></PolyData></VTKFile>"""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.vtp")
            file.write_text(text)
            numpy.testing.assert_array_equal(thalweg.read_vtp(file).triangles, [[0, 1, 2], [0, 2, 3]])

    def test_damaged_files_are_named(self):
        content = next((RUN / "snapshots").glob("*.vtp")).read_bytes()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "cut.vtp")
            for damaged in (content[:len(content) // 2], b"", content.replace(b"UInt64", b"UInt32"), content.replace(b"PolyData", b"ImageData")):
                file.write_bytes(damaged)
                with self.assertRaisesRegex(thalweg.InputError, "cut.vtp: .*; write it again"):
                    thalweg.read_vtp(file)
            with self.assertRaisesRegex(thalweg.InputError, "cannot be read"):
                thalweg.read_vtp(pathlib.Path(folder, "none.vtp"))
            with self.assertRaisesRegex(thalweg.InputError, "holds no run"):
                thalweg.Run(folder)


class Units(unittest.TestCase):
    def test_quantities(self):
        for text, known in (("2 mm", 0.002), ("1540 kg/m^3", 1540), ("38 deg", math.radians(38)), ("0.0015 Pa s", 0.0015), ("9.81 m/s^2", 9.81),
                            ("3 h", 10800), ("1 g/cm^3", 1000), ("20 L/s", 0.02), ("5 m2 s-1", 5), ("1 kPa", 1000), ("7", 7), ("1e-3 m", 0.001)):
            self.assertAlmostEqual(thalweg.si(text), known, msg=text)
        self.assertEqual(thalweg.si(["1 cm", "2 cm"], "m"), [0.01, 0.02])
        self.assertEqual(thalweg.written(0.002, "mm"), "2 mm")
        self.assertEqual(unit("Pa")[1], unit("kg/m/s^2")[1])
        for bad in ("mm", "2 parsecs", "2 m^x", ""):
            with self.assertRaises(thalweg.InputError):
                thalweg.si(bad)
        with self.assertRaisesRegex(thalweg.InputError, "is not measured in m"):
            thalweg.si("2 s", "m")

    def test_they_are_those_of_the_program(self):
        """The resolved case has SI numbers as the program's own library makes them."""
        run = thalweg.Run(RUN)
        original = thalweg.Case.read(ROOT / "cases/louvain")
        for key in ("materials.pvc.grain_diameter", "materials.pvc.friction_angle", "materials.pvc.grain_density"):
            self.assertAlmostEqual(original.si(key), thalweg.si(run.case["materials"]["pvc"][key.rsplit(".", 1)[1]]), msg=key)


class Cases(unittest.TestCase):
    def test_every_case_can_be_changed_and_keeps_its_comments(self):
        for file in sorted(ROOT.glob("cases/**/case.toml")):
            case = thalweg.Case.read(file)
            before = case.text
            case["numerics.spacing"] = (0.0075, "mm")
            self.assertEqual(case["numerics.spacing"], "7.5 mm")
            changed = [(a, b) for a, b in zip(before.splitlines(), case.text.splitlines()) if a != b]
            self.assertEqual((len(changed), len(before.splitlines())), (1, len(case.text.splitlines())), file)
            self.assertEqual(changed[0][0].partition("#")[2], changed[0][1].partition("#")[2])
            for shape in case.names("shape"):
                case[f"shape.{shape}.name"] = shape
            self.assertEqual(case.data, {**tomllib.loads(before), "numerics": case.data["numerics"]})

    def test_keys_tables_and_lists(self):
        case = thalweg.Case('[numerics]   # how\nspacing = "5 mm"  # fine\n\n[output]\ntimes = ["1 s",  # first\n  "2 s"]\nend = "2 s"\n')
        case["numerics.cfl"] = 0.4
        case["output.times"] = [(0.5, "s"), "1 s"]
        case["model.wall_friction"] = "smooth"
        case["materials.sand.porosity"] = numpy.float64(0.4)
        case.add("gauge", name="toe", at=["0.1 m", "0 m"])
        case["gauge.toe.kind"] = "pressure"
        self.assertEqual(case.text, '[numerics]   # how\nspacing = "5 mm"  # fine\ncfl = 0.4\n\n[output]\ntimes = ["0.5 s", "1 s"]\nend = "2 s"\n\n'
                         '[model]\nwall_friction = "smooth"\n\n[materials.sand]\nporosity = 0.4\n\n[[gauge]]\nname = "toe"\nat = ["0.1 m", "0 m"]\n'
                         'kind = "pressure"\n')
        self.assertEqual(case.si("output.times"), [0.5, 1.0])
        with self.assertRaisesRegex(KeyError, "there is no gauge heel; there are toe"):
            case["gauge.heel.kind"] = "pressure"
        with self.assertRaisesRegex(KeyError, "did you mean cfl"):
            case["numerics.cfll"]
        self.assertNotIn("numerics.precision", case)

    def test_values_that_no_text_edit_can_change_are_refused(self):
        case = thalweg.Case('numerics = { spacing = "5 mm" }\n')
        with self.assertRaisesRegex(thalweg.InputError, "line of its own"):
            case["numerics.spacing"] = "6 mm"
        self.assertEqual(case["numerics.spacing"], "5 mm")


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = SCRATCH / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)

    def coarse(self):
        case = thalweg.Case.read(ROOT / "cases/dam_break")
        case["numerics.spacing"] = "20 mm"
        case["output.end"] = "0.1 s"
        case["output.interval"] = "0.05 s"
        case["compare.times"] = ["0.0714 s"]
        case["domain.to"] = ["0.72 m", "0.4 m"]
        return case

    def test_a_run_from_python(self):
        run = thalweg.run(self.coarse(), self.folder / "run", settings={"numerics.cfl": 0.45}, threads=1)
        numpy.testing.assert_allclose(run.times, [0, 0.05, 0.0714, 0.1])
        self.assertEqual(run.case["numerics"]["cfl"], 0.45)
        with self.assertRaisesRegex(thalweg.InputError, "--force"):
            thalweg.run(self.coarse(), self.folder / "run")
        with self.assertRaisesRegex(thalweg.InputError, "numerics.spacing"):
            thalweg.run(self.coarse(), self.folder / "other", settings={"numerics.spacing": "5 s"})
        self.assertIn("checked only", thalweg.check(ROOT / "cases/dam_break"))

    def test_a_sweep_from_python(self):
        folder = self.coarse().save(self.folder / "case").parent
        table = thalweg.sweep(folder, self.folder / "sweep", vary={"numerics.spacing": [(0.02, "mm"), (0.025, "mm")]}, measures=["front"])
        self.assertEqual(list(table["spacing"]), [0.02, 0.025])
        self.assertTrue(numpy.all(table["front"] > 0.1))


class Installed(unittest.TestCase):
    def test_pip_installs_it_from_the_tree_without_a_network(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "source")
            shutil.copytree(ROOT / "python", source, ignore=shutil.ignore_patterns("__pycache__"))
            missing = [name for name in ("pip", "setuptools", "wheel") if importlib.util.find_spec(name) is None]
            if missing:
                self.skipTest(f"{missing[0]} is not installed: tools/install-deps --test")
            target = pathlib.Path(folder, "site")
            result = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", "--quiet",
                                     "--target", target, source], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)
            code = ("import thalweg, thalweg.importing.command, pathlib; print(thalweg.Case.read(pathlib.Path(%r)).si('numerics.spacing'))"
                    % str(ROOT / "cases/dam_break"))
            result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=folder, env={"PYTHONPATH": str(target)})
            self.assertEqual((result.stdout.strip(), result.stderr), ("0.005", ""))


class WithoutNumPy(unittest.TestCase):
    def test_what_the_programs_use_needs_no_numpy(self):
        code = ("import sys; sys.modules['numpy'] = None; import thalweg.programs, thalweg.tables, thalweg.particle_file, thalweg.faults, "
                "thalweg.importing.command, thalweg.case, thalweg.units")
        result = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, env={"PYTHONPATH": str(ROOT / "python")})
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
