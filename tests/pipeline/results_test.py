#!/usr/bin/env python3
"""Files of `thalweg run` are complete and physically right: results_test.py THALWEG FOLDER"""

import html.parser
import pathlib
import sys
import unittest
import urllib.parse

import coarse_louvain as case

thalweg, run = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))

HISTORY = ("time [s],step [-],dt [s],dt_limiter,kinetic_energy [J],potential_energy [J],internal_energy [J],"
           "water_mass [kg],sediment_mass [kg],excluded [-],max_speed [m/s],viscous_iterations [-],"
           "viscous_residual [-],viscous_retries [-],viscosity_capped [-],pressure_sweeps [-],resting [-],"
           "bed_load [-],suspended [-],mass_in [kg],mass_out [kg],mass_lost [kg],"
           "grain_mass [kg],suspended_mass [kg]").split(",")
PROFILE = ["x [m]", "free_surface [m]", "bed [m]", "moving_bed [m]", "floor [m]"]
GRAVITY_WAVE = (9.81 * 0.10) ** 0.5  # [m/s] in the tank; the dam's wave runs back with it
DRY_FRONT = 2 * GRAVITY_WAVE  # [m/s] Ritter's front on a frictionless dry bed: nothing is faster


class Links(html.parser.HTMLParser):
    """Everything a page shows or links to."""

    def __init__(self):
        super().__init__()
        self.targets, self.text = [], []

    def handle_starttag(self, tag, attributes):
        self.targets += [value for name, value in attributes if name in ("href", "src", "data") and value]

    def handle_data(self, data):
        self.text.append(data)


class Files(unittest.TestCase):
    def test_nothing_half_written_is_left(self):
        ours = [path for path in run.rglob("*") if path.is_file() and not path.is_relative_to(run / "foam")]
        leftovers = [path for path in ours if path.stat().st_size == 0 or "tmp" in path.name]
        self.assertEqual(leftovers, [])

    def test_snapshots_are_at_the_times_asked_for(self):
        regular = {round(index * case.INTERVAL, 6) for index in range(round(case.END / case.INTERVAL) + 1)}
        self.assertEqual([round(time, 6) for time, _ in case.series(run)], sorted(regular | set(case.COMPARED)))
        for _, file in case.series(run):
            self.assertTrue(file.is_file(), file)

    def test_info_reads_every_particle_file(self):
        for file in (run / "particles.vtp", *(file for _, file in case.series(run))):
            result = case.call([thalweg, "info", file])
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("water", result.stdout)
        self.assertEqual(case.call([thalweg, "info", run]).returncode, 0)

    def test_the_run_keeps_the_case_it_was_made_from(self):
        resolved = run / "case.resolved.toml"
        again = case.call([thalweg, "gencase", resolved, "--check"])
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("spacing", resolved.read_text())


class History(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = case.table(run / "history.csv")

    def test_columns_and_times(self):
        self.assertEqual(list(self.rows[0]), HISTORY)
        times = [row["time [s]"] for row in self.rows]
        self.assertEqual(times, sorted(times))
        self.assertLess(times[0], 1e-3, "the first step")
        self.assertAlmostEqual(times[-1], case.END, delta=1e-6)

    def test_masses_are_the_scenes_and_stay(self):
        """Filled areas times densities; compression under 0.1 m of water at 10 times its speed is below 1 %."""
        for column, mass in (("water_mass [kg]", case.WATER_AREA * case.WATER_DENSITY),
                             ("sediment_mass [kg]", case.BED_AREA * case.BED_DENSITY)):
            values = [row[column] for row in self.rows]
            self.assertAlmostEqual(values[0], mass, delta=0.01 * mass)
            self.assertAlmostEqual(values[-1], values[0], delta=1e-6 * mass, msg="particles carry their mass for life")
        self.assertEqual(self.rows[-1]["excluded [-]"], 0)

    def test_the_dam_breaks_and_nothing_explodes(self):
        """Kinetic energy comes from the fall of the water: it cannot exceed what potential energy was lost."""
        first, last = self.rows[0], self.rows[-1]
        gained = last["kinetic_energy [J]"] - first["kinetic_energy [J]"]
        lost = first["potential_energy [J]"] - last["potential_energy [J]"]
        self.assertGreater(gained, 0)
        # Lattice start and weak compressibility may set free some energy of their own: 5 % of what fell.
        self.assertLess(gained, 1.05 * lost)
        self.assertLess(max(row["max_speed [m/s]"] for row in self.rows), 1.5 * DRY_FRONT)

    def test_timing_and_summary(self):
        timing = case.table(run / "timing.csv")
        self.assertAlmostEqual(sum(row["share [-]"] for row in timing), 1, delta=0.02)
        summary = {row["quantity"]: row["value"] for row in case.table(run / "summary.csv")}
        self.assertAlmostEqual(summary["physical_time"], case.END, delta=1e-6)
        fluid = (case.WATER_AREA + case.BED_AREA) / case.SPACING**2
        self.assertAlmostEqual(summary["fluid_particles"], fluid, delta=0.02 * fluid)
        for quantity in ("particles", "steps", "wall_seconds", "particle_steps_per_second", "neighbours_mean"):
            self.assertGreater(summary[quantity], 0, quantity)


class Profiles:
    """Particles and mesh have to pass the same physical checks; `resolution` is the smallest length that either resolves [m]."""

    def profile(self, time):
        return case.table(self.folder / f"t{time:.3f}.csv")

    def test_one_file_for_each_time_with_the_columns_of_the_contract(self):
        wanted = {f"t{time:.3f}.csv" for time in case.COMPARED}
        self.assertLessEqual(wanted, {path.name for path in self.folder.glob("t*.csv")})
        for time in case.COMPARED:
            rows = self.profile(time)
            self.assertTrue(set(rows[0]) <= set(PROFILE) and set(PROFILE[:3]) <= set(rows[0]), list(rows[0]))
            places = [row["x [m]"] for row in rows]
            self.assertTrue(all(left < right for left, right in zip(places, places[1:])))
            self.assertLess(places[0], -0.95)
            self.assertGreater(places[-1], 1.4)

    def test_the_tank_far_from_the_gate_does_not_know_yet(self):
        for row in self.profile(0.10):
            if -0.8 < row["x [m]"] < -2 * GRAVITY_WAVE * 0.10:
                self.assertAlmostEqual(row["free_surface [m]"], case.WATER_LEVEL, delta=self.resolution)
                self.assertAlmostEqual(row["bed [m]"], case.BED_LEVEL, delta=self.resolution)

    def test_the_bed_ahead_of_the_fastest_front_is_untouched(self):
        for time in case.COMPARED:
            ahead = [row for row in self.profile(time) if DRY_FRONT * time + 0.2 < row["x [m]"] < 1.4]
            self.assertGreater(len(ahead), 10)
            for row in ahead:
                self.assertAlmostEqual(row["bed [m]"], case.BED_LEVEL, delta=self.resolution)

    def test_the_water_has_run_out(self):
        for time in case.COMPARED:
            wet = [row["x [m]"] for row in self.profile(time)
                   if None not in (row["free_surface [m]"], row["bed [m]"])
                   and row["free_surface [m]"] - row["bed [m]"] > 0.25 * self.resolution]
            self.assertGreater(max(wet), 0.2 * DRY_FRONT * time, f"t = {time} s")
            self.assertLess(max(wet), DRY_FRONT * time + 3 * self.resolution, f"t = {time} s")

    def test_the_area_between_surface_and_bed_is_the_water(self):
        for time in case.COMPARED:
            rows = [row for row in self.profile(time) if None not in (row["free_surface [m]"], row["bed [m]"])]
            depths = [(row["x [m]"], row["free_surface [m]"] - row["bed [m]"]) for row in rows]
            area = sum(0.5 * (x1 - x0) * (depth0 + depth1) for (x0, depth0), (x1, depth1) in zip(depths, depths[1:]))
            # Half a resolution over the tank's metre at surface and bed each.
            self.assertAlmostEqual(area, case.WATER_AREA, delta=self.resolution, msg=f"t = {time} s")


class ParticleProfiles(Profiles, unittest.TestCase):
    folder = run / "profiles"
    resolution = 1.5 * case.SPACING


class MeshProfiles(Profiles):
    resolution = case.CELL


def mesh_models():
    """Names of the mesh models: both of our own, or the stock one where the library for them is not available."""
    return sorted(path.name for path in (run / "foam").iterdir() if not path.name.endswith("x"))


for model in mesh_models():
    globals()[f"MeshProfiles_{model}"] = type(f"MeshProfiles_{model}", (MeshProfiles, unittest.TestCase),
                                              {"folder": run / "foam" / model / "profiles"})


class MeshModels(unittest.TestCase):
    def test_both_of_our_own_ran_or_the_stock_one(self):
        self.assertIn(mesh_models(), (["eroding-bed", "same-material"], ["stock"]))

    def test_each_has_a_coarser_mesh_and_keeps_its_volumes(self):
        for model in mesh_models():
            for folder in (model, model + "-2x"):
                summary = {row["quantity"]: row["value"] for row in case.table(run / "foam" / folder / "summary.csv")}
                self.assertLess(abs(summary["water_volume_error"]), 1e-4, folder)
                self.assertLess(abs(summary.get("sediment_volume_error", 0)), 1e-4, folder)
                self.assertLess(abs(summary.get("grains_volume_error", 0)), 1e-6, folder)

    def test_both_methods_say_what_they_cost(self):
        rows = case.table(run / "report" / "cost.csv")
        methods = {row["method"] for row in rows}
        self.assertEqual(methods, {"particles", *mesh_models()})
        for method in methods:
            finest, coarser = sorted((row for row in rows if row["method"] == method),
                                     key=lambda row: row["resolution [m]"])
            self.assertIsNone(finest["error_bed [m]"])
            self.assertGreater(coarser["error_bed [m]"], 0)
            self.assertGreater(coarser["cpu [s]"], 0)
            for work in ("elements [-]", "steps [-]"):  # seconds would be chance: both runs are over in one
                self.assertGreater(finest[work], coarser[work])


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Links()
        cls.page.feed((run / "report" / "index.html").read_text())
        cls.text = " ".join(cls.page.text)

    def test_everything_it_shows_is_there(self):
        self.assertTrue(self.page.targets)
        for target in self.page.targets:
            parts = urllib.parse.urlparse(target)
            if parts.scheme == "data" or not parts.path:
                continue
            self.assertEqual(parts.scheme, "", f"{target}: a report is read without a network")
            file = run / "report" / urllib.parse.unquote(parts.path)
            self.assertTrue(file.exists(), target)

    def test_it_names_the_case_and_both_methods(self):
        self.assertIn("Dam break over a bed of PVC grains (Louvain)", self.text)
        self.assertIn("OpenFOAM", self.text)

    def test_it_shows_every_compared_time(self):
        for time in case.COMPARED:
            self.assertIn(f"{time:g} s", self.text)


if __name__ == "__main__":
    unittest.main()
