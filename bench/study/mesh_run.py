"""A run of a study on a mesh: a case with some keys changed, computed by OpenFOAM once, and its fields."""

import array
import json
import re
import shutil

from study.costs import overrides
from thalweg.programs import call
from thalweg.tables import read_table


class MeshRun:
    """The case with `settings` (as of --set) in cells of the size `cell`, by a model of thalweg foam."""

    def __init__(self, thalweg, runs, case, name, settings, cell, model):
        self.thalweg, self.case, self.name, self.cell, self.model = thalweg, case, name, cell, model
        self.settings = [f"{model} {cell}", *settings]
        self.root = runs / re.sub(r"[^\w.]+", "_", name)
        self.folder = self.root / "foam" / model  # of profiles, gauges and case/

    def complete(self):
        mark = self.root / "study.json"
        return mark.exists() and json.loads(mark.read_text(encoding="utf-8")) == self.settings

    def compute(self):
        """Computes what is not there yet."""
        if self.complete():
            return
        shutil.rmtree(self.root, ignore_errors=True)
        call(self.thalweg, "foam", self.case, "--out", self.root, "--cell", self.cell, "--model", self.model, "--meshes", "1",
             *overrides(self.settings[1:]))
        (self.root / "study.json").write_text(json.dumps(self.settings), encoding="utf-8")
        print(f"done: {self.name}", flush=True)

    def summary(self, quantity):
        return next(row["value"] for row in read_table(self.folder / "summary.csv") if row["quantity"] == quantity)

    def cpu_seconds(self):
        """Processor time of all programs of OpenFOAM [s], meshing included."""
        return self.summary("cpu_seconds")

    def profiles(self):
        """The profiles at compare.times, by time: (time [s], rows)."""
        files = sorted((self.folder / "profiles").glob("t*.csv"))
        return [(float(file.stem[1:]), read_table(file)) for file in files]

    def times(self):
        """The folders of fields, by time: (time [s], folder); not the start."""
        found = []
        for folder in (self.folder / "case").iterdir():
            if folder.is_dir() and re.fullmatch(r"[0-9.]+(e-[0-9]+)?", folder.name) and float(folder.name) > 0:
                found.append((float(folder.name), folder))
        return sorted(found)

    def centres(self):
        """Of the cells [m], as (x, y, z)."""
        constant = self.folder / "case/constant"
        columns = [field(constant / name) for name in ("Cx", "Cy", "Cz")]
        count = max(len(column) for column in columns)
        return list(zip(*(column if len(column) == count else column * count for column in columns)))


def field(file):
    """Values of a field in OpenFOAM's binary format, one for each cell; a vector's components one after the other. A uniform
    field is a single value."""
    data = file.read_bytes()
    if uniform := re.search(rb"internalField\s+uniform\s+\(?([^;)]*)\)?\s*;", data):
        return [float(word) for word in uniform.group(1).split()]
    head = re.search(rb"internalField\s+nonuniform\s+List<(scalar|vector)>\s*(\d+)\s*\(", data)
    if head is None:
        raise RuntimeError(f"{file}: is no binary field of numbers")
    count = int(head.group(2)) * (3 if head.group(1) == b"vector" else 1)
    return array.array("d", data[head.end():head.end() + 8 * count]).tolist()


def each(values, count):
    """One value, or one vector, for each cell, also of a uniform field."""
    return values * count if len(values) in (1, 3) else values
