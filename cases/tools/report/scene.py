"""The last snapshot in space, the half of the ice in front of the body taken away: by VTK where it is installed and has a
screen, or xvfb-run in place of one; else by matplotlib."""
from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy
from matplotlib import pyplot
from matplotlib.collections import EllipseCollection, PolyCollection
from matplotlib.colors import Normalize

from diagnostics import Missing, Run
from diagnostics.cut import plane_of
from diagnostics.surface import placed, poses, read_stl, surface_path
from launcher.places import python_path

from .figure import embed, Picture, picture
from .views import ICE

FROM = (0.3, 0.4, 1.0)  # where the viewer is, seen from what is looked at
PATIENCE = 120  # with VTK [s]


@dataclass(frozen=True)
class Scene:
    """Spheres not nearer to the viewer than the body's axis: position, radius [m], speed [m/s]; triangles of the body [m];
    the time [s] and the plane z [m] of the cut."""

    time: float
    plane: float
    position: numpy.ndarray
    radius: numpy.ndarray
    speed: numpy.ndarray
    body: numpy.ndarray

    def fastest(self) -> float:
        """Upper end of the colours [m/s]: all but the fastest 0.2 % of the spheres are below."""
        return max(float(numpy.percentile(self.speed, 99.8)), 1e-6)


def scene(run: Run) -> Scene:
    """Of the last snapshot."""
    n, plane = len(run.particles.steps) - 1, plane_of(run)
    position, radius, velocity = run.particles.read(n, "position", "radius", "velocity")
    kept = position[:, 2] <= plane
    if not kept.any():
        raise Missing(f"{run.particles.path}: has no spheres behind the body.")
    time = float(run.particles.times[n])
    return Scene(time, plane, position[kept], radius[kept], numpy.linalg.norm(velocity[kept], axis=1), body_at(run, time))


def body_at(run: Run, time: float) -> numpy.ndarray:
    """Triangles of the body [m] at the row of the history nearest to a time; none without a body."""
    try:
        corners, (centre, attitude) = read_stl(surface_path(run)), poses(run)
    except Missing:
        return numpy.empty((0, 3, 3))
    row = int(numpy.argmin(numpy.abs(run.column("x").time - time)))
    return placed(corners.reshape(-1, 3), centre, attitude, row).reshape(-1, 3, 3)


def draw(run: Run, shape: str) -> Picture:
    """The picture of either, wide or half as wide as the page."""
    what = scene(run)
    text = f"{run.name}, {1e3 * what.time:.3g} ms, spheres coloured by speed up to {what.fastest():.3g} m/s"
    image = rendered(run)
    return picture(image, text, "png", shape=shape) if image else drawn(what, text, shape)


# ------------------------------------------------------------------------------------------------------------------- VTK
def screen() -> list[str] | None:
    """What to start VTK with so that it can draw; None where it is not installed or has nothing to draw on."""
    if not importlib.util.find_spec("vtkmodules"):
        return None
    if os.environ.get("DISPLAY"):
        return []
    return ["xvfb-run", "-a"] if shutil.which("xvfb-run") else None


def rendered(run: Run) -> bytes | None:
    """The image that scene_vtk.py makes; None where it cannot. In a process of its own: VTK aborts without a screen."""
    prefix = screen()
    if prefix is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        image = Path(folder, "scene.png")
        command = [*prefix, sys.executable, "-B", "-m", "report.scene_vtk", str(run.folder), str(image)]
        try:
            subprocess.run(command, env=dict(os.environ, PYTHONPATH=python_path()), capture_output=True, timeout=PATIENCE)
        except (OSError, subprocess.TimeoutExpired):
            return None
        return image.read_bytes() if image.is_file() else None


# ------------------------------------------------------------------------------------------------------------ matplotlib
def drawn(what: Scene, text: str, shape: str) -> Picture:
    """Spheres as discs, the farther ones first, then the near side of the body."""
    view = axes_of_view()
    figure, axis = pyplot.subplots(figsize=(11, 5.5))
    axis.grid(False)
    colours = Normalize(0, what.fastest())
    spheres(axis, what, view, colours)
    triangles(axis, what.body @ view.T)
    axis.set(aspect="equal")
    axis.autoscale_view()
    axis.axis("off")
    figure.colorbar(pyplot.cm.ScalarMappable(colours, ICE), ax=axis, label="speed of the spheres [m/s]", shrink=0.5, aspect=25)
    return embed(figure, text, "png", shape=shape)


def axes_of_view() -> numpy.ndarray:
    """Unit vectors of the picture: to the right, up, towards the viewer."""
    near = numpy.array(FROM) / numpy.linalg.norm(FROM)
    right = numpy.cross([0.0, 1.0, 0.0], near)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(near, right), near])


def spheres(axis, what: Scene, view: numpy.ndarray, colours: Normalize) -> None:
    """Discs, in millimetres of the picture."""
    seen = what.position @ view.T
    order = numpy.argsort(seen[:, 2])
    size = 2e3 * what.radius[order]
    axis.add_collection(EllipseCollection(size, size, numpy.zeros_like(size), units="xy", offsets=1e3 * seen[order, :2],
                                          offset_transform=axis.transData, array=what.speed[order], cmap=ICE, norm=colours,
                                          edgecolors="#5b5348", linewidths=0.25))


def triangles(axis, seen: numpy.ndarray) -> None:
    """The body's near side, shaded; n x 3 x 3 in the axes of the view."""
    normal = numpy.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
    near = normal[:, 2] > 0
    share = normal[near, 2] / numpy.maximum(numpy.linalg.norm(normal[near], axis=1), 1e-30)
    grey = numpy.outer(0.35 + 0.65 * share, numpy.array([0.42, 0.45, 0.49]))
    axis.add_collection(PolyCollection(1e3 * seen[near][:, :, :2], facecolors=grey, edgecolors=grey, linewidths=0.2))
