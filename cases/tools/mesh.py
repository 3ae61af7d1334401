"""A blockMeshDict of one box, cut along each axis into stretches of even or geometrically growing cells."""
import math


def growing(length, first, growth):
    """(cells, last/first) of a stretch that starts with cells of about `first` and grows by about `growth` per cell."""
    cells = max(1, math.ceil(math.log(1 + (growth - 1) * length / first) / math.log(growth)))
    low, high = 1.0, growth
    for _ in range(60):  # the growth that fills the length with that many cells exactly
        middle = 0.5 * (low + high)
        total = first * cells if middle == 1 else first * (middle**cells - 1) / (middle - 1)
        low, high = (middle, high) if total < length else (low, middle)
    return cells, low ** (cells - 1)


def axis(low, core_low, core_high, high, size, growth):
    """Stretches [(length, cells, last/first)]: growing cells outside [core_low, core_high], even ones inside."""
    stretches = []
    if core_low > low:
        cells, ratio = growing(core_low - low, size * growth, growth)
        stretches.append((core_low - low, cells, 1 / ratio))
    stretches.append((core_high - core_low, max(1, round((core_high - core_low) / size)), 1.0))
    if high > core_high:
        cells, ratio = growing(high - core_high, size * growth, growth)
        stretches.append((high - core_high, cells, ratio))
    return stretches


def cell_count(*axes):
    """Cells of the whole mesh."""
    return math.prod(sum(cells for _, cells, _ in stretches) for stretches in axes)


def write_block_mesh(path, box, axes):
    """One block with multi-grading: patches `sides`, `bottom`, `top` (y is up). box: ((x, X), (y, Y), (z, Z)) [m]."""
    (x, X), (y, Y), (z, Z) = box
    grading = " ".join("(" + " ".join(f"({length:.9g} {cells} {ratio:.9g})" for length, cells, ratio in stretches) + ")"
                       for stretches in axes)
    counts = " ".join(str(sum(cells for _, cells, _ in stretches)) for stretches in axes)
    vertices = "\n".join(f"    ({a:.9g} {b:.9g} {c:.9g})" for c in (z, Z) for b in (y, Y) for a in (x, X))
    with open(path, "w") as file:
        file.write(f"""FoamFile {{ version 2.0; format ascii; class dictionary; object blockMeshDict; }}

scale 1;

vertices
(
{vertices}
);

blocks
(
    hex (0 1 3 2 4 5 7 6) ({counts})
    simpleGrading ({grading})
);

edges ();

boundary
(
    sides  {{ type patch; faces ((0 4 6 2) (1 3 7 5) (0 2 3 1) (4 5 7 6)); }}
    bottom {{ type wall;  faces ((0 1 5 4)); }}
    top    {{ type patch; faces ((2 6 7 3)); }}
);
""")
