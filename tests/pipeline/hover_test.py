"""Compares the values that the report shows at the pointer, in headless Chromium, with the curves beside it:
hover_test.py THALWEG RUN"""

import pathlib
import re
import sys
import unittest

import coarse_louvain as case
from report_numbers_test import SPH, folder_of, interpolate, mesh_models

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "postproc"))
import browser

run = pathlib.Path(sys.argv[2])
TIME = case.COMPARED[-1]
POINT = """
const svg = document.querySelector("#figure_ID svg"), frame = svg.getBoundingClientRect();
svg.dispatchEvent(new PointerEvent("pointermove", {clientX: frame.left + 0.45 * frame.width, clientY: frame.top + 60}));
"""


class Hover(unittest.TestCase):
    def test_the_values_of_all_curves_at_the_pointer(self):
        page = browser.dom(run / "report" / "index.html", POINT.replace("ID", f"t{TIME:.3f}".replace(".", "_")))
        shown = re.search(r'<div class="values"[^>]*display: block[^>]*>(.*?)</table>', page, re.DOTALL)
        self.assertIsNotNone(shown, "the box with the values is open")
        x = float(re.search(r"x = (-?[0-9.]+) m", shown.group(1)).group(1))
        self.assertTrue(-1 < x < 1.5)
        rows = re.findall(r"<tr><td[^>]*>([^<]+)</td><td>([^<]+)</td><td[^>]*>([^<]+)</td>", shown.group(1))
        self.assertEqual({source for _, source, _ in rows}, {SPH, *mesh_models()})
        for curve, source, value in rows:
            profile = case.table(folder_of(source) / f"t{TIME:.3f}.csv")
            places, heights = ([row[name] for row in profile] for name in ("x [m]", curve.replace(" ", "_") + " [m]"))
            # x is shown to half a millimetre, over which a curve of 10 mm columns may rise; heights to a tenth.
            near = [1e3 * z for z in (interpolate(places, heights, x + step) for step in (-6e-4, 0, 6e-4)) if z is not None]
            self.assertLessEqual(min(near) - 0.1, float(value), (curve, source))
            self.assertGreaterEqual(max(near) + 0.1, float(value), (curve, source))


if __name__ == "__main__":
    browser.skip_without_chromium()
    unittest.main(argv=sys.argv[:1])
