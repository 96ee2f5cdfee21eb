"""A tank of water at rest, 0.2 m wide and 0.1 m deep: a case whose answer is known, for the tests of validate and sweep."""

import pathlib
import shutil
import subprocess

CASE = """\
[case]
name = "tank"
title = "Water at rest"
dimension = 2

[domain]
from = ["-0.1 m", "-0.1 m"]
to = ["0.3 m", "0.25 m"]
gravity = ["0 m/s^2", "-9.81 m/s^2"]

[[shape]]
name = "walls"
kind = "box"
role = "wall"
side = "outside"
open = ["+z"]
from = ["0 m", "0 m"]
to = ["0.2 m", "0.2 m"]

[[shape]]
name = "water"
kind = "box"
role = "water"
from = ["0 m", "0 m"]
to = ["0.2 m", "0.1 m"]

[numerics]
spacing = "10 mm"
maximum_speed = "1 m/s"

[[gauge]]
name = "middle"
at = ["0.1 m", "0 m"]

[[gauge]]
name = "floor"
kind = "pressure"
at = ["0.1 m", "0.01 m"]

[output]
end = "0.1 s"
interval = "0.05 s"
gauge_interval = "10 ms"
"""

LEVEL = """\
[level]
measure = "column"
file = "gauges.csv"
column = "middle.level"
statistic = "mean"
value = {value}
unit = "m"
limit = {limit}
reason = "a quarter of a spacing"
{more}
"""


def write(folder, expected=None, case=CASE):
    """The case in a new folder, with its expected.toml if one is given."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "case.toml").write_text(case, encoding="utf-8")
    if expected is not None:
        (folder / "expected.toml").write_text(expected, encoding="utf-8")
    return folder


def level(value=0.1, limit=0.0025, more=""):
    return LEVEL.format(value=value, limit=limit, more=more)


def call(*words, folder=None):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, stdin=subprocess.DEVNULL, cwd=folder)


def error_of(result, test):
    """The one error line of a program that was given wrong input."""
    test.assertEqual(result.returncode, 2, result.stdout + result.stderr)
    errors = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
    test.assertEqual(len(errors), 1, result.stderr)
    test.assertNotIn("Traceback", result.stderr)
    test.assertLessEqual(len(errors[0]), 310, errors[0])
    test.assertIn(";", errors[0], "what to do is missing")
    return errors[0]


def arguments(argv):
    """Program and scratch folder of a test script; both are taken off the command line."""
    return pathlib.Path(argv.pop(1)).resolve(), pathlib.Path(argv.pop(1)).resolve()
