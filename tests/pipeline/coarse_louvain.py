"""The Louvain dam break, coarse and short: the run of the pipeline's tests, and readers for its files."""

import csv
import pathlib
import subprocess
import xml.etree.ElementTree

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases" / "louvain"
SPACING = 0.010  # [m]
CELL = 0.020  # [m]
END = 0.25  # [s]
INTERVAL = 0.05  # [s]
COMPARED = (0.10, 0.25)  # [s]
SETTINGS = (f'numerics.spacing="{SPACING} m"', f'foam.cell="{CELL} m"', f'output.end="{END} s"',
            f'output.interval="{INTERVAL} s"', "compare.times=[" + ", ".join(f'"{time} s"' for time in COMPARED) + "]")

# Constants of cases/louvain/case.toml.
WATER_LEVEL = 0.16  # [m]
BED_LEVEL = 0.06  # [m]
WATER_AREA = 1.0 * (WATER_LEVEL - BED_LEVEL)  # [m^2]
BED_AREA = 2.5 * BED_LEVEL  # [m^2]
WATER_DENSITY = 1000.0  # [kg/m^3]
BED_DENSITY = 0.47 * 1000 + (1 - 0.47) * 1540  # [kg/m^3] porosity 0.47, grains 1540


def command(thalweg, program, case, out, settings=SETTINGS, options=()):
    """The command line of a run with settings of the case file overridden."""
    overrides = [word for text in settings for word in ("--set", text)]
    return [str(thalweg), program, str(case), "--out", str(out), *options, *overrides]


def call(words):
    """Runs a program to its end and keeps its output."""
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, stdin=subprocess.DEVNULL)


def table(file):
    """The rows of a CSV file of ours as dictionaries; numbers where they are numbers, None where a cell is empty."""
    lines = [line for line in file.read_text().splitlines() if line and not line.startswith("#")]
    return [{name: number(text) for name, text in row.items()} for row in csv.DictReader(lines)]


def number(text):
    if text in ("", None):
        return None
    try:
        return float(text)
    except ValueError:
        return text


def series(run):
    """(time, file) of the entries of snapshots.pvd."""
    collection = xml.etree.ElementTree.parse(run / "snapshots.pvd").getroot().find("Collection")
    return [(float(entry.get("timestep")), run / entry.get("file")) for entry in collection]


def solvers_under(process):
    """The solvers among the processes that this one has started, and those that these have."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            program = (entry / "cmdline").read_bytes().split(b"\0")[0].decode()
        except (OSError, IndexError):
            continue
        found.append((int(entry.name), parent, program))
    known = {process}
    while more := {pid for pid, parent, _ in found if parent in known} - known:
        known |= more
    parents = {parent for _, parent, _ in found}  # the one that has started mpirun is no rank
    return sorted(pid for pid, _, program in found if pid in known - parents and program.endswith("thalweg-solver"))
