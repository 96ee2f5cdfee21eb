"""docs/expected.md: the keys of expected.toml and all measures, from their declarations."""

from thalweg.tables import markdown
from validation.expected import ENTRY_KEYS, RUN_KEYS
from validation.keys import documented
from validation.library import MEASURES
from validation.references import KEYS as REFERENCE_KEYS

COLUMNS = ["key", "value", "meaning"]


def reference_page():
    lines = ["# What a case must hold: expected.toml", "",
             "Written by `thalweg validate --measures`. `expected.toml` lies beside `case.toml`. It says which runs are made, what is measured of "
             "them, what is known of it in nature or theory, and how far a run may be from that. Numbers are SI; nothing has a unit "
             "but what `unit` says for the reader.", "",
             "    [[run]]", '    name = "5 mm"', "    set = ['numerics.spacing=\"5 mm\"']", "    repeats = 2", "",
             "    [head]", '    title = "head over the crest"', '    measure = "column"', '    file = "gauges.csv"', '    column = "head.level"',
             '    statistic = "mean"', "    last = 0.5", "    less = 0.2", "    value = 0.0569", '    unit = "m"', '    relative_to = "reference"',
             "    limit = 0.05", '    reason = "…"', "", "## A run", "", *markdown(COLUMNS, documented(RUN_KEYS)), "",
             "Without any `[[run]]` the case runs once as it stands.", "", "## A quantity", "",
             "A table of any name.", "", *markdown(COLUMNS, documented(ENTRY_KEYS)), "",
             "Verdict: **pass** if the judged error is within `limit`; **known misfit** if it is beyond, declared, and within `misfit_limit`; "
             "else **fail**, as for a run that failed. A `known_misfit` is never a pass.", "", "## What is known", "",
             "Keys of the measures that do not know it themselves:", "", *markdown(COLUMNS, documented(REFERENCE_KEYS)), "", "## Measures"]
    for name, found in sorted(MEASURES.items()):
        own = [key for key in found.keys if key not in REFERENCE_KEYS]
        lines += ["", f"### {name}", "", found.meaning + (" What is known: the keys above." if found.has_reference else "")]
        if own:
            lines += ["", *markdown(COLUMNS, documented(own))]
    return "\n".join(lines) + "\n"
