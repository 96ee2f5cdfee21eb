"""The problems on a mesh: the errors of a run of OpenFOAM, by the measures of problems.py.

errors(run, finest, particles): `finest` is the finest mesh of the same model, `particles` the finest run of particles; None where
there is none. A distance from the finest is that from the same method's.
"""

import math

from channel import Channel
from problems import GRAVITY, Box, DamBreak, Impact
from study import norms
from study.mesh_run import each, field
from study.results import Gauges
from thalweg.tables import read_table
from wall_jet import WallJet


def liquid(folder, count):
    """Share of water and sediment in each cell."""
    if (folder / "alpha.air").exists():
        return [1 - air for air in each(field(folder / "alpha.air"), count)]
    return each(field(folder / "alpha.water"), count)


class Still:
    """Pressure and speed in cells of water or sediment, over the second half of the run; `layers` as of norms.layered_pressure()."""

    def __init__(self, layers):
        self.layers = layers

    def errors(self, run, finest=None, particles=None):
        heights = [z for _, _, z in run.centres()]
        count = len(heights)
        wrong, speeds = [], []
        times = run.times()
        for _, folder in times[len(times) // 2:]:
            filled = [cell for cell, share in enumerate(liquid(folder, count)) if share > 0.99]
            pressure, velocity = each(field(folder / "p"), count), each(field(folder / "U"), count)
            exact = [norms.layered_pressure(heights[cell], self.layers, GRAVITY) for cell in filled]
            wrong.append(norms.rms(pressure[cell] - p for cell, p in zip(filled, exact)) / norms.rms(exact))
            speeds.append(norms.rms(math.hypot(*velocity[3 * cell:3 * cell + 3]) for cell in filled))
        return {"pressure": norms.rms(wrong), "speed": norms.rms(speeds) / math.sqrt(GRAVITY * self.layers[-1][0])}


class DamBreakOnMesh(DamBreak):
    """The front is where a column of cells holds at least half a cell of water."""

    def fronts(self, run):
        half = run.summary("cell_size") / 2
        return [max(row["x"] for row in rows if row["free_surface"] - row["floor"] >= half) / self.width + half / self.width
                for _, rows in run.profiles()]

    def errors(self, run, finest=None, particles=None):
        return super().errors(run, finest)


class ImpactOnMesh(Impact):
    """The sensors on the wall."""

    def errors(self, run, finest=None, particles=None):
        return self.of_sensors(run)


class BoxOnMesh(Box):
    """Heights alone: with cells of centimetres the sensors of the pressure lie in the box that is taken out of the mesh."""

    def errors(self, run, finest=None, particles=None):
        return {"height": self.heights(Gauges(run))}


class Louvain:
    """Root mean squares [m] of the profiles over four times from the finest mesh of the model, and from the finest particles."""

    @staticmethod
    def distance(profiles, others, curve):
        squares = []
        for (_, rows), (_, those) in zip(profiles, others):
            known = [(row["x"], row[curve]) for row in those if isinstance(row[curve], float)]
            for row in rows:
                there = interpolated(known, row["x"])
                if isinstance(row[curve], float) and there is not None:
                    squares.append((row[curve] - there) ** 2)
        return math.sqrt(sum(squares) / len(squares))

    def errors(self, run, finest=None, particles=None):
        found = {}
        if finest:
            found |= {"bed": self.distance(run.profiles(), finest.profiles(), "bed"),
                      "surface": self.distance(run.profiles(), finest.profiles(), "free_surface")}
        if particles:
            files = sorted((particles.folder / "profiles").glob("t*.csv"))
            theirs = [(float(file.stem[1:]), read_table(file)) for file in files]
            found |= {"bed from the particles": self.distance(run.profiles(), theirs, "bed"),
                      "surface from the particles": self.distance(run.profiles(), theirs, "free_surface")}
        return found


def interpolated(points, x):
    """A curve of points (x, value), ascending in x, at x; None beside it."""
    for (left, a), (right, b) in zip(points, points[1:]):
        if left <= x <= right:
            return a + (b - a) * (x - left) / (right - left)
    return None


class ChannelOnMesh(Channel):
    """Rows of cells in place of rows of particles; a cell counts by its share of water."""

    def errors(self, run, finest=None, particles=None):
        centres = run.centres()
        samples = []
        for time, folder in run.times():
            if time < self.begin - 1e-6:
                continue
            velocity, share = each(field(folder / "U"), len(centres)), liquid(folder, len(centres))
            samples += [(z, velocity[3 * cell], share[cell]) for cell, (_, _, z) in enumerate(centres) if share[cell] > 0.5]
        return self.of_samples(samples, run.summary("cell_size"))


class WallJetOnMesh(WallJet):
    """Rows of cells in place of rows of particles; a cell counts by its share of water."""

    def errors(self, run, finest=None, particles=None):
        centres = run.centres()
        samples = []
        for time, folder in run.times():
            if time < self.begin:
                continue
            velocity, share = each(field(folder / "U"), len(centres)), liquid(folder, len(centres))
            samples += [(x, z, velocity[3 * cell], share[cell]) for cell, (x, _, z) in enumerate(centres) if share[cell] > 0.5]
        return self.of_samples(samples, run.summary("cell_size"))


ON_MESH = {"dam_break": DamBreakOnMesh(), "impact": ImpactOnMesh(), "spheric02": BoxOnMesh(), "louvain": Louvain(),
           "still_tank": Still([(0.3, 1000.0)]), "still_water": Still([(0.06, 1286.2), (0.16, 1000.0)]), "channel": ChannelOnMesh(),
           "wall_jet": WallJetOnMesh()}
