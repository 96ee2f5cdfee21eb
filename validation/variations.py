"""What a sweep varies: keys with several values, and all their combinations."""

import itertools
import re
from dataclasses import dataclass

from thalweg.faults import InputError

NUMBER = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)")
MOST_RUNS = 1000  # more are a mistake in the command rather than a study


@dataclass
class Value:
    """One value of a key: `number` and `unit` if it is a number, and the text of --set."""
    text: str
    number: float | None
    unit: str

    def setting(self, key):
        quoted = self.unit != "" or (self.number is None and not self.text.startswith(("[", '"', "'")) and " " in self.text)
        return f'{key}="{self.text}"' if quoted else f"{key}={self.text}"


@dataclass
class Variation:
    key: str
    values: list

    @property
    def numeric(self):
        """True if all values are numbers of one unit, so that they have places on an axis."""
        return all(value.number is not None for value in self.values) and len({value.unit for value in self.values}) == 1

    @property
    def heading(self):
        return f"{self.key} [{self.values[0].unit or '-'}]" if self.numeric else self.key


def split(text):
    """Parts between commas that stand in no brackets and no quotes."""
    parts, depth, quote = [""], 0, ""
    for letter in text:
        quote = "" if letter == quote else letter if not quote and letter in "\"'" else quote
        depth += (letter in "[(") - (letter in "])") if not quote else 0
        if letter == "," and depth == 0 and not quote:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def value(text, unit=""):
    match = NUMBER.fullmatch(text.strip("\"'"))
    if match and not re.search(r"\d", match.group(2)[:1]):
        own = match.group(2).strip() or unit
        return Value(f"{match.group(1)} {own}".strip(), float(match.group(1)), own)
    return Value(text, None, "")


def variation(text):
    """KEY=V1,V2,…: a unit behind the last number counts for all numbers without one."""
    key, equals, values = text.partition("=")
    if not equals or not key.strip() or not values.strip():
        raise InputError(f"--vary {text}: names no values; write KEY=VALUE,VALUE as in numerics.spacing=20,10,5mm")
    parts = split(values)
    if "" in parts:
        raise InputError(f"--vary {text}: a value between two commas is missing; write KEY=VALUE,VALUE")
    unit = value(parts[-1]).unit
    found = Variation(key.strip(), [value(part, unit) for part in parts])
    texts = [each.text for each in found.values]
    twice = next((each for each in texts if texts.count(each) > 1), None)
    if twice is not None:
        raise InputError(f"--vary {text}: the value {twice} stands there twice; leave one out, and use --repeats for equal runs")
    return found


def combinations(variations, repeats):
    """All combinations of values, each a tuple in the order of the variations."""
    keys = [each.key for each in variations]
    twice = next((key for key in keys if keys.count(key) > 1), None)
    if twice is not None:
        raise InputError(f"--vary {twice}: the key stands there twice; give all its values in one --vary")
    found = list(itertools.product(*(each.values for each in variations)))
    if len(found) * repeats > MOST_RUNS:
        raise InputError(f"thalweg sweep: these are {len(found) * repeats} runs and at most {MOST_RUNS} are made; vary less")
    return found
