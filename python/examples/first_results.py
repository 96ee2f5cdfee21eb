# %% [markdown]
# # From a case to a figure of your own
#
# A dam break over grains at a coarse spacing: changed, run, and read as NumPy arrays. Open this file as a notebook in an editor that knows
# `# %%` cells, or run it: `python3 first_results.py CASE OUT`. The program `thalweg` has to be on the PATH.

# %%
import pathlib
import sys

import numpy

import thalweg

case_folder, out = map(pathlib.Path, sys.argv[1:3]) if len(sys.argv) > 2 else (pathlib.Path("cases/louvain"), pathlib.Path("out/first"))

# %% [markdown]
# ## The case
# Values are texts with units; `si` gives numbers. A change keeps the comments of the file.

# %%
case = thalweg.Case.read(case_folder)
print(case["case.title"])
print("grains of", case.si("materials.pvc.grain_diameter") * 1000, "mm,", len(case.names("shape")), "shapes")
case["numerics.spacing"] = (0.01, "mm")
case["output.end"] = "0.3 s"
case["output.interval"] = "0.1 s"
case["output.times"] = []
case["compare.times"] = ["0.2 s"]

# %% [markdown]
# ## The run

# %%
run = thalweg.run(case, out, force=True)
print(len(run.times), "snapshots, to", run.times[-1], "s;", len(run.warnings), "warnings")

# %% [markdown]
# ## Tables: the front of the water over time

# %%
front = run.table("profiles/front.csv")
column = next(name for name in front.names if name != "time")
speed = numpy.gradient(front[column], front["time"])
print(f"the front moves at {speed[-1]:.2f} m/s at the end")

# %% [markdown]
# ## Particles: the mean velocity of the water in slices of 0.1 m

# %%
particles = run.particles()
water = particles["Type"] == 2
x, u = particles.points[water, 0], particles["Velocity"][water, 0]
edges = numpy.arange(x.min(), x.max() + 0.1, 0.1)
count, _ = numpy.histogram(x, edges)
total, _ = numpy.histogram(x, edges, weights=u)
means = numpy.divide(total, count, out=numpy.full(len(count), numpy.nan), where=count > 0)
for left, mean in zip(edges, means):
    print(f"x = {left:5.2f} m: {mean:6.3f} m/s")

# %% [markdown]
# ## A profile: how far the bed has moved

# %%
first, last = run.profile(run.times[0]), run.profile()
change = last["bed"] - numpy.interp(last["x"], first["x"], first["bed"])
print(f"deepest scour {-1000 * numpy.nanmin(change):.1f} mm at x = {last['x'][numpy.nanargmin(change)]:.3f} m")
numpy.savetxt(out / "bed_change.csv", numpy.column_stack([last["x"], change]), delimiter=",", header="x [m],change [m]", comments="")
