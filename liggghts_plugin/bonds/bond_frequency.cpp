#include "bond_frequency.h"

#include <algorithm>
#include <cmath>

namespace frazil
{

namespace
{

const int iterations = 60;

/// Largest eigenvalue of the symmetric tridiagonal matrix, by bisection on the signs of its pivots.
double largestEigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside)
{
    double low = 0, high = 0;
    for (std::size_t i = 0; i < diagonal.size(); ++i)
        high = std::max(high, diagonal[i] + beside[i] + (i ? beside[i - 1] : 0));
    for (int halving = 0; halving < 50; ++halving) {
        const double x = 0.5 * (low + high);
        bool above = false; // is an eigenvalue above x?
        double pivot = 1;
        for (std::size_t i = 0; i < diagonal.size() && !above; ++i) {
            pivot = diagonal[i] - x - (i ? beside[i - 1] * beside[i - 1] / pivot : 0);
            above = pivot >= 0;
        }
        (above ? low : high) = x;
    }
    return high;
}

/// Lanczos iteration on M^-1 K in the scalar product of M.
class Lanczos
{
  public:
    Lanczos(const BondTable& table, const BondMaterial& material, const VibratingSpheres& spheres)
        : table_(table), material_(material), spheres_(spheres), now_(6 * spheres.all, 0), before_(6 * spheres.all, 0)
    {
        for (int i = 0; i < spheres.owned; ++i)
            for (int c = 0; c < 6; ++c)
                now_[6 * i + c] = std::sin(12.9898 * spheres.id[i] + 78.233 * c) / (c < 3 ? 1 : spheres.radius[i]);
        length_ = std::sqrt(massProduct(now_, now_));
    }

    double largestEigenvalue()
    {
        while (diagonal_.size() < iterations && length_ > 0)
            iterate();
        return diagonal_.empty() ? 0 : frazil::largestEigenvalue(diagonal_, beside_);
    }

  private:
    void iterate()
    {
        for (double& u : now_)
            u /= length_;
        spheres_.fillGhosts(now_);
        std::vector<double> next(6 * spheres_.all, 0);
        addStiffnessTimes(table_, material_, now_, next);
        const double old = diagonal_.empty() ? 0 : length_;
        for (int i = 0; i < spheres_.owned; ++i)
            for (int c = 0; c < 6; ++c)
                next[6 * i + c] = next[6 * i + c] / inertia(i, c) - old * before_[6 * i + c];
        diagonal_.push_back(massProduct(next, now_));
        for (int n = 0; n < 6 * spheres_.owned; ++n)
            next[n] -= diagonal_.back() * now_[n];
        length_ = std::sqrt(massProduct(next, next));
        if (length_ < 1e-9 * diagonal_.front())
            length_ = 0; // the start spans few modes, and they are found
        beside_.push_back(length_);
        before_.swap(now_);
        now_.swap(next);
    }

    /// Mass [kg] or moment of inertia [kg m2] of degree of freedom c of a sphere.
    double inertia(int i, int c) const
    {
        return spheres_.mass[i] * (c < 3 ? 1 : 0.4 * spheres_.radius[i] * spheres_.radius[i]);
    }

    double massProduct(const std::vector<double>& a, const std::vector<double>& b) const
    {
        double here = 0;
        for (int i = 0; i < spheres_.owned; ++i)
            for (int c = 0; c < 6; ++c)
                here += inertia(i, c) * a[6 * i + c] * b[6 * i + c];
        return spheres_.sumOverRanks(here);
    }

    const BondTable& table_;
    const BondMaterial& material_;
    const VibratingSpheres& spheres_;
    std::vector<double> now_, before_;      ///< directions; the start has another length
    std::vector<double> diagonal_, beside_; ///< of the tridiagonal matrix [1/s2]
    double length_;
};

} // namespace

double largestFrequency(const BondTable& table, const BondMaterial& material, const VibratingSpheres& spheres)
{
    return std::sqrt(Lanczos(table, material, spheres).largestEigenvalue());
}

void addStiffnessTimes(const BondTable& table, const BondMaterial& material, const std::vector<double>& u,
                       std::vector<double>& result)
{
    const auto at = [&](int i, int c) { return Vec3{u[6 * i + c], u[6 * i + c + 1], u[6 * i + c + 2]}; };
    const auto add = [&](int i, int c, const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis)
            result[6 * i + c + axis] += v[axis];
    };
    for (std::size_t k = 0; k < table.size(); ++k) {
        const BondStiffness s = stiffnessOf(material, table.restLength[k], table.radius[k]);
        const int i = table.at1[k], j = table.at2[k];
        const double share = table.share[k];
        const Vec3 d = table.stateOf(k).separation, n = d / norm(d);
        const Vec3 turn1 = at(i, 3), turn2 = at(j, 3);
        const Vec3 slip = at(j, 0) - at(i, 0) - cross(share * turn1 + (1 - share) * turn2, d);
        const Vec3 bend = turn2 - turn1;
        const Vec3 f = s.shear * slip + (s.normal - s.shear) * dot(slip, n) * n;
        const Vec3 m = s.bending * bend + (s.torsion - s.bending) * dot(bend, n) * n;
        const Vec3 lever = cross(d, f);
        add(table.target1[k], 0, -f);
        add(table.target2[k], 0, f);
        add(table.target1[k], 3, -(share * lever + m));
        add(table.target2[k], 3, -((1 - share) * lever - m));
    }
}

double largestDashpotTime(const BondTable& table, const BondMaterial& material)
{
    double largest = 0;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const BondStiffness s = stiffnessOf(material, table.restLength[k], table.radius[k]);
        const BondDashpots c = dashpotsOf(s, material.damping, table.reducedMass[k], table.reducedInertia[k]);
        largest =
            std::max({largest, c.normal / s.normal, c.shear / s.shear, c.torsion / s.torsion, c.bending / s.bending});
    }
    return largest;
}

StepLimit stepLimit(double bonds, double contacts, double dashpotTime)
{
    const double all = bonds + contacts, drag = dashpotTime * bonds;
    return {2 / std::sqrt(all), (std::sqrt(drag * drag + 4 * all) - drag) / all};
}

} // namespace frazil
