"""The instrument that measures error against seconds: speed_vs_error_test.py THALWEG SCRATCH

Its references against closed forms, its norms on fields that are known, and one small problem from case to table and picture.
"""

import array
import csv
import math
import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "bench/speed_vs_error/speed_vs_error.py"
sys.path[:0] = [str(ROOT / "bench"), str(SCRIPT.parent)]

from on_mesh import ON_MESH
from study import norms
from study.mesh_run import MeshRun
from problems import PROBLEMS
from thalweg.particle_file import arrays, replace_arrays
from study.runs import Run

thalweg, scratch = sys.argv[1], pathlib.Path(sys.argv[2])


class References(unittest.TestCase):
    def test_a_newtonian_slot_has_a_parabola(self):
        velocity = norms.slot_velocity(0.1, 1200.0, (0.0, 1.0, 5.0, 1.0))
        for x in (0.001, 0.02, 0.05, 0.09):
            self.assertAlmostEqual(velocity(x), 1200 / (2 * 5.0) * x * (0.1 - x), delta=1e-6)

    def test_a_bingham_slot_has_its_plug(self):
        """Regularised so sharply that the closed form of the ideal fluid holds to a thousandth."""
        width, force, yield_stress, consistency = 0.1, 1200.0, 24.0, 5.0
        velocity = norms.slot_velocity(width, force, (yield_stress, 1e6, consistency, 1.0))
        sheared = width / 2 - yield_stress / force
        plug = force * sheared ** 2 / (2 * consistency)
        self.assertAlmostEqual(velocity(width / 2), plug, delta=1e-3 * plug)
        self.assertAlmostEqual(velocity(sheared), plug, delta=1e-3 * plug)
        self.assertAlmostEqual(velocity(sheared / 2), 0.75 * plug, delta=1e-3 * plug)

    def test_the_shear_rate_carries_the_stress(self):
        rate = norms.shear_rate(40.0, 24.0, 20.0, 5.0, 1.5)
        self.assertAlmostEqual(24 * (1 - math.exp(-10 * rate)) + 5 * rate ** 1.5, 40.0, places=9)

    def test_the_vortex_decays_as_its_viscosity_says(self):
        u, w, pressure = norms.vortex(0.25, 0.0, 0.1, 1.0, 1.0, 0.1)
        self.assertAlmostEqual(u, math.exp(-8 * math.pi ** 2 * 0.1 / 10))
        self.assertAlmostEqual(w, 0.0)
        self.assertAlmostEqual(pressure, 0.0)
        self.assertAlmostEqual(norms.vortex(0.0, 0.0, 0.0, 1.0, 2.0, 0.1)[2], 2.0)  # U^2/2 at a stagnation point

    def test_pressure_under_two_layers(self):
        layers = ((0.06, 1286.2), (0.16, 1000.0))
        self.assertAlmostEqual(norms.layered_pressure(0.0, layers, 9.81), 9.81 * (100 + 0.06 * 1286.2))
        self.assertAlmostEqual(norms.layered_pressure(0.10, layers, 9.81), 9.81 * 60)
        self.assertEqual(norms.layered_pressure(0.17, layers, 9.81), 0)

    def test_order_and_front(self):
        self.assertAlmostEqual(norms.order([4, 2, 1], [16e-3, 4e-3, 1e-3]), 2)
        self.assertEqual(norms.pareto_front([(3, 1), (1, 5), (2, 5), (2, 2), (4, 4)]), [(1, 5), (2, 2), (3, 1)])


def write_field(file, kind, numbers):
    """A field as OpenFOAM writes it in its binary format."""
    file.parent.mkdir(parents=True, exist_ok=True)
    count = len(numbers) // (3 if kind == "vector" else 1)
    head = f"FoamFile {{ format binary; }}\ninternalField   nonuniform List<{kind}> \n{count}\n(".encode()
    file.write_bytes(head + array.array("d", numbers).tobytes() + b")\n;\n")


class OnMesh(unittest.TestCase):
    """Measures of a mesh, on fields that are known: 8 cells of 12.5 mm, one above the other."""

    def setUp(self):
        self.run_there = MeshRun(thalweg, scratch / "on_mesh", None, "column", [], "12.5 mm", "stock")
        shutil.rmtree(self.run_there.root, ignore_errors=True)
        case = self.run_there.folder / "case"
        self.heights = [0.0125 * (k + 0.5) for k in range(8)]
        for name, numbers in (("Cx", [0.5] * 8), ("Cz", self.heights)):
            write_field(case / "constant" / name, "scalar", numbers)
        (case / "constant/Cy").write_bytes(b"internalField   uniform 0.25;\n")
        (case / "40").mkdir()
        (case / "40/alpha.air").write_bytes(b"internalField   uniform 0;\n")
        self.fields = case / "40"

    def test_centres_of_uniform_and_other_coordinates(self):
        self.assertEqual(self.run_there.centres()[2], (0.5, 0.25, self.heights[2]))
        self.assertEqual([time for time, _ in self.run_there.times()], [40])

    def test_hydrostatic_water_at_rest_has_no_error(self):
        write_field(self.fields / "p", "scalar", [9810 * (0.3 - z) for z in self.heights])
        (self.fields / "U").write_bytes(b"internalField   uniform (0 0 0);\n")
        errors = ON_MESH["still_tank"].errors(self.run_there)
        self.assertAlmostEqual(errors["pressure"], 0)
        self.assertEqual(errors["speed"], 0)
        write_field(self.fields / "p", "scalar", [1.01 * 9810 * (0.3 - z) for z in self.heights])
        self.assertAlmostEqual(ON_MESH["still_tank"].errors(self.run_there)["pressure"], 0.01)

    def test_the_logarithmic_law_has_no_error(self):
        law = PROBLEMS["channel"].law()
        mean = law.mean(PROBLEMS["channel"].depth)
        self.assertAlmostEqual(mean, 0.7452, delta=2e-4)  # of the channel's expected.toml
        (self.run_there.folder / "summary.csv").write_text("quantity,value,unit\ncell_size,0.0125,m\n", encoding="utf-8")
        for factor in (1.0, 1.02):
            write_field(self.fields / "U", "vector", [u for z in self.heights for u in (factor * law.velocity(z), 0.0, 0.0)])
            rows = ON_MESH["channel"].errors(self.run_there)["rows"]
            middle = norms.rms(law.velocity(z) for z in self.heights[1:-1])
            self.assertAlmostEqual(rows, (factor - 1) * middle / mean, delta=1e-9)

    def test_a_jet_that_slows_down_as_measured_has_no_error(self):
        jet = PROBLEMS["wall_jet"]
        speeds = {place: jet.velocity * 3.5 / math.sqrt(place) for place in jet.places}
        rows = [(place * jet.opening, z, share * speed, 1.0) for place, speed in speeds.items() for z, share in ((0.002, 0.6), (0.007, 1.0))]
        beyond = [(20 * jet.opening, 0.002, 9.0, 1.0), (17 * jet.opening, 0.15, 9.0, 1.0)]  # between two places, and above the rows
        self.assertEqual(jet.of_samples(rows + beyond, 0.005), {"decay": 0, "mean": 0})
        errors = jet.of_samples([(x, z, 0.9 * u, weight) for x, z, u, weight in rows], 0.005)
        self.assertAlmostEqual(errors["decay"], 0.1)
        self.assertAlmostEqual(errors["mean"], -0.1)

    def test_distances_of_profiles(self):
        level = [{"x": 0.1 * i, "bed": 0.02} for i in range(5)]
        ramp = [{"x": 0.05 * i, "bed": 0.02 + 0.003} for i in range(9)]
        self.assertAlmostEqual(ON_MESH["louvain"].distance([(1, level)], [(1, ramp)], "bed"), 0.003)


class OneProblem(unittest.TestCase):
    """The Taylor-Green vortex at two spacings, by the command a user gives."""

    @classmethod
    def setUpClass(cls):
        cls.out = scratch / "speed_vs_error"
        shutil.rmtree(cls.out, ignore_errors=True)
        cls.command = [SCRIPT, thalweg, "--quick", "--only", "taylor_green", "--out", str(cls.out),
                       "--page", str(cls.out / "page.md"), "--record", str(cls.out)]
        cls.said = subprocess.run([sys.executable, "-B", *cls.command], capture_output=True, text=True, check=True).stdout
        with (cls.out / "points.csv").open(encoding="utf-8") as table:
            cls.rows = list(csv.DictReader(line for line in table if not line.startswith("#")))

    def test_errors_fall_with_the_spacing(self):
        """Second order but for the lattice's floor; a wrong norm, field or time gives none of this."""
        coarse, fine = (float(row["error"]) for row in self.rows if row["group"] == "spacing")
        self.assertLess(coarse, 0.05)
        self.assertGreater(math.log2(coarse / fine), 1)

    def test_every_point_has_cost_and_settings(self):
        self.assertEqual({row["group"] for row in self.rows}, {"spacing", "numerics.smoothing_ratio", "numerics.cfl"})
        for row in self.rows:
            self.assertEqual(row["failure"], "")
            self.assertGreater(float(row["cpu [s]"]), 0)
            self.assertGreater(int(row["steps [-]"]), 10)
        changed = next(row for row in self.rows if row["changed"] == "smoothing_ratio=1.3")
        self.assertEqual(float(changed["numerics.smoothing_ratio"]), 1.3)

    def test_the_exact_field_has_no_error(self):
        """The snapshot's velocities replaced by the exact ones; then by those of a vortex 1 % too fast."""
        folder = scratch / "exact_field"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.out / "runs/taylor_green_6.25_cm", folder / "taylor_green_6.25_cm")
        run = Run(thalweg, folder, None, "taylor_green 6.25 cm", [])
        snapshot = sorted((run.folder / "snapshots").glob("*.vtp"))[-1]
        places = arrays(snapshot, {"Points"})["Points"]
        for factor in (1.0, 1.01):
            velocities = []
            for i in range(0, len(places), 3):
                u, w, _ = norms.vortex(places[i], places[i + 2], 0.1, 1.0, 1.0, 0.1)
                velocities += [factor * u, 0.0, factor * w]
            replace_arrays(snapshot, {"Velocity": velocities})
            errors = PROBLEMS["taylor_green"].errors(run)
            rms_of_vortex = math.sqrt(0.5)  # over its largest velocity: sin^2 cos^2 has a mean of a quarter, and there are two
            self.assertAlmostEqual(errors["velocity"], (factor - 1) * rms_of_vortex, delta=2e-4)
            self.assertAlmostEqual(errors["decay"], factor - 1, delta=5e-4)

    def test_what_is_there_is_kept(self):
        mark = self.out / "runs/taylor_green_6.25_cm/study.json"
        before = mark.stat().st_mtime_ns
        again = subprocess.run([sys.executable, "-B", *self.command], capture_output=True, text=True, check=True).stdout
        self.assertNotIn("done:", again)
        self.assertEqual(mark.stat().st_mtime_ns, before)

    def test_page_record_and_picture_say_where_they_come_from(self):
        record = (self.out / "speed-vs-error-quick.md").read_text(encoding="utf-8")
        page = (self.out / "page.md").read_text(encoding="utf-8")
        for text in (record, page):
            self.assertRegex(text, r"commit [0-9a-f]{7}")
            self.assertIn("--quick --only taylor_green", text)
            self.assertIn("processors", text)
        self.assertIn("<svg", (self.out / "images/speed_vs_error_taylor_green.svg").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
