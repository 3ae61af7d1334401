"""Where the vertical momentum of a run went: fluid, particles and body, term by term.

Over the fluid steps from the first exchange to the last line of the ledger, y components [N s]:

    fluid      what frazilFoam's `Momentum budget` lines say that changed it, against the change
    exchange   particles on the fluid, -Σ(impulseFine + Δt passiveReturned) - impulseHeld, against `particles` of the budget
    whole      fluid + particles + body: change, against the boundary, the weights, what the method leaves (splitting,
               gradient), and what is on its way between the programs at the end: the impulse that the particles report one
               step late, the prediction held, ∇p that acts on the particles a step late, the body's load likewise, and
               the half DEM step for which LIGGGHTS still pushes the particles with the forces of the step before
"""
from __future__ import annotations

import re

import numpy

from .catalogue import Missing, value
from .facts import said
from .run import Run

TERMS = ("boundary", "weight", "tension", "particles", "solid", "bodies", "splitting", "gradient")
OUTSIDE = ("boundary", "weight", "tension", "splitting", "gradient")


def steps(run: Run) -> dict[str, numpy.ndarray]:
    """Fluid steps of log.foam that ledger and history have, too: each term [N], with `deltaT` [s]; the load on the bodies
    has its sign turned."""
    if list(run.folder.glob("log.foam-*")):
        raise Missing(f"{run.folder / 'log.foam'}: the run was continued, and its budget is in several logs.")
    time, rows = 0.0, []
    for line in run.log("log.foam").splitlines():
        if line.startswith("Time = "):
            now = float(line.split()[2])
            deltaT, time = now - time, now
        elif line.startswith("Momentum budget:"):
            terms = {name: float(y) for name, y in re.findall(r"(\w+) \(\S+ (\S+) \S+\)", line)}
            rows.append({"deltaT": deltaT, **terms})
    rows = rows[:min(len(table["time"]) for table in (run.ledger, run.history)) - 1]
    if not rows or rows[-1].keys() != rows[0].keys():
        raise Missing(f"{run.folder / 'log.foam'}: has no Momentum budget; frazilFoam writes one with bodies only.")
    return {name: numpy.array([row[name] for row in rows]) for name in rows[0]}


def total(rows: dict[str, numpy.ndarray], name: str) -> float:
    """∫ of a term over all steps [N s]."""
    return float(rows["deltaT"] @ rows[name])


def impulse(rows: dict[str, numpy.ndarray]) -> float:
    """∫ |load on the bodies| dt [N s]: the measure of what is left over."""
    found = float(rows["deltaT"] @ numpy.abs(rows["bodies"])) if "bodies" in rows else 0.0
    if not found:
        raise Missing("log.foam: no load on a body yet, over which the rest of the momentum could be measured.")
    return found


def fluid_rest(rows: dict[str, numpy.ndarray]) -> float:
    """Change of the fluid's momentum less all its terms [N s]."""
    return total(rows, "change") - sum(total(rows, name) for name in TERMS)


def exchange_rest(run: Run, rows: dict[str, numpy.ndarray]) -> float:
    """What the particles gave to the fluid by the budget, and by the ledger with its sign turned, together [N s]."""
    ledger, n = run.ledger, len(rows["deltaT"])
    given = ledger["impulseFineY"][:n].sum() + rows["deltaT"] @ ledger["passiveReturnedY"][:n]
    return float(total(rows, "particles") + given + ledger["impulseHeldY"][n])


def changes(run: Run, rows: dict[str, numpy.ndarray], body_mass: float) -> dict[str, float]:
    """What fluid, particles and body gained [N s]."""
    ledger, history, n = run.ledger, run.history, len(rows["deltaT"])
    return {"fluid": total(rows, "change"), "particles": ledger["demMomentumY"][n] - ledger["demMomentumY"][0],
            "body": body_mass * (history["vy"][n] - history["vy"][0])}


def from_outside(run: Run, rows: dict[str, numpy.ndarray], mass: float, gravity: float = 9.81) -> float:
    """What came through the boundary and by the weights of fluid and of `mass` [kg], and what the method leaves [N s]."""
    end = run.ledger["time"][len(rows["deltaT"])]
    return sum(total(rows, name) for name in OUTSIDE) - gravity * end * mass


def on_way(run: Run, rows: dict[str, numpy.ndarray]) -> dict[str, float]:
    """What one program has given and the other does not have yet [N s]."""
    ledger, history = run.ledger, run.history
    deltaT, n = rows["deltaT"], len(rows["deltaT"])
    force = ledger["passiveReceivedY"][:n] + ledger["responseY"][:n]
    dragged = ledger["impulseReceivedY"][1:n + 1].sum() - ledger["impulseFineY"][:n].sum()
    return {"reported late": dragged, "held": -ledger["impulseHeldY"][n],
            "half a DEM step": -0.5 * deltaT[-1] / history["substeps"][n - 1] * force[-1],
            "pressure": deltaT @ force + total(rows, "solid") - deltaT @ ledger["passiveReturnedY"][:n],
            "load of the body": deltaT @ history["fluid_fy"][:n] + total(rows, "bodies")}


def whole(run: Run, rows: dict[str, numpy.ndarray], particle_density: float, body_mass: float) -> dict[str, float]:
    """The balance of everything, term by term, `unexplained` last [N s]."""
    changed, way = changes(run, rows, body_mass), on_way(run, rows)
    outside = from_outside(run, rows, particle_density * run.ledger["volumeParticles"][0] + body_mass)
    rest = sum(changed.values()) - outside - sum(way.values())
    return {**changed, "from outside": outside, **way, "unexplained": rest}


def balance(run: Run) -> dict[str, float]:
    """The same [N s] with the density and the mass that the run itself names: ice_density, and the body's in log.dem."""
    mass = float(said(run, "log.dem", r"^Body \S+: mass (\S+) kg"))
    density = run.parameter("ice_density") if run.ledger["particles"][0] else 0.0
    return whole(run, steps(run), density, mass)


@value("momentum of the fluid, unexplained over the impulse on the body", "")
def unexplained_fluid(run: Run) -> float:
    """|change - Σ terms| of the fluid over ∫|load on the bodies| dt [-]."""
    rows = steps(run)
    return abs(fluid_rest(rows)) / impulse(rows)


@value("momentum of fluid, ice and body, unexplained over the impulse on the body", "")
def unexplained_whole(run: Run) -> float:
    """|unexplained| of the whole system over ∫|load on the bodies| dt [-]."""
    return abs(balance(run)["unexplained"]) / impulse(steps(run))
