"""Results of a run as NumPy arrays: tables, particles, surfaces and profiles of its folder (docs/file-formats.md)."""

import pathlib
import re
import tomllib
from functools import cached_property

import numpy

from thalweg.faults import InputError
from thalweg.tables import text_rows
from thalweg.units import si
from thalweg.vtp import read_vtp


class Table:
    """A CSV table of ours. table["bed"] is a column, NaN where a cell is empty; texts are an array of texts. table.units: name → unit."""

    def __init__(self, file):
        self.file = pathlib.Path(file)
        try:
            rows = text_rows(self.file)
        except OSError as error:
            raise InputError(f"{file}: cannot be read ({error.strerror}); give a table that is there") from error
        self.rows, self.units, self._columns = len(rows), {}, {}
        for heading in rows[0] if rows else []:
            name, _, unit = (heading or "").partition(" [")
            self.units[name] = unit.rstrip("]")
            self._columns[name] = _numbers([row[heading] for row in rows])

    @property
    def names(self):
        return list(self._columns)

    def __len__(self):
        return self.rows

    def __contains__(self, name):
        return name in self._columns

    def __getitem__(self, name):
        if name not in self._columns:
            raise KeyError(f"{self.file.name} has no column {name}; there are {', '.join(self._columns) or 'none'}")
        return self._columns[name]


def _numbers(cells):
    try:
        return numpy.array([float(cell) if cell else numpy.nan for cell in cells])
    except ValueError:
        return numpy.array([cell or "" for cell in cells])


class Run:
    """A run's folder: what is in it is read when it is asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not (self.folder / "case.resolved.toml").is_file():
            raise InputError(f"{folder}: holds no run; give the folder that thalweg run has written")

    def table(self, name):
        """A table of the folder: "history.csv", "profiles/front.csv", "report/errors.csv"."""
        return Table(self.folder / name)

    @cached_property
    def case(self):
        """The case with all its defaults, as a dictionary."""
        return tomllib.loads((self.folder / "case.resolved.toml").read_text(encoding="utf-8"))

    @cached_property
    def spacing(self):
        """[m]"""
        return si(self.case["numerics"]["spacing"])

    @cached_property
    def history(self):
        """Energies, masses, time step over time."""
        return self.table("history.csv")

    @cached_property
    def gauges(self):
        """Readings of the gauges during the run: columns NAME.level and so on."""
        return self.table("gauges.csv")

    @cached_property
    def series(self):
        """Scour, deposition and volumes over time."""
        return self.table("profiles/series.csv")

    @cached_property
    def summary(self):
        """One entry per fact about the run, as texts: quantity → value."""
        return {row["quantity"]: row["value"] for row in text_rows(self.folder / "summary.csv")}

    @cached_property
    def warnings(self):
        """What the programs have warned of."""
        return [line for file in sorted(self.folder.glob("warnings/*.txt")) for line in file.read_text(encoding="utf-8").splitlines() if line]

    def _entries(self, series):
        """(time [s], file) of a .pvd file."""
        file = self.folder / series
        if not file.is_file():
            raise InputError(f"{self.folder}: has no {series}; run the program that writes it (docs/file-formats.md)")
        found = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', file.read_text(encoding="utf-8"))
        return sorted((float(time), file.parent / name) for time, name in found)

    @property
    def times(self):
        """[s] of the snapshots."""
        return numpy.array([time for time, _ in self._entries("snapshots.pvd")])

    def particles(self, time=None):
        """The particles of the snapshot nearest to a time [s], without one of the last."""
        return read_vtp(_nearest(self._entries("snapshots.pvd"), time))

    def surface(self, name, time=None):
        """"free_surface", "bed" or "motionless_bed" at the time [s] nearest to the one given, without one the last."""
        return read_vtp(_nearest(self._entries(f"surfaces/{name}.pvd"), time))

    def profile(self, time=None, line=None):
        """Free surface, bed and moving bed along x, or along a [[line]] of the case, nearest to a time [s]."""
        folder = self.folder / "profiles" / (line or "all")
        files = sorted((float(file.stem[1:]), file) for file in folder.glob("t*.csv"))
        if not files:
            raise InputError(f"{folder}: has no profiles; run thalweg postproc {self.folder}")
        return Table(_nearest(files, time))


def _nearest(entries, time):
    if not entries:
        raise InputError("the series is empty; run the program that writes it again")
    return entries[-1][1] if time is None else min(entries, key=lambda entry: abs(entry[0] - time))[1]
