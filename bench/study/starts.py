"""Starts that differ by less than anything that is known of a scene: what their results differ by is scatter."""

import itertools
import re

from study.programs import call

KEY = "materials.water.density"
STEPS = (1e-4, -1e-4, 2e-4, -2e-4, 0.5e-4, -0.5e-4)  # shares of the water's density


def density(thalweg, case, settings):
    """The density of the case's water [kg/m^3]: of the settings, the case's table (as tomllib reads it), or the default."""
    given = [text.split("=", 1)[1].strip().strip('"') for text in settings if text.split("=", 1)[0].strip() == KEY]
    in_file = case.get("materials", {}).get("water", {}).get("density")
    if not given and in_file is None:
        explained = call(thalweg, "explain", KEY).text
        given = [re.search(r"default ([\d.e+]+ \S+)", explained).group(1)]
    number, unit = (given[-1] if given else in_file).split(None, 1)
    return float(number), unit


def start(thalweg, case, settings, number):
    """The setting of start `number`, from 1: the water's density, changed by some ten-thousandths of it."""
    value, unit = density(thalweg, case, settings)
    step = next(itertools.islice(itertools.cycle(STEPS), number - 1, None)) * (1 + (number - 1) // len(STEPS))
    return f'{KEY}="{value * (1 + step):.9g} {unit}"'
