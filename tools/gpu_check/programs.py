"""The bundle's programs, each with its output in a log."""

import csv
import hashlib
import os
import re
import shutil
import signal
import subprocess
import time


class Programs:
    """The programs of a bundle, and the folders of their runs and logs."""

    def __init__(self, bundle, out):
        self.bundle = bundle
        self.runs = out / "runs"
        self.logs = out / "logs"

    def log(self, name):
        self.logs.mkdir(parents=True, exist_ok=True)
        return self.logs / (re.sub(r"[^\w.-]+", "_", name) + ".log")

    def run(self, name, command, limit, **environment):
        """Runs a command: (exit status or "timeout", wall seconds). It is first asked to end, so that it keeps its work."""
        start = time.monotonic()
        with open(self.log(name), "a", encoding="utf-8") as output:
            output.write("$ " + " ".join(map(str, command)) + "\n")
            output.flush()
            with subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT,
                                  env={**os.environ, **environment}) as process:
                try:
                    status = process.wait(timeout=max(1.0, limit))
                except subprocess.TimeoutExpired:
                    status = "timeout"
                    process.send_signal(signal.SIGTERM)
                    try:
                        process.wait(timeout=60)
                    except subprocess.TimeoutExpired:
                        process.kill()
        return status, time.monotonic() - start

    def last_lines(self, name):
        text = self.log(name).read_text(encoding="utf-8", errors="replace").strip().splitlines()
        return text[-1][:200] if text else ""

    def fill(self, name, case, settings, limit):
        """Fills a scene anew; its folder, or None where that failed."""
        folder = self.runs / re.sub(r"[^\w.-]+", "_", name)
        shutil.rmtree(folder, ignore_errors=True)
        overrides = [word for s in settings for word in ("--set", s)]
        status, _ = self.run(f"{name}-fill", [self.bundle / "bin" / "thalweg-gencase", self.bundle / case, "--out", folder,
                                              "--force", *overrides], limit)
        return folder if status == 0 else None

    def solve(self, name, folder, limit, *options, backend="cuda", wrap=(), **environment):
        return self.run(name, [*wrap, self.bundle / "bin" / "thalweg-solver", folder, "--backend", backend, *options], limit,
                        **environment)


def table(file):
    """The first two columns of a table: quantity and value of summary.csv, heading and seconds of timing.csv."""
    with open(file, encoding="utf-8") as rows:
        return {row[0]: row[1] for row in csv.reader(rows)}


def last_row(file):
    with open(file, encoding="utf-8") as rows:
        return list(csv.DictReader(rows))[-1]


# What a checkpoint holds beside the state: the seconds that the run has taken, and the check sum of the whole file.
NO_STATE = (rb'<DataArray [^>]*Name="RunCounts".*?</DataArray>', rb"<!-- crc32 .*?-->")


def digest(file):
    """Of the state or the rows in a file of results; empty where it is missing."""
    if not file.exists():
        return ""
    content = file.read_bytes()
    for pattern in NO_STATE:
        content = re.sub(pattern, b"", content, flags=re.DOTALL)
    return hashlib.sha256(content).hexdigest()
