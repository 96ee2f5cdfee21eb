"""Motions of a definition as the [[motion]] tables of a case: tables of ways or angles, or a rotation."""

import math
from dataclasses import dataclass

ROWS = 12          # of a table that is written into the case; a longer one becomes a CSV file
STEPS = 32         # rows in a period of a sine
MOST_ROWS = 20_000
UNMOVED = ("mvnull", "wait")


@dataclass
class Motion:
    name: str
    mk: int
    line: int
    keys: dict
    reach: float = 0.0  # [m] farthest way from the start, for the domain


class Motions:
    """The motions by the mk of the walls that follow them. `files`: name → text of the tables beside the case."""

    def __init__(self, definition, end):
        self.definition, self.end, self.of, self.files = definition, end, {}, {}
        root = definition.case.find("casedef/motion")
        for node in root.children if root else []:
            if node.tag == "objreal":
                self.object(node)
            elif node.tag == "obj" and not node.tag.startswith("_"):
                definition.remark(node, "<obj>, a motion that others ride on, is not understood; its bodies stand still")
        self.pistons()

    def number(self, node, name, default=None):
        return self.definition.number(node, name, default)

    def object(self, node):
        mk = int(self.number(node, "ref"))
        begins = node.all("begin")
        parts = {int(self.number(part, "id")): part for part in node.children if part.tag.startswith(("mv", "wait")) and part.get("id")}
        chosen = [part for part in parts.values() if part.tag not in UNMOVED]
        if not chosen:
            return  # a wall that a wave paddle or a coupling moves, or that stands still
        if len(begins) != 1 or node.all("objreal"):
            self.definition.remark(node, f"mk {mk}: several beginnings, or motions within motions, are not understood; it stands still")
            return
        begin = begins[0]
        start, finish = self.number(begin, "start", 0.0), self.number(begin, "finish", self.end)
        pieces, time, part, seen = [], start, parts.get(int(self.number(begin, "mov"))), 0
        while part is not None and time < min(finish, self.end) - 1e-12 and seen < 2000:
            duration = self.number(part, "duration", -1.0)
            until = min(finish, self.end, time + duration if duration > 0 else self.end)
            pieces.append((part, time, until))
            following = part.get("next")
            time, part, seen = until, parts.get(int(float(following))) if following else None, seen + 1
        try:
            motion = self.of_pieces(mk, node, pieces)
        except NotUnderstood as reason:
            self.definition.remark(reason.node, f"mk {mk}: {reason}; it stands still")
            return
        if motion:
            self.of[mk] = motion

    def of_pieces(self, mk, node, pieces):
        moving = [piece for piece in pieces if piece[0].tag not in UNMOVED]
        if not moving:
            return None
        if all(part.tag.startswith("mvrot") for part, _, _ in moving):
            return self.rotation(mk, node, pieces)
        rows, place = [(0.0, (0.0, 0.0, 0.0))], (0.0, 0.0, 0.0)
        for part, begin, until in pieces:
            ways = self.ways(part, until - begin)
            if begin > rows[-1][0] + 1e-12:
                rows.append((begin, place))
            rows += [(begin + t, tuple(p + w for p, w in zip(place, way))) for t, way in ways if begin + t > rows[-1][0] + 1e-12]
            place = rows[-1][1]
        farthest = max((p for _, p in rows), key=lambda p: math.hypot(*p))
        length = math.hypot(*farthest)
        if length == 0:
            return None
        along = tuple(x / length for x in farthest)
        off = max(math.dist(p, tuple(sum(a * b for a, b in zip(p, along)) * x for x in along)) for _, p in rows)
        if off > 1e-6 * length:
            raise NotUnderstood(node, "moves along more than one direction")
        ways = [(t, sum(a * b for a, b in zip(p, along))) for t, p in rows]
        keys = {"kind": "piecewise linear", "direction": self.flat_vector(along), **self.table(mk, ways, "displacement", "m")}
        return Motion(f"mk {mk}", mk, node.line, keys, length)

    def flat_vector(self, v):
        return [round(v[a], 9) + 0.0 for a in ((0, 2) if self.definition.flat else (0, 1, 2))]

    def table(self, mk, rows, what, unit):
        if len(rows) <= ROWS:
            return {"times": [f"{t:.9g} s" for t, _ in rows], f"{what}s": [f"{round(x, 9) + 0.0:.9g} {unit}" for _, x in rows]}
        name = f"motion_mk{mk}.csv"
        self.files[name] = f"time [s],{what} [{unit}]\n" + "".join(f"{t:.9g},{x:.9g}\n" for t, x in rows)
        return {"file": name}

    def vector(self, part, name):
        return self.definition.point(part.find(name)) if part.find(name) else (0.0, 0.0, 0.0)

    def ways(self, part, duration):
        """(time, way) from the beginning of a part on; without its first row (0, 0)."""
        if part.tag in UNMOVED:
            return [(duration, (0.0, 0.0, 0.0))]
        if part.tag == "mvrect":
            return [(duration, tuple(v * duration for v in self.vector(part, "vel")))]
        if part.tag == "mvrectace":
            begin, rise = self.vector(part, "velini"), self.vector(part, "ace")
            times = [duration * (i + 1) / STEPS for i in range(STEPS)]
            return [(t, tuple(v * t + a * t * t / 2 for v, a in zip(begin, rise))) for t in times]
        if part.tag == "mvrectsinu":
            return self.sines(part, duration)
        if part.tag in ("mvfile", "mvrectfile"):
            return self.read_ways(part, duration)
        raise NotUnderstood(part, f"<{part.tag}> is not understood")

    def sines(self, part, duration):
        often, far, phase = (self.vector(part, name) for name in ("freq", "ampl", "phase"))
        per = math.pi / 180 if part.get("anglesunits") == "degrees" else 1.0
        fastest = max((abs(f) for f, a in zip(often, far) if a), default=0.0)
        count = min(max(2, math.ceil(duration * fastest * STEPS)), MOST_ROWS)
        times = [duration * (i + 1) / count for i in range(count)]
        return [(t, tuple(a * (math.sin(2 * math.pi * f * t + per * p) - math.sin(per * p)) for f, a, p in zip(often, far, phase)))
                for t in times]

    def columns(self, part, indices):
        """Rows of chosen columns of the part's file, from its first time on."""
        file = part.find("file")
        path = self.definition.folder / (file.get("name", "") if file else "").replace("\\", "/")
        if not path.is_file():
            raise NotUnderstood(part, f"the file {path.name} is not there")
        rows = []
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines()[:MOST_ROWS]:
            cells = line.replace(";", " ").replace(",", " ").split()
            try:
                rows.append(tuple(float(cells[i]) if i is not None else 0.0 for i in indices))
            except (ValueError, IndexError):
                continue  # a heading or a remark
        if len(rows) < 2:
            raise NotUnderstood(part, f"the file {path.name} has no table")
        rows = [row for before, row in zip([(-math.inf,), *rows], rows) if row[0] > before[0]]
        return [(row[0] - rows[0][0], *(x - first for x, first in zip(row[1:], rows[0][1:]))) for row in rows]

    def read_ways(self, part, duration):
        file = part.find("file")
        indices = [int(self.number(file, f"field{name}")) if file and file.get(f"field{name}") else None for name in ("time", "x", "y", "z")]
        rows = self.columns(part, [indices[0] or 0, *indices[1:]])
        return [(row[0], row[1:]) for row in rows[1:] if row[0] <= duration + 1e-9]

    def rotation(self, mk, node, pieces):
        moving = [piece for piece in pieces if piece[0].tag not in UNMOVED]
        part, begin, until = moving[0]
        ends = [self.vector(part, name) for name in ("axisp1", "axisp2")]
        if any([self.vector(other, name) for name in ("axisp1", "axisp2")] != ends for other, _, _ in moving):
            raise NotUnderstood(node, "turns about more than one axis")
        axis = [b - a for a, b in zip(*ends)]
        length = math.hypot(*axis)
        if length == 0 or (self.definition.flat and abs(abs(axis[1]) - length) > 1e-9 * length):
            raise NotUnderstood(node, "has an axis that is not across the plane")
        # GenCase counts left-handed; in a plane a case counts counter-clockwise, x to the right and z upwards.
        sense = (1 if axis[1] > 0 else -1) if self.definition.flat else -1
        place = {"center": [f"{x:.9g} m" for x in self.flat_vector(ends[0])]}
        if not self.definition.flat:
            place["axis"] = self.flat_vector([a / length for a in axis])
        if len(moving) == 1 and part.tag == "mvrot" and until >= self.end - 1e-9:
            speed = sense * self.number(part.find("vel"), "ang") * self.degrees(part)
            return Motion(f"mk {mk}", mk, node.line, {"kind": "rotation", **place, "start": f"{begin:.9g} s",
                                                      "angular_speed": f"{speed:.9g} deg/s"})
        rows, angle = [(0.0, 0.0)], 0.0
        for part, begin, until in pieces:
            if begin > rows[-1][0] + 1e-12:
                rows.append((begin, angle))
            rows += [(begin + t, angle + sense * a) for t, a in self.angles(part, until - begin) if begin + t > rows[-1][0] + 1e-12]
            angle = rows[-1][1]
        return Motion(f"mk {mk}", mk, node.line, {"kind": "rotation", **place, **self.table(mk, rows, "angle", "deg")})

    @staticmethod
    def degrees(part):
        return 1.0 if part.get("anglesunits", "degrees") == "degrees" else 180 / math.pi

    def angles(self, part, duration):
        """(time, angle [deg], as GenCase counts it) from the beginning of a part on."""
        per = self.degrees(part)
        if part.tag in UNMOVED:
            return [(duration, 0.0)]
        if part.tag == "mvrot":
            return [(duration, per * duration * self.number(part.find("vel"), "ang"))]
        times = [duration * (i + 1) / STEPS for i in range(STEPS)]
        if part.tag == "mvrotace":
            begin, rise = (self.number(part.find(name), "ang", 0.0) * per if part.find(name) else 0.0 for name in ("velini", "ace"))
            return [(t, begin * t + rise * t * t / 2) for t in times]
        if part.tag == "mvrotsinu":
            often, far, phase = (self.number(part.find(name), "v", 0.0) if part.find(name) else 0.0 for name in ("freq", "ampl", "phase"))
            count = min(max(2, math.ceil(duration * abs(often) * STEPS)), MOST_ROWS)
            turn = math.radians(phase * per)
            return [(t, far * per * (math.sin(2 * math.pi * often * t + turn) - math.sin(turn)))
                    for t in (duration * (i + 1) / count for i in range(count))]
        if part.tag == "mvrotfile":
            return [(t, per * a) for t, a in self.columns(part, (0, 1))[1:] if t <= duration + 1e-9]
        raise NotUnderstood(part, f"<{part.tag}> is not understood")

    # Wave paddles.

    def pistons(self):
        special = self.definition.case.find("execution/special/wavepaddles")
        for node in special.children if special and special.active() else []:
            if node.tag.startswith("_"):
                continue
            if node.tag != "piston":
                self.definition.remark(node, f"the wave paddle <{node.tag}> is not understood; its walls stand still")
                continue
            mk = int(self.value(node, "mkbound"))
            depth, height, period = (self.value(node, name) for name in ("depth", "waveheight", "waveperiod"))
            if min(depth, height, period) <= 0:
                self.definition.remark(node, "the piston has no depth, height or period; its walls stand still")
                continue
            self.of[mk] = self.piston(node, mk, depth, height, period)
            for child in node.children:
                if child.tag.startswith("awas") or (child.tag == "waveorder" and self.number(child, "value", 1.0) > 1):
                    self.definition.remark(child, f"<{child.tag}>: the piston makes first-order waves and absorbs none")

    def value(self, node, name, default=0.0):
        return self.number(node.find(name), "value", default) if node.find(name) else default

    def piston(self, node, mk, depth, height, period):
        """Regular waves of first order: stroke = height / (2 (cosh 2kd - 1)/(sinh 2kd + 2kd)) (Biesel; Dean & Dalrymple 1991,
        eq. 6.25), with a linear ramp over some periods, smoothed by its square."""
        omega, g = 2 * math.pi / period, math.hypot(*self.definition.gravity) or 9.81
        k = omega * omega / g
        for _ in range(200):  # omega^2 = g k tanh(k d), by damped iteration
            k = (k + omega * omega / (g * math.tanh(max(k * depth, 1e-9)))) / 2
        two = 2 * k * depth
        share = 2 * (math.cosh(two) - 1) / (math.sinh(two) + two) if two < 300 else 2.0
        stroke = self.value(node, "gainstroke", 1.0) * height / share
        ramp, start = self.value(node, "ramp") * period, self.value(node, "start")
        duration = self.value(node, "duration") or self.end
        phase = math.pi * self.value(node, "phase")
        count = min(math.ceil((min(duration, self.end - start)) / period * STEPS), MOST_ROWS)
        rows = [(0.0, 0.0)] + ([(start, 0.0)] if start > 0 else [])
        for i in range(count):
            t = (i + 1) * period / STEPS
            grown = min(1.0, t / ramp) ** 2 if ramp > 0 else 1.0
            rows.append((start + t, grown * stroke / 2 * (math.sin(omega * t + phase) - math.sin(phase))))
        direction = self.definition.point(node.find("pistondir")) if node.find("pistondir") else (1.0, 0.0, 0.0)
        keys = {"kind": "piecewise linear", "direction": self.flat_vector(direction), **self.table(mk, rows, "displacement", "m")}
        return Motion(f"mk {mk}", mk, node.line, keys, stroke)


class NotUnderstood(Exception):
    """A motion for which a case has no counterpart; `node` is the element."""

    def __init__(self, node, text):
        super().__init__(text)
        self.node = node
