"""What is known of a quantity: numbers in expected.toml, or a table in the case's folder."""

from thalweg.tables import read_table
from thalweg.faults import InputError, nearest
from validation.keys import Key
from validation.points import Point

KEYS = (
    Key("at", "number or numbers", "times [s] of the values; with `reference`: left out"),
    Key("value", "number or numbers", "the known value, in the order of `at`"),
    Key("between", "pairs", "in place of `value`: the range of what is known, [lowest, highest], in the order of `at`"),
    Key("reference", "text", "in place of `value`: a table of the case, for example reference/front.csv"),
    Key("reference_at", "text or texts", "its column of times; two columns: begin and end of a window, over which the run is averaged"),
    Key("reference_column", "text or texts", "its column of known values, in the order of `column`"),
    Key("reference_low", "text", "in place of reference_column: its column of lowest values"),
    Key("reference_high", "text", "and of highest values"),
    Key("at_scale", "positive number", "the table's times are multiplied by it, to give seconds"),
    Key("value_scale", "positive number", "the table's values are multiplied by it, to give the unit of the quantity"),
)
AT_END = (None,)


def as_list(value):
    return value if isinstance(value, list) else [value]


class Reference:
    """Known values of an entry: `times` at which there are any ([s], or (begin, end)), and range(n, column)."""

    def __init__(self, entry):
        self._entry, given = entry, entry.given
        if "reference" in given:
            self._from_table()
            return
        for key in ("reference_at", "reference_column", "reference_low", "reference_high", "at_scale", "value_scale"):
            if key in given:
                raise InputError(f"{entry.at(key)}: {key} has no table; give reference, the name of the table")
        self.times = [float(time) for time in as_list(given["at"])] if "at" in given else list(AT_END)
        if "value" in given and "between" in given:
            raise InputError(f"{entry.at('between')}: value and between exclude each other; keep one of them")
        pairs = given.get("between") or [(value, value) for value in as_list(given.get("value", []))]
        for low, high in pairs:
            if low > high:
                raise InputError(f"{entry.at('between')}: {low:g} is above {high:g}; give [lowest, highest]")
        if pairs and len(pairs) != len(self.times):
            key = "between" if "between" in given else "value"
            raise InputError(f"{entry.at(key)}: {key} has {len(pairs)} entries and `at` {len(self.times)}; give one for each time")
        self._ranges = [pairs] if pairs else None

    def _from_table(self):
        given, entry = self._entry.given, self._entry
        for key in ("at", "value", "between"):
            if key in given:
                raise InputError(f"{entry.at(key)}: {key} stands beside a table; leave one of them out")
        if "reference_at" not in given:
            raise InputError(f"{entry.at('reference')}: reference_at is missing; give it: the table's column of times")
        low = as_list(given.get("reference_column") or given.get("reference_low") or [])
        high = as_list(given.get("reference_column") or given.get("reference_high") or [])
        if not low or len(low) != len(high):
            raise InputError(f"{entry.at('reference')}: no column of known values; give reference_column, or reference_low and "
                             "reference_high")
        file = entry.folder / given["reference"]
        if not file.is_file():
            raise InputError(f"{entry.at('reference')}: there is no file {given['reference']} in the case's folder; correct the name")
        rows = read_table(file)
        times = self._columns(rows, as_list(given["reference_at"]), "reference_at", given.get("at_scale", 1))
        self.times = [row[0] if len(row) == 1 else (row[0], row[1]) for row in times]
        scale = given.get("value_scale", 1)
        key = "reference_column" if "reference_column" in given else "reference_low"
        lows = self._columns(rows, low, key, scale)
        highs = self._columns(rows, high, "reference_column" if "reference_column" in given else "reference_high", scale)
        self._ranges = [[(lows[n][c], highs[n][c]) for n in range(len(rows))] for c in range(len(low))]

    def _columns(self, rows, names, key, scale):
        entry = self._entry
        for name in names:
            if not rows or name not in rows[0]:
                raise InputError(f"{entry.at(key)}: {entry.given['reference']} has no column {name}; "
                                 f"{nearest(name, list(rows[0]) if rows else ['nothing'])}")
        for number, row in enumerate(rows, 1):
            if any(not isinstance(row[name], float) for name in names):
                raise InputError(f"{entry.at(key)}: {entry.given['reference']}: row {number} has no number in {', '.join(names)}; "
                                 "fill it or take the row out")
        return [[row[name] * scale for name in names] for row in rows]

    @property
    def columns(self):
        """Number of columns of known values; 0 if nothing is known."""
        return len(self._ranges) if self._ranges else 0

    def points(self, sample, column=0):
        """A point for each time: sample(time) is what was computed."""
        ranges = self._ranges[column] if self._ranges else [(None, None)] * len(self.times)
        return [Point("" if time is None else time if not isinstance(time, tuple) else sum(time) / 2, sample(time), low, high)
                for time, (low, high) in zip(self.times, ranges)]
