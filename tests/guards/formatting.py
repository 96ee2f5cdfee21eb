#!/usr/bin/env python3
"""Checks that .clang-format was applied to every source: formatting.py ROOT [CLANG_FORMAT]"""

import pathlib
import subprocess
import sys

from source_tree import report, sources


def check(root, clang_format="clang-format-14"):
    root = pathlib.Path(root)
    paths = sources(root)
    violations = []
    for path in paths:
        command = [clang_format, "--style=file", path]
        formatted = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        for number, (want, have) in enumerate(zip(formatted.splitlines(), path.read_text().splitlines()), 1):
            if want != have:
                break
        else:
            number = 0
        if formatted != path.read_text():
            name = path.relative_to(root)
            violations.append(f"{name}:{number or 1}: differs from .clang-format; {clang_format} -i {name}")
    return violations, len(paths)


if __name__ == "__main__":
    sys.exit(report(*check(*sys.argv[1:])))
