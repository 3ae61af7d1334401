/// A random heap of bonded spheres, as a rank holds it: more bonds than a block of the kernel takes.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "bond_options.h"
#include "bond_shape.h"
#include "bond_step.h"

namespace frazil
{

inline Settings bondWords()
{
    Settings words("", "", Settings::Form::script);
    for (const auto& [key, value] : {std::pair<const char*, const char*>{"young", "5e8"},
                                     {"stiffness_ratio", "2.66"},
                                     {"tensile_strength", "1e30"},
                                     {"shear_strength", "1e30"}})
        words.set(key, value);
    return words;
}

struct Cluster {
    static constexpr int count = 60;
    std::mt19937 engine{7};
    std::vector<Vec3> position, velocity, spin, force, torque;
    std::vector<double> mass, radius;
    std::vector<int> id;
    BondTable table;

    /// Spheres of about 1 mm, each bonded to the four before it.
    explicit Cluster(const BondOptions& options)
        : position(count), velocity(count), spin(count), force(count), torque(count)
    {
        for (int i = 0; i < count; ++i) {
            position[i] = Vec3{0.002 * i, 0, 0} + random(0.0005);
            velocity[i] = random(0.5);
            spin[i] = random(200);
            radius.push_back(0.001 + 0.0002 * std::sin(i));
            mass.push_back(4e-6 * (1 + 0.3 * std::cos(i)));
            id.push_back(i + 1);
            for (int j = std::max(0, i - 4); j < i; ++j)
                bond(j, i, options);
        }
    }

    void bond(int i, int j, const BondOptions& options)
    {
        const std::size_t k = table.add();
        table.id1[k] = id[i], table.id2[k] = id[j];
        table.at1[k] = table.target1[k] = i;
        table.at2[k] = table.target2[k] = j;
        const Vec3 d = position[j] - position[i];
        table.restLength[k] = norm(d);
        for (int axis = 0; axis < 3; ++axis)
            table.state[BondTable::separation + axis][k] = d[axis];
        completeRow(table, k, options, {radius[i], mass[i]}, {radius[j], mass[j]});
    }

    /// What a step of dt [s] with these velocities does to the positions.
    void move(double dt)
    {
        for (int i = 0; i < count; ++i)
            position[i] += dt * velocity[i];
    }

    BondSpheres spheres()
    {
        for (int i = 0; i < count; ++i)
            force[i] = torque[i] = Vec3();
        return {count, count, &position[0].x, &velocity[0].x, &spin[0].x, &force[0].x, &torque[0].x};
    }

    Vec3 random(double size)
    {
        std::uniform_real_distribution<double> one(-size, size);
        return {one(engine), one(engine), one(engine)};
    }
};

} // namespace frazil
