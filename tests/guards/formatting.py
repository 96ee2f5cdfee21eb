#!/usr/bin/env python3
"""Checks that .clang-format was applied to every source: formatting.py ROOT [CLANG_FORMAT]"""

import pathlib
import re
import subprocess
import sys

from source_tree import report, sources

DIFFERENCE = re.compile(r"^(?P<path>.+?):(?P<line>\d+):\d+: error: code should be clang-formatted")


def check(root, clang_format="clang-format-14"):
    root = pathlib.Path(root)
    paths = sources(root)
    if not paths:
        return [], 0
    # One process for all files: its start costs more than the work on one file.
    process = subprocess.run([clang_format, "--style=file", "--dry-run", "--Werror", *paths], capture_output=True, text=True)
    violations = {}
    for difference in filter(None, map(DIFFERENCE.match, process.stderr.splitlines())):
        name = pathlib.Path(difference["path"]).relative_to(root)
        violations.setdefault(name, f"{name}:{difference['line']}: differs from .clang-format; {clang_format} -i {name}")
    if process.returncode and not violations:
        raise RuntimeError(f"{clang_format} failed: {process.stderr}")
    return list(violations.values()), len(paths)


if __name__ == "__main__":
    sys.exit(report(*check(*sys.argv[1:])))
