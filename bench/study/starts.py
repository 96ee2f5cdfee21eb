"""Starts that differ by less than anything that is known of a scene: what their results differ by is scatter."""

import itertools
import re

from study.programs import call

WATER = "materials.water.density"
STEPS = (1e-4, -1e-4, 2e-4, -2e-4, 0.5e-4, -0.5e-4)  # shares of a density


def value_of(thalweg, case, settings, key):
    """Number and unit of a key: of the settings, of the case's table (as tomllib reads it), or the default. ValueError if there is none."""
    given = [text.split("=", 1)[1].strip().strip('"') for text in settings if text.split("=", 1)[0].strip() == key]
    found = given[-1] if given else case
    if not given:
        for part in key.split("."):
            found = found.get(part) if isinstance(found, dict) else None
    if found is None:
        explained = re.search(r"default ([\d.e+-]+ \S+)", call(thalweg, "explain", key).text)
        found = explained.group(1) if explained else None
    match = re.fullmatch(r"\s*([\d.eE+-]+)\s+(\S.*?)\s*", str(found))
    if not match:
        raise ValueError(f"{key} has no value with a unit")
    return float(match.group(1)), match.group(2)


def start(thalweg, case, settings, number, keys=(WATER,)):
    """The settings of start `number`, from 1: densities, of the water if nothing else is named, changed by some ten-thousandths."""
    step = next(itertools.islice(itertools.cycle(STEPS), number - 1, None)) * (1 + (number - 1) // len(STEPS))
    values = {key: value_of(thalweg, case, settings, key) for key in keys}
    return [f'{key}="{value * (1 + step):.9g} {unit}"' for key, (value, unit) in values.items()]
