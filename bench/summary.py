#!/usr/bin/env python3
"""Writes the figures of the newest measurements into the table of docs/performance.md: summary.py [--check]

The table stands between two marks in that file. With --check nothing is written; it fails if the table would change.
"""

import json
import re
import sys

from measure import ROOT

PAGE = ROOT / "docs" / "performance.md"
FIRST, LAST = "<!-- written by bench/summary.py -->", "<!-- end -->"
DATED = re.compile(r"\d{4}-\d\d-\d\d-(.*)\.json")


def newest():
    """The newest page of each measurement, by name."""
    pages = {}
    for file in sorted((ROOT / "bench" / "results").glob("*.json")):
        found = DATED.fullmatch(file.name)
        content = json.loads(file.read_text(encoding="utf-8"))
        if found and isinstance(content, dict) and content.get("figures"):
            pages[found.group(1)] = (file.with_suffix(".md").name, content)
    return pages


def table():
    lines = ["| what | figure | where |", "|---|---|---|"]
    for _, (page, content) in sorted(newest().items()):
        lines += [f"| {what} | {figure} | {page} |" for what, figure in content["figures"]]
    return "\n".join([FIRST, *lines, LAST])


def main():
    text = PAGE.read_text(encoding="utf-8")
    first, last = text.index(FIRST), text.index(LAST) + len(LAST)
    new = text[:first] + table() + text[last:]
    if "--check" in sys.argv:
        sys.exit("docs/performance.md: its table is not that of bench/results; run bench/summary.py" if new != text else 0)
    PAGE.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
