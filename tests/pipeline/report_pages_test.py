#!/usr/bin/env python3
"""The reports of runs of all kinds in headless Chromium: report_pages_test.py THALWEG FOLDER

Each page is rendered without a message on the console, keeps within a window 1280 pixels wide, opens with the question
and the answer, has its parts in order, and prints to A4.
"""

import html
import pathlib
import re
import shutil
import sys
import unittest

import coarse_louvain as case

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "postproc"))
import browser

thalweg, scratch = (pathlib.Path(argument) for argument in (sys.argv.pop(1), sys.argv.pop(1)))

# Name: case, settings. All are coarse and short.
RUNS = {
    "plane": (case.CASE, ['numerics.spacing="20 mm"', 'output.end="0.2 s"', 'output.interval="0.05 s"', "compare.times=[]"]),
    "space": (ROOT / "cases/louvain3d", ['numerics.spacing="20 mm"', 'output.end="0.1 s"', 'output.interval="0.05 s"',
                                         "compare.times=[]"]),
    "surface": (ROOT / "tests/solver/program/surface_bed/pier.toml", ['output.end="0.5 s"', 'output.interval="0.1 s"',
                                                                      "surface_bed.factor=20"]),
    "spinning": (ROOT / "tests/solver/program/surface_bed/pier.toml", ['output.end="0.1 s"', 'output.interval="0.05 s"',
                                                                       'surface_bed.spin_up="1 s"']),
    "dry": (ROOT / "cases/stability/column", ['numerics.spacing="10 mm"', 'output.end="0.4 s"', "compare.times=[]",
                                              "compare.references=[]"]),
    "water": (ROOT / "cases/weir", ['numerics.spacing="10 mm"', 'output.end="1 s"', "compare.times=[]"]),
}
WIDTH = 1280  # [pixels]
# Right ends of elements beyond the window, by the script that the page runs.
OVERFLOW = """
const wide = [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().right > innerWidth + 1
  && !e.closest("svg")).map((e) => e.tagName + "." + e.className);
document.title = "wide: " + wide.slice(0, 5).join(" ");
"""


def run_folder(name):
    """The finished run of this name; made once for all tests of this call."""
    folder = scratch / name
    if not (folder / "report" / "index.html").is_file():
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
        path, settings = RUNS[name]
        result = case.call(case.command(thalweg, "run", path, folder, settings, ["--no-foam"]))
        assert result.returncode == 0, result.stderr
    return folder


def changed_copy(name, of, end):
    """A copy of a run whose case goes on to a later end, reported again."""
    folder = scratch / name
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(run_folder(of), folder)
    resolved = folder / "case.resolved.toml"
    text, count = re.subn(r'(?s)(\n\[output\]\nend = )"[^"]*"', rf'\g<1>"{end} s"', resolved.read_text())
    assert count == 1, "the table [output] begins with its end"
    resolved.write_text(text)
    return folder


def report(folder, *options):
    result = case.call([thalweg, "postproc", folder, "--report", *options])
    return result


def headings(page):
    return [html.unescape(text) for text in re.findall(r"<h2>(.*?)</h2>", page)]


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Runs of an earlier build would hide what has changed since."""
        shutil.rmtree(scratch, ignore_errors=True)

    def check(self, folder, shown):
        """Renders and prints the page; `shown` are headings in the order in which they have to stand."""
        file = folder / "report" / "index.html"
        page = file.read_text()
        self.assertEqual(browser.console(file), [], folder.name)
        title = re.search(r"<title>(.*?)</title>", browser.dom(file, OVERFLOW, WIDTH)).group(1)
        self.assertEqual(title.strip(), "wide:", "elements reach beyond the window")
        pdf = folder / "report.pdf"
        browser.print_pdf(file, pdf)
        boxes = re.findall(rb"/MediaBox\s*\[\s*0 0 ([0-9.]+) ([0-9.]+)", pdf.read_bytes())
        self.assertTrue(boxes)
        for width, height in boxes:  # A4 in points
            self.assertAlmostEqual(float(width), 595, delta=1)
            self.assertAlmostEqual(float(height), 842, delta=1)
        found = [heading for heading in headings(page) if heading in shown]
        self.assertEqual(found, shown)
        self.assertLess(page.index('class="asked"'), page.index('class="answer"'))
        self.assertLess(page.index('class="answer"'), page.index("<h2>"))
        self.assertNotRegex(re.sub(r"<script.*?</script>|<svg.*?</svg>|<style.*?</style>", "", page, flags=re.DOTALL), r"\bnan\b|\binf\b")
        return page

    def test_plane(self):
        page = self.check(run_folder("plane"),
                          ["Scour depth and volume against time", "The scene", "The bed before and after",
                           "Shear stress on the bed", "Depths of all methods, and what follows",
                           "Which is which, how far apart, and what it cost", "Profiles", "What it cost"])
        self.assertIn("How deep does the water scour the bed", page)
        self.assertIn("<dt>band</dt>", page)

    def test_space(self):
        folder = run_folder("space")
        self.assertEqual(report(folder, "--3d").returncode, 0)
        page = self.check(folder, ["Scour depth and volume against time", "The bed from above",
                                   "Sections through the deepest place", "Shear stress on the bed", "What it cost"])
        self.assertIn("No mesh model has been run", page)
        for picture in ("bed_map.png", "shear_map.png", "section_x.svg", "section_y.svg", "scour.svg", "volume.svg"):
            self.assertGreater((folder / "report/pictures" / picture).stat().st_size, 2000, picture)

    def test_surface(self):
        folder = run_folder("surface")
        page = self.check(folder, ["Scour depth and volume against time", "The bed from above",
                                   "Sections through the deepest place", "Shear stress on the bed", "The current",
                                   "Scour by formulas", "Depths of all methods, and what follows", "What it cost"])
        self.assertIn("of the bed’s time", page)
        # The answer is the deepest column of history.csv; the map's deepest place is the same column.
        deepest = max(row["bed_scour [m]"] for row in case.table(folder / "history.csv"))
        self.assertIn(f'<div class="v">{1e3 * deepest:.1f} <span>mm</span>', page)
        fall = max(-row["change [m]"] for row in case.table(folder / "report/data/bed_map.csv")
                   if row["change [m]"] is not None)
        self.assertAlmostEqual(fall, deepest, delta=1e-6)
        series = case.table(folder / "report/data/bed_series.csv")
        self.assertAlmostEqual(series[-1]["eroded [m^3]"], series[-1]["deposited [m^3]"], delta=1e-3 * series[-1]["eroded [m^3]"])

    def test_surface_before_its_first_step(self):
        page = self.check(run_folder("spinning"), ["The scene", "The bed from above", "What it cost"])
        self.assertIn("the bed has taken no step yet", page)
        self.assertNotIn("<dt>volume</dt>", page)
        self.assertNotIn("Scour depth and volume against time", headings(page))

    def test_dry(self):
        page = self.check(run_folder("dry"), ["Fall of the bed and volume against time", "The bed before and after",
                                              "What it cost"])
        self.assertIn("How far does the dry bed fall and spread?", page)
        self.assertNotIn("Shear stress on the bed", headings(page))

    def test_water_alone(self):
        page = self.check(run_folder("water"), ["What came in and went out", "The scene", "What it cost"])
        self.assertIn("it has no sediment", page)
        self.assertNotIn("Scour depth and volume against time", headings(page))

    def test_unfinished_and_failed(self):
        folder = changed_copy("unfinished", "plane", 5)
        (folder / "summary.csv").unlink()
        report(folder)
        page = self.check(folder, ["Scour depth and volume against time", "Warnings", "What it cost"])
        self.assertIn("The results end at t = 0.2 s of 5 s", page.split("</header>")[0])
        self.assertIn("the run has not come to its end", page)
        folder = changed_copy("failed", "plane", 5)
        shutil.copy(folder / "particles.vtp", folder / "diverged.vtp")
        report(folder)
        page = self.check(folder, ["Scour depth and volume against time", "Warnings", "What it cost"])
        self.assertIn("This run failed after t = 0.2 s of 5 s", page.split("</header>")[0])

    def test_one_unit_for_heights(self):
        """The scour's unit is the only one in which the page's own texts give heights; places alone are in metres."""
        page = (run_folder("surface") / "report" / "index.html").read_text()
        text = html.unescape(re.sub(r"<script.*?</script>|<svg.*?</svg>|<style.*?</style>", "", page, flags=re.DOTALL))
        for part in ("Scour depth and volume against time", "The bed from above", "Scour by formulas",
                     "Depths of all methods, and what follows"):
            section = re.sub(r"c?m<sup>.*?</sup>|<[^>]+>", " ", text.split(f"<h2>{part}</h2>")[1].split("<h2>")[0])
            section = re.sub(r"\b[xyt] = [\u2212\-0-9.]+\s*(m|s)\b", "", section)
            self.assertNotRegex(section, r"[0-9]\s(m|cm|µm|um)\b", part)
            self.assertRegex(section, r"\bmm\b", part)


if __name__ == "__main__":
    browser.skip_without_chromium()
    unittest.main(argv=sys.argv[:1])
