"""The outcome of a validation: a row for each quantity and run, with its verdict."""

from dataclasses import dataclass, field

from validation.finished import Finished
from validation.points import Errors, errors, judged, order_of, scaled

NEGLIGIBLE = 0.01  # share of the limit
PASS, MISFIT, FAIL, NO_VERDICT = "pass", "known misfit", "fail", "no verdict"


@dataclass
class Row:
    """One quantity of one run. Numbers are in the unit of the quantity; `error` is in that of the limit. None: does not apply."""
    case: str
    run: object                  # PipelineRun
    plan: object                 # RunPlan
    entry: object                # Entry
    points: list = field(default_factory=list)
    found: Errors = field(default_factory=lambda: Errors(0))
    error: float | None = None
    scatter: float | None = None
    equal_runs: int = 1          # runs of which the scatter is the extent
    order: float | None = None
    order_note: str = ""
    verdict: str = NO_VERDICT
    note: str = ""

    @property
    def computed(self):
        return self.points[0].computed if len(self.points) == 1 else None

    @property
    def reference(self):
        return self.points[0].reference if len(self.points) == 1 else None


def measured(finished, entry, finest):
    """Points and errors of an entry in a run, and the error that is held against the limit; None if it is not measured of this run."""
    finished.where = entry.at
    result = entry.measure.function(finished, entry, finest)
    given = entry.given
    which, scale = given.get("error", "largest"), given.get("relative_to")
    if isinstance(result, Errors):
        size = {"range": lambda: result.rmse / result.normalised_rmse if result.normalised_rmse else None,
                "spacing": lambda: finished.spacing}.get(scale, lambda: scale or 1)()
        if not isinstance(size, (int, float)):
            finished.fail(f"relative_to is {scale}, which a measure of whole profiles does not know; give a number, range or spacing", "relative_to")
        value = judged(result, which)
        return [], result, None if value is None else value / size
    if not result:
        return None
    try:
        value = judged(errors(scaled(result, scale, finished.spacing)), which)
    except ZeroDivisionError as error:
        finished.fail(f"{error}; give relative_to another scale", "relative_to")
    return result, errors(result), value


def verdict(row):
    """The verdict and a note, from limit and known misfit; nothing else decides."""
    given = row.entry.given
    if row.run.failure:
        return FAIL, f"the run failed: {row.run.failure}"
    if "limit" not in given:
        return NO_VERDICT, given["reason"]
    if row.error is None:
        return FAIL, "the measure gives no such error; take another for `error`"
    size = abs(row.error)
    if size <= given["limit"]:
        return PASS, "a misfit is declared for it that is not there" if "known_misfit" in given else ""
    if size <= given.get("misfit_limit", -1.0):
        return MISFIT, given["known_misfit"]
    worse = f", nor is the known misfit of {given['misfit_limit']:g}" if "misfit_limit" in given else ""
    return FAIL, f"{size:.3g} is above the limit of {given['limit']:g}{worse}"


def spread(row, finished, repeats, finest):
    """Extent of the judged error, or of what was computed if nothing is known, over the run and its repeats."""
    values = [row.error if row.error is not None else row.computed]
    for repeat in repeats:
        again = measured(repeat, row.entry, finest)
        if again:
            points, _, error = again
            values.append(error if error is not None else points[0].computed if len(points) == 1 else None)
    known = [value for value in values if value is not None]
    return (max(known) - min(known), len(known)) if len(known) > 1 else (None, 1)


def rows_of(expected, runs):
    """The rows of a case. `runs`: for each RunPlan the run and its repeats."""
    done = {plan.name: (Finished(run), [Finished(repeat) for repeat in repeats if not repeat.failure])
            for plan, run, repeats in runs if not run.failure}
    finest = {}
    for plan, run, _ in runs:
        if plan.name in done:
            best = finest.get(plan.variant)
            finished = done[plan.name][0]
            finest[plan.variant] = finished if best is None or finished.spacing < best.spacing else best
    rows = []
    for entry in expected.entries:
        for plan, run, _ in runs:
            if not entry.concerns(plan):
                continue
            row = Row(expected.name, run, plan, entry)
            if plan.name in done:
                finished, repeats = done[plan.name]
                found = measured(finished, entry, finest[plan.variant])
                if found is None:
                    continue
                row.points, row.found, row.error = found
                row.scatter, row.equal_runs = spread(row, finished, repeats, finest[plan.variant])
            row.verdict, row.note = verdict(row)
            rows.append(row)
        add_order(rows, entry, done)
    return rows


def add_order(rows, entry, done):
    """Order of convergence of the error, in the quantity's own unit, where runs of a variant have several spacings. Within the scatter there
    is none to see, nor where all errors are a hundredth of the limit: those are of rounding."""
    which = entry.given.get("error", "largest")
    variants = {}
    for row in rows:
        if row.entry is entry and row.error is not None and row.plan.name in done:
            variants.setdefault(row.plan.variant, {})[done[row.plan.name][0].spacing] = row
    for found in variants.values():
        sizes = [abs(row.error) for row in found.values()]
        if max(sizes) <= NEGLIGIBLE * entry.given.get("limit", 0.0):
            continue
        order, note = order_of(list(found), [judged(row.found, which) for row in found.values()])
        scatter = max((row.scatter or 0.0 for row in found.values()), default=0.0)
        if order is not None and max(sizes) - min(sizes) <= scatter:
            note = "within the scatter"
        for row in found.values():
            row.order, row.order_note = order, note
