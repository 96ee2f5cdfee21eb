"""Measurements that are repeated in turn, and the spread of their results.

Ratios are taken pair by pair from runs that alternate, so that a busy machine disturbs both alike; their median is what is quoted.
"""

import statistics
import sys
from dataclasses import dataclass


def in_turn(measurements, repeats):
    """Calls the named measurements one after the other, `repeats` times around; a list of results for each name."""
    results = {name: [] for name in measurements}
    for turn in range(repeats):
        for name, measurement in measurements.items():
            results[name].append(measurement())
            print(f"  {name}, {turn + 1} of {repeats}", file=sys.stderr, flush=True)
    return results


@dataclass
class Spread:
    """Median of some numbers, with the least and the largest."""
    median: float
    least: float
    most: float

    @classmethod
    def of(cls, numbers):
        numbers = list(numbers)
        return cls(statistics.median(numbers), min(numbers), max(numbers))

    def __format__(self, spec):
        return f"{self.median:{spec}} ({self.least:{spec}} to {self.most:{spec}})"


def ratios(numerators, denominators):
    """Ratios of runs that alternated, pair by pair."""
    return Spread.of(a / b for a, b in zip(numerators, denominators))


def shown(cell):
    """A cell of a table: three significant digits, the spread of repeated runs behind the median."""
    if isinstance(cell, Spread):
        return f"{shown(cell.median)} ({shown(cell.least)} to {shown(cell.most)})"
    if isinstance(cell, float):
        return f"{cell:.0f}" if abs(cell) >= 1000 else f"{cell:.3g}"
    return str(cell)
