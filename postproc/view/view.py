"""Opens this run in ParaView 5.11: paraview --script=view.py, or in a running ParaView: Tools, Python Shell, Run Script.

Pictures without a window: pvbatch view.py --pictures FOLDER [--times 0.25 0.5 …] [--width 1600] [--camera above]
(without --times: all of the run's times). Cameras of a 3-D run: oblique (default), above, side, upstream, downstream.

Water is coloured by its speed, sediment by its state or, without states, by its speed; walls are grey. Where the run has
surfaces, the bed is coloured by how far it has sunk or risen, and the water's surface lies over it like glass.
"""

import argparse
import pathlib
import re
import sys

from paraview.simple import (AnnotateTimeFilter, Clip, ColorBy, CreateView, GetColorTransferFunction, GetScalarBar,
                             OpenDataFile, Render, SaveScreenshot, SetActiveView, Show, Text, Threshold,
                             _DisableFirstRenderCameraReset)


def own_folder():
    """The folder of this script. ParaView's window runs it without telling its name, which then stands in the command line."""
    name = globals().get("__file__")
    if name is None:
        try:
            words = pathlib.Path("/proc/self/cmdline").read_text(encoding="utf-8").split("\0")
        except OSError:
            words = []
        name = next((word.partition("=")[2] for word in words if word.startswith("--script=")), "view.py")
    return pathlib.Path(name).resolve().parent


FOLDER = own_folder()
WATER, SEDIMENT = 2, 3
STATES = ["0", "sediment", "1", "deposit", "2", "bed load", "3", "suspended"]
STATE_COLOURS = [0.71, 0.58, 0.42, 0.71, 0.58, 0.42, 0.90, 0.62, 0.00, 0.84, 0.37, 0.00]
BLUES = [0, 0.78, 0.86, 0.94, 0.3, 0.62, 0.79, 0.88, 0.65, 0.19, 0.51, 0.74, 1, 0.03, 0.19, 0.42]
BLUE_TO_BROWN = [0, 0.78, 0.86, 0.94, 0.5, 0.80, 0.70, 0.55, 1, 0.50, 0.35, 0.15]
BROWNS = [0, 0.40, 0.29, 0.17, 0.5, 0.80, 0.52, 0.20, 1, 1.0, 0.85, 0.45]
# Share of the largest change: blue-green where the bed has sunk, brown where it has risen (ColorBrewer's BrBG).
SINK_AND_RISE = [-1, 0.00, 0.35, 0.32, -0.5, 0.35, 0.71, 0.67, 0, 0.96, 0.96, 0.94, 0.5, 0.75, 0.51, 0.18, 1, 0.33, 0.19, 0.02]
INK = [0.15, 0.15, 0.15]
WIDTH = 1600  # [pixels] of a picture
# Camera of a 3-D scene: the way from its middle to the camera, in sizes of the fluid, and which way is up.
CAMERAS = {"oblique": ((0.28, -1.09, 0.76), (0, 0, 1)), "above": ((0, 0, 1.3), (0, 1, 0)), "side": ((0, -1.45, 0.1), (0, 0, 1)),
           "upstream": ((-1.1, -0.1, 0.5), (0, 0, 1)), "downstream": ((1.1, -0.1, 0.5), (0, 0, 1))}


def stretched(points, largest):
    """The colours of a map whose places are shares of `largest`."""
    return [value * largest if index % 4 == 0 else value for index, value in enumerate(points)]


def font(view, size):
    """A size of text that is smaller in small pictures."""
    return max(9, round(size * min(1, view.ViewSize[0] / 1100)))


def legend(view, lookup, title, place):
    bar = GetScalarBar(lookup, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize = bar.LabelFontSize = font(view, 14)
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position = [place, 50 / view.ViewSize[1]]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.2, 10
    bar.AddRangeLabels = 0
    bar.Visibility = 1


def points_in(source):
    return source.GetDataInformation().GetNumberOfPoints()


def plain(shown, colour):
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = shown.AmbientColor = colour


def array_range(source, name):
    """Smallest and largest magnitude of a point array over the times read so far."""
    information = source.PointData.GetArray(name)
    return information.GetRange(-1 if information.GetNumberOfComponents() > 1 else 0)


def part(source, types, name):
    """The particles of some types."""
    chosen = Threshold(registrationName=name, Input=source)
    chosen.Scalars = ["POINTS", "Type"]
    chosen.ThresholdMethod = "Between"
    chosen.LowerThreshold, chosen.UpperThreshold = types
    return chosen


def drawn_as_spheres(shown, spacing, flat):
    shown.SetRepresentationType("Point Gaussian")
    shown.GaussianRadius = 0.6 * spacing
    shown.ShaderPreset = "Plain circle" if flat else "Sphere"
    shown.ScaleByArray = 0


def title_of(folder):
    """The case's title, or the folder's name; without tomllib, which the Python of older ParaViews lacks."""
    case = folder / "case.resolved.toml"
    found = re.search(r"""^title\s*=\s*['"](.+)['"]""", case.read_text(encoding="utf-8"), re.MULTILINE) if case.exists() else None
    return found.group(1) if found else folder.name


class Scene:
    """The run in one view."""

    def __init__(self, folder, camera="oblique", width=WIDTH):
        self.folder, self.camera, self.width = folder, camera, width
        self.particles = OpenDataFile(str(folder / "snapshots.pvd"))
        if self.particles is None:
            raise SystemExit(f"error: {folder}/snapshots.pvd cannot be opened; is {folder} the folder of a finished run?")
        self.times = list(self.particles.TimestepValues) or [0.0]
        _DisableFirstRenderCameraReset()
        self.view = CreateView("RenderView")
        SetActiveView(self.view)
        self.legends = []
        self.read_last()
        self.set_up_view()
        self.add_particles()
        self.frame()
        self.add_axes()
        self.add_texts()

    def read_last(self):
        """Ranges and sizes are those of the last time, which has the widest spread of a flow that began at rest."""
        self.view.ViewTime = self.times[-1]
        self.particles.UpdatePipeline(self.times[-1])
        fields = self.particles.FieldData
        self.spacing = fields.GetArray("Spacing").GetRange()[0]
        self.flat = fields.GetArray("Dimension").GetRange()[0] == 2
        self.names = {array.GetName() for array in self.particles.PointData}

    def set_up_view(self):
        self.view.OrientationAxesVisibility = 0
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [1, 1, 1]
        self.view.CameraParallelProjection = 1 if self.flat else 0

    def add_particles(self):
        self.water = part(self.particles, (WATER, WATER), "water")
        self.sediment = part(self.particles, (SEDIMENT, SEDIMENT), "sediment")
        self.measure()
        self.show_walls()
        if self.add_surfaces():
            return
        if "Concentration" in self.names and array_range(self.water, "Concentration")[1] > 0:
            self.show_by_concentration()
        elif points_in(self.water):
            self.show_by_speed(self.water, BLUES, "speed of the water [m/s]")
        if points_in(self.sediment):
            if "State" in self.names and array_range(self.sediment, "State")[1] > 0:
                self.show_by_state()
            else:
                self.show_by_speed(self.sediment, BROWNS, "speed of the sediment [m/s]")

    def measure(self):
        """The room the fluid takes up at the first and the last time."""
        boxes = []
        for time in (self.times[0], self.times[-1]):
            for source in (self.water, self.sediment):
                source.UpdatePipeline(time)
                if points_in(source):
                    boxes.append(source.GetDataInformation().GetBounds())
        self.low = [min(box[2 * axis] for box in boxes) for axis in range(3)]
        self.high = [max(box[2 * axis + 1] for box in boxes) for axis in range(3)]
        self.length, self.height = self.high[0] - self.low[0], self.high[2] - self.low[2]

    def add_surfaces(self):
        """In 3-D, where postproc has made them: the bed by its change of level under a water surface of glass."""
        bed, free = (self.folder / "surfaces" / f"{name}.pvd" for name in ("bed", "free_surface"))
        if self.flat or not bed.exists() or not free.exists():
            return False
        bed = OpenDataFile(str(bed))
        bed.UpdatePipeline(self.times[-1])
        largest = max(1e-3, *map(abs, array_range(bed, "BedLevelChange")))
        shown = Show(bed, self.view)
        ColorBy(shown, ("POINTS", "BedLevelChange"))
        lookup = GetColorTransferFunction("BedLevelChange")
        lookup.RGBPoints, lookup.ColorSpace = stretched(SINK_AND_RISE, largest), "RGB"
        lookup.NanColor = [0.8, 0.8, 0.8]
        self.legends.append((lookup, "bed risen (+), sunk (-) since the start [m]"))
        glass = Show(OpenDataFile(str(free)), self.view)
        plain(glass, [0.35, 0.6, 0.8])
        glass.Opacity = 0.35
        return True

    def show_by_speed(self, source, points, title):
        shown = Show(source, self.view)
        drawn_as_spheres(shown, self.spacing, self.flat)
        if source is self.sediment and "BedShear" in self.names:  # a bed that is a surface: it only rises and sinks
            plain(shown, STATE_COLOURS[:3])
            return
        ColorBy(shown, ("POINTS", "Velocity", "Magnitude"), separate=True)
        largest = max(array_range(source, "Velocity")[1], 1e-6)
        lookup = GetColorTransferFunction("Velocity", shown, separate=True)
        lookup.RGBPoints, lookup.ColorSpace = stretched(points, largest), "RGB"
        self.legends.append((lookup, title))

    def show_by_concentration(self):
        """Water by the share of its volume that grains take."""
        shown = Show(self.water, self.view)
        drawn_as_spheres(shown, self.spacing, self.flat)
        ColorBy(shown, ("POINTS", "Concentration"))
        largest = array_range(self.water, "Concentration")[1]
        lookup = GetColorTransferFunction("Concentration")
        lookup.RGBPoints, lookup.ColorSpace = stretched(BLUE_TO_BROWN, largest), "RGB"
        self.legends.append((lookup, "grains in the water [-]"))

    def show_by_state(self):
        shown = Show(self.sediment, self.view)
        drawn_as_spheres(shown, self.spacing, self.flat)
        ColorBy(shown, ("POINTS", "State"))
        lookup = GetColorTransferFunction("State")
        lookup.InterpretValuesAsCategories = 1
        lookup.Annotations = STATES[2:]
        lookup.IndexedColors = STATE_COLOURS[3:]
        self.legends.append((lookup, "state of the sediment"))

    def show_walls(self):
        """In 2-D what encloses the fluid; in 3-D only bodies in the flow, for the container would hide everything."""
        margin = 3 * self.spacing if self.flat else -self.spacing
        low = [self.low[0] - margin, self.low[1] - margin, self.low[2] - (margin if self.flat else 0)]
        top = self.high[2] + (margin if self.flat else 100 * self.height)
        walls = Clip(registrationName="walls", Input=part(self.particles, (0, 1), "all walls"), ClipType="Box")
        walls.ClipType.Position = low
        walls.ClipType.Length = [self.length + 2 * margin, self.high[1] - self.low[1] + 2 * margin, top - low[2]]
        walls.UpdatePipeline(self.times[-1])
        if points_in(walls):
            shown = Show(walls, self.view)
            drawn_as_spheres(shown, self.spacing, self.flat)
            plain(shown, [0.72, 0.72, 0.72])

    def add_axes(self):
        """Axes in metres around what is shown; in a plane there is no y."""
        grid = self.view.AxesGrid
        grid.Visibility = 1
        grid.XTitle, grid.YTitle, grid.ZTitle = ("x and z [m]", "", "") if self.flat else ("x [m]", "y [m]", "z [m]")
        grid.ShowGrid = 0
        grid.AxesToLabel = 0b000101 if self.flat else 0b000111  # once each, at the lower ends
        grid.CullFrontface, grid.CullBackface = (1, 0) if self.flat else (0, 1)
        for axis in "XYZ":
            setattr(grid, f"{axis}TitleColor", INK)
            setattr(grid, f"{axis}LabelColor", INK)
            setattr(grid, f"{axis}TitleFontSize", font(self.view, 14))
            setattr(grid, f"{axis}LabelFontSize", font(self.view, 12))
        grid.GridColor = INK

    def add_texts(self):
        clock = AnnotateTimeFilter(registrationName="time", Input=self.particles)
        clock.Format = "t = {time:.3f} s"
        self.text(Show(clock, self.view), "Upper Right Corner", 18)
        title = Text(registrationName="title")
        title.Text = title_of(self.folder) + "  (SPH, Thalweg)"
        self.text(Show(title, self.view), "Upper Left Corner", 16)
        for number, (lookup, name) in enumerate(self.legends):
            legend(self.view, lookup, name, 0.1 + 0.31 * number)

    def text(self, shown, place, size):
        shown.WindowLocation = place
        shown.FontSize = font(self.view, size)
        shown.Color = INK

    def frame(self):
        """The camera sees all of the fluid, of the first time and of the last."""
        view = self.view
        middle = [(low + high) / 2 for low, high in zip(self.low, self.high)]
        if self.flat:
            above, below, beside = 50, 160, 80  # [pixels] for the title, for axis and legends, for the axis
            walls = 6 * self.spacing
            metres = max((self.length + walls) / (self.width - 2 * beside), (self.height + walls) / (0.4 * self.width))  # in a pixel
            view.ViewSize = [self.width, int((self.height + walls) / metres) + above + below]
            view.CameraParallelScale = metres * view.ViewSize[1] / 2
            middle[2] -= (below - above) / 2 * metres
            view.CameraPosition = [middle[0], middle[1] - 10 * self.length, middle[2]]
        else:
            view.ViewSize = [self.width, self.width // 2]
            way, up = CAMERAS[self.camera]
            size = 0.8 * self.length + (self.high[1] - self.low[1]) + 0.5 * self.height  # of what is seen
            if self.camera == "above":
                middle[1] -= 0.08 * size  # room for the legends
            else:
                middle[2] -= (0.06 if self.camera == "oblique" else 0.12) * size
            view.CameraPosition = [m + w * size for m, w in zip(middle, way)]
            view.CameraViewUp = list(up)
        view.CameraFocalPoint = middle
        if self.flat:
            view.CameraViewUp = [0, 0, 1]


def save_pictures(scene, folder, times):
    folder.mkdir(parents=True, exist_ok=True)
    for wanted in times or scene.times:
        time = min(scene.times, key=lambda there: abs(there - wanted))
        scene.view.ViewTime = time
        Render(scene.view)
        SaveScreenshot(str(folder / f"t{time:.3f}.png"), scene.view)


def main(arguments):
    parser = argparse.ArgumentParser(prog="view.py", description=__doc__.splitlines()[0])
    parser.add_argument("--pictures", type=pathlib.Path, metavar="FOLDER", help="save a picture of each time there")
    parser.add_argument("--times", type=float, nargs="+", metavar="SECONDS", help="only of the times nearest to these")
    parser.add_argument("--width", type=int, default=WIDTH, help="width of a picture in pixels (default: %(default)s)")
    parser.add_argument("--camera", choices=sorted(CAMERAS), default="oblique", help="from where a 3-D run is seen (default: %(default)s)")
    options, _ = parser.parse_known_args(arguments)  # in its window ParaView's own words may stand here
    scene = Scene(FOLDER, options.camera, options.width)
    if options.pictures:
        save_pictures(scene, options.pictures, options.times)
    else:
        Render(scene.view)


main(sys.argv[1:])
