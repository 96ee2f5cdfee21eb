#!/usr/bin/env python3
"""Runs the whole pipeline on the coarse case, for the tests that read its files: run_once.py THALWEG FOLDER"""

import pathlib
import shutil
import sys
import time

import coarse_louvain

thalweg, folder = (pathlib.Path(argument) for argument in sys.argv[1:3])
shutil.rmtree(folder, ignore_errors=True)
folder.parent.mkdir(parents=True, exist_ok=True)
began = time.monotonic()
result = coarse_louvain.call(coarse_louvain.command(thalweg, "run", coarse_louvain.CASE, folder))
print(result.stdout, result.stderr, sep="\n")
print(f"exit status {result.returncode} after {time.monotonic() - began:.1f} s")
sys.exit(result.returncode)
