"""The record of a measurement: its tables with machine, commit and command, in bench/records."""

import datetime
import json
import pathlib

from study.origin import ROOT, commit, load, machine
from study.repeats import shown
from thalweg.tables import markdown

RECORDS = ROOT / "bench" / "records"


class Record:
    """The tables of one measurement, written as NAME.json and NAME.md; a later run overwrites them."""

    def __init__(self, name, title, command):
        self.name = name
        self.content = {"title": title, "date": datetime.date.today().isoformat(), "commit": commit(),
                        "command": command, "machine": machine(), "load": load(), "parts": [], "figures": []}

    def note(self, text):
        self.content["parts"].append({"note": text})

    def table(self, caption, columns, rows):
        """Rows of numbers and texts, in the order of the columns."""
        self.content["parts"].append({"caption": caption, "columns": columns, "rows": rows})

    def figure(self, what, figure):
        """A line of the table in docs/performance.md (summary.py)."""
        self.content["figures"].append([what, figure])

    def text(self):
        c = self.content
        lines = [f"# {c['title']}, {c['date']}", "",
                 f"Machine: {c['machine']}; load {c['load']:.1f} when it began (a run of this measurement adds its own). "
                 f"Commit {c['commit']}.", "", f"    {c['command']}"]
        for part in c["parts"]:
            lines += ["", part.get("note") or part["caption"]]
            if "note" in part:
                continue
            lines += ["", *markdown(part["columns"], [[shown(cell) for cell in row] for row in part["rows"]])]
        return "\n".join(lines) + "\n"

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        plain = json.dumps(self.content, indent=1, default=lambda spread: vars(spread))
        (folder / f"{self.name}.json").write_text(plain + "\n", encoding="utf-8")
        (folder / f"{self.name}.md").write_text(self.text(), encoding="utf-8")
        print(self.text())


def common_arguments(parser, repeats):
    parser.add_argument("thalweg", type=lambda text: pathlib.Path(text).resolve(),
                        help="the program, for example build/release/bin/thalweg")
    parser.add_argument("--repeats", type=int, default=repeats, help="of every run (default: %(default)s)")
    parser.add_argument("--records", type=pathlib.Path, default=RECORDS,
                        help="where NAME.md and NAME.json go (default: bench/records)")
