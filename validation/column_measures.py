"""Measures of the tables that solver and postproc write."""

import math

from study.norms import slope
from validation.keys import Key
from validation.library import measure
from validation.points import Point
from validation.references import as_list

WINDOW = (
    Key("from", "number", "begin of the window [s]; default: the run's start"),
    Key("to", "number", "end of the window [s]; default: the run's end"),
    Key("last", "positive number", "in place of `from`: the window is this share of the run, at its end"),
)


def window(finished, entry):
    """Begin and end [s]."""
    given = entry.given
    end = given.get("to", finished.end)
    return given.get("from", finished.end * (1 - given["last"]) if "last" in given else 0.0), end


def within(finished, series, begin, end):
    """The samples (time, value) of the window; InputError if there are none."""
    edge = 1e-9 + 1e-9 * abs(end)
    found = [(time, value) for time, value in series if begin - edge <= time <= end + edge]
    if not found:
        finished.fail(f"run {finished.run.name} has no value between {begin:g} and {end:g} s; give a window within the run")
    return found


def mean(series):
    return sum(value for _, value in series) / len(series)


def trend(series):
    """Slope of the straight line through samples, least squares."""
    return slope([time for time, _ in series], [value for _, value in series])


def running_mean(series, over):
    """Each sample replaced by the mean over so long [s] around it, less where the series ends."""
    means, first, behind, total = [], 0, 0, 0.0
    for time, _ in series:
        while behind < len(series) and series[behind][0] <= time + over / 2 + 1e-12:
            total += series[behind][1]
            behind += 1
        while series[first][0] < time - over / 2 - 1e-12:
            total -= series[first][1]
            first += 1
        means.append((time, total / (behind - first)))
    return means


def noise(series, over):
    smooth = running_mean(series, over)
    return math.sqrt(mean([(time, (value - level) ** 2) for (time, value), (_, level) in zip(series, smooth)]))


def arrival(series, above):
    """Time [s] of the first larger value; infinite without one."""
    return next((time for time, value in series if value > above), math.inf)


STATISTICS = {
    "mean": mean,
    "last": lambda series: series[-1][1],
    "largest": lambda series: max(value for _, value in series),
    "smallest": lambda series: min(value for _, value in series),
    "trend": trend,                                                       # per second
    "drift": lambda series: trend(series) * (series[-1][0] - series[0][0]),  # over the window
    "change": lambda series: max((value - series[0][1] for _, value in series), key=abs),
}
WITH_A_KEY = {"arrival": (arrival, "above"), "noise": (noise, "over")}


def statistic(finished, entry, series):
    """The statistic of a series over its window."""
    given = entry.given
    name = given.get("statistic", "last")
    if name in WITH_A_KEY:
        of, key = WITH_A_KEY[name]
        if key not in given:
            finished.fail(f'the statistic "{name}" needs the key `{key}`')
        return of(within(finished, series, *window(finished, entry)), given[key])
    if "over" in given:
        series = running_mean(series, given["over"])
    return STATISTICS[name](within(finished, series, *window(finished, entry)))


@measure("column", "A column of a table over time (history.csv, gauges.csv, profiles/front.csv, profiles/series.csv …). Where times are "
         "given (`at`, or a reference with times): its value at the nearest row. Else a statistic over a window.",
         Key("file", "text", "the table, in the run's folder", required=True),
         Key("column", "text or texts", "its column, without the unit; several: one for each reference_column", required=True),
         Key("statistic", "text", "mean, last, largest, smallest, trend (slope per second), drift (trend times the window), change "
                                  "(farthest from the first value), arrival (time [s] of the first value above `above`), noise (root of "
                                  "mean squares of the values less their running means over `over`); default: last", words=(*STATISTICS, *WITH_A_KEY)),
         *WINDOW,
         Key("above", "number", "of the arrival"),
         Key("over", "positive number", "values are replaced by their running means over so long [s]; of the noise, taken off them"),
         Key("clock", "text", "its column of times [s]; default: time, that of the water (bed_time: that of a bed that is a surface)"),
         Key("less", "number", "is taken from every value"),
         Key("empty", "number", "counts where a cell is empty (dry gauge); default: the row is left out"))
def column(finished, entry, _):
    given, less = entry.given, entry.given.get("less", 0.0)
    columns = as_list(given["column"])
    points = []
    for number, name in enumerate(columns):
        series = finished.column(given["file"], name, given.get("empty"), given.get("clock", "time"))

        def sample(time, series=series):
            if time is None:
                return statistic(finished, entry, series) - less
            if isinstance(time, tuple):
                return mean(within(finished, series, *time)) - less
            gap = max((after[0] - before[0] for before, after in zip(series, series[1:])), default=0.0)
            near = min(series, key=lambda row: abs(row[0] - time), default=(float("inf"), 0.0))
            if abs(near[0] - time) > gap + 1e-9:
                finished.fail(f"run {finished.run.name} has no row near {time:g} s in {given['file']}; it ends at {finished.end:g} s")
            return near[1] - less

        for point in entry.reference.points(sample, number if entry.reference.columns > 1 else 0):
            if len(columns) > 1:
                point.at = f"{name} at {point.at:g} s" if isinstance(point.at, float) else name
            points.append(point)
    return points


@measure("energy rise", "Largest rise of the total energy over the run, as the height [m] by which it would lift all fluid. Nothing may "
         "add energy: 0 is known.",
         Key("above", "text", '"start" (default): above the first value; "lowest": above the lowest value before',
             words=("start", "lowest")), reference=False)
def energy_rise(finished, entry, _):
    rows = finished.table("history.csv")
    energies = [row["kinetic_energy"] + row["potential_energy"] + row["internal_energy"] for row in rows]
    base, rise = energies[0], 0.0
    for energy in energies:
        rise = max(rise, energy - base)
        if entry.given.get("above", "start") == "lowest":
            base = min(base, energy)
    weight = (rows[0]["water_mass"] + rows[0]["sediment_mass"]) * finished.gravity
    return [Point("", rise / weight, 0.0, 0.0)]
