"""Fields of OpenFOAM's time folders as numpy arrays (writeFormat binary), and how far two folders are apart."""

import pathlib
import re

import numpy as np

# Values per entry and numpy type of what OpenFOAM writes as a list (labels of 32, scalars of 64 bits)
KINDS = {
    "label": (1, "<i4"), "scalar": (1, "<f8"), "vector": (3, "<f8"), "symmTensor": (6, "<f8"), "tensor": (9, "<f8")
}

FIELD_BLOCK = re.compile(rb"\buniform\s+([^;]+);|\bnonuniform\s+List<(\w+)>\s*(\d+)(?:\s*\(|;)")
BARE_LIST = re.compile(rb"\n(\d+)\s*\(")


def class_of(data):
    """The class a file's header names; empty without a header."""
    found = re.search(rb"\bclass\s+(\w+);", data[:2000])
    return found.group(1).decode() if found else ""


def one_list(data, kind, count, start):
    """The binary list that begins at start, and where it ends."""
    width, dtype = KINDS[kind]
    values = np.frombuffer(data, dtype, int(count)*width, start)
    return values.astype(float), start + values.nbytes


def blocks(path):
    """All uniform values and lists of a field file, or the one list of a mesh file, each flat."""
    data = pathlib.Path(path).read_bytes()
    name = class_of(data)
    if re.match(r"(vol|surface|point)\w+Field$", name):
        return field_blocks(data)
    kind = re.match(r"(label|vector)(List|Field)$", name)
    found = BARE_LIST.search(data)
    return [one_list(data, kind.group(1), found.group(1), found.end())[0]] if kind and found else []


def field_blocks(data):
    """Internal and boundary values in the order of the file; the search jumps over the bytes of each list."""
    result, position = [], 0
    while True:
        found = FIELD_BLOCK.search(data, position)
        if not found:
            return result
        uniform, kind, count = found.groups()
        position = found.end()
        if uniform:
            result.append(np.array(uniform.translate(None, b"()").split(), float))
        elif int(count):
            values, position = one_list(data, kind.decode(), count, position)
            result.append(values)


def files(folder):
    """Field and mesh files of a time folder by their path in it."""
    paths = (p for p in pathlib.Path(folder).rglob("*") if p.is_file())
    return {str(p.relative_to(folder)): p for p in paths if p.relative_to(folder).parts[0] != "uniform"}


def gap_and_scale(path, other):
    """Greatest difference of two files' values, and the greatest value; an infinite gap if they cannot be compared."""
    mine, theirs = blocks(path), blocks(other)
    if [x.size for x in mine] != [x.size for x in theirs]:
        return float("inf"), 1.0
    if not mine:
        return 0.0, 0.0
    a, b = np.concatenate(mine), np.concatenate(theirs)
    gap = np.abs(a - b).max(initial=0)
    return float("inf") if np.isnan(gap) else gap, np.abs(a).max(initial=0)


def differences(folders, others):
    """Greatest difference of each file relative to the greatest value; the folders are the ranks' parts of one time.

    Stops where one program writes a file that the other does not.
    """
    found = {}
    for folder, other in zip(folders, others):
        mine, theirs = files(folder), files(other)
        if set(mine) != set(theirs):
            raise SystemExit(f"{folder} and {other}: only one of them has {sorted(set(mine) ^ set(theirs))}")
        for name in mine:
            found.setdefault(name, []).append(gap_and_scale(mine[name], theirs[name]))
    worst = {name: np.array(pairs).max(axis=0) for name, pairs in found.items()}
    return {name: gap/(scale or 1) for name, (gap, scale) in worst.items()}
