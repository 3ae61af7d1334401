"""Frazil's launcher: what `./frazil` does once it has found Python. A module imports only those of earlier lines:

    places, say, table
    packages, foam_source, build   set-up; foam_source imports packages, build both
    environment, case, run
    failure, watch
    resume, results
    cli
"""
