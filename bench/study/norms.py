"""Exact and measured references, and distances from them: pure functions, SI units."""

import math


def rms(values):
    values = list(values)
    return math.sqrt(sum(v * v for v in values) / len(values))


def shear_rate(stress, yield_stress, regularisation, consistency, flow_index):
    """The shear rate [1/s] at which a Herschel-Bulkley-Papanastasiou fluid carries this shear stress [Pa]: the root of
    tau_y (1 - exp(-m g/2)) + k g^n = stress (physics/sediment/herschel_bulkley.hpp), by bisection to the last digit."""
    def carried(rate):
        return -yield_stress * math.expm1(-regularisation * rate / 2) + consistency * rate ** flow_index

    low, high = 0.0, 1.0
    while carried(high) < stress:
        high *= 2
    while True:
        middle = (low + high) / 2
        if middle in (low, high):
            return middle
        low, high = (middle, high) if carried(middle) < stress else (low, middle)


def slot_velocity(width, body_force, law, intervals=500):
    """Steady velocity [m/s] between two walls it sticks to, as a function of the place across [m]: the shear stress is
    body_force |x - width/2| [Pa], body_force [N/m^3]; Simpson's rule on `intervals` intervals from wall to middle."""
    step = width / 2 / intervals
    velocities, at = [0.0], shear_rate(body_force * width / 2, *law)
    for k in range(intervals):
        stress = body_force * (width / 2 - k * step)
        between, after = (shear_rate(max(stress - body_force * part * step, 0.0), *law) for part in (0.5, 1))
        velocities.append(velocities[-1] + step * (at + 4 * between + after) / 6)
        at = after

    def velocity(x):
        place = min(x, width - x) / step
        k = min(max(int(place), 0), intervals - 1)
        return velocities[k] + (place - k) * (velocities[k + 1] - velocities[k])

    return velocity


def vortex(x, z, time, side, speed, viscosity):
    """Taylor-Green vortex: velocities [m/s] and pressure over density [m^2/s^2] in a periodic square of this side [m]."""
    k = 2 * math.pi / side
    decay = math.exp(-2 * viscosity * k * k * time)
    u = speed * decay * math.sin(k * x) * math.cos(k * z)
    w = -speed * decay * math.cos(k * x) * math.sin(k * z)
    return u, w, (speed * decay) ** 2 / 4 * (math.cos(2 * k * x) + math.cos(2 * k * z))


VON_KARMAN = 0.41  # [-] as in physics/water/log_profile.hpp


class LogLaw:
    """The logarithmic law of a rough or smooth floor: u = (u*/κ) ln(z/z0), z0 = 0.11 ν/u* + 0.033 ks."""

    def __init__(self, friction, viscosity, roughness):
        self.friction = friction  # [m/s] u*
        self.origin = 0.11 * viscosity / friction + 0.033 * roughness  # [m] z0

    def velocity(self, z):
        return self.friction / VON_KARMAN * math.log(z / self.origin) if z > self.origin else 0.0

    def mean(self, depth):
        """Over the depth; from ∫ ln(z/z0) dz between z0 and H."""
        return self.friction / VON_KARMAN * (math.log(depth / self.origin) - 1 + self.origin / depth)


def layered_pressure(z, layers, gravity):
    """Hydrostatic pressure [Pa] under layers of (top [m], density [kg/m^3]), the lowest first."""
    pressure, below = 0.0, z
    for top, density in layers:
        pressure += density * gravity * max(0.0, top - below)
        below = max(below, top)
    return pressure


def mean_between(series, begin, end):
    """Mean of samples (time, value) with begin <= time < end; None where there is none. A missing value counts as 0."""
    found = [value if isinstance(value, float) else 0.0 for time, value in series if begin <= time < end]
    return sum(found) / len(found) if found else None


def slope(xs, ys):
    """Slope of the straight line through points, least squares."""
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) / sum((x - mean_x) ** 2 for x in xs)


def order(spacings, errors):
    """Order of convergence: slope of log(error) over log(spacing), least squares."""
    return slope([math.log(s) for s in spacings], [math.log(e) for e in errors])


def pareto_front(points):
    """The points (cost, error) that no other point beats in both, cheapest first."""
    front = []
    for cost, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((cost, error))
    return front
