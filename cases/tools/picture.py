#!/usr/bin/env python3
"""A figure of a run in which a body falls through ice or water: picture.py RUNFOLDER OUT.png

Above, four cuts through the body's axis (the plane z = 0, y is up): water fraction, the spheres near the cut, the body.
Below, speed of the body, contact force and broken bonds against time.
Reads what a case with one blockMesh block leaves: foam/, dem/projectile.stl, history.csv and, if there, particles.h5.
"""
import re
import sys
from pathlib import Path

import checks

try:
    import h5py
    import numpy as np
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.collections import EllipseCollection
    from matplotlib.colors import LinearSegmentedColormap, Normalize
except ImportError as missing:
    sys.exit(f"picture: no figure, because {missing.name} is not installed")

WATER = LinearSegmentedColormap.from_list("water", ["#ffffff", "#cfe3f1", "#6fa8cf"])
ICE = LinearSegmentedColormap.from_list("ice", ["#f4f1e6", "#f6d98b", "#ee9a3a", "#c8371d", "#6d1010"])
BODY, INK = "#4a4f57", "#22262b"


# ------------------------------------------------------------------------------------------------------------ the fluid
def block(run):
    """Cell edges [m] along x, y and z of the one block of foam/system/blockMeshDict, with its multi-grading."""
    text = (run / "foam/system/blockMeshDict").read_text()
    corners = re.search(r"vertices\s*\((.*?)\)\s*;", text, re.S).group(1)
    corners = np.array([word.split() for word in re.findall(r"\(([^()]*)\)", corners)], float)
    counts = re.search(r"hex\s*\([^)]*\)\s*\(([^)]*)\)", text).group(1).split()
    grading = re.search(r"simpleGrading\s*\((.*)\)\s*\)\s*;", text).group(1)
    edges = []
    for low, axis in zip(corners.min(axis=0), re.findall(r"\(((?:\s*\([^()]*\))+)\s*\)", "(" + grading + ")")):
        points = [low]
        for length, cells, ratio in (map(float, word.split()) for word in re.findall(r"\(([^()]*)\)", axis)):
            sizes = np.geomspace(1.0, ratio, int(cells))
            points.extend(points[-1] + length * np.cumsum(sizes) / sizes.sum())
        edges.append(np.array(points))
    if [len(axis) - 1 for axis in edges] != [int(word) for word in counts]:
        sys.exit(f"picture: {run}/foam/system/blockMeshDict is not one block with a simpleGrading of stretches "
                 "(length cells ratio) along each axis")
    return edges


def moments(run):
    """[(time [s], folder)] of the fluid's write times, in order."""
    times = [path for path in (run / "foam").iterdir() if re.fullmatch(r"[\d.]+(e-?\d+)?", path.name)]
    times = sorted((float(path.name), path) for path in times if (path / "alpha.water").is_file())
    if len(times) < 4:
        sys.exit(f"picture: {run}/foam has {len(times)} times with alpha.water, four are needed; a parallel run keeps "
                 "them in processor*: frazil exec reconstructPar -case foam gathers them")
    return times


def scalars(path, shape):
    """Internal field of a volScalarField, ascii or binary, as an array [z, y, x]."""
    data = path.read_bytes()
    uniform = re.search(rb"internalField\s+uniform\s+([^;]+);", data)
    if uniform:
        return np.full(shape, float(uniform.group(1)))
    start = re.search(rb"internalField\s+nonuniform\s+List<scalar>\s+(\d+)\s*\(", data)
    count = int(start.group(1))
    if count != np.prod(shape):
        sys.exit(f"picture: {path} has {count} values, the block of blockMeshDict {np.prod(shape)} cells")
    if re.search(rb"format\s+binary", data[:1000]):
        return np.frombuffer(data, "<f8", count, start.end()).reshape(shape)
    return np.array(data[start.end():data.index(b")", start.end())].split(), float).reshape(shape)


def water_cut(path, edges):
    """(x, y, water fraction[y, x]) at the cell centres, interpolated across z to the plane z = 0."""
    x, y, z = (0.5 * (axis[1:] + axis[:-1]) for axis in edges)
    field = scalars(path / "alpha.water", (len(z), len(y), len(x)))
    behind = int(np.clip(np.searchsorted(z, 0.0) - 1, 0, len(z) - 2))
    share = np.clip(-z[behind] / (z[behind + 1] - z[behind]), 0.0, 1.0)
    return x, y, (1 - share) * field[behind] + share * field[behind + 1]


# ------------------------------------------------------------------------------------------------- spheres and the body
def spheres_near_cut(run, time, within):
    """Position, radius and speed of the spheres within one diameter of the plane z = 0, the farthest from the viewer
    first, at the snapshot nearest to `time`, at most `within` [s] away; None without particles.h5."""
    if not (run / "particles.h5").is_file():
        return None
    with h5py.File(run / "particles.h5", "r") as file:
        snapshot = min(file["particles"].values(), key=lambda group: abs(group.attrs["time"] - time))
        if abs(snapshot.attrs["time"] - time) > within:
            sys.exit(f"picture: {run}/particles.h5 has no snapshot within {within:.2g} s of time {time:g} s")
        position, radius, velocity = (np.array(snapshot[name]) for name in ("position", "radius", "velocity"))
    near = np.flatnonzero(np.abs(position[:, 2]) <= 2 * radius)
    near = near[np.argsort(position[near, 2])]
    return position[near], radius[near], np.linalg.norm(velocity[near], axis=1)


def turn(rotation):
    """Matrix of a rotation vector [rad] (Rodrigues)."""
    angle = np.linalg.norm(rotation)
    if angle == 0:
        return np.eye(3)
    a, b, c = rotation / angle
    cross = np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def poses(history):
    """Centre of mass [m] and attitude of the body at every row of the history; the attitude is first the STL's,
    then it is turned by the mean angular velocity of each step."""
    columns = lambda *names: np.column_stack([history[name] for name in names])
    centre, spin, time = columns("x", "y", "z"), columns("wx", "wy", "wz"), np.array(history["time"])
    attitude = [np.eye(3)]
    for n in range(1, len(time)):
        attitude.append(turn(0.5 * (spin[n - 1] + spin[n]) * (time[n] - time[n - 1])) @ attitude[-1])
    return centre, attitude


def corners_of(run):
    """Vertices [m] of dem/projectile.stl (ascii), as it lies at the start."""
    words = re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", (run / "dem/projectile.stl").read_text())
    return np.unique(np.array(words, float), axis=0)


def outline(points):
    """Convex hull of points in the plane, counter-clockwise (Andrew's monotone chain): the body is convex."""
    left = lambda a, b, c: (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])

    def chain(ordered):
        hull = []
        for p in ordered:
            while len(hull) > 1 and left(hull[-2], hull[-1], p) <= 0:
                hull.pop()
            hull.append(p)
        return hull[:-1]

    ordered = points[np.lexsort((points[:, 1], points[:, 0]))]
    return np.array(chain(ordered) + chain(ordered[::-1]))


# ----------------------------------------------------------------------------------------------------------- the figure
def choose(history, times):
    """Four write times: before the first contact, after the largest contact force, half-way to the end, the end."""
    time, force = np.array(history["time"]), np.array(history["contact_fy"])
    written = np.array([moment for moment, _ in times])
    if not np.any(force > 0):
        return [times[n] for n in np.linspace(0, len(times) - 1, 4).round().astype(int)]
    before = max(0, np.searchsorted(written, time[np.argmax(force > 0)]) - 1)
    hardest = min(np.searchsorted(written, time[np.argmax(force)]), len(times) - 3)
    return [times[n] for n in (before, hardest, (hardest + len(times) - 1) // 2, len(times) - 1)]


def view(axis, cut, spheres, body, colours):
    """One cut, in millimetres."""
    x, y, water = cut
    axis.contourf(1e3 * x, 1e3 * y, np.clip(water, 0, 1), levels=np.linspace(0, 1, 21), cmap=WATER)
    axis.contour(1e3 * x, 1e3 * y, water, levels=[0.5], colors="#2f6690", linewidths=0.9)
    if spheres is not None:
        position, radius, speed = spheres
        size = 2e3 * radius
        axis.add_collection(EllipseCollection(
            size, size, np.zeros_like(size), units="xy", offsets=1e3 * position[:, :2], offset_transform=axis.transData,
            array=speed, cmap=ICE, norm=colours, edgecolors="#5b5348", linewidths=0.45))
    axis.fill(*(1e3 * body.T), facecolor=BODY, edgecolor="black", linewidth=0.9, zorder=5)
    axis.set_aspect("equal")


def window(outlines, spheres):
    """Limits [mm] of the views: everything the body passes, three lengths of it wide."""
    low, high = (1e3 * limit for limit in (min(o[:, 1].min() for o in outlines), max(o[:, 1].max() for o in outlines)))
    half = 0.36 * (high - low)
    return (-half, half), (low - 0.2 * half, high + 0.15 * half)


def name_phases(axis, spheres):
    """Says in the first view which shade is what."""
    axis.text(0.04, 0.97, "air", transform=axis.transAxes, va="top", style="italic")
    axis.text(0.04, 0.36, "water", transform=axis.transAxes, va="top", style="italic")
    if spheres is not None:
        position, radius, _ = spheres
        top = 1e3 * (position[:, 1] + radius).max()
        axis.text(0.04, top + 2, "ice", transform=axis.get_yaxis_transform(), va="bottom", style="italic")


def views(figure, axes, run, history, chosen):
    """The upper row and its scale of colours."""
    centre, attitude = poses(history)
    corners, edges, time = corners_of(run), block(run), np.array(history["time"])
    rows = [int(np.argmin(np.abs(time - moment))) for moment, _ in chosen]
    bodies = [outline(((corners - centre[0]) @ attitude[row].T + centre[row])[:, :2]) for row in rows]
    apart = min(later - earlier for (earlier, _), (later, _) in zip(chosen, chosen[1:]))
    spheres = [spheres_near_cut(run, moment, 0.5 * apart) for moment, _ in chosen]
    colours = Normalize(0, 5 * np.ceil(0.2 * np.abs(history["vy"]).max() - 0.02))
    x, y = window(bodies, spheres)
    for axis, letter, (moment, path), near, body in zip(axes, "abcd", chosen, spheres, bodies):
        view(axis, water_cut(path, edges), near, body, colours)
        axis.set(xlim=x, ylim=y, xlabel="x [mm]")
        axis.set_title(f"({letter})  t = {1e3 * moment:.1f} ms", loc="left")
    axes[0].set_ylabel("height y [mm]")
    name_phases(axes[0], spheres[0])
    if spheres[0] is not None:
        scale = axes[0].inset_axes((0.12, 0.12, 0.76, 0.025))
        bar = figure.colorbar(pyplot.cm.ScalarMappable(colours, ICE), cax=scale, orientation="horizontal")
        bar.set_label("speed of the spheres [m/s]", labelpad=2)


def panels(history):
    """[(label, {name: (values, colour)})] of the lower row; without what the run has not."""
    length = lambda *names: np.sqrt(sum(np.square(history[name]) for name in names))
    rows = [("body speed [m/s]", {"": (length("vx", "vy", "vz"), INK)}),
            ("contact force [N]", {"": (length("contact_fx", "contact_fy", "contact_fz"), "#c8371d")}),
            ("broken bonds", {"in tension": (history["broken_tension"], "#2f6690"),
                              "in shear": (history["broken_shear"], "#ee9a3a")})]
    return [(label, lines) for label, lines in rows if any(np.any(np.nan_to_num(v)) for v, _ in lines.values())]


def curves(figure, history, chosen):
    """The lower row, with the times of the views marked."""
    time, rows = 1e3 * np.array(history["time"]), panels(history)
    for axis, letter, (label, lines) in zip(figure.subplots(1, len(rows), squeeze=False)[0], "efg", rows):
        for name, (values, colour) in lines.items():
            axis.plot(time, values, color=colour, label=name)
        axis.set(xlabel="time t [ms]", ylabel=label, xlim=(0, time[-1]), ylim=(0, None))
        axis.set_title(f"({letter})", loc="left", x=-0.043 * len(rows))
        if len(lines) > 1:
            axis.legend(frameon=False, loc="lower right")
        for name, (moment, _) in zip("abcd", chosen):
            axis.axvline(1e3 * moment, color="#7d8790", linewidth=0.8, linestyle=":", zorder=0)
            axis.text(1e3 * moment, 1.01, name, transform=axis.get_xaxis_transform(), ha="center", color="#5c656e",
                      fontsize=9)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: picture.py RUNFOLDER OUT.png")
    run, out = Path(sys.argv[1]), Path(sys.argv[2])
    history = checks.table(run / "history.csv")
    chosen = choose(history, moments(run))
    pyplot.rcParams.update({"font.size": 11, "axes.titlesize": 12, "axes.linewidth": 0.8, "axes.edgecolor": INK,
                            "lines.linewidth": 1.5})
    figure = pyplot.figure(figsize=(13.4, 8.6), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.08, h_pad=0.06)
    upper, lower = figure.subfigures(2, 1, height_ratios=(2.05, 1))
    views(upper, upper.subplots(1, 4, sharey=True), run, history, chosen)
    curves(lower, history, chosen)
    figure.savefig(out, dpi=120)


if __name__ == "__main__":
    main()
