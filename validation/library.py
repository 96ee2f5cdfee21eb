"""The library of measures: how a figure is taken from a run's files. Each one declares its keys."""

from dataclasses import dataclass

from validation.references import KEYS as REFERENCE_KEYS

MEASURES = {}


@dataclass
class Measure:
    name: str
    meaning: str
    keys: tuple
    has_reference: bool  # takes what is known from the entry; else the measure knows it
    function: object     # (finished run, entry, the finished run that counts as the finest) → list of Point, or Errors


def measure(name, meaning, *keys, reference=True):
    """Puts a function into the library under this name."""
    def put(function):
        MEASURES[name] = Measure(name, meaning, keys + (REFERENCE_KEYS if reference else ()), reference, function)
        return function
    return put
