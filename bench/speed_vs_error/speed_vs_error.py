#!/usr/bin/env python3
"""Measures error against seconds: the cost of each choice of the numerics, and the distance of its results from a known answer.

Runs the table matrix.toml: each problem at several spacings, with one key of the numerics changed at a time, and with every
combination of a few. Whatever is there already is kept, so that a matrix that was stopped goes on where it was; runs that failed
are tried again with --again. Then writes points.csv and a picture a problem to OUT, with the Pareto front marked, and, with --page,
a page of documentation with the pictures in images/ beside it and, with --record, tables in bench/records.

Seconds are the solver's own CPU seconds of one thread. Errors are distances from closed forms, from measurements, or from the
finest run (problems.py).
"""

import argparse
import itertools
import pathlib
import shutil
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from page import draw_problem, measured, page, summary_lines
from on_mesh import ON_MESH
from problems import PROBLEMS, resolved
from study import origin, runs
from study.costs import overrides
from thalweg.programs import call
from study.mesh_run import MeshRun
from study.record import RECORDS
from thalweg.tables import write_table

SHOWN = ("numerics.smoothing_ratio", "numerics.cfl", "numerics.sound_speed_factor", "numerics.density_diffusion",
         "numerics.artificial_viscosity", "numerics.viscosity", "numerics.viscous_tolerance", "model.rest",
         "numerics.precision", "numerics.accuracy")  # columns of points.csv


def value_of(case, key):
    """The value of a key like "numerics.cfl" in a resolved case; None if the program that wrote it does not know the key."""
    for name in key.split("."):
        case = case.get(name, {})
    return None if case == {} else case


def written(value):
    """A value in the form that --set takes."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def names_of(table):
    """The problems of the matrix: those that do not stand alone."""
    return [problem["name"] for problem in table["problem"] if not problem.get("alone", False)]


class AnyPoint:
    """One run of one problem, on particles or on a mesh."""

    problem, run, failure = None, None, None

    def there(self):
        return self.run.complete() or self.failure is not None

    def figures(self, errors, elements, with_pairs):
        """The part of a line of points.csv that a run measures; `elements`: their row in summary.csv."""
        keys = ("measure", "error", "further", "cpu [s]", "steps [-]", "particles [-]", "pairs [1e9]", "particle-steps per CPU s [1/s]")
        if self.failure is not None:
            return dict.fromkeys(keys, "") | {"failure": self.failure}
        cpu, steps, count = self.run.cpu_seconds(), self.run.summary("steps"), self.run.summary(elements)
        pairs = f"{steps * count * self.run.summary('neighbours_mean') / 1e9:.4g}" if with_pairs else ""
        measure = self.problem["measure"]
        further = "; ".join(f"{name}={value:.4g}" for name, value in errors.items() if name != measure)
        error = f"{errors[measure]:.5g}" if measure in errors else ""
        values = (measure, error, further, f"{cpu:.3f}", int(steps), int(count), pairs, f"{steps * count / max(cpu, 1e-3):.3g}")
        return dict(zip(keys, values)) | {"failure": ""}


class Point(AnyPoint):
    """One run of one problem: a spacing, and the keys that are changed."""

    def __init__(self, matrix, problem, group, spacing, changes=None):
        self.problem, self.group, self.spacing, self.changes = problem, group, spacing, dict(changes or {})
        settings = [f'numerics.spacing="{spacing}"', *problem.get("set", []),
                    *(f"{key}={written(value)}" for key, value in self.changes.items())]
        label = " ".join([problem["name"], spacing, *(f"{key} {written(value)}" for key, value in self.changes.items())])
        self.run = runs.Run(matrix.thalweg, matrix.out / "runs", ROOT / problem["case"], label, settings)
        self.failure = self.earlier_failure()

    def earlier_failure(self):
        """The reason why the run failed before; None if it did not."""
        failed = self.run.folder / "failed.txt"
        if not failed.exists():
            return None
        settings, _, reason = failed.read_text(encoding="utf-8").partition("\n")
        return reason if settings == str(self.run.settings) else None

    def compute(self, again):
        """Computes the run unless it is there; a failed one counts as there."""
        if self.failure is not None and not again:
            return
        self.failure = None
        failed = self.run.folder / "failed.txt"
        try:
            self.run.compute(PROBLEMS[self.problem["name"]].start, postproc=self.problem["name"] == "louvain")
        except RuntimeError as error:
            told = [line for line in str(error).splitlines() if "error" in line]
            self.failure = (told or str(error).splitlines())[-1].split("error: ")[-1].replace(f"{self.run.folder}/", "")
            self.run.folder.mkdir(parents=True, exist_ok=True)
            failed.write_text(f"{self.run.settings}\n{self.failure}", encoding="utf-8")
            print(f"failed: {self.run.name}: {self.failure}", flush=True)

    def row(self, errors):
        """The point as a line of points.csv."""
        case = resolved(self.run.folder) if self.run.complete() else {}
        row = {"problem": self.problem["name"], "group": self.group, "spacing": self.spacing,
               "changed": " ".join(f"{key.split('.')[-1]}={written(value)}" for key, value in self.changes.items())}
        row |= {key: "" if value_of(case, key) is None else written(value_of(case, key)) for key in SHOWN}
        return row | self.figures(errors, "fluid_particles", with_pairs=True)


class MeshPoint(AnyPoint):
    """One run of one problem on a mesh."""

    def __init__(self, matrix, problem, mesh, cell, group="mesh"):
        self.problem, self.group, self.cell, self.model = problem, group, cell, mesh["model"]
        settings = [*problem.get("set", []), *mesh.get("set", [])]
        label = f"{problem['name']} {self.model} {cell} cells"
        self.run = MeshRun(matrix.thalweg, matrix.out / "runs", ROOT / problem["case"], label, settings, cell, self.model)

    def compute(self, again):
        """Computes the run unless it is there; one that fails is left out, with its reason."""
        del again  # one that failed is always tried again: its reason is most often that OpenFOAM is missing
        try:
            self.run.compute()
        except RuntimeError as error:
            self.failure = str(error).splitlines()[-1].split("error: ")[-1]
            print(f"failed: {self.run.name}: {self.failure}", flush=True)

    def row(self, errors):
        """The point as a line of points.csv: cells in place of particles."""
        row = {"problem": self.problem["name"], "group": self.group, "spacing": self.cell, "changed": self.model}
        return row | dict.fromkeys(SHOWN, "") | self.figures(errors, "cells", with_pairs=False)


class Matrix:
    """All points of the table, each run once however often the table names it."""

    def __init__(self, thalweg, out, table, only=None, quick=False):
        self.thalweg, self.out, self.table = pathlib.Path(thalweg).resolve(), pathlib.Path(out).resolve(), table
        names = only or (table["quick"] if quick else names_of(table))
        self.problems = [problem for problem in table["problem"] if problem["name"] in names]
        if quick:
            self.problems = [self.small(problem) for problem in self.problems]
        self.unknown, self.points = set(), []
        for problem in self.problems:
            self.points += self.points_of(problem)

    @staticmethod
    def small(problem):
        """The problem at its two coarsest spacings, the next as the reference where one is needed."""
        coarsest = problem["spacings"][:2]
        expected = {key: value for key, value in problem["expected"].items() if key != "error"}  # that is of another spacing
        problem = {key: value for key, value in problem.items() if key != "mesh"}
        fewer = problem | {"spacings": coarsest, "base": coarsest[0], "product": [], "expected": expected,
                           "axes": ["numerics.smoothing_ratio", "numerics.cfl"]}
        return fewer | ({"finest": problem["spacings"][2]} if "finest" in problem else {})

    def defaults(self, problem):
        """The case with nothing changed but what the problem sets, resolved by the program."""
        start = Point(self, problem, "", problem["base"])
        folder = self.out / "defaults" / problem["name"]
        shutil.rmtree(folder, ignore_errors=True)
        call(self.thalweg, "gencase", start.run.case, "--out", folder, *overrides(start.run.settings))
        return resolved(folder)

    def points_of(self, problem):
        usual = self.defaults(problem)

        def changed(keys, values):
            """Without those that are as the case has them."""
            return {key: value for key, value in zip(keys, values) if written(value_of(usual, key)) != written(value)
                    and value_of(usual, key) != value}

        points = [Point(self, problem, "spacing", spacing) for spacing in problem["spacings"]]
        if "finest" in problem:
            points.append(Point(self, problem, "finest", problem["finest"]))
        for axis in self.table["axis"]:
            key = axis["key"]
            wanted = axis.get("always", False) or key in problem.get("axes", [key])
            here = problem["name"] in axis.get("problems", [problem["name"]]) and wanted
            if not here:
                continue
            if value_of(usual, key) is None:
                self.unknown.add(key)
                continue
            for value in axis["values"]:
                if changes := changed([key], [value]):
                    points.append(Point(self, problem, key, axis.get("at", problem["base"]), changes))
        keys = self.table["product"].keys()
        for spacing, *values in itertools.product(problem.get("product", []), *self.table["product"].values()):
            points.append(Point(self, problem, "product", spacing, changed(keys, values)))
        for mesh in problem.get("mesh", []):
            points += [MeshPoint(self, problem, mesh, cell) for cell in mesh["cells"]]
            if "finest" in mesh:
                points.append(MeshPoint(self, problem, mesh, mesh["finest"], "finest mesh"))
        once = {}
        for point in points:
            once.setdefault(point.run.name, point)
        return list(once.values())

    def compute(self, jobs, again):
        runs.compute_all(self.points, jobs, lambda point: point.compute(again))

    def left_out(self):
        """Entries of the table without a row: keys that the program does not know, points that were not run yet."""
        return [f"{key} (unknown to the program)" for key in sorted(self.unknown)] + [
            point.run.name for point in self.points if not point.there()]

    def rows(self):
        """The finished points, as lines of points.csv."""
        rows = []
        for problem in self.problems:
            points = [point for point in self.points if point.problem is problem and point.there()]
            finest = next((point.run for point in points if point.group == "finest" and point.run.complete()), None)
            for point in points:
                rows.append(point.row({} if point.failure is not None else self.errors(point, points, finest)))
        return rows


    @staticmethod
    def errors(point, points, finest):
        name = point.problem["name"]
        if isinstance(point, Point):
            return PROBLEMS[name].errors(point.run, None if finest is point.run else finest)
        finest_mesh = next((other.run for other in points if other.group == "finest mesh" and other.model == point.model
                            and other.run.complete() and other is not point), None)
        return ON_MESH[name].errors(point.run, finest_mesh, finest)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("thalweg", help="the program, for example build/release/bin/thalweg")
    arguments.add_argument("--out", default="out/speed_vs_error", help="where runs and results go (default: %(default)s)")
    arguments.add_argument("--table", default=pathlib.Path(__file__).with_name("matrix.toml"), help="what is run")
    arguments.add_argument("--only", action="append", metavar="PROBLEM", help="this problem; may be given several times")
    arguments.add_argument("--quick", action="store_true", help="a few cheap problems at two coarse spacings: under three minutes")
    arguments.add_argument("--jobs", type=int, default=1, help="runs at a time, one thread each (default: %(default)s)")
    arguments.add_argument("--again", action="store_true", help="tries again what failed")
    arguments.add_argument("--collect", action="store_true", help="runs nothing: tables and pictures of what is there")
    arguments.add_argument("--page", type=pathlib.Path, help="page to write, its pictures in images/ beside it")
    arguments.add_argument("--record", nargs="?", type=pathlib.Path, const=RECORDS,
                           help="also writes speed-vs-error.csv and .md there, with --quick speed-vs-error-quick (without a folder: "
                                "bench/records)")
    given = arguments.parse_args()

    table = tomllib.loads(pathlib.Path(given.table).read_text(encoding="utf-8"))
    known = names_of(table)
    if wrong := set(given.only or []) - set(known):
        arguments.error(f"--only: there is no problem {', '.join(sorted(wrong))}; there are {', '.join(known)}")
    matrix = Matrix(given.thalweg, given.out, table, given.only, given.quick)
    for key in sorted(matrix.unknown):
        print(f"left out: {key}, which this program does not know", flush=True)
    if not given.collect:
        matrix.compute(given.jobs, given.again)

    made = origin.lines("speed_vs_error/speed_vs_error.py", ignored=("--collect", "--again"))
    rows = matrix.rows()
    if not rows:
        sys.exit("no run is there yet; leave --collect out")
    write_table(matrix.out / "points.csv", rows, made)
    drawn = [problem for problem in matrix.problems if measured(rows, problem)]
    for problem in drawn:
        draw_problem(problem, rows, matrix.out)
    if given.page:
        images = given.page.parent / "images"
        images.mkdir(parents=True, exist_ok=True)
        for problem in drawn:
            shutil.copy(matrix.out / f"speed_vs_error_{problem['name']}.svg", images)
        given.page.write_text(page(drawn, rows, made, matrix.left_out()), encoding="utf-8")
    if given.record:
        name = "speed-vs-error" + ("-quick" if given.quick else "")
        given.record.mkdir(parents=True, exist_ok=True)
        shutil.copy(matrix.out / "points.csv", given.record / f"{name}.csv")
        (given.record / f"{name}.md").write_text("\n".join(summary_lines(drawn, rows, made, f"{name}.csv")), encoding="utf-8")
    print(f"{matrix.out / 'points.csv'} and a picture a problem")


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("stopped; the same command goes on from here")
