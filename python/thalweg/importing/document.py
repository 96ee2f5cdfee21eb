"""A definition of GenCase as the text of a case.toml, with the files beside it and remarks on all that has no counterpart."""

import math
import re
from dataclasses import dataclass, field

from thalweg.faults import InputError
from thalweg.importing import geometry as geo
from thalweg.importing.definition import Definition
from thalweg.importing.motions import Motions
from thalweg.importing.openings import Openings, gauges
from thalweg.importing.shapes import REACH, Shapes

MARGIN = 10         # spacings of room around all bodies: as long as the zones of inlets and outlets
ABOVE = 0.5         # of the height: room for splashes
KNOWN_SPECIALS = {"gauges", "inout", "wavepaddles", "savedt", "timeout", "outparts", "flexstrucs", "flexiblestructures", "boundcorr",
                  "boundextrap", "initialize", "nnphases"}
PERIODIC = re.compile(r"^([XYZ]{1,2})Periodic(?:Inc([XYZ]))?$")


@dataclass
class Imported:
    """A case that was imported: its name, text, files beside it (name → bytes), and remarks (line, text)."""
    name: str
    text: str
    files: dict
    remarks: list
    counts: dict = field(default_factory=dict)


def words(value):
    """A value as TOML."""
    if isinstance(value, list):
        return "[" + ", ".join(words(each) for each in value) + "]"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def table(title, keys, *comments):
    lines = [f"# {comment}" for comment in comments if comment]
    return "\n".join([*lines, title, *(f"{key} = {words(value)}" for key, value in keys.items())]) + "\n"


class Conversion:
    """One definition on its way. `root`: its XML; `shown`: its name in messages; rigid: floating bodies become fixed walls."""

    def __init__(self, root, folder, shown, rigid):
        self.root, self.shown = root, shown
        definition = self.definition = Definition(root, folder, shown)
        self.gravity = definition.gravity = definition.point(root.find("casedef/constantsdef/gravity")) \
            if root.find("casedef/constantsdef/gravity") else (0.0, 0.0, -9.81)
        self.parameters = {node.get("key"): node for node in (root.find("execution/parameters") or root).all("parameter") if node.active()}
        self.end = self.parameter("TimeMax", 1.0)
        self.floating(rigid)
        self.openings = Openings(definition)
        self.motions = Motions(definition, self.end)
        drawn = Shapes(definition, self.openings.mks, set(self.motions.of))
        self.shapes, self.meshes = drawn.list, drawn.files
        if not any(shape.role == "water" for shape in self.shapes):
            reasons = "; ".join(f"line {line}: {text}" for line, text in sorted(definition.remarks)[:1])
            raise InputError(f"{shown}: draws no fluid that fills a room{' (' + reasons + ')' if reasons else ''}; a case needs water, draw some")
        self.rest()
        self.zones()

    def parameter(self, key, default=None):
        node = self.parameters.get(key)
        return default if node is None else self.definition.number(node, "value", default)

    # What has no counterpart.

    def floating(self, rigid):
        bodies = [(node, "floats (<floating>)") for node in (self.root.find("casedef/floatings") or self.root).all("floating")]
        chrono = self.root.find("execution/special/chrono")
        bodies += [(node, "is moved by Chrono (<bodyfloating>)") for node in (chrono.all("bodyfloating") if chrono and chrono.active() else [])]
        for node, how in bodies:
            mk = node.get("mkbound", "?")
            if not rigid:
                raise InputError(f"{self.shown}:{node.line}: mk {mk} {how}, and a case has no bodies that water moves; "
                                 "--rigid makes them fixed walls")
            self.definition.remark(node, f"mk {mk} {how}: taken as a fixed wall, because of --rigid")

    def rest(self):
        """Remarks on what is left, by name."""
        definition = self.definition
        for tag in ("flexstrucs", "flexiblestructures"):
            found = self.root.find(f"execution/special/{tag}")
            for node in found.children if found and found.active() else []:
                if node.get("mkbound"):
                    definition.remark(node, f"mk {node.get('mkbound')} bends (<{node.tag}>): taken as a rigid wall")
        special = self.root.find("execution/special")
        for node in special.children if special else []:
            if node.tag not in KNOWN_SPECIALS and not node.tag.startswith("_") and node.active():
                definition.remark(node, f"<{node.tag}> is not understood and left out")
        phases = self.root.find("execution/special/nnphases")
        if phases:
            definition.remark(phases, "phases of several densities: all are water here; write sediment for those that are bed")

    # Tables.

    def periodic(self):
        axes = set()
        for key, node in self.parameters.items():
            found = PERIODIC.match(key or "")
            if found:
                axes |= set(found.group(1).lower())
                if found.group(2) and abs(self.definition.number(node, "value", 0.0)) > 0:
                    self.definition.remark(node, f"{key}: a period that goes up or down is not understood; drive the flow with [flow]")
        return sorted(axis for axis in axes if not (self.definition.flat and axis == "y"))

    def zones(self):
        """Walls that end at an opening go on under its zone, as long as they lie along the flow."""
        for opening in self.openings.list:
            axis = max(range(3), key=lambda a: abs(opening.way[a]))
            if abs(opening.way[axis]) < 0.999:
                continue
            out = (1 if opening.way[axis] > 0 else -1) * (-1 if opening.kind == "inlet" else 1)
            at, end = opening.at[axis], opening.at[axis] + out * 8 * self.definition.spacing
            index = {0: 0, 1: 1, 2: 1 if self.definition.flat else 2}[axis]
            for shape in self.shapes:
                room, key = shape.room, "to" if out > 0 else "from"
                if shape.role != "wall" or shape.kind != "box" or room is None:
                    continue
                face = (room.low, room.high)[out > 0][axis]
                far = (room.high, room.low)[out > 0][axis]
                if (face - at) * out >= -1e-9 - REACH * self.definition.spacing and (end - face) * out > 0 and (far - at) * out < 0:
                    ends = list(shape.keys[key])
                    ends[index] = f"{end:.9g} m"
                    shape.keys[key] = ends
                    shape.note = "; ".join(filter(None, (shape.note, f"goes on under the zone of {opening.keys['name']}")))

    def domain(self, periodic):
        rooms = [shape.room for shape in self.shapes if shape.room is not None]
        room = geo.bounds([p for each in rooms for p in (each.low, each.high)])
        inner = geo.bounds([p for shape in self.shapes if shape.role == "water" and shape.room
                            for p in (shape.room.low, shape.room.high)] or [room.low, room.high])
        margin = MARGIN * self.definition.spacing
        reach = max((motion.reach for motion in self.motions.of.values()), default=0.0)
        if any(motion.keys["kind"] == "rotation" for motion in self.motions.of.values()):
            reach = max(h - l for a, (l, h) in enumerate(zip(room.low, room.high)) if not (self.definition.flat and a == 1))
        low, high = [], []
        for axis, name in enumerate("xyz"):
            if name in periodic:
                low.append(inner.low[axis])
                high.append(inner.high[axis])
                continue
            low.append(room.low[axis] - margin - reach)
            above = ABOVE * (room.high[axis] - room.low[axis]) if axis == 2 else 0.0
            high.append(room.high[axis] + margin + reach + above)
        return low, high

    def text(self, name):
        definition = self.definition
        axes = (0, 2) if definition.flat else (0, 1, 2)
        periodic = self.periodic()
        low, high = self.domain(periodic)
        parts = [f"# Imported from {self.shown}, a definition of DualSPHysics' GenCase, by thalweg import. x, y and z are as they were"
                 + (";\n# the scene is the plane at y = " + f"{definition.plane:g} m.\n" if definition.flat else ".\n")
                 + "# Numerics are Thalweg's own: only the spacing is taken over.\n",
                 table("[case]", {"name": name, "title": name.replace("_", " "), "source": f"imported from {self.shown}",
                                  "dimension": 2 if definition.flat else 3}),
                 table("[domain]", {"from": [f"{low[a]:.9g} m" for a in axes], "to": [f"{high[a]:.9g} m" for a in axes],
                                    "gravity": [f"{self.gravity[a]:.9g} m/s^2" for a in axes],
                                    **({"periodic": periodic} if periodic else {})})]
        used = set()
        for shape in self.shapes:
            motion = self.motions.of.get(shape.mk) if shape.role == "wall" else None
            keys = {"name": shape.name, "kind": shape.kind, "role": "moving wall" if motion else shape.role}
            if motion:
                keys["motion"] = motion.name
                used.add(shape.mk)
            parts.append(table("[[shape]]", {**keys, **shape.keys}, f"mk {shape.mk}, line {shape.line}" + (f": {shape.note}" if shape.note else "")))
        for mk in sorted(set(self.motions.of) - used):
            definition.remarks.append((self.motions.of[mk].line, f"the motion of mk {mk} moves nothing that is drawn; left out"))
        parts += [table("[[motion]]", {"name": self.motions.of[mk].name, **self.motions.of[mk].keys}, f"line {self.motions.of[mk].line}")
                  for mk in sorted(used)]
        parts += [table(f"[[{each.kind}]]", each.keys, f"line {each.line}") for each in self.openings.list]
        corner = next((shape.room.low for shape in self.shapes if shape.role == "water" and shape.room), None)
        if corner:
            parts.append(table("[gencase]", {"anchor": "point", "anchor_point": [f"{corner[a]:.9g} m" for a in axes]},
                               "the lattice begins at the corner of the first water, as GenCase's does at whole spacings"))
        parts += [table("[materials.water]", self.water())]
        if self.openings.list and (self.gravity[2] >= 0 or math.hypot(*self.gravity[:2]) > 0):
            parts.append(table("[model]", {"turbulence": "off"}, "eddies are measured by the depth along gravity, which does not point along -z"))
        keys = {"spacing": f"{definition.spacing:.9g} m"}
        if math.hypot(*self.gravity) == 0:
            keys["maximum_speed"] = "1 m/s"
        parts += [table("[numerics]", keys, "" if math.hypot(*self.gravity) else "no gravity, from which a largest speed would follow: set it")]
        parts += [table("[[gauge]]", each.keys, f"line {each.line}") for each in gauges(definition)]
        out = self.parameter("TimeOut", self.end / 20)
        parts += [table("[output]", {"end": f"{self.end:.9g} s", "interval": f"{max(out, self.end / 1000):.9g} s"})]
        if definition.remarks:
            parts.append("# Not taken over:\n" + "".join(f"#   line {line}: {text}\n" for line, text in sorted(set(definition.remarks))))
        return "\n".join(parts)

    def water(self):
        constants = self.root.find("casedef/constantsdef/rhop0")
        density = self.definition.number(constants, "value", 1000.0) if constants else 1000.0
        keys = {"density": f"{density:.9g} kg/m^3"}
        laminar = self.parameter("ViscoTreatment", 1.0) in (2.0, 3.0)
        keys["viscosity"] = f"{density * self.parameter('Visco', 1e-6) if laminar else 0.001:.9g} Pa s"
        return keys


def convert(root, folder, shown, name, rigid=False):
    """The Imported case of a definition. `folder`: where files it names lie. Throws InputError."""
    if root.tag != "case":
        raise InputError(f"{shown}:{root.line}: begins with <{root.tag}>, not <case>; give a definition of GenCase (_Def.xml)")
    conversion = Conversion(root, folder, shown, rigid)
    text = conversion.text(name)
    files = {file: content.encode() for file, content in conversion.motions.files.items()}
    files |= conversion.meshes
    return Imported(name, text, files, sorted(set(conversion.definition.remarks)), {
        "shapes": len(conversion.shapes), "motions": text.count("[[motion]]"), "openings": len(conversion.openings.list),
        "gauges": text.count("[[gauge]]")})
