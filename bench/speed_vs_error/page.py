"""The pictures and the page of error against seconds."""

import math
import pathlib

from study import norms, pictures
from thalweg.tables import markdown

DISCUSSION = pathlib.Path(__file__).with_name("discussion.md")
COLOURS = {"spacing": "#c0392b", "product": "#2b6cb0", "one at a time": "#8c6239", "mesh": "#4a4a4a"}
ON_MESH = ("mesh", "finest mesh")  # groups


def metres(spacing):
    number, unit = spacing.split()
    return float(number) * {"mm": 1e-3, "cm": 1e-2, "m": 1.0}[unit]


def measured(rows, problem):
    """Particles: rows of the problem that have an error and took time: (CPU s, error, row)."""
    return [(float(row["cpu [s]"]), float(row["error"]), row) for row in rows
            if row["problem"] == problem["name"] and row["error"] and row["group"] not in ON_MESH]


def on_mesh(rows, problem):
    """The same of the mesh's rows."""
    return [(float(row["cpu [s]"]), float(row["error"]), row) for row in rows
            if row["problem"] == problem["name"] and row["error"] and row["group"] in ON_MESH]


def series(rows, problem):
    """By spacing, the numerics as the case has them: (spacing [m], error, row), coarse to fine."""
    return sorted(((metres(row["spacing"]), error, row) for _, error, row in measured(rows, problem)
                   if row["group"] == "spacing"), key=lambda found: -found[0])


def order_of(rows, problem):
    found = series(rows, problem)
    return norms.order([s for s, _, _ in found], [e for _, e, _ in found]) if len(found) > 1 else None


def base_row(rows, problem, spacing=None):
    spacing = spacing or problem["base"]
    return next(((cpu, error, row) for cpu, error, row in measured(rows, problem)
                 if row["group"] == "spacing" and row["spacing"] == spacing), None)


def tics(values):
    """1, 2 and 5 in each decade that the values reach."""
    decades = range(math.floor(math.log10(min(values))), math.ceil(math.log10(max(values))) + 1)
    return ", ".join(f"{digit * 10.0 ** power:g}" for power in decades for digit in (1, 2, 5))


def draw_problem(problem, rows, out):
    """Error over CPU seconds of all points, the Pareto front as a line, its points numbered as in front_table()."""
    points = measured(rows, problem)
    groups = {}
    for cpu, error, row in points:
        group = row["group"] if row["group"] in ("spacing", "product") else "one at a time"
        groups.setdefault(group, []).append(f"{cpu:g} {error:g}")
    meshes = on_mesh(rows, problem)
    front = norms.pareto_front([(cpu, error) for cpu, error, _ in points])
    blocks = [("front", "\n".join(f"{cpu:g} {error:g} {n}" for n, (cpu, error) in enumerate(front, 1)))]
    blocks += [(group.replace(" ", "_"), "\n".join(lines)) for group, lines in groups.items()]
    plots = ['$front using 1:2 with steps lw 2 lc rgb "black" title "Pareto front"']
    plots += [f'${group.replace(" ", "_")} using 1:2 with points pt 7 ps {0.9 if group == "spacing" else 0.5} '
              f'lc rgb "{COLOURS[group]}" title "{TITLES[group]}"' for group in sorted(groups)]
    if meshes:
        blocks.append(("mesh", "\n".join(f'{cpu:g} {error:g} "{row["changed"]}, {row["spacing"]}"' for cpu, error, row in meshes)))
        title = "OpenFOAM, from its own finest" if "finest" in problem else "OpenFOAM"
        plots.append(f'$mesh using 1:2 with points pt 4 lc rgb "{COLOURS["mesh"]}" title "{title}"')
        plots.append(f'$mesh using 1:2:3 with labels offset 0,0.8 font ",9" tc rgb "{COLOURS["mesh"]}" notitle')
    plots.append('$front using 1:2:3 with labels left offset 0.5,0.6 font ",10" notitle')
    xs = [cpu for cpu, _, _ in points + meshes]
    ys = [error for _, error, _ in points + meshes]
    data = "\n".join(f"${name} << END\n{lines}\nEND" for name, lines in blocks)
    pictures.draw(f"""{data}
set logscale xy
set format y "%g"
set ytics add ({tics(ys)})
set xlabel "CPU seconds of one thread"
set ylabel "error ({problem['measure']}) [{problem['unit']}]"
set title "{problem['title']}"
set key outside below horizontal
set bmargin 8
set grid lc rgb "#dddddd"
set xrange [{min(xs) / 1.4:g}:{max(xs) * 1.4:g}]
set yrange [{min(ys) / 1.4:g}:{max(ys) * 1.4:g}]
set mxtics 10
set format x "%g"
plot {', '.join(plots)}
""", out / f"speed_vs_error_{problem['name']}.svg", 900, 560)


TITLES = {"spacing": "spacing, the case's numerics", "product": "spacing x h/dp x Courant number",
          "one at a time": "one key changed"}


def further(row):
    return row["further"].replace("; ", ", ").replace("=", " ")


def spacing_table(rows, problem):
    table = [[row["spacing"], row["particles [-]"], row["steps [-]"], f"{error:.3g}", further(row), row["cpu [s]"],
              row["particle-steps per CPU s [1/s]"]] for _, error, row in series(rows, problem)]
    return markdown(["spacing", "particles", "steps", f"{problem['measure']} [{problem['unit']}]", "further measures",
                     "CPU s", "particle-steps per CPU s"], table)


def mesh_table(rows, problem):
    """The problem on a mesh."""
    table = []
    for row in rows:
        if row["problem"] != problem["name"] or row["group"] not in ON_MESH:
            continue
        if row["failure"]:
            table.append([row["changed"], row["spacing"], "", "", "failed: " + row["failure"], "", "", ""])
        else:
            error = f"{float(row['error']):.3g}" if row["error"] else "is the finest"
            table.append([row["changed"], row["spacing"], row["particles [-]"], row["steps [-]"], error, further(row),
                          row["cpu [s]"], row["particle-steps per CPU s [1/s]"]])
    return markdown(["model", "cells", "number", "steps", f"{problem['measure']} [{problem['unit']}]", "further measures",
                     "CPU s", "cell-steps per CPU s"], table)


def methods_table(rows, problems):
    """Each mesh point beside the most accurate particles, as the case has them, that take no more seconds."""
    table = []
    for problem in problems:
        for cpu, error, row in on_mesh(rows, problem):
            cheaper = [(e, c, r) for c, e, r in measured(rows, problem) if r["group"] == "spacing" and c <= cpu]
            mesh = [problem["name"], problem["measure"], row["changed"], row["spacing"], f"{error:.3g}", f"{cpu:.3g}"]
            if not cheaper:
                table.append([*mesh, "none is as cheap", "", "", ""])
                continue
            best, seconds, theirs = min(cheaper, key=lambda found: found[0])
            table.append([*mesh, theirs["spacing"], f"{best:.3g}", f"{seconds:.3g}", "particles" if best < error else "mesh"])
    return markdown(["problem", "error", "model", "cells", "error", "CPU s", "particles", "error", "CPU s", "smaller error"], table)


def times(value, reference):
    return f"{value / reference:.2f}" if reference else "–"


def choice_table(rows, problem):
    """One key changed at a time, beside the case as it is at the same spacing."""
    table = []
    for row in rows:
        if row["problem"] != problem["name"] or "." not in row["group"]:
            continue
        base = base_row(rows, problem, row["spacing"])
        if row["failure"]:
            table.append([row["changed"], row["spacing"], "failed: " + row["failure"], "", "", "", "", ""])
        elif base and row["error"]:
            table.append([row["changed"], row["spacing"], f"{float(row['error']):.3g}", times(float(row["error"]), base[1]),
                          further(row), row["cpu [s]"], times(float(row["cpu [s]"]), base[0]),
                          times(float(row["pairs [1e9]"]), float(base[2]["pairs [1e9]"]))])
    return markdown(["changed", "spacing", f"{problem['measure']} [{problem['unit']}]", "times", "further measures", "CPU s",
                     "times", "pairs, times"], table)


def front_table(rows, problem):
    points = measured(rows, problem)
    names = {(cpu, error): row for cpu, error, row in points}
    front = norms.pareto_front([(cpu, error) for cpu, error, _ in points])
    table = [[n, names[found]["spacing"], names[found]["changed"] or "as it is", f"{found[1]:.3g}", f"{found[0]:.3g}"]
             for n, found in enumerate(front, 1)]
    return markdown(["", "spacing", "changed", f"{problem['measure']} [{problem['unit']}]", "CPU s"], table)


def choices(rows):
    return list(dict.fromkeys((row["group"], row["changed"]) for row in rows if "." in row["group"]))


def overview_table(rows, problems):
    """Each change's error and seconds over those of the case as it is."""
    table = []
    for group, changed in choices(rows):
        cells = []
        for problem in problems:
            found = [row for row in rows if (row["problem"], row["group"], row["changed"]) == (problem["name"], group, changed)]
            base = base_row(rows, problem, found[0]["spacing"]) if found else None
            if found and found[0]["failure"]:
                cells.append("failed")
            elif base and found[0]["error"]:
                cells.append(f"{times(float(found[0]['error']), base[1])} / {times(float(found[0]['cpu [s]']), base[0])}")
            else:
                cells.append("")
        table.append([changed, *cells])
    return markdown(["changed", *(problem["name"] for problem in problems)], table)


def accuracy_table(rows, problems):
    """Error and cost of the levels of numerics.accuracy; the case's own numerics are those of "standard"."""
    table = []
    for problem in problems:
        found = [row for row in rows if row["problem"] == problem["name"] and row["group"] == "numerics.accuracy"]
        for spacing in dict.fromkeys(row["spacing"] for row in found):
            levels = {row["changed"].split("=")[-1]: row for row in found if row["spacing"] == spacing}
            table.append(accuracy_row(problem, spacing, base_row(rows, problem, spacing), levels))
    return markdown(["problem", "spacing", "error", "draft", "CPU s", "standard", "CPU s", "fine", "CPU s"], table)


def accuracy_row(problem, spacing, base, levels):
    cells = []
    for level in ("draft", "standard", "fine"):
        row = levels.get(level) if level != "standard" else base and base[2]
        if row is None or row["failure"]:
            cells += [row["failure"] if row else "", ""]
        else:
            cells += [f"{float(row['error']):.3g}", f"{float(row['cpu [s]']):.3g}"]
    return [problem["name"], spacing, f"{problem['measure']} [{problem['unit']}]", *cells]


def verdict(problem, order, error):
    """Compares order and error with what was expected; returns the text for the table."""
    low, high = problem["expected"]["order"]
    missed = []
    if not low <= order <= high:
        missed.append("order " + ("below" if order < low else "above"))
    if error > problem["expected"].get("error", error):
        missed.append("error above")
    return "as expected" if not missed else "missed: " + ", ".join(missed)


def expectation_table(rows, problems):
    table = []
    for problem in problems:
        order, base = order_of(rows, problem), base_row(rows, problem)
        low, high = problem["expected"]["order"]
        expected = [f"{low:g} to {high:g}", problem["expected"].get("error", "–"), problem["expected"]["why"]]
        found = [f"{order:.2f}", f"{base[1]:.3g}", verdict(problem, order, base[1])] if order and base else ["", "", "not run"]
        table.append([problem["name"], f"{problem['measure']} [{problem['unit']}]", problem["base"], *expected, *found])
    return markdown(["problem", "error", "at", "order expected", "error at most", "because", "order", "error", ""], table)


def cost_lines(rows):
    total = sum(float(row["cpu [s]"]) for row in rows if row["cpu [s]"])
    return [f"{len(rows)} runs, {total / 60:.0f} CPU minutes; {sum(1 for row in rows if row['failure'])} failed."]


def summary_lines(problems, rows, made, table):
    """The record: who measured what where, the expectations and the overview."""
    yield from ["# Error against seconds", ""]
    yield from (f"- {line}" for line in made.splitlines())
    yield from ["", *cost_lines(rows), f"Every point: `{table}`. Error / CPU seconds over those of the case as it is:", ""]
    yield from overview_table(rows, problems)
    yield from ["", "Expected before it was run, and found:", ""]
    yield from expectation_table(rows, problems)
    yield ""


def page(problems, rows, made, left_out):
    """The page of documentation: the discussion, then tables and pictures as they were made."""
    machine, commit, command = made.splitlines()
    lines = ["# Speed against error", "", DISCUSSION.read_text(encoding="utf-8").rstrip(), "", "## How it was measured", "",
             f"Machine: {machine}. Programs: {commit}. Command:", "", f"    {command}", "", *cost_lines(rows)]
    if left_out:
        lines.append(f"Left out or not run yet: {'; '.join(left_out)}.")
    lines += ["", "## Expected and found", "",
              "Written down before the matrix was run, after trials of single points (`bench/speed_vs_error/matrix.toml`):", "",
              *expectation_table(rows, problems), "", "## Draft, standard, fine", "",
              "`numerics.accuracy` sets the defaults of other keys (`thalweg explain accuracy`). Error and CPU seconds at one spacing:",
              "", *accuracy_table(rows, problems), "", "## What each choice does", "",
              "Error / CPU seconds, over those of the case as it is at the same spacing. Below 1 is better.", "",
              *overview_table(rows, problems), ""]
    if any(on_mesh(rows, problem) for problem in problems):
        lines += ["## Particles and mesh", "",
                  "Each run of OpenFOAM beside the particles with the smallest error among those that took no more seconds, with the "
                  "numerics as each case has them. Distances \"from the finest\" and of Louvain's bed are from the same method's finest "
                  "run, so that they tell how far a method has converged, not which of both is right.", "",
                  *methods_table(rows, problems), ""]
    for problem in problems:
        lines += [f"## {problem['title']}", "", f"`{problem['case']}`; {problem['meaning']}.", "",
                  f"![Error against seconds](images/speed_vs_error_{problem['name']}.svg)", "", *spacing_table(rows, problem), "",
                  "Pareto front:", "", *front_table(rows, problem), "", "One key changed at a time:", "",
                  *choice_table(rows, problem), ""]
        if any(row["problem"] == problem["name"] and row["group"] in ON_MESH for row in rows):
            lines += ["On a mesh (`thalweg foam`):", "", *mesh_table(rows, problem), ""]
    return "\n".join(lines)
