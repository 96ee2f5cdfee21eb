"""Runs the view.py that postproc has left in a run's folder and looks at its pictures: tools/pvpython view_run.py RUN PICTURES

A script that fails inside ParaView still leaves a white window; so the pictures are looked at.
"""

import pathlib
import runpy
import shutil
import sys
import unittest

import numpy
from paraview.simple import Delete, GetRenderViews
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

run, pictures = (pathlib.Path(argument) for argument in sys.argv[1:3])
times = [0.0, 0.1]


def pixels_of(picture):
    """The part of a picture in which the scene is."""
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    rows = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3).astype(int)
    return rows[160:height - 50].reshape(-1, 3)  # from below: without the legends and the title


class View(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(pictures, ignore_errors=True)
        sys.argv = ["view.py", "--pictures", str(pictures), "--times", *map(str, times)]
        module = runpy.run_path(str(run / "view.py"), run_name="__main__")
        cls.cameras = module["CAMERAS"]
        cls.grids = [(view.AxesGrid.Visibility, view.AxesGrid.XTitle, list(view.ViewSize)) for view in GetRenderViews()]
        cls.pixels = {time: pixels_of(pictures / f"t{time:.3f}.png") for time in times}

        for view in GetRenderViews():
            Delete(view)  # while the display is still there

    def test_water_and_sediment_have_their_colours(self):
        """Blue where water stands, brown where the bed lies; each fills a good part of a picture of 2.5 m by 0.2 m."""
        for time, pixels in self.pixels.items():
            red, green, blue = pixels.T
            with self.subTest(time=time):
                self.assertGreater(numpy.mean((blue > red + 15) & (blue >= green)), 0.05, "water")
                self.assertGreater(numpy.mean((red > blue + 40) & (red > green)), 0.1, "sediment")
                self.assertGreater(numpy.mean(pixels.min(axis=1) > 250), 0.2, "background")

    def test_axes_and_size_are_as_asked(self):
        (visible, title, size), = self.grids
        self.assertEqual((visible, title, size[0]), (1, "x and z [m]", 1600))
        self.assertIn("above", self.cameras)

    def test_the_flow_is_seen_to_move(self):
        before, after = self.pixels.values()
        self.assertGreater(numpy.mean(numpy.abs(before - after).max(axis=1) > 30), 0.01)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
