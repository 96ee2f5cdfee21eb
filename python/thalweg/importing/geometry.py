"""Geometry of a definition: placements, bodies, and the side of them on which a point lies. Lengths in metres."""

import itertools
import math
from dataclasses import dataclass

IDENTITY = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0))
FACES = {"left": (0, 0), "right": (0, 1), "front": (1, 0), "back": (1, 1), "bottom": (2, 0), "top": (2, 1)}  # axis, end


def product(a, b):
    """The placement that does b first, then a; three rows of four."""
    rows = [*b, (0.0, 0.0, 0.0, 1.0)]
    return tuple(tuple(sum(a[i][k] * rows[k][j] for k in range(4)) for j in range(4)) for i in range(3))


def apply(m, p):
    return tuple(sum(m[i][k] * p[k] for k in range(3)) + m[i][3] for i in range(3))


def moved(v):
    return tuple((*IDENTITY[i][:3], float(v[i])) for i in range(3))


def scaled(v):
    return tuple(tuple(float(v[i]) if i == j else 0.0 for j in range(4)) for i in range(3))


def rotated(angle, begin, end):
    """About the line from begin to end. GenCase counts left-handed (JMatrix4.h of its solver: MatrixRot): `angle` [deg] as it does."""
    axis = [e - b for b, e in zip(begin, end)]
    length = math.sqrt(sum(a * a for a in axis)) or 1.0
    x, y, z = (a / length for a in axis)
    c, s = math.cos(math.radians(-angle)), math.sin(math.radians(-angle))
    t = 1 - c
    turn = ((t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0.0), (t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0.0),
            (t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0.0))
    return product(moved(begin), product(turn, moved([-b for b in begin])))


def straight(m):
    """Whether boxes along the axes stay so."""
    return all(abs(m[i][j]) < 1e-9 for i in range(3) for j in range(3) if i != j)


def uniform_scale(m):
    """The factor by which all lengths grow, or None if they do so differently."""
    lengths = [math.sqrt(sum(m[i][j] ** 2 for i in range(3))) for j in range(3)]
    return lengths[0] if max(lengths) - min(lengths) < 1e-6 * max(lengths) else None


@dataclass
class Box:
    low: tuple
    high: tuple

    def corners(self):
        return list(itertools.product(*zip(self.low, self.high)))

    def contains(self, p, by=0.0):
        return all(l - by <= x <= h + by for l, x, h in zip(self.low, p, self.high))

    def triangles(self):
        c = self.corners()  # number 4x + 2y + z
        quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
        return [tuple(c[q[k]] for k in each) for q in quads for each in ((0, 1, 2), (0, 2, 3))]


@dataclass
class Sphere:
    center: tuple
    radius: float

    def corners(self):
        return Box(*(tuple(c + sign * self.radius for c in self.center) for sign in (-1, 1))).corners()

    def contains(self, p, by=0.0):
        return math.dist(p, self.center) <= self.radius + by


@dataclass
class Cylinder:
    begin: tuple
    end: tuple
    radius: float

    def corners(self):
        low = tuple(min(a, b) - self.radius for a, b in zip(self.begin, self.end))
        return Box(low, tuple(max(a, b) + self.radius for a, b in zip(self.begin, self.end))).corners()

    def contains(self, p, by=0.0):
        axis = [e - b for b, e in zip(self.begin, self.end)]
        length = math.sqrt(sum(a * a for a in axis))
        if length == 0:
            return False
        along = sum(a * (x - b) for a, x, b in zip(axis, p, self.begin)) / length
        off = math.sqrt(max(0.0, sum((x - b) ** 2 for x, b in zip(p, self.begin)) - along * along))
        return -by <= along <= length + by and off <= self.radius + by


class Surface:
    """Triangles; `closed` if every edge has two of them."""

    def __init__(self, triangles):
        self.list = [tuple(tuple(map(float, p)) for p in each) for each in triangles]
        edges = {}
        for each in self.list:
            for a, b in zip(each, each[1:] + each[:1]):
                key = tuple(sorted((tuple(round(x, 9) for x in a), tuple(round(x, 9) for x in b))))
                edges[key] = edges.get(key, 0) + 1
        self.closed = bool(edges) and all(count == 2 for count in edges.values())

    def triangles(self):
        return self.list

    def corners(self):
        points = [p for each in self.list for p in each]
        return Box(*(tuple(extreme(p[i] for p in points) for i in range(3)) for extreme in (min, max))).corners()

    def contains(self, p, by=0.0):
        """Of a closed surface: whether a ray along x crosses it an odd number of times. The ray is shifted a little off edges."""
        if not self.closed:
            return False
        y, z = p[1] + 1.234567e-7, p[2] + 2.345678e-7
        return sum(_crosses(each, p[0], y, z) for each in self.list) % 2 == 1


def _crosses(triangle, x, y, z):
    (xa, ya, za), (xb, yb, zb), (xc, yc, zc) = triangle
    whole = (yb - ya) * (zc - za) - (yc - ya) * (zb - za)
    if whole == 0:
        return False
    v = ((y - ya) * (zc - za) - (yc - ya) * (z - za)) / whole
    w = ((yb - ya) * (z - za) - (y - ya) * (zb - za)) / whole
    return v >= 0 and w >= 0 and v + w <= 1 and xa + v * (xb - xa) + w * (xc - xa) > x


def transformed(body, m):
    """A body through a placement that keeps lengths."""
    if isinstance(body, Box) and straight(m):
        return bounds([apply(m, p) for p in (body.low, body.high)])
    if isinstance(body, Sphere):
        return Sphere(apply(m, body.center), body.radius)
    if isinstance(body, Cylinder):
        return Cylinder(apply(m, body.begin), apply(m, body.end), body.radius)
    if isinstance(body, (Box, Surface)):
        return Surface([tuple(apply(m, p) for p in each) for each in body.triangles()])
    return None


def bounds(points):
    """The box around points."""
    return Box(*(tuple(extreme(p[i] for p in points) for i in range(3)) for extreme in (min, max)))


def section(triangles, y):
    """The cut of triangles by the plane at y: chains of points (x, z), and whether each is closed."""
    y += 1.3e-9  # off the corners, which lie in the plane more often than not
    links = {}
    for each in triangles:
        cut = []
        for a, b in zip(each, each[1:] + each[:1]):
            if (a[1] < y) != (b[1] < y):
                t = (y - a[1]) / (b[1] - a[1])
                cut.append((round(a[0] + t * (b[0] - a[0]), 8), round(a[2] + t * (b[2] - a[2]), 8)))
        if len(cut) == 2 and cut[0] != cut[1]:
            links.setdefault(cut[0], []).append(cut[1])
            links.setdefault(cut[1], []).append(cut[0])
    chains = []
    while links:
        begin = next((p for p, to in links.items() if len(to) == 1), next(iter(links)))
        chain = [begin]
        while links.get(chain[-1]):
            here = chain[-1]
            there = links[here].pop()
            links[there].remove(here)
            chain.append(there)
        links = {p: to for p, to in links.items() if to}
        closed = len(chain) > 3 and chain[0] == chain[-1]
        chains.append((without_straight_corners(chain[:-1] if closed else chain, closed), closed))
    return chains


def without_straight_corners(chain, closed):
    """The chain without the corners at which it goes straight on."""
    kept = []
    for i, p in enumerate(chain):
        if not closed and i in (0, len(chain) - 1):
            kept.append(p)
            continue
        a, b = chain[i - 1], chain[(i + 1) % len(chain)]
        if abs((p[0] - a[0]) * (b[1] - p[1]) - (p[1] - a[1]) * (b[0] - p[0])) > 1e-12:
            kept.append(p)
    return kept


def fan(points):
    """Triangles of a convex polygon."""
    return [(points[0], a, b) for a, b in zip(points[1:], points[2:])]


def strip(one, other, closed):
    """Triangles between two lines of points, those without area left out."""
    pairs = list(zip(one, other))
    pairs = [*pairs, pairs[0]] if closed else pairs
    return [each for (a, c), (b, d) in zip(pairs, pairs[1:]) for each in ((a, b, d), (a, d, c)) if has_area(each)]


def has_area(triangle):
    a, b, c = triangle
    u, v = ([q - p for p, q in zip(a, end)] for end in (b, c))
    return math.sqrt(sum((u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) ** 2 for i in range(3))) > 1e-15
