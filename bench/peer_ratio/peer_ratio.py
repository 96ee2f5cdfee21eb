#!/usr/bin/env python3
"""Compares one core with DualSPHysics 5.4 on the same 3-D dam break: peer_ratio.py THALWEG --dualsphysics FOLDER

Both programs start from the same particles in the middle of the collapse, which ours computes first. They use the same kernel
(Wendland C2), smoothing length, speed of sound, artificial viscosity and density diffusion, and one thread. The measure is the
number of evaluations of the forces on a fluid particle per second of processor time: our leapfrog step has one evaluation,
their symplectic step has two. The time before the first step (reading, first lists) is left out: for theirs
it is measured as a run of one step, ours reports it.

FOLDER holds the sources of DualSPHysics 5.4, which are compiled with -O3 -march=native -ffast-math; without it only the
second table is made: ours alone on the two-phase scene of cases/louvain.
"""

import argparse
import pathlib
import statistics
import sys

BENCH = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(BENCH), str(BENCH.parent / "python")]

import dualsphysics  # noqa: E402
from study.costs import fill, solve, write_case  # noqa: E402
from study.origin import ROOT, command_line  # noqa: E402
from study.record import Record, common_arguments  # noqa: E402
from study.repeats import Spread, in_turn, ratios, shown  # noqa: E402
from thalweg import particle_file  # noqa: E402

SCENE = {"name": "collapse", "spacing": 0.008, "smoothing_length": 0.012, "density": 1000.0, "sound_speed": 35.0,
         "artificial_viscosity": 0.02, "density_diffusion": 0.1, "cfl": 0.2}
TANK = (1.6, 0.672, 0.4)     # [m]
COLUMN = (0.4, 0.672, 0.304)  # [m] 50 x 84 x 38 particles
CELLS = {"full": "as wide as the support (its default)", "half": "half as wide"}
CASE = """
[case]
name = "collapse"
dimension = 3
[domain]
from = ["-0.1 m", "-0.1 m", "-0.1 m"]
to = ["1.7 m", "0.772 m", "0.8 m"]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[[shape]]
name = "tank"
kind = "box"
role = "wall"
side = "outside"
open = ["+z"]
from = ["0 m", "0 m", "0 m"]
to = ["{tank[0]} m", "{tank[1]} m", "{tank[2]} m"]
[[shape]]
name = "column"
kind = "box"
role = "water"
from = ["0 m", "0 m", "0 m"]
to = ["{column[0]} m", "{column[1]} m", "{column[2]} m"]
[numerics]
spacing = "{scene[spacing]} m"
smoothing_ratio = {ratio}
maximum_speed = "{speed} m/s"
artificial_viscosity = {scene[artificial_viscosity]}
density_diffusion = {scene[density_diffusion]}
[output]
end = "{end} s"
interval = "{end} s"
"""


def ours(given):
    """The folder of our scene, and its state after `given.start` seconds of collapse."""
    end = 10.0
    case = CASE.format(tank=TANK, column=COLUMN, scene=SCENE, ratio=SCENE["smoothing_length"] / SCENE["spacing"],
                       speed=SCENE["sound_speed"] / 10, end=end)
    folder = write_case(case, given.out / "collapse")
    run = fill(given.thalweg, folder, folder / "run", [f"numerics.spacing={given.spacing} m"])
    state = folder / f"after-{given.start:g}s-{given.spacing}m.vtp"
    if not state.exists():
        solve(given.thalweg, run, "--until", f"{given.start} s", threads=2)
        (run / "checkpoint.vtp").rename(state)
    return run, state


def theirs(given, state):
    """The same fluid, and of our walls the layer next to it, which is what DualSPHysics' own scenes have."""
    found = particle_file.arrays(state, {"Points", "Velocity", "Density", "Type"})
    scene = SCENE | {"spacing": given.spacing, "smoothing_length": given.spacing * 1.5}
    walls, fluid, velocity, density = [], [], [], []
    for i, kind in enumerate(found["Type"]):
        place = found["Points"][3 * i:3 * i + 3]
        if kind == particle_file.WATER:
            fluid += place
            velocity += found["Velocity"][3 * i:3 * i + 3]
            density.append(found["Density"][i])
        elif all(-given.spacing < x < extent + given.spacing for x, extent in zip(place, TANK)):
            walls += place
    return dualsphysics.write_scene(given.out / "dualsphysics", scene, walls, fluid, velocity, density), len(walls) // 3


def compare(given, record):
    program = dualsphysics.build(given.dualsphysics, given.out.resolve() / "build", 2)
    run, state = ours(given)
    case, n_walls = theirs(given, state)
    n = solve(given.thalweg, run, "--restart", state, "--benchmark", 1).fluid

    def evaluations_of_ours():
        cost = solve(given.thalweg, run, "--restart", state, "--benchmark", given.steps)
        return n * cost.steps / cost.cpu, cost

    def evaluations_of_theirs(cells, start):
        cpu, log = dualsphysics.take_steps(program, case, given.peer_steps, cells)
        return 2 * n * (given.peer_steps - 1) / (cpu - start), dualsphysics.version(log)

    starts = {cells: statistics.median(dualsphysics.take_steps(program, case, 1, cells)[0] for _ in range(3))
              for cells in CELLS}
    found = in_turn({"ours": evaluations_of_ours} |
                    {cells: lambda cells=cells: evaluations_of_theirs(cells, starts[cells]) for cells in CELLS},
                    given.repeats)
    our_rates = [rate for rate, _ in found["ours"]]
    cost = found["ours"][0][1]
    their_rates = {cells: [rate for rate, _ in found[cells]] for cells in CELLS}
    version = found["full"][0][1]
    over_theirs = {cells: ratios(our_rates, their_rates[cells]) for cells in CELLS}
    record.table(f"3-D dam break, {n} fluid particles, smoothing length 1.5 spacings, from {given.start} s after the "
                 f"collapse began; {given.repeats} runs each in turn: median (least to largest)",
                 ["program", "million evaluations/CPU s", "ours over it, pair by pair", "steps", "evaluations a step", "walls",
                  "lists built"],
                 [["Thalweg, leapfrog", Spread.of(r / 1e6 for r in our_rates), ratios(our_rates, our_rates), cost.steps, 1,
                   cost.particles - cost.fluid, cost.rebuilds],
                  *([f"DualSPHysics {version}, symplectic, {dualsphysics.FLAGS}, cells {CELLS[cells]}",
                     Spread.of(r / 1e6 for r in their_rates[cells]), over_theirs[cells], given.peer_steps, 2, n_walls,
                     "every step"] for cells in CELLS)])
    pairs = cost.neighbours * statistics.median(our_rates) / 1e6
    record.note(f"{cost.neighbours:.0f} neighbours in the support; ours meets {pairs:.0f} million of them a CPU second in each of two "
                "sweeps, one for accelerations and one for density rates, beside what walls and lists take.")
    for cells, words in CELLS.items():
        record.figure(f"dam break in space, {n} particles, {cost.neighbours:.0f} neighbours: evaluations of the forces a CPU "
                      f"second, one core; beside DualSPHysics {version} with cells {words}",
                      f"{statistics.median(our_rates) / 1e6:.2f} million; "
                      f"{statistics.median(their_rates[cells]) / 1e6:.2f} million; ratio {shown(over_theirs[cells])}")
    total = sum(cost.headings.values())
    record.table("Where ours spends its time", ["line of the step", "share"],
                 [[name, f"{100 * seconds / total:.1f} %"]
                  for name, seconds in sorted(cost.headings.items(), key=lambda line: -line[1]) if seconds > 0.005 * total])


def two_phase(given, record):
    """Runs the whole plane two-phase scene with our program alone."""
    run = fill(given.thalweg, ROOT / "cases" / "louvain", given.out / "louvain",
               ["numerics.spacing=4 mm"])
    until = ["--until", f"{given.two_phase} s"]
    costs = in_turn({"Louvain": lambda: solve(given.thalweg, run, *until)}, given.repeats)["Louvain"]
    record.table(f"Louvain, 2-D, 4 mm, three states, {costs[0].fluid} fluid particles, {given.two_phase:g} s, one thread "
                 "(in DualSPHysics' non-Newtonian build 1 s took 642 to 798 CPU s on such a core, 0.65 million evaluations/CPU s)",
                 ["CPU s", "million evaluations/CPU s", "steps", "viscous iterations a step"],
                 [[Spread.of(c.cpu for c in costs), Spread.of(1e3 / c.ns for c in costs), costs[0].steps,
                   costs[0].iterations]])
    if given.two_phase == 1:
        record.figure("Louvain in the plane, 4 mm, three states, 1 s, one core",
                      f"{statistics.median(c.cpu for c in costs):.1f} CPU s, "
                      f"{statistics.median(1e3 / c.ns for c in costs):.1f} million particle-steps a CPU second "
                      "(DualSPHysics' non-Newtonian build: 642 to 798 CPU s)")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    common_arguments(parser, 5)
    parser.add_argument("--dualsphysics", type=pathlib.Path, help="folder of DualSPHysics 5.4 with its sources")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/peer_ratio"),
                        help="where scenes and the build go; kept for the next time (default: %(default)s)")
    parser.add_argument("--spacing", type=float, default=SCENE["spacing"], help="[m] (default: %(default)s)")
    parser.add_argument("--start", type=float, default=0.2, help="[s] where both start from (default: %(default)s)")
    parser.add_argument("--steps", type=int, default=120, help="of ours in each run (default: %(default)s)")
    parser.add_argument("--peer-steps", type=int, default=13, help="of theirs in each run (default: %(default)s)")
    parser.add_argument("--two-phase", type=float, default=1.0, help="[s] of the plane scene; 0: without it")
    given = parser.parse_args()
    record = Record("peer", "Beside DualSPHysics on one core", command_line("peer_ratio/peer_ratio.py"))
    if given.dualsphysics is None:
        record.note("DualSPHysics was not given (--dualsphysics FOLDER): no comparison.")
    else:
        compare(given, record)
    if given.two_phase > 0:
        two_phase(given, record)
    record.write(given.records)


if __name__ == "__main__":
    main()
