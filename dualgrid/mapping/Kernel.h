/// The kernels: each makes the stencil of a point, of at most Stencil::capacity cells in the ring around the particle's
/// own, with weights that sum to one. To add one: its header, its word in Kernel, its row in the test of all kernels
/// (dualgrid/doc/adding.md).
#pragma once

#include <variant>

#include "CentreCell.h"
#include "Trilinear.h"

namespace frazil
{

/// The first is the default.
using Kernel = std::variant<Trilinear, CentreCell>;

} // namespace frazil
