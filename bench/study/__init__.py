"""Shared by all measurements: programs and their costs, runs that go on where they stopped, records. Tables and particle files are
read by the package `thalweg`, which lies in python/ and, in the packed programs, beside this one."""

import pathlib
import sys

_package = pathlib.Path(__file__).resolve().parents[2] / "python"
if _package.is_dir() and str(_package) not in sys.path:
    sys.path.append(str(_package))
