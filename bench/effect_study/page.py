"""The picture and the page of an effect study."""

import math
from dataclasses import dataclass

from study import pictures
from thalweg.tables import markdown

CURVES = ("free_surface", "bed", "moving_bed")


@dataclass
class Results:
    """The results of a study: rows as in its CSV tables, lengths in m."""
    times: list         # [s]
    effects: list       # a row a choice
    convergence: list   # a row a spacing, the finest last
    rms: dict           # of equal runs, by (curve, time)
    extents: dict       # of front, scour and ridge of equal runs, by (name, time)

    def scatter(self, curve):
        """Root mean square over the times [mm]."""
        return 1e3 * math.sqrt(sum(self.rms[curve, time] ** 2 for time in self.times) / len(self.times))


def mean_over_times(row, curve, times):
    """Root mean square over the times [mm], of a row with one column a time."""
    values = [float(row[f"{curve} {time:g} s [m]"]) for time in times if row[f"{curve} {time:g} s [m]"]]
    return 1e3 * math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def draw(results, picture):
    """The picture: bars of what each choice does, the scatter as a line; convergence beside it."""
    times, effect_rows, convergence_rows = results.times, results.effects, results.convergence
    scatter = results.scatter("bed")
    bars = "\n".join(f'"{row["group"]}: {row["choice"]}" {mean_over_times(row, "bed", times):.3f} '
                     f'{mean_over_times(row, "free_surface", times):.3f}' for row in reversed(effect_rows))
    points = "\n".join(f'{row["spacing"].split()[0]} {mean_over_times(row, "bed", times):.3f} '
                       f'{mean_over_times(row, "free_surface", times):.3f} {row[f"front {times[-1]:g} s [m]"]} '
                       f'{1e3 * float(row[f"scour {times[-1]:g} s [m]"]):.2f}' for row in convergence_rows)
    script = f"""
$effects << END
{bars}
END
$spacings << END
{points}
END
set multiplot
set origin 0,0.4
set size 1,0.6
set lmargin at screen 0.42
set title "What each choice changes, root mean square over the profile and {len(times)} times"
set xlabel "mm"
set yrange [-0.5:{len(effect_rows)}-0.5]
set ytics nomirror
set xrange [0:*]
set key at graph 0.98,0.62
set arrow 1 from first {scatter:.3f},graph 0 to first {scatter:.3f},graph 1 nohead front dt 2 lw 2
plot $effects using 2:0:(0):2:($0-0.35):($0) with boxxyerror fs solid 0.8 lc rgb "#8c6239" title "bed", \\
     $effects using 3:0:(0):3:($0):($0+0.35):ytic(1) with boxxyerror fs solid 0.8 lc rgb "#2b6cb0" \\
       title "free surface", \\
     1/0 with lines dt 2 lw 2 lc rgb "black" title "bed of equal runs"
unset arrow 1
unset lmargin
set yrange [0:*]
set ytics auto
set xrange [0:{1.1 * max(float(row["spacing"].split()[0]) for row in convergence_rows):g}]
set xlabel "spacing [mm]"
set key default
set key bottom right
set origin 0,0
set size 0.5,0.4
set title "Distance from the finest run [mm]"
plot $spacings using 1:2 with linespoints pt 7 lc rgb "#8c6239" title "bed", \\
     $spacings using 1:3 with linespoints pt 7 lc rgb "#2b6cb0" title "free surface"
set origin 0.5,0
set title "Front [m] and scour [cm] at {times[-1]:g} s"
plot $spacings using 1:4 with linespoints pt 7 lc rgb "#2b6cb0" title "front", \\
     $spacings using 1:($5/10) with linespoints pt 7 lc rgb "#8c6239" title "scour"
unset multiplot
"""
    pictures.draw(script, picture, 1000, 520 + 26 * len(effect_rows))


def series_of(row, name, times, factor, digits):
    return " ".join(f"{factor * float(row[f'{name} {time:g} s [m]']):.{digits}f}"
                    if row[f"{name} {time:g} s [m]"] else "–" for time in times)


def ratio(distance, scatter):
    return f"{distance / scatter:.1f}" if scatter > 0 and not math.isnan(distance) else "–"


def scatter_table(results):
    rows = [[f"{curve.replace('_', ' ')} [mm]", *(f"{1e3 * results.rms[curve, t]:.2f}" for t in results.times)]
            for curve in CURVES]
    rows += [[f"{name} [mm]", *(f"{1e3 * results.extents[name, t]:.1f}" for t in results.times)]
             for name in ("front", "scour", "ridge")]
    return markdown(["", *(f"{time:g} s" for time in results.times)], rows)


def effect_table(results, base, when):
    times = results.times
    columns = ["choice", f"free surface [mm] at {when} s", "bed [mm]", "moving bed [mm]", "bed / scatter", "front [m]",
               "scour [mm]", "ridge [mm]", "CPU s", "iterations a step"]
    rows = [[": ".join(filter(None, (row["group"], row["choice"]))),
             *(series_of(row, curve, times, 1e3, 1) for curve in CURVES),
             ratio(mean_over_times(row, "bed", times), results.scatter("bed")), series_of(row, "front", times, 1, 3),
             series_of(row, "scour", times, 1e3, 0), series_of(row, "ridge", times, 1e3, 0), row["cpu [s]"],
             row["viscous iterations a step [-]"]] for row in [base, *results.effects]]
    return markdown(columns, rows)


def convergence_table(results, when):
    times = results.times
    columns = ["spacing", f"free surface [mm] at {when} s", "bed [mm]", "front [m]", "scour [mm]", "steps", "CPU s"]
    rows = [[row["spacing"], series_of(row, "free_surface", times, 1e3, 1), series_of(row, "bed", times, 1e3, 1),
             series_of(row, "front", times, 1, 3), series_of(row, "scour", times, 1e3, 0), row["steps [-]"],
             row["cpu [s]"]] for row in results.convergence]
    return markdown(columns, rows)


def page(results, base, scene, equal, commit):
    """The page of documentation: tables and picture, and how they were made."""
    when = ", ".join(f"{time:g}" for time in results.times)
    return "\n".join([
        "# What each choice changes", "",
        f"The case {scene} is run with one choice changed at a time.",
        f"Distances are root mean squares between profiles at t = {when} s, in mm.",
        f"`bench/effect_study/effect_study.py` wrote this page at commit {commit}; `study.toml` beside it lists the runs.",
        "An effect smaller than the scatter is no effect. An effect smaller than the distance to the finest run may come from",
        "the spacing.", "",
        "![Effects and convergence](images/effects.svg)", "",
        "## What equal runs differ by", "",
        f"{equal}: root mean square over all pairs,",
        "and the range from the smallest to the largest front, scour and ridge.", "",
        *scatter_table(results), "",
        "## Effects", "",
        "Bed / scatter: root mean square of the bed over all times, divided by that of equal runs; 1 means no effect.", "",
        *effect_table(results, base, when), "",
        "## Convergence in the spacing", "",
        f"Distances from the run at {results.convergence[-1]['spacing']}.", "",
        *convergence_table(results, when), ""])
