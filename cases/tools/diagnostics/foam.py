"""The fluid's mesh and fields, where the mesh is one blockMesh block: cell edges, write times, scalar fields; on any number
of ranks, without reconstructPar."""
from __future__ import annotations

import re
from pathlib import Path

import numpy

from .catalogue import Missing
from .run import Run


def edges(run: Run) -> list[numpy.ndarray]:
    """Cell edges [m] along x, y and z of the one block of foam/system/blockMeshDict, with its multi-grading."""
    text = run.text("foam/system/blockMeshDict")
    vertices = re.search(r"vertices\s*\((.*?)\)\s*;", text, re.S)
    block = re.search(r"hex\s*\([^)]*\)\s*\(([^)]*)\)\s*simpleGrading\s*\((.*?)\)\s*\)?\s*;", text, re.S)
    if not vertices or not block or text.count("hex") != 1:
        raise Missing(f"{run.folder}/foam/system/blockMeshDict: is not one block with a simpleGrading.")
    corners = numpy.array([words.split() for words in re.findall(r"\(([^()]*)\)", vertices.group(1))], float)
    counts = [int(word) for word in block.group(1).split()]
    stretches = re.findall(r"\(((?:\s*\([^()]*\))+)\s*\)", f"({block.group(2)})")
    if not stretches:  # one last/first per axis
        lengths = corners.max(axis=0) - corners.min(axis=0)
        stretches = [f"({length} {cells} {ratio})" for length, cells, ratio in zip(lengths, counts, block.group(2).split())]
    axes = [graded(low, axis) for low, axis in zip(corners.min(axis=0), stretches)]
    if [len(axis) - 1 for axis in axes] != counts:
        raise Missing(f"{run.folder}/foam/system/blockMeshDict: its simpleGrading does not make up the block's cells.")
    return axes


def graded(low: float, stretches: str) -> numpy.ndarray:
    """Edges [m] along one axis from its stretches `(length cells last/first)`."""
    points = [numpy.array([low])]
    for length, cells, ratio in (map(float, words.split()) for words in re.findall(r"\(([^()]*)\)", stretches)):
        sizes = numpy.geomspace(1.0, ratio, int(cells))
        points.append(points[-1][-1] + length * numpy.cumsum(sizes) / sizes.sum())
    return numpy.concatenate(points)


def parts(run: Run) -> list[Path]:
    """The folders that hold the times: foam, or foam/processor* of a run on several fluid ranks."""
    ranks = sorted((run.folder / "foam").glob("processor[0-9]*"), key=lambda path: int(path.name[9:]))
    return ranks or [run.folder / "foam"]


def write_times(run: Run, field: str = "alpha.water") -> list[tuple[float, str]]:
    """[(time [s], name of its folder)], in order, of the times at which every fluid rank has written the field."""
    names = [{path.parent.name for path in part.glob(f"[0-9]*/{field}")} for part in parts(run)]
    whole = [name for name in set.intersection(*names) if re.fullmatch(r"[\d.]+(e-?\d+)?", name)]
    if not whole:
        raise Missing(f"{run.folder}/foam: has no time with {field}.")
    return sorted((float(name), name) for name in whole)


def scalar_field(run: Run, time: str, field: str, axes: list[numpy.ndarray]) -> numpy.ndarray:
    """A volScalarField at the time folder of that name, as an array [z, y, x]."""
    shape = tuple(len(axis) - 1 for axis in reversed(axes))
    whole = numpy.full(numpy.prod(shape), numpy.nan)
    for part in parts(run):
        cells = addressing(part) if part.name != "foam" else slice(None)
        values = internal_field(part / time / field)
        expected = len(whole[cells])
        if values.size not in (1, expected):
            raise Missing(f"{part / time / field}: has {values.size} values for {expected} cells of the mesh; it is being "
                          "written, or the mesh is another one.")
        whole[cells] = values
    return whole.reshape(shape)


def addressing(part: Path) -> numpy.ndarray:
    """For each cell of a rank its number in the whole mesh, as decomposePar has written it."""
    return foam_list(part / "constant/polyMesh/cellProcAddressing", rb"(\d+)\s*\(", "<i4")


def internal_field(path: Path) -> numpy.ndarray:
    """Values of a volScalarField's cells; one value if it is uniform."""
    uniform = re.search(rb"internalField\s+uniform\s+([^;]+);", read(path))
    if uniform:
        return numpy.array([float(uniform.group(1))])
    return foam_list(path, rb"internalField\s+nonuniform\s+List<scalar>\s+(\d+)\s*\(", "<f8")


def foam_list(path: Path, start: bytes, kind: str) -> numpy.ndarray:
    """A list in OpenFOAM's ascii or binary form: behind `start`, which catches its length."""
    data = read(path)
    body = data.index(b"}") if b"FoamFile" in data else 0
    found = re.compile(start).search(data, body)
    if not found:
        raise Missing(f"{path}: holds no list of values; it is being written.")
    if not re.search(rb"format\s+binary", data[:1000]):
        return numpy.array(data[found.end():data.index(b")", found.end())].split(), numpy.dtype(kind))
    count = int(found.group(1))
    if len(data) < found.end() + count * numpy.dtype(kind).itemsize:
        raise Missing(f"{path}: ends before its {count} values; it is being written.")
    return numpy.frombuffer(data, kind, count, found.end())


def read(path: Path) -> bytes:
    """The whole file."""
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise Missing(f"{path}: does not exist.") from None
