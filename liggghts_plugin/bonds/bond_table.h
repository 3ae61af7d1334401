/* The bonds that a rank works on, as contiguous columns, and their resting place with the particles.

   BondTable: one row per bond with at least one owned sphere; sphere 1 is the one with the lower id. Local indices are
   cached between reneighbourings, so that the step loop looks nothing up. A bond between two ranks has a row on both:
   both see the same state and evaluate the same expressions, so both break it in the same step without a message.

   BondStore: the same bonds as halves, listed per owned sphere, while spheres migrate, are sorted, deleted or written
   to restart files. Halves lie in one pool; a sphere holds its first half and their number. */

#ifndef FRAZIL_BOND_TABLE_H
#define FRAZIL_BOND_TABLE_H

#include "parallel_bond.h"

#include <array>
#include <vector>

namespace frazil
{

class BondTable
{
  public:
    /// Columns of the state (units: BondState), in the order in which they travel with the particles.
    enum StateColumn { separation = 0, shear = 3, bending = 6, torsion = 9, stateColumns = 10 };

    std::vector<int> id1, id2;         ///< id1 < id2
    std::vector<int> at1, at2;         ///< local indices to read positions from (the closest image)
    std::vector<int> target1, target2; ///< local indices to add forces to; owned below the number of owned spheres
    std::array<std::vector<double>, stateColumns> state;
    std::vector<double> restLength, radius, share, strength; ///< [m], [m], [-], [-]
    std::vector<double> reducedMass, reducedInertia;         ///< [kg], [kg m2]

    std::size_t size() const { return id1.size(); }

    void clear()
    {
        forEachColumn([](auto& column) { column.clear(); });
    }

    /// Adds a row of zeros and returns its number.
    std::size_t add()
    {
        forEachColumn([](auto& column) { column.push_back(0); });
        return size() - 1;
    }

    /// Row k is overwritten by the last one.
    void remove(std::size_t k)
    {
        forEachColumn([k](auto& column) {
            column[k] = column.back();
            column.pop_back();
        });
    }

    BondState stateOf(std::size_t k) const
    {
        const auto vector = [&](int c) { return Vec3{state[c][k], state[c + 1][k], state[c + 2][k]}; };
        return {vector(separation), vector(shear), vector(bending), state[torsion][k]};
    }

    BondShape shapeOf(std::size_t k) const { return {restLength[k], radius[k], share[k], strength[k]}; }

  private:
    template <class Action> void forEachColumn(Action action)
    {
        for (auto* column : {&id1, &id2, &at1, &at2, &target1, &target2})
            action(*column);
        for (auto& column : state)
            action(column);
        for (auto* column : {&restLength, &radius, &share, &strength, &reducedMass, &reducedInertia})
            action(*column);
    }
};

/// One sphere's end of a bond.
struct BondHalf {
    int partner;       ///< id of the other sphere
    double restLength; ///< [m]
    std::array<double, BondTable::stateColumns> state;
    static constexpr int words = 2 + BondTable::stateColumns; ///< doubles in a message or restart record
};

class BondStore
{
  public:
    struct Owner {
        int self = 0;    ///< id of the sphere when its bonds were stored
        int initial = 0; ///< bonds it was created with
        int first = 0, count = 0;
    };

    std::vector<Owner> owners; ///< by local index
    std::vector<BondHalf> pool;

    static constexpr int words(int count) { return 3 + BondHalf::words * count; }

    int pack(int i, double* buffer) const
    {
        const Owner& owner = owners[i];
        int m = 0;
        buffer[m++] = owner.self;
        buffer[m++] = owner.initial;
        buffer[m++] = owner.count;
        for (int h = owner.first; h < owner.first + owner.count; ++h) {
            buffer[m++] = pool[h].partner;
            buffer[m++] = pool[h].restLength;
            for (double value : pool[h].state)
                buffer[m++] = value;
        }
        return m;
    }

    int unpack(int i, const double* buffer)
    {
        int m = 0;
        Owner owner;
        owner.self = static_cast<int>(buffer[m++]);
        owner.initial = static_cast<int>(buffer[m++]);
        owner.count = static_cast<int>(buffer[m++]);
        owner.first = static_cast<int>(pool.size());
        owners[i] = owner;
        for (int h = 0; h < owner.count; ++h) {
            BondHalf half;
            half.partner = static_cast<int>(buffer[m++]);
            half.restLength = buffer[m++];
            for (double& value : half.state)
                value = buffer[m++];
            pool.push_back(half);
        }
        return m;
    }

    /// Takes the halves of the first `owned` spheres from the table; their ids and initial numbers stay.
    void fill(const BondTable& table, int owned)
    {
        for (int i = 0; i < owned; ++i)
            owners[i].count = 0;
        for (std::size_t k = 0; k < table.size(); ++k)
            for (int target : {table.target1[k], table.target2[k]})
                if (target < owned)
                    ++owners[target].count;
        int next = 0;
        for (int i = 0; i < owned; ++i) {
            owners[i].first = next;
            next += owners[i].count;
            owners[i].count = 0;
        }
        pool.resize(next);
        for (std::size_t k = 0; k < table.size(); ++k) {
            put(table, k, table.target1[k], table.id2[k], owned);
            put(table, k, table.target2[k], table.id1[k], owned);
        }
    }

  private:
    void put(const BondTable& table, std::size_t k, int target, int partner, int owned)
    {
        if (target >= owned)
            return;
        BondHalf& half = pool[owners[target].first + owners[target].count++];
        half.partner = partner;
        half.restLength = table.restLength[k];
        for (int c = 0; c < BondTable::stateColumns; ++c)
            half.state[c] = table.state[c][k];
    }
};

} // namespace frazil

#endif
