"""Measures against exact laws: the logarithmic law of the wall, Kynch's theory of sedimentation."""

import math

from study.norms import LogLaw, slope
from thalweg.particle_file import SEDIMENT, WATER
from study.results import quantity
from validation.column_measures import mean, within
from validation.keys import Key
from validation.library import measure
from validation.points import Point

DEPTH = Key("depth", "positive number", "depth of the water [m]", required=True)
LAST = Key("last", "positive number", "share of the run, at its end, over which is averaged; default: the last third")


class Current(LogLaw):
    """The logarithmic law of a run that a slope drives: u*² = g H S."""

    def __init__(self, finished, entry):
        case, self.depth = finished.case, entry.given["depth"]
        if "slope" not in case.get("flow", {}):
            finished.fail(f"run {finished.run.name} has no current that a slope drives; take the entry out, or set flow.drive = slope", "measure")
        water = case["materials"]["water"]
        viscosity = quantity(water["viscosity"]) / quantity(water["density"])
        roughness = max(quantity(shape.get("roughness", 0)) for shape in case["shape"] if shape["role"] == "wall")
        super().__init__(math.sqrt(finished.gravity * self.depth * quantity(case["flow"]["slope"])), viscosity, roughness)
        self.begin = finished.end * (1 - entry.given.get("last", 1 / 3))


@measure("log-law velocity", "Mean velocity of the water [m/s] against the mean of the logarithmic law over the depth.", DEPTH, LAST,
         reference=False)
def log_law_velocity(finished, entry, _):
    law = Current(finished, entry)
    series = within(finished, finished.column("history.csv", "bulk_velocity"), law.begin, finished.end)
    return [Point("", mean(series), law.mean(law.depth), law.mean(law.depth))]


@measure("log-law stress", "Drive less change of momentum, (g_x − dU/dt) H, against u*² = g H S [m²/s²]: what the floor takes.", DEPTH, LAST,
         reference=False)
def log_law_stress(finished, entry, _):
    law = Current(finished, entry)
    velocities, drives = (within(finished, finished.column("history.csv", name), law.begin, finished.end)
                          for name in ("bulk_velocity", "drive"))
    rate = slope([time for time, _ in velocities], [value for _, value in velocities])
    return [Point("", (mean(drives) - rate) * law.depth, law.friction ** 2, law.friction ** 2)]


def water_of(finished, begin):
    """(z, velocity along x) of the water in every snapshot from `begin` on."""
    for time, file in finished.snapshots:
        if time >= begin - 1e-9:
            found = finished.particles(file, ("Points", "Velocity", "Type"))
            for i, kind in enumerate(found["Type"]):
                if kind == WATER:
                    yield found["Points"][3 * i + 2], found["Velocity"][3 * i]


@measure("log-law profile", "Velocity [m/s] of every row one spacing high, mean over the snapshots, against the logarithmic law. Rows with less "
         "than a fiftieth of a row's water are particles that fly over the surface, and are left out.", DEPTH, LAST, reference=False)
def log_law_profile(finished, entry, _):
    law, spacing = Current(finished, entry), finished.spacing
    rows = {}
    for z, velocity in water_of(finished, law.begin):
        row = rows.setdefault(max(0, int(z / spacing)), [0, 0.0, 0.0])
        row[0], row[1], row[2] = row[0] + 1, row[1] + velocity, row[2] + law.velocity(z)
    whole = sum(count for count, _, _ in rows.values()) / (round(law.depth / spacing) + 1)
    return [Point(f"z = {(row + 0.5) * spacing:.4g} m", computed / count, known / count, known / count)
            for row, (count, computed, known) in sorted(rows.items()) if count >= 0.02 * whole]


@measure("depth of the current", "Twice the mean height of the water [m] over the snapshots, against the depth.", DEPTH, LAST, reference=False)
def depth_of_the_current(finished, entry, _):
    heights = [z for z, _ in water_of(finished, Current(finished, entry).begin)]
    depth = entry.given["depth"]
    return [Point("", 2 * sum(heights) / len(heights), depth, depth)]


KYNCH = (
    Key("at", "number", "time [s], before the edges meet", required=True),
    DEPTH,
    Key("concentration", "positive number", "volume share of the grains at the start", required=True),
    Key("packing", "positive number", "volume share of the grains in the bed", required=True),
    Key("settling_velocity", "positive number", "of one grain in still water [m/s]", required=True),
    Key("exponent", "positive number", "of (1 − C) in the hindered settling velocity (Richardson & Zaki: 4.65)", required=True),
)


class Kynch:
    """Batch sedimentation (Kynch 1952): the clear water's edge falls at w, a bed rises at w C/(packing − C)."""

    def __init__(self, finished, entry):
        given = entry.given
        self.time, self.depth, self.start = given["at"], given["depth"], given["concentration"]
        self.packing, self.finished = given["packing"], finished
        if not self.start < min(self.packing, 1.0):
            finished.fail("the suspension is as dense as the bed; give a concentration below packing", "concentration")
        self.fall = given["settling_velocity"] * (1 - self.start) ** given["exponent"]
        self.rise = self.fall * self.start / (self.packing - self.start)

    def grains(self, counts):
        """Grains where counts(z), as the height [m] of suspension of the start's concentration that holds them."""
        found = self.finished.particles(self.finished.snapshot(self.time), ("Points", "Type", "Concentration"))
        domain = self.finished.case["domain"]
        width = quantity(domain["to"][0]) - quantity(domain["from"][0])
        share = {WATER: 1.0, SEDIMENT: self.packing}
        return sum(found["Concentration"][i] * share[kind] for i, kind in enumerate(found["Type"])
                   if kind in share and counts(found["Points"][3 * i + 2])) / self.start * self.finished.spacing ** 2 / width


@measure("kynch edge", "Edge of the clear water [m] in batch sedimentation, by the grains in the upper half, against Kynch's theory.", *KYNCH,
         reference=False)
def kynch_edge(finished, entry, _):
    law = Kynch(finished, entry)
    edge = law.depth / 2 + law.grains(lambda z: z > law.depth / 2)
    known = law.depth - law.fall * law.time
    return [Point(law.time, edge, known, known)]


@measure("kynch bed", "Grains below a height in batch sedimentation, as the height [m] of suspension that holds them, against Kynch's theory.",
         *KYNCH, Key("below", "positive number", "[m], above the bed of the theory", required=True), reference=False)
def kynch_bed(finished, entry, _):
    law, below = Kynch(finished, entry), entry.given["below"]
    bed = law.rise * law.time
    known = bed * law.packing / law.start + (below - bed)
    return [Point(law.time, law.grains(lambda z: z < below), known, known)]
