"""Measures of the bed's profile between two places: depth of a hole, height of a dike, and the water that runs over its crest."""

import math

from validation.column_measures import mean, within
from validation.keys import Key
from validation.library import measure
from validation.points import Point

CURVE = Key("curve", "text", "bed (default), free_surface or moving_bed", words=("bed", "free_surface", "moving_bed"))
BETWEEN = (
    Key("begin", "number", "first place along x [m]", required=True),
    Key("end", "number", "last place along x [m]", required=True),
)


def heights(finished, entry, time):
    """Heights [m] of the curve at the places that the entry asks for."""
    given = entry.given
    found = [z for x, z in finished.profile(time, given.get("curve", "bed")) if given["begin"] <= x <= given["end"]]
    if not found:
        finished.fail(f"the {given.get('curve', 'bed')} of run {finished.run.name} has no point between {given['begin']:g} and "
                      f"{given['end']:g} m at {time:g} s; give places where there is one", "begin")
    return found


@measure("depth of a hole", "Largest depth [m] of a curve of the profile below a level, between two places along x.",
         CURVE, *BETWEEN, Key("level", "number", "height [m] from which the depth counts", required=True))
def depth_of_a_hole(finished, entry, _):
    return entry.reference.points(
        lambda time: entry.given["level"] - min(heights(finished, entry, finished.end if time is None else time)))


@measure("height of a crest", "Highest point [m] of a curve of the profile between two places along x.", CURVE, *BETWEEN)
def height_of_a_crest(finished, entry, _):
    return entry.reference.points(lambda time: max(heights(finished, entry, finished.end if time is None else time)))


@measure("rise of a crest", "Largest rise [m] of the curve's highest point between two places along x, above its lowest before, over all "
         "snapshots. Water that runs over a dike raises nothing: 0 is known.", CURVE, *BETWEEN, reference=False)
def rise_of_a_crest(finished, entry, _):
    lowest, rise, when = math.inf, 0.0, 0.0
    for time, _ in finished.snapshots:
        crest = max(heights(finished, entry, time))
        if crest - lowest > rise:
            rise, when = crest - lowest, time
        lowest = min(lowest, crest)
    return [Point(when, rise, 0.0, 0.0)]


@measure("broad-crested weir", "Discharge per width [m²/s] over the bed's crest, the highest point between two places along x, against "
         "(2/3)^1.5 √g h^1.5: critical flow without losses under the head h [m] of the water upstream.",
         *BETWEEN, Key("at", "numbers", "times [s] of snapshots", required=True),
         Key("level", "text", "gauge of the water's level upstream", required=True),
         Key("flux", "text", "gauge of the flux over the crest", required=True),
         Key("over", "positive number", "time [s] around each time over which level and flux are averaged", required=True),
         reference=False)
def broad_crested_weir(finished, entry, _):
    given, points = entry.given, []
    for time in given["at"]:
        level, flux = (mean(within(finished, finished.column("gauges.csv", name), time - given["over"] / 2, time + given["over"] / 2))
                       for name in (f"{given['level']}.level", f"{given['flux']}.water"))
        head = max(level - max(heights(finished, entry, time)), 0.0)
        known = (2 / 3) ** 1.5 * math.sqrt(finished.gravity) * head ** 1.5
        points.append(Point(float(time), flux, known, known))
    return points
