"""Where the vertical momentum of a run went: fluid, particles and body, term by term.

Over the fluid steps from the first exchange to the last line of the ledger, y components [N s]:

    fluid      what frazilFoam's `Momentum budget` lines say that changed it, against the change
    exchange   particles on the fluid, -Σ(impulseFine + Δt passiveReturned) - impulseHeld, against `particles` of the budget
    whole      fluid + particles + body: change, against the boundary, the weights, what the method leaves (splitting,
               gradient), and what is on its way between the programs at the end: the impulse that the particles report one
               step late, the prediction held, ∇p that acts on the particles a step late, the body's load likewise, and
               the half DEM step for which LIGGGHTS still pushes the particles with the forces of the step before
"""
import re

import checks


def steps(run):
    """Fluid steps of log.foam: {term: [N]} with `deltaT` [s]; the load on the bodies has its sign turned."""
    time, rows = 0.0, []
    for line in (run / "log.foam").read_text().splitlines():
        if line.startswith("Time = "):
            now = float(line.split()[2])
            deltaT, time = now - time, now
        elif line.startswith("Momentum budget:"):
            terms = {name: float(y) for name, y in re.findall(r"(\w+) \(\S+ (\S+) \S+\)", line)}
            rows.append({"deltaT": deltaT, **terms})
    return rows


def exchanged(ledger, n, deltaT):
    """What the particles got over n steps by their own account [N s]: drag and added mass, passive with response; and the
    last force of the latter [N]."""
    impulse = sum(ledger["impulseReceivedY"][1:n + 1])
    force = [passive + response for passive, response in zip(ledger["passiveReceivedY"], ledger["responseY"])]
    return impulse, sum(d * f for d, f in zip(deltaT, force)), force[n - 1]


def check(run, result, particle_density, body_mass, gravity=9.81):
    """Asserts the three balances to 1e-3 of the impulse on the body."""
    ledger, history = checks.table(run / "ledger.csv"), checks.table(run / "history.csv")
    rows = steps(run)[:len(ledger["time"]) - 1]
    n, deltaT = len(rows), [row["deltaT"] for row in rows]
    end = ledger["time"][n]
    total = lambda name: sum(row["deltaT"] * row[name] for row in rows)
    impulse = sum(row["deltaT"] * abs(row["bodies"]) for row in rows)

    terms = ("boundary", "weight", "tension", "particles", "solid", "bodies", "splitting", "gradient")
    fluid = total("change") - sum(total(name) for name in terms)
    result.below("fluid's momentum, unexplained over the impulse on the body", abs(fluid) / impulse, 1e-3)

    given = sum(ledger["impulseFineY"][k] + deltaT[k] * ledger["passiveReturnedY"][k] for k in range(n))
    held = ledger["impulseHeldY"][n]
    result.below("particles on the fluid: ledger against budget, over it",
                 abs(total("particles") + given + held) / impulse, 1e-3)

    mass = particle_density * ledger["volumeParticles"][0]
    body = body_mass * (history["vy"][n] - history["vy"][0])
    particles = ledger["demMomentumY"][n] - ledger["demMomentumY"][0]
    dragged, passive, last = exchanged(ledger, n, deltaT)
    half_step = 0.5 * deltaT[-1] / history["substeps"][n - 1] * last
    on_way = {
        "reported late": dragged - sum(ledger["impulseFineY"][:n]),
        "held": -held,
        "half a DEM step": -half_step,
        "pressure": passive + total("solid") - sum(d * y for d, y in zip(deltaT, ledger["passiveReturnedY"])),
        "body": sum(d * f for d, f in zip(deltaT, history["fluid_fy"])) + total("bodies"),
    }
    outside = (total("boundary") + total("weight") + total("tension") + total("splitting") + total("gradient")
               - gravity * end * (mass + body_mass))
    rest = total("change") + particles + body - outside - sum(on_way.values())
    for name, value in (("fluid", total("change")), ("particles", particles), ("body", body), ("from outside", outside),
                        *on_way.items()):
        print(f"     momentum, {name}: {value:.6g} N s")
    result.below("momentum of the whole system, unexplained over the impulse on the body", abs(rest) / impulse, 1e-3)
