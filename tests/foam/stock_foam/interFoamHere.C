/*---------------------------------------------------------------------------*\
    Frazil: LIGGGHTS-OpenFOAM coupling. GPL-3.0-or-later, see LICENSE.

Application
    interFoamHere

Description
    OpenFOAM's own interFoam.C, unchanged, with this project's compiler and flags: what frazilFoam is to equal without
    constant/couplingProperties. An installed interFoam rounds differently, and where it was vectorised wrongly
    (FindOpenFOAM.cmake says when) it is no reference on meshes whose cells are not aligned with the axes.
\*---------------------------------------------------------------------------*/

#include "interFoam.C"
