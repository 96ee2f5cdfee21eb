#!/usr/bin/env python3
"""Errors, orders and measures of validate and sweep against values worked by hand: figures_test.py"""

import math
import pathlib
import sys
import tempfile
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "bench"), str(ROOT / "python")]

from validation.convergence import convergence
from validation.engine import case_content
from validation.expected import read_expected
from thalweg.faults import InputError
from validation.library import MEASURES
from validation.measure_reference import reference_page
from validation.points import Point, errors, order_of, scaled
from thalweg.toml_files import Lines
from validation.variations import combinations, variation


class Errors(unittest.TestCase):
    def test_errors_over_points(self):
        # Errors 1, -3, 2: rmse sqrt(14/3), bias 0; the reference runs from 10 to 14.
        found = errors([Point("a", 11, 10, 10), Point("b", 9, 12, 12), Point("c", 16, 14, 14)])
        self.assertAlmostEqual(found.rmse, math.sqrt(14 / 3))
        self.assertAlmostEqual(found.normalised_rmse, math.sqrt(14 / 3) / 4)
        self.assertEqual((found.points, found.bias, found.largest, found.largest_at), (3, 0, -3, "b"))

    def test_no_error_inside_a_range_and_its_edge_beyond(self):
        self.assertEqual([Point("", value, 2.0, 3.0).error for value in (1.5, 2.5, 3.25)], [-0.5, 0.0, 0.25])

    def test_nothing_known_gives_no_error(self):
        self.assertEqual((errors([Point("", 1.0)]).points, errors([Point("", 1.0)]).rmse), (0, None))

    def test_scales(self):
        points = [Point("a", 11, 10, 10), Point("b", 18, 20, 20)]
        for scale, expected in ((None, (1, -2)), (2, (0.5, -1)), ("reference", (0.1, -0.1)), ("range", (0.1, -0.2)),
                                ("rms", (1 / math.sqrt(250), -2 / math.sqrt(250))), ("spacing", (4, -8))):
            for point, error in zip(scaled(points, scale, 0.25), expected):
                self.assertAlmostEqual(point.error, error, msg=str(scale))

    def test_order_of_errors(self):
        order, note = order_of([0.04, 0.01, 0.02], [-16e-4, 1e-4, 4e-4])
        self.assertAlmostEqual(order, 2)
        self.assertEqual(note, "")
        self.assertEqual(order_of([2, 1], [1, 3])[1], "grows")
        self.assertEqual(order_of([4, 2, 1], [2, 3, 1])[1], "not monotonic")
        self.assertIsNone(order_of([2, 1], [1, 0])[0])


class Convergence(unittest.TestCase):
    def test_a_quantity_of_known_order(self):
        # f = 7 + 3 h^1.5 at spacings that have no constant ratio.
        found = convergence([5, 2, 3], [7 + 3 * h ** 1.5 for h in (5, 2, 3)])
        self.assertAlmostEqual(found.order, 1.5, places=9)
        self.assertAlmostEqual(found.extrapolated, 7, places=8)
        self.assertAlmostEqual(found.band, 1.25 * 3 * 2 ** 1.5, places=8)

    def test_what_has_no_order(self):
        self.assertEqual(convergence([4, 2, 1], [1, 3, 2]).note, "not monotonic")
        self.assertEqual(convergence([4, 2, 1], [1, 2, 4]).note, "does not converge")
        self.assertEqual(convergence([4, 2, 1], [1, 1.2, 1.3], scatter=0.5).note, "within the scatter")


class Variations(unittest.TestCase):
    def settings(self, text):
        found = variation(text)
        return [value.setting(found.key) for value in found.values]

    def test_units_and_words(self):
        self.assertEqual(self.settings("a.b=20,10,5mm"), ['a.b="20 mm"', 'a.b="10 mm"', 'a.b="5 mm"'])
        self.assertEqual(self.settings("a.b=1 m/s,2e-1 m/s"), ['a.b="1 m/s"', 'a.b="2e-1 m/s"'])
        self.assertEqual(self.settings("a.b=0.3,0.5"), ["a.b=0.3", "a.b=0.5"])
        self.assertEqual(self.settings("model.yield_fit=outer,plane-strain"), ["model.yield_fit=outer", "model.yield_fit=plane-strain"])
        self.assertEqual(self.settings('to=["1 m", "2 m"],["1 m", "3 m"]'), ['to=["1 m", "2 m"]', 'to=["1 m", "3 m"]'])

    def test_all_combinations(self):
        found = combinations([variation("a=1,2"), variation("b=x,y,z")], 1)
        self.assertEqual([tuple(value.text for value in values) for values in found],
                         [("1", "x"), ("1", "y"), ("1", "z"), ("2", "x"), ("2", "y"), ("2", "z")])


def fail(text, key=None):
    raise InputError(f"{key}: {text}")


class Measures(unittest.TestCase):
    """Each measure on made-up results."""

    def measured(self, name, given, **results):
        finished = types.SimpleNamespace(spacing=0.01, gravity=9.81, end=10.0, run=types.SimpleNamespace(name="r"), **results)
        reference = types.SimpleNamespace(points=lambda sample, column=0: [Point("", sample(time)) for time in given.get("at", [None])], columns=0)
        return MEASURES[name].function(finished, types.SimpleNamespace(given=given, reference=reference), None)

    def test_statistics_of_a_column(self):
        rows = [(float(t), 2.0 * t + 1) for t in range(11)]
        for statistic, expected in (("mean", 13), ("last", 21), ("largest", 21), ("smallest", 5), ("trend", 2), ("drift", 16), ("change", 16)):
            point, = self.measured("column", {"file": "f", "column": "c", "statistic": statistic, "from": 2.0}, column=lambda *_: rows)
            self.assertAlmostEqual(point.computed, expected, msg=statistic)

    def test_arrival_noise_and_running_mean_of_a_column(self):
        rows = [(0.001 * n, 1000.0 + (100 if n % 2 else -100) if n >= 50 else 0.0) for n in range(101)]

        def measured(**keys):
            point, = self.measured("column", {"file": "f", "column": "c", **keys}, column=lambda *_: rows)
            return point.computed

        self.assertAlmostEqual(measured(statistic="arrival", above=500.0), 0.05)
        self.assertEqual(measured(statistic="arrival", above=5000.0), math.inf)
        # A mean over 9 or 10 of the values that alternate is off by at most a ninth of their swing.
        self.assertAlmostEqual(measured(statistic="noise", over=0.01, **{"from": 0.07, "to": 0.09}), 100, delta=12)
        self.assertAlmostEqual(measured(statistic="largest", over=0.01, **{"from": 0.07, "to": 0.09}), 1000, delta=12)
        self.assertEqual(measured(statistic="largest"), 1100)

    def test_value_of_a_column_at_a_time(self):
        rows = [(0.0, 1.0), (1.0, 3.0), (2.0, 7.0)]
        points = self.measured("column", {"file": "f", "column": "c", "at": [0.9, 2.0], "less": 1}, column=lambda *_: rows)
        self.assertEqual([point.computed for point in points], [2, 6])

    def test_profile_along_a_line_and_along_x(self):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "report"
            report.mkdir()
            (report / "errors.csv").write_text(
                "reference,compared,line,curve,time [s],points [-],rmse [m],normalised_rmse [-],bias [m],largest_error [m],largest_error_at [m],"
                "brier_skill [-]\nmeasured,run,,bed,20,5,0.01,0.1,0,0.02,0.3,0.5\nmeasured,run,s1,bed,20,7,0.03,0.2,0.01,0.05,0.4,\n")
            given = {"curve": "bed", "at": 20}
            self.assertEqual(self.measured("profile", given, folder=pathlib.Path(folder)).rmse, 0.01)
            along = self.measured("profile", {**given, "line": "s1"}, folder=pathlib.Path(folder))
            self.assertEqual((along.points, along.rmse, along.bias), (7, 0.03, 0.01))
            with self.assertRaisesRegex(InputError, "at 20 s along s2 with no measurement"):
                self.measured("profile", {**given, "line": "s2"}, folder=pathlib.Path(folder), fail=fail)

    def test_front_passes_over_two_drops(self):
        particles = {"Points": [x for place in (0.5, 0.9, 0.8, 0.4, 2.0) for x in (place, 0, 0)], "Type": (2, 2, 2, 2, 0)}
        point, = self.measured("water front", {}, snapshot=lambda _: "", particles=lambda *_: particles)
        self.assertAlmostEqual(point.computed, 0.505)

    def test_water_over_height_lies_between_the_middles_of_rows(self):
        places, concentrations = (0.105, 0.115, 0.125, 0.095), (1e-2, 1e-3, 1e-4, 0.9)  # the last one is of the bed
        particles = {"Points": [x for z in places for x in (0, 0, z)], "Type": (2, 2, 2, 3), "Concentration": concentrations,
                     "Velocity": [x for u in (1.0, 2.0, 3.0, 9.0) for x in (u, 0, 0)]}
        finished = types.SimpleNamespace(spacing=0.01, end=10.0, particles=lambda *_: particles, snapshots=[(1.0, "early"), (10.0, "last")])
        reference = types.SimpleNamespace(points=lambda sample: [Point(z, sample(z), 1e-2, 1e-2) for z in (0.001, 0.01, 0.0225, 0.04)])

        def measured(given):
            return MEASURES["water over height"].function(finished, types.SimpleNamespace(given={"floor": 0.1, **given}, reference=reference), None)
        self.assertEqual([round(point.computed, 9) for point in measured({"array": "Velocity"})], [1.5, 2.75])
        logarithms = measured({"array": "Concentration", "logarithmic": True})
        self.assertEqual([(round(point.computed, 9), point.low) for point in logarithms], [(-2.5, -2.0), (-3.75, -2.0)])

    def test_toe_lies_between_two_columns(self):
        profile = [(0.0, 0.04), (0.01, 0.008), (0.02, 0.002), (0.03, 0.0)]
        point, = self.measured("toe", {"height": 0.004}, profile=lambda *_: profile)
        self.assertAlmostEqual(point.computed, 0.01 + 0.01 * 4 / 6)

    def test_the_depth_of_a_hole_counts_between_its_places_alone(self):
        profile = [(-0.6, -0.09), (-0.01, -0.03), (0.0, -0.045), (0.02, -0.04), (0.3, 0.01)]
        given = {"begin": -0.1, "end": 0.1, "level": -0.025}
        self.assertAlmostEqual(self.measured("depth of a hole", given, profile=lambda *_: profile)[0].computed, 0.02)
        with self.assertRaises(InputError):
            self.measured("depth of a hole", {**given, "begin": 0.4, "end": 0.5}, profile=lambda *_: profile, fail=fail)

    def test_the_height_of_a_crest_counts_between_its_places_alone(self):
        profile = [(-0.6, 0.9), (-0.01, 0.03), (0.0, 0.045), (0.02, 0.04), (0.3, 0.5)]
        point, = self.measured("height of a crest", {"begin": -0.1, "end": 0.1}, profile=lambda *_: profile)
        self.assertAlmostEqual(point.computed, 0.045)

    def test_the_velocity_of_a_surface_is_that_of_the_highest_water_around_a_place(self):
        # Three columns: the middle one has slow water below, the last one lies outside of the square; particle 4 is of a wall.
        particles = {"Points": [0.05, 0.05, 0.2, 0.15, 0.05, 0.1, 0.15, 0.05, 0.3, 0.95, 0.05, 0.2, 0.05, 0.05, 0.9],
                     "Velocity": [1, 0.5, 0, 0, 0, 0, 3, -0.5, 0, 7, 7, 0, 9, 9, 9], "Type": (2, 2, 2, 2, 0)}
        finished = types.SimpleNamespace(spacing=0.1, particles=lambda *_: particles, snapshot=lambda _: "")
        reference = types.SimpleNamespace(columns=2, times=[(0.1, 0.1), (5.0, 5.0)],
                                          points=lambda sample, _: [Point("", sample(place), 0.0, 0.0) for place in reference.times])
        points = MEASURES["surface velocity"].function(
            finished, types.SimpleNamespace(given={"time": 1.0, "over": 0.3, "column": ["u", "v"]}, reference=reference), None)
        self.assertEqual([point.computed for point in points], [2.0, 0.0, 0.0, 0.0])
        self.assertEqual(points[0].at, "u at 0.1, 0.1 m")

    def test_a_crest_rises_above_its_lowest_before(self):
        crests = {0.0: 0.2, 1.0: 0.15, 2.0: 0.16, 3.0: 0.1, 4.0: 0.12}
        results = {"snapshots": [(time, "") for time in crests], "profile": lambda time, _: [(0.5, 0.3), (0.8, crests[time]), (0.9, 0.05)]}
        point, = self.measured("rise of a crest", {"begin": 0.7, "end": 1.0}, **results)
        self.assertEqual((round(point.computed, 9), point.at, point.low), (0.02, 4.0, 0.0))

    def test_a_weir_takes_its_head_from_the_highest_bed(self):
        # (2/3)^1.5 sqrt(9.81) 0.04^1.5 = 0.54433 * 3.13209 * 0.008 = 0.013639
        columns = {"pool.level": [(1.9, 0.17), (2.1, 0.19), (5.0, 9.0)], "crest.water": [(1.9, 0.012), (2.1, 0.014), (5.0, 9.0)]}
        given = {"begin": 0.7, "end": 1.0, "at": [2.0], "level": "pool", "flux": "crest", "over": 0.4}
        point, = self.measured("broad-crested weir", given, profile=lambda *_: [(0.75, 0.13), (0.8, 0.14), (0.9, 0.1)],
                               column=lambda _, name: columns[name])
        self.assertAlmostEqual(point.computed, 0.013)
        self.assertAlmostEqual(point.low, 0.013639, places=6)

    def test_energy_rise_above_start_and_above_the_lowest(self):
        rows = [{"kinetic_energy": e, "potential_energy": 0.0, "internal_energy": 0.0, "water_mass": 2.0, "sediment_mass": 0.0} for e in (5, 2, 4, 6)]
        for above, rise in (("start", 1), ("lowest", 4)):
            point, = self.measured("energy rise", {"above": above}, table=lambda _: rows)
            self.assertAlmostEqual(point.computed, rise / (2 * 9.81))

    def test_log_law_has_the_mean_of_its_own_profile(self):
        case = {"materials": {"water": {"viscosity": "0.001 Pa s", "density": "1000 kg/m^3"}}, "flow": {"slope": 0.00197},
                "shape": [{"role": "wall", "roughness": "0.001 m"}]}
        point, = self.measured("log-law velocity", {"depth": 0.1}, case=case, column=lambda *_: [(8.0, 0.7), (9.0, 0.8)])
        self.assertAlmostEqual(point.computed, 0.75)
        friction = math.sqrt(9.81 * 0.1 * 0.00197)
        origin = 0.11e-6 / friction + 0.033e-3
        mean = sum(friction / 0.41 * math.log((n + 0.5) / 1e5 * 0.1 / origin) for n in range(100000) if (n + 0.5) / 1e6 > origin) / 1e5
        self.assertAlmostEqual(point.low, mean, places=5)

    def test_kynch_at_the_start_is_the_whole_column(self):
        case = {"domain": {"from": ["0 m"], "to": ["0.1 m"]}}
        count = 200  # particles of 1 cm^2 in 0.1 m x 0.2 m
        particles = {"Points": [x for n in range(count) for x in (0, 0, (n // 10 + 0.5) * 0.01)], "Type": (2,) * count,
                     "Concentration": (0.1,) * count}
        given = {"at": 0.0, "depth": 0.2, "concentration": 0.1, "packing": 0.6, "settling_velocity": 0.026, "exponent": 4.65, "below": 0.03}
        for name, expected in (("kynch edge", 0.2), ("kynch bed", 0.03)):
            point, = self.measured(name, given, case=case, snapshot=lambda _: "", particles=lambda *_: particles)
            self.assertAlmostEqual(point.computed, expected)
            self.assertAlmostEqual(point.low, expected)


class Files(unittest.TestCase):
    def test_lines_of_tables_and_keys(self):
        lines = Lines('a = 1\n[x]\ntext = """\n[y]\nb = 2\n"""\nb = 3\n[[run]]\nname = "1"\n[[run]]\nname = "2"\n')
        self.assertEqual((lines.key("x", "b"), lines.table("run", 1), lines.key("run", "name", 1), lines.key("", "a")), (7, 10, 11, 1))

    def test_every_case_of_the_project_is_read(self):
        read = [read_expected(file.parent, file.parent.name) for file in sorted((ROOT / "cases").glob("*/expected.toml"))]
        self.assertGreaterEqual({case.name for case in read}, {"still_water", "dam_break", "spheric02", "channel", "batch_sedimentation",
                                                               "submerged_columns", "louvain", "weir"})
        for case in read:
            self.assertTrue(case.runs, f"{case.name} has no run")

    def test_the_page_of_the_measures_is_up_to_date(self):
        self.assertEqual((ROOT / "docs/expected.md").read_text(encoding="utf-8"), reference_page(),
                         "write it again: thalweg validate --measures > docs/expected.md")

    def test_a_measurement_belongs_to_the_content_of_a_case(self):
        self.assertNotEqual(case_content(ROOT / "cases/dam_break"), case_content(ROOT / "cases/still_water"))

    def test_a_folder_without_a_case_is_wrong_input(self):
        with self.assertRaises(InputError):
            read_expected(ROOT / "docs", "docs")


if __name__ == "__main__":
    unittest.main()
