#!/usr/bin/env python3
"""Makes docs/stability.md of the last run of the stability suite: results_page.py SUITE.toml RESULTS_FOLDER PAGE.md"""

import pathlib
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench"))

from study.origin import commit  # noqa: E402
from thalweg.tables import markdown, text_rows  # noqa: E402

HEAD = """# Stability: the tests of the suite and their results

The target `stability-page` writes this page from the tables that the tests of `cases/stability/suite.toml` produce.
`cases/stability/README.md` explains scenes and measures. Commit COMMIT. CPU seconds are those of one core of the machine that
ran the suite.

    cmake --build build/release --target stability-page

"""
COMMON = ["energy_gain", "steps", "speed", "compression"]
NOTHING = ["water_mass", "sediment_mass", "excluded", "not_finite"]
COLUMNS = ["case", "what it tests", "particles", "steps", "CPU s", "mass, leak, NaN", "energy gain [dp]",
           "steps / acoustic", "speed / fall", "compression", "further", "verdict"]


def results_of(folder, name):
    """The rows of a case by measure; empty if it was not run, or stopped when it should not."""
    file = folder / f"{name}.csv"
    if not file.exists():
        return {}
    return {row["measure"]: {heading.split(" [")[0]: text for heading, text in row.items()} for row in text_rows(file)}


def shown(row, with_bound):
    text = row["value"] if row["measure"] != "diagnosis" else f"stops: {row['bound']}"
    if with_bound and row["measure"] != "diagnosis":
        text = f"{row['measure'].replace('_', ' ')} {text} {row['unit']} ({row['bound']})"
    return text if row["holds"] == "yes" else f"**{text}**"


def line_of(case, rows):
    first = next(iter(rows.values()), None)
    if first is None:
        return [case["name"], case["tries"]] + ["–"] * 9 + ["**no result**"]
    exact = [rows[name] for name in NOTHING if name in rows]
    further = [row for name, row in rows.items() if name not in COMMON + NOTHING]
    own = case.get("bounds", {})
    return [case["name"].replace("_", " "), case["tries"], first["particles"], first["steps"], first["cpu"],
            "none" if all(row["holds"] == "yes" for row in exact) else
            "; ".join(shown(row, True) for row in exact if row["holds"] != "yes"),
            *(shown(rows[name], name in own) if name in rows else "–" for name in COMMON),
            "; ".join(shown(row, True) for row in further),
            "holds" if all(row["holds"] == "yes" for row in rows.values()) else "**fails**"]


def table(lines):
    return markdown(COLUMNS, ([str(cell).replace("|", "\\|") for cell in cells] for cells in lines))


def main(suite_file, results, page):
    suite = tomllib.loads(pathlib.Path(suite_file).read_text(encoding="utf-8"))
    lines = [line_of(case, results_of(pathlib.Path(results), case["name"])) for case in suite["case"]]
    bounds = suite["every_run"]
    text = HEAD.replace("COMMIT", commit()) + "\n".join(table(lines))
    text += "\n\nBounds of every case that must run to its end, unless its cell gives another bound:\n\n"
    for name, bound in bounds.items():
        text += f"- {name.replace('_', ' ')} ≤ {bound['at_most']:g}: {bound['why']}.\n"
    text += "\nFurther bounds:\n\n"
    for case in suite["case"]:
        for name, bound in case.get("bounds", {}).items():
            text += f"- {case['name'].replace('_', ' ')}, {name.replace('_', ' ')}: {bound['why']}.\n"
    pathlib.Path(page).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
