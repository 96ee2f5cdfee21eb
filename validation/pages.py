"""The tables of a validation: validation.csv, validation.json and validation.md."""

import json
import os
import pathlib
import re
import subprocess
import sys
from dataclasses import asdict

from thalweg.tables import markdown, write_table
from validation import outcome

MOST_LISTED = 6  # points
MARKS = {outcome.PASS: "pass", outcome.MISFIT: "**known misfit**", outcome.FAIL: "**FAIL**", outcome.NO_VERDICT: "–"}


def shown(value, digits=3):
    """A number of a table; empty for none."""
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.{digits}g}"


def commit(folder):
    """The commit of the sources in whose tree the case lies, if it lies in one."""
    described = subprocess.run(["git", "-C", folder, "describe", "--always", "--dirty=, with changes"], capture_output=True, text=True,
                               check=False)
    return described.stdout.strip() or "unknown"


def command_line(ignored=("--resume", "--force", "--add")):
    """The command that started this run, without folders of the machine."""
    words, skipped = [], False
    for word in sys.argv[1:]:
        if skipped or word in ignored:
            skipped = False
            continue
        if word in ("--out", "-o", "--page", "--jobs"):
            skipped = True
            continue
        if word.startswith(("--out=", "--page=", "--jobs=")):
            continue
        words.append(pathlib.Path(word).name if word.startswith("/") else f"'{word}'" if re.search(r"[^\w./=:,-]", word) else word)
    return " ".join(["thalweg", pathlib.Path(sys.argv[0]).name.removeprefix("thalweg-"), *words])


def origin(thalweg, folder):
    """Lines that say which program made the figures."""
    version = subprocess.run([thalweg, "--version"], capture_output=True, text=True, check=False).stdout.partition("\n")[0]
    return {"program": version, "commit": commit(folder), "command": command_line()}


def line(row):
    """The row in one line, for the terminal."""
    given = row.entry.given
    limit = f", limit {shown(given['limit'])}" if "limit" in given else ""
    value = "" if row.computed is None else f" {shown(row.computed, 4)} {given['unit']}"
    known = "" if row.reference is None else f" (known {shown(row.reference, 4)})"
    error = "" if row.error is None else f", {given.get('error', 'largest')} error {shown(row.error)}{limit}"
    note = f": {row.note}" if row.note else ""
    return f"{row.case}: {row.entry.title}, {row.plan.name}:{value}{known}{error}: {row.verdict}{note}"


def record(row):
    """Everything about a row as plain values, in the order of the table's columns."""
    given, found = row.entry.given, row.found
    facts = {} if row.run.failure else row.run.facts()
    return {
        "case": row.case, "quantity": row.entry.name, "title": row.entry.title, "run": row.plan.name, "variant": row.plan.variant,
        "spacing [m]": facts.get("spacing", ""), "particles [-]": facts.get("particles", ""), "cpu [s]": facts.get("cpu_seconds", ""),
        "unit": given["unit"], "points [-]": found.points,
        "computed": shown(row.computed, 6), "known": shown(row.reference, 6),
        "rmse": shown(found.rmse, 6), "normalised_rmse [-]": shown(found.normalised_rmse, 6), "bias": shown(found.bias, 6),
        "largest_error": shown(found.largest, 6), "largest_error_at": shown(found.largest_at, 6),
        "brier_skill [-]": shown(found.brier_skill, 6),
        "judged_by": given.get("error", "largest"), "relative_to": shown(given.get("relative_to", "")), "judged_error": shown(row.error, 6),
        "limit": shown(given.get("limit"), 6), "uncertainty": shown(given.get("uncertainty"), 6), "scatter": shown(row.scatter, 6),
        "scatter_runs [-]": row.equal_runs, "order [-]": shown(row.order), "order_note": row.order_note,
        "verdict": row.verdict, "note": row.note, "reason": given["reason"]}


def cell(text):
    return str(text).replace("|", "\\|")


def runs_table(planned, base):
    rows = []
    for plan, run, repeats in planned:
        facts = {} if run.failure else run.facts()
        settings = ", ".join(plan.set) or "as the case stands"
        cost = sum(float(member.facts()["cpu_seconds"]) for member in (run, *repeats) if not member.failure)
        link = [f"[report]({os.path.relpath(run.folder / 'report/index.html', base)})" if not run.failure else ""] if base else []
        rows.append([plan.name, cell(f"`{settings}`" if plan.set else settings), shown(1e3 * float(facts["spacing"])) if facts else "",
                     facts.get("particles", ""), f"{cost:.1f}" if facts else "failed", 1 + len(repeats), *link])
    return markdown(["run", "keys changed", "spacing [mm]", "particles", "CPU s, with repeats", "runs", *(["report"] if base else [])], rows)


def judged_words(row):
    """The kind of error that is judged, and what it is divided by."""
    given = row.entry.given
    over = {"reference": "of the known", "range": "of the range", "rms": "of the rms", "spacing": "spacings"}
    scale = given.get("relative_to")
    size = given["unit"] if scale is None else over.get(scale, f"of {shown(scale)} {given['unit']}")
    return f"{given.get('error', 'largest')}, {size}"


def listed(points, text):
    """The values of a few points in a cell; of many none, which are in validation.json."""
    return ", ".join(map(text, points)) if len(points) <= MOST_LISTED else ""


def known(point):
    """What is known at a point: a number, or a range."""
    if point.low is None:
        return ""
    return shown(point.low, 4) if point.low == point.high else f"{shown(point.low, 4)}–{shown(point.high, 4)}"


def figures_table(rows):
    """The table of a case; a column that is empty in all rows is left out."""
    columns = ["quantity", "run", "unit", "computed", "known", "points", "RMSE", "RMSE / range", "bias", "largest error", "at", "Brier skill",
               "judged error", "judged by", "limit", "data uncertainty", "scatter (runs)", "order", "verdict"]
    table = []
    for row in rows:
        found, given = row.found, row.entry.given
        order = "" if row.order is None else f"{row.order:.1f}" + (f" ({row.order_note})" if row.order_note else "")
        scatter = "" if row.scatter is None else f"{shown(row.scatter, 2)} ({row.equal_runs})"
        table.append([cell(row.entry.title), row.plan.name, given["unit"], listed(row.points, lambda point: shown(point.computed, 4)),
                      listed(row.points, known), found.points or "", *map(shown, (found.rmse, found.normalised_rmse, found.bias, found.largest,
                      found.largest_at, found.brier_skill, row.error)), judged_words(row) if row.error is not None else "",
                      shown(given.get("limit")), shown(given.get("uncertainty")), scatter, order, MARKS[row.verdict]])
    kept = [n for n in range(len(columns)) if any(entries[n] != "" for entries in table)]
    return markdown([columns[n] for n in kept], [[entries[n] for n in kept] for entries in table])


def notes(rows):
    """What does not fit and why, and the reason of every limit."""
    lines, said = [], set()
    for row in rows:
        if row.verdict in (outcome.MISFIT, outcome.FAIL):
            lines.append(f"- **{row.verdict}**, {row.entry.title}, {row.plan.name}: {shown(row.error)} "
                         f"(limit {shown(row.entry.given.get('limit'))}). {row.note}")
        elif row.note and row.verdict == outcome.PASS:
            lines.append(f"- {row.entry.title}, {row.plan.name}: {row.note}")
    for row in rows:
        if row.entry.name not in said:
            said.add(row.entry.name)
            data = f" Data: {row.entry.given['uncertainty_of']}." if "uncertainty_of" in row.entry.given else ""
            lines.append(f"- {row.entry.title}: {row.entry.given['reason']}.{data}")
    return lines


def command_of(made, expected):
    """The command that makes the section of a case alone."""
    options = [word for word in made["command"].split()[2:] if word in ("--full", "--no-repeats")]
    return " ".join(["thalweg validate", *options, f"{expected.case.resolve().parent.name}/{expected.name}"])


def section(expected, found, rows, made, base):
    """The part of the page on a case; `base` is the folder from which links count, None for a page without links."""
    count = {verdict: sum(row.verdict == verdict for row in rows) for verdict in MARKS}
    cpu = sum(float(member.facts()["cpu_seconds"]) for _, run, repeats in found for member in (run, *repeats) if not member.failure)
    return "\n".join([
        f"## {expected.name}", "",
        f"{len(rows)} figures: {count[outcome.PASS]} pass, {count[outcome.MISFIT]} known misfits, {count[outcome.FAIL]} fail, "
        f"{count[outcome.NO_VERDICT]} without a verdict. `{command_of(made, expected)}`, program {made['program']}, commit {made['commit']}, "
        f"{cpu:.0f} s of processor time in the solver.", "", *runs_table(found, base), "", *figures_table(rows), "", *notes(rows)]) + "\n"


COUNTS = re.compile(r"^(\d+) figures: (\d+) pass, (\d+) known misfits, (\d+) fail, (\d+) without a verdict\. .*, (\d+) s of processor time", re.M)


def sections_of(text):
    """The sections of a page, by the name of the case."""
    parts = re.split(r"^(?=## )", text, flags=re.M)[1:]
    return {part.partition("\n")[0].removeprefix("## "): part.rstrip("\n") + "\n" for part in parts if COUNTS.search(part)}


def page(sections):
    """The page of sections, by the name of the case."""
    figures, passed, misfits, fails, unknown, cpu = (sum(map(int, column)) for column in zip(*(
        COUNTS.search(part).groups() for part in sections.values())))
    head = ["# Validation", "",
            f"Made by `thalweg validate`, one thread a run, {cpu} s of processor time in the solver. Every section says by which command, "
            "program and commit.",
            f"**{figures} figures: {passed} pass, {misfits} known misfits, {fails} fail, {unknown} without a verdict** because nothing is "
            "known to hold them against.", "",
            "Errors are computed less known, 0 inside a known range. RMSE, bias and largest error have the quantity's unit; the judged error, "
            "limit, data uncertainty and scatter have the unit in \"judged by\". Scatter: extent of the judged error over runs whose Courant "
            "numbers differ by some ten-thousandths; without a known value, extent of the computed value. Order: slope of log error over log "
            "spacing within a variant. `expected.toml` of each case holds limits and reasons (docs/expected.md)."]
    return "\n".join(head) + "\n\n" + "\n".join(sections.values())


def write(out, planned, rows, made, copy=None, add=False):
    """Writes the tables into the folder `out`, and the page also to `copy` if that is given; with `add` the sections of other cases that
    `copy` holds stay."""
    out.mkdir(parents=True, exist_ok=True)
    comment = f"made by: {made['command']}, program {made['program']}, commit {made['commit']}"
    records = [record(row) for row in rows]
    write_table(out / "validation.csv", records, comment)
    plain = [{**entry, "errors": asdict(row.found), "points": [asdict(point) for point in row.points[:1000]],
                       "report": os.path.relpath(row.run.folder / "report/index.html", out)} for entry, row in zip(records, rows)]
    (out / "validation.json").write_text(json.dumps({**made, "figures": plain}, indent=1) + "\n", encoding="utf-8")

    def sections(base):
        return {expected.name: section(expected, found, [row for row in rows if row.case == expected.name], made, base)
                for expected, found in planned}

    (out / "validation.md").write_text(page(sections(out)), encoding="utf-8")
    if copy:
        copy.parent.mkdir(parents=True, exist_ok=True)
        there = sections_of(copy.read_text(encoding="utf-8")) if add and copy.exists() else {}
        copy.write_text(page(there | sections(None)), encoding="utf-8")
