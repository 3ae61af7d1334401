"""A plate of equal spheres in hexagonal close packing, layers horizontal (y is up), and the numbers that follow from it.
SI units."""
import math

LAYER = math.sqrt(2.0 / 3.0)  # distance of two layers over D
ROW = math.sqrt(3.0) / 2.0    # distance of two rows over D


def plate(diameter, columns, rows, layers):
    """Centres of columns x rows x layers spheres (along x, z, y), centred in x and z, lowest sphere resting on y = 0.
    Close-packed rows along x; every second row and every second layer is shifted into the gaps (ABAB)."""
    points = []
    for k in range(layers):
        for j in range(rows):
            for i in range(columns):
                points.append((i + 0.5 * ((j + k) % 2), 0.5 + LAYER * k, ROW * (j + (k % 2) / 3.0)))
    width = max(p[0] for p in points), max(p[2] for p in points)
    return [(diameter * (x - width[0] / 2), diameter * y, diameter * (z - width[1] / 2)) for x, y, z in points]


def contacts(points, diameter):
    """Pairs (n, m), n < m, of numbers of points that are no farther apart than 1.001 diameters."""
    cells = {}
    for n, point in enumerate(points):
        cells.setdefault(tuple(math.floor(c / diameter) for c in point), []).append(n)
    around = [(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
    pairs = []
    for cell, members in cells.items():
        near = [m for shift in around for m in cells.get(tuple(map(sum, zip(cell, shift))), ())]
        pairs += [(n, m) for n in members for m in near
                  if n < m and math.dist(points[n], points[m]) < 1.001 * diameter]
    return pairs


def thickness(diameter, layers):
    """From the lowest to the highest point of the plate [m]."""
    return diameter * (1 + LAYER * (layers - 1))


def cap_share(depth, diameter):
    """Share of a sphere's volume below a level that is `depth` above its lowest point."""
    s = min(max(depth / diameter, 0.0), 1.0)
    return s * s * (3 - 2 * s)


def draft(diameter, layers, density_ratio):
    """Depth of the plate's lowest point in still water [m]: where the spheres' volume below the level is
    density_ratio of all. Water fills the pores, so only the spheres count."""
    low, high = 0.0, thickness(diameter, layers)
    for _ in range(60):
        middle = 0.5 * (low + high)
        wet = sum(cap_share(middle - LAYER * k * diameter, diameter) for k in range(layers)) / layers
        low, high = (middle, high) if wet < density_ratio else (low, middle)
    return 0.5 * (low + high)


def critical_step(diameter, density, young, stiffness_ratio):
    """Largest stable DEM step of the bonded packing [s]: dt_c = 2/ω_max, ω_max² = max(8 kn, 45 ks) A/m with
    kn = E/D, ks = kn/κ, A = πD²/4 (twelve bonds; the rotations govern when κ is small)."""
    mass = density * math.pi / 6 * diameter**3
    area = math.pi / 4 * diameter**2
    normal = young / diameter
    return 2 / math.sqrt(max(8 * normal, 45 * normal / stiffness_ratio) * area / mass)


def bond_words(parameters):
    """The words of fix bond/parallel that change how strong single bonds are; none where all are equally strong."""
    angle, modulus = parameters["friction_angle"], parameters["weibull_modulus"]
    words = [f"friction_angle {angle:g}"] if angle else []
    return " ".join(words + ([f"weibull {modulus:g} {parameters['weibull_seed']}"] if modulus else []))


def write_data(path, points, diameters, density, box, types):
    """LIGGGHTS data file of `atom_style granular`: id type diameter density x y z. diameters [m]: one, or one per sphere;
    box: ((x, X), (y, Y), (z, Z))."""
    if isinstance(diameters, float):
        diameters = [diameters] * len(points)
    with open(path, "w") as data:
        data.write(f"Spheres of {min(diameters):g} to {max(diameters):g} m, {density:g} kg/m3\n\n{len(points)} atoms\n"
                   f"{types} atom types\n\n")
        for (low, high), axis in zip(box, "xyz"):
            data.write(f"{low:.17g} {high:.17g} {axis}lo {axis}hi\n")
        data.write("\nAtoms\n\n")
        for n, (diameter, point) in enumerate(zip(diameters, points), 1):
            data.write("%d 1 %.17g %g %.17g %.17g %.17g\n" % (n, diameter, density, *point))
