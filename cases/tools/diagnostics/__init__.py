"""Diagnostics of a run folder, one function each with formula and unit: for `./frazil report`, for sweeps, for scripts.

    from diagnostics import Run, SERIES, VALUES, Missing
    run = Run("runs/ice_entry-demo")
    VALUES["peak_contact_force"](run)     # one number [N]; Missing, in words, where the run has no such thing
    SERIES["loss"](run)                   # Series(time [s], values)

Also from a run that is still going on or was interrupted. A module imports only those of earlier lines:

    catalogue                      the two lists, Series, Missing
    snapshots, run                 the files
    surface, foam                  the body's surface and attitude; the fluid's mesh and fields
    scales                         the study's units
    facts
    body, loads, scaled            the body: motion, forces, both in the study's units
    ice, cut, ledger, momentum, wall_time
"""
from . import body, ice, ledger, loads, momentum, scaled, wall_time
from .catalogue import Missing, Series, SERIES, VALUES
from .run import Run
