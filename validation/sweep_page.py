"""What a sweep writes: sweep.csv, sweep.md, and a picture for each measure."""

import os
import re
import sys

from study.pictures import draw
from thalweg.tables import markdown, write_table
from validation.convergence import convergence
from validation.pages import cell, shown

SPACING = "numerics.spacing"
COLOURS = ("#2b6cb0", "#8c6239", "#2f855a", "#b83280", "#c05621", "#4a5568")


def rows(variations, found):
    """A row for each run: values, its number among equal runs, state, every quantity that any run has."""
    headings = {}
    for member in found:
        headings |= {name: unit for name, (_, unit) in {**member.found, **member.measured}.items()}
    table = []
    for member in found:
        have = {**member.found, **member.measured}
        table.append({variation.heading: f"{value.number:g}" if variation.numeric else value.text
                      for variation, value in zip(variations, member.values)} |
                     {"equal run": member.equal, "state": "failed" if member.run.failure else "finished"} |
                     {f"{name} [{unit}]": shown(have.get(name, (None, ""))[0], 8) for name, unit in headings.items()} |
                     {"note": member.run.failure})
    return table


def groups(found):
    """Combination → its finished members, in the order of the sweep."""
    together = {}
    for member in found:
        together.setdefault(tuple(value.text for value in member.values), []).append(member)
    return {key: [member for member in members if not member.run.failure] for key, members in together.items()}


def statistics(members, name):
    """Mean, least, most and number of a measure over equal runs; None without any."""
    values = [member.measured[name][0] for member in members if member.measured.get(name, (None,))[0] is not None]
    return (sum(values) / len(values), min(values), max(values), len(values)) if values else None


def combinations_table(variations, found, names):
    columns = [variation.heading for variation in variations] + [f"{name} [{unit_of(found, name)}]" for name in names] + ["CPU s", "runs"]
    table = []
    for key, members in groups(found).items():
        cost = [member.found["cpu_seconds"][0] for member in members]
        values = [statistics(members, name) for name in names]
        table.append([*(text.split()[0] if variation.numeric else text for text, variation in zip(key, variations)),
                      *("" if found_one is None else words(found_one) for found_one in values),
                      f"{sum(cost) / len(cost):.1f}" if cost else "failed", len(members)])
    return markdown(columns, table)


def words(found):
    mean, least, most, number = found
    return shown(mean, 4) + (f" ({shown(least, 4)} to {shown(most, 4)})" if number > 1 else "")


def unit_of(found, name):
    return next((member.measured[name][1] for member in found if name in member.measured), "-")


def convergences(variations, found, name):
    """(other values, Convergence, spacings) of each combination of the other keys, if three spacings are there."""
    at = next((n for n, variation in enumerate(variations) if variation.key == SPACING), None)
    if at is None:
        return []
    together = {}
    for members in groups(found).values():
        measured = statistics(members, name)
        if measured:
            first = members[0]
            others = tuple(f"{variation.key} {value.text}" for n, (variation, value) in enumerate(zip(variations, first.values)) if n != at)
            together.setdefault(others, []).append((first.found["spacing"][0], measured))
    return [(others, convergence([spacing for spacing, _ in points], [mean for _, (mean, *_) in points],
                                 max(most - least for _, (_, least, most, _) in points)), sorted(spacing for spacing, _ in points)[:3])
            for others, points in together.items() if len({spacing for spacing, _ in points}) >= 3]


def convergence_lines(variations, found, names):
    table = []
    for name in names:
        for others, result, spacings in convergences(variations, found, name):
            table.append([name, ", ".join(others) or "–", ", ".join(f"{1e3 * spacing:g}" for spacing in spacings),
                          shown(result.order, 2), shown(result.extrapolated, 4), "" if result.band is None else f"± {shown(result.band, 2)}",
                          result.note])
    if not table:
        return []
    return ["", "## Convergence in the spacing", "",
            "Richardson's order of the three finest spacings, value extrapolated to a spacing of 0, and band: 1.25 times its distance from the "
            "finest value (Roache 1997). No order is given where values do not change monotonically or by no more than equal runs differ.", "",
            *markdown(["measure", "with", "spacings [mm]", "order", "extrapolated", "band", "note"], table)]


def escaped(text):
    return text.replace("\\", "\\\\").replace('"', "'")


def picture(out, variations, found, name):
    """Draws the measure against the first key, a curve for each combination of the others; bars: from least to most of equal runs."""
    first, blocks, curves = variations[0], [], []
    together = {}
    for members in groups(found).values():
        measured = statistics(members, name)
        if measured:
            together.setdefault(tuple(value.text for value in members[0].values[1:]), []).append((members[0].values[0], measured))
    places = {value.text: place for place, value in enumerate(first.values)}
    for number, (others, points) in enumerate(together.items()):
        lines = [f"{value.number if first.numeric else places[value.text]:.9g} {mean:.9g} {least:.9g} {most:.9g}"
                 for value, (mean, least, most, _) in sorted(points, key=lambda point: point[0].number if first.numeric else places[point[0].text])]
        blocks.append(f"$curve{number} << END\n" + "\n".join(lines) + "\nEND")
        label = ", ".join(f"{variation.key.split('.')[-1]} {text}" for variation, text in zip(variations[1:], others)) or "mean of equal runs"
        colour = COLOURS[number % len(COLOURS)]
        curves.append(f'$curve{number} using 1:2:3:4 with yerrorlines lw 1.5 pt 7 ps 0.7 lc rgb "{colour}" title "{escaped(label)}"')
    if not curves:
        return None
    bands = [f'{result.extrapolated - result.band:.9g} with lines dt 3 lc rgb "{COLOURS[n % len(COLOURS)]}" title "band of its extrapolated value", '
             f'{result.extrapolated + result.band:.9g} with lines dt 3 lc rgb "{COLOURS[n % len(COLOURS)]}" notitle'
             for n, (_, result, _) in enumerate(convergences(variations, found, name)) if result.band is not None and first.key == SPACING]
    tics = "" if first.numeric else "set xtics (" + ", ".join(f'"{escaped(text)}" {place}' for text, place in places.items()) + ")\n"
    edge = "set offsets graph 0.05, graph 0.05, graph 0.08, graph 0.08\nset key outside bottom center horizontal\n"
    axes = f'\nset termoption noenhanced\nset xlabel "{escaped(first.heading)}"\nset ylabel "{escaped(name)} [{unit_of(found, name)}]"\n'
    script = "\n".join(blocks) + axes + tics + edge + "plot " + ", \\\n     ".join(curves + bands) + "\n"
    file = out / (re.sub(r"[^\w.]+", "_", name) + ".svg")
    try:
        draw(script, file, 800, 500)
    except (RuntimeError, OSError) as error:
        print(f"warning: no picture of {name}: {str(error).splitlines()[0]}; gnuplot has to be installed", file=sys.stderr)
        return None
    return file


def write(out, case, variations, found, names, repeats, made):
    """Writes table, pictures and page into the folder `out`."""
    comment = f"made by: {made['command']}, program {made['program']}, commit {made['commit']}"
    write_table(out / "sweep.csv", rows(variations, found), comment)
    cpu = sum(member.found["cpu_seconds"][0] for member in found if member.found)
    lines = [f"# Sweep of {case}", "",
             f"Made by `{made['command']}`, program {made['program']}, commit {made['commit']}; {cpu:.0f} s of processor time in the solver, "
             "one thread a run.", f"{sum(not member.run.failure for member in found)} of {len(found)} runs finished. All quantities of each run: sweep.csv.", ""]
    if repeats > 1:
        lines += ["In parentheses: least and most of equal runs, whose Courant numbers differ by some ten-thousandths. Smaller differences mean "
                  "nothing.", ""]
    lines += ["## Combinations", "", *combinations_table(variations, found, names), *convergence_lines(variations, found, names)]
    for name in names:
        drawn = picture(out, variations, found, name)
        if drawn:
            lines += ["", f"![{name} against {variations[0].key}]({drawn.name})"]
    lines += ["", "## Runs", ""]
    for member in found:
        report = member.run.folder / "report/index.html"
        state = f"failed: {cell(member.run.failure)}" if member.run.failure else f"[report]({os.path.relpath(report, out)})"
        lines.append(f"- {member.run.name}: {state}")
    (out / "sweep.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
