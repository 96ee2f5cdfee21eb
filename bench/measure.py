"""What the measurements of this folder share: what a run of the solver cost, runs in turn, and the page they end on.

A cost is processor time, which other programs on the machine disturb least; ratios are taken pair by pair from runs that
alternate, and their median is what is quoted.
"""

import csv
import datetime
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[1]


@dataclass
class Used:
    """What a process used, from its start to its end."""
    text: str     # what it printed
    cpu: float    # [s] of all threads, system time included
    peak: int     # [bytes] largest resident memory


def call(*command, environment=None):
    """Runs a command to its end. Raises RuntimeError with what it printed if it fails."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        process = subprocess.Popen([str(part) for part in command], stdout=output, stderr=subprocess.STDOUT,
                                   env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}\nexit status {process.returncode}\n{text}")
    return Used(text, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss)


@dataclass
class Cost:
    """What some steps of the solver cost, loading and filling not included."""
    steps: int
    fluid: int            # particles that are not walls
    particles: int
    cpu: float            # [s] of all threads
    wall: float           # [s]
    physical: float       # [s] of the scene since its start
    rebuilds: int         # of the neighbour lists
    iterations: float     # of the viscous solve, a step
    neighbours: float     # in the kernel's support, mean over the fluid
    bytes: float          # of all arrays, a particle
    peak: int             # [bytes] largest resident memory of the process, loading included
    headings: dict        # the step's lines that ran: seconds

    @property
    def ns(self):
        """[ns] of processor time a fluid particle and step."""
        return 1e9 * self.cpu / (self.fluid * self.steps)


def settings(pairs):
    """Keys of the case as options of the programs."""
    return [text for pair in pairs for text in ("--set", pair)]


def fill(thalweg, case, run, changes=()):
    """Fills a scene with particles, unless the folder `run` holds the same one already."""
    mark = run / "filled.json"
    scene = {"case": (case / "case.toml").read_text(encoding="utf-8"), "changes": list(changes)}
    if mark.exists() and json.loads(mark.read_text(encoding="utf-8")) == scene:
        return run
    call(thalweg, "gencase", case, "--out", run, *settings(changes))
    mark.write_text(json.dumps(scene), encoding="utf-8")
    return run


def write_case(text, folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return folder


def rows_of(file):
    with file.open(encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def solve(thalweg, run, *options, threads=1):
    """Runs the solver in the folder of a filled scene; what it says that its steps cost."""
    used = call(thalweg, "solver", run, "--threads", threads, *options)
    value = {row["quantity"]: row["value"] for row in rows_of(run / "summary.csv")}
    return Cost(steps=int(value["steps_since_restart"]), fluid=int(value["fluid_particles"]),
                particles=int(value["particles"]), cpu=float(value["cpu_seconds"]), wall=float(value["wall_seconds"]),
                physical=float(value["physical_time"]), rebuilds=int(value["list_rebuilds"]),
                iterations=float(value["viscous_iterations_per_step"]), neighbours=float(value["neighbours_mean"]),
                bytes=float(value["bytes_per_particle"]), peak=used.peak,
                headings={row["heading"]: float(row["seconds [s]"]) for row in rows_of(run / "timing.csv")})


def in_turn(measurements, repeats):
    """Calls the named measurements one after the other, `repeats` times around; a list of results for each name."""
    results = {name: [] for name in measurements}
    for turn in range(repeats):
        for name, measurement in measurements.items():
            results[name].append(measurement())
            print(f"  {name}, {turn + 1} of {repeats}", file=sys.stderr, flush=True)
    return results


@dataclass
class Spread:
    """Median of some numbers, with the least and the largest."""
    median: float
    least: float
    most: float

    @classmethod
    def of(cls, numbers):
        numbers = list(numbers)
        return cls(statistics.median(numbers), min(numbers), max(numbers))

    def __format__(self, spec):
        return f"{self.median:{spec}} ({self.least:{spec}} to {self.most:{spec}})"


def ratios(numerators, denominators):
    """Of runs that alternated, pair by pair."""
    return Spread.of(a / b for a, b in zip(numerators, denominators))


def machine():
    """The kind of machine, its processor and memory, as text."""
    processor = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")

    def entry(name):
        found = re.search(rf"^{name}\s*:\s*(.*)$", processor, re.MULTILINE)
        return found.group(1) if found else "?"

    flags = entry("flags").split()
    widest = next((name for flag, name in (("avx512f", "AVX-512"), ("avx2", "AVX2")) if flag in flags), "no AVX2")
    caches = pathlib.Path("/sys/devices/system/cpu/cpu0/cache")
    sizes = [f"L{(index / 'level').read_text().strip()} {(index / 'size').read_text().strip()}"
             for index in sorted(caches.glob("index*")) if (index / "type").read_text().strip() != "Instruction"]
    memory = int(re.search(r"MemTotal:\s*(\d+)", pathlib.Path("/proc/meminfo").read_text()).group(1)) / 1e6
    system = re.search(r'PRETTY_NAME="([^"]*)"', pathlib.Path("/etc/os-release").read_text())
    compiler = subprocess.run(["g++", "-dumpfullversion"], capture_output=True, text=True, check=False).stdout.strip()
    return (f"{len(os.sched_getaffinity(0))} cores of {entry('model name')} (family {entry('cpu family')}, "
            f"model {entry('model')}), {widest}, {', '.join(sizes)}, {memory:.0f} GB, "
            f"{system.group(1) if system else '?'}, g++ {compiler}")


def commit():
    described = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty=, with changes"],
                               capture_output=True, text=True, check=False)
    return described.stdout.strip() or "unknown"


class Page:
    """Tables of one measurement, written as DATE-NAME.json and DATE-NAME.md."""

    def __init__(self, name, title, command):
        self.name = name
        self.content = {"title": title, "date": datetime.date.today().isoformat(), "commit": commit(),
                        "command": command, "machine": machine(), "load": os.getloadavg()[0], "parts": [], "figures": []}

    def note(self, text):
        self.content["parts"].append({"note": text})

    def table(self, caption, columns, rows):
        """Rows of numbers and texts, in the order of the columns."""
        self.content["parts"].append({"caption": caption, "columns": columns, "rows": rows})

    def figure(self, what, figure):
        """A line of the table in docs/performance.md (summary.py)."""
        self.content["figures"].append([what, figure])

    def text(self):
        c = self.content
        lines = [f"# {c['title']}, {c['date']}", "",
                 f"Machine: {c['machine']}; load {c['load']:.1f} when it began (a run of this measurement adds its own). "
                 f"Commit {c['commit']}.", "", f"    {c['command']}"]
        for part in c["parts"]:
            lines += ["", part.get("note") or part["caption"]]
            if "note" in part:
                continue
            lines += ["", "| " + " | ".join(part["columns"]) + " |", "|" + "---|" * len(part["columns"])]
            lines += ["| " + " | ".join(shown(cell) for cell in row) + " |" for row in part["rows"]]
        return "\n".join(lines) + "\n"

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / f"{self.content['date']}-{self.name}"
        plain = json.dumps(self.content, indent=1, default=lambda spread: vars(spread))
        file.with_name(file.name + ".json").write_text(plain + "\n", encoding="utf-8")
        file.with_name(file.name + ".md").write_text(self.text(), encoding="utf-8")
        print(self.text())


def shown(cell):
    """A cell of a table: three significant digits, the spread of repeated runs behind the median."""
    if isinstance(cell, Spread):
        return f"{shown(cell.median)} ({shown(cell.least)} to {shown(cell.most)})"
    if isinstance(cell, float):
        return f"{cell:.0f}" if abs(cell) >= 1000 else f"{cell:.3g}"
    return str(cell)


def common_arguments(parser, repeats):
    parser.add_argument("thalweg", type=lambda text: pathlib.Path(text).resolve(),
                        help="the program, for example build/release/bin/thalweg")
    parser.add_argument("--repeats", type=int, default=repeats, help="of every run (default: %(default)s)")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "bench" / "results",
                        help="where table and JSON go (default: bench/results)")


def command_line(script):
    """How this run was called, without folders of the machine."""
    return " ".join([f"bench/{script}", *(pathlib.Path(a).name if a.startswith("/") else a for a in sys.argv[1:])])
