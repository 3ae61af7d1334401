"""Heads of LIGGGHTS scripts: SI units, granular spheres, Hertz contacts."""

CONTACTS = """fix m1 all property/global youngsModulus peratomtype {young}
fix m2 all property/global poissonsRatio peratomtype {poisson}
fix m3 all property/global coefficientRestitution peratomtypepair 1 {restitution}
fix m4 all property/global coefficientFriction peratomtypepair 1 {friction}
{more}pair_style gran model hertz tangential history
pair_coeff * *
"""
GRAVITY = "fix gravity all gravity 9.81 vector 0 -1 0\n"


def contacts(young="5e6", poisson=0.45, restitution=0.3, friction=0.5, more=""):
    """One material; young [Pa] as LIGGGHTS is to read it."""
    return CONTACTS.format(young=young, poisson=poisson, restitution=restitution, friction=friction, more=more)


def box(low, high):
    """Commands that create an empty box between two corners [m]."""
    sides = " ".join(f"{a} {b}" for a, b in zip(low, high))
    return f"region box block {sides} units box\ncreate_box 1 box\n"


def setting(create, boundary="f f f", skin=0.002, processors="* * *", sort=""):
    """Up to the neighbour lists. create: the commands that make box and spheres; skin [m]; sort: words for atom_modify."""
    bounds = f"boundary {boundary}\n" if boundary else ""
    return (f"units si\natom_style granular\natom_modify map array{sort}\n{bounds}newton off\ncommunicate single vel yes\n"
            f"processors {processors}\n{create.rstrip()}\nneighbor {skin} bin\nneigh_modify delay 0\n")


def head(create, boundary="f f f", skin=0.002, processors="* * *", sort="", **material):
    """The same, and the contact law."""
    return setting(create, boundary, skin, processors, sort) + contacts(**material)
