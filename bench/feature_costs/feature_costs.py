#!/usr/bin/env python3
"""Measures the cost of each feature, and shows that a scene without the feature does not pay for it: feature_costs.py THALWEG

Each row compares two runs that alternate, one without the feature and one with it. Both start from the same particles, or from
scenes with equally many. The second table lists the lines of the step that only the run with the feature calls.
"""

import argparse
import pathlib
import sys
from dataclasses import dataclass, field

BENCH = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(BENCH), str(BENCH / "scaling")]

import scaling  # noqa: E402
from study.costs import fill, overrides, solve, write_case  # noqa: E402
from study.origin import ROOT, command_line  # noqa: E402
from study.record import Record, common_arguments  # noqa: E402
from study.repeats import Spread, in_turn, ratios  # noqa: E402

GAUGES = "".join(f"""
[[gauge]]
name = "gauge-{n}"
kind = "{kind}"
at = ["{x} m", "0.08 m"]
""" for n, (kind, x) in enumerate([("water level", -0.4), ("water level", 0.2), ("pressure", -0.8), ("velocity", -0.2)]))


@dataclass
class Start:
    """The state and the settings from which the solver takes its steps."""
    run: pathlib.Path
    state: pathlib.Path = None  # a checkpoint; without: the filled scene
    changes: list = field(default_factory=list)
    flags: list = field(default_factory=list)

    def cost(self, given, length):
        state = ["--restart", self.state] if self.state else []
        return solve(given.thalweg, self.run, *state, *overrides(self.changes), *self.flags, *length)

    def but(self, *changes, flags=()):
        return Start(self.run, self.state, [*self.changes, *changes], [*self.flags, *flags])


class Scenes:
    """Scenes that several rows share. A scene is filled, and run up to its start, when it is first needed."""

    def __init__(self, given):
        self.given, self.known = given, {}

    def filled(self, name, case, *changes):
        return Start(fill(self.given.thalweg, case, self.given.out / name, changes))

    def written(self, name, text):
        folder = write_case(text, self.given.out / name)
        return Start(fill(self.given.thalweg, folder, folder / "run"))

    def after(self, seconds, start):
        """The same scene after `seconds`."""
        state = start.run / f"after-{seconds:g}s.vtp"
        if not state.exists():
            solve(self.given.thalweg, start.run, "--until", f"{seconds} s", *overrides(start.changes))
            (start.run / "checkpoint.vtp").rename(state)
        return Start(start.run, state, start.changes)

    def layers(self, dimension, with_bed):
        number = self.given.particles
        return self.written(f"layers-{dimension}d-{with_bed:d}", scaling.scene(dimension, number, with_bed))

    def louvain(self, *changes, name="louvain"):
        always = [f"numerics.spacing={self.given.spacing} mm", "model.sediment=viscoplastic",
                  "materials.pvc.dynamic_friction_angle=50 deg"]  # read by the row that needs it only
        return self.filled(name, ROOT / "cases" / "louvain", *always, *changes)


def narrow(width, particles):
    """Water in space, `width` particles wide between periodic sides and as long as it has to be."""
    length = round(particles / scaling.LAYERS[3] / width)
    text = scaling.scene(3, scaling.LAYERS[3] * 64 * 64, False)
    wide, d = scaling.lengths(64 * scaling.SPACING).strip('"'), scaling.SPACING
    return text.replace(f'"{wide}", "{wide}"', f'"{length * d:.6g} m", "{width * d:.6g} m"')


def comparisons(scenes):
    """Rows of the comparison: feature, scene, start without it, start with it, and the options that say how long to run."""
    given = scenes.given
    steps = ["--benchmark", given.steps]
    short = ["--until", f"{given.seconds} s"]
    collapse = scenes.after(given.start, scenes.louvain())
    moving = collapse.but("model.rest=false")
    still = scaling.scene(2, given.particles, True).replace("rest = false", "rest = true")
    rest = scenes.after(given.settle, scenes.written("still", still))
    dam = scenes.filled("dam", ROOT / "cases" / "dam_break", "numerics.spacing=2 mm")
    louvain = scenes.louvain("output.interval=0 s", name="silent")
    gauged = scenes.written("gauged", (ROOT / "cases/louvain/case.toml").read_text(encoding="utf-8")
                            .replace('spacing = "5 mm"', f'spacing = "{given.spacing} mm"')
                            .replace('"three-state"', '"viscoplastic"').replace('interval = "0.05 s"', "") + GAUGES)
    gate = (ROOT / "cases/gate/case.toml").read_text(encoding="utf-8").replace(
        'spacing = "5 mm"', f'spacing = "{given.spacing} mm"')
    still_gate = gate.replace('"moving wall"', '"wall"').replace('motion = "lift"\n', "")
    first, last = still_gate.index("[[motion]]"), still_gate.index("[materials.water]")
    still_gate = still_gate[:first] + still_gate[last:]
    side = round((given.particles / scaling.LAYERS[3]) ** 0.5)
    return [
        ("sediment", "3-D, bed below half of the water's depth", scenes.layers(3, False), scenes.layers(3, True), steps),
        ("sediment", "2-D, the same", scenes.layers(2, False), scenes.layers(2, True), steps),
        ("rest", "2-D, bed at rest", rest.but("model.rest=false"), rest, steps),
        ("rest", "Louvain, collapse", moving, collapse, steps),
        ("three states", "Louvain, collapse", moving, moving.but("model.sediment=three-state"), steps),
        ("pore pressure", "Louvain, collapse", moving, moving.but("model.pore_pressure=diffusion"), steps),
        ("effective pressure by Laplace", "Louvain, collapse", moving, moving.but("model.effective_pressure=laplace"), steps),
        ("friction by inertial number", "Louvain, collapse", moving, moving.but("model.rheology=mu-of-i"), steps),
        ("Mohr-Coulomb", "Louvain, collapse", moving, moving.but("model.yield=mohr-coulomb"), steps),
        ("seepage", "Louvain, start; the bed's particles twice",
         scenes.louvain("model.rest=false", name="plain"),
         scenes.louvain("model.rest=false", "model.seepage=mixture", name="seepage"), steps),
        ("wall friction", "dam break, 2-D", dam.but("model.wall_friction=none"), dam, steps),
        ("moving walls", "gate, 2-D", scenes.written("still-gate", still_gate), scenes.written("gate", gate), steps),
        ("four gauges, 1000 readings a run", "Louvain, 2-D", louvain, gauged, short),
        ("twenty snapshots", "Louvain, 2-D", louvain, louvain.but(f"output.interval={given.seconds / 20} s"), short),
        ("--profile", "Louvain, collapse", collapse, collapse.but(flags=["--profile"]), steps),
        ("narrow: 10 wide, periodic", "3-D, water, as many", scenes.written("wide", narrow(side, given.particles)),
         scenes.written("narrow", narrow(10, given.particles)), steps),
        ("third dimension", "water, as many", scenes.layers(2, False), scenes.layers(3, False), steps),
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    common_arguments(parser, 5)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/feature_costs"),
                        help="where scenes go; kept for the next time (default: %(default)s)")
    parser.add_argument("--particles", type=int, default=40000, help="of scenes that are layers (default: %(default)s)")
    parser.add_argument("--spacing", type=float, default=4, help="[mm] of the Louvain scenes (default: %(default)s)")
    parser.add_argument("--steps", type=int, default=100, help="of a run (default: %(default)s)")
    parser.add_argument("--seconds", type=float, default=0.05, help="[s] of a run with gauges or snapshots")
    parser.add_argument("--start", type=float, default=0.15, help="[s] of collapse before the rows that say so")
    parser.add_argument("--settle", type=float, default=0.5, help="[s] in which the bed comes to rest")
    parser.add_argument("--only", help="only rows whose name contains this text")
    given = parser.parse_args()

    record = Record("feature-costs", "What features cost", command_line("feature_costs/feature_costs.py"))
    rows, unused = [], []
    for name, scene, off, on, length in comparisons(Scenes(given)):
        if given.only and given.only not in name:
            continue
        runs = in_turn({f"{name}, {scene}: without": lambda: off.cost(given, length),
                        f"{name}, {scene}: with": lambda: on.cost(given, length)}, given.repeats)
        without, used = runs.values()
        a, b = without[0], used[0]
        added = [h for h in b.headings if h not in a.headings]
        rows.append([name, scene, f"{a.fluid}" if a.fluid == b.fluid else f"{a.fluid}, {b.fluid}",
                     Spread.of(c.ns for c in without).median, Spread.of(c.ns for c in used).median,
                     ratios([c.cpu / c.steps for c in used], [c.cpu / c.steps for c in without]),
                     f"{a.bytes:.0f}, {b.bytes:.0f}", f"{a.iterations:.1f}, {b.iterations:.1f}"])
        record.figure(f"{name} ({scene}): time of a step, with over without", f"{rows[-1][5].median:.2f}")
        unused.append([name, scene, len(a.headings), ", ".join(added) or "-"])
    record.table(f"One thread, {given.repeats} runs each in turn, {given.steps} steps: medians; of the ratio least and largest "
                 "too", ["feature", "scene", "particles without, with", "ns a particle-step without", "ns a particle-step with",
                         "processor time of a step, with over without", "bytes a particle", "viscous iterations a step"],
                 rows)
    record.table("What is off is not called: lines of the step that the run without the feature went through, and those that only "
                 "the run with it did", ["feature", "scene", "lines without", "lines that the feature adds"], unused)
    record.write(given.records)


if __name__ == "__main__":
    main()
