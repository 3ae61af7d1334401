"""`frazil calibrate`: bond parameters whose specimens have the stiffness and the strengths of a given ice.

Bulk values that can be asked for: E in tension, Poisson's ratio ν, strength in bending, in compression, and in tension. The bonds
have a ratio κ = kn/ks, which ν fixes alone (or it is given); a modulus E_b, which E fixes then; a tensile strength σc, which bending
and tension share; a shear strength τc, which compression fixes. So bending and tension together ask for more than the bonds have,
and the table says what both can be. ν is that in the plate's plane, across the pull: with it the plate bends.

    theory.py     the lattice's closed form: the first guess, and which targets exclude each other
    specimens.py  ice_tension, ice_compression, ice_bending with given bonds, several at a time
    fit.py        correct, measure, until all targets are met
    result.py     table, file, lines for the script
"""
