/// The catalogue of drag laws. Each gives the same dimensionless number
///
///   F(Re, αf) = K / (3 π μ D),   drag = K (u - up),   Re = αf ρ D |u - up| / μ   (superficial)
///
/// that is, the drag in units of Stokes' drag, as a pure function of two dimensionless numbers. Every law is finite as
/// Re -> 0 and free of divisions by Re. K is the force per particle of model A (physics: fd = V β_d/(1-αf) (u - up));
/// the pressure gradient acts on top of it. 0 < αf <= 1. Laws compose: a closure for dense beds takes its dilute limit
/// from the single-sphere law. To add one: its header, its name in
/// DragLaw, its test and its row in couplingProperties.md (dualgrid/doc/adding.md).
#pragma once

#include <variant>

#include "Beetstra.h"
#include "DiFelice.h"
#include "Gidaspow.h"
#include "KochHill.h"
#include "SchillerNaumann.h"

namespace frazil
{

/// No drag at all: to see what the other forces do.
struct NoDrag {
    static constexpr const char* name = "none";
    static constexpr const char* source = "to see what the other forces do";

    double operator()(double, double) const { return 0; }
};

/// The first is the default.
using DragLaw = std::variant<DiFelice, Gidaspow, SchillerNaumann, KochHill, Beetstra, NoDrag>;

} // namespace frazil
