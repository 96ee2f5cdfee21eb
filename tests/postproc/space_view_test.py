"""The report's 3-D view in headless Chromium, without a network: space_view_test.py PAGE PICTURE"""

import base64
import json
import pathlib
import re
import struct
import sys
import unittest
import zlib

import browser

page, picture = (pathlib.Path(argument) for argument in sys.argv[1:3])


def rgb_rows(file):
    """The rows of an 8-bit RGB or RGBA PNG as lists of (r, g, b); no library is needed for that."""
    data = file.read_bytes()
    at, compressed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", content[:10])
        if kind == b"IDAT":
            compressed += content
        at += 12 + length
    size = 4 if colour == 6 else 3
    raw, stride, rows, above = zlib.decompress(compressed), width * size, [], bytes(width * size)
    for y in range(height):
        rule, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - size] if i >= size else 0
            corner = above[i - size] if i >= size else 0
            guess = left + above[i] - corner
            paeth = min((abs(guess - value), order, value) for order, value in enumerate((left, above[i], corner)))[2]
            line[i] = (line[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[rule]) & 255
        rows.append([tuple(line[i:i + 3]) for i in range(0, stride, size)])
        above = bytes(line)
    return rows


class SpaceView(unittest.TestCase):
    def test_it_is_drawn_and_the_slider_has_the_runs_times(self):
        elements = browser.dom(page)
        self.assertIn('data-drawn="yes"', elements)
        self.assertRegex(elements, r'<input type="range"[^>]* max="2"')
        self.assertIn("t = 0.500 s", elements)

    def test_the_slider_changes_the_time(self):
        moved = browser.dom(page, "const s = document.querySelector('#scene input'); s.value = 1;"
                                  "s.dispatchEvent(new Event('input'));")
        self.assertIn("t = 0.250 s", moved)

    def test_bed_and_water_are_seen(self):
        """Brown where the bed has risen, blue of the water somewhere, and more than a few colours: it is lit."""
        browser.screenshot(page, picture, 700, 640)
        pixels = [pixel for row in rgb_rows(picture)[120:560] for pixel in row]
        brown = sum(red > blue + 25 for red, green, blue in pixels)
        blue = sum(blue > red + 25 for red, green, blue in pixels)
        self.assertGreater(brown, 0.01 * len(pixels))
        self.assertGreater(blue, 0.01 * len(pixels))
        self.assertGreater(len(set(pixels)), 500)
        # The pier is solid and dark grey; the walls around the flow let bed and water be seen, as above.
        dark = sum(max(pixel) < 110 and max(pixel) - min(pixel) < 12 for pixel in pixels)
        self.assertGreater(dark, 0.002 * len(pixels))

    def test_pier_and_walls_are_surfaces(self):
        data = json.loads(re.search(r'id="scene-data">(.*?)</script>', page.read_text(), re.DOTALL).group(1))
        for name, low, high in (("bodies", (0.55, 0.1), (0.65, 0.2)), ("walls", (-0.02, -0.02), (1.22, 0.32))):
            raw = base64.b64decode(data[name]["points"])
            points = [struct.unpack_from("<3f", raw, at) for at in range(0, len(raw), 12)]
            self.assertGreater(len(points), 50)
            for axis in (0, 1):
                self.assertAlmostEqual(min(point[axis] for point in points), low[axis], delta=0.02, msg=name)
                self.assertAlmostEqual(max(point[axis] for point in points), high[axis], delta=0.02, msg=name)

    def test_says_nothing_on_the_console(self):
        self.assertEqual(browser.console(page), [])

    def test_nothing_is_fetched(self):
        text = re.sub(r"<script.*?</script>", "", page.read_text(), flags=re.DOTALL)
        self.assertNotRegex(text, r"<(link|iframe)|src=")
        self.assertNotRegex(page.read_text(), r"<script[^>]* src")


if __name__ == "__main__":
    browser.skip_without_chromium()
    if not page.exists():
        print("skipped: this build has no vtk.js")
        sys.exit(browser.SKIPPED)
    unittest.main(argv=sys.argv[:1])
