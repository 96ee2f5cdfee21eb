#!/usr/bin/env python3
"""Measures the cost of a particle-step over the number of particles, and the gain from a second thread: scaling.py THALWEG

The scenes are water over a bed, or water alone, between periodic sides. The domain widens while depth and spacing stay, so that
scenes differ only in their number of particles. The bed may not come to rest, because small scenes run for more steps. The cost
of a step is the difference of two runs of different length: reading, the first lists and the first touch of memory drop out.
The cost of building lists is measured with a skin of zero, with which every step builds them. `--part` makes one part of the
table at a time, for machines where all take too long.
"""

import argparse
import math
import pathlib
import re
import shutil
import sys
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from study.costs import Cost, fill, solve, write_case  # noqa: E402
from study.origin import command_line  # noqa: E402
from thalweg.programs import call  # noqa: E402
from thalweg.tables import text_rows  # noqa: E402
from study.record import Record, common_arguments  # noqa: E402
from study.repeats import Spread, in_turn, ratios  # noqa: E402

SPACING = 0.01  # [m]
LAST_CACHE = 2 << 20  # [bytes] of the counted traffic: much less than the scene, as with millions of particles
LAYERS = {2: 64, 3: 32}  # of fluid; in space the kernel reaches through a fifth of them
CASE = """
[case]
name = "layers"
dimension = {dimension}
[domain]
from = [{low}]
to = [{high}]
gravity = [{gravity}]
periodic = [{periodic}]
[[shape]]
name = "floor"
kind = "box"
role = "wall"
from = [{floor_low}]
to = [{floor_high}]
[[shape]]
name = "water"
kind = "box"
role = "water"
from = [{water_low}]
to = [{high_fluid}]
{bed}
[numerics]
spacing = "{spacing} m"
maximum_speed = "2 m/s"
[output]
end = "10 s"
"""
BED = """
[[shape]]
name = "bed"
kind = "box"
role = "sediment"
from = [{low}]
to = [{high}]
[materials.grains]
grain_density = "2650 kg/m^3"
porosity = 0.4
grain_diameter = "2 mm"
friction_angle = "30 deg"
[model]
sediment = "viscoplastic"
rest = false
"""


def lengths(*values):
    return ", ".join(f'"{value:.6g} m"' for value in values)


def scene(dimension, particles, with_bed):
    """The case file of so many fluid particles, nearly."""
    depth = LAYERS[dimension] * SPACING
    columns = max(12, round((particles / LAYERS[dimension]) ** (1 / (dimension - 1))))
    extent = [columns * SPACING] * (dimension - 1)
    zero = [0.0] * (dimension - 1)
    bed = BED.format(low=lengths(*zero, 0), high=lengths(*extent, depth / 2)) if with_bed else ""
    return CASE.format(dimension=dimension, low=lengths(*zero, -0.1), high=lengths(*extent, 1.5 * depth),
                       gravity=", ".join(['"0 m/s^2"'] * (dimension - 1) + ['"-9.81 m/s^2"']),
                       periodic=", ".join(f'"{axis}"' for axis in "xy"[:dimension - 1]), floor_low=lengths(*zero, -0.06),
                       floor_high=lengths(*extent, 0), water_low=lengths(*zero, depth / 2 if with_bed else 0),
                       high_fluid=lengths(*extent, depth), bed=bed, spacing=SPACING)


@dataclass
class Steps:
    """The cost of the steps that the longer of two runs takes beyond the shorter one: [ns] per fluid particle."""
    last: Cost  # the longer run
    cpu: float          # processor time a step
    wall: float         # by the clock a step
    lists: float        # processor time a step for refresh_neighbours
    solve: float        # processor time an iteration of the viscous solve; nan without

    @property
    def rest(self):
        """Processor time a step without the viscous solve, whose number of iterations is another matter."""
        return self.cpu - (0 if math.isnan(self.solve) else self.solve * self.last.iterations)


def measured_steps(given, run, few, many, threads, *options):
    short, long = (solve(given.thalweg, run, "--benchmark", steps, *options, threads=threads)
                   for steps in (few, many))
    steps = long.steps - short.steps
    per = 1e9 / long.fluid
    iterations = long.iterations * long.steps - short.iterations * short.steps

    def spent(heading):  # timing.csv is by the clock
        return sum(sign * cost.headings.get(heading, 0) * cost.cpu / cost.wall for sign, cost in ((1, long), (-1, short)))

    return Steps(long, (long.cpu - short.cpu) * per / steps, (long.wall - short.wall) * per / steps,
                 spent("refresh_neighbours") * per / steps,
                 spent("solve_viscosity") * per / iterations if iterations > 0 else math.nan)


def sizes(given, record, dimension, with_bed, numbers):
    rows = []
    for number in numbers:
        folder = write_case(scene(dimension, number, with_bed), given.out / f"{dimension}d-{with_bed:d}-{number}")
        run = fill(given.thalweg, folder, folder / "run")
        many = 2 + max(4, min(2000, int(given.work / number)))
        turns = in_turn({f"{number}": lambda: measured_steps(given, run, 2, many, 1),
                         f"{number}, lists in each step": lambda: measured_steps(
                             given, run, 2, 2 + max(2, many // 8), 1, "--set", "numerics.list_skin=0")},
                        1 if number > 3e6 else given.repeats)
        taken, building = turns.values()
        cost = taken[0].last
        rows.append([cost.fluid, Spread.of(t.rest for t in taken),
                     Spread.of(t.solve for t in taken) if with_bed else "-",
                     Spread.of(t.lists for t in building),
                     cost.bytes * cost.particles / cost.fluid, cost.peak / cost.particles, cost.steps])
        if number > 1e6:
            shutil.rmtree(folder)  # gigabytes
    name = f"{dimension}-D, {'water over a bed' if with_bed else 'water'}"
    record.table(f"{name}, one thread; as many walls as {cost.particles / cost.fluid - 1:.0%} of the particles beside",
                 ["particles", "CPU ns a particle-step, no lists built, without the viscous solve",
                  "CPU ns a particle and viscous iteration", "CPU ns a particle to build lists",
                  "bytes of arrays a fluid particle", "peak memory a particle, reading included", "steps"], rows)
    least, most = (pick(r[1].median for r in rows) for pick in (min, max))
    record.note(f"Dearest over cheapest: {most / least:.2f}.")
    record.figure(f"{name}, {rows[0][0]} to {rows[-1][0]} particles: CPU time a particle-step, one core",
                  f"{least:.0f} to {most:.0f} ns{' and the viscous solve' if with_bed else ''}; lists "
                  f"{min(r[3].median for r in rows):.0f} to {max(r[3].median for r in rows):.0f} ns each time; "
                  f"{rows[-1][4]:.0f} bytes a particle")


def threads(given, record):
    rows = []
    for name, dimension, number, with_bed in (("2-D, bed", 2, given.thread_particles // 3, True),
                                              ("3-D, bed", 3, given.thread_particles, True),
                                              ("3-D, water", 3, given.thread_particles, False)):
        folder = write_case(scene(dimension, number, with_bed), given.out / f"threads-{dimension}d-{with_bed:d}")
        run = fill(given.thalweg, folder, folder / "run")
        many = 2 + max(10, int(given.work / number))
        turns = in_turn({f"{name}, {n} threads": lambda n=n: measured_steps(given, run, 2, many, n)
                         for n in (1, 2)}, given.repeats)
        one, two = turns.values()
        rows.append([name, one[0].last.fluid, Spread.of(t.wall for t in one), Spread.of(t.wall for t in two),
                     ratios((t.wall for t in one), (t.wall for t in two)),
                     ratios((t.cpu for t in two), (t.cpu for t in one))])
        record.figure(f"second thread, {name}, {rows[-1][1]} particles", f"{rows[-1][4].median:.2f} times as fast")
    record.table("One thread and two, in turn; by the clock, which needs a machine with nothing else to do",
                 ["scene", "particles", "ns a particle-step, one", "two", "gain", "processor time of two over one"], rows)


def ranks(given, record):
    """Two ranks beside two threads, and what more ranks than cores can still tell: copies, messages and bytes."""
    rows, counts = [], []
    for name, number, with_bed in (("3-D, water", given.thread_particles, False), ("3-D, bed", given.thread_particles, True)):
        folder = write_case(scene(3, number, with_bed), given.out / f"ranks-{with_bed:d}")
        run = fill(given.thalweg, folder, folder / "run")
        many = 2 + max(10, int(given.work / number))
        threads, two = in_turn({f"{name}, two threads": lambda: measured_steps(given, run, 2, many, 2),
                                f"{name}, two ranks": lambda: measured_steps(given, run, 2, many, 1, "--ranks", 2)},
                               given.repeats).values()
        rows.append([name, two[0].last.fluid, Spread.of(t.wall for t in threads), Spread.of(t.wall for t in two),
                     ratios((t.wall for t in threads), (t.wall for t in two))])
        record.figure(f"two ranks beside two threads, {name}, {rows[-1][1]} particles", f"{rows[-1][4].median:.2f} of their speed")
        for number_of_ranks in (1, 2, 4, 8):
            steps = measured_steps(given, run, 2, many, 1, "--ranks", number_of_ranks)
            told = {row["quantity"]: row["value"] for row in text_rows(run / "summary.csv")}
            numbers = [float(told.get(name, 0)) for name in ("copies_per_particle", "collectives_per_step", "messages_per_step",
                                                             "sent_bytes_per_step", "bytes_per_particle")]
            counts.append([name, number_of_ranks, *numbers[:3], numbers[3] / 1e6, numbers[4], steps.cpu, steps.last.iterations])
    record.table("Two threads and two ranks, in turn; by the clock, which needs a machine with nothing else to do",
                 ["scene", "particles", "ns a particle-step, two threads", "two ranks", "speed of the ranks over that of the threads"], rows)
    record.table("Counted, of the rank that sends most, lists included; times of one run each",
                 ["scene", "ranks", "copies a particle", "collectives a step", "messages a step", "MB a step",
                  "bytes of arrays a particle", "CPU ns a particle-step, all ranks together", "viscous iterations a step"], counts)


FLUME = """
[case]
name = "flume"
dimension = 3
[domain]
from = [{low}]
to = [{top}]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[[shape]]
name = "walls"
kind = "box"
role = "wall"
from = [{low}]
to = [{high}]
[[shape]]
name = "inside"
kind = "box"
role = "empty"
from = ["0 m", "0 m", "0 m"]
to = ["5 m", "0.5 m", "1 m"]
[[shape]]
name = "water"
kind = "box"
role = "water"
from = ["0 m", "0 m", "0 m"]
to = ["5 m", "0.5 m", "0.3 m"]
{bed}
[numerics]
spacing = "{spacing} m"
maximum_speed = "2 m/s"
[output]
end = "10 s"
"""


def flume(given, record):
    """The flume of ranks_model.py: what the model says beside what is measured."""
    from ranks_model import Partition, seconds_of_step

    partition = Partition(given.spacing)
    wall = 3 * given.spacing
    rows = []
    for kind in ("water", "bed"):
        bed = BED.format(low=lengths(0, 0, 0), high=lengths(5, 0.5, 0.1)) if kind == "bed" else ""
        text = FLUME.format(low=lengths(-wall, -wall, -wall), high=lengths(5 + wall, 0.5 + wall, 0.35),
                            top=lengths(5 + wall, 0.5 + wall, 0.4), bed=bed, spacing=given.spacing)
        run = fill(given.thalweg, write_case(text, given.out / f"flume-{kind}"), given.out / f"flume-{kind}" / "run")
        many = 2 + max(10, int(given.work / partition.particles))
        turns = in_turn({f"{kind}, {n} ranks": lambda n=n: measured_steps(given, run, 2, many, 1, "--ranks", n) for n in (1, 2)},
                        given.repeats)
        one, two = turns.values()
        told = {n: sum(seconds_of_step(kind, partition.particles, partition.cut(n), n)) for n in (1, 2)}
        rows.append([kind, one[0].last.fluid, Spread.of(t.wall for t in one), Spread.of(t.wall for t in two),
                     ratios((t.wall / 2 for t in one), (t.wall for t in two)), told[1] / told[2] / 2])
    record.table("By the clock, one thread a rank, in turn; which needs a machine with two cores and nothing else to do",
                 ["scene", "particles", "ns a particle-step, one rank", "two ranks", "efficiency", "predicted"], rows)
    counts = []
    for ranks in (2, 4, 8):
        solve(given.thalweg, run, "--benchmark", 3, "--ranks", ranks, threads=1)
        told = {row["quantity"]: row["value"] for row in text_rows(run / "summary.csv")}
        cut = partition.cut(ranks)
        counts.append([ranks, float(told["copies_per_particle"]), cut.mean_copies, cut.interior])
    record.table("Counted, with walls, and predicted, without", ["ranks", "copies a particle", "predicted", "interior, predicted"],
                 counts)


def counted(given, run, steps):
    """Instructions, reads and writes, misses of the first and of the last cache, as valgrind's model of them counts."""
    said = call("valgrind", "--tool=cachegrind", "--cache-sim=yes", f"--LL={LAST_CACHE},16,64",
                "--cachegrind-out-file=/dev/null", given.thalweg.with_name("thalweg-solver"), run, "--threads", 1,
                "--benchmark", steps).text
    return [int(re.search(rf"{name}:\s+([\d,]+)", said).group(1).replace(",", ""))
            for name in ("I +refs", "D +refs", "D1 +misses", "LLd misses")]


def traffic(given, record):
    """Counts what a step reads and writes, by valgrind: the processor's own counters are often not accessible."""
    if shutil.which("valgrind") is None:
        record.note("Memory traffic is not counted: valgrind is not installed.")
        return
    rows = []
    for with_bed in (False, True):
        folder = write_case(scene(3, given.traffic_particles, with_bed), given.out / f"traffic-{with_bed:d}")
        run = fill(given.thalweg, folder, folder / "run")
        cost = solve(given.thalweg, run, "--benchmark", 2)
        few, many = (counted(given, run, steps) for steps in (1, 3))
        each = [(m - f) / (2 * cost.fluid) for f, m in zip(few, many)]
        rows.append(["water over a bed" if with_bed else "water", cost.fluid, *each[:2], 64 * each[2], 64 * each[3],
                     cost.bytes * cost.particles / cost.fluid])
    record.table(f"Counted by valgrind's model of the caches (AVX2 sweeps, which is all it knows; last cache {LAST_CACHE >> 20} MB), "
                 "3-D, for a fluid particle and a step that builds no lists",
                 ["scene", "particles", "instructions", "reads and writes", "bytes into the first cache",
                  "bytes from memory", "bytes of arrays a fluid particle"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    common_arguments(parser, 3)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/scaling"),
                        help="where scenes go; kept for the next time but for the largest (default: %(default)s)")
    parser.add_argument("--largest", type=float, default=1e7, help="number of particles in 3-D (default: %(default)g)")
    parser.add_argument("--work", type=float, default=4e6, help="particle-steps of a run, about (default: %(default)g)")
    parser.add_argument("--thread-particles", type=int, default=200000, help="of the 3-D scenes of the part threads")
    parser.add_argument("--traffic-particles", type=int, default=30000, help="of the scenes of the part traffic")
    parser.add_argument("--part", choices=("space", "plane", "threads", "ranks", "flume", "traffic"),
                        help="default: all but traffic, ranks and flume")
    parser.add_argument("--spacing", type=float, default=0.0125, help="of the part flume [m] (default: %(default)g)")
    given = parser.parse_args()

    record = Record("scaling" + (f"-{given.part}" if given.part else ""), "Particles and threads",
                    command_line("scaling/scaling.py"))
    def up_to(largest):
        return [round(10 ** (4 + k / 2)) for k in range(1 + int(2 * math.log10(largest / 1e4) + 1e-6))]
    if given.part in (None, "space"):
        sizes(given, record, 3, False, up_to(given.largest))
        sizes(given, record, 3, True, up_to(min(1e6, given.largest)))
    if given.part in (None, "plane"):
        sizes(given, record, 2, True, up_to(min(1e6, given.largest)))
    if given.part in (None, "threads"):
        threads(given, record)
    if given.part == "ranks":
        ranks(given, record)
    if given.part == "flume":
        flume(given, record)
    if given.part == "traffic":
        traffic(given, record)
    record.write(given.records)


if __name__ == "__main__":
    main()
