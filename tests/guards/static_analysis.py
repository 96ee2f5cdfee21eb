#!/usr/bin/env python3
"""Runs clang-tidy over the units of the programs: static_analysis.py ROOT BUILD DATABASE CLANG_TIDY PLUGIN

The tests are left out: they cost as much again and decide nothing for a user. PLUGIN keeps the checks out of the libraries'
headers (static_analysis/own_sources.cpp). DATABASE holds the compile_commands.json in which each source is a unit by itself,
whatever BUILD has compiled together; so every source is also known to compile alone. A unit that passed is analysed again
only when its text, one of the files that it was built from, its flags or the checks have changed; BUILD/static_analysis
remembers.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import subprocess
import sys

PROGRAMS = ("physics", "common", "case", "gencase", "solver", "postproc", "foam_reference")


def units(root, database):
    """One compile command per source file: a source that is compiled for several processors says the same in each."""
    chosen = {}
    for entry in json.loads((database / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if path.suffix == ".cpp" and path.is_relative_to(root) and path.relative_to(root).parts[0] in PROGRAMS:
            chosen.setdefault(path, entry)
    return chosen


def built_from(build):
    """For each source that ninja has built, the object and the files that this was made of, as ninja noted them: of an object
    of several sources all of theirs."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout
    objects, files = {}, []
    for line in listing.splitlines():
        if line.startswith("    "):
            files.append(build / line.strip())
        elif ": #deps" in line:
            files = objects[build / line.split(": #deps")[0]] = []
    return {path.resolve(): (built, files) for built, files in objects.items() for path in files if path.suffix == ".cpp"}


class Digests:
    """Digests of files, each read once: of the project's by content, of the libraries' by size and time."""

    def __init__(self, root):
        self.root, self.known = root, {}

    def of(self, path):
        if path not in self.known:
            state = path.stat()
            own = path.resolve().is_relative_to(self.root)
            content = path.read_bytes() if own else f"{state.st_size} {state.st_mtime_ns}".encode()
            self.known[path] = str(path).encode() + hashlib.sha256(content).digest(), state.st_mtime_ns
        return self.known[path]


def fingerprint(entry, built, files, digests, always):
    """Changes whenever the analysis of a unit could come out differently; None if a file is newer than what ninja noted."""
    try:
        parts = [digests.of(path) for path in files]
        if not files or any(changed > built.stat().st_mtime_ns for _, changed in parts):
            return None
    except OSError:
        return None
    return hashlib.sha256(b"".join([always, entry["command"].encode(), *(digest for digest, _ in parts)])).hexdigest()


def analyse(path, root, database, clang_tidy, plugin):
    """The findings of clang-tidy in a unit, or nothing."""
    result = subprocess.run([clang_tidy, f"--load={plugin}", "-p", database, "-quiet",
                             "-extra-arg=-Wno-unknown-warning-option", path], cwd=root, capture_output=True, text=True)
    return result.returncode and (result.stdout or result.stderr or f"{path}: clang-tidy ended with {result.returncode}")


def check(root, build, database, clang_tidy, plugin):
    root, build, database, plugin = (pathlib.Path(path).resolve() for path in (root, build, database, plugin))
    passed = build / "static_analysis"
    passed.mkdir(exist_ok=True)
    chosen, made_of, digests = units(root, database), built_from(build), Digests(root)
    always = (root / ".clang-tidy").read_bytes() + plugin.read_bytes()
    made = {path: made_of.get(path, (None, [])) for path in chosen}
    files = {path: found for path, (_, found) in made.items()}
    marks = {path: fingerprint(entry, *made[path], digests, always) for path, entry in chosen.items()}
    changed = [path for path in chosen if not (marks[path] and (passed / marks[path]).exists())]
    print(f"{len(chosen)} units, {len(changed)} of them new or changed")

    # A unit of many files takes long: it starts first, so that no core waits for it at the end.
    changed.sort(key=lambda path: -len(files[path]))
    (passed / "compile_commands.json").write_text(json.dumps([chosen[path] for path in changed]))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        findings = dict(zip(changed, workers.map(lambda path: analyse(path, root, passed, clang_tidy, plugin), changed)))
    for path, found in findings.items():
        if not found and marks[path]:
            (passed / marks[path]).touch()
    print("\n".join(dict.fromkeys(filter(None, findings.values()))))
    return 1 if not chosen or any(findings.values()) else 0


if __name__ == "__main__":
    sys.exit(check(*sys.argv[1:]))
