#!/usr/bin/env python3
"""`thalweg new`: every scene fills without a warning, runs, and has its report: new_test.py THALWEG FOLDER"""

import pathlib
import shutil
import subprocess
import sys
import tomllib
import unittest

thalweg, scratch = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))

# Scene: a coarser spacing that still fills it, and a short end.
SHORT = {"walljet": ("10 mm", "0.3 s"), "pier": ("20 mm", "0.2 s"), "channel": ("20 mm", "0.2 s"), "dam-break": ("20 mm", "0.2 s"),
         "column": ("10 mm", "0.3 s"), "dike": ("20 mm", "0.2 s")}


def call(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, stdin=subprocess.DEVNULL)


class New(unittest.TestCase):
    def setUp(self):
        self.folder = scratch / self.id().rsplit(".", 1)[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def test_every_scene_fills_and_runs(self):
        for scene, (spacing, end) in SHORT.items():
            with self.subTest(scene=scene):
                case = self.folder / f"my_{scene}"
                made = call(thalweg, "new", case, "--from", scene)
                self.assertEqual(made.returncode, 0, made.stderr)
                text = (case / "case.toml").read_text()
                self.assertEqual(tomllib.loads(text)["case"]["name"], f"my_{scene}")
                self.assertGreaterEqual(text.count("# <-"), 3, "what to change first is marked")
                check = call(thalweg, "gencase", case, "--check")
                self.assertEqual((check.returncode, check.stderr), (0, ""), check.stdout)
                run = call(thalweg, "run", case, "--no-foam", "--threads", "1", "--out", self.folder / scene, "--set", f"numerics.spacing={spacing}",
                           "--set", f"output.end={end}", "--set", f"output.interval={end}", "--set", "compare.times=[]")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertIn("</html>", (self.folder / scene / "report/index.html").read_text())

    def test_wrong_words_are_one_line(self):
        for words, known in ((["a", "--from", "walljett"], "did you mean walljet?"), (["a b/c d"], "cannot name a case"),
                             (["x", "--frm", "pier"], "unrecognized arguments")):
            result = call(thalweg, "new", *[self.folder / words[0], *words[1:]])
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)
            self.assertIn(known, result.stderr)

    def test_a_folder_that_cannot_be_is_one_line(self):
        (self.folder / "file").write_text("")
        for name in ("file", "file/below"):
            result = call(thalweg, "new", self.folder / name)
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)

    def test_a_case_is_not_overwritten(self):
        self.assertEqual(call(thalweg, "new", self.folder / "a").returncode, 0)
        again = call(thalweg, "new", self.folder / "a", "--from", "pier")
        self.assertEqual(again.returncode, 2)
        self.assertIn("--force", again.stderr)
        self.assertEqual(call(thalweg, "new", self.folder / "a", "--from", "pier", "--force").returncode, 0)
        self.assertIn("dimension = 3", (self.folder / "a/case.toml").read_text())


if __name__ == "__main__":
    unittest.main()
