#include "bond_results.h"

#include <algorithm>
#include <cstdio>
#include <tuple>

namespace frazil
{

BondTotals totalsOf(const BondTable& table, const BondMaterial& material, int owned)
{
    BondTotals totals;
    for (std::size_t k = 0; k < table.size(); ++k) {
        if (table.target1[k] >= owned)
            continue;
        const BondState state = table.stateOf(k);
        const BondShape shape = table.shapeOf(k);
        const BondStiffness stiffness = stiffnessOf(material, shape.restLength, shape.radius);
        totals.elasticEnergy += elasticEnergy(state, stiffness, shape.restLength);
        const BondUse use = useOf(state, stiffness, shape, material);
        totals.useTension = std::max(totals.useTension, use.tension);
        totals.useShear = std::max(totals.useShear, use.shear);
    }
    return totals;
}

SymmetricTensor virialOf(const Vec3& d, const Vec3& f)
{
    return {d.x * f.x,
            d.y * f.y,
            d.z * f.z,
            0.5 * (d.x * f.y + d.y * f.x),
            0.5 * (d.x * f.z + d.z * f.x),
            0.5 * (d.y * f.z + d.z * f.y)};
}

double elasticEnergyOf(const BondTable& table, std::size_t k, const BondMaterial& material)
{
    const double restLength = table.restLength[k];
    return elasticEnergy(table.stateOf(k), stiffnessOf(material, restLength, table.radius[k]), restLength);
}

Vec3 elasticForce(const BondTable& table, std::size_t k, const BondMaterial& material)
{
    const double restLength = table.restLength[k];
    return elasticLoad(table.stateOf(k), stiffnessOf(material, restLength, table.radius[k]), restLength).force;
}

void addBondVirial(const BondTable& table, const BondMaterial& material, int owned, double* const* rows, int column)
{
    for (std::size_t k = 0; k < table.size(); ++k) {
        const SymmetricTensor virial = virialOf(table.stateOf(k).separation, elasticForce(table, k, material));
        const int target[2] = {table.target1[k], table.target2[k]};
        const double share[2] = {table.share[k], 1 - table.share[k]};
        for (int end = 0; end < 2; ++end)
            if (target[end] < owned)
                for (int c = 0; c < 6; ++c)
                    rows[target[end]][column + c] += share[end] * virial[c];
    }
}

BondEvent eventOf(const BondTable& table, std::size_t k, const BondMaterial& material, bool shear, double time,
                  const Vec3& x1)
{
    const BondState state = table.stateOf(k);
    const BondShape shape = table.shapeOf(k);
    const BondStiffness stiffness = stiffnessOf(material, shape.restLength, shape.radius);
    const BondStress stress = stressOf(state, stiffness, shape, material.momentFactor);
    const Vec3 centre = x1 + shape.share * state.separation;
    return {time, table.id1[k], table.id2[k], shear, centre.x, centre.y, centre.z, stress.sigma, stress.tau};
}

bool writeEvents(const std::string& path, bool append, std::vector<BondEvent>& events)
{
    FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
    if (!file)
        return false;
    std::fseek(file, 0, SEEK_END);
    if (std::ftell(file) == 0)
        std::fputs("time,id1,id2,mode,x,y,z,sigma,tau\n", file);
    std::sort(events.begin(), events.end(), [](const BondEvent& a, const BondEvent& b) {
        return std::tie(a.time, a.id1, a.id2) < std::tie(b.time, b.id1, b.id2);
    });
    for (const BondEvent& e : events)
        std::fprintf(file, "%.12g,%d,%d,%s,%.9g,%.9g,%.9g,%.9g,%.9g\n", e.time, e.id1, e.id2,
                     e.shear ? "shear" : "tension", e.x, e.y, e.z, e.sigma, e.tau);
    return std::fclose(file) == 0;
}

} // namespace frazil
