"""What a finished run has left in its folder: tables, snapshots, the resolved case."""

import functools
import math
import re

from thalweg.particle_file import arrays
from study.results import quantity, resolved
from thalweg.tables import read_table
from thalweg.faults import InputError, nearest

NEAR = 0.005  # share of a time by which a snapshot may lie beside it: times in cases are rounded


class Finished:
    """The results of one run; where(key) stands before the message about something that it does not have: "file:line" of the key."""

    def __init__(self, run):
        self.run, self.folder = run, run.folder
        self.where = lambda key: run.name

    @functools.cached_property
    def case(self):
        return resolved(self.folder)

    @functools.cached_property
    def spacing(self):
        return quantity(self.case["numerics"]["spacing"])

    @functools.cached_property
    def gravity(self):
        return abs(quantity(self.case["domain"]["gravity"][-1]))

    @functools.cached_property
    def end(self):
        """Of the water's time [s]; the bed's own end may come before output.end."""
        if quantity(self.case.get("surface_bed", {}).get("end", "0 s")) > 0:
            return self.snapshots[-1][0]
        return quantity(self.case["output"]["end"])

    def fail(self, text, key=None):
        raise InputError(f"{self.where(key)}: {text}")

    @functools.lru_cache(maxsize=None)
    def table(self, name):
        file = self.folder / name
        if not file.exists():
            there = sorted(path.relative_to(self.folder).as_posix() for path in self.folder.glob("*.csv"))
            there += [f"profiles/{path.name}" for path in sorted(self.folder.glob("profiles/*.csv")) if path.stem in ("front", "series")]
            self.fail(f"run {self.run.name} has no {name}; its tables are {', '.join(there)}", "file")
        return read_table(file)

    def column(self, name, column, empty=None, clock="time"):
        """Values over the times of the column `clock`, (time [s], value): rows without a value are left out, or count as
        `empty`."""
        rows = self.table(name)
        for wanted, key in ((column, "column"), (clock, "clock")):
            if rows and wanted in rows[0]:
                continue
            self.fail(f"{name} of run {self.run.name} has no column {wanted}; "
                      f"{nearest(wanted, [known for known in rows[0] if known != 'time'] if rows else ['nothing'])}", key)
        found = [(row[clock], row[column] if isinstance(row[column], float) else empty) for row in rows]
        return [(time, value) for time, value in found if value is not None]

    @functools.cached_property
    def snapshots(self):
        """(time [s], file), in the order of time."""
        series = (self.folder / "snapshots.pvd").read_text(encoding="utf-8")
        entries = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', series)
        return sorted((float(time), self.folder / file) for time, file in entries)

    def snapshot(self, time):
        """The file of the snapshot at this time [s], the last one for None."""
        nearest_one = self.snapshots[-1] if time is None else min(self.snapshots, key=lambda entry: abs(entry[0] - time))
        if time is not None and not math.isclose(nearest_one[0], time, rel_tol=NEAR, abs_tol=1e-6):
            self.fail(f"run {self.run.name} has no snapshot at {time:g} s (the nearest is at {nearest_one[0]:g} s); "
                      "add the time to compare.times, or change the time here", "at")
        return nearest_one[1]

    @functools.lru_cache(maxsize=8)
    def particles(self, file, names):
        """The arrays of a snapshot; `names` is a tuple."""
        found = arrays(file, set(names))
        missing = [name for name in names if name not in found]
        if missing:
            self.fail(f"the snapshots of run {self.run.name} have no array {missing[0]}; name one that its models write "
                      "(docs/file-formats.md)", "array")
        return found

    def profile(self, time, curve):
        """(x, height) [m] of a curve of postproc's profile at this time; empty cells are left out."""
        files = {float(path.stem[1:]): path for path in (self.folder / "profiles/all").glob("t*.csv")}
        near = min(files, key=lambda at: abs(at - time), default=math.inf)
        if not math.isclose(near, time, rel_tol=NEAR, abs_tol=1e-6):
            self.fail(f"run {self.run.name} has no profile at {time:g} s; add the time to compare.times, or change the time here", "at")
        rows = read_table(files[near])
        if curve not in rows[0]:
            self.fail(f"profiles have no curve {curve}; {nearest(curve, list(rows[0]))}", "curve")
        return [(row["x"], row[curve]) for row in rows if isinstance(row[curve], float)]
