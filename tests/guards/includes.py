#!/usr/bin/env python3
"""Checks who includes whom (ARCHITECTURE.md, "Who may include whom"): includes.py ROOT

The layers are data, below; a file belongs to the layer with the longest matching prefix.
"""

import pathlib
import re
import sys

from source_tree import HEADERS, report, sources

# Layer: the layers whose headers it may include besides its own. Tests and benchmarks may look at everything.
ALLOWED = {
    "physics": set(),
    "common": {"physics"},
    "common/io": {"common", "physics"},
    "common/extraction": {"case", "common", "physics"},
    "common/app/scour": {"case", "common", "physics"},
    "common/app": {"case", "common", "common/app/scour", "common/io", "physics"},  # the umbrella program, which sits on the libraries
    "case": {"common", "physics"},  # a law declares its own parameters; the case is made of these structs
    "gencase": {"case", "common", "common/io", "physics"},
    "solver/state": {"physics"},
    "solver/backend": {"common", "physics", "solver/state"},
    "solver/domain": {"common", "physics", "solver/state", "solver/backend"},
    "solver/lists": {"physics", "solver/state", "solver/backend", "solver/domain"},
    "solver/passes": {"physics", "solver/state", "solver/backend"},
    "solver/models": {"case", "common", "physics", "solver/state", "solver/backend", "solver/domain", "solver/lists",
                      "solver/passes"},
    # The step itself and its timing.
    "solver": {"physics", "solver/state", "solver/backend", "solver/lists", "solver/passes", "solver/models"},
    "solver/simulation": {"case", "common", "physics", "solver", "solver/state", "solver/backend", "solver/domain",
                          "solver/lists", "solver/passes", "solver/models"},
    # The interface of a simulation is all that the program and its neighbours see of the solver.
    "solver interface": {"case", "common", "solver", "solver/state"},
    "solver/program": {"case", "common", "common/io", "common/extraction", "solver interface", "solver/state"},
    "postproc": {"case", "common", "common/app/scour", "common/io", "common/extraction", "physics"},
    "foam_reference": {"case", "common", "common/io", "common/extraction", "physics", "foam_reference/library"},
    "foam_reference/library": {"physics"},  # compiled by wmake against OpenFOAM
}
SOLVER_INTERFACE = {"solver/simulation/simulation.hpp", "solver/simulation/start.hpp"}
ALLOWED["solver/simulation"].add("solver interface")
# Foreign header: the layers that may include it.
FOREIGN = {
    r"vtk\w*\.h": ({"common/io", "postproc"}, "VTK belongs to common/io and postproc"),
    r"CGAL/.*": ({"gencase"}, "CGAL belongs to gencase"),
    r"(cuda|cub|cooperative_groups|nv)(_|/|\.h).*": ({"solver/backend"}, "CUDA belongs to solver/backend"),
    r"omp\.h": ({"solver/backend"}, "in the solver only the backend knows OpenMP"),
}
SYNTAX = {
    r"<<<": "CUDA launches belong to solver/backend",
    r"\bcuda[A-Z]\w*": "CUDA calls belong to solver/backend",
    r"\b__(global|device|host|shared|constant|launch_bounds)__\b":
        "write HOST_DEVICE; CUDA's words belong to solver/backend",
}
# The one place outside the backend where CUDA's words are spelled out.
SPELLS_CUDA = "physics/host_device.hpp"

INCLUDE = re.compile(r'^\s*#\s*include\s*(?P<open>[<"])(?P<name>[^>"]+)[>"]')
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def layer_of(path):
    """The layer of a path relative to the root, or None for tests, benchmarks and foreign headers."""
    if path in SOLVER_INTERFACE:
        return "solver interface"
    matches = [layer for layer in ALLOWED if path.startswith(layer + "/")]
    return max(matches, key=len, default=None)


def blank(text):
    """The text without comments and string literals, lines kept."""
    return COMMENT_OR_STRING.sub(lambda match: "\n" * match.group().count("\n") + " ", text)


def includes(text):
    """(line number, "<" or '"', name) of every include that is not in a comment."""
    without_comments = re.sub(r"/\*.*?\*/", lambda match: "\n" * match.group().count("\n"), text, flags=re.DOTALL)
    for number, line in enumerate(without_comments.splitlines(), 1):
        if match := INCLUDE.match(line):
            yield number, match["open"], match["name"]


def edge_violations(root, path, text):
    layer = layer_of(path)
    for number, opening, name in includes(text):
        where = f"{path}:{number}"
        beside_it = layer is None and (root / path).parent.joinpath(name).is_file()
        if opening == '"' and not beside_it and not (root / name).is_file():
            yield f'{where}: "{name}" is no file of the repository; write the path from the root, or <> for a library'
            continue
        target = layer_of(name) if opening == '"' else None
        if layer and target and target != layer and target not in ALLOWED[layer]:
            allowed = ", ".join(sorted(ALLOWED[layer])) or "nothing"
            yield f"{where}: {layer} may not include {target}; allowed: {allowed}"
        if layer and opening == '"' and target is None:
            yield f"{where}: {layer} may not include {name}; tests and benchmarks are read by nobody"
        if layer == "physics" and opening == "<" and re.search(r"[./]", name):
            yield f"{where}: physics may not include <{name}>; the laws need the standard library alone"
        for pattern, (allowed, rule) in FOREIGN.items():
            outside_solver = name == "omp.h" and layer and not layer.startswith("solver")
            if layer and opening == "<" and re.fullmatch(pattern, name) and layer not in allowed and not outside_solver:
                yield f"{where}: {layer} may not include <{name}>; {rule}"


def syntax_violations(path, text):
    layer = layer_of(path)
    if layer is None or layer == "solver/backend" or path == SPELLS_CUDA:
        return
    for number, line in enumerate(blank(text).splitlines(), 1):
        for pattern, rule in SYNTAX.items():
            if match := re.search(pattern, line):
                yield f"{path}:{number}: '{match.group()}' in {layer}; {rule}"
        if layer.startswith("solver") and re.match(r"\s*#\s*pragma\s+omp\b(?!\s+(declare\s+)?simd)", line):
            yield f"{path}:{number}: '#pragma omp' in {layer}; threads belong to solver/backend"


def reach_of(root, start):
    """Every include reachable from a file through headers of the repository: {name: the file that includes it}."""
    reached, open_files = {}, [start]
    while open_files:
        current = open_files.pop()
        for _, opening, name in includes((root / current).read_text()):
            if name not in reached:
                reached[name] = current
                if opening == '"' and (root / name).is_file():
                    open_files.append(name)
    return reached


def device_violations(root, path):
    """nvcc never sees VTK or CGAL, not even through another header."""
    for name, includer in reach_of(root, path).items():
        if re.match(r"vtk\w*\.h$|CGAL/", name):
            yield f"{path}:1: reaches <{name}> through {includer}; keep VTK and CGAL away from CUDA sources"


def cycle_violations(root, paths):
    """A header that reaches itself cannot be read from the top."""
    for path in paths:
        if path in reach_of(root, path):
            yield f"{path}:1: includes itself through other headers; break the circle"


def check(root):
    root = pathlib.Path(root)
    violations, checked = [], 0
    names = [path.relative_to(root).as_posix() for path in sources(root)]
    for path in names:
        text = (root / path).read_text()
        violations += edge_violations(root, path, text)
        violations += syntax_violations(path, text)
        if path.endswith((".cu", ".cuh")):
            violations += device_violations(root, path)
        checked += 1
    violations += cycle_violations(root, [path for path in names if path.endswith(HEADERS)])
    return violations, checked


if __name__ == "__main__":
    sys.exit(report(*check(sys.argv[1])))
