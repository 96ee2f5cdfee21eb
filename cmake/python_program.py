#!/usr/bin/env python3
"""Puts packages into one file that python3 runs: python_program.py PROGRAM MODULE:FUNCTION PACKAGE…"""

import pathlib
import shutil
import sys
import tempfile
import zipapp


PACKED = (".py", ".toml")


def left_out(folder, names):
    return [name for name in names if not name.endswith(PACKED) and not pathlib.Path(folder, name).is_dir() or name == "__pycache__"]


def main(program, start, packages):
    with tempfile.TemporaryDirectory() as folder:
        for package in map(pathlib.Path, packages):
            shutil.copytree(package, pathlib.Path(folder, package.name), ignore=left_out)
        zipapp.create_archive(folder, program, "/usr/bin/env python3", start, compressed=True)
    pathlib.Path(program).chmod(0o755)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
