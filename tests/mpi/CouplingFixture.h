/// What the tests of the coupling step share: a fine mesh and spheres shared among the ranks, and one coupling over a
/// communicator.
///
/// The fine mesh is shared in stripes that do not follow the blocks of the coarse grid, its cells straddle coarse cells, it
/// leaves a part of the coarse grid dry, and some particles sit exactly on rank boundaries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "CouplingStep.h"

namespace frazil
{

const Phase water{1000, 1e-3}, air{1.2, 1.8e-5};
const Phase syrup{1000, 1e4}; // drag is linear in it
const Vec3 gravity{0, 0, -9.81};
const Box box{{0, 0, 0}, {6, 5, 5}};
const double deltaT = 0.01;

inline int rankOf(MPI_Comm comm)
{
    int rank;
    MPI_Comm_rank(comm, &rank);
    return rank;
}

inline int sizeOf(MPI_Comm comm)
{
    int size;
    MPI_Comm_size(comm, &size);
    return size;
}

/// 13 x 9 x 11 boxes over x < 4.6, water below z = 2.4; this rank's share of them, and where each is in the whole.
struct FineMesh {
    std::vector<int> whole;
    std::vector<Box> cell;
    std::vector<double> volume, epsilon, open, density, wet;
    std::vector<Vec3> velocity, gradient, viscous, acceleration, vorticity;

    FineMesh(int rank, int ranks, double length)
    {
        const int n[3] = {13, 9, 11};
        for (int f = 0; f < n[0] * n[1] * n[2]; ++f) {
            const int i[3] = {f % n[0], f / n[0] % n[1], f / n[0] / n[1]};
            if ((i[0] + 2 * i[1] + i[2]) / 7 % ranks == rank)
                add(f, i, n, length);
        }
    }
    void add(int f, const int* i, const int* n, double length)
    {
        const Vec3 size{length / n[0], box.max.y / n[1], box.max.z / n[2]};
        const Vec3 low{i[0] * size.x, i[1] * size.y, i[2] * size.z};
        whole.push_back(f);
        cell.push_back({low, low + size});
        volume.push_back(size.x * size.y * size.z);
        open.push_back(f % 23 == 0 ? 0.0 : f % 19 == 0 ? 0.4 : 1.0);
        epsilon.push_back(open.back() * (0.9 + 0.1 * std::sin(f)));
        wet.push_back(low.z < 2.4 ? 1 : 0);
        density.push_back(wet.back() > 0 ? water.density : air.density);
        velocity.push_back({std::sin(f), 0.1 * i[0], std::cos(f)});
        gradient.push_back(density.back() * gravity);
        viscous.push_back({0.01 * f, 0, 1});
        acceleration.push_back({0, std::cos(2 * f), 0});
        vorticity.push_back({1, 2, std::sin(3 * f)});
    }
    FineFlow flow() const
    {
        return {volume.size(),   volume.data(),   epsilon.data(), open.data(),         density.data(),  wet.data(),
                velocity.data(), gradient.data(), viscous.data(), acceleration.data(), vorticity.data()};
    }
    std::vector<FinePiece> pieces(const CoarseGrid& grid) const
    {
        std::vector<FinePiece> pieces;
        for (std::size_t f = 0; f < cell.size(); ++f) {
            clipBox(cell[f], grid, [&](std::int64_t c, double v, const Vec3& x) {
                pieces.push_back({int(f), c, v, x});
            });
        }
        return pieces;
    }
    int cellAt(const Vec3& p) const
    {
        for (std::size_t f = 0; f < cell.size(); ++f) {
            if (cell[f].contains(p))
                return int(f);
        }
        return -1;
    }
};

/// Spheres all over the coarse grid, those that `grid` gives to `owner`.
struct Spheres {
    std::vector<std::int64_t> id;
    std::vector<Vec3> position, velocity, spin, impulse;
    std::vector<double> radius, exposure;

    Spheres(const CoarseGrid& grid, int owner, int step)
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> u(0, 1);
        for (int n = 0; n < 400; ++n) {
            Vec3 p{6 * u(random), 5 * u(random), 5 * u(random)};
            if (n % 9 == 0)
                p.x = 3; // where blocks meet
            if (n % 10 == 0)
                p.y = 2;
            if (n < 150)
                p = {1.2 + 0.5 * p.x / 6, 1.4 + 0.4 * p.y / 5, 1.3 + 0.2 * p.z / 5}; // a heap that is clipped
            if (grid.ownerOf(p) != owner)
                continue;
            id.push_back(n);
            position.push_back(p);
            velocity.push_back({0.1 * n, 1, -1});
            spin.push_back({0, 0, 1});
            radius.push_back(0.1 + 0.001 * (n % 50));
            exposure.push_back(1);
            impulse.push_back({std::sin(n + step), 2, std::cos(2 * n)});
        }
    }
    ParticleView view() const
    {
        return {id.size(),   id.data(),     position.data(), velocity.data(),
                spin.data(), radius.data(), exposure.data(), impulse.data()};
    }
};

/// One coupling over a communicator.
struct Coupling {
    MPI_Comm comm;
    CoarseGrid grid;
    std::unique_ptr<FineMesh> mesh;
    CouplingStep step;
    std::vector<Interaction> replies;
    std::vector<std::int64_t> id;
    FineSource source;
    Ledger ledger;

    Coupling(MPI_Comm comm, const Settings& settings, const Phase& liquid = water)
        : comm(comm), grid(box, 1, sizeOf(comm), gravity), step(settings, grid, liquid, air, gravity, comm)
    {
    }
    void advance(double length, int number)
    {
        mesh = std::make_unique<FineMesh>(rankOf(comm), sizeOf(comm), length);
        step.setParts(mesh->pieces(grid));
        step.setLocator([this](const Vec3& p) { return mesh->cellAt(p); });
        const Spheres spheres(grid, rankOf(comm), number);
        id = spheres.id;
        ledger = step.advance(spheres.view(), mesh->flow(), deltaT, replies, source);
    }
};

} // namespace frazil
