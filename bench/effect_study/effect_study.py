#!/usr/bin/env python3
"""What each choice of the model changes, beside what equal runs differ by, and how far the spacing is converged.

Runs the table study.toml: the case as it is, from slightly different starts, with one choice changed at a time, and at
finer and finer spacing. Whatever is there already is kept, so that a study that was stopped goes on where it was. Then
writes effects.csv, convergence.csv, repeatability.csv and effects.svg to OUT and, with --page, a page of documentation
with the picture beside it.

All numbers are those of `thalweg postproc`: profiles, fronts, and root mean squares between runs.
"""

import argparse
import csv
import itertools
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
CURVES = ("free_surface", "bed", "moving_bed")


def read_table(file):
    """Rows of a CSV table of ours, units taken off the headings, numbers as numbers."""
    with file.open(encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        rows.fieldnames = [heading.split(" [")[0] for heading in rows.fieldnames]
        return [{key: number(value) for key, value in row.items()} for row in rows]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def write_table(file, rows, comment):
    with file.open("w", encoding="utf-8", newline="") as to:
        to.write(f"# {comment}\n")
        table = csv.DictWriter(to, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


class Run:
    """One run of the study: the case with some keys changed, in a folder of its own."""

    def __init__(self, study, name, settings):
        self.study, self.name, self.settings = study, name, settings
        self.folder = study.out / "runs" / re.sub(r"[^\w.]+", "_", name)

    def complete(self):
        mark = self.folder / "study.json"
        return mark.exists() and json.loads(mark.read_text(encoding="utf-8")) == self.settings

    def compute(self):
        """Computes what is not there yet; continues a run that was stopped on the way."""
        if self.complete():
            return
        begun = self.folder / "study.begun.json"
        same = begun.exists() and json.loads(begun.read_text(encoding="utf-8")) == self.settings
        checkpoint = self.folder / "checkpoint.vtp"
        if not (same and checkpoint.exists()):
            shutil.rmtree(self.folder, ignore_errors=True)
            overrides = [text for setting in self.settings for text in ("--set", setting)]
            self.study.call("gencase", self.study.case, "--out", self.folder, *overrides)
            begun.write_text(json.dumps(self.settings), encoding="utf-8")
            self.study.call("solver", self.folder, "--threads", "1")
        else:
            self.study.call("solver", self.folder, "--threads", "1", "--restart", checkpoint)
        self.study.call("postproc", self.folder)
        begun.rename(self.folder / "study.json")
        print(f"done: {self.name}", flush=True)

    def front(self, time):
        """[m]"""
        return next(row["front"] for row in read_table(self.folder / "profiles/front.csv")
                    if math.isclose(row["time"], time, abs_tol=1e-6))

    def bed_change(self, time):
        """Deepest scour and highest ridge against the first bed [m]."""
        at = {round(row["x"], 6): row["bed"] for row in read_table(self.folder / "profiles" / f"t{time:.3f}.csv")}
        beds = [bed for bed in at.values() if isinstance(bed, float)]
        return self.study.bed_level - min(beds), max(beds) - self.study.bed_level

    def summary(self, quantity):
        return next(row["value"] for row in read_table(self.folder / "summary.csv") if row["quantity"] == quantity)

    def distances(self, others):
        """Root mean square [m] from each of the other runs, by (its name, curve, time)."""
        if not others:
            return {}
        compared = [f"{other.name.replace('=', '')}={other.folder}" for other in others]
        labels = {other.name.replace("=", ""): other.name for other in others}
        self.study.call("postproc", self.folder, "--compare", *compared)
        return {(labels[row["reference"]], row["curve"], row["time"]): row["rmse"]
                for row in read_table(self.folder / "report/errors.csv") if row["reference"] in labels}


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

    def call(self, *arguments):
        result = subprocess.run([self.thalweg, *arguments], capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise RuntimeError(f"thalweg {' '.join(map(str, arguments))}\n{result.stdout}{result.stderr}")
        return result.stdout

    def runs(self):
        return [self.base, *self.starts, *(run for _, _, run in self.choices), *self.spacings]

    def compute(self, jobs):
        """Computes all runs, `jobs` at a time; a run that fails is reported and left out."""
        def one(run):
            try:
                run.compute()
            except RuntimeError as error:
                print(f"FAILED: {run.name}\n{error}", file=sys.stderr, flush=True)
        with ThreadPoolExecutor(jobs) as pool:
            list(pool.map(one, self.runs()))

    def scatter(self):
        """Root mean square over all pairs of equal runs, by (curve, time); extent of front, scour and ridge, by name."""
        members = [run for run in [self.base, *self.starts] if run.complete()]
        pairs = {}
        for n, run in enumerate(members[1:], 1):
            for (_, curve, time), distance in run.distances(members[:n]).items():
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
    return row | {"steps [-]": int(run.summary("steps")), "cpu [s]": f"{run.summary('cpu_seconds'):.1f}",
                  "viscous iterations a step [-]": run.summary("viscous_iterations_per_step")}


def rms_columns(distances, name, times):
    return {f"{curve} {time:g} s [m]": f"{distances[name, curve, time]:.5f}" if (name, curve, time) in distances else ""
            for curve, time in itertools.product(CURVES, times)}


def effects(study):
    rows = []
    for group, name, run in study.choices:
        if run.complete():
            distances = run.distances([study.base])
            rows.append({"group": group, "choice": name} | rms_columns(distances, study.base.name, study.times) |
                        figures_of(run, study.times))
    return rows


def convergence(study):
    runs = [run for run in study.spacings if run.complete()]
    rows = []
    for run in runs:
        distances = run.distances([runs[-1]]) if run is not runs[-1] else {}
        rows.append({"spacing": run.name} | rms_columns(distances, runs[-1].name, study.times) |
                    figures_of(run, study.times))
    return rows


def repeatability(study, rms, extents):
    return [{"curve": curve, "time [s]": time, "rms [m]": f"{value:.5f}"} for (curve, time), value in sorted(rms.items())] + \
           [{"curve": f"extent of {name}", "time [s]": time, "rms [m]": f"{value:.5f}"}
            for (name, time), value in sorted(extents.items())]


def mean_over_times(row, curve, times):
    """Root mean square over the times [mm], of a row with one column a time."""
    values = [float(row[f"{curve} {time:g} s [m]"]) for time in times if row[f"{curve} {time:g} s [m]"]]
    return 1e3 * math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def draw(study, effect_rows, convergence_rows, rms, picture):
    """The picture: bars of what each choice does to the bed, the scatter as a line; convergence beside it."""
    times = study.times
    scatter = {curve: 1e3 * math.sqrt(sum(rms[curve, t] ** 2 for t in times) / len(times)) for curve in CURVES}
    bars = "\n".join(f'"{row["group"]}: {row["choice"]}" {mean_over_times(row, "bed", times):.3f} '
                     f'{mean_over_times(row, "free_surface", times):.3f}' for row in reversed(effect_rows))
    points = "\n".join(f'{row["spacing"].split()[0]} {mean_over_times(row, "bed", times):.3f} '
                       f'{mean_over_times(row, "free_surface", times):.3f} {row[f"front {times[-1]:g} s [m]"]} '
                       f'{1e3 * float(row[f"scour {times[-1]:g} s [m]"]):.2f}' for row in convergence_rows)
    script = f"""
set terminal svg size 1000,{520 + 26 * len(effect_rows)} font "sans,13" background "white"
set output "{picture.name}"
$effects << END
{bars}
END
$spacings << END
{points}
END
set multiplot
set origin 0,0.4
set size 1,0.6
set lmargin at screen 0.42
set title "What each choice changes, root mean square over the profile and {len(times)} times"
set xlabel "mm"
set yrange [-0.5:{len(effect_rows)}-0.5]
set ytics nomirror
set xrange [0:*]
set key at graph 0.98,0.14
set arrow 1 from first {scatter["bed"]:.3f},graph 0 to first {scatter["bed"]:.3f},graph 1 nohead dt 2 lw 2
plot $effects using 2:0:(0):2:($0-0.35):($0) with boxxyerror fs solid 0.8 lc rgb "#8c6239" title "bed", \\
     $effects using 3:0:(0):3:($0):($0+0.35):ytic(1) with boxxyerror fs solid 0.8 lc rgb "#2b6cb0" title "free surface", \\
     1/0 with lines dt 2 lw 2 lc rgb "black" title "bed of equal runs"
unset arrow 1
unset lmargin
set yrange [0:*]
set ytics auto
set xrange [0:{1.1 * max(float(row["spacing"].split()[0]) for row in convergence_rows):g}]
set xlabel "spacing [mm]"
set key default
set key bottom right
set origin 0,0
set size 0.5,0.4
set title "Distance from the finest run [mm]"
plot $spacings using 1:2 with linespoints pt 7 lc rgb "#8c6239" title "bed", \\
     $spacings using 1:3 with linespoints pt 7 lc rgb "#2b6cb0" title "free surface"
set origin 0.5,0
set title "Front [m] and scour [cm] at {times[-1]:g} s"
plot $spacings using 1:4 with linespoints pt 7 lc rgb "#2b6cb0" title "front", \\
     $spacings using 1:($5/10) with linespoints pt 7 lc rgb "#8c6239" title "scour"
unset multiplot
"""
    file = picture.with_suffix(".gnuplot")
    file.write_text(script, encoding="utf-8")
    result = subprocess.run(["gnuplot", file.name], cwd=picture.parent, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"gnuplot: {result.stderr}")


def markdown(columns, rows):
    yield "| " + " | ".join(columns) + " |"
    yield "|" + "---|" * len(columns)
    for row in rows:
        yield "| " + " | ".join(str(cell) for cell in row) + " |"


def series_of(row, name, times, factor, digits):
    return " ".join(f"{factor * float(row[f'{name} {time:g} s [m]']):.{digits}f}"
                    if row[f"{name} {time:g} s [m]"] else "–" for time in times)


def ratio(distance, scatter):
    return f"{distance / scatter:.1f}" if scatter > 0 and not math.isnan(distance) else "–"


def page(study, effect_rows, convergence_rows, rms, extents, members, picture):
    """The page of documentation: tables and picture, and how they were made."""
    times = study.times
    when = ", ".join(f"{time:g}" for time in times)
    scatter = {curve: 1e3 * math.sqrt(sum(rms[curve, t] ** 2 for t in times) / len(times)) for curve in CURVES}
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True)
    lines = [
        "# What each choice changes", "",
        f"The case `{study.case.relative_to(ROOT)}` at a spacing of {study.spacing}, one choice changed at a time; distances are root mean",
        f"squares between profiles at t = {when} s, in mm. Written by `bench/effect_study/effect_study.py` at commit",
        f"{commit.stdout.strip()}; the table of runs is `study.toml` beside it. Spacing and scatter bound what can be read from",
        "it: an effect smaller than the scatter is none, and one smaller than the distance to the finest run may be of the spacing.", "",
        f"![Effects and convergence]({picture})", "",
        "## What equal runs differ by", "",
        f"{members} runs whose water density differs by up to two ten-thousandths: root mean square over all pairs, and the extent from the least",
        "to the largest front, scour and ridge.", "",
        *markdown(["", *(f"{time:g} s" for time in times)],
                  [[f"{curve.replace('_', ' ')} [mm]", *(f"{1e3 * rms[curve, t]:.2f}" for t in times)] for curve in CURVES] +
                  [[f"{name} [mm]", *(f"{1e3 * extents[name, t]:.1f}" for t in times)] for name in ("front", "scour", "ridge")]),
        "", "## Effects", "",
        "Bed / scatter: root mean square of the bed over all times, over that of equal runs; 1 is no effect.", "",
        *markdown(["choice", f"free surface [mm] at {when} s", "bed [mm]", "moving bed [mm]", "bed / scatter", "front [m]", "scour [mm]",
                   "ridge [mm]", "CPU s", "iterations a step"],
                  [[": ".join(filter(None, (row["group"], row["choice"]))), *(series_of(row, curve, times, 1e3, 1) for curve in CURVES),
                    ratio(mean_over_times(row, "bed", times), scatter["bed"]), series_of(row, "front", times, 1, 3),
                    series_of(row, "scour", times, 1e3, 0), series_of(row, "ridge", times, 1e3, 0), row["cpu [s]"],
                    row["viscous iterations a step [-]"]]
                   for row in [{"group": "as it is", "choice": ""} | rms_columns({}, "", times) |
                               figures_of(study.base, times)] + effect_rows]),
        "", "## Convergence in the spacing", "",
        f"Distances from the run at {convergence_rows[-1]['spacing']}.", "",
        *markdown(["spacing", f"free surface [mm] at {when} s", "bed [mm]", "front [m]", "scour [mm]", "steps", "CPU s"],
                  [[row["spacing"], series_of(row, "free_surface", times, 1e3, 1), series_of(row, "bed", times, 1e3, 1),
                    series_of(row, "front", times, 1, 3), series_of(row, "scour", times, 1e3, 0), row["steps [-]"],
                    row["cpu [s]"]] for row in convergence_rows]), ""]
    return "\n".join(lines)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("thalweg", help="the program, for example build/release/bin/thalweg")
    arguments.add_argument("--out", default="out/effect_study", help="where runs and results go (default: %(default)s)")
    arguments.add_argument("--table", default=pathlib.Path(__file__).with_name("study.toml"), help="what is run")
    arguments.add_argument("--spacing", help="of all runs but those of [[spacing]]; default: the table's")
    arguments.add_argument("--finest", help="leaves out the runs of [[spacing]] beyond this one, for example \"5 mm\"")
    arguments.add_argument("--jobs", type=int, default=1, help="runs at a time, one thread each (default: %(default)s)")
    arguments.add_argument("--page", type=pathlib.Path, help="page of documentation to write, picture in images/ beside it")
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
    made = f"{study.case.name} at {study.spacing}; distances: root mean square from the run with nothing changed"
    write_table(study.out / "effects.csv", effect_rows, made)
    write_table(study.out / "convergence.csv", convergence_rows, "distances: root mean square from the finest run")
    write_table(study.out / "repeatability.csv", repeatability(study, rms, extents),
                f"{members} runs whose water density differs by up to two ten-thousandths, all pairs")
    draw(study, effect_rows, convergence_rows, rms, study.out / "effects.svg")
    if given.page:
        images = given.page.parent / "images"
        images.mkdir(parents=True, exist_ok=True)
        shutil.copy(study.out / "effects.svg", images / "effects.svg")
        given.page.write_text(page(study, effect_rows, convergence_rows, rms, extents, members, "images/effects.svg"),
                              encoding="utf-8")
    print(f"{study.out / 'effects.csv'}, convergence.csv, repeatability.csv, effects.svg")


if __name__ == "__main__":
    main()
