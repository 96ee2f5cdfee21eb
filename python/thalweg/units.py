"""Quantities with units, "2 mm" or "1540 kg/m^3", as SI numbers: the units that case files use, written as UDUNITS does."""

import math
import re

from thalweg.faults import InputError

# Symbol: factor to SI, exponents of m, kg, s.
BASE = {"m": (1.0, (1, 0, 0)), "g": (1e-3, (0, 1, 0)), "s": (1.0, (0, 0, 1)), "Pa": (1.0, (-1, 1, -2)), "N": (1.0, (1, 1, -2)),
        "L": (1e-3, (3, 0, 0)), "l": (1e-3, (3, 0, 0)), "J": (1.0, (2, 1, -2)), "W": (1.0, (2, 1, -3)), "Hz": (1.0, (0, 0, -1))}
ALONE = {"min": (60.0, (0, 0, 1)), "h": (3600.0, (0, 0, 1)), "hour": (3600.0, (0, 0, 1)), "day": (86400.0, (0, 0, 1)),
         "d": (86400.0, (0, 0, 1)), "deg": (math.pi / 180, (0, 0, 0)), "degree": (math.pi / 180, (0, 0, 0)), "rad": (1.0, (0, 0, 0)),
         "ft": (0.3048, (1, 0, 0)), "foot": (0.3048, (1, 0, 0)), "inch": (0.0254, (1, 0, 0)), "t": (1e3, (0, 1, 0)), "bar": (1e5, (-1, 1, -2)),
         "%": (0.01, (0, 0, 0)), "byte": (1.0, (0, 0, 0)), "kB": (1e3, (0, 0, 0)), "MB": (1e6, (0, 0, 0)), "GB": (1e9, (0, 0, 0))}
PREFIXES = {"n": 1e-9, "u": 1e-6, "µ": 1e-6, "m": 1e-3, "c": 1e-2, "d": 1e-1, "h": 1e2, "k": 1e3, "M": 1e6, "G": 1e9}
QUANTITY = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$")
PART = re.compile(r"([A-Za-zµ%]+)(?:\^?([-+]?\d+))?$")


def unit(text):
    """(factor to SI, exponents of m, kg, s) of a unit. Raises InputError."""
    factor, exponents, sign = 1.0, [0, 0, 0], 1
    for word in re.findall(r"/|[^\s/*.·]+", text):
        if word == "/":
            sign = -1
            continue
        if word == "1":
            continue
        found = PART.match(word)
        if not found:
            raise InputError(f"{text}: is no unit; write one as in \"kg/m^3\"")
        size, powers = _symbol(found.group(1), text)
        power = sign * int(found.group(2) or 1)
        factor *= size ** power
        exponents = [e + power * p for e, p in zip(exponents, powers)]
        sign = 1
    return factor, tuple(exponents)


def _symbol(name, text):
    for known in (ALONE, BASE):
        if name in known:
            return known[name]
    if name[:1] in PREFIXES and name[1:] in BASE:
        size, powers = BASE[name[1:]]
        return PREFIXES[name[0]] * size, powers
    raise InputError(f"{text}: the unit {name} is not known here; write one as in \"kg/m^3\"")


def si(quantity, of=None):
    """The SI number of "2 mm", of a number, or of lists of them. `of`: a unit of the same kind that it has to be, such as "m"."""
    if isinstance(quantity, (list, tuple)):
        return [si(each, of) for each in quantity]
    if not isinstance(quantity, str):
        return float(quantity)
    found = QUANTITY.match(quantity)
    if not found:
        raise InputError(f"{quantity}: is no quantity; write a number and a unit, as \"2 mm\"")
    factor, exponents = unit(found.group(2))
    if of is not None and exponents != unit(of)[1]:
        raise InputError(f"{quantity}: is not measured in {of}; give a unit of that kind")
    return float(found.group(1)) * factor


def written(value, in_unit):
    """The text of an SI number in a unit: written(0.002, "mm") is "2 mm"."""
    return f"{value / unit(in_unit)[0]:.12g} {in_unit}".strip()
