"""Filling from a seed: the region that walls leave, as a box where it is one. Stands in for GenCase's flood on particles."""

from collections import deque

from thalweg.importing import geometry as geo
from thalweg.importing.drawn import Chain

CELLS = {True: 14_000, False: 40_000}  # by flat: cells of the coarse grid on which the region is searched


def fill(filled, walls, definition):
    """The box that a filling comes to; None where the region is no box. `walls`: what was drawn as walls before it."""
    flat, seed = definition.flat, filled.seed
    limits = definition.limits if filled.box is None else common(filled.box, definition.limits)
    if limits is None or not limits.contains(seed, 1e-9):
        return None
    axes = (0, 2) if flat else (0, 1, 2)
    volume = 1.0
    for a in axes:
        volume *= limits.high[a] - limits.low[a]
    cell = max(definition.spacing, (volume / CELLS[flat]) ** (1 / len(axes)))
    cells = flood(seed, limits, walls, axes, cell)
    if cells is None:
        return None
    low, high = [], []
    planes = [[p[a] for wall in walls if isinstance(wall.body, geo.Box) for p in (wall.body.low, wall.body.high)] for a in range(3)]
    for a in range(3):
        if a not in axes:
            low.append(limits.low[a])
            high.append(limits.high[a])
            continue
        ends = [seed[a] + cell * extreme(c[a] for c in cells) for extreme in (min, max)]
        low.append(nearest(ends[0] - cell / 2, [*planes[a], limits.low[a]], cell))
        high.append(nearest(ends[1] + cell / 2, [*planes[a], limits.high[a]], cell))
    box = geo.Box(tuple(low), tuple(high))
    return box if is_filled(box, cells, seed, cell, axes, walls) else None


def common(a, b):
    """What two boxes share, or None."""
    low, high = tuple(map(max, a.low, b.low)), tuple(map(min, a.high, b.high))
    return geo.Box(low, high) if all(l <= h for l, h in zip(low, high)) else None


def nearest(value, candidates, within):
    near = min(candidates, key=lambda c: abs(c - value), default=value)
    return near if abs(near - value) <= within else value


def flood(seed, limits, walls, axes, cell):
    """The cells (offsets from the seed in cells) that are reached from it, or None if the region leaves no end."""
    begin = (0, 0, 0)
    reached, queue = {begin}, deque([begin])
    while queue:
        here = queue.popleft()
        p = tuple(s + cell * k for s, k in zip(seed, here))
        for axis in axes:
            for way in (-1, 1):
                there = tuple(k + (way if i == axis else 0) for i, k in enumerate(here))
                if there in reached:
                    continue
                q = tuple(s + cell * k for s, k in zip(seed, there))
                if not limits.contains(q, 1e-9) or any(blocks(wall, p, q) for wall in walls):
                    continue
                reached.add(there)
                if len(reached) > 60_000:
                    return None
                queue.append(there)
    return reached


def is_filled(box, cells, seed, cell, axes, walls):
    """Whether all cells in the box were reached or lie in walls."""
    ranges = [range(min(c[a] for c in cells), max(c[a] for c in cells) + 1) if a in axes else range(1) for a in range(3)]
    missing = total = 0
    for i in ranges[0]:
        for j in ranges[1]:
            for k in ranges[2]:
                total += 1
                if (i, j, k) not in cells:
                    p = tuple(s + cell * n for s, n in zip(seed, (i, j, k)))
                    missing += box.contains(p) and not any(wall.faces is None and wall.body.contains(p, cell / 2) for wall in walls)
    return missing <= 0.002 * total


def blocks(wall, p, q):
    """Whether a wall lies between two points."""
    body = wall.body
    if isinstance(body, geo.Box):
        if wall.faces is None:
            return enters(body, p, q)
        return any(crosses_face(body, *geo.FACES[name], p, q) for name in wall.faces)
    if isinstance(body, Chain):
        return any(segments_cross(a, b, p, q) for a, b in zip(body.points, body.points[1:]))
    if wall.faces is None or getattr(body, "closed", True):
        steps = [tuple(a + t / 4 * (b - a) for a, b in zip(p, q)) for t in range(1, 5)]
        inside = body.contains(p)
        return any(body.contains(x) != inside for x in steps)
    return False


def enters(box, p, q):
    """Whether the segment from p to q meets the box."""
    begin, end = 0.0, 1.0
    for low, high, a, b in zip(box.low, box.high, p, q):
        way = b - a
        if abs(way) < 1e-15:
            if not low <= a <= high:
                return False
            continue
        near, far = sorted(((low - a) / way, (high - a) / way))
        begin, end = max(begin, near), min(end, far)
    return begin <= end


def crosses_face(box, axis, end, p, q):
    at = (box.low, box.high)[end][axis]
    if (p[axis] < at) == (q[axis] < at):
        return False
    t = (at - p[axis]) / (q[axis] - p[axis])
    hit = [a + t * (b - a) for a, b in zip(p, q)]
    return all(i == axis or box.low[i] <= hit[i] <= box.high[i] for i in range(3))


def segments_cross(a, b, p, q):
    """In the plane x-z."""
    def side(u, v, w):
        return (v[0] - u[0]) * (w[2] - u[2]) - (v[2] - u[2]) * (w[0] - u[0])
    return side(a, b, p) * side(a, b, q) <= 0 and side(p, q, a) * side(p, q, b) <= 0
