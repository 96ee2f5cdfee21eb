#!/usr/bin/env python3
"""Writes the figures of all records into the table of docs/performance.md: summary.py [--check]

The table stands between two marks in that file. With --check nothing is written; it fails if the table would change.
"""

import json
import sys

from study.origin import ROOT
from study.record import RECORDS

PAGE = ROOT / "docs" / "performance.md"
FIRST, LAST = "<!-- written by bench/summary.py -->", "<!-- end -->"


def records():
    """The content of each record with figures, by name."""
    contents = {file.stem: json.loads(file.read_text(encoding="utf-8")) for file in sorted(RECORDS.glob("*.json"))}
    return {name: content for name, content in contents.items() if content.get("figures")}


def table():
    lines = ["| what | figure | where |", "|---|---|---|"]
    found = records()
    for name in sorted(found, key=lambda name: (name == "feature-costs", name)):  # many lines, last
        lines += [f"| {what} | {figure} | records/{name}.md |" for what, figure in found[name]["figures"]]
    return "\n".join([FIRST, *lines, LAST])


def main():
    text = PAGE.read_text(encoding="utf-8")
    first, last = text.index(FIRST), text.index(LAST) + len(LAST)
    new = text[:first] + table() + text[last:]
    if "--check" in sys.argv:
        sys.exit("docs/performance.md: its table is not that of bench/records; run bench/summary.py" if new != text else 0)
    PAGE.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
