"""Runs of a case through `thalweg run`, each in a folder of its own, and made once."""

import hashlib
import json
import pathlib
import re
import shutil
import sys
import tempfile

from study.costs import overrides
from thalweg.programs import Failed, call
from study.results import resolved
from study.runs import Run
from study.starts import start
from thalweg.tables import text_rows
from thalweg.faults import InputError, say

PROGRAMS = ("thalweg-gencase", "thalweg-solver", "thalweg-postproc", "thalweg_core_openmp_*.so", "thalweg_core_cuda.so")


def program():
    """The program `thalweg` beside this one."""
    found = pathlib.Path(sys.argv[0]).resolve().with_name("thalweg")
    if not found.is_file():
        raise InputError(f"{found.name}: the program is not beside {pathlib.Path(sys.argv[0]).name}; call it as `thalweg validate`")
    return found


def digest(files):
    whole = hashlib.sha256()
    for file in files:
        whole.update(file.name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return whole.hexdigest()[:16]


def build(thalweg):
    """A hash of the programs that make a run: the version alone is the same for many builds."""
    return digest(sorted(file for pattern in PROGRAMS for file in thalweg.parent.glob(pattern)))


def case_content(folder):
    """A hash of the case's file, the files it names, and its measurements."""
    text = (folder / "case.toml").read_text(encoding="utf-8")
    named = {folder / word for word in re.findall(r"[\"']([^\"'\n]+)[\"']", text) if len(word) < 200 and (folder / word).is_file()}
    return digest([folder / "case.toml", *sorted(named | {file for file in (folder / "reference").rglob("*") if file.is_file()})])


class PipelineRun(Run):
    """A run with its report. `made_by`: build and content of the case, by which a finished run is known again."""

    def __init__(self, thalweg, runs, case, name, settings, made_by):
        super().__init__(thalweg, runs, case, name, settings)
        self.identity = {"settings": self.settings, **made_by}
        self.failure = ""  # in a line, if it has failed: it diverged, a disk was full, somebody ended it

    def mark(self, name):
        file = self.folder / name
        try:
            return json.loads(file.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None

    def complete(self):
        return self.mark("made_by.json") == self.identity and (self.folder / "summary.csv").is_file()

    def equal(self, runs, name, number):
        """A run that is equal but for its rounding (study/starts.py)."""
        with tempfile.TemporaryDirectory() as folder:
            self.gencase("--out", folder)
            return PipelineRun(self.thalweg, runs, self.case, name, [*self.settings, start(resolved(pathlib.Path(folder)), number)],
                               {key: value for key, value in self.identity.items() if key != "settings"})

    def check(self):
        """Throws InputError if gencase refuses the case with these settings."""
        self.gencase("--check")

    def gencase(self, *options):
        try:
            call(self.thalweg, "gencase", self.case, *options, *overrides(self.settings))
        except Failed as failed:
            raise InputError(failed.error_line()) from failed

    def compute(self):
        """Makes the run, or goes on with it if the folder holds a part of the same one. A run of another case, other settings or another
        build is made again."""
        if self.complete():
            return
        begun = self.folder / "made_by.begun.json"
        earlier = self.mark(begun.name) or self.mark("made_by.json")
        goes_on = self.mark(begun.name) == self.identity
        if not goes_on:
            if earlier:
                say(f"{self.case.name}: {self.name}: made again, because {self.difference(earlier)}")
            shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True, exist_ok=True)
        begun.write_text(json.dumps(self.identity), encoding="utf-8")
        try:
            used = call(self.thalweg, "run", self.case, "--out", self.folder, "--no-foam", "--threads", "1", "--resume",
                        *overrides([*self.settings, "compare.runs=1"]))
        except Failed as failed:
            if failed.status == 2:
                raise InputError(f"run {self.name}: {failed.error_line()}") from failed
            self.failure = failed.error_line()
            return
        begun.rename(self.folder / "made_by.json")
        say(f"{self.case.name}: {self.name}: {used.cpu:.1f} s of processor time")

    def difference(self, earlier):
        """The parts of its identity in which an earlier run differs."""
        words = {"settings": "its settings have changed", "build": "the programs have changed", "case": "the case has changed"}
        return " and ".join(words[key] for key, value in self.identity.items() if earlier.get(key) != value) or "it is not whole"

    def facts(self):
        """summary.csv: quantity → text."""
        return {row["quantity"]: row["value"] for row in text_rows(self.folder / "summary.csv")}
