"""Renders the last snapshot of a run with VTK: python3 -m report.scene_vtk RUNFOLDER OUT.png (started by scene.py)."""
import sys

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401 (registers what rendering needs)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData, vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkClipPolyData, vtkContourFilter, vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from diagnostics import foam, Missing, Run

from .scene import FROM, Scene, scene
from .views import ICE

SIZE = (1500, 800)  # of the image [pixels]
FACETS = 1.5e6      # of all spheres together: a processor without a graphics card draws them in seconds


def made(kind: type, **settings):
    """An object of VTK with these settings; its constructors take none before version 9.3."""
    thing = kind()
    for name, value in settings.items():
        getattr(thing, f"Set{name}")(value)
    return thing


def spheres(what: Scene) -> vtkActor:
    """A glyph each, coloured by speed."""
    points, data = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(what.position, deep=True))
    data.SetPoints(points)
    for name, values in (("radius", what.radius), ("speed", what.speed)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    data.GetPointData().SetActiveScalars("radius")
    around = int(min(max((FACETS / len(what.radius)) ** 0.5, 8), 20))
    form = made(vtkSphereSource, Radius=1.0, ThetaResolution=around, PhiResolution=around)
    glyphs = made(vtkGlyph3D, ScaleFactor=1.0)
    glyphs.SetSourceConnection(form.GetOutputPort())
    glyphs.SetInputData(data)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(glyphs.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("speed")
    mapper.SetLookupTable(colours())
    mapper.SetScalarRange(0, what.fastest())
    return actor(mapper, (1, 1, 1))


def colours() -> vtkLookupTable:
    """The same as in the cuts."""
    table = made(vtkLookupTable, NumberOfTableValues=256)
    for n, colour in enumerate(ICE(numpy.linspace(0, 1, 256))):
        table.SetTableValue(n, *colour)
    return table


def body(what: Scene) -> vtkActor:
    """Its triangles."""
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(what.body.reshape(-1, 3), deep=True))
    for first in range(0, 3 * len(what.body), 3):
        cells.InsertNextCell(3, (first, first + 1, first + 2))
    data.SetPoints(points)
    data.SetPolys(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    return actor(mapper, (0.36, 0.39, 0.43))


def water(run: Run, what: Scene) -> vtkActor:
    """Its surface, where the water fraction is one half, behind the plane of the cut."""
    axes = foam.edges(run)
    name = min(foam.write_times(run), key=lambda item: abs(item[0] - what.time))[1]
    grid = made(vtkRectilinearGrid, Dimensions=[len(axis) for axis in axes])
    for put, axis in zip((grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates), axes):
        put(numpy_to_vtk(axis, deep=True))
    grid.GetCellData().SetScalars(numpy_to_vtk(foam.scalar_field(run, name, "alpha.water", axes).ravel(), deep=True))
    nodes, half, clip = vtkCellDataToPointData(), vtkContourFilter(), vtkClipPolyData()
    nodes.SetInputData(grid)
    half.SetInputConnection(nodes.GetOutputPort())
    half.SetValue(0, 0.5)
    clip.SetInputConnection(half.GetOutputPort())
    clip.SetClipFunction(made(vtkPlane, Origin=(0, 0, what.plane), Normal=(0, 0, -1)))
    mapper = made(vtkPolyDataMapper, ScalarVisibility=False)
    mapper.SetInputConnection(clip.GetOutputPort())
    surface = actor(mapper, (0.25, 0.5, 0.7))
    surface.GetProperty().SetOpacity(0.35)
    return surface


def actor(mapper: vtkPolyDataMapper, colour: tuple) -> vtkActor:
    """What is drawn, in a colour where its points have none."""
    thing = made(vtkActor, Mapper=mapper)
    thing.GetProperty().SetColor(*colour)
    return thing


def render(run: Run, path: str) -> None:
    """The image of the ice and the body; the water, if it can be read, reaches beyond its edges."""
    what = scene(run)
    renderer = made(vtkRenderer, Background=(1, 1, 1))
    renderer.AddActor(spheres(what))
    renderer.AddActor(body(what))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*FROM)
    camera.SetFocalPoint(0, 0, 0)
    renderer.ResetCamera()
    camera.Zoom(1.45)
    try:
        renderer.AddActor(water(run, what))
    except Missing:
        pass
    renderer.ResetCameraClippingRange()
    window = made(vtkRenderWindow, OffScreenRendering=True, Size=SIZE, MultiSamples=8)
    window.AddRenderer(renderer)
    window.Render()
    image, writer = made(vtkWindowToImageFilter, Input=window), made(vtkPNGWriter, FileName=path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    render(Run(sys.argv[1]), sys.argv[2])
