/// Small questions that both schemes ask: where is a particle, which coarse cells do the fine cells touch.
#pragma once

#include <cstdint>
#include <vector>

#include "LocalCells.h"
#include "Overlap.h"
#include "ParticleView.h"

namespace frazil
{

/// Owned local cell that holds particle i. InputError, naming the particle and the cure, if this rank does not own it.
int homeOf(const ParticleView& particles, std::size_t i, const LocalCells& cells);

/// Global ids of the coarse cells with pieces, ascending, each once.
std::vector<std::int64_t> touchedCells(const std::vector<FinePiece>& pieces);

} // namespace frazil
