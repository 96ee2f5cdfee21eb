#!/usr/bin/env python3
"""Checks what may stand in a tracked file, and which of them may be executed: tracked_files.py ROOT"""

import pathlib
import re
import sys

from source_tree import report, tracked_files

# What -> the cure. The patterns are split so that this file does not find itself.
FORBIDDEN = {
    r"(?<![\w.~$}])/(?:home|root|Users|work" r"|mnt|tmp/\w+)/\w":
        "a path of one machine; use a relative path or a variable",
    r"https?://(?:[\w-]+\.)*(?:deb\.debian" r"|debian-ports|npmjs|pypi|crates)\.\w+":
        "a package host; name the package instead",
    r"^(?:<{7}|>{7}|={7})(?: |$)": "a merge conflict; resolve it",
    r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b": "unfinished work; do it or write an issue",
    r"[ \t]+$": "space at the end of the line; remove it",
    r"\t": "a tab; indent with spaces",
}
# Foreign text that is kept as it is, inputs as fuzzing found them, and formats in which a tab or a line's last space carries meaning.
VERBATIM = re.compile(r"^(LICENSE|LICENSES/.*|tests/fuzz/inputs/.*|.*/reference/.*|.*\.(stl|vtp|png|svg))$")
LARGEST = 1_000_000  # [bytes]; data that are larger belong to a release, not into the history


def text_violations(name, text):
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, rule in FORBIDDEN.items():
            if match := re.search(pattern, line):
                yield f"{name}:{number}: '{match.group()}' is {rule}"
    if text and not text.endswith("\n"):
        yield f"{name}: the last line does not end; add a newline"


def mode_violations(name, content, executable):
    script = content.startswith(b"#!")
    if script and not executable:
        yield f"{name}:1: begins with #! but may not be executed; git update-index --chmod=+x {name}"
    if executable and not script:
        yield f"{name}:1: may be executed but is no script; git update-index --chmod=-x {name}"


def check(root):
    violations, checked = [], 0
    for path, executable in tracked_files(root):
        name = path.relative_to(root).as_posix()
        content = path.read_bytes()
        checked += 1
        violations += mode_violations(name, content, executable)
        if len(content) > LARGEST:
            violations.append(f"{name}: {len(content)} bytes; keep files below {LARGEST}")
        if VERBATIM.match(name) or b"\0" in content:
            continue
        try:
            violations += text_violations(name, content.decode("utf-8"))
        except UnicodeDecodeError as error:
            violations.append(f"{name}: is not UTF-8 ({error.reason} at byte {error.start}); convert it")
    return violations, checked


if __name__ == "__main__":
    sys.exit(report(*check(pathlib.Path(sys.argv[1]))))
