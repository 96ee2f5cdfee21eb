#!/usr/bin/env python3
"""What seeps through a bed run with model.seepage = "mixture": seepage_flux.py RUN [X ...]

Per snapshot and section x [m]: volume flux of the pore water relative to the grains, sum over the bed's water of
V (u - mean u of the grains), over the width of the section's window [m^2/s]; bed: porosity below 0.6. CSV to stdout,
the integral over time [m^2] as the last row.
"""

import pathlib
import re
import sys

from study.particle_file import SEDIMENT, WATER, arrays

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
    run = pathlib.Path(sys.argv[1])
    sections = [float(x) for x in sys.argv[2:]] or [-0.3, -0.1, 0.0, 0.1, 0.3]
    series = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', (run / "snapshots.pvd").read_text())
    rows = []
    for time, name in series:
        particles = arrays(run / name, {"Type", "Velocity", "Mass", "Density", "Porosity", "Points"})
        rows.append((float(time), [flux(particles, x) for x in sections]))
    print("time [s]," + ",".join(f"x = {x:g} m [m^2/s]" for x in sections))
    for time, values in rows:
        print(f"{time:g}," + ",".join(f"{v:.3e}" for v in values))
    through = [sum((t1 - t0) * (a[k] + b[k]) / 2 for (t0, a), (t1, b) in zip(rows, rows[1:]))
               for k in range(len(sections))]
    print("# integral [m^2]: " + ", ".join(f"{v:.2e}" for v in through))


if __name__ == "__main__":
    main()
