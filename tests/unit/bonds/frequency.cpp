/// The largest frequency against a dense matrix and against closed forms, and the time step that follows.
#include <gtest/gtest.h>

#include "Cluster.h"
#include "bond_frequency.h"
#include "contact_frequency.h"

using namespace frazil;

namespace
{

VibratingSpheres spheresOf(const Cluster& cluster)
{
    return {Cluster::count,
            Cluster::count,
            cluster.id.data(),
            cluster.mass.data(),
            cluster.radius.data(),
            [](std::vector<double>&) {},
            [](double here) { return here; }};
}

/// Largest eigenvalue of M^-1 K by 20000 steps of the power method.
double slowEigenvalue(const Cluster& cluster, const BondMaterial& material)
{
    std::vector<double> u(6 * Cluster::count), inertia(u.size());
    for (std::size_t n = 0; n < u.size(); ++n) {
        const double r = cluster.radius[n / 6], m = cluster.mass[n / 6];
        inertia[n] = n % 6 < 3 ? m : 0.4 * m * r * r;
        u[n] = std::cos(1.7 * n) / std::sqrt(inertia[n]);
    }
    double eigenvalue = 0;
    for (int iteration = 0; iteration < 20000; ++iteration) {
        std::vector<double> next(u.size(), 0);
        addStiffnessTimes(cluster.table, material, u, next);
        double above = 0, below = 0, length = 0;
        for (std::size_t n = 0; n < u.size(); ++n) {
            above += next[n] * u[n];
            below += inertia[n] * u[n] * u[n];
            next[n] /= inertia[n];
            length += inertia[n] * next[n] * next[n];
        }
        eigenvalue = above / below; // Rayleigh's quotient
        for (std::size_t n = 0; n < u.size(); ++n)
            u[n] = next[n] / std::sqrt(length);
    }
    return eigenvalue;
}

} // namespace

TEST(BondFrequency, EqualsThatOfTheWholeMatrix)
{
    const BondOptions options(bondWords());
    const Cluster cluster(options);
    const double slow = std::sqrt(slowEigenvalue(cluster, options.material));
    const double fast = largestFrequency(cluster.table, options.material, spheresOf(cluster));
    EXPECT_NEAR(fast, slow, 5e-3 * slow);
    EXPECT_LE(fast, slow * (1 + 1e-9)); // Lanczos comes from below
}

TEST(BondFrequency, TwoSpheresOnAStiffAxis)
{
    // Thin discs of great length between equal spheres: only the axial mode is left, w^2 = 2 kn A/m
    Settings words = bondWords();
    words.set("stiffness_ratio", "1e9");
    words.set("radius_factor", "1e-4");
    const BondOptions options(words);
    Cluster cluster(options);
    cluster.table.clear();
    cluster.position[1] = cluster.position[0] + Vec3{0.002, 0, 0};
    cluster.mass[1] = cluster.mass[0];
    cluster.radius[1] = cluster.radius[0];
    cluster.bond(0, 1, options);
    const BondStiffness k = stiffnessOf(options.material, cluster.table.restLength[0], cluster.table.radius[0]);
    EXPECT_NEAR(largestFrequency(cluster.table, options.material, spheresOf(cluster)),
                std::sqrt(2 * k.normal / cluster.mass[0]), 1e-6 * std::sqrt(2 * k.normal / cluster.mass[0]));
}

TEST(BondFrequency, RigidMotionsMeetNoStiffness)
{
    const BondOptions options(bondWords());
    const Cluster cluster(options);
    std::vector<double> u(6 * Cluster::count), result(u.size(), 0);
    const Vec3 velocity{0.1, -0.2, 0.3}, omega{5, -7, 11};
    for (int i = 0; i < Cluster::count; ++i) {
        const Vec3 moved = velocity + cross(omega, cluster.position[i]);
        for (int axis = 0; axis < 3; ++axis)
            u[6 * i + axis] = moved[axis], u[6 * i + 3 + axis] = omega[axis];
    }
    addStiffnessTimes(cluster.table, options.material, u, result);
    const BondStiffness k = stiffnessOf(options.material, cluster.table.restLength[0], cluster.table.radius[0]);
    for (double force : result)
        EXPECT_LE(std::abs(force), 1e-12 * k.normal);
}

TEST(BondFrequency, NoBondsNoFrequency)
{
    const BondOptions options(bondWords());
    Cluster cluster(options);
    cluster.table.clear();
    EXPECT_EQ(largestFrequency(cluster.table, options.material, spheresOf(cluster)), 0);
    EXPECT_EQ(largestDashpotTime(cluster.table, options.material), 0);
}

TEST(StepLimit, SolvesTheConditionOfVerletsScheme)
{
    EXPECT_DOUBLE_EQ(stepLimit(9, 16, 0).critical, 0.4); // 2/5
    EXPECT_DOUBLE_EQ(stepLimit(9, 16, 0).stable, 0.4);
    const double dt = stepLimit(9, 16, 0.1).stable;
    EXPECT_NEAR(4 - dt * dt * 25 - 2 * dt * 0.1 * 9, 0, 1e-14);
    EXPECT_LT(dt, 0.4);
}

TEST(Contact, ModuliOfEqualMaterialsByHand)
{
    const ContactModuli moduli(2e9, 0.25, 2e9, 0.25);
    EXPECT_DOUBLE_EQ(moduli.normal, 2e9 / (2 * (1 - 0.0625)));
    EXPECT_DOUBLE_EQ(moduli.tangential, 2e9 / (4 * 1.75 * 1.25)); // G/(2 (2 - nu)), G = E/(2 (1 + nu))
}

TEST(Contact, TheOverlapOfAnImpactHoldsItsEnergy)
{
    const ContactModuli moduli(2e9, 0.25, 2e9, 0.25);
    const double m = 4e-6, r = 0.001, v = 3, overlap = moduli.impactOverlap(m, r, v);
    EXPECT_NEAR(8.0 / 15 * moduli.normal * std::sqrt(r) * std::pow(overlap, 2.5), 0.5 * m * v * v, 1e-15);
}
