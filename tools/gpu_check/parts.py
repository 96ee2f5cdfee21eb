"""The rows of the check: what is run, for how long at most, and when it has passed."""

import dataclasses
import pathlib
import shutil
import typing

from gpu_check import machine
from gpu_check.programs import Programs, digest, last_row, table

NAMES = ["tests", "sanitizer", "bench", "ncu", "flume"]

# A scene for every model: (name, case in the bundle, settings, time until which it runs). Some ten to fifty steps each.
MODELS = [
    ("water", "cases/dam_break", (), "5 ms"),
    ("water in space", "cases/spheric02", ('numerics.spacing="6 cm"',), "20 ms"),
    ("three states and rest", "cases/louvain", ('numerics.spacing="10 mm"',), "10 ms"),
    ("three states in space", "cases/louvain3d", ('numerics.spacing="20 mm"',), "10 ms"),
    ("mixture", "cases/louvain", ('numerics.spacing="10 mm"', 'model.sediment="viscoplastic"', 'model.seepage="mixture"'), "5 ms"),
    ("pore pressure", "cases/submerged_columns", ('numerics.spacing="4 mm"',), "10 ms"),
    ("moving walls", "cases/gate", ('numerics.spacing="10 mm"',), "10 ms"),
    ("current", "cases/channel", ('numerics.spacing="10 mm"',), "20 ms"),
    ("inlet and outlet", "cases/weir", ('numerics.spacing="10 mm"',), "20 ms"),
    ("suspended load", "cases/batch_sedimentation", ('numerics.spacing="10 mm"',), "20 ms"),
    ("surface bed", "cases/pipeline_hours", (), "5 ms"),
    ("films", "cases/spheric02", ('numerics.spacing="6 cm"', "model.thin_films=true"), "20 ms"),
    ("bed load by a law", "models/bed_load-flat.toml", (), "5 ms"),
    ("opening in space", "models/openings-space.toml", (), "5 ms"),
    ("grains through openings", "models/openings-grains.toml", (), "5 ms"),
]

# Of these, the ones that are run on several ranks too, which share the GPU, and those on two ranks with a GPU each.
ON_RANKS = ("water in space", "three states in space", "surface bed")
BY_NCCL = ("three states in space",)

# Developed flows: (name, case, settings, time from which steps are counted, steps, quick).
BENCHES = [
    ("flume 0.15 M", "cases/louvain3d", ('numerics.spacing="6.6 mm"',), "0.12 s", 200, True),
    ("water 0.2 M", "cases/spheric02", ('numerics.spacing="1.8 cm"',), "0.4 s", 200, True),
    ("water 3 M", "cases/spheric02", ('numerics.spacing="7 mm"',), "0.4 s", 100, False),
    ("flume 1 M", "cases/louvain3d", ('numerics.spacing="2.95 mm"',), "0.12 s", 200, False),
    ("flume 3.55 M", "cases/louvain3d", ('numerics.spacing="2 mm"',), "0.12 s", 100, False),
    ("flume 20 M", "cases/louvain3d", ('numerics.spacing="1.05 mm"',), "5 ms", 20, False),
]
WARM_UP = 20  # steps that are taken off: modules are loaded and the first lists made

# What changes with time or machine in a table of results.
NO_COMPARE = ("compare.times=[]", 'output.interval="1 s"')


@dataclasses.dataclass
class Row:
    """A part's smallest unit. run(budget) returns {"passed": True, False or None (not finished), "why": …, …}."""

    part: str
    name: str
    seconds: float  # that it needs at most, as far as anybody knows
    run: typing.Callable
    quick: bool = True


def outcome(passed, seconds, why="", **more):
    return {"passed": passed, "seconds": round(seconds, 1), "why": why, **more}


def skipped(why, seconds=0):
    """Of a row that this machine cannot run."""
    return outcome(None, seconds, why, skipped=True)


def rows(bundle, out):
    programs = Programs(bundle, pathlib.Path(out))
    made = []
    for suite in ("OnAGpu/OnDevice*", "OnAGpu/StepsOnDevice*"):
        made.append(Row("tests", f"cuda_test {suite.rsplit('/', 1)[1].rstrip('*')}", 120,
                        lambda budget, suite=suite: run_tests(programs, budget, "cuda_test", suite)))
    made.append(Row("tests", "cases against the CPU", 240,
                    lambda budget: run_tests(programs, budget, "case_agreement_test", "*")))
    for model in MODELS:
        made.append(Row("tests", f"model: {model[0]}", 60, lambda budget, model=model: run_model(programs, budget, *model)))
    for model in MODELS:
        if model[0] in ON_RANKS:
            made.append(Row("tests", f"ranks: {model[0]}", 60,
                            lambda budget, model=model: run_ranks(programs, budget, *model)))
        if model[0] in BY_NCCL:
            made.append(Row("tests", f"NCCL: {model[0]}", 60,
                            lambda budget, model=model: run_nccl(programs, budget, *model)))
    for check in ("memcheck", "initcheck", "racecheck"):
        for name, case, settings, until in (
                ("dam break", "cases/dam_break", ('numerics.spacing="2 cm"',), "10 ms"),
                ("two-phase", "cases/louvain", ('numerics.spacing="20 mm"',), "5 ms")):
            made.append(Row("sanitizer", f"{check}: {name}", 150,
                            lambda budget, a=(check, name, case, settings, until): run_sanitizer(programs, budget, *a),
                            quick=check != "racecheck"))
    for bench in BENCHES:
        name, *scene, quick = bench
        small = quick or "1 M" in name
        made.append(Row("bench", name, 60 if small else 240,
                        lambda budget, a=(name, *scene): run_bench(programs, budget, *a), quick))
        made.append(Row("bench", f"{name}, shares", 30 if small else 90,
                        lambda budget, a=(name, scene[-1]): run_shares(programs, budget, *a), quick))
        if scene[0].endswith("louvain3d"):
            for way in ("stored", "computed"):
                made.append(Row("bench", f"{name}, {way}", 60,
                                lambda budget, a=(name, scene[-1], way): run_again(programs, budget, *a), False))
    made.append(Row("ncu", "ncu: flume 3.55 M", 240, lambda budget: run_ncu(programs, budget), quick=False))
    made.append(Row("flume", "flume, 1 s at 2 mm", 30, lambda budget: run_flume(programs, budget), quick=False))
    return made


def run_tests(programs, budget, program, suite):
    file = programs.bundle / "bin" / program
    if not file.exists():
        return outcome(False, 0, f"{program} is not in the bundle; build it with the tests and the CUDA core")
    environment = {"THALWEG_CASES": str(programs.bundle / "cases"), "THALWEG_TEST_BACKEND": "cuda"}
    name = f"{program}-{suite}"
    status, seconds = programs.run(name, [file, f"--gtest_filter={suite}"], min(600, budget.left()), **environment)
    if status == "timeout":
        return outcome(None, seconds, "ran out of time")
    return outcome(status == 0, seconds, "" if status == 0 else programs.last_lines(name))


def run_model(programs, budget, model, case, settings, until):
    """The same run twice on the GPU and once on the CPU."""
    name = f"model {model}"
    seconds = 0
    found = []
    for way, backend in (("first", "cuda"), ("second", "cuda"), ("cpu", "openmp")):
        folder = programs.fill(f"{name} {way}", case, (*settings, *NO_COMPARE), budget.left())
        if folder is None:
            return outcome(False, seconds, "the scene was not filled: " + programs.last_lines(f"{name} {way}-fill"))
        status, took = programs.solve(f"{name} {way}", folder, min(120, budget.left()), "--until", until, backend=backend)
        seconds += took
        if status != 0:
            passed = None if status == "timeout" else False
            return outcome(passed, seconds, f"{way} run: {programs.last_lines(f'{name} {way}')}")
        found.append(folder)
    if digest(found[0] / "history.csv") != digest(found[1] / "history.csv"):
        return outcome(False, seconds, "two runs on the GPU differ in history.csv")
    if digest(found[0] / "checkpoint.vtp") != digest(found[1] / "checkpoint.vtp"):
        return outcome(False, seconds, "two runs on the GPU differ in checkpoint.vtp")
    gpu, cpu = (last_row(found[n] / "history.csv") for n in (0, 2))
    for column, tolerance in AGREEMENT.items():
        key = next((k for k in gpu if k.split(" [")[0] == column), None)
        if key is None:
            return outcome(False, seconds, f"history.csv has no column {column}")
        a, b = float(gpu[key]), float(cpu[key])
        if abs(a - b) > tolerance * max(abs(a), abs(b)):
            return outcome(False, seconds, f"{column}: {a:.6g} on the GPU, {b:.6g} on the CPU")
    for folder in found:
        shutil.rmtree(folder)
    return outcome(True, seconds)


def run_ranks(programs, budget, model, case, settings, until):
    """The same run on one, two and three ranks."""
    return compare_ranks(programs, budget, f"ranks {model}", case, settings, until, (1, 2, 3))


def run_nccl(programs, budget, model, case, settings, until):
    """The same run on one rank, and on two that send to each other by NCCL."""
    if machine.gpus() < 2:
        return skipped("needs two GPUs")
    if not (programs.bundle / "bin" / "thalweg_link_nccl.so").exists():
        return skipped("the bundle was built without NCCL")
    return compare_ranks(programs, budget, f"nccl {model}", case, settings, until, (1, 2), "--device-messages", "nccl")


def compare_ranks(programs, budget, name, case, settings, until, numbers, *options):
    """The same run on so many ranks each time."""
    if shutil.which("mpirun") is None:
        return skipped("mpirun is not on this machine")
    seconds = 0
    found = []
    for ranks in numbers:
        folder = programs.fill(f"{name} {ranks}", case, (*settings, *NO_COMPARE), budget.left())
        if folder is None:
            return outcome(False, seconds, "the scene was not filled: " + programs.last_lines(f"{name} {ranks}-fill"))
        status, took = programs.solve(f"{name} {ranks}", folder, min(120, budget.left()), "--until", until, "--ranks", str(ranks),
                                      *options)
        seconds += took
        said = programs.last_lines(f"{name} {ranks}")
        if status != 0 and " MPI" in said:
            return skipped(f"MPI does not run on this machine: {said}", seconds)
        if status != 0:
            return outcome(None if status == "timeout" else False, seconds, f"{ranks} ranks: {said}")
        found.append(folder)
    for folder in found[1:]:
        for file in ("history.csv", "checkpoint.vtp"):
            if digest(found[0] / file) != digest(folder / file):
                return outcome(False, seconds, f"{folder.name} differs from one rank in {file}")
    for folder in found:
        shutil.rmtree(folder)
    return outcome(True, seconds)


# Relative differences of GPU and CPU after some tens of steps: sums in another order, and a viscous solve that stops at a
# residual of 1e-3 (tests/solver/simulation/case_agreement_test.cpp).
AGREEMENT = {"kinetic_energy": 0.02, "potential_energy": 1e-4, "water_mass": 1e-6, "sediment_mass": 1e-6}


def run_sanitizer(programs, budget, check, scene, case, settings, until):
    tool = shutil.which("compute-sanitizer") or "/usr/local/cuda/bin/compute-sanitizer"
    if not pathlib.Path(tool).exists():
        return skipped("compute-sanitizer is not on this machine")
    name = f"{check} {scene}"
    folder = programs.fill(name, case, (*settings, *NO_COMPARE), budget.left())
    if folder is None:
        return outcome(False, 0, "the scene was not filled")
    wrap = (tool, "--tool", check, "--error-exitcode", "99")
    status, seconds = programs.solve(name, folder, min(400, budget.left()), "--until", until, wrap=wrap)
    if status == "timeout":
        return outcome(None, seconds, "ran out of time")
    return outcome(status == 0, seconds, "" if status == 0 else programs.last_lines(name))


def developed(programs, budget, name, case, settings, until):
    """The folder with a checkpoint of the developed flow, made once: (folder, "") or (None, why)."""
    folder = programs.runs / name.replace(" ", "_")
    if not (folder / "developed").exists():
        fresh = not (folder / "checkpoint.vtp").exists()
        if fresh and programs.fill(name, case, (*settings, *NO_COMPARE), budget.left()) is None:
            return None, "the scene was not filled: " + programs.last_lines(f"{name}-fill")
        status, _ = programs.solve(f"{name} warm-up", folder, budget.left() - 10, "--until", until, "--restart", "latest")
        if status != 0:
            return None, f"warm-up: {status}: {programs.last_lines(f'{name} warm-up')}"
        (folder / "developed").touch()
        shutil.rmtree(folder / "snapshots", ignore_errors=True)
    return folder, ""


def steps_of(programs, budget, name, folder, steps, *options, **environment):
    """Takes steps from the checkpoint and returns (summary, "") or (None, why)."""
    status, _ = programs.solve(name, folder, budget.left(), "--restart", "latest", "--until", "10 s", "--benchmark",
                               str(steps), *options, **environment)
    if status != 0:
        return None, f"{status}: {programs.last_lines(name)}"
    return table(folder / "summary.csv"), ""


def measure(programs, budget, name, folder, steps, **environment):
    """Figures of `steps` steps after the warm-up; refused where another process uses the GPU."""
    start = budget.left()
    if why := machine.busy():
        return outcome(False, 0, f"no figures: {why}")
    before, why = steps_of(programs, budget, f"{name} before", folder, WARM_UP, **environment)
    if before is None:
        return outcome(False, start - budget.left(), why)
    after, why = steps_of(programs, budget, name, folder, WARM_UP + steps, **environment)
    if after is None:
        return outcome(False, start - budget.left(), why)
    if why := machine.busy():
        return outcome(False, start - budget.left(), f"no figures: {why}")
    wall = float(after["wall_seconds"]) - float(before["wall_seconds"])
    lists = int(after["list_rebuilds"]) - int(before["list_rebuilds"])
    fluid = int(after["fluid_particles"])
    if wall <= 0:
        return outcome(False, start - budget.left(), f"no figures: {steps} steps took {wall} s")
    figures = {
        "particles": int(after["particles"]), "fluid_particles": fluid, "steps": steps, "wall_seconds": wall,
        "time": float(before["physical_time"]), "ns_per_fluid_particle_step": 1e9 * wall / (fluid * steps),
        "list_rebuilds": lists, "steps_per_list": steps / lists if lists else float(steps),
        "coefficients": environment.get("THALWEG_PAIR_COEFFICIENTS", "by memory"),
        **{key: float(after[key]) for key in ("neighbours_mean", "list_entries_per_particle", "bytes_per_particle",
                                              "viscous_iterations_per_step", "fixed_launches", "repeated_launches")}}
    return outcome(True, start - budget.left(), figures=figures)


def run_bench(programs, budget, name, case, settings, until, steps):
    folder, why = developed(programs, budget, name, case, settings, until)
    if folder is None:
        return outcome(None if "timeout" in why else False, 0, why)
    return measure(programs, budget, name, folder, steps)


def known(programs, name):
    folder = programs.runs / name.replace(" ", "_")
    return folder if (folder / "developed").exists() else None


def run_again(programs, budget, name, steps, way):
    """The same with pair coefficients that are stored, or computed again."""
    folder = known(programs, name)
    if folder is None:
        return outcome(None, 0, f"{name} comes first")
    return measure(programs, budget, f"{name} {way}", folder, steps, THALWEG_PAIR_COEFFICIENTS=way)


def run_shares(programs, budget, name, steps):
    folder = known(programs, name)
    if folder is None:
        return outcome(None, 0, f"{name} comes first")
    start = budget.left()
    found, why = steps_of(programs, budget, f"{name} shares", folder, max(WARM_UP, steps // 2), "--profile")
    if found is None:
        return outcome(False, start - budget.left(), why)
    headings = {k: float(v) for k, v in table(folder / "timing.csv").items() if k != "heading"}
    return outcome(True, start - budget.left(), headings=headings)


NCU_METRICS = ",".join((
    "gpu__time_duration.sum", "sm__issue_active.avg.pct_of_peak_sustained_elapsed",
    "sm__warps_active.avg.pct_of_peak_sustained_active", "l1tex__t_sector_hit_rate.pct", "lts__t_sector_hit_rate.pct",
    "l1tex__throughput.avg.pct_of_peak_sustained_elapsed", "dram__bytes.sum"))


def run_ncu(programs, budget):
    tool = shutil.which("ncu") or "/usr/local/cuda/bin/ncu"
    if not pathlib.Path(tool).exists():
        return skipped("ncu is not on this machine")
    folder = known(programs, "flume 3.55 M")
    if folder is None:
        return outcome(None, 0, "flume 3.55 M comes first")
    start = budget.left()
    wrap = (tool, "--csv", "--metrics", NCU_METRICS, "--launch-skip", "200", "--launch-count", "400")
    status, seconds = programs.solve("ncu", folder, min(400, budget.left()), "--restart", "latest", "--until", "10 s",
                                     "--benchmark", "20", wrap=wrap)
    passed = None if status == "timeout" else status == 0
    return outcome(passed, min(seconds, start), "" if passed else programs.last_lines("ncu"))


def run_flume(programs, budget):
    """One second of the paper's run. It goes on from its checkpoint in the next call where the time runs out."""
    name = "flume 1 s"
    folder = programs.runs / name.replace(" ", "_")
    if why := machine.busy():
        return outcome(False, 0, f"no figures: {why}")
    if not (folder / "case.resolved.toml").exists():
        if programs.fill(name, "cases/louvain3d", ('numerics.spacing="2 mm"',), budget.left()) is None:
            return outcome(False, 0, "the scene was not filled")
    status, seconds = programs.solve(name, folder, budget.left() - 20, "--restart", "latest")
    figures = {}
    if (folder / "summary.csv").exists():
        summary = table(folder / "summary.csv")
        figures = {"flow_seconds": float(summary["physical_time"]), "wall_seconds": float(summary["wall_seconds"]),
                   "summary": summary}
    if status == "timeout":
        return outcome(None, seconds, "goes on with the next call", **figures)
    return outcome(status == 0, seconds, "" if status == 0 else programs.last_lines(name), **figures)
