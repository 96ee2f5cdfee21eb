"""Opens a run in the real ParaView 5.11, as a user would: tools/pvpython open_run.py RUN_FOLDER PICTURE_FOLDER

ParaView falls back silently: without TimeValue it shows file numbers for seconds, without Verts it draws nothing, and a
broken array only disappears from the list. So everything is asked of ParaView itself, not of our own reader.
"""

import pathlib
import sys
import unittest
import xml.etree.ElementTree

import numpy
from paraview import servermanager
from paraview.simple import (ColorBy, CreateView, Delete, GetColorTransferFunction, OpenDataFile, Render, ResetCamera,
                             SaveScreenshot, Show)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

run, pictures = (pathlib.Path(argument) for argument in sys.argv[1:3])

# Name: components, data type as VTK calls it (docs/file-formats.md).
ARRAYS = {"Id": (1, ("vtktypeint64", "long", "long long", "idtype")), "Type": (1, ("unsigned char", "vtktypeuint8")),
          "Velocity": (3, ("float",)), "Density": (1, ("float",)),
          "Pressure": (1, ("float",))}


def series_entries():
    """(time, file) of every entry of snapshots.pvd, read as plain XML."""
    collection = xml.etree.ElementTree.parse(run / "snapshots.pvd").getroot().find("Collection")
    return [(float(entry.get("timestep")), run / entry.get("file")) for entry in collection]


def open_file(name):
    source = OpenDataFile([str(path) for path in name] if isinstance(name, list) else str(name))
    if source is None:
        raise AssertionError(f"ParaView cannot open {name}")
    return source


def points_at(source, time):
    """The data set ParaView has at a time; a .pvd gives it as a multi-block or directly."""
    source.UpdatePipeline(time)
    data = servermanager.Fetch(source)
    if data.IsA("vtkMultiBlockDataSet"):
        blocks = [data.GetBlock(index) for index in range(data.GetNumberOfBlocks())]
        assert len(blocks) == 1, f"{len(blocks)} blocks"
        data = blocks[0]
    return data


def names_of(attributes):
    return [attributes.GetArrayName(index) for index in range(attributes.GetNumberOfArrays())]


class OpenedByParaView(unittest.TestCase):
    def check_particles(self, data, arrays):
        self.assertGreater(data.GetNumberOfPoints(), 100)
        self.assertEqual(data.GetNumberOfVerts(), data.GetNumberOfPoints(), "without Verts nothing is drawn")
        # Sediment has a state only where the model gives it one.
        if data.GetPointData().HasArray("State"):
            arrays = {**arrays, "State": (1, ("unsigned char", "vtktypeuint8"))}
        for name, (components, types) in arrays.items():
            with self.subTest(array=name):
                array = data.GetPointData().GetArray(name)
                self.assertIsNotNone(array, f"ParaView shows {names_of(data.GetPointData())}")
                self.assertEqual(array.GetNumberOfComponents(), components)
                self.assertIn(array.GetDataTypeAsString(), types)
                values = vtk_to_numpy(array)
                self.assertEqual(len(values), data.GetNumberOfPoints())
                self.assertFalse((values != values).any() or (abs(values.astype(float)) == float("inf")).any())
        self.assertTrue(data.GetPointData().HasArray("Mass") or data.GetFieldData().HasArray("Mass"))
        ids = vtk_to_numpy(data.GetPointData().GetArray("Id"))
        self.assertEqual(len(set(ids.tolist())), len(ids), "an Id occurs twice")

    def test_particles_at_the_start(self):
        source = open_file(run / "particles.vtp")
        data = points_at(source, 0.0)
        self.check_particles(data, ARRAYS)
        self.assertEqual(data.GetFieldData().GetArray("TimeValue").GetValue(0), 0.0)
        types = vtk_to_numpy(data.GetPointData().GetArray("Type"))
        self.assertEqual(set(types.tolist()), {0, 2, 3}, "wall, water and sediment")
        self.assertEqual(data.GetBounds()[2:4], (0.0, 0.0), "a 2-D scene lies in the plane y = 0")
        Delete(source)

    def test_series_shows_seconds(self):
        entries = series_entries()
        times = [time for time, _ in entries]
        self.assertGreaterEqual(len(times), 3)
        self.assertNotEqual(times, list(range(len(times))), "these are file numbers")
        source = open_file(run / "snapshots.pvd")
        self.assertEqual(len(source.TimestepValues), len(times))
        for shown, time in zip(source.TimestepValues, times):
            self.assertAlmostEqual(shown, time, delta=1e-9)
        counts = set()
        for time in times:
            with self.subTest(time=time):
                data = points_at(source, time)
                self.check_particles(data, ARRAYS)
                self.assertAlmostEqual(data.GetFieldData().GetArray("TimeValue").GetValue(0), time, delta=1e-9)
                counts.add(data.GetNumberOfPoints())
        Delete(source)

    def test_files_opened_as_a_group_show_seconds_too(self):
        entries = series_entries()
        source = open_file([path for _, path in entries])
        self.assertEqual([round(time, 9) for time in source.TimestepValues], [round(time, 9) for time, _ in entries])
        Delete(source)

    def test_water_has_moved(self):
        """The data of the first and the last time differ: the times are not one file shown twice."""
        entries = series_entries()
        source = open_file(run / "snapshots.pvd")
        rightmost = []
        for time in (entries[0][0], entries[-1][0]):
            data = points_at(source, time)
            water = vtk_to_numpy(data.GetPointData().GetArray("Type")) == 2
            rightmost.append(vtk_to_numpy(data.GetPoints().GetData())[water, 0].max())
        self.assertGreater(rightmost[1], rightmost[0] + 0.01, "the dam's water runs to the right")
        Delete(source)

    def test_a_picture_shows_particles(self):
        source = open_file(run / "snapshots.pvd")
        last = series_entries()[-1][0]
        view = CreateView("RenderView")
        view.ViewSize = [1200, 400]
        view.ViewTime = last
        view.CameraParallelProjection = 1
        shown = Show(source, view)
        shown.PointSize = 4
        ColorBy(shown, ("POINTS", "Pressure"))
        shown.RescaleTransferFunctionToDataRange(True)
        GetColorTransferFunction("Pressure")
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -10, 0], [0, 0, 0], [0, 0, 1]
        ResetCamera(view)
        Render(view)
        pictures.mkdir(parents=True, exist_ok=True)
        picture = pictures / "pressure.png"
        picture.unlink(missing_ok=True)
        SaveScreenshot(str(picture), view, ImageResolution=[1200, 400])
        Delete(view)  # while the display is still there
        Delete(source)
        reader = vtkPNGReader()
        reader.SetFileName(str(picture))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(-1, 3)
        colours, counts = numpy.unique(pixels, axis=0, return_counts=True)
        self.assertGreater(len(colours), 20, "pressure varies, so its colours do")
        self.assertLess(counts.max(), 0.999 * len(pixels), "the picture is empty")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
