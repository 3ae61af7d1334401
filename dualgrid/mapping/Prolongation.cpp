#include "Prolongation.h"

#include <algorithm>
#include <cmath>

namespace frazil
{

namespace
{

template <class T> constexpr int components = int(sizeof(T) / sizeof(double));

double& component(double& value, int)
{
    return value;
}
double component(const double& value, int)
{
    return value;
}
double& component(Vec3& value, int i)
{
    return value[i];
}
double component(const Vec3& value, int i)
{
    return value[i];
}

template <class T> bool isZero(const T& value)
{
    for (int i = 0; i < components<T>; ++i) {
        if (component(value, i) != 0)
            return false;
    }
    return true;
}

template <class T> void widen(T& low, T& high, const T& value)
{
    for (int i = 0; i < components<T>; ++i) {
        component(low, i) = std::min(component(low, i), component(value, i));
        component(high, i) = std::max(component(high, i), component(value, i));
    }
}

template <class T> T product(T a, const T& b)
{
    for (int i = 0; i < components<T>; ++i)
        component(a, i) *= component(b, i);
    return a;
}

/// Largest share of `swing` that stays within `room`, both of one sign.
double allowed(double room, double swing)
{
    return std::abs(swing) <= std::abs(room) ? 1.0 : std::abs(room / swing);
}

} // namespace

std::array<double, 8> cornerWeights(const Vec3& point, const Box& cell, double exponent)
{
    const Vec3 toMin = point - cell.min, toMax = cell.max - point;
    const double onNode = 1e-20 * dot(cell.size(), cell.size()); // distance² below which the node's value is taken
    std::array<double, 8> weight;
    double sum = 0;
    for (int n = 0; n < 8; ++n) {
        const Vec3 d{n & 1 ? toMax.x : toMin.x, n & 2 ? toMax.y : toMin.y, n & 4 ? toMax.z : toMin.z};
        const double distance2 = dot(d, d);
        if (distance2 <= onNode) {
            weight.fill(0);
            weight[n] = 1;
            return weight;
        }
        sum += weight[n] = exponent == 2 ? 1 / distance2 : std::pow(distance2, -0.5 * exponent);
    }
    for (double& w : weight)
        w /= sum;
    return weight;
}

template <class T>
typename Prolongation<T>::Surroundings Prolongation<T>::lookAround(const LocalCells& cells, int cell,
                                                                   const CoarseField<T>& value,
                                                                   const CoarseField<double>& weight) const
{
    Surroundings around{};
    double shared[8] = {};
    const CellIndex c = cells.grid().index(cells.global(cell));
    for (int n = 0; n < 27; ++n) {
        const int d[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        const int neighbour = cells.local(CellIndex{c[0] + d[0], c[1] + d[1], c[2] + d[2]});
        if (neighbour < 0 || !(weight[neighbour] > 0))
            continue;
        for (int k = 0; k < 8; ++k) {
            const int side[3] = {k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1};
            if (d[0] == -side[0] || d[1] == -side[1] || d[2] == -side[2])
                continue;
            around.corner[k] += weight[neighbour] * value[neighbour];
            shared[k] += weight[neighbour];
        }
    }
    for (int k = 0; k < 8; ++k)
        around.corner[k] *= 1.0 / shared[k]; // the cell itself is among them
    around.lowestCorner = around.highestCorner = around.corner[0];
    for (const T& corner : around.corner)
        widen(around.lowestCorner, around.highestCorner, corner);
    return around;
}

template <class T>
void Prolongation<T>::shape(const FineParts& parts, const LocalCells& cells, const CoarseField<T>& value,
                            const CoarseField<double>& weight, const double* density, CoarseField<T>& moment)
{
    around_.resize(parts.rows());
    raw_.resize(parts.count());
    moment.reset(cells);
    T* raw = raw_.data();
    for (int row = 0; row < parts.rows(); raw += parts.end(row) - parts.begin(row), ++row) {
        const int cell = parts.coarseCell(row);
        if (isZero(value[cell]))
            continue;
        const Surroundings& around = around_[row] = lookAround(cells, cell, value, weight);
        const Box box = cells.grid().cellBox(cells.grid().index(cells.global(cell)));
        T* r = raw;
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part, ++r) {
            const auto w = cornerWeights(part->centroid, box, settings_.exponent);
            *r = T{};
            for (int k = 0; k < 8; ++k)
                *r += w[k] * around.corner[k];
            moment[cell] += density[part->fineCell] * part->volume * *r;
        }
    }
}

template <class T>
T Prolongation<T>::slopeFactor(const Surroundings& around, const T& value, const T& mean, double lowest,
                               double highest) const
{
    T factor{};
    for (int i = 0; i < components<T>; ++i) {
        const double v = component(value, i), m = component(mean, i);
        double low = lowest, high = highest;
        if (settings_.limitToCells) {
            low = std::max(low, std::min(v, component(around.lowestCorner, i)));
            high = std::min(high, std::max(v, component(around.highestCorner, i)));
        }
        const double up = std::max(0.0, component(around.highestCorner, i) - m);
        const double down = std::max(0.0, m - component(around.lowestCorner, i));
        component(factor, i) = std::min(allowed(std::max(0.0, high - v), up), allowed(std::max(0.0, v - low), down));
    }
    return factor;
}

template <class T>
void Prolongation<T>::spread(const FineParts& parts, const CoarseField<T>& value, const CoarseField<double>& weight,
                             const double* density, const CoarseField<T>& moment, double lowest, double highest,
                             std::vector<T>& amount) const
{
    amount.assign(parts.count(), T{});
    const T* raw = raw_.data();
    T* to = amount.data();
    for (int row = 0; row < parts.rows(); ++row) {
        const std::size_t n = parts.end(row) - parts.begin(row);
        raw += n, to += n;
        const int cell = parts.coarseCell(row);
        if (isZero(value[cell]))
            continue;
        const T mean = moment[cell] * (1 / weight[cell]);
        const T slope = slopeFactor(around_[row], value[cell], mean, lowest, highest);
        const T* r = raw - n;
        T* amountOf = to - n;
        for (const FinePart* part = parts.begin(row); part != parts.end(row); ++part, ++r, ++amountOf) {
            const T atPart = value[cell] + product(slope, T(*r - mean));
            *amountOf = density[part->fineCell] * part->volume * atPart;
        }
    }
}

template class Prolongation<double>;
template class Prolongation<Vec3>;

} // namespace frazil
