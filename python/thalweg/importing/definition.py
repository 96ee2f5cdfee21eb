"""What a GenCase definition draws, in order: the commands of its mainlist as bodies with a role, and remarks on those not understood."""

import math

from thalweg.faults import InputError
from thalweg.importing import geometry as geo
from thalweg.importing.drawn import Chain, Drawn, Filled
from thalweg.importing.expressions import Variables
from thalweg.importing.mesh_files import read_mesh

MOST_DRAWN = 5000
SILENT = {"setshapemode", "shapeout", "cellsout", "pointsmkout", "debugout", "printf", "setdpctes", "dpctessave", "dpctesload",
          "dpctesreset", "setnormalinvert", "setboxlimitmode", "exportvar", "setmknextfluid", "setmknextbound", "setmknextauto",
          "setfrdrawmode", "delvar", "newvarstr", "newvarstrcte", "setvarstr", "varssave", "varsload", "clipreset"}


class Definition:
    """The drawing of a definition. `remarks`: (line, text) of what was not understood."""

    def __init__(self, case, folder, shown):
        self.folder, self.shown = folder, shown
        self.drawn, self.remarks, self.variables = [], [], Variables()
        self.case = case
        self.matrix, self.saved, self.kind, self.mk, self.mode = geo.IDENTITY, [], "void", 0, "full"
        self.drawing, self.pen, self.depth = True, None, 0
        self._constants()
        self._lists = {node.get("name", ""): node for node in self._need("casedef/geometry/commands").all("list")}
        self.run(self._need("casedef/geometry/commands/mainlist"))
        initials = case.find("casedef/initials")
        for node in initials.children if initials else []:
            if not node.tag.startswith("_") and node.active():
                self._initial(node)

    def _need(self, path):
        node = self.case.find(path)
        if node is None:
            raise InputError(f"{self.shown}: has no <{path.split('/')[-1]}>; give a definition of GenCase (_Def.xml)")
        return node

    def where(self, node):
        return f"{self.shown}:{node.line}"

    def remark(self, node, text):
        self.remarks.append((node.line, text))

    def number(self, node, name, default=None):
        text = node.get(name) if node is not None else None
        if text is None:
            if default is None:
                raise InputError(f"{self.where(node)}: <{node.tag}> has no {name}; give it")
            return default
        return self.variables.number(text, self.where(node))

    def point(self, node, default=0.0):
        return tuple(self.number(node, axis, default) for axis in "xyz")

    def flag(self, node, name, default):
        return bool(self.number(node, name, float(default)))

    def _initial(self, node):
        """A body moved or turned after it was drawn."""
        kind = "bound" if node.get("mkbound") else "fluid"
        chosen = [each for each in self.drawn if isinstance(each, Drawn) and each.kind == kind and str(each.mk) == node.get(f"mk{kind}")]
        if node.tag == "move":
            matrix = geo.moved(self.point(node))
        elif node.tag == "rotateaxis":
            per = 1.0 if node.get("anglesunits", "degrees") == "degrees" else 180 / math.pi
            ends = [self.point(self._child(node, name)) for name in ("axisp1", "axisp2")]
            matrix = geo.rotated(per * self.number(node, "angle"), *ends)
        else:
            self.remark(node, f"<{node.tag}> at the start is not understood: water starts at rest, bodies where they are drawn")
            return
        for each in chosen:
            moved = geo.transformed(each.body, matrix)
            if moved is None:
                self.remark(node, f"<{node.tag}> of a line is not understood; it stays where it is drawn")
            else:
                each.body = moved

    def _constants(self):
        constants = self.case.find("casedef/constantsdef")
        for node in constants.children if constants else []:
            if node.get("value") is not None and not node.tag.startswith("_"):
                self.variables.set(node.tag, self.number(node, "value"))
        for node in (self.case.find("casedef/geometry/predefinition") or self.case).all("newvarcte"):
            self.set_variables(node)
        grid = self._need("casedef/geometry/definition")
        self.spacing = self.number(grid, "dp")
        if not 1e-6 <= self.spacing <= 100:
            raise InputError(f"{self.where(grid)}: dp is {self.spacing:g} m; give a spacing from 1e-6 to 100 m")
        self.variables.set("Dp", self.spacing)
        low, high = (self.point(self._need(f"casedef/geometry/definition/{name}")) for name in ("pointmin", "pointmax"))
        if any(a > b for a, b in zip(low, high)) or low[0] == high[0] or low[2] == high[2]:
            raise InputError(f"{self.where(grid)}: pointmin does not lie below pointmax; correct the two")
        self.limits, self.flat, self.plane = geo.Box(low, high), low[1] == high[1], low[1]
        for name, end in (("PosMin", low), ("PosMax", high)):
            for axis, value in zip("xyz", end):
                self.variables.set(f"{name}_{axis}", value)

    def set_variables(self, node):
        for name, text in node.attributes.items():
            if not name.startswith("_"):
                self.variables.set(name, self.variables.number(text, self.where(node)))

    def run(self, commands):
        self.depth += 1
        if self.depth > 20:
            raise InputError(f"{self.where(commands)}: lists call each other in a circle; break it")
        for node in commands.children:
            if not node.tag.startswith("_") and node.active():
                self._command(node)
                if len(self.drawn) > MOST_DRAWN:
                    raise InputError(f"{self.where(node)}: more than {MOST_DRAWN} bodies are drawn; import a part of them")
        self.depth -= 1

    def _command(self, node):
        method = getattr(self, f"do_{node.tag}", None)
        if method:
            method(node)
        elif node.tag.startswith(("draw", "fill")) and not self.drawing or node.tag in SILENT:
            return
        else:
            self.remark(node, f"<{node.tag}> is not understood and left out")

    # State of the drawing.

    def do_newvar(self, node):
        self.set_variables(node)

    do_newvarcte = do_setvar = do_newvar

    def do_setmkfluid(self, node):
        self.kind, self.mk = "fluid", int(self.number(node, "mk"))

    def do_setmkbound(self, node):
        self.kind, self.mk = "bound", int(self.number(node, "mk"))

    def do_setmkvoid(self, _):
        self.kind, self.mk = "void", 0

    def do_setdrawmode(self, node):
        self.mode = node.get("mode", "full").strip().lower()

    def do_setactive(self, node):
        self.drawing = self.flag(node, "drawpoints", True)

    def do_resetdraw(self, _):
        self.matrix, self.mode, self.drawing = geo.IDENTITY, "full", True

    def do_runlist(self, node):
        listed = self._lists.get(node.get("name", ""))
        if listed is None:
            raise InputError(f"{self.where(node)}: there is no list {node.get('name')}; correct the name")
        for _ in range(min(int(self.number(node, "times", 1)), MOST_DRAWN)):
            self.run(listed)

    def do_matrixreset(self, _):
        self.matrix = geo.IDENTITY

    def do_matrixsave(self, _):
        self.saved.append(self.matrix)

    def do_matrixload(self, _):
        self.matrix = self.saved.pop() if self.saved else geo.IDENTITY

    def do_move(self, node):
        self.matrix = geo.product(self.matrix, geo.moved(self.point(node)))

    def do_scale(self, node):
        self.matrix = geo.product(self.matrix, geo.scaled(self.point(node, 1.0)))

    def do_rotate(self, node):
        self.matrix = geo.product(self.matrix, geo.rotated(self.number(node, "ang"), (0, 0, 0), self.point(node)))

    def do_rotateline(self, node):
        begin, end = self._points(node, 2)
        self.matrix = geo.product(self.matrix, geo.rotated(self.number(node, "ang"), begin, end))

    def _points(self, node, least):
        points = [self.point(child) for child in node.all("point")]
        if len(points) < least:
            raise InputError(f"{self.where(node)}: <{node.tag}> has {len(points)} points; give {least}")
        return points

    # Bodies.

    def add(self, node, body, faces=None, **more):
        if self.drawing:
            self.drawn.append(Drawn(self.kind, self.mk, node.line, body, faces, node.get("objname", ""), **more))

    def placed(self, node, triangles):
        """A surface through the matrix."""
        surface = geo.Surface([tuple(geo.apply(self.matrix, p) for p in each) for each in triangles])
        self.add(node, surface, more_than_faces(surface, self.mode))

    def box_of(self, node):
        low = self.point(self._child(node, "point"))
        end = node.find("endpoint")
        high = self.point(end) if end else tuple(a + b for a, b in zip(low, self.point(self._child(node, "size"))))
        return geo.Box(tuple(map(min, low, high)), tuple(map(max, low, high)))

    def _child(self, node, tag):
        child = node.find(tag)
        if child is None:
            raise InputError(f"{self.where(node)}: <{node.tag}> has no <{tag}>; give it")
        return child

    def faces_of(self, node):
        """Names of the faces that are drawn; None if the box is solid."""
        words = self._child(node, "boxfill").text.replace("|", " ").replace("^", " ^ ").lower().split()
        faces, solid, out = set(), False, False
        for word in words:
            if word == "^":
                out = True
                continue
            if word not in (*geo.FACES, "solid", "all"):
                raise InputError(f"{self.where(node)}: there is no face {word}; give solid, all, {', '.join(geo.FACES)}")
            chosen = set(geo.FACES) if word == "all" else {word} & set(geo.FACES)
            faces, solid, out = (faces - chosen if out else faces | chosen), solid or word == "solid", False
        if solid:
            return None if self.mode in ("full", "solid") else set(geo.FACES)
        return faces

    def do_drawbox(self, node):
        box, faces = self.box_of(node), self.faces_of(node)
        if not geo.straight(self.matrix):
            surface = geo.Surface([tuple(geo.apply(self.matrix, p) for p in each) for each in box.triangles()])
            self.add(node, surface, faces)
            return
        low, high = (geo.apply(self.matrix, p) for p in (box.low, box.high))
        if faces is not None:  # a mirrored axis exchanges its two faces
            ends = {(axis, end if self.matrix[axis][axis] > 0 else 1 - end) for axis, end in (geo.FACES[f] for f in faces)}
            faces = {name for name, place in geo.FACES.items() if place in ends}
        self.add(node, geo.Box(tuple(map(min, low, high)), tuple(map(max, low, high))), faces)

    def _scale(self, node):
        factor = geo.uniform_scale(self.matrix)
        if factor is None:
            self.remark(node, f"<{node.tag}> is scaled differently along its axes and left out")
        return factor

    def do_drawsphere(self, node):
        factor = self._scale(node)
        if factor:
            center, radius = geo.apply(self.matrix, self._points(node, 1)[0]), factor * self.number(node, "radius")
            self.add(node, geo.Sphere(center, radius), hollow(self.mode))

    def do_drawcylinder(self, node):
        factor = self._scale(node)
        if factor:
            ends = [geo.apply(self.matrix, p) for p in self._points(node, 2)]
            self.add(node, geo.Cylinder(ends[0], ends[1], factor * self.number(node, "radius")), hollow(self.mode))

    def do_drawline(self, node):
        self.add(node, Chain([geo.apply(self.matrix, p) for p in self._points(node, 2)]))

    def do_drawlines(self, node):
        self.do_drawline(node)

    def do_setlinebegin(self, node):
        self.pen = geo.apply(self.matrix, self.point(node))

    def do_drawlineto(self, node):
        end = geo.apply(self.matrix, self.point(node))
        self.add(node, Chain([self.pen or end, end]))
        self.pen = end

    def do_drawtriangle(self, node):
        self.placed(node, [tuple(self._points(node, 3)[:3])])

    def do_drawquadri(self, node):
        a, b, c, d = self._points(node, 4)[:4]
        self.placed(node, [(a, b, c), (a, c, d)])

    def do_drawtrianglesstrip(self, node):
        points = self._points(node, 3)
        self.placed(node, list(zip(points, points[1:], points[2:])))

    def do_drawtrianglesfan(self, node):
        points = self._points(node, 3)
        self.placed(node, [(points[0], a, b) for a, b in zip(points[1:], points[2:])])

    do_drawpolygon = do_drawtrianglesfan

    def do_drawtriangles(self, node):
        points = [self.point(child) for child in self._child(node, "points").all("point")]
        corners = [tuple(int(x) for x in self.point(child)) for child in self._child(node, "triangles").all("triangle")]
        if any(not 0 <= k < len(points) for each in corners for k in each):
            raise InputError(f"{self.where(node)}: a triangle names a point that is not there; count points from 0")
        self.placed(node, [tuple(points[k] for k in each) for each in corners])

    do_drawfigure = do_drawtriangles

    def do_drawprism(self, node):
        points = self._points(node, 6)
        half = len(points) // 2
        below, above = points[:half], points[half:2 * half]
        self.placed(node, [*geo.fan(below[::-1]), *geo.fan(above), *geo.strip(below, above, True)])

    def do_drawpyramid(self, node):
        top, *base = self._points(node, 4)
        self.placed(node, [*geo.fan(base[::-1]), *((a, b, top) for a, b in zip(base, base[1:] + base[:1]))])

    def do_drawbeach(self, node):
        """The line of points in the plane x-z, drawn out along y from 0 to the y of the points."""
        points = self._points(node, 2)
        self.placed(node, geo.strip([(p[0], 0.0, p[2]) for p in points], points, False))

    def do_drawextrude(self, node):
        points, way = self._points(node, 2), self.point(self._child(node, "extrude"))
        further = [tuple(a + b for a, b in zip(p, way)) for p in points]
        closed = self.flag(node, "closed", False)
        ends = [*geo.fan(points[::-1]), *geo.fan(further)] if closed and self.mode != "face" else []
        self.placed(node, [*geo.strip(points, further, closed), *ends])

    def do_drawfilestl(self, node):
        self._file(node)

    do_drawfilevtk = do_drawfileply = do_drawfilestl

    def _file(self, node):
        matrix = self.matrix
        for child in node.children:
            if child.tag == "drawmove":
                matrix = geo.product(matrix, geo.moved(self.point(child)))
            elif child.tag not in ("drawrotate", "drawscale"):
                self.remark(child, f"<{child.tag}> of a file is not understood; the whole file is taken as it lies")
        for child in node.all("drawrotate"):
            for axis, name in enumerate(("angx", "angy", "angz")):
                end = tuple(float(axis == i) for i in range(3))
                matrix = geo.product(matrix, geo.rotated(-self.number(child, name, 0.0), (0, 0, 0), end))
        for child in node.all("drawscale"):
            matrix = geo.product(matrix, geo.scaled(self.point(child, 1.0)))
        file = self.folder / node.get("file", "").replace("\\", "/")
        triangles = read_mesh(file) if file.is_file() else None
        if triangles is None:
            self.remark(node, f"the file {node.get('file')} is {'of a kind that is not read' if file.is_file() else 'not there'}; "
                              "the body is left out")
            return
        surface = geo.Surface([tuple(geo.apply(matrix, p) for p in each) for each in triangles])
        whole = self.flag(node, "autofill", False) or self.kind == "fluid"
        self.add(node, surface, None if whole else set(geo.FACES), file=file.stem)

    # Filling from a seed.

    def do_fillbox(self, node):
        self._fill(node, self.box_of(node))

    def do_fillpoint(self, node):
        self._fill(node, None)

    do_fillvoidpoint = do_fillpoint

    def _fill(self, node, box):
        if not self.drawing:
            return
        modes = (node.find("modefill").text if node.find("modefill") else "void").replace("|", " ").lower().split()
        if modes != ["void"]:
            self.remark(node, f"<{node.tag}> fills {' and '.join(modes)}, not what is empty; left out")
            return
        if not geo.straight(self.matrix):
            self.remark(node, f"<{node.tag}> is turned and left out")
            return
        if box:
            low, high = (geo.apply(self.matrix, p) for p in (box.low, box.high))
            box = geo.Box(tuple(map(min, low, high)), tuple(map(max, low, high)))
        self.drawn.append(Filled(self.kind, self.mk, node.line, geo.apply(self.matrix, self.point(node)), box))


def hollow(mode):
    return set(geo.FACES) if mode in ("face", "wire") else None


def more_than_faces(surface, mode):
    """A surface is a body if it is closed and not only its faces are drawn."""
    return None if surface.closed and mode in ("full", "solid") else set(geo.FACES)
