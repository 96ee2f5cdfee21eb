"""Scenes filled for a measurement, and the cost of the solver's steps in them.

A cost is processor time, which other programs on the machine disturb least.
"""

import json
from dataclasses import dataclass

from thalweg.programs import call
from thalweg.tables import text_rows


@dataclass
class Cost:
    """The cost of some steps of the solver, without loading and filling."""
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


def overrides(pairs):
    """Keys of the case as options of the programs."""
    return [text for pair in pairs for text in ("--set", pair)]


def fill(thalweg, case, run, changes=()):
    """Fills a scene with particles, unless the folder `run` holds the same one already."""
    mark = run / "filled.json"
    scene = {"case": (case / "case.toml").read_text(encoding="utf-8"), "changes": list(changes)}
    if mark.exists() and json.loads(mark.read_text(encoding="utf-8")) == scene:
        return run
    call(thalweg, "gencase", case, "--out", run, "--force", *overrides(changes))
    mark.write_text(json.dumps(scene), encoding="utf-8")
    return run


def write_case(text, folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return folder


def solve(thalweg, run, *options, threads=1):
    """Runs the solver in the folder of a filled scene and returns the cost of its steps, as it reports them."""
    used = call(thalweg, "solver", run, "--threads", threads, "--force", *options)
    value = {row["quantity"]: row["value"] for row in text_rows(run / "summary.csv")}
    return Cost(steps=int(value["steps_since_restart"]), fluid=int(value["fluid_particles"]),
                particles=int(value["particles"]), cpu=float(value["cpu_seconds"]), wall=float(value["wall_seconds"]),
                physical=float(value["physical_time"]), rebuilds=int(value["list_rebuilds"]),
                iterations=float(value["viscous_iterations_per_step"]), neighbours=float(value["neighbours_mean"]),
                bytes=float(value["bytes_per_particle"]), peak=used.peak,
                headings={row["heading"]: float(row["seconds [s]"]) for row in text_rows(run / "timing.csv")})
