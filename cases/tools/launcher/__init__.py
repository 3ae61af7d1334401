"""Frazil's launcher: what `./frazil` does once it has found Python. Imports point one way: places <- say <- {packages,
foam_source} <- build <- environment <- {case, run} <- {resume, failure} <- watch, {table} <- results, all <- cli."""
