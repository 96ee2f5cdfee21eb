"""Runs that are equal but for less than anything that is known of a scene: what their results differ by is scatter.

The Courant number is changed by some ten-thousandths: other time steps and other rounding of the same physics, in every scene. (A density would
do as well in a scene of several materials; where there is only water, results over the density do not depend on it.)
"""

KEY = "numerics.cfl"
STEP = 1e-4


def start(resolved, number):
    """The setting of the equal run `number`, from 1; `resolved`: the tables of its resolved case."""
    return f"{KEY}={resolved['numerics']['cfl'] * (1 - STEP * number):.9g}"
