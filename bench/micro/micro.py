#!/usr/bin/env python3
"""Measures every pass and sweep of the solver by itself, for each instruction set this processor has.

    bench/micro/micro.py build/release

runs the programs thalweg_micro_* of that build on one thread (five minutes or less) and writes bench/records/micro.json and
micro.md: nanoseconds a particle, million useful pairs a second, how many lanes were useful, bytes that had to be moved, and
the instructions of each sweep's inner loop as the compiler left them. Times are CPU times, the least of three repetitions. Where
valgrind is, callgrind counts the instructions that the sweeps of AVX2 carry out; it does not know AVX-512.
"""

import argparse
import datetime
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from disassembly import count, inner_loop, sweeps  # noqa: E402
from study import origin  # noqa: E402
from study.record import RECORDS  # noqa: E402
from thalweg.tables import markdown  # noqa: E402

LANES = {"avx512": 16, "avx2": 8, "baseline": 4}
NEEDS = {"avx512": {"avx512f", "avx512dq", "avx512vl", "avx512bw"}, "avx2": {"avx2", "fma"}, "baseline": set()}
# Keys that Google Benchmark adds to the results of a run.
BOOKKEEPING = {"family_index", "per_family_instance_index", "run_name", "run_type", "repetitions", "repetition_index", "threads",
               "real_time", "time_unit"}
SWEEPS = {
    r"ContinuitySweep<": "density rate",
    r"ContinuityAndStrainSweep<\d, false>": "density rate and strain",
    r"MomentumSweep<\d, false>": "momentum",
    r"ViscousCoefficientSweep<\d, true": "viscous coefficients",
    r"ViscousProductSweep<\d, true": "viscous product",
    r"ViscousProductSweep<\d, false": "viscous product, nothing stored",
    r"BedSurfaceSweep<": "bed surface",
    r"WallPressureSweep<": "wall pressure",
}


def run(program, repetitions, seconds, chosen):
    """Runs a benchmark program; {name: the repetition with the least CPU time}."""
    text = subprocess.run([program, "--benchmark_format=json", f"--benchmark_repetitions={repetitions}",
                           f"--benchmark_min_time={seconds}", f"--benchmark_filter={chosen}"],
                          check=True, capture_output=True, text=True).stdout
    best = {}
    for row in json.loads(text)["benchmarks"]:
        if row["run_type"] == "iteration":
            name = row["name"]
            if name not in best or row["cpu_time"] < best[name]["cpu_time"]:
                best[name] = {key: value for key, value in row.items() if key not in BOOKKEEPING}
    return best


def count_instructions(program):
    """{"3-D/momentum": {"instructions": …}} of the sweeps' inner loops."""
    counts = {}
    for dimension, body, code in sweeps(program):
        title = next((title for pattern, title in SWEEPS.items() if re.match(pattern, body)), None)
        if title is not None:
            counts[f"{dimension}-D/{title}"] = count(inner_loop(code))
    if missing := {f"{d}-D/{title}" for d in "23" for title in SWEEPS.values()} - counts.keys():
        sys.exit(f"{program}: found no inner loop of {', '.join(sorted(missing))}")
    return counts


def count_executed(program, names):
    """{name: instructions a particle} of whole sweeps, ends and lists of a cluster included, by callgrind."""
    counts = {}
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out",
                                   "--toggle-collect=*sweep_cluster*", program, f"--benchmark_filter=^{name}$",
                                   "--benchmark_min_time=0.0001", "--benchmark_format=json"],
                                  check=True, capture_output=True, text=True)
        row = json.loads(done.stdout)["benchmarks"][0]
        collected = int(re.search(r"Collected : (\d+)", done.stderr)[1])
        counts[name] = collected / (row["iterations"] * row["particles"])
    return counts


def size_of(name):
    return int(name.rsplit("/", 1)[1])


def table(head, rows):
    return "\n".join(markdown(head, rows))


def sweep_rows(results, sets, dimension):
    first = results[sets[0]]["rows"]
    for name, row in first.items():
        if not name.startswith(dimension) or "pairs/s" not in row:
            continue
        efficiency = row["neighbours"] / row["lanes/particle"]
        cells = [name.split("/")[1], f"{row['particles']:.0f}", f"{row['neighbours']:.0f}", f"{row['lanes/particle']:.0f}",
                 f"{100 * efficiency:.0f} %", f"{row['bytes/particle']:.0f}"]
        for isa in sets:
            r = results[isa]["rows"][name]
            cells += [f"{1e9 * r['s/particle']:.0f}", f"{r['pairs/s'] / 1e6:.0f}"]
        cells.append(f"{row['bytes/particle'] / row['s/particle'] / 1e9:.1f}")
        yield cells


def pass_rows(results, sets):
    for name, row in results[sets[0]]["rows"].items():
        if "particles" not in row or "pairs/s" in row:
            continue
        cells = [name.split("/")[0], name.split("/")[1], f"{row['particles']:.0f}"]
        cells += [f"{1e9 * results[isa]['rows'][name]['s/particle']:.2f}" for isa in sets]
        moved = row["bytes/particle"]
        cells += [f"{moved:.0f}", f"{moved / row['s/particle'] / 1e9:.1f}"] if moved > 0 else ["", ""]
        yield cells


def floor_rows(results, sets):
    """Measured time beside what multiplications and memory alone would take at the machine's measured peaks."""
    for isa in sets:
        rows, loops = results[isa]["rows"], results[isa]["loops"]
        multiplications = rows["peak/multiply-add"]["flop/s"] / 2  # lanes a second
        memory = max((row for name, row in rows.items() if name.startswith("peak/read")), key=lambda r: size_of(r["name"]))
        largest = max(size_of(name) for name in rows if name.startswith("3-D/"))
        for title in ("density rate and strain", "momentum", "viscous coefficients", "viscous product"):
            row, loop = rows[f"3-D/{title}/{largest}"], loops.get(f"3-D/{title}")
            if loop is None:
                continue
            turns = row["lanes/particle"] / LANES[isa]
            yield [isa, title, f"{turns * loop['instructions']:.0f}",
                   f"{1e9 * loop['multiply'] * row['lanes/particle'] / multiplications:.0f}",
                   f"{1e9 * row['bytes/particle'] / memory['bytes_per_second']:.0f}", f"{1e9 * row['s/particle']:.0f}",
                   f"{1e9 * row['s/particle'] * row['neighbours'] / row['lanes/particle']:.0f}"]


def executed_rows(results):
    for isa, result in results.items():
        for name, executed in result["executed"].items():
            title, size = name.rsplit("/", 1)
            row, loop = result["rows"][name], result["loops"].get(title)
            if loop is not None:
                turns = row["lanes/particle"] / LANES[isa]
                yield [isa, title, size, f"{executed:.0f}", f"{turns * loop['instructions']:.0f}"]


def page(results, facts, command):
    sets = list(results)
    heads = [f"{isa}: {what}" for isa in sets for what in ("ns a particle", "M pairs/s")]
    sweep_head = ["sweep", "particles", "neighbours", "lanes a particle", "useful", "bytes a particle", *heads, f"{sets[0]}: GB/s"]
    peaks = [[isa, f"{r['peak/multiply-add']['flop/s'] / 1e9:.0f}",
              *(f"{row['bytes_per_second'] / 1e9:.0f}" for name, row in r.items() if name.startswith("peak/read"))]
             for isa, r in ((isa, results[isa]["rows"]) for isa in sets)]
    sizes = [f"read {size_of(name) >> 10} KiB, GB/s" for name in results[sets[0]]["rows"] if name.startswith("peak/read")]
    loops = [[isa, name, *(str(n) for n in counts.values())]
             for isa in sets for name, counts in sorted(results[isa]["loops"].items())]
    counted = next(iter(results[sets[0]]["loops"].values()), {})
    return f"""# Passes and sweeps by themselves, {facts['date']}

Machine: {facts['machine']}; load {facts['load']:.1f} at the start. Commit {facts['commit']}. Command:

    {command}

One thread; CPU times, the least of three repetitions. A jittered lattice, periodic, h = 1.5 dp, half sediment and half water over a
wall; list skin 10 %. A pair is useful if both are within the kernel's support; the other lanes are those of the skin, of the three
other particles of a cluster, and padding. Bytes are those that have to come from memory or go there if nothing stays in a cache.

## Sweeps in space

{table(sweep_head, list(sweep_rows(results, sets, '3-D')))}

## Sweeps in the plane

{table(sweep_head, list(sweep_rows(results, sets, '2-D')))}

## Passes, ns a particle

{table(["", "pass", "particles", *sets, "bytes a particle", f"{sets[0]}: GB/s"], list(pass_rows(results, sets)))}

## What the machine can do

{table(["", "multiply-add, GF/s", *sizes], peaks)}

The largest scene in space beside its floors. Multiplications: those of the loop, every lane, at the rate of the row above, two
operations each. Memory: the bytes at the rate of the largest read. The last column is what the measured time would be if every lane
were useful.

{table(["", "sweep", "instructions a particle", "multiplications, ns", "memory, ns", "measured, ns", "its useful share, ns"],
       list(floor_rows(results, sets)))}

## Instructions carried out, a particle

Callgrind's count of whole sweeps beside that of the inner loop: the rest is what a cluster and a particle cost once.

{table(["", "sweep", "particles a side", "sweep", "inner loop"], list(executed_rows(results)))}

## Inner loops, instructions for as many pairs as a register holds (16, 8, 4)

{table(["", "sweep", *counted], loops)}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="build folder with bench/thalweg_micro_*")
    parser.add_argument("--records", type=pathlib.Path, default=RECORDS, help="where the record goes (default: bench/records)")
    parser.add_argument("--filter", default=".", help="only benchmarks with such names (a regular expression)")
    arguments = parser.parse_args()

    facts = {"date": datetime.date.today().isoformat(), "commit": origin.commit(), "machine": origin.machine(),
             "load": origin.load()}
    has = set(origin.processor("flags").split())
    results = {}
    for isa, needs in NEEDS.items():
        program = arguments.build / "bench" / f"thalweg_micro_{isa}"
        if program.exists() and needs <= has:
            rows = run(program, 3, 0.05, arguments.filter)
            smallest = [name for name in rows if name.startswith("3-D/") and name.endswith("/12") and "pairs/s" in rows[name]]
            counted = shutil.which("valgrind") is not None and isa == "avx2"
            results[isa] = {"rows": rows, "loops": count_instructions(program),
                            "executed": count_executed(program, smallest) if counted else {}}
    if not results:
        parser.error(f"no thalweg_micro_* in {arguments.build}/bench that runs here; build them first")

    arguments.records.mkdir(parents=True, exist_ok=True)
    plain = json.dumps({"facts": facts, "results": results}, indent=1)
    (arguments.records / "micro.json").write_text(plain + "\n", encoding="utf-8")
    (arguments.records / "micro.md").write_text(page(results, facts, origin.command_line("micro/micro.py")), encoding="utf-8")
    print(f"written: micro.json and micro.md in {arguments.records}")


if __name__ == "__main__":
    main()
