"""Points where a run is compared with what is known, and the errors over them."""

from dataclasses import dataclass

from study.norms import order, rms


@dataclass
class Point:
    """One comparison: computed, and the range of what is known (one number: low and high are equal; nothing known: None)."""
    at: object              # a time [s], a place [m], a name
    computed: float
    low: float | None = None
    high: float | None = None

    @property
    def reference(self):
        """The middle of what is known."""
        return None if self.low is None else (self.low + self.high) / 2

    @property
    def error(self):
        """Computed less what is known; 0 inside a range."""
        return max(self.computed - self.high, 0.0) + min(self.computed - self.low, 0.0)


@dataclass
class Errors:
    """Errors over some points, in the unit of the quantity; what does not apply is None."""
    points: int
    rmse: float | None = None
    normalised_rmse: float | None = None  # over the range of the reference
    bias: float | None = None
    largest: float | None = None          # with its sign
    largest_at: object = None
    brier_skill: float | None = None      # of a bed: 1 perfect, 0 as bad as a bed that does not change


def errors(points):
    """The errors over points; without a reference there are none."""
    known = [point for point in points if point.low is not None]
    if not known:
        return Errors(0)
    worst = max(known, key=lambda point: abs(point.error))
    references = [point.reference for point in known]
    extent = max(references) - min(references)
    size = rms(point.error for point in known)
    return Errors(len(known), size, size / extent if extent > 0 else None,
                  sum(point.error for point in known) / len(known), worst.error, worst.at)


def scaled(points, scale, spacing):
    """The same points over a scale: a number, or "reference" (each point's own), "range", "rms" of the reference, "spacing"."""
    if scale is None:
        return points
    known = [point.reference for point in points if point.low is not None]
    whole = {"range": lambda: max(known) - min(known), "rms": lambda: rms(known), "spacing": lambda: spacing}

    def over(point):
        size = abs(point.reference) if scale == "reference" else whole[scale]() if scale in whole else scale
        if size == 0:
            raise ZeroDivisionError(f"the scale {scale} is 0 at {point.at}")
        return Point(point.at, point.computed / size, point.low / size, point.high / size)

    return [over(point) if point.low is not None else point for point in points]


def judged(found, which):
    """The error that is held against the limit."""
    return {"largest": found.largest, "rmse": found.rmse, "bias": found.bias}[which]


def order_of(spacings, values):
    """Order of convergence of errors, and a note. None without two spacings or with an error of 0.

    spacings [m] differ; values: the error that is judged, a sign counts as none."""
    pairs = sorted(zip(spacings, (abs(value) for value in values)), reverse=True)
    if len(pairs) < 2 or any(value == 0 for _, value in pairs):
        return None, ""
    slope = order([spacing for spacing, _ in pairs], [value for _, value in pairs])
    changes = [after - before for (_, before), (_, after) in zip(pairs, pairs[1:])]
    if max(changes) < 0:
        return slope, ""
    return slope, "grows" if min(changes) > 0 else "not monotonic"
