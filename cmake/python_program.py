#!/usr/bin/env python3
"""Puts packages into one file that python3 runs: python_program.py PROGRAM MODULE:FUNCTION PACKAGE…"""

import pathlib
import shutil
import sys
import tempfile
import zipapp


def main(program, start, packages):
    with tempfile.TemporaryDirectory() as folder:
        for package in map(pathlib.Path, packages):
            shutil.copytree(package, pathlib.Path(folder, package.name), ignore=lambda _, names: [n for n in names if not n.endswith(".py")])
        zipapp.create_archive(folder, program, "/usr/bin/env python3", start, compressed=True)
    pathlib.Path(program).chmod(0o755)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
