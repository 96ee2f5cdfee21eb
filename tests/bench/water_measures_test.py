"""What judges the water, on made-up data: water_measures_test.py

Each measure must find what was put into the data: a decay, a period, a noise, a void, a rise of energy.
"""

import csv
import math
import pathlib
import sys
import tempfile
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bench"), str(ROOT / "python"), str(ROOT / "bench/speed_vs_error")]

import water
import water_norms
from thalweg.particle_file import SEDIMENT, WALL, WATER


class Wave(unittest.TestCase):
    def test_a_low_wave_has_the_linear_period(self):
        for depth in (0.05, 0.3, 5.0):
            k = water_norms.wave_number(0.6)
            linear = 2 * math.pi / math.sqrt(9.81 * k * math.tanh(k * depth))
            self.assertAlmostEqual(water_norms.standing_period(k, depth, 1e-9), linear, places=12)

    def test_in_deep_water_steepness_slows_it_as_rayleigh_says(self):
        k, steepness = 10.0, 0.2
        linear = 2 * math.pi / math.sqrt(9.81 * k)
        self.assertAlmostEqual(linear / water_norms.standing_period(k, 10.0, steepness / k), 1 - steepness ** 2 / 8, places=9)

    def test_the_start_keeps_volume_and_walls(self):
        k, d, a, step = water_norms.wave_number(0.6), 0.3, 0.015, 1e-5
        for x, z in ((0.1, 0.05), (0.3, 0.29), (0.5, 0.2)):
            along = (water_norms.mode_displacement(x + step, z, k, d, a)[0] - water_norms.mode_displacement(x - step, z, k, d, a)[0])
            up = (water_norms.mode_displacement(x, z + step, k, d, a)[1] - water_norms.mode_displacement(x, z - step, k, d, a)[1])
            self.assertAlmostEqual((along + up) / (2 * step), 0, places=8)
        self.assertAlmostEqual(water_norms.mode_displacement(0.6, 0.2, k, d, a)[0], 0)
        self.assertAlmostEqual(water_norms.mode_displacement(0.2, 0.0, k, d, a)[1], 0)
        self.assertAlmostEqual(water_norms.mode_displacement(0.0, d, k, d, a)[1], a)  # the crest

    def test_its_pressure_is_that_of_the_linear_mode(self):
        """None at the surface; at the floor, under a crest, rho g (d + a/cosh kd)."""
        k, d, a = water_norms.wave_number(0.6), 0.3, 0.015
        for x in (0.0, 0.2, 0.6):
            self.assertAlmostEqual(water_norms.mode_pressure(x, d, k, d, a, 1000), 0, places=9)
        self.assertAlmostEqual(water_norms.mode_pressure(0, 0, k, d, a, 1000), 9810 * (d + a / math.cosh(k * d)), places=6)

    def test_its_energy_is_the_weight_that_was_lifted(self):
        """rho g/2 times the integral of the squared elevation, by the midpoint rule."""
        k, a, n = water_norms.wave_number(0.6), 0.015, 1000
        lifted = sum(1000 * 9.81 / 2 * (a * math.cos(k * 0.6 * (i + 0.5) / n)) ** 2 * 0.6 / n for i in range(n))
        self.assertAlmostEqual(water_norms.wave_energy(0.6, a, 1000), lifted, places=9)

    def test_decay_and_period_are_found(self):
        """Half of the expected phase shift is still found; disorder that grows is not mistaken for wave."""
        for loss, off in ((0.02, 1.0), (0.09, 0.99), (0.01, 1.01)):
            period = 0.9 * off
            rate = -math.log(1 - loss) / period
            swing = [(t, math.exp(-rate * t) * math.sin(2 * math.pi * t / period) ** 2 + 0.002 * t)
                     for t in (0.005 * n for n in range(1201))]
            found, found_period, disorder = water_norms.decay_of_swing(swing, 0.9)
            self.assertAlmostEqual(found, loss, delta=0.0005)
            self.assertAlmostEqual(found_period / period, 1, delta=2e-4)
            self.assertAlmostEqual(disorder, 0.0114 / math.exp(-rate * 5.7), delta=0.002)

    def test_a_parabola_has_its_vertex(self):
        points = [(t, 3 - 2 * (t - 0.37) ** 2) for t in (0.1, 0.2, 0.25, 0.5, 0.9)]
        for found, exact in zip(water_norms.vertex(points), (0.37, 3)):
            self.assertAlmostEqual(found, exact)


class Signals(unittest.TestCase):
    def test_noise_is_what_is_quicker_than_the_window(self):
        """A tone of ten periods in the window has its own root mean square; a ramp is no noise."""
        times = [0.0001 * n for n in range(10001)]
        tone = [(t, 5 * t + 0.3 * math.sin(2 * math.pi * 1000 * t)) for t in times]
        self.assertAlmostEqual(water_norms.noise(tone, 0.01, 0.1, 0.9), 0.3 / math.sqrt(2), delta=0.003)
        self.assertAlmostEqual(water_norms.noise([(t, 5 * t) for t in times], 0.01, 0.1, 0.9), 0, places=9)

    def test_deviation_is_about_the_mean_of_its_interval(self):
        tone = [(0.001 * n, 7 + 0.2 * math.sin(2 * math.pi * n / 50)) for n in range(500)] + [(0.5, 100.0)]
        self.assertAlmostEqual(water_norms.deviation(tone, 0.25, 0.5), 0.2 / math.sqrt(2), delta=1e-6)

    def test_only_rises_above_the_start_count(self):
        self.assertEqual(water_norms.rise_above_start([5, 4, 4.5, 3]), 0)
        self.assertEqual(water_norms.rise_above_start([5, 4, 7, 6]), 2)

    def test_quantile(self):
        self.assertEqual(water_norms.quantile([3, 1, 2], 0.5), 2)
        self.assertAlmostEqual(water_norms.quantile(range(11), 0.9), 9)


class Contact(unittest.TestCase):
    """A column of bed and water on the lattice of 5 mm, at x = 0.3 m, hydrostatic."""

    def column(self, void, bed_kind=SEDIMENT, flying=False, excess=0.0):
        dp, rows = 0.005, []
        for n in range(4):
            rows.append((bed_kind, -dp * (n + 0.5), 2000.0))
        if flying:
            rows.append((SEDIMENT, 3.3 * dp, 2000.0))
        lowest = dp * (0.5 + void)
        rows += [(WATER, lowest + dp * n, 1000.0) for n in range(5)]
        top = lowest + 4.5 * dp
        bed_top = 1000 * 9.81 * (top - lowest) + 1500 * 9.81 * (lowest + dp / 2) + excess
        pressure = [bed_top if z == -dp / 2 else 1000 * 9.81 * (top - z) for _, z, _ in rows]
        return {"Type": [kind for kind, _, _ in rows], "Pressure": pressure, "Density": [density for _, _, density in rows],
                "Points": [value for _, z, _ in rows for value in (0.3025, 0.0, z)]}

    def found(self, **made):
        return list(water.DryBed().columns(self.column(**made), 0.005))

    def test_lattice_is_contact(self):
        for kind in (SEDIMENT, WALL):
            (height, excess), = self.found(void=0, bed_kind=kind)
            self.assertAlmostEqual(height, 0.5)
            self.assertAlmostEqual(excess, 0, places=6)

    def test_a_void_is_seen_and_not_its_pressure(self):
        (height, excess), = self.found(void=1.5, excess=300)
        self.assertAlmostEqual(height, 2.0)
        self.assertAlmostEqual(excess, 300, places=6)

    def test_a_flying_grain_is_not_the_bed(self):
        (height, _), = self.found(void=0, flying=True)
        self.assertAlmostEqual(height, 0.5)

    def test_the_place_of_a_lone_missing_grain_is_no_void(self):
        """The column has lost its highest grain; the next one, a spacing aside, has not."""
        particles = self.column(void=0)
        particles["Points"][0:3] = [0.3074, 0.0, -0.0025]
        (height, _), = water.DryBed().columns(particles, 0.005)
        self.assertAlmostEqual(height, 0.5)

    def test_only_columns_beyond_the_gate_count(self):
        particles = self.column(void=0)
        particles["Points"] = [value - 0.1 if n % 3 == 0 else value for n, value in enumerate(particles["Points"])]
        self.assertEqual(list(water.DryBed().columns(particles, 0.005)), [])


class Energy(unittest.TestCase):
    def test_a_rise_is_a_height_in_spacings(self):
        """10 kg lifted by 2 mm at a spacing of 5 mm."""
        with tempfile.TemporaryDirectory() as folder:
            run = types.SimpleNamespace(folder=pathlib.Path(folder))
            (run.folder / "case.resolved.toml").write_text('[numerics]\nspacing = "0.005 m"\n', encoding="utf-8")
            with (run.folder / "history.csv").open("w", encoding="utf-8") as file:
                table = csv.writer(file)
                table.writerow(["time [s]", "kinetic_energy [J]", "potential_energy [J]", "internal_energy [J]", "water_mass [kg]",
                                "sediment_mass [kg]"])
                for time, rise in ((0, 0), (1, -1), (2, 10 * 9.81 * 0.002), (3, 0.1)):
                    table.writerow([time, rise, 5, 1, 4, 6])
            self.assertAlmostEqual(water.energy_rise(run), 0.4)


if __name__ == "__main__":
    unittest.main()
