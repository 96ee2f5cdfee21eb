"""A run of a study: a case with some keys changed, in a folder of its own, computed once."""

import json
import re
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor

from study.costs import overrides
from thalweg.programs import call, stop_all
from thalweg.tables import read_table


class Run:
    """The case with `settings` (as of --set), in a folder below `runs` that has the run's name."""

    def __init__(self, thalweg, runs, case, name, settings):
        self.thalweg, self.case, self.name, self.settings = thalweg, case, name, list(settings)
        self.folder = runs / re.sub(r"[^\w.]+", "_", name)

    def complete(self):
        mark = self.folder / "study.json"
        return mark.exists() and json.loads(mark.read_text(encoding="utf-8")) == self.settings

    def compute(self, start=None, postproc=False):
        """Computes what is not there yet; continues a run that was stopped on the way. `start` may change particles.vtp."""
        if self.complete():
            return
        begun = self.folder / "study.begun.json"
        same = begun.exists() and json.loads(begun.read_text(encoding="utf-8")) == self.settings
        checkpoint = self.folder / "checkpoint.vtp"
        if not (same and checkpoint.exists()):
            shutil.rmtree(self.folder, ignore_errors=True)
            call(self.thalweg, "gencase", self.case, "--out", self.folder, *overrides(self.settings))
            if start:
                start(self.folder)
            begun.write_text(json.dumps(self.settings), encoding="utf-8")
            call(self.thalweg, "solver", self.folder, "--threads", "1")
        else:
            call(self.thalweg, "solver", self.folder, "--threads", "1", "--restart", "latest")
        if postproc:
            call(self.thalweg, "postproc", self.folder)
        begun.rename(self.folder / "study.json")
        print(f"done: {self.name}", flush=True)

    def summary(self, quantity):
        return next(row["value"] for row in read_table(self.folder / "summary.csv") if row["quantity"] == quantity)

    def cpu_seconds(self):
        """Processor time of the whole run [s], over all restarts."""
        return self.summary("cpu_seconds")

    def profile_distances(self, others):
        """Root mean squares [m] between profiles of this run and of the others, by (other's name, curve, time)."""
        if not others:
            return {}
        labels = {other.name.replace("=", ""): other for other in others}
        compared = [f"{label}={other.folder}" for label, other in labels.items()]
        call(self.thalweg, "postproc", self.folder, "--compare", *compared)
        return {(labels[row["reference"]].name, row["curve"], row["time"]): row["rmse"]
                for row in read_table(self.folder / "report/errors.csv") if row["reference"] in labels}


def compute_all(runs, jobs, compute):
    """Calls compute(run) for all runs, `jobs` at a time; a run that fails is reported and left out. Returns the failed ones."""
    failed = []

    def one(run):
        try:
            compute(run)
        except RuntimeError as error:
            failed.append(run)
            print(f"FAILED: {run.name}\n{error}", file=sys.stderr, flush=True)

    with ThreadPoolExecutor(jobs) as pool:
        try:
            list(pool.map(one, runs))
        except BaseException:  # a signal too: nothing is started any more, and the pool waits for what runs
            stop_all()
            raise
    return failed
