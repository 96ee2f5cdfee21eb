#!/usr/bin/env python3
"""Measures the effect of each choice of the model, the scatter of equal runs, and the convergence in the spacing.

Runs the table study.toml: the case as it is, from slightly different starts, with one choice changed at a time, and at
finer and finer spacing. Whatever is there already is kept, so that a study that was stopped goes on where it was. Then
writes effects.csv, effects-convergence.csv, effects-repeatability.csv and effects.svg to OUT and, with --page, a page of
documentation with the picture beside it and, with --record, the tables to bench/records.

All numbers are those of `thalweg postproc`: profiles, fronts, and root mean squares between runs.
"""

import argparse
import itertools
import math
import pathlib
import shutil
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from page import CURVES, Results, draw, page
from study import origin, runs
from study.record import RECORDS
from thalweg.tables import read_table, write_table


class Run(runs.Run):
    """One run of the study: the case with some keys changed, in a folder of its own."""

    def __init__(self, study, name, settings):
        super().__init__(study.thalweg, study.out / "runs", study.case, name, settings)
        self.study = study

    def front(self, time):
        """[m]"""
        return next(row["front"] for row in read_table(self.folder / "profiles/front.csv")
                    if math.isclose(row["time"], time, abs_tol=1e-6))

    def bed_change(self, time):
        """Deepest scour and highest ridge against the first bed [m]."""
        at = {round(row["x"], 6): row["bed"] for row in read_table(self.folder / "profiles" / f"t{time:.3f}.csv")}
        beds = [bed for bed in at.values() if isinstance(bed, float)]
        return self.study.bed_level - min(beds), max(beds) - self.study.bed_level


class Study:
    def __init__(self, thalweg, out, table, spacing):
        self.thalweg, self.out = pathlib.Path(thalweg).resolve(), pathlib.Path(out).resolve()
        self.case = ROOT / table["case"]
        self.times = table["times"]
        self.spacing = spacing or table["base_spacing"]
        at_spacing = [f'numerics.spacing="{self.spacing}"']
        self.base = Run(self, "as it is", at_spacing)
        self.starts = [Run(self, f"start {n}", at_spacing + row["set"]) for n, row in enumerate(table["start"], 1)]
        self.choices = [(row["group"], row["name"], Run(self, f"{row['group']} {row['name']}", at_spacing + row["set"]))
                        for row in table["choice"]]
        self.spacings = [Run(self, row["set"][0].split("=")[1].strip('"'), row["set"]) for row in table["spacing"]]
        shapes = tomllib.loads((self.case / "case.toml").read_text(encoding="utf-8"))["shape"]
        bed = next(shape for shape in shapes if shape["role"] == "sediment")
        self.bed_level = float(bed["to"][-1].split()[0])  # [m] the case file says it in m

    def runs(self):
        return [self.base, *self.starts, *(run for _, _, run in self.choices), *self.spacings]

    def compute(self, jobs):
        """Computes all runs, `jobs` at a time; a run that fails is reported and left out."""
        runs.compute_all(self.runs(), jobs, lambda run: run.compute(postproc=True))

    def scatter(self):
        """Root mean square over all pairs of equal runs by (curve, time); extent of front, scour and ridge by name."""
        members = [run for run in [self.base, *self.starts] if run.complete()]
        pairs = {}
        for n, run in enumerate(members[1:], 1):
            for (_, curve, time), distance in run.profile_distances(members[:n]).items():
                pairs.setdefault((curve, time), []).append(distance)
        rms = {key: math.sqrt(sum(d * d for d in found) / len(found)) for key, found in pairs.items()}
        extents = {}
        for time in self.times:
            for key, values in (("front", [run.front(time) for run in members]),
                                ("scour", [run.bed_change(time)[0] for run in members]),
                                ("ridge", [run.bed_change(time)[1] for run in members])):
                extents[key, time] = max(values) - min(values)
        return rms, extents, len(members)


def figures_of(run, times):
    """Front, scour and ridge of a run at all times [m], and what it cost."""
    row = {}
    for time in times:
        scour, ridge = run.bed_change(time)
        row |= {f"front {time:g} s [m]": f"{run.front(time):.3f}", f"scour {time:g} s [m]": f"{scour:.4f}",
                f"ridge {time:g} s [m]": f"{ridge:.4f}"}
    return row | {"steps [-]": int(run.summary("steps")), "cpu [s]": f"{run.cpu_seconds():.1f}",
                  "viscous iterations a step [-]": run.summary("viscous_iterations_per_step")}


def rms_columns(distances, name, times):
    return {f"{curve} {time:g} s [m]": f"{distances[name, curve, time]:.5f}" if (name, curve, time) in distances else ""
            for curve, time in itertools.product(CURVES, times)}


def effects(study):
    rows = []
    for group, name, run in study.choices:
        if run.complete():
            distances = run.profile_distances([study.base])
            rows.append({"group": group, "choice": name} | rms_columns(distances, study.base.name, study.times) |
                        figures_of(run, study.times))
    return rows


def convergence(study):
    runs = [run for run in study.spacings if run.complete()]
    rows = []
    for run in runs:
        distances = run.profile_distances([runs[-1]]) if run is not runs[-1] else {}
        rows.append({"spacing": run.name} | rms_columns(distances, runs[-1].name, study.times) |
                    figures_of(run, study.times))
    return rows


def repeatability(rms, extents):
    rows = [*rms.items(), *(((f"extent of {name}", time), value) for (name, time), value in extents.items())]
    return [{"curve": curve, "time [s]": time, "rms [m]": f"{value:.5f}"} for (curve, time), value in sorted(rows)]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("thalweg", help="the program, for example build/release/bin/thalweg")
    arguments.add_argument("--out", default="out/effect_study", help="where runs and results go (default: %(default)s)")
    arguments.add_argument("--table", default=pathlib.Path(__file__).with_name("study.toml"), help="what is run")
    arguments.add_argument("--spacing", help="of all runs but those of [[spacing]]; default: the table's")
    arguments.add_argument("--finest", help="leaves out the runs of [[spacing]] beyond this one, for example \"5 mm\"")
    arguments.add_argument("--jobs", type=int, default=1, help="runs at a time, one thread each (default: %(default)s)")
    arguments.add_argument("--record", nargs="?", type=pathlib.Path, const=RECORDS,
                           help="also writes the tables there (without a folder: bench/records)")
    arguments.add_argument("--page", type=pathlib.Path, help="page to write, its picture in images/ beside it")
    given = arguments.parse_args()

    study = Study(given.thalweg, given.out, tomllib.loads(pathlib.Path(given.table).read_text(encoding="utf-8")),
                  given.spacing)
    if given.finest:
        names = [run.name for run in study.spacings]
        if given.finest not in names[1:]:
            arguments.error(f"--finest has to be one of {', '.join(names[1:])}")
        study.spacings = study.spacings[:names.index(given.finest) + 1]
    study.compute(given.jobs)

    rms, extents, members = study.scatter()
    effect_rows, convergence_rows = effects(study), convergence(study)
    equal = f"{members} runs whose water density differs by up to two ten-thousandths"
    made = origin.lines("effect_study/effect_study.py")
    tables = {"effects": (effect_rows, f"{study.case.name} at {study.spacing}; distances: root mean square from the run with nothing "
                                       "changed"),
              "effects-convergence": (convergence_rows, "distances: root mean square from the finest run"),
              "effects-repeatability": (repeatability(rms, extents), f"{equal}, all pairs")}
    for folder in filter(None, (study.out, given.record)):
        for name, (rows, comment) in tables.items():
            write_table(folder / f"{name}.csv", rows, f"{made}\n{comment}")
    results = Results(study.times, effect_rows, convergence_rows, rms, extents)
    picture = study.out / "effects.svg"
    draw(results, picture)
    if given.page:
        images = given.page.parent / "images"
        images.mkdir(parents=True, exist_ok=True)
        shutil.copy(picture, images)
        base = {"group": "as it is", "choice": ""} | rms_columns({}, "", study.times)
        base |= figures_of(study.base, study.times)
        case = study.case.relative_to(ROOT)
        given.page.write_text(page(results, base, f"`{case}` at a spacing of {study.spacing}", equal, origin.commit()),
                              encoding="utf-8")
    print(f"{', '.join(f'{name}.csv' for name in tables)} and {picture.name} in {study.out}")


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("stopped; the same command goes on from here")
