"""Order of convergence and extrapolated value of a quantity at three spacings (Richardson; Roache 1997, Annu. Rev. Fluid Mech. 29)."""

from dataclasses import dataclass

SAFETY = 1.25  # Roache's factor for three grids
HIGHEST_ORDER = 10.0


@dataclass
class Convergence:
    """order p, value at spacing 0, band: SAFETY times its distance from the finest value. None where there is no order."""
    order: float | None = None
    extrapolated: float | None = None
    band: float | None = None
    note: str = ""


def convergence(spacings, values, scatter=0.0):
    """Of the three finest of some spacings [m] and the values there; `scatter`: extent of equal runs, below which there is no order.

    f(h) = f0 + c h^p through three points: (f3 - f2)/(f2 - f1) = (h3^p - h2^p)/(h2^p - h1^p), h1 the finest; p by bisection."""
    (h1, f1), (h2, f2), (h3, f3) = sorted(zip(spacings, values))[:3]
    if max(f1, f2, f3) - min(f1, f2, f3) <= scatter:
        return Convergence(note="within the scatter")
    if f1 == f2 or (f3 - f2) * (f2 - f1) <= 0:
        return Convergence(note="not monotonic")
    wanted = (f3 - f2) / (f2 - f1)

    def ratio(p):
        return (h3 ** p - h2 ** p) / (h2 ** p - h1 ** p)

    low, high = 1e-6, HIGHEST_ORDER
    if wanted <= ratio(low):
        return Convergence(note="does not converge")
    if wanted >= ratio(high):
        return Convergence(note=f"order above {HIGHEST_ORDER:g}")
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if ratio(middle) < wanted else (low, middle)
    order = (low + high) / 2
    change = (f1 - f2) * h1 ** order / (h2 ** order - h1 ** order)
    return Convergence(order, f1 + change, SAFETY * abs(change), "")
