"""Frazil's launcher: what `./frazil` does once it has found Python. Imports point one way, from the right to the left:

    places, say, table <- packages <- foam_source <- build
                                      foam_source <- environment
                                      case, environment <- run <- failure <- watch
                                                           run <- resume, results
    all of these <- cli
"""
