"""Bodies of a definition as the [[shape]] tables of a case."""

import itertools
import re
from dataclasses import dataclass, field

from thalweg.importing import geometry as geo
from thalweg.importing.drawn import Chain, Drawn, Filled
from thalweg.importing.filling import common, fill
from thalweg.importing.mesh_files import stl

REACH = 4  # spacings: as far as the widest kernel of a case reaches; a wall of a case is that thick
ROLES = {"fluid": "water", "bound": "wall", "void": "empty"}
OPEN = {"left": "-x", "right": "+x", "front": "-y", "back": "+y", "bottom": "-z", "top": "+z"}


@dataclass
class Shape:
    """A table [[shape]]: its keys as they are written, and the room it takes."""
    name: str
    kind: str
    role: str
    keys: dict
    mk: int
    line: int
    room: object
    note: str = ""
    more: dict = field(default_factory=dict)


class Shapes:
    """The shapes of a definition, in its order. `files`: name → content of the meshes beside the case."""

    def __init__(self, definition, used_by_openings=(), moving=()):
        self.definition, self.flat, self.dp = definition, definition.flat, definition.spacing
        self.files, self.list, self.names, self.openings = {}, [], set(), set(used_by_openings)
        self.bodies = []  # what the drawing comes to, fillings as boxes
        self.container = None  # the hollow box that became one: a case has one, others are made of plates
        for each in self.joined(definition.drawn, moving):
            self.bodies.append(self.resolved(each) if isinstance(each, Filled) else each)
        corners = [p for each in self.bodies if isinstance(each, Drawn) for p in each.body.corners()]
        self.middle = tuple((l + h) / 2 for l, h in zip(*vars(geo.bounds(corners)).values())) if corners else (0, 0, 0)
        for each in self.bodies:
            self.emit(each)

    @staticmethod
    def joined(drawn, moving):
        """The bodies, hollow boxes in one place that stand still joined to one: sides and floor are often drawn apart."""
        kept = []
        for each in drawn:
            if isinstance(each, Drawn) and isinstance(each.body, geo.Box) and each.faces and each.kind == "bound" and each.mk not in moving:
                same = next((other for other in kept if isinstance(other, Drawn) and other.body == each.body and other.kind == "bound"
                             and other.faces and other.mk not in moving), None)
                if same:
                    same.faces = same.faces | each.faces
                    continue
            kept.append(each)
        return kept

    def resolved(self, filled):
        walls = [each for each in self.bodies if isinstance(each, Drawn) and each.kind == "bound"]
        box = fill(filled, walls, self.definition)
        return Drawn(filled.kind, filled.mk, filled.line, box) if box else filled

    # Who is where.

    def fluid_at(self, p):
        """Whether there is fluid at a point when all is drawn."""
        for each in reversed(self.bodies):
            if isinstance(each, Drawn) and each.faces is None and each.body.contains(p):
                return each.kind == "fluid"
        return False

    def fluid_inside(self, body):
        """Whether a hollow body holds fluid, or a seed from which it is filled."""
        seeds = [each.seed for each in self.bodies if isinstance(each, Filled)]
        if any(body.contains(seed) for seed in seeds):
            return True
        box = geo.bounds(body.corners())
        shares = [(i + 0.5) / 6 for i in range(6)]
        middle = [(self.definition.plane - box.low[1]) / ((box.high[1] - box.low[1]) or 1)] if self.flat else shares
        for share in itertools.product(shares, middle, shares):
            p = tuple(l + s * (h - l) for l, h, s in zip(box.low, box.high, share))
            if body.contains(p) and self.fluid_at(p):
                return True
        return False

    def fluid_beside(self, box, axis, end):
        """Whether fluid touches a face of a box from outside."""
        at = (box.low, box.high)[end][axis] + (1 if end else -1) * 0.75 * self.dp
        others = [a for a in range(3) if a != axis and not (self.flat and a == 1)]
        for shares in itertools.product([(i + 0.5) / 8 for i in range(8)], repeat=len(others)):
            p = [0.0, self.definition.plane, 0.0]
            p[axis] = at
            for a, share in zip(others, shares):
                p[a] = box.low[a] + share * (box.high[a] - box.low[a])
            if self.fluid_at(tuple(p)):
                return True
        return False

    # Writing.

    def metres(self, p):
        return [f"{round(p[a], 9) + 0.0:.9g} m" for a in ((0, 2) if self.flat else (0, 1, 2))]

    def add(self, each, kind, keys, room, note="", role=None):
        base = re.sub(r"[^\w -]+", " ", each.name).strip()[:40] or f"{role or ROLES[each.kind]} {each.mk}".replace("empty 0", "empty")
        name = next(n for n in itertools.chain([base], (f"{base}, {k}" for k in itertools.count(2))) if n not in self.names)
        self.names.add(name)
        self.list.append(Shape(name, kind, role or ROLES[each.kind], keys, each.mk, each.line, room, note))

    def emit(self, each):
        if isinstance(each, Filled):
            self.level(each)
        elif each.kind == "fluid" and each.faces is not None:
            if each.mk not in self.openings:
                self.remark(each, "draws only faces of water, which is no room for it; left out")
        elif each.kind == "void" and each.faces is not None:
            self.remark(each, "empties only faces; left out")
        elif self.outside_of_plane(each.body):
            return
        elif isinstance(each.body, geo.Box):
            self.box(each)
        elif isinstance(each.body, geo.Surface):
            self.surface(each)
        elif isinstance(each.body, Chain):
            self.chain(each, each.body.points)
        else:
            self.round(each)

    def remark(self, each, text):
        self.definition.remarks.append((each.line, text))

    def outside_of_plane(self, body):
        room = geo.bounds(body.corners())
        y = self.definition.plane
        return self.flat and not room.low[1] - 1e-9 <= y <= room.high[1] + 1e-9

    def level(self, filled):
        if filled.kind != "fluid":
            self.remark(filled, "fills a room that is no box, and not with water; left out")
            return
        top = filled.box.high[2] if filled.box else self.definition.limits.high[2]
        self.add(Drawn("fluid", filled.mk, filled.line, None), "level", {"level": f"{top:.9g} m"}, None,
                 "filled from a seed: the inside of the containers before it, or the hollows of the walls; look at it")

    def box(self, each):
        room = common(each.body, self.definition.limits) if not self.flat else common(
            geo.Box((each.body.low[0], self.definition.plane, each.body.low[2]), (each.body.high[0], self.definition.plane, each.body.high[2])),
            self.definition.limits)
        if room is None:
            return
        sizes = [h - l for a, (l, h) in enumerate(zip(room.low, room.high)) if not (self.flat and a == 1)]
        if each.kind == "bound" and each.faces is not None:
            self.faces(each, room)
        elif each.kind == "bound":
            room, note = self.thick(each, room)
            self.add(each, "box", {"from": self.metres(room.low), "to": self.metres(room.high)}, room, note)
        elif min(sizes) > 0.5 * self.dp:
            self.add(each, "box", {"from": self.metres(room.low), "to": self.metres(room.high)}, room)

    def thick(self, each, room):
        """A wall that is thinner than the kernel reaches grows away from the water."""
        low, high, notes = list(room.low), list(room.high), []
        for axis in (0, 2) if self.flat else (0, 1, 2):
            lack = REACH * self.dp - (high[axis] - low[axis])
            if lack <= 1e-9:
                continue
            wet = [self.fluid_beside(room, axis, end) for end in (0, 1)]
            if all(wet):
                notes.append("thinner than the kernel reaches, with water on both sides, which feels the other side through it")
                continue
            outer = 1 if wet[0] else 0 if wet[1] else int((low[axis] + high[axis]) / 2 > self.middle[axis])
            (high if outer else low)[axis] += lack if outer else -lack
            notes.append("made as thick as the kernel reaches, away from the water")
        return geo.Box(tuple(low), tuple(high)), "; ".join(dict.fromkeys(notes))

    def faces(self, each, room):
        names = {name for name in each.faces if not (self.flat and geo.FACES[name][0] == 1)}
        names = {name for name in names if self.within_limits(each.body, *geo.FACES[name])}
        whole = 4 if self.flat else 6
        thin = any(h - l < 0.5 * self.dp for a, (l, h) in enumerate(zip(room.low, room.high)) if not (self.flat and a == 1))
        keys = {"from": self.metres(room.low), "to": self.metres(room.high)}
        basin = "top" not in names and len(names) >= whole - 2 and self.is_basin(each)
        if not thin and names and (basin or self.fluid_inside(each.body)):
            if self.container is None:
                missing = [OPEN[name] for name in geo.FACES if name not in names and not (self.flat and geo.FACES[name][0] == 1)]
                self.container = each
                self.add(each, "box", {"side": "outside", **keys, **({"open": missing} if missing else {})}, self.around(room))
                return
        elif not thin and len(names) >= whole - 2:
            self.add(each, "box", keys, room, "a hollow box without water inside, taken as solid")
            return
        for name in sorted(names):
            self.plate(each, room, names, *geo.FACES[name])

    def within_limits(self, box, axis, end):
        limits = self.definition.limits
        return box.low[axis] >= limits.low[axis] - 1e-9 if end == 0 else box.high[axis] <= limits.high[axis] + 1e-9

    def is_basin(self, each):
        """A hollow box open at its top that nothing was cut out for: a dry basin, not a building."""
        middle = tuple((l + h) / 2 for l, h in zip(each.body.low, each.body.high))
        return not any(isinstance(other, Drawn) and other.kind == "void" and other.faces is None and other.body.contains(middle)
                       for other in self.bodies)

    def around(self, room):
        return geo.Box(*(tuple(x + sign * REACH * self.dp for x in p) for p, sign in ((room.low, -1), (room.high, 1))))

    def plate(self, each, room, names, axis, end):
        at = (room.low, room.high)[end][axis]
        low, high = list(room.low), list(room.high)
        for name in names:  # plates meet behind their edges
            other, side = geo.FACES[name]
            if other != axis:
                (high if side else low)[other] += (1 if side else -1) * REACH * self.dp
        low[axis] = high[axis] = at
        flat_face = geo.Box(tuple(low), tuple(high))
        behind = tuple(at + (-1 if end else 1) * self.dp / 2 if a == axis else (l + h) / 2 for a, (l, h) in enumerate(zip(room.low, room.high)))
        if any(shape.role == "wall" and shape.room and "side" not in shape.keys and shape.room.contains(behind) for shape in self.list):
            return  # the face of a body that is solid already
        wet = [self.fluid_beside(flat_face, axis, side) for side in (0, 1)]
        outer = end if wet[0] == wet[1] else (1 if wet[0] else 0)
        low, high = list(flat_face.low), list(flat_face.high)
        (high if outer else low)[axis] += (1 if outer else -1) * REACH * self.dp
        room = geo.Box(tuple(low), tuple(high))
        self.add(each, "box", {"from": self.metres(low), "to": self.metres(high)}, room, "a face, made as thick as the kernel reaches")

    def round(self, each):
        body, note = each.body, ""
        outside = {"side": "outside"} if each.kind == "bound" and each.faces is not None and self.fluid_inside(body) else {}
        room = geo.bounds(body.corners())
        room = self.around(room) if outside else room
        if isinstance(body, geo.Sphere):
            radius = body.radius
            if self.flat:
                radius = (radius ** 2 - (body.center[1] - self.definition.plane) ** 2) ** 0.5
            self.add(each, "sphere", {**outside, "center": self.metres(body.center), "radius": f"{radius:.9g} m"}, room, note)
        elif not self.flat:
            self.add(each, "cylinder", {**outside, "from": self.metres(body.begin), "to": self.metres(body.end),
                                        "radius": f"{body.radius:.9g} m"}, room)
        elif abs(body.begin[0] - body.end[0]) + abs(body.begin[2] - body.end[2]) < 1e-9:
            self.add(each, "cylinder", {**outside, "center": self.metres(body.begin), "radius": f"{body.radius:.9g} m"}, room)
        else:
            self.remark(each, "is a cylinder that lies in the plane of a 2-D scene; left out, draw it as a box")

    def surface(self, each):
        body = each.body
        if self.flat:
            for points, closed in geo.section(body.triangles(), self.definition.plane):
                if closed:
                    self.polygon(each, points)
                else:
                    self.chain(each, [(x, self.definition.plane, z) for x, z in points])
            return
        hollow = each.kind == "bound" and each.faces is not None
        side = {} if not hollow else {"side": "outside"} if body.closed and self.fluid_inside(body) else {} if body.closed else {"side": "both"}
        if each.kind != "bound" and not body.closed:
            self.remark(each, "is a surface with a rim, which bounds no volume; left out")
            return
        base = f"{each.file or 'mesh'}_{each.mk}"
        file = next(n for n in (f"{base}{end}.stl" for end in itertools.chain([""], (f"_{k}" for k in itertools.count(2))))
                    if n not in self.files)
        self.files[file] = stl(body.triangles(), file)
        room = geo.bounds(body.corners())
        self.add(each, "mesh", {**side, "file": file}, self.around(room) if side else room)

    def polygon(self, each, points):
        corners = [(x, self.definition.plane, z) for x, z in points]
        hollow = each.kind == "bound" and each.faces is not None
        outside = {"side": "outside"} if hollow and self.fluid_inside_polygon(points) else {}
        self.add(each, "prism", {**outside, "polygon": [self.metres(p) for p in corners]}, self.around(geo.bounds(corners)))

    def fluid_inside_polygon(self, points):
        x, z = (sum(p[i] for p in points) / len(points) for i in (0, 1))
        seeds = [each for each in self.bodies if isinstance(each, Filled)]
        return self.fluid_at((x, self.definition.plane, z)) or bool(seeds)

    def chain(self, each, points):
        """A line in the plane: a wall as thick as the kernel reaches, on the side away from the water."""
        if not self.flat or each.kind != "bound":
            self.remark(each, "is a line, which has no volume; left out, draw it as a box")
            return
        points = [(p[0], p[2]) for p in points]
        wet = {1: 0, -1: 0}
        for a, b in zip(points, points[1:]):
            length = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5 or 1.0
            left = (-(b[1] - a[1]) / length, (b[0] - a[0]) / length)
            for share, side in itertools.product((0.1, 0.3, 0.5, 0.7, 0.9), wet):
                p = [a[i] + share * (b[i] - a[i]) + side * 1.5 * self.dp * left[i] for i in (0, 1)]
                wet[side] += self.fluid_at((p[0], self.definition.plane, p[1]))
        # Left of the line where the water is on its right; without water below a line that runs along, as a floor is.
        side = 1 if wet[-1] > wet[1] else -1 if wet[1] > wet[-1] else (-1 if points[-1][0] >= points[0][0] else 1)
        outer = offset(points, side * REACH * self.dp)
        for (a, b), (d, c) in zip(zip(points, points[1:]), zip(outer, outer[1:])):
            corners = [(p[0], self.definition.plane, p[1]) for p in (a, b, c, d)]
            self.add(each, "prism", {"polygon": [self.metres(p) for p in corners]}, geo.bounds(corners),
                     "a line, made as thick as the kernel reaches")


def offset(points, by):
    """The points of a line moved to its left, where two parts meet along their bisector."""
    normals = []
    for a, b in zip(points, points[1:]):
        length = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5 or 1.0
        normals.append((-(b[1] - a[1]) / length, (b[0] - a[0]) / length))
    moved = []
    for i, p in enumerate(points):
        m, n = normals[max(i - 1, 0)], normals[min(i, len(normals) - 1)]
        share = max(1 + m[0] * n[0] + m[1] * n[1], 0.3)
        moved.append(tuple(p[k] + by * (m[k] + n[k]) / share for k in (0, 1)))
    return moved
