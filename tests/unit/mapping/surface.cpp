/// The plane of the water's surface in a coarse cell, and the share of a sphere below it.
#include <gtest/gtest.h>

#include <cmath>

#include "WaterSurface.h"

using namespace frazil;

namespace
{

const double h = 2; // coarse cell [m]

/// A grid of 1 x 1 x n cells of 2 m, and its water below a plane, summed over small boxes.
struct Tank {
    CoarseGrid grid;
    LocalCells cells{grid, 0};
    CoarseField<CoarseFluid> fluid;
    CoarseField<WaterSurface> surface;
    CoarseField<Box> filled;

    Tank(int height, const Vec3& normal, double level) : grid(Box{{0, 0, 0}, {h, h, h * height}}, h, 1, {})
    {
        fluid.reset(cells);
        surface.reset(cells);
        filled.reset(cells);
        for (int c = 0; c < cells.count(); ++c) {
            fill(c, normal, level);
            filled[c] = box(c);
            surface[c] = surfaceIn(box(c), fluid[c]);
        }
    }
    SphereShare sphereAt(double z, double r) const
    {
        return shareOfSphere({1, 1, z}, r, cells, filled, fluid, surface);
    }
    Box box(int cell) const { return grid.cellBox(grid.index(cells.global(cell))); }
    void fill(int cell, const Vec3& normal, double level)
    {
        const int n = 40;
        const double dx = h / n;
        const Vec3 low = box(cell).min, centre = grid.centre(cells.global(cell));
        for (int i = 0; i < n * n * n; ++i) {
            const Vec3 corner = low + dx * Vec3{double(i % n), double(i / n % n), double(i / n / n)};
            const Box small{corner, corner + Vec3{dx, dx, dx}};
            const double wet = shareBelow(small, normal, level), volume = dx * dx * dx;
            const Vec3 place = corner + 0.5 * small.size() - centre;
            fluid[cell].openVolume += volume;
            fluid[cell].openWater += wet * volume;
            fluid[cell].waterMoment += wet * volume * place;
        }
    }
};

} // namespace

TEST(WaterSurface, ShareOfABoxBelowAPlane)
{
    const Box box{{1, 2, 3}, {2, 4, 6}};
    EXPECT_NEAR(shareBelow(box, {0, 0, 1}, 4), 1.0 / 3, 1e-15);
    EXPECT_NEAR(shareBelow(box, {0, 0, -1}, -4), 2.0 / 3, 1e-15);
    EXPECT_NEAR(shareBelow(box, {1, 0.5, 0}, 3), 0.5, 1e-15);           // through the middle
    EXPECT_NEAR(shareBelow(box, {1, 0.5, 1.0 / 3}, 4), 1.0 / 6, 1e-15); // the unit corner: (1·1·1)/6 of the unit cube
    EXPECT_NEAR(shareBelow(box, {1, 0.5, 1.0 / 3}, 3.5), 0.125 / 6, 1e-15);
    EXPECT_NEAR(shareBelow(box, {1e-14, 0, 1}, 4), 1.0 / 3, 1e-12);
    EXPECT_EQ(shareBelow(box, {0, 1, 0}, 1), 0);
    EXPECT_EQ(shareBelow(box, {0, 1, 0}, 5), 1);
}

TEST(WaterSurface, FlatSurfaceIsFound)
{
    for (const double level : {0.13, 1.0, 1.71}) {
        const Tank tank(1, {0, 0, 1}, level);
        EXPECT_NEAR(tank.surface[0].normal.z, 1, 1e-11);
        EXPECT_NEAR(tank.surface[0].level, level, 1e-11);
        EXPECT_EQ(tank.surface[0].sharpness, 1);
    }
}

TEST(WaterSurface, SlopedSurfaceKeepsItsVolumeAndNearlyItsDirection)
{
    for (const Vec3& slope : {Vec3{1, 0, 1}, Vec3{1, 1, 1}, Vec3{-0.3, 0.2, 1}, Vec3{0.1, -2, 0.5}}) {
        const Vec3 normal = slope / norm(slope);
        for (const double above : {-0.5, 0.0, 0.4}) {
            const double level = dot(normal, {1, 1, 1}) + above;
            const Tank tank(1, normal, level);
            const Box cell = tank.box(0);
            EXPECT_NEAR(shareBelow(cell, tank.surface[0].normal, tank.surface[0].level),
                        shareBelow(cell, normal, level), 1e-12);
            EXPECT_GT(dot(tank.surface[0].normal, normal), std::cos(8 * 3.1416 / 180));
            EXPECT_EQ(tank.surface[0].sharpness, 1);
        }
    }
}

TEST(WaterSurface, EvenMixtureHasNoPlane)
{
    Tank tank(1, {0, 0, 1}, 0);
    tank.fluid[0].openWater = 0.4 * tank.fluid[0].openVolume;
    const WaterSurface surface = surfaceIn(tank.box(0), tank.fluid[0]);
    EXPECT_EQ(surface.sharpness, 0);
    EXPECT_NEAR(surface.shareOf({{0, 0, 1.9}, {1, 1, 2}}), 0.4, 1e-15);
}

/// A cube of the sphere's volume has the edge a = 1.612 r.
TEST(WaterSurface, SphereSinksThroughSurfaceAndCellFace)
{
    const double r = 0.5, a = std::cbrt(4.0 / 3 * 3.14159265358979323846) * r;
    for (const double level : {1.3, 1.9, 2.0, 2.1}) { // in either cell, and on the face between them
        const Tank tank(2, {0, 0, 1}, level);
        for (double z = 0.6; z < 3.4; z += 0.05) {
            const double expected = std::min(1.0, std::max(0.0, 0.5 + (level - z) / a));
            EXPECT_NEAR(tank.sphereAt(z, r).inWater, expected, 1e-10) << level << z;
            EXPECT_NEAR(tank.sphereAt(z, r).inMesh, 1, 1e-14);
        }
    }
}

TEST(WaterSurface, CellsWithoutFluidAreLeftOut)
{
    Tank tank(2, {0, 0, 1}, 1);
    tank.fluid[1] = CoarseFluid{};
    EXPECT_NEAR(tank.sphereAt(2, 0.5).inWater, 0, 1e-15);
    EXPECT_FALSE(tank.sphereAt(2, 0.5).dry);
    EXPECT_TRUE(tank.sphereAt(3.2, 0.5).dry);
}

/// Half of the upper cell is outside of the mesh: a sphere leaves as its volume does, and not at once.
TEST(WaterSurface, SphereLeavesTheMesh)
{
    Tank tank(2, {0, 0, 1}, 1);
    tank.filled[1].max.z = 3;
    const double r = 0.5, a = std::cbrt(4.0 / 3 * 3.14159265358979323846) * r;
    for (const double z : {2.0, 2.8, 3.0, 3.2, 3.4, 3.9})
        EXPECT_NEAR(tank.sphereAt(z, r).inMesh, std::min(1.0, std::max(0.0, 0.5 + (3 - z) / a)), 1e-14) << z;
}

/// Water of 0.2 m over a floor that lies 1.2 m above the cell's lower face: the plane is cut in what is open.
TEST(WaterSurface, SurfaceOverAFloorInsideTheCell)
{
    const Box cell{{0, 0, 0}, {h, h, h}};
    CoarseFluid fluid;
    MeshShare mesh{4 * 0.8, {0, 0, 4 * 0.8 * 0.6}}; // from 1.2 to 2
    fluid.openVolume = mesh.volume;
    fluid.openMoment = mesh.moment;
    fluid.openWater = 4 * 0.2;
    fluid.waterMoment = {0, 0, 4 * 0.2 * 0.3}; // from 1.2 to 1.4
    const Box filled = filledBox(cell, mesh);
    EXPECT_NEAR(filled.min.z, 1.2, 1e-14);
    EXPECT_NEAR(filled.max.z, 2, 1e-14);
    const WaterSurface surface = surfaceIn(filled, fluid);
    EXPECT_NEAR(surface.level, 1.4, 1e-12);
    EXPECT_EQ(surface.sharpness, 1);
    EXPECT_NEAR(surface.shareOf({{0.5, 0.5, 1.25}, {0.6, 0.6, 1.35}}), 1, 1e-12) << "submerged";
}

TEST(WaterSurface, ASlantedWallLeavesTheWholeCell)
{
    const Box cell{{0, 0, 0}, {h, h, h}}; // the half below the diagonal of x and z
    const Box filled = filledBox(cell, {4, {-4.0 / 3, 0, -4.0 / 3}});
    EXPECT_EQ(filled.max.z, h);
    EXPECT_EQ(filled.min.z, 0);
    EXPECT_EQ(norm(filledBox(cell, {}).size()), 0) << "no mesh";
}
