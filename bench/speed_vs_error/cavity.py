"""The lid-driven cavity (scenes/cavity): the start of a run, and its distance from tabulated profiles."""

import math

from study import norms
from study.origin import ROOT
from thalweg.particle_file import arrays, of_fluid, replace_arrays
from study.results import quantity, resolved, snapshots
from thalweg.tables import read_table

TABLE = ROOT / "bench/speed_vs_error/reference/cavity.csv"
SIDE, LID = 1.0, 1.0  # [m], [m/s]
# Pressure at the start over rho U^2 [-]: above the depth of the vortex's core (0.11 at Re = 1000), so that little of the water
# pulls; more of it makes the lattice stiff, which brakes (error 7.2 % with 0.2, 8.9 % with 1 at Re = 1000, 32 along a side).
BACKGROUND = 0.2


def linear_fit(samples):
    """The value at 0 of the plane through (x, z, value, weight), least squares; the weighted mean where the points are too few."""
    sums = [[0.0] * 4 for _ in range(3)]
    for x, z, value, weight in samples:
        row = (1.0, x, z)
        for i in range(3):
            for j, entry in enumerate((*row, value)):
                sums[i][j] += weight * row[i] * entry
    (w, sx, sz, v), (_, xx, xz, xv), (_, _, zz, zv) = sums
    minors = xx * zz - xz * xz, sx * zz - sz * xz, sx * xz - sz * xx
    determinant = w * minors[0] - sx * minors[1] + sz * minors[2]
    if not determinant > 1e-9 * w * xx * zz:
        return v / w
    return (v * minors[0] - xv * minors[1] + zv * minors[2]) / determinant


def velocity_at(point, particles, fluid, reach):
    """Velocity (x, z) [m/s] at a point, from the particles within `reach` [m], weighed by Wendland's kernel."""
    near = []
    for i in fluid:
        x, z = particles["Points"][3 * i] - point[0], particles["Points"][3 * i + 2] - point[1]
        closeness = 1 - math.hypot(x, z) / reach
        if closeness > 0:
            near.append((i, x, z, closeness ** 4 * (5 - 4 * closeness)))
    return [linear_fit([(x, z, particles["Velocity"][3 * i + c], weight) for i, x, z, weight in near]) for c in (0, 2)]


class Cavity:
    """Means over the snapshots of the run's last quarter; the places on walls and lid do not count."""

    def start(self, folder):
        """Under a pressure, so that the flow does not tear."""
        file, case = folder / "particles.vtp", resolved(folder)
        numerics = case["numerics"]
        sound = quantity(numerics["sound_speed_factor"]) * quantity(numerics["maximum_speed"])
        density, pressure = quantity(case["materials"]["water"]["density"]), BACKGROUND * LID ** 2
        particles = arrays(file, {"Type", "Density", "Pressure", "Mass"})
        fluid = set(of_fluid(particles))

        def changed(name, change):
            return [change(value) if i in fluid else value for i, value in enumerate(particles[name])]

        excess = pressure / sound ** 2
        replace_arrays(file, {"Density": changed("Density", lambda _: density * (1 + excess)),
                              "Mass": changed("Mass", lambda mass: mass * (1 + excess)),
                              "Pressure": changed("Pressure", lambda _: density * pressure)})

    def profiles(self, run):
        """Rows of the table with what the run has: (row, velocity over the lid's)."""
        case, files = resolved(run.folder), snapshots(run.folder)
        reach = 1.5 * quantity(case["numerics"]["spacing"])
        rows = [row for row in read_table(TABLE) if 0 < row["place"] < 1]
        sums = [0.0] * len(rows)
        last = files[-max(1, len(files) // 4):]
        for file in last:
            particles = arrays(file, {"Type", "Points", "Velocity"})
            fluid = of_fluid(particles)
            for n, row in enumerate(rows):
                along_x = row["velocity"] == "w"
                point = (row["place"] * SIDE, SIDE / 2) if along_x else (SIDE / 2, row["place"] * SIDE)
                sums[n] += velocity_at(point, particles, fluid, reach)[1 if along_x else 0]
        return [(row, total / len(last) / LID) for row, total in zip(rows, sums)]

    def errors(self, run, finest=None):
        water = resolved(run.folder)["materials"]["water"]
        reynolds = round(quantity(water["density"]) * LID * SIDE / quantity(water["viscosity"]))
        found = self.profiles(run)
        tables = [name for name in ("ghia", "botella") if f"{name}_{reynolds}" in found[0][0]]
        errors = {}
        for name in tables:
            wrong = [value - row[f"{name}_{reynolds}"] for row, value in found]
            label = "velocity" if name == "ghia" else f"velocity, {name}"
            errors |= {label: norms.rms(wrong), f"largest, {name}": max(abs(w) for w in wrong)}
        return errors
