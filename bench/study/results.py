"""What the problems read of a run's folder."""

import tomllib

from thalweg.tables import read_table


def resolved(folder):
    return tomllib.loads((folder / "case.resolved.toml").read_text(encoding="utf-8"))


def quantity(text):
    """A number with its unit, as the resolved case writes it: SI."""
    return float(str(text).split()[0])


def snapshots(folder):
    return sorted((folder / "snapshots").glob("*.vtp"))


class Gauges:
    """The readings of a run's gauges, as columns over time."""

    def __init__(self, run):
        self.rows = read_table(run.folder / "gauges.csv")

    def series(self, column, per_time=1.0, per_value=1.0):
        return [(row["time"] / per_time, row[column] / per_value if isinstance(row[column], float) else 0.0)
                for row in self.rows]

    def at(self, column, time):
        """The value at the row nearest to the time; 0 where there was none."""
        return min(self.series(column), key=lambda point: abs(point[0] - time))[1]
