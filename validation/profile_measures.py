"""Measures of whole profiles, from the error tables of postproc."""

import math

from study.norms import rms
from thalweg.tables import read_table
from validation.keys import Key
from validation.library import measure
from validation.points import Errors

CURVE = Key("curve", "text", "bed, free_surface or moving_bed", required=True, words=("bed", "free_surface", "moving_bed"))


@measure("profile", "A profile at one time against a measured one that the case compares with (reference/t0.500.csv), as in "
         "report/errors.csv: root mean square, bias, largest error, Brier skill score.",
         CURVE, Key("at", "number", "time [s], one of compare.times or bed_times", required=True),
         Key("line", "text", "name of a [[line]], measured in reference/NAME/t0.500.csv; default: the profile along x"),
         Key("source", "text", "label of the measurement in report/errors.csv; default: the only one there"), reference=False)
def profile(finished, entry, _):
    given = entry.given
    file = finished.folder / "report/errors.csv"
    rows = [row for row in (read_table(file) if file.exists() else [])
            if row["curve"] == given["curve"] and (row["line"] or "") == given.get("line", "")
            and math.isclose(row["time"], given["at"], abs_tol=1e-6) and given.get("source") in (None, row["reference"])]
    if len({row["reference"] for row in rows}) != 1:
        along = f"along {given['line']} " if "line" in given else ""
        labels = sorted({row["reference"] for row in rows})
        finished.fail(f"run {finished.run.name} compares the {given['curve']} at {given['at']:g} s {along}with "
                      f"{'no measurement' if not rows else ' and '.join(labels)}; see report/errors.csv, give source, or a profile in reference/")
    row = rows[0]
    number = {key: value if isinstance(value, float) else None for key, value in row.items()}
    return Errors(int(row["points"]), number["rmse"], number["normalised_rmse"], number["bias"], number["largest_error"],
                  number["largest_error_at"], number["brier_skill"])


@measure("distance from the finest", "Root mean square [m] between a profile of the run and the same of the finest run of its variant, "
         "over some times: no comparison with nature, only what the spacing decides.",
         CURVE, Key("at", "numbers", "times [s], of compare.times or bed_times", required=True), reference=False)
def distance_from_the_finest(finished, entry, finest):
    if finest is None or finest is finished:
        return []
    found = finished.run.profile_distances([finest.run])
    wanted = [distance for (_, curve, time), distance in found.items()
              if curve == entry.given["curve"] and any(math.isclose(time, at, abs_tol=1e-6) for at in entry.given["at"])]
    if len(wanted) != len(entry.given["at"]):
        finished.fail(f"the profiles of run {finished.run.name} have {len(wanted)} of the times; give times of compare.times")
    return Errors(len(wanted), rms(wanted), None, None, max(wanted), None)
