#!/usr/bin/env python3
"""Checks that every header compiles alone: headers.py ROOT DATABASE

A header is given to the compiler with the flags of the translation units of its room, taken from DATABASE's
compile_commands.json, in which each source is a unit by itself, so that it sees what they see and nothing that another header
happens to include first. A header that a unit includes before anything else is read alone when that unit is analysed
(static_analysis.py), and is not compiled again.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from source_tree import report, sources

GUARDS = pathlib.Path(__file__).resolve().parent
# A room of headers alone, and the room whose units' flags it takes.
FLAGS_OF = {"physics": "common"}
KEPT_WITH_VALUE = ("-I", "-isystem", "-D")
KEPT_PREFIXES = ("-I", "-isystem", "-D", "-W", "-std=", "-f")


def flags_of(command):
    """The compiler and those of its flags that decide whether a header compiles."""
    words = shlex.split(command)
    compiler = next(word for word in words if pathlib.Path(word).name != "ccache")
    kept, take_next = [], False
    for word in words[words.index(compiler) + 1:]:
        if take_next or word.startswith(KEPT_PREFIXES):
            kept.append(word)
        take_next = not take_next and word in KEPT_WITH_VALUE
    return compiler, kept


def units_of(root, build):
    """The project's units that BUILD compiles, each with its command; not those that it writes itself."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if path.is_relative_to(root) and not path.is_relative_to(build) and path.suffix == ".cpp":
            yield path, entry["command"]


def included_first(root, build):
    """The headers that some unit includes before anything else."""
    found = set()
    for path, _ in units_of(root, build):
        first = re.search(r"^#include .*$", path.read_text(encoding="utf-8"), re.MULTILINE)
        if first and '"' in first[0]:
            found.add(first[0].split('"')[1])
    return found


def flags_by_room(root, build):
    """For each first folder the union of its units' flags, in the order they first appear."""
    rooms = {}
    for path, command in units_of(root, build):
        if GUARDS in path.parents:
            continue  # a part of clang, compiled as clang is: older C++, no run-time types
        compiler, flags = flags_of(command)
        room = rooms.setdefault(path.relative_to(root).parts[0], (compiler, {}))
        for words in pair_up(flags):
            macro = words[-1].removeprefix("-D").split("=")[0]  # units may give one macro several values
            room[1].setdefault(macro if words[0].startswith("-D") else words, words)
    return {room: (compiler, [word for words in kept.values() for word in words])
            for room, (compiler, kept) in rooms.items()}


def pair_up(flags):
    """Flags as tuples, so that "-isystem folder" stays together when duplicates go."""
    words = iter(flags)
    return [(word, next(words)) if word in KEPT_WITH_VALUE else (word,) for word in words]


def compile_alone(root, header, compiler, flags):
    """The compiler's first error, or nothing. The header comes from an include, as a unit would see it."""
    result = subprocess.run([compiler, *flags, "-fsyntax-only", "-x", "c++", "-"], input=f'#include "{header}"\n',
                            capture_output=True, text=True, cwd=root)
    if result.returncode == 0:
        return None
    first = next((line for line in result.stderr.splitlines() if "error" in line), result.stderr.strip())
    return f"{header}:1: does not compile alone ({first}); include what it uses"


def check(root, build):
    root, build = pathlib.Path(root).resolve(), pathlib.Path(build).resolve()
    rooms = flags_by_room(root, build)
    headers = [path.relative_to(root).as_posix() for path in sources(root, (".hpp",))]
    alone = included_first(root, build)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        jobs = []
        for header in (header for header in headers if header not in alone):
            room = header.split("/")[0]
            room = FLAGS_OF.get(room, room)
            if room not in rooms:
                return [f"{header}:1: no unit of {room} is in {build.name}/compile_commands.json; configure first"], 1
            jobs.append(workers.submit(compile_alone, root, header, *rooms[room]))
        return [violation for job in jobs if (violation := job.result())], len(headers)


if __name__ == "__main__":
    sys.exit(report(*check(sys.argv[1], sys.argv[2])))
