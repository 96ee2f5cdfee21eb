#!/usr/bin/env python3
"""Runs clang-tidy over the units of the programs: static_analysis.py ROOT BUILD [CLANG_TIDY RUN_CLANG_TIDY]

The tests are left out: they cost as much again and decide nothing for a user. A unit that passed is analysed again only
when its preprocessed text, its flags or .clang-tidy have changed; BUILD/static_analysis remembers.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys

PROGRAMS = ("physics", "common", "case", "gencase", "solver", "postproc", "foam_reference")


def units(root, build):
    """One compile command per source file: a source that is compiled for several processors says the same in each."""
    chosen = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if path.suffix == ".cpp" and path.is_relative_to(root) and path.relative_to(root).parts[0] in PROGRAMS:
            chosen.setdefault(path, entry)
    return chosen


def fingerprint(root, entry):
    """Changes whenever the analysis of a unit could come out differently."""
    words = shlex.split(entry["command"])
    words[words.index("-o"):words.index("-o") + 2] = []
    words[words.index("-c")] = "-E"
    text = subprocess.run(words, cwd=entry["directory"], capture_output=True).stdout
    return hashlib.sha256((root / ".clang-tidy").read_bytes() + entry["command"].encode() + text).hexdigest()


def check(root, build, clang_tidy="clang-tidy-14", run_clang_tidy="run-clang-tidy-14"):
    root, build = pathlib.Path(root).resolve(), pathlib.Path(build).resolve()
    passed = build / "static_analysis"
    passed.mkdir(exist_ok=True)
    chosen = units(root, build)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        fingerprints = dict(zip(chosen, workers.map(lambda entry: fingerprint(root, entry), chosen.values())))
    changed = [path for path in chosen if not (passed / fingerprints[path]).exists()]
    print(f"{len(chosen)} units, {len(changed)} of them new or changed")
    if not chosen or not changed:
        return 0 if chosen else 1

    (passed / "compile_commands.json").write_text(json.dumps([chosen[path] for path in changed]))
    status = subprocess.run([run_clang_tidy, "-clang-tidy-binary", clang_tidy, "-p", passed, "-quiet",
                             "-j", str(os.cpu_count()), "-extra-arg=-Wno-unknown-warning-option"], cwd=root,
                            stderr=subprocess.DEVNULL).returncode
    if status == 0:
        for path in changed:
            (passed / fingerprints[path]).touch()
    return status


if __name__ == "__main__":
    sys.exit(check(*sys.argv[1:]))
