/// The fast kernel (blocks, vector instructions) against a slow reference: the law bond by bond, written out in numbers
/// of its own, over random bonds and motions. Every entry of state, load, use and power within 1e-12 of its scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "bond_kernel.h"

using namespace frazil;

namespace
{

struct Random {
    std::mt19937 engine{11};
    double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    Vec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

/// What a bond does in one step, as the page of fix bond/parallel has it: plain sums, no shared expressions.
struct Reference {
    Vec3 shear, bending, force, torque1, torque2;
    double torsion, tension, shearUse, power = 0;
};

Vec3 perpendicular(const Vec3& v, const Vec3& n)
{
    return v - dot(v, n) * n;
}

/// v turned by the shortest rotation that takes the unit vector a to the unit vector b (Rodrigues).
Vec3 turnedFromTo(const Vec3& v, const Vec3& a, const Vec3& b)
{
    const Vec3 axis = cross(a, b);
    return v + cross(axis, v) + cross(axis, cross(axis, v)) / (1 + dot(a, b));
}

Vec3 turnedAbout(const Vec3& v, const Vec3& n, double angle)
{
    return v * std::cos(angle) + cross(n, v) * std::sin(angle) + n * (dot(n, v) * (1 - std::cos(angle)));
}

struct Dashpots {
    double normal, shear, torsion, bending;
};

/// Fractions of critical, 2 sqrt(stiffness x inertia), of the four modes.
Dashpots dashpots(const BondMaterial& m, double normal, double shear, double torsion, double bending, double mass,
                  double inertia)
{
    auto c = [](double zeta, double k, double inert) { return 2 * zeta * std::sqrt(k * inert); };
    return {c(m.damping.normal, normal, mass), c(m.damping.shear, shear, mass), c(m.damping.torsion, torsion, inertia),
            c(m.damping.bending, bending, inertia)};
}

Reference reference(const BondState& old, const BondShape& shape, const BondMaterial& m, const Vec3& d, const Vec3& t1,
                    const Vec3& t2, double mass, double inertia, double rate)
{
    const double rb = shape.radius, area = M_PI * rb * rb, i = area * rb * rb / 4, j = 2 * i;
    const double kn = m.young / shape.restLength, ks = kn / m.stiffnessRatio;
    const Vec3 n0 = old.separation / norm(old.separation), n1 = d / norm(d), middle = (n0 + n1) / norm(n0 + n1);
    const double stretch = norm(d) - norm(old.separation);
    const Vec3 centre = 0.5 * (d + old.separation);
    const Vec3 slip =
        perpendicular(d - old.separation - cross(shape.share * t1 + (1 - shape.share) * t2, centre), middle);
    const Vec3 bend = perpendicular(t2 - t1, middle);
    const double twist = 0.5 * dot(t2 - t1, n0 + n1), spin = 2 * std::atan(0.25 * dot(0.5 * (t1 + t2), n0 + n1));
    // Half of an increment acts before the turn. It is perpendicular to the middle direction; the part of it along n1 goes.
    auto carried = [&](const Vec3& v, const Vec3& more) {
        const Vec3 first = 0.5 * (more - (n0 + n1) * (dot(more, n1) / (1 + dot(n0, n1))));
        return perpendicular(turnedAbout(turnedFromTo(v, n0, n1) + first, n1, spin) + 0.5 * more, n1);
    };
    Reference r;
    r.shear = carried(old.shear, ks * area * slip);
    r.bending = carried(old.bending, kn * i * bend);
    r.torsion = old.torsion + ks * j * twist;
    const double axial = kn * (norm(d) - shape.restLength);
    Vec3 force = axial * area * n1 + r.shear, moment = r.torsion * n1 + r.bending;
    const double sigma = axial + m.momentFactor * norm(r.bending) * rb / i;
    const double tau = norm(r.shear) / area + m.momentFactor * std::abs(r.torsion) * rb / j;
    r.tension = sigma / (shape.strength * m.tensileStrength);
    r.shearUse = tau / (shape.strength * m.shearStrength + m.frictionTan * std::max(0.0, -axial));
    if (m.damping.any()) {
        const Dashpots c = dashpots(m, kn * area, ks * area, ks * j, kn * i, mass, inertia);
        force += rate * (c.normal * stretch * n1 + c.shear * slip);
        moment += rate * (c.torsion * twist * n1 + c.bending * bend);
        r.power = rate * rate *
                  (c.normal * stretch * stretch + c.shear * dot(slip, slip) + c.torsion * twist * twist +
                   c.bending * dot(bend, bend));
    }
    r.force = force;
    r.torque1 = shape.share * cross(d, force) + moment;
    r.torque2 = (1 - shape.share) * cross(d, force) - moment;
    return r;
}

Vec3 row(const BondBlock::Row* rows, int b)
{
    return {rows[0][b], rows[1][b], rows[2][b]};
}

void fill(BondTable& table, BondBlock& block, Random& random)
{
    for (int b = 0; b < block.count; ++b) {
        Vec3 direction = random.vector(1);
        direction *= 1 / norm(direction);
        const double length = random(0.0018, 0.0022);
        table.restLength[b] = 0.002, table.radius[b] = random(5e-4, 1.5e-3);
        table.share[b] = random(0.3, 0.7), table.strength[b] = random(0.5, 1.5);
        table.reducedMass[b] = random(1e-6, 1e-5), table.reducedInertia[b] = random(1e-12, 1e-11);
        const Vec3 d = length * direction;
        const Vec3 shear = perpendicular(random.vector(2), direction),
                   bend = perpendicular(random.vector(1e-3), direction);
        const double columns[] = {d.x,     d.y,    d.z,    shear.x, shear.y,
                                  shear.z, bend.x, bend.y, bend.z,  random(-1e-3, 1e-3)};
        for (int c = 0; c < BondTable::stateColumns; ++c)
            table.state[c][b] = columns[c];
        const Vec3 next = d + random.vector(2e-5), t1 = random.vector(0.02), t2 = random.vector(0.02);
        for (int axis = 0; axis < 3; ++axis) {
            block.separation[axis][b] = next[axis];
            block.turn1[axis][b] = t1[axis];
            block.turn2[axis][b] = t2[axis];
        }
    }
}

void compare(const BondMaterial& material)
{
    BondTable table;
    const int count = BondBlock::capacity - 3; // not a whole number of vectors
    for (int b = 0; b < count; ++b)
        table.add();
    BondBlock block(table, 0, count);
    Random random;
    fill(table, block, random);
    const double rate = 1e6, limit = 1e-12;
    std::vector<Reference> expected;
    for (int b = 0; b < count; ++b)
        expected.push_back(reference(table.stateOf(b), table.shapeOf(b), material, row(block.separation, b),
                                     row(block.turn1, b), row(block.turn2, b), table.reducedMass[b],
                                     table.reducedInertia[b], rate));
    advanceBlock(block, material, rate);
    auto near = [&](const Vec3& a, const Vec3& b, double scale) { EXPECT_LE(norm(a - b), limit * scale); };
    for (int b = 0; b < count; ++b) {
        const Reference& e = expected[b];
        const BondState state = table.stateOf(b);
        const double force = norm(e.force) + 2, moment = norm(e.torque1) + norm(e.torque2) + 1e-3;
        near(state.shear, e.shear, force);
        near(state.bending, e.bending, moment);
        EXPECT_NEAR(state.torsion, e.torsion, limit * moment);
        near(row(block.force, b), e.force, force);
        near(row(block.torque1, b), e.torque1, moment);
        near(row(block.torque2, b), e.torque2, moment);
        EXPECT_NEAR(block.useTension[b], e.tension, limit * (1 + std::abs(e.tension)));
        EXPECT_NEAR(block.useShear[b], e.shearUse, limit * (1 + std::abs(e.shearUse)));
        if (material.damping.any()) {
            EXPECT_NEAR(block.power[b], e.power, limit * (1 + e.power));
        }
    }
}

BondMaterial ice()
{
    BondMaterial m;
    m.young = 5e8, m.stiffnessRatio = 2.66, m.tensileStrength = 1.2e6, m.shearStrength = 0.8e6;
    return m;
}

} // namespace

TEST(BondKernel, ElasticBonds)
{
    compare(ice());
}

TEST(BondKernel, MomentsCountInPart)
{
    BondMaterial material = ice();
    material.momentFactor = 0.3;
    compare(material);
}

TEST(BondKernel, FrictionRaisesTheShearStrength)
{
    BondMaterial material = ice();
    material.frictionTan = 0.7;
    compare(material);
}

TEST(BondKernel, DampedBonds)
{
    BondMaterial material = ice();
    material.damping = {0.1, 0.2, 0.3, 0.4};
    compare(material);
}
