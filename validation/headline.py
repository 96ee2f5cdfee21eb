"""The headline quantities of a run, from the tables of its report: one number each, with its unit."""

from thalweg.tables import text_rows
from validation.column_measures import STATISTICS
from thalweg.faults import InputError, nearest
from validation.finished import Finished

AT_END = {"profiles/series.csv": ("front", "scour", "scour_x", "scour_y", "deposition", "deposition_x", "deposition_y", "resting_scour",
                                  "eroded", "deposited", "sediment_volume"),
          "profiles/front.csv": ("front",),
          "history.csv": ("bulk_velocity", "excluded")}
EXTREMES = {"history.csv": (("max_speed", "largest"), ("kinetic_energy", "largest")),
            "profiles/series.csv": (("scour", "largest"), ("deposition", "largest"))}
FACTS = ("spacing", "particles", "steps", "cpu_seconds")


def units(folder, name):
    """Column → unit of a table; none for texts."""
    rows = text_rows(folder / name) if (folder / name).exists() else []
    return dict(heading.removesuffix("]").split(" [") for heading in (rows[0] if rows else {}) if heading.endswith("]"))


def last(finished, name, column):
    series = finished.column(name, column)
    return series[-1][1] if series else None


def quantities(run):
    """Name → (value or None, unit) of everything that the tables hold at the end of the run, of extremes over it, and of its cost."""
    finished, found = Finished(run), {}
    for name, columns in AT_END.items():
        there = units(run.folder, name)
        for column in columns:
            if column in there and column not in found:
                found[column] = (last(finished, name, column), there[column])
    for name, columns in EXTREMES.items():
        there = units(run.folder, name)
        for column, statistic in columns:
            series = finished.column(name, column) if column in there else []
            if series:
                label = column if column.startswith("max") else f"{statistic}_{column}"
                found[label] = (STATISTICS[statistic](series), there[column])
    for column, unit in units(run.folder, "gauges.csv").items():
        if column != "time":
            found[column] = (last(finished, "gauges.csv", column), unit)
    facts = {row["quantity"]: row for row in text_rows(run.folder / "summary.csv")}
    for fact in FACTS:
        found[fact] = (float(facts[fact]["value"]), facts[fact]["unit"])
    return found


def asked(text):
    """(file, column, statistic) of a measure FILE:COLUMN:STATISTIC, None for the name of a headline quantity."""
    parts = text.split(":")
    if len(parts) == 1:
        return None
    if len(parts) > 3 or not parts[0].endswith(".csv"):
        raise InputError(f"--measure {text}: is no measure; give a headline quantity, or FILE.csv:COLUMN:STATISTIC")
    statistic = parts[2] if len(parts) == 3 else "last"
    if statistic not in STATISTICS:
        raise InputError(f"--measure {text}: there is no statistic {statistic}; {nearest(statistic, list(STATISTICS))}")
    return parts[0], parts[1], statistic


def measure(run, text, found):
    """(value or None, unit) of a measure; `found`: the run's headline quantities. InputError if the run does not have it."""
    wanted = asked(text)
    if wanted is None:
        if text not in found:
            raise InputError(f"--measure {text}: the run has no such quantity; {nearest(text, list(found))}")
        return found[text]
    name, column, statistic = wanted
    finished = Finished(run)
    finished.where = lambda key: f"--measure {text}"
    series = finished.column(name, column)
    return (STATISTICS[statistic](series) if series else None), units(run.folder, name).get(column, "-")
