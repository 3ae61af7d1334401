/// Coarse grid -> fine mesh: inverse distance from the coarse nodes (2.25, 2.23), made conservative and bounded.
///
///   node:        φ_n = Σ W_c φ_c / Σ W_c over the cells that share the node             (2.25, equal distances)
///   part:        r_p = Σ_8 w φ_n / Σ w,  w = 1/|x_p - x_n|^exponent;  on a node: φ_n    (2.23)
///   correction:  φ_p = φ_c + ψ_c (r_p - r_c),  r_c = Σ r_p W_p / Σ W_p over the parts of the coarse cell
///
/// Inverse distance alone does not conserve. With r_c taken out, Σ φ_p W_p = φ_c Σ W_p holds in every coarse cell to
/// round-off, for any slope factor 0 <= ψ_c <= 1; and ψ_c, the largest that keeps φ_p within bounds, costs no iteration
/// and clips nothing. Bounds: the given physical ones, and with limiter `cell` also the range of the cell and its
/// nodes, so of the 27 cells around (the study's gradient-limited interpolation). Node values are weighted by W_c: a cell
/// in which a trace of water appears must not count at once as much as a full one.
/// W_p: what the value is per: open volume for αs, fluid mass for an
/// acceleration, so that air is not pushed as if it were water.
/// A fine cell that straddles coarse cells has a part in each, so it averages over all of them.
/// Cost: only coarse cells with a value; per part 8 distances. Parallel: the caller completes `moment` over the halo
/// between shape() and spread().
#pragma once

#include <array>
#include <vector>

#include "CoarseField.h"
#include "FineParts.h"
#include "Vec3.h"

namespace frazil
{

struct ProlongationSettings {
    double exponent = 2;      ///< [-]
    bool limitToCells = true; ///< keep values within the range of the cell and its nodes
};

/// Weights [-] of the eight corners (x fastest) of a coarse cell for a point [m] in it, sum 1.
std::array<double, 8> cornerWeights(const Vec3& point, const Box& cell, double exponent);

/// T: double or Vec3 (each component by itself).
template <class T> class Prolongation
{
  public:
    explicit Prolongation(const ProlongationSettings& settings) : settings_(settings) {}

    /// First half: r_p, and this rank's share of Σ r_p W_p.
    /// @param value    φ_c, ghosts up to date
    /// @param weight   Σ W_p of the whole coarse cell, ghosts up to date; 0 where the cell holds nothing
    /// @param density  W per volume in each fine cell (open fraction [-], or ρ ε [kg/m3])
    /// @param moment   out: Σ r_p W_p, to be completed over the halo
    void shape(const FineParts& parts, const LocalCells& cells, const CoarseField<T>& value,
               const CoarseField<double>& weight, const double* density, CoarseField<T>& moment);

    /// Second half: φ_p W_p of each part.
    /// @param lowest, highest  physical bounds of φ; ±infinity for none
    /// @param amount           out: one entry per part
    void spread(const FineParts& parts, const CoarseField<T>& value, const CoarseField<double>& weight,
                const double* density, const CoarseField<T>& moment, double lowest, double highest,
                std::vector<T>& amount) const;

  private:
    /// What the cells around one coarse cell allow.
    struct Surroundings {
        std::array<T, 8> corner;
        T lowestCorner, highestCorner;
    };
    Surroundings lookAround(const LocalCells& cells, int cell, const CoarseField<T>& value,
                            const CoarseField<double>& weight) const;
    T slopeFactor(const Surroundings& around, const T& value, const T& mean, double lowest, double highest) const;

    ProlongationSettings settings_;
    std::vector<Surroundings> around_; ///< per row of parts
    std::vector<T> raw_;               ///< r_p per part
};

/// Adds the amounts of the parts to their fine cells.
template <class T> void addToCells(const FineParts& parts, const std::vector<T>& amount, T* fine)
{
    std::size_t p = 0;
    for (int row = 0; row < parts.rows(); ++row) {
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part, ++p)
            fine[part->fineCell] += amount[p];
    }
}

} // namespace frazil
