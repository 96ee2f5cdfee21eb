#!/usr/bin/env python3
"""docs/tutorial.md: every command runs and every file shown is what lies there: tutorial_test.py THALWEG FOLDER"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
thalweg, scratch = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


class Tutorial(unittest.TestCase):
    def test_from_an_empty_folder_to_a_report(self):
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir(parents=True)
        blocks = BLOCK.findall((ROOT / "docs/tutorial.md").read_text(encoding="utf-8"))
        self.assertGreaterEqual(sum(kind == "sh" for kind, _ in blocks), 8)
        here = scratch
        path = {**os.environ, "PATH": f"{thalweg.parent}:{os.environ['PATH']}"}
        outputs = {}
        for kind, text in blocks:
            if kind == "toml":
                self.assertIn(text, (here / "jet/case.toml").read_text(encoding="utf-8"), "the tutorial shows another file than thalweg new writes")
                continue
            self.assertEqual(kind, "sh")
            result = subprocess.run(["bash", "-e", "-c", f"{text}\npwd >'{scratch}/pwd'"], cwd=here, env=path, capture_output=True, text=True,
                                    stdin=subprocess.DEVNULL)
            self.assertEqual(result.returncode, 0, text + result.stdout[-2000:] + result.stderr[-2000:])
            outputs[text] = result.stdout + result.stderr
            here = pathlib.Path((scratch / "pwd").read_text().strip())
        everything = "".join(outputs.values())
        self.assertIn("as expected", everything)
        self.assertIn("morphological factor", everything)
        self.assertIn("Dey & Sarkar", everything)
        for run in ("first", "fine"):
            self.assertIn("</html>", (here / run / "report/index.html").read_text(encoding="utf-8"))
        self.assertIn('grain_diameter = "2 mm" ', (here / "jet/case.toml").read_text())
        # What the text promises of the results: there is a hole, and the faster jet digs deeper.
        rows = [line.split(",") for line in (here / "sweep/sweep.csv").read_text().splitlines() if not line.startswith("#")]
        scour = rows[0].index("scour [m]")
        self.assertGreater(float(rows[2][scour]), float(rows[1][scour]))


if __name__ == "__main__":
    unittest.main()
