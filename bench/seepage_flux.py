#!/usr/bin/env python3
"""Flux of pore water through the bed of a run with model.seepage = "mixture": seepage_flux.py RUN [X ...]

Per snapshot and section x [m]: volume flux of the pore water relative to the grains, sum over the bed's water of V (u - mean u
of the grains), over the width of the section's window [m^2/s]; bed: porosity below 0.6. The integrals over time [m^2] stand in
the comment. The table goes to bench/records/seepage-flux.csv.
"""

import argparse
import pathlib
import re

from study import origin
from thalweg.particle_file import SEDIMENT, WATER, arrays
from study.record import RECORDS
from thalweg.tables import write_table

HALF_WIDTH = 0.04  # [m] of a section's window
BED = 0.6  # porosity of the bed is below


def flux(particles, x):
    if "Porosity" not in particles:
        return 0.0  # the start, before the first step
    water = volume = grains = grain_velocity = 0.0
    for i, kind in enumerate(particles["Type"]):
        if abs(particles["Points"][3 * i] - x) >= HALF_WIDTH or particles["Porosity"][i] >= BED:
            continue
        velocity = particles["Velocity"][3 * i]
        if kind == WATER:
            own = particles["Mass"][i] / particles["Density"][i]
            water += own * velocity
            volume += own
        elif kind == SEDIMENT:
            grains += 1
            grain_velocity += velocity
    slip = water - (volume * grain_velocity / grains if grains else 0)
    return slip / (2 * HALF_WIDTH)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=pathlib.Path, help="folder of a finished run")
    parser.add_argument("x", type=float, nargs="*", default=[-0.3, -0.1, 0.0, 0.1, 0.3],
                        help="[m] sections (default: those of Louvain)")
    parser.add_argument("--records", type=pathlib.Path, default=RECORDS, help="where the table goes (default: bench/records)")
    given = parser.parse_args()
    run, sections = given.run, given.x
    series = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', (run / "snapshots.pvd").read_text())
    rows = []
    for time, name in series:
        particles = arrays(run / name, {"Type", "Velocity", "Mass", "Density", "Porosity", "Points"})
        rows.append((float(time), [flux(particles, x) for x in sections]))
    through = [sum((t1 - t0) * (a[k] + b[k]) / 2 for (t0, a), (t1, b) in zip(rows, rows[1:]))
               for k in range(len(sections))]
    integrals = ", ".join(f"{x:g} m: {v:.2e}" for x, v in zip(sections, through))
    given.records.mkdir(parents=True, exist_ok=True)
    write_table(given.records / "seepage-flux.csv",
                [{"time [s]": f"{time:g}"} | {f"x = {x:g} m [m^2/s]": f"{v:.3e}" for x, v in zip(sections, values)}
                 for time, values in rows],
                f"{origin.lines('seepage_flux.py')}\nSeepage through the bed, relative to the grains; integrals [m^2] {integrals}")


if __name__ == "__main__":
    main()
