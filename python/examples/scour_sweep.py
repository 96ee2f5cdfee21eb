# %% [markdown]
# # A sweep: the scour against one parameter, and the scatter of equal runs
#
# `python3 scour_sweep.py CASE OUT`. Runs that are equal but for their rounding show what a difference means.

# %%
import pathlib
import sys

import numpy

import thalweg

case_folder, out = map(pathlib.Path, sys.argv[1:3]) if len(sys.argv) > 2 else (pathlib.Path("cases/louvain"), pathlib.Path("out/sweep"))

# %%
table = thalweg.sweep(case_folder, out, force=True, repeats=2,
                      vary={"materials.pvc.friction_angle": ["30 deg", "38 deg"]},
                      settings={"numerics.spacing": "15 mm", "output.end": "0.25 s", "output.interval": "0.05 s", "output.times": [],
                                "compare.times": ["0.2 s"]})
print("columns:", ", ".join(table.names))

# %% [markdown]
# ## Mean and scatter of each angle

# %%
angles = table["materials.pvc.friction_angle"]
for angle in numpy.unique(angles):
    scour = table["scour"][angles == angle]
    print(f"{angle} deg: scour {1000 * scour.mean():.2f} mm, runs differ by {1000 * numpy.ptp(scour):.2f} mm")

# %% [markdown]
# ## The same from the runs themselves

# %%
for folder in sorted((out / "runs").iterdir()):
    run = thalweg.Run(folder)
    print(folder.name, "deepest bed", f"{numpy.nanmin(run.profile()['bed']):.4f} m")
