"""Inlets and outlets of a definition (special/inout) as [[inlet]] and [[outlet]], and its gauges as [[gauge]]."""

import math
import re
from dataclasses import dataclass

from thalweg.importing import geometry as geo
from thalweg.importing.drawn import Drawn

WAYS = {"right": (1, 0, 0), "left": (-1, 0, 0), "back": (0, 1, 0), "front": (0, -1, 0), "top": (0, 0, 1), "bottom": (0, 0, -1)}
FLOWS = {"l/s": 1e-3, "gal/s": 3.785411784e-3, "gal/min": 3.785411784e-3 / 60}  # [m^3/s], US gallons
POINTS = 9  # of a profile's table


@dataclass
class Table:
    """A table [[inlet]], [[outlet]] or [[gauge]]: its keys as they are written."""
    kind: str
    keys: dict
    line: int
    note: str = ""
    at: tuple = ()
    way: tuple = ()


class Openings:
    """The openings of a definition. `mks`: numbers of the fluids that only mark an opening."""

    def __init__(self, definition):
        self.definition, self.flat, self.list, self.mks = definition, definition.flat, [], set()
        root = definition.case.find("execution/special/inout")
        zones = [node for node in root.all("inoutzone") if node.active()] if root and root.active() else []
        for node in zones:
            self.zone(node)
        down = definition.gravity[2] < 0 and math.hypot(*definition.gravity[:2]) == 0
        for each in self.list:  # a pump needs an inlet, a level gravity straight down
            if each.keys.get("kind") == "pump" and not (down and any(other.kind == "inlet" for other in self.list)):
                each.keys["kind"] = "fall"

    def metres(self, p):
        return [f"{round(p[a], 9) + 0.0:.9g} m" for a in ((0, 2) if self.flat else (0, 1, 2))]

    def place(self, node):
        """(centre, direction of the water that comes in, height, width, diameter) of a zone; None if it is not understood."""
        number, point = self.definition.number, self.definition.point
        zone = node.find("zone2d") or node.find("zone3d")
        what = next((child for child in zone.children if not child.tag.startswith("_")), None) if zone else None
        if what is None or any(child.tag.startswith("rotate") for child in what.children):
            return None
        way = point(what.find("direction")) if what.find("direction") else None
        if what.tag == "line":
            a, b = point(what.find("point")), point(what.find("point2"))
            if way is None:
                way = (abs(b[2] - a[2]), 0.0, -(b[0] - a[0]))
            return tuple((p + q) / 2 for p, q in zip(a, b)), way, math.dist(a, b), 0.0, 0.0
        if what.tag == "circle":
            return point(what.find("point")), way, 0.0, 0.0, 2 * number(what.find("radius"), "v")
        if what.tag == "box":
            low, size = point(what.find("point")), point(what.find("size"))
            return self.of_box(geo.Box(low, tuple(a + b for a, b in zip(low, size))), way)
        if what.tag == "particles":
            mk, word = int(number(what, "mkfluid")), what.get("direction", "").lower()
            self.mks.add(mk)
            drawn = [each for each in self.definition.drawn if isinstance(each, Drawn) and each.kind == "fluid" and each.mk == mk
                     and isinstance(each.body, geo.Box) and each.faces and len(each.faces) == 1]
            if len(drawn) != 1 or (word not in WAYS and way is None):
                return None
            axis, end = geo.FACES[next(iter(drawn[0].faces))]
            low, high = list(drawn[0].body.low), list(drawn[0].body.high)
            low[axis] = high[axis] = (low, high)[end][axis]
            return self.of_box(geo.Box(tuple(low), tuple(high)), way or tuple(map(float, WAYS[word])))
        return None

    def of_box(self, box, way):
        """Of a rectangle across an axis: height upwards, or along x where the flow is vertical."""
        if way is None:
            return None
        axis = max(range(3), key=lambda a: abs(way[a]))
        up = 0 if axis == 2 else 2
        across = 3 - axis - up
        sizes = [h - l for l, h in zip(box.low, box.high)]
        middle = tuple((l + h) / 2 for l, h in zip(box.low, box.high))
        if self.flat:
            middle = (middle[0], self.definition.plane, middle[2])
        return middle, way, sizes[up], sizes[across], 0.0

    def zone(self, node):
        place = self.place(node)
        if place is None or place[1] is None or math.hypot(*place[1]) == 0:
            self.definition.remark(node, "the place of this in/out zone is not understood; the opening is left out")
            return
        at, way, height, width, diameter = place
        length = math.hypot(*way)
        way = tuple(w / length for w in way)
        keys = {"at": self.metres(at)}
        size = {"diameter": f"{diameter:.9g} m"} if diameter else {"height": f"{height:.9g} m"}
        if not self.flat and not diameter:
            size["width"] = f"{width:.9g} m"
        amount = self.velocity(node, at, height or diameter, way)
        inward = amount is not None and amount[1] > 0
        out_way = way if inward else tuple(-w for w in way)
        keys["direction"] = [round(out_way[a], 9) + 0.0 for a in ((0, 2) if self.flat else (0, 1, 2))]
        keys |= size
        level = self.level(node, at, height or diameter, way)
        if inward:
            keys |= amount[0]
            keys |= {"surface": "full"} if level is None else level
        elif level is not None and "level" in level or level is not None and "levels" in level:
            keys |= {"kind": "level", **{key: value for key, value in level.items() if key != "surface"}}
        else:
            full = not level and (amount is not None or self.has_fixed_surface(node))
            keys["kind"] = "pump" if full else "fall"
        number = sum(each.kind == ("inlet" if inward else "outlet") for each in self.list)
        kind = "inlet" if inward else "outlet"
        self.list.append(Table(kind, {"name": f"{kind}_{number + 1}", **keys}, node.line, at=at, way=out_way))

    def has_fixed_surface(self, node):
        found = node.find("imposezsurf")
        return found is not None and self.definition.number(found, "mode", 2.0) == 0

    def level(self, node, at, height, way):
        """Keys of the water's level in an opening; None if the water fills it, {} if nothing is said."""
        found = node.find("imposezsurf")
        if found is None or abs(way[2]) > 0.5:
            return None
        mode = int(self.definition.number(found, "mode", 0.0))
        bottom, top = at[2] - height / 2, at[2] + height / 2
        if mode == 0 and found.find("zsurf"):
            value = self.definition.number(found.find("zsurf"), "value")
            return {"surface": "level", "level": f"{value:.9g} m"} if bottom < value < top - self.definition.spacing / 2 else None
        if mode == 1 and found.find("zsurftimes"):
            rows = [(self.definition.number(row, "time"), self.definition.number(row, "zsurf")) for row in found.find("zsurftimes").children]
            return {"surface": "level", "times": [f"{t:.9g} s" for t, _ in rows], "levels": [f"{z:.9g} m" for _, z in rows]}
        if mode == 2:
            return {"surface": "follow"}
        self.definition.remark(found, "the level from a file is not understood; the opening is taken as full")
        return None

    def velocity(self, node, at, height, way):
        """(keys, mean velocity inwards [m/s]) of what is imposed; None where the velocity is extrapolated."""
        found = node.find("imposevelocity")
        mode = int(self.definition.number(found, "mode", 0.0)) if found else 2
        if mode == 2:
            return None
        children = {child.tag: child for child in found.children if child.active()}
        per, key = 1.0, ("velocity", "velocities", "m/s")
        if "flowvelocity" in children:
            per, key = FLOWS.get(children["flowvelocity"].get("units", "l/s"), 1e-3), ("flow_rate", "flow_rates", "m^3/s")
        fixed = next((children[tag] for tag in ("velocity", "velocity2", "velocity3") if tag in children), None)
        bottom = at[2] - height / 2
        if fixed is not None:
            mean, profile = self.profile(fixed, bottom, height, way)
            return {key[0]: f"{per * abs(mean):.9g} {key[2]}", **profile}, mean
        table = next((children[tag] for tag in ("velocitytimes", "velocitytimes2", "velocitytimes3") if tag in children), None)
        if table is None:
            self.definition.remark(found, "a velocity from a file, a grid or a jet is not understood; give one to this inlet")
            return {"velocity": "1 m/s"}, 1.0
        rows = [(self.definition.number(row, "time"), *self.profile(row, bottom, height, way)) for row in table.children]
        fastest = max(rows, key=lambda row: abs(row[1]))
        if any(row[1] * fastest[1] < 0 for row in rows):
            self.definition.remark(table, "the flow turns its direction, which an opening does not; it stands still meanwhile")
        amounts = [f"{per * max(0.0, math.copysign(1, fastest[1]) * mean):.9g} {key[2]}" for _, mean, _ in rows]
        return {"times": [f"{row[0]:.9g} s" for row in rows], key[1]: amounts, **fastest[2]}, fastest[1]

    def profile(self, node, bottom, height, way):
        """Mean velocity and the keys of the profile: uniform, linear through two points or a parabola through three."""
        number = self.definition.number
        names = [("v", "z"), ("v2", "z2"), ("v3", "z3")]
        given = [(number(node, z, 0.0), number(node, v)) for v, z in names if node.get(v) is not None]
        if len(given) == 1 or abs(way[2]) > 0.5 or len({z for z, _ in given}) < len(given):
            return given[0][1], {}

        def speed(z):  # Lagrange
            return sum(v * math.prod((z - w) / (u - w) for w, _ in given if w != u) for u, v in given)

        heights = [height * i / (POINTS - 1) for i in range(POINTS)]
        speeds = [speed(bottom + h) for h in heights]
        mean = sum((a + b) / 2 for a, b in zip(speeds, speeds[1:])) / (POINTS - 1)
        sign = 1 if mean >= 0 else -1
        return mean, {"profile": "table", "heights": [f"{h:.6g} m" for h in heights],
                      "speeds": [f"{max(0.0, sign * s):.6g} m/s" for s in speeds]}


def gauges(definition):
    """The gauges of a definition that a case has too."""
    root = definition.case.find("execution/special/gauges")
    found, names = [], set()
    for node in root.children if root and root.active() else []:
        if node.tag == "default" or node.tag.startswith("_") or not node.active():
            continue
        keys = _gauge(definition, node)
        if keys is None:
            definition.remark(node, f"the gauge <{node.tag}> {node.get('name', '')} is not understood; left out")
            continue
        base = re.sub(r"[^A-Za-z0-9_-]+", "_", node.get("name", "gauge")) or "gauge"
        name = next(n for n in (base, *(f"{base}_{k}" for k in range(2, 10_000))) if n not in names)
        names.add(name)
        found.append(Table("gauge", {"name": name, **keys}, node.line))
    return found


def _gauge(definition, node):
    place = node.find("point") or node.find("point0")
    if place is None or node.tag not in ("velocity", "swl", "maxz"):
        return None
    at = definition.point(place)
    if node.tag == "swl":
        end = definition.point(node.find("point2")) if node.find("point2") else at
        if math.dist(at[:2], end[:2]) > 1e-9:
            return None  # along a line that is not vertical
        at = (*at[:2], (at[2] + end[2]) / 2)
    kind = "velocity" if node.tag == "velocity" else "water level"
    return {"kind": kind, "at": [f"{at[a]:.9g} m" for a in ((0, 2) if definition.flat else (0, 1, 2))]}
