"""Recomputes every number in a report's tables and tiles from the tables beside the page: report_numbers_test.py THALWEG RUN

The test reads the page as it is shown. It computes errors anew from the curves in report/data, with code of its own. A table
that this test does not know is a failure, because nobody would check its numbers.
"""

import html.parser
import math
import pathlib
import re
import sys
import unittest

import coarse_louvain as case

run = pathlib.Path(sys.argv[2])
report = run / "report"
SPH = "Thalweg SPH"


class Page(html.parser.HTMLParser):
    """Tables as lists of rows under the heading before them, tiles as {caption: value}, facts of the answer as {name: text}."""

    def __init__(self):
        super().__init__()
        self.heading, self.tables, self.tiles, self.facts, self.lead = "", [], {}, {}, ""
        self.text, self.where, self.value, self.skip = "", None, "", 0

    def handle_starttag(self, tag, attributes):
        kind = dict(attributes).get("class", "")
        if tag in ("script", "style", "svg"):
            self.skip += 1
        if tag in ("h2", "h3", "th", "td", "dt", "dd"):
            self.text, self.where = "", tag
        if tag == "table":
            self.tables.append((self.heading, []))
        if tag == "tr":
            self.tables[-1][1].append([])
        if tag == "div" and kind in ("v", "k"):
            self.text, self.where = "", kind
        if tag == "p" and kind == "lead":
            self.text, self.where = "", "lead"

    def handle_endtag(self, tag):
        if tag in ("script", "style", "svg"):
            self.skip -= 1
        text = " ".join(self.text.replace("\u202f", "").replace("\u2212", "-").split())
        if tag in ("h2", "h3") and self.where == tag:
            self.heading = text
        elif tag in ("th", "td") and self.where == tag:
            self.tables[-1][1][-1].append(text)
        elif tag == "dt" and self.where == tag:
            self.value = text
        elif tag == "dd" and self.where == tag:
            self.facts[self.value] = text
        elif tag == "div" and self.where == "v":
            self.value = text
        elif tag == "div" and self.where == "k":
            self.tiles[text] = self.value
        elif tag == "p" and self.where == "lead":
            self.lead = text
        else:
            return
        self.where = None

    def handle_data(self, data):
        if not self.skip:
            self.text += data

    def table(self, heading):
        found = [rows for name, rows in self.tables if name == heading]
        assert found, f"no table under '{heading}'"
        return [row for row in found[0] if row]


def quantities(file):
    return {row["quantity"]: row["value"] for row in case.table(file)}


def printed_as(shown, value, decimals):
    """True if the printed number is `value` rounded to so many decimals; a half may go either way."""
    return abs(float(shown) - value) <= 0.5000001 * 10 ** -decimals


def interpolate(xs, zs, at):
    for k, x in enumerate(xs):
        if x == at:
            return zs[k]
        if x > at:
            if k == 0 or zs[k] is None or zs[k - 1] is None:
                return None
            return zs[k - 1] + (zs[k] - zs[k - 1]) * (at - xs[k - 1]) / (x - xs[k - 1])
    return None


def errors_again(reference, compared, curve):
    """RMSE, bias and largest error [m] of one curve of two profiles, at the reference's points."""
    curve += " [m]"
    if curve not in reference[0] or curve not in compared[0]:
        return None
    xs, zs = [row["x [m]"] for row in compared], [row[curve] for row in compared]
    differences = [interpolate(xs, zs, row["x [m]"]) - row[curve] for row in reference
                   if row[curve] is not None and interpolate(xs, zs, row["x [m]"]) is not None]
    return (math.sqrt(sum(d * d for d in differences) / len(differences)), sum(differences) / len(differences),
            max(differences, key=abs))


def mesh_models():
    """{label: its summary} of every mesh model whose finest mesh the report shows."""
    found = {}
    for file in [run / "foam" / "summary.csv", *sorted(run.glob("foam/*/summary.csv"))]:
        if not file.exists() or re.search(r"-\d+x$", file.parent.name):
            continue
        summary = quantities(file)
        words = ["OpenFOAM", summary.get("mesh_model"), f"{1e3 * summary['cell_size']:g} mm"]
        found[" ".join(word for word in words if word)] = summary
    return found


def folder_of(label):
    """The folder of report/data that holds the curves of a source."""
    return report / "data" / re.sub("[^a-z0-9]+", "_", label.lower())


class Numbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page()
        cls.page.feed((report / "index.html").read_text())
        cls.errors = [row for row in case.table(report / "errors.csv") if not row.get("line")]
        cls.summary = quantities(run / "summary.csv")
        cls.meshes = mesh_models()

    def test_every_table_is_known(self):
        checked = {"Which is which, how far apart, and what it cost", "Root mean square difference [mm]", "In full",
                   "Front, deepest scour and highest deposition", "This run", "Where the time went",
                   "What limited the time step", "The mesh model",
                   "Depths of all methods, and what follows"}
        if (report / "cost.csv").exists():
            checked.add("Speed against error")
        of_the_case = {"What is on, what is off", "Constants", "Sources"}  # case.resolved.toml and texts
        self.assertEqual({name for name, _ in self.page.tables} - of_the_case, checked)

    def test_tiles(self):
        tiles = self.page.tiles
        for caption, key, factor, decimals in (("particles, walls included", "particles", 1, 0),
                                               ("time steps", "steps", 1, 0),
                                               ("wall-clock time", "wall_seconds", 1, 1),
                                               ("processor time", "cpu_seconds", 1, 1),
                                               ("particle-steps per second", "particle_steps_per_second", 1e-6, 2)):
            shown = re.match(r"[0-9.]+", tiles[caption]).group()
            self.assertTrue(printed_as(shown, factor * self.summary[key], decimals), caption)

    def test_answer(self):
        series = case.table(run / "profiles" / "series.csv")
        deepest = max(series, key=lambda row: row["scour [m]"])
        facts = self.page.facts
        self.assertTrue(printed_as(self.page.tiles["deepest scour"].split()[0], 1e3 * deepest["scour [m]"], 1))
        self.assertEqual(facts["where"], f"x = {deepest['scour_x [m]']:.4f} m")
        self.assertEqual(facts["when"], f"t = {deepest['time [s]']:.4g} s")
        self.assertTrue(printed_as(facts["highest rise"].split()[0], 1e3 * series[-1]["deposition [m]"], 1))
        fallen, risen = re.match(r"([0-9.]+) cm2 fallen, ([0-9.]+) cm2 risen", facts["volume"]).groups()
        self.assertTrue(printed_as(fallen, 1e4 * series[-1]["eroded [m^2]"], 1))
        self.assertTrue(printed_as(risen, 1e4 * series[-1]["deposited [m^2]"], 1))
        # The picture's table holds the same.
        for row, shown in zip(series, case.table(report / "data" / "bed_series.csv"), strict=True):
            for name in ("time [s]", "scour [m]", "deposition [m]", "eroded [m^2]", "deposited [m^2]"):
                self.assertAlmostEqual(row[name], shown[name], delta=1e-6, msg=name)

    def test_band(self):
        """The largest of: the change of the depth with twice the spacing, and the scatter of equal runs."""
        depths = {}
        coarse = case.table(run / "coarser" / "2x" / "profiles" / "series.csv")
        fine = case.table(run / "profiles" / "series.csv")
        end = min(coarse[-1]["time [s]"], fine[-1]["time [s]"])
        for name, rows in (("coarse", coarse), ("fine", fine)):
            depths[name] = max(row["scour [m]"] for row in rows if row["time [s]"] <= end)
        scatter = max(row["rms [m]"] for row in case.table(case.CASE / "repeatability.csv") if row["curve"] == "bed")
        half = max(abs(depths["coarse"] - depths["fine"]), scatter)
        shown = re.match(r"± ([0-9.]+) mm", self.page.facts["band"]).group(1)
        self.assertTrue(printed_as(shown, 1e3 * half, 1), self.page.facts["band"])

    def test_depths_of_all_methods(self):
        heads, *rows = self.page.table("Depths of all methods, and what follows")
        known = {(row["reference"]): row for row in case.table(report / "scalars.csv")
                 if not row["line"] and row["quantity"] == "scour" and row["compared"] == SPH
                 and row["reference_value [m]"] is not None}  # the last time of each
        shown = {row[0]: dict(zip(heads, row)) for row in rows}
        self.assertEqual(set(shown), set(known))
        half = float(re.match(r"± ([0-9.]+) mm", self.page.facts["band"]).group(1))
        for name, row in known.items():
            cells = shown[name]
            for head, column in (("scour [mm]", "reference_value [m]"), ("this run [mm]", "compared_value [m]")):
                self.assertTrue(printed_as(cells[head], 1e3 * row[column], 1), (name, head))
            apart = 1e3 * abs(row["compared_value [m]"] - row["reference_value [m]"])
            if abs(apart - half) > 0.1:
                self.assertEqual(cells["what follows"], "the methods differ" if apart > half else "within the band: the same")

    def whole_bed(self):
        """The change of the bed at the last time. In the plane it is that of the profile, whose columns lie twice as far apart."""
        last = case.table(run / "profiles" / "series.csv")[-1]
        self.assertAlmostEqual(last["scour [m]"], self.scour_of_profile(), delta=0.1 * case.SPACING)
        return last

    def scour_of_profile(self):
        profiles = run / "profiles" / "all"
        start = {row["x [m]"]: row["bed [m]"] for row in case.table(profiles / "t0.000.csv")}
        end = case.table(profiles / f"t{case.END:.3f}.csv")
        return max(start[row["x [m]"]] - row["bed [m]"] for row in end
                   if None not in (row["bed [m]"], start.get(row["x [m]"])))

    def test_lead(self):
        whole = self.whole_bed()
        self.assertIn(f"scoured by up to {1e3 * whole['scour [m]']:.1f} mm (at x = {whole['scour_x [m]']:.4f} m)",
                      self.page.lead)
        self.assertIn(f"at rest (the moving bed's lower edge) has fallen by up to {1e3 * whole['resting_scour [m]']:.1f} mm",
                      self.page.lead)
        for label in self.meshes:
            bed = [1e3 * row["rmse [m]"] for row in self.errors_of(SPH, label) if row["curve"] == "bed"]
            self.assertRegex(self.page.lead, f"from {label}: [^;]*bed {min(bed):.1f}–{max(bed):.1f} mm")

    def errors_of(self, compared, reference):
        return [row for row in self.errors if (row["compared"], row["reference"]) == (compared, reference)]

    def test_errors_follow_from_the_curves_beside_the_page(self):
        for label in self.meshes:
            self.assertGreaterEqual(len(self.errors_of(SPH, label)), 2 * len(case.COMPARED),
                                    "free surface and bed at each time")
        for row in self.errors:
            name = f"t{row['time [s]']:.3f}.csv"
            reference, compared = (case.table(folder_of(row[role]) / name) for role in ("reference", "compared"))
            again = errors_again(reference, compared, row["curve"])
            for column, value in zip(("rmse [m]", "bias [m]", "largest_error [m]"), again):
                self.assertAlmostEqual(row[column], value, delta=1e-7, msg=f"{column} of {row}")

    def error(self, pair, curve, time):
        return next(row for row in self.errors_of(*pair)
                    if row["curve"] == curve.replace(" ", "_") and row["time [s]"] == time)

    def test_table_of_root_mean_squares(self):
        heads, *rows = self.page.table("Root mean square difference [mm]")
        times = [float(head.split()[2]) for head in heads[3:]]
        self.assertEqual(times, sorted(case.COMPARED))
        scatter = {(row["curve"], row["time [s]"]): row["rms [m]"] for row in case.table(case.CASE / "repeatability.csv")}
        pair = None
        for row in rows:
            pair = (row[0], row[1]) if row[0] else pair
            for time, cell in zip(times, row[3:]):
                if row[0].startswith("scatter"):
                    known = scatter.get((row[2].replace(" ", "_"), time))
                    self.assertTrue(cell == "–" if known is None else printed_as(cell, 1e3 * known, 1), row)
                else:
                    self.assertTrue(printed_as(cell.rstrip("*"), 1e3 * self.error(pair, row[2], time)["rmse [m]"], 1), row)

    def test_table_in_full(self):
        heads, *rows = self.page.table("In full")
        self.assertEqual(len([row for row in rows if len(row) == len(heads)]), len(self.errors))
        columns = {"RMSE [mm]": ("rmse [m]", 1e3, 1), "of range": ("normalised_rmse [-]", 100, 1),
                   "bias [mm]": ("bias [m]", 1e3, 1), "largest [mm]": ("largest_error [m]", 1e3, 1),
                   "at x [m]": ("largest_error_at [m]", 1, 3), "skill": ("brier_skill [-]", 1, 2),
                   "points": ("points [-]", 1, 0)}
        for row in rows:
            if len(row) == 1:
                pair = row[0].split(" against ")
                continue
            cells = dict(zip(heads, row))
            error = self.error(pair, cells["curve"], float(cells["t [s]"]))
            for head, (column, factor, decimals) in columns.items():
                cell, value = cells[head].removesuffix(" %"), error[column]
                self.assertTrue(cell == "–" if value is None else printed_as(cell, factor * value, decimals), (row, head))

    def test_front_and_extremes(self):
        heads, *rows = self.page.table("Front, deepest scour and highest deposition")
        scalars = [row for row in case.table(report / "scalars.csv") if not row["line"]]
        rows = [row for row in rows if len(row) == len(heads)]
        self.assertEqual(len(rows), len(scalars))
        for shown, row in zip(rows, scalars):
            is_height = row["quantity"] in ("scour", "deposition")
            factor, decimals = (1e3, 1) if is_height else (1, 3)
            self.assertEqual(shown[0], f"{row['quantity'].replace('_', ' ')} [{'mm' if is_height else 'm'}]")
            for cell, column in zip(shown[2:], ("compared_value [m]", "reference_value [m]", "error [m]")):
                self.assertTrue(cell == "–" if row[column] is None else printed_as(cell, factor * row[column], decimals),
                                (shown, row))

    def test_which_is_which(self):
        heads, *rows = self.page.table("Which is which, how far apart, and what it cost")
        by_name = {row[1]: dict(zip(heads, row)) for row in rows}
        self.assertEqual(by_name[SPH]["method"], "particles (SPH)")
        self.assertEqual(by_name["no measurement"]["method"], "measured", "an empty slot that is seen")
        for label in self.meshes:
            self.assertEqual(by_name[label]["method"], "mesh (finite volumes)")
        for name, summary in [(SPH, self.summary), *self.meshes.items()]:
            size = "fluid_particles" if name == SPH else "cells"
            row = by_name[name]
            self.assertEqual(float(row["size"].split()[0]), summary[size])
            self.assertEqual(float(row["steps"]), summary["steps"])
            for head, key in (("wall clock [s]", "wall_seconds"), ("CPU [s]", "cpu_seconds")):
                self.assertTrue(printed_as(row[head], summary[key], 1), (name, head))
        for label in self.meshes:
            for curve in ("free surface", "bed"):
                rms = [1e3 * row["rmse [m]"] for row in self.errors_of(SPH, label)
                       if row["curve"] == curve.replace(" ", "_")]
                low, high = f"{min(rms):.1f}", f"{max(rms):.1f}"
                self.assertEqual(by_name[label][f"{curve} off by [mm]"], low if low == high else f"{low}–{high}")

    def test_summaries(self):
        shown = {row[0]: row[1] for row in self.page.table("This run")}
        self.check_summary(shown, self.summary)
        heads, *rows = self.page.table("The mesh model")
        for label, summary in self.meshes.items():
            self.check_summary({row[0]: row[heads.index(label)] for row in rows}, summary)

    def check_summary(self, shown, summary):
        """Five digits, or whole numbers from ten thousand on; exponents are typeset and left to the eye."""
        for name, value in summary.items():
            if isinstance(value, float) and 1e-3 <= abs(value) < 1e15:
                self.assertAlmostEqual(float(shown[name.replace("_", " ")]), value,
                                       delta=max(1e-4 * abs(value), 0.5 * (abs(value) >= 1e4)), msg=name)

    def test_speed_against_error(self):
        if not (report / "cost.csv").exists():
            self.skipTest("one resolution of each method")
        costs = case.table(report / "cost.csv")
        _, *rows = self.page.table("Speed against error")
        for shown, row in zip(rows, costs, strict=True):
            for cell, column, factor, decimals in zip(
                    shown[1:], ("elements [-]", "steps [-]", "cpu [s]", "element_steps_per_second [1/s]",
                                "error_free_surface [m]", "error_bed [m]"), (1, 1, 1, 1, 1e3, 1e3), (0, 0, 1, 0, 1, 1)):
                value = row[column]
                self.assertTrue(cell == "finest" if value is None else printed_as(cell, factor * value, decimals),
                                (shown, column))

    def test_where_the_time_went(self):
        heads, *rows = self.page.table("Where the time went")
        for row, entry in zip(rows, case.table(run / "timing.csv"), strict=True):
            cells = dict(zip(heads, row))
            self.assertEqual(cells["heading"], entry["heading"])
            self.assertTrue(printed_as(cells["seconds"], entry["seconds [s]"], 2))
            self.assertTrue(printed_as(cells["share"].split()[0], 100 * entry["share [-]"], 1))
            self.assertEqual(float(cells["calls"]), entry["calls [-]"])

    def test_what_limited_the_time_step(self):
        limiters = [row["dt_limiter"] for row in case.table(run / "history.csv")]
        for name, share, _ in self.page.table("What limited the time step")[1:]:
            self.assertTrue(printed_as(share.split()[0], 100 * limiters.count(name) / len(limiters), 1), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
