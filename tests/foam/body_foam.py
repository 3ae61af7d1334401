#!/usr/bin/env python3
"""Immersed bodies of frazilFoam alone, at 8 cells per diameter.

Usage: body_foam.py CASE FRAZILFOAM WORK_FOLDER, CASE one of
  archimedes       sphere at rest, immersed and across the surface: F = ρ g V of the displaced water, within 2 %
  still_porous     still water and random αs: max|U| below 1e-6 m/s
  moving_sphere    20 m/s against still water: ripple of the force below 10 % of ½ρU²A
  closed_tank      a sphere moves through the surface in a tank without an outlet: α <= 1 + 1e-4 on one rank and on two
  momentum         two bodies between particles: the fluid's momentum, what crosses the boundary, weight, surface
                   tension and the loads balance to 1e-6 of the impulse, on one rank and on two
  far_corner       cells of half the size far from the cone change neither impulse nor ripple
  cone_entry       120° cone at 20 m/s: water volume within 1e-6 of the body's volume, impulse within 10 % of the
                   measured one, ripple of the force after the peak below 10 % of ½ρU²A
"""

import math
import pathlib
import random
import re
import statistics
import sys

import numpy as np

import foam_case as fc
import surfaces
import tank_case

D, N, SPEED, GRAVITY = 0.016, 8, 20.0, 9.81
DX = D/N
OFFSET = 0.37*DX  # no plane of symmetry of the body lies on the mesh


def mesh(half_width, half_height, dx=DX, corner=False):
    """Cubes of dx; with `corner` the first layer along each axis is halved, so that one corner has a cell of dx/2."""
    lo, hi = (-half_width, -half_height, -half_width), (half_width, half_height, half_width)
    cells = [round((b - a)/dx) for a, b in zip(lo, hi)]
    if not corner:
        return tank_case.box_mesh(lo, hi, cells)
    halved = " ".join(f"((1 2 1) ({n - 1} {n - 1} 1))" for n in cells)
    return tank_case.box_mesh(lo, hi, [n + 1 for n in cells], f"({halved})")


def prepare(folder, foam_mesh, triangles, surface_y, times, motion="", gravity=GRAVITY, sigma=0.0, top="open"):
    bodies = f'ball {{ surface "constant/triSurface/ball.stl"; {motion} }}' if triangles else ""
    case = tank_case.write_case(folder, foam_mesh, surface_y, times, bodies, gravity=gravity, top=top, sigma=sigma)
    if triangles:
        surfaces.write_stl(case / "constant/triSurface/ball.stl", triangles)
    fc.run(["blockMesh"], case, "log.blockMesh")
    if surface_y is not None:
        fc.run(["setFields"], case, "log.setFields")
    return case


def write_fluid_fraction(case, values):
    tank_case.write(case / "0/fluidFraction", "dimensions [0 0 0 0 0 0 0]; internalField nonuniform List<scalar> "
             + f"{len(values)} ({' '.join(map(str, values))}); boundaryField {{ \".*\" {{ type zeroGradient; }} }}\n",
             "volScalarField")


def vertical_forces(log):
    return [float(f) for f in re.findall(r"^Body \w+: centre .* force \(\S+ (\S+) ", log, re.M)]


def archimedes(foam, work):
    ok = True
    r = D/2
    for name, surface, centre in (("immersed", 1.2*D, -0.6*D), ("across", 0.0, 0.21*DX)):
        body = surfaces.sphere(D, (OFFSET, centre, -OFFSET))
        case = prepare(work / name, mesh(2*D, 2*D), body, surface, tank_case.control(0.005, 5e-4, 0.3))
        force = vertical_forces(fc.run([foam], case, "log.frazilFoam"))[-1]
        depth = min(max(surface - (centre - r), 0), 2*r)
        wet = math.pi*depth**2*(3*r - depth)/3
        expected = GRAVITY*(1000*wet + 1.294*(4/3*math.pi*r**3 - wet))
        error = force/expected - 1
        print(f"{name}: force {force:.6g} N, Archimedes {expected:.6g} N, error {error:.2%}, allowed 2 %")
        ok &= abs(error) < 0.02
    return ok


def still_porous(foam, work):
    random.seed(1)
    cells = (8, 16, 8)
    case = prepare(work / "still", tank_case.box_mesh((0, 0, 0), (0.08, 0.16, 0.08), cells), None, 0.08,
                   tank_case.control(0.05, 1e-3, 0.3))
    text = (case / "system/fvSolution").read_text().replace("tolerance 1e-7; relTol 0.001", "tolerance 1e-12; relTol 0")
    (case / "system/fvSolution").write_text(text)
    write_fluid_fraction(case, [0.45 + 0.5*random.random() if 4 <= j < 12 and 2 <= i < 6 else 1.0
                                for k in range(cells[2]) for j in range(cells[1]) for i in range(cells[0])])
    fc.run([foam], case, "log.frazilFoam")
    fastest = max(abs(u) for u in fc.lists(case / fc.last_time(case) / "U")[0])
    print(f"still water, random αs: max|U| {fastest:.2g} m/s, allowed 1e-6")
    return fastest < 1e-6


def moving_sphere(foam, work):
    delta_t = 0.25*DX/SPEED
    case = prepare(work / "moving", mesh(2*D, 2*D), surfaces.sphere(D, (OFFSET, 0.5*D, -OFFSET)), None,
                   tank_case.control(20*delta_t, delta_t, adjust="no"), "motion { velocity (0 -20 0); omega (0 0 0); }",
                   gravity=0)
    forces = vertical_forces(fc.run([foam], case, "log.frazilFoam"))[-8:]
    ripple = (max(forces) - min(forces))/2/(0.5*1000*SPEED**2*math.pi*D**2/4)
    print(f"moving sphere: mean force {statistics.mean(forces):.1f} N, ripple {ripple:.1%} of ½ρU²A, allowed 10 %")
    return ripple < 0.10


def run_on(ranks, foam, case):
    """Log of a run on so many ranks; one means serial."""
    if ranks == 1:
        return fc.run([foam], case, "log.frazilFoam")
    fc.run(["decomposePar", "-force"], case, "log.decomposePar")
    return fc.run([*fc.MPIRUN, "-np", ranks, foam, "-parallel"], case, "log.frazilFoam")


def closed_tank(foam, work):
    delta_t = 0.25*DX/SPEED
    excess, force = {}, {}
    for ranks in (1, 2):
        case = prepare(work / f"ranks{ranks}", mesh(2*D, 2*D), surfaces.sphere(D, (OFFSET, 0.5*D, -OFFSET)), 0.0,
                       tank_case.control(20*delta_t, delta_t, adjust="no"),
                       "motion { velocity (0 -20 0); omega (0 0 0); }", top="closed")
        log = run_on(ranks, foam, case)
        excess[ranks] = max(float(a) for a in re.findall(r"Max\(alpha.water\) = (\S+)", log)) - 1
        force[ranks] = np.array(vertical_forces(log))
    apart = np.max(np.abs(force[1] - force[2]))/np.max(np.abs(force[1]))
    print(f"closed tank: max α - 1 {excess[1]:.1e} on one rank, {excess[2]:.1e} on two, allowed 1e-4; "
          f"forces differ by {apart:.1e}, allowed 1e-3")
    return max(excess.values()) < 1e-4 and apart < 1e-3


def momentum_case(folder, delta_t, steps):
    """Two bodies, 1 cell apart, one slipping into water at 20 m/s, one turning; random αs around them."""
    random.seed(1)
    box = mesh(1.5*D, 1.5*D)
    bodies = """
ball { surface "constant/triSurface/ball.stl"; motion { velocity (0 -20 0); omega (0 0 0); } }
rough { surface "constant/triSurface/rough.stl"; slip no; motion { velocity (3 0 0); omega (0 0 900); } }"""
    case = tank_case.write_case(folder, box, 0.0, tank_case.control(steps*delta_t, delta_t, adjust="no", write_interval=delta_t), bodies)
    surfaces.write_stl(case / "constant/triSurface/ball.stl", surfaces.sphere(D, (OFFSET, 0.4*D, -OFFSET)))
    surfaces.write_stl(case / "constant/triSurface/rough.stl", surfaces.sphere(0.8*D, (OFFSET, -0.62*D, -OFFSET)))
    fc.run(["blockMesh"], case, "log.blockMesh")
    fc.run(["setFields"], case, "log.setFields")
    n = 3*N
    write_fluid_fraction(case, [0.5 + 0.4*random.random() if 6 <= i < 18 and 6 <= j < 18 else 1.0
                                for k in range(n) for j in range(n) for i in range(n)])
    return case


def fluid_momentum(folder):
    """Σ ρ ε U V [N s] of a time folder."""
    def field(name, size):
        text = (folder / name).read_text()
        uniform = re.search(r"internalField\s+uniform\s+\(?([^;)]*)", text)
        one = [float(x) for x in uniform.group(1).split()] if uniform else None
        return np.array(one*(3*N)**3 if uniform else fc.lists(folder / name)[0]).reshape(-1, size)
    alpha = field("alpha.water", 1)
    epsilon = field("fluidFraction", 1)*(1 - field("gamma", 1))
    return np.sum((1000*alpha + 1.294*(1 - alpha))*epsilon*field("U", 3), axis=0)*DX**3


def momentum_terms(log):
    """Terms of the momentum budget [N], an array over steps each."""
    terms = {}
    for line in re.findall(r"^Momentum budget: (.*)", log, re.M):
        for name, *xyz in re.findall(r"(\w+) \((\S+) (\S+) (\S+)\)", line):
            terms.setdefault(name, []).append([float(x) for x in xyz])
    return {name: np.array(values) for name, values in terms.items()}


def momentum(foam, work):
    delta_t, steps, ok = 0.25*DX/SPEED, 12, True
    for ranks in (1, 2):
        case = momentum_case(work / f"ranks{ranks}", delta_t, steps)
        log = run_on(ranks, foam, case)
        terms = momentum_terms(log)
        impulse = delta_t*np.sum(np.linalg.norm(terms["bodies"], axis=1))
        error = delta_t*np.max(np.abs(np.sum(terms["error"], axis=0)))/impulse
        rest = delta_t*np.sum(np.abs(terms["splitting"]) + np.abs(terms["gradient"]))/impulse
        loads = np.array([[float(x) for x in f] for f in re.findall(r"^Body .* force \((\S+) (\S+) (\S+)\)", log, re.M)])
        reported = np.max(np.abs(loads[0::2] + loads[1::2] + terms["bodies"]))*delta_t/impulse
        print(f"momentum, {ranks} ranks: error {error:.1e} of the impulse on the bodies, allowed 1e-6; loads reported "
              f"and in the budget differ by {reported:.1e}, allowed 1e-6; splitting and gradient {rest:.1e}, allowed 1e-2")
        ok &= error < 1e-6 and reported < 1e-6 and rest < 1e-2
        if ranks == 1:
            times = sorted((p for p in case.iterdir() if re.fullmatch(r"[0-9.e+-]+", p.name)), key=lambda p: float(p.name))
            change = fluid_momentum(times[-1]) - fluid_momentum(times[1])
            apart = np.max(np.abs(change - delta_t*np.sum(terms["change"][1:], axis=0)))/impulse
            print(f"momentum of the fields written and change in the budget differ by {apart:.1e}, allowed 1e-6")
            ok &= apart < 1e-6
    return ok


def slamming(log, contact, depth):
    """t* = U (t - contact)/depth [-] and Cs = F/(½ρU²A) [-] of every step."""
    times = np.array([float(t) for t in re.findall(r"^Time = (\S+)", log, re.M)])
    return (times - contact)*SPEED/depth, np.array(vertical_forces(log))/(0.5*1000*SPEED**2*math.pi*D**2/4)


def impulse_to(t_end, t, cs):
    """∫ Cs dt* from contact to t_end; the force of a step holds over the step."""
    edges = np.clip(np.concatenate([[0.0], t]), 0, t_end)
    return float(np.sum(cs*np.diff(edges)))


def crossing_ripple(t, cs, crossing, start):
    """Largest half range, within the time of crossing one cell, of Cs less its mean over that time, after `start`."""
    per = 40
    even = np.arange(t[0], t[-1], crossing/per)
    window = np.ones(per + 1)/per
    window[[0, -1]] /= 2
    rest = np.interp(even, t, cs)[per//2:-per//2] - np.convolve(np.interp(even, t, cs), window, "valid")
    rest = rest[even[per//2:-per//2] > start]
    return max(np.ptp(rest[i:i + per + 1])/2 for i in range(len(rest) - per))


def cone_figures(foam, folder, n=N, offset=0.37, half=(2.5*D, 3*D), corner=False):
    """Figures of the 120° cone at 20 m/s with n cells per diameter, its axis offset [cells] from a mesh line."""
    dx = D/n
    gap = 1.2*dx
    body = surfaces.cone(D, 2*D, (offset*dx, gap, -offset*dx))
    case = prepare(folder, mesh(*half, dx, corner), body, 0.0, tank_case.control(gap/SPEED + 6.8e-4, 1e-5, 0.3),
                   "motion { velocity (0 -20 0); omega (0 0 0); }", sigma=0.0725)
    log = fc.run([foam], case, "log.frazilFoam")
    depth = D/2/math.tan(math.radians(60))
    t, cs = slamming(log, gap/SPEED, depth)
    water = [float(v) for v in re.findall(r"^Water volume = (\S+)", log, re.M)]
    return {
        "J(1)": impulse_to(1, t, cs), "J(2)": impulse_to(2, t, cs), "peak": max(cs), "at": t[cs.argmax()],
        "ripple": crossing_ripple(t, cs, dx/depth, 1.4),
        "drift": max(abs(v - water[0]) for v in water)/surfaces.volume(body), "steps": len(t),
    }


def cone_entry(foam, work):
    f = cone_figures(foam, work / "entry")
    print(f"cone entry: impulse {f['J(2)']:.2f}, measured 2.07 +- 0.05, allowed 10 %; peak Cs {f['peak']:.2f} at t* "
          f"{f['at']:.2f}; ripple {f['ripple']:.1%} of ½ρU²A, allowed 10 %; "
          f"water volume drift {f['drift']:.1e} of the body's, allowed 1e-6")
    return abs(f["J(2)"]/2.07 - 1) < 0.10 and f["ripple"] < 0.10 and f["drift"] < 1e-6


def far_corner(foam, work):
    even, fine = (cone_figures(foam, work / name, half=(1.5*D, 2.5*D), corner=corner)
                  for name, corner in (("even", False), ("corner", True)))
    impulse = abs(fine["J(2)"]/even["J(2)"] - 1)
    ripple = abs(fine["ripple"] - even["ripple"])
    print(f"fine cells in a far corner: impulse {even['J(2)']:.4f} and {fine['J(2)']:.4f}, differ by {impulse:.1e}; ripple "
          f"{even['ripple']:.2%} and {fine['ripple']:.2%}; allowed 1e-3 for both")
    return impulse < 1e-3 and ripple < 1e-3


CASES = {f.__name__: f for f in (archimedes, still_porous, moving_sphere, closed_tank, momentum,
                                  far_corner, cone_entry)}

if __name__ == "__main__":
    work = pathlib.Path(sys.argv[3]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    sys.exit(not CASES[sys.argv[1]](pathlib.Path(sys.argv[2]).resolve(), work))
