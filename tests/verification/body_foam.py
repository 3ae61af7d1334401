#!/usr/bin/env python3
"""Immersed bodies of frazilFoam alone, at 8 cells per diameter.

Usage: body_foam.py CASE FRAZILFOAM WORK_FOLDER, CASE one of
  archimedes       sphere at rest, immersed and across the surface: F = ρ g V of the displaced water, within 2 %
  still_porous     still water and random αs: max|U| below 1e-6 m/s
  moving_sphere    20 m/s against still water: ripple of the force below 10 % of ½ρU²A
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

import body_case as bc
import foam_case as fc

D, N, SPEED, GRAVITY = 0.016, 8, 20.0, 9.81
DX = D/N
OFFSET = 0.37*DX  # no plane of symmetry of the body lies on the mesh


def mesh(half_width, half_height):
    lo, hi = (-half_width, -half_height, -half_width), (half_width, half_height, half_width)
    return bc.box_mesh(lo, hi, [round((b - a)/DX) for a, b in zip(lo, hi)])


def prepare(folder, foam_mesh, triangles, surface_y, times, motion="", gravity=GRAVITY, sigma=0.0):
    bodies = f'ball {{ surface "constant/triSurface/ball.stl"; {motion} }}' if triangles else ""
    case = bc.write_case(folder, foam_mesh, surface_y, times, bodies, gravity=gravity, sigma=sigma)
    if triangles:
        bc.write_stl(case / "constant/triSurface/ball.stl", triangles)
    fc.run(["blockMesh"], case, "log.blockMesh")
    if surface_y is not None:
        fc.run(["setFields"], case, "log.setFields")
    return case


def vertical_forces(log):
    return [float(f) for f in re.findall(r"^Body \w+: centre .* force \(\S+ (\S+) ", log, re.M)]


def archimedes(foam, work):
    ok = True
    r = D/2
    for name, surface, centre in (("immersed", 1.2*D, -0.6*D), ("across", 0.0, 0.21*DX)):
        body = bc.sphere(D, (OFFSET, centre, -OFFSET))
        case = prepare(work / name, mesh(2*D, 2*D), body, surface, bc.control(0.005, 5e-4, 0.3))
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
    case = prepare(work / "still", bc.box_mesh((0, 0, 0), (0.08, 0.16, 0.08), cells), None, 0.08,
                   bc.control(0.05, 1e-3, 0.3))
    text = (case / "system/fvSolution").read_text().replace("tolerance 1e-7; relTol 0.001", "tolerance 1e-12; relTol 0")
    (case / "system/fvSolution").write_text(text)
    values = [0.45 + 0.5*random.random() if 4 <= j < 12 and 2 <= i < 6 else 1.0
              for k in range(cells[2]) for j in range(cells[1]) for i in range(cells[0])]
    bc.write(case / "0/fluidFraction", "dimensions [0 0 0 0 0 0 0]; internalField nonuniform List<scalar> "
             + f"{len(values)} ({' '.join(map(str, values))}); boundaryField {{ \".*\" {{ type zeroGradient; }} }}\n",
             "volScalarField")
    fc.run([foam], case, "log.frazilFoam")
    fastest = max(abs(u) for u in fc.lists(case / fc.last_time(case) / "U")[0])
    print(f"still water, random αs: max|U| {fastest:.2g} m/s, allowed 1e-6")
    return fastest < 1e-6


def moving_sphere(foam, work):
    delta_t = 0.25*DX/SPEED
    case = prepare(work / "moving", mesh(2*D, 2*D), bc.sphere(D, (OFFSET, 0.5*D, -OFFSET)), None,
                   bc.control(20*delta_t, delta_t, adjust="no"), "motion { velocity (0 -20 0); omega (0 0 0); }",
                   gravity=0)
    forces = vertical_forces(fc.run([foam], case, "log.frazilFoam"))[-8:]
    ripple = (max(forces) - min(forces))/2/(0.5*1000*SPEED**2*math.pi*D**2/4)
    print(f"moving sphere: mean force {statistics.mean(forces):.1f} N, ripple {ripple:.1%} of ½ρU²A, allowed 10 %")
    return ripple < 0.10


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


def cone_entry(foam, work):
    gap = 1.2*DX
    body = bc.cone(D, 2*D, (OFFSET, gap, -OFFSET))
    case = prepare(work / "entry", mesh(2.5*D, 3*D), body, 0.0, bc.control(8e-4, 1e-5, 0.3),
                   "motion { velocity (0 -20 0); omega (0 0 0); }", sigma=0.0725)
    log = fc.run([foam], case, "log.frazilFoam")
    depth = D/2/math.tan(math.radians(60))
    t, cs = slamming(log, gap/SPEED, depth)
    impulse, ripple = impulse_to(2, t, cs), crossing_ripple(t, cs, DX/depth, 1.4)
    water = [float(v) for v in re.findall(r"^Water volume = (\S+)", log, re.M)]
    drift = max(abs(v - water[0]) for v in water)/bc.volume(body)
    print(f"cone entry: impulse {impulse:.2f}, measured 2.07 +- 0.05, allowed 10 %; peak Cs {max(cs):.2f} at t* "
          f"{t[cs.argmax()]:.2f}; ripple {ripple:.1%} of ½ρU²A, allowed 10 %; "
          f"water volume drift {drift:.1e} of the body's, allowed 1e-6")
    return abs(impulse/2.07 - 1) < 0.10 and ripple < 0.10 and drift < 1e-6


CASES = {f.__name__: f for f in (archimedes, still_porous, moving_sphere, cone_entry)}

if __name__ == "__main__":
    work = pathlib.Path(sys.argv[3]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    sys.exit(not CASES[sys.argv[1]](pathlib.Path(sys.argv[2]).resolve(), work))
