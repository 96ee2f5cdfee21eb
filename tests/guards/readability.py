#!/usr/bin/env python3
"""Checks what a machine can check of readability: readability.py ROOT

A source file has at most 400 lines. A comment does not open with What, Whether, Where or How: such an opening hides the
subject of the sentence.
"""

import pathlib
import re
import sys

from source_tree import report, sources

MOST_LINES = 400
RIDDLE = re.compile(r"^\s*(///|//)\s+(What|Whether|Where|How)\b")


def check(root):
    root = pathlib.Path(root)
    violations, checked = [], 0
    for path in sources(root):
        lines = path.read_text().splitlines()
        name = path.relative_to(root).as_posix()
        checked += 1
        if len(lines) > MOST_LINES:
            violations.append(f"{name}:{MOST_LINES}: has {len(lines)} lines; split it by idea")
        for number, line in enumerate(lines, 1):
            opens_comment = number == 1 or not re.match(r"^\s*(///|//)", lines[number - 2])
            if opens_comment and (match := RIDDLE.match(line)):
                violations.append(f"{name}:{number}: a comment opens with '{match[2]}'; begin with its subject")
    return violations, checked


if __name__ == "__main__":
    sys.exit(report(*check(sys.argv[1])))
