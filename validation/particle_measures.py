"""Measures of the particles in the snapshots of a run, and of the profiles that postproc makes of them."""

import math

from study.norms import layered_pressure, rms
from study.of_particles import front_of_water
from thalweg.particle_file import SEDIMENT, WATER, of_fluid
from validation.keys import Key
from validation.library import measure
from validation.points import Point
from validation.references import as_list

PHASES = {"water": WATER, "sediment": SEDIMENT}
COMPONENTS = ("u", "v")


@measure("water front", "Foremost edge of the water along x [m]: half a spacing beyond the third foremost particle.")
def water_front(finished, entry, _):
    def sample(time):
        found = finished.particles(finished.snapshot(time), ("Points", "Type"))
        return front_of_water(found, finished.spacing)
    return entry.reference.points(sample)


@measure("creep", "Largest way of a particle of sediment from the first to the last snapshot [m]. In nature it rests: 0 is known.",
         reference=False)
def creep(finished, entry, _):
    first, last = (finished.particles(file, ("Points", "Type", "Id")) for _, file in (finished.snapshots[0], finished.snapshots[-1]))
    begun = {first["Id"][i]: first["Points"][3 * i:3 * i + 3] for i, kind in enumerate(first["Type"]) if kind == SEDIMENT}
    if not begun:
        finished.fail(f"run {finished.run.name} has no sediment; take the entry out")
    ways = [math.dist(begun[last["Id"][i]], last["Points"][3 * i:3 * i + 3])
            for i, kind in enumerate(last["Type"]) if kind == SEDIMENT and last["Id"][i] in begun]
    return [Point("", max(ways), 0.0, 0.0)]


@measure("water speed", "Root mean square speed of the water in a snapshot [m/s].")
def water_speed(finished, entry, _):
    def sample(time):
        found = finished.particles(finished.snapshot(time), ("Velocity", "Type"))
        return rms(math.hypot(*found["Velocity"][3 * i:3 * i + 3]) for i, kind in enumerate(found["Type"]) if kind == WATER)
    return entry.reference.points(sample)


@measure("hydrostatic pressure", "Pressure [Pa] of every particle of the last snapshot, against the weight of what lies over it.",
         Key("layers", "pairs", "top [m] and density [kg/m^3] of each layer, the lowest first", required=True), reference=False)
def hydrostatic_pressure(finished, entry, _):
    found = finished.particles(finished.snapshot(None), ("Points", "Type", "Pressure"))
    layers = entry.given["layers"]
    points = []
    for i in of_fluid(found):
        z = found["Points"][3 * i + 2]
        known = layered_pressure(z, layers, finished.gravity)
        points.append(Point(f"z = {z:.4g} m", found["Pressure"][i], known, known))
    return points


@measure("particle mean", "Mean of an array over the particles of one phase in a box.",
         Key("array", "text", "a point array of the snapshots (docs/file-formats.md)", required=True),
         Key("of", "text", "water or sediment", required=True, words=tuple(PHASES)),
         Key("box", "pairs", "lowest and highest x, and z [m]: [[0, 0.05], [0, 0.006]]", required=True))
def particle_mean(finished, entry, _):
    (x0, x1), (z0, z1) = entry.given["box"][0], entry.given["box"][-1]

    def sample(time):
        found = finished.particles(finished.snapshot(time), ("Points", "Type", entry.given["array"]))
        values, places = found[entry.given["array"]], found["Points"]
        inside = [values[i] for i, kind in enumerate(found["Type"]) if kind == PHASES[entry.given["of"]]
                  and x0 <= places[3 * i] <= x1 and z0 <= places[3 * i + 2] <= z1]
        if not inside:
            finished.fail(f"run {finished.run.name} has no {entry.given['of']} in the box at {time} s; enlarge it")
        return sum(inside) / len(inside)
    return entry.reference.points(sample)


def rows_of_water(finished, array, floor, begin):
    """Mean height over `floor` [m] and mean of an array in every row of water one spacing high, over the snapshots from `begin`
    [s] on, the lowest first. Rows with less than a fiftieth of the fullest are particles that fly over the surface."""
    sums = {}
    for _, file in (entry for entry in finished.snapshots if entry[0] >= begin - 1e-9):
        found = finished.particles(file, ("Points", "Type", array))
        each = len(found[array]) // len(found["Type"])  # of a vector the component along x
        for i, kind in enumerate(found["Type"]):
            if kind == WATER:
                height = found["Points"][3 * i + 2] - floor
                row = sums.setdefault(max(0, int(height / finished.spacing)), [0, 0.0, 0.0])
                row[0], row[1], row[2] = row[0] + 1, row[1] + height, row[2] + found[array][each * i]
    fullest = max((count for count, _, _ in sums.values()), default=0)
    return [(height / count, value / count) for _, (count, height, value) in sorted(sums.items()) if count >= 0.02 * fullest]


@measure("water over height", "Mean of an array of the water over its height: rows one spacing high, mean over the last snapshots, linear "
         "between their middles. What is known stands in a table, in which `reference_at` names the column of heights [m]. Heights below the "
         "lowest row's middle or above the highest's are left out.",
         Key("array", "text", "a point array of the snapshots (docs/file-formats.md); of a vector the component along x", required=True),
         Key("floor", "number", "height [m] of the floor or bed from which the table counts; default: 0"),
         Key("last", "positive number", "share of the run, at its end, over which is averaged; default: the last third"),
         Key("logarithmic", "flag", "true: the decimal logarithm is compared, and interpolated"))
def water_over_height(finished, entry, _):
    given = entry.given
    taken = (lambda value: math.log10(max(value, 1e-300))) if given.get("logarithmic") else float
    rows = [(height, taken(value)) for height, value in
            rows_of_water(finished, given["array"], given.get("floor", 0.0), finished.end * (1 - given.get("last", 1 / 3)))]

    def sample(height):
        for (z, value), (above, after) in zip(rows, rows[1:]):
            if z <= height <= above:
                return value + (after - value) * (height - z) / (above - z)
        return None
    return [Point(f"z = {point.at:.4g} m", point.computed, taken(point.low), taken(point.high))
            for point in entry.reference.points(sample) if point.computed is not None]


@measure("toe", "Farthest place along x [m] at which a curve of the profile is as high as `height`, linear between its points.",
         Key("curve", "text", "bed (default), free_surface or moving_bed", words=("bed", "free_surface", "moving_bed")),
         Key("height", "number", "[m]", required=True))
def toe(finished, entry, _):
    height = entry.given["height"]

    def sample(time):
        profile = finished.profile(finished.end if time is None else time, entry.given.get("curve", "bed"))
        for (x, z), (after, below) in reversed(list(zip(profile, profile[1:]))):
            if z >= height > below:
                return x + (after - x) * (z - height) / (z - below)
        finished.fail(f"no height of run {finished.run.name} falls through {height:g} m; give another height")
    return entry.reference.points(sample)


def surface_of_water(found, spacing):
    """(x, y) [m], height [m] and velocity [m/s] of the highest particle of water in every column one spacing wide."""
    columns = {}
    for i, kind in enumerate(found["Type"]):
        if kind == WATER:
            x, y, z = found["Points"][3 * i:3 * i + 3]
            column = math.floor(x / spacing), math.floor(y / spacing)
            if column not in columns or columns[column][2] < z:
                columns[column] = x, y, z, found["Velocity"][3 * i:3 * i + 3]
    return list(columns.values())


@measure("surface velocity", "Velocity of the water's surface [m/s] at one time in space, as floats on it show it: mean over a square around "
         "each place of the highest water in every column one spacing wide. What is known stands in a table, in which `reference_at` names "
         "the columns of x and y [m]. Where the run has no water the velocity counts as 0.",
         Key("column", "text or texts", "components, u along x and v along y, in the order of `reference_column`", required=True),
         Key("time", "number", "time [s] of a snapshot", required=True),
         Key("over", "positive number", "side of the square [m]", required=True))
def surface_velocity(finished, entry, _):
    surface = surface_of_water(finished.particles(finished.snapshot(entry.given["time"]), ("Points", "Velocity", "Type")), finished.spacing)
    half = entry.given["over"] / 2
    points = []
    for number, name in enumerate(as_list(entry.given["column"])):
        if name not in COMPONENTS:
            finished.fail(f"there is no component {name}; give u, v or both", "column")
        component = COMPONENTS.index(name)

        def sample(place, component=component):
            near = [velocity[component] for x, y, _, velocity in surface if abs(x - place[0]) <= half and abs(y - place[1]) <= half]
            return sum(near) / len(near) if near else 0.0
        for place, point in zip(entry.reference.times, entry.reference.points(sample, number)):
            point.at = f"{name} at {place[0]:g}, {place[1]:g} m"
            points.append(point)
    return points
