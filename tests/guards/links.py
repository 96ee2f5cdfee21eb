#!/usr/bin/env python3
"""Checks that the links of the documents lead somewhere: links.py ROOT

Relative links of every tracked .md file: the file or folder is there, and a heading has the name behind #. Links to the web are not tried.
"""

import pathlib
import re
import sys

from source_tree import report, tracked_files

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.+?)\s*$", re.MULTILINE)
FENCE = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)


def anchors(text):
    """The names of headings as web pages of repositories make them."""
    found = set()
    for heading in HEADING.findall(FENCE.sub("", text)):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        found.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return found


def check_page(root, name, text):
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("    "):
            continue  # a block of code
        for link in LINK.findall(line):
            if re.match(r"[a-z]+:", link):
                continue
            place, _, anchor = link.partition("#")
            target = (root / name).parent / place if place else root / name
            if not target.exists():
                yield f"{name}:{number}: the link {link} leads nowhere; correct it"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text(encoding="utf-8")):
                yield f"{name}:{number}: {place or name} has no heading {anchor}; correct the link"


def check(root):
    violations, checked = [], 0
    for path, _ in tracked_files(root):
        if path.suffix == ".md":
            checked += 1
            violations += check_page(pathlib.Path(root), path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
    return violations, checked


if __name__ == "__main__":
    sys.exit(report(*check(pathlib.Path(sys.argv[1]))))
