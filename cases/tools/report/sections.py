"""What the page shows, section by section; what a run does not have is said below the section, with the reason."""
from __future__ import annotations

from diagnostics import Run

from . import cracks, curves, cuts, scene, shares, sizes, tables
from .curves import Curve
from .figure import picture
from .section import Section


def sections(runs: list[Run]) -> list[Section]:
    """The page from top to bottom."""
    return [make(runs) for make in (what_was_run, own_pictures, body, scaled, ice, crack_maps, cut_views, scenes, balance,
                                    wall_time)]


def what_was_run(runs: list[Run]) -> Section:
    """Versions, ranks, state, parameters."""
    section = Section("What was run")
    section.add_table("", tables.facts, runs)
    section.add_table("Parameters" + (" (bold where the runs differ)" if len(runs) > 1 else ""), tables.parameters, runs)
    return section


def own_pictures(runs: list[Run]) -> Section:
    """What the cases without a fluid draw of themselves; the others are shown by their cuts."""
    section = Section("The case's own picture")
    for run in runs:
        path = run.folder / "picture.png"
        if run.plan.get("np_foam") == 0 and path.is_file():
            text = f"{run.name}: what the case draws of itself"
            section.pictures.append(picture(path.read_bytes(), text, "png", shape="wide"))
    return section


def body(runs: list[Run]) -> Section:
    """Speed, depth, attitude and loads."""
    section = Section("Body", "y is up, the still surface is at y = 0. Forces are those at the exchanges, once per fluid step.")
    section.add_table("", tables.values, runs, "body", "loads", "scaled")
    for curve in (Curve(("speed",)), Curve(("speed",), over="depth"), Curve(("depth",)), Curve(("tilt",)), Curve(("drift",)),
                  Curve(("contact_force_y",)), Curve(("contact_force_sideways",)), Curve(("fluid_force_y",)),
                  Curve(("fluid_force_sideways",)), Curve(("wetted",))):
        section.add(curves.draw, runs, curve)
    return section


def scaled(runs: list[Run]) -> Section:
    """The same in the study's units."""
    section = Section("Body in the study's units", "c = √(E_b/ρ) of the bonds' modulus and the spheres' density (a run without "
                      "ice: the study's), t* = t c/D0 from the first touch of ice or water on, u* = u/c, L* = L/D0, "
                      "F* = F/(½ ρw c² π D0²/4).")
    for name in ("scaled_speed", "scaled_depth", "scaled_contact_force", "scaled_fluid_force"):
        section.add(curves.draw, runs, Curve((name,), over="scaled time"))
    return section


def ice(runs: list[Run]) -> Section:
    """Broken bonds, loss, fragments."""
    section = Section("Ice", "η: volume of the largest fragment over that of the ice at the start.")
    section.add_table("", tables.values, runs, "ice")
    section.add(curves.draw, runs, Curve(("broken_tension", "broken_shear"), label="broken bonds"))
    for name in ("loss", "pieces", "crack_radius"):
        section.add(curves.draw, runs, Curve((name,)))
    section.add(sizes.draw_counts, runs)
    section.add(sizes.draw_shares, runs)
    return section


def crack_maps(runs: list[Run]) -> Section:
    """One map per run."""
    section = Section("Cracks", "Each broken bond is drawn as the edge of its face, where it was in the unbroken ice; the "
                      "colour is the time of its breaking.")
    for run in runs:
        section.add(cracks.draw, run)
    return section


def cut_views(runs: list[Run]) -> Section:
    """Four moments per run."""
    section = Section("Cuts through the axis", "Water blue, air white, spheres within one diameter of the cut, body grey: "
                      "before the first contact, after the largest contact force, half-way on, at the end; even moments "
                      "without a contact.")
    for run in runs:
        section.add(cuts.draw, run)
    return section


def scenes(runs: list[Run]) -> Section:
    """The last snapshot in space."""
    section = Section("In space", "The last snapshot: the body, and the spheres behind its axis, pale at rest and dark red "
                      "where fast.")
    for run in runs:
        section.add(scene.draw, run, "wide" if len(runs) == 1 else "half")
    return section


def balance(runs: list[Run]) -> Section:
    """The ledger and the momentum budget."""
    section = Section("Ledger", "Do particles, coarse grid and fluid mesh hold the same volume and momentum? The relative "
                      "errors are round-off, below 1e-8, unless the program is at fault.")
    section.add_table("", tables.values, runs, "ledger", "momentum")
    section.add_table("Vertical momentum [N s]: what fluid, particles and body gained, what came from outside, what is on its "
                      "way between the programs", tables.momentum, runs)
    section.add(curves.draw, runs, Curve(("ledger_error",), log=True))
    for name in ("clipped_share", "dry_particles", "particles_lost"):
        section.add(curves.draw, runs, Curve((name,)))
    return section


def wall_time(runs: list[Run]) -> Section:
    """Where it went."""
    section = Section("Wall time")
    section.add_table("", tables.values, runs, "wall_time")
    section.add(curves.draw, runs, Curve(("wall_time",)))
    for run in runs:
        section.add(shares.draw, run)
    return section
