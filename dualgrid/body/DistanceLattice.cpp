#include "DistanceLattice.h"

#include <cmath>

#include "SurfaceDistance.h"

namespace
{

/// Powers of 1 - G that a filtered distance is without
constexpr int filterOrder = 3;

} // namespace

frazil::DistanceLattice::DistanceLattice(const Box& bounds, double spacing, double margin) : spacing_(spacing)
{
    const Vec3 size = bounds.size();
    for (int axis = 0; axis < 3; ++axis) {
        const double length = size[axis] + 2 * margin;
        n_[axis] = std::max(2, int(std::ceil(length / spacing)) + 1);
        const double middle = 0.5 * (bounds.min[axis] + bounds.max[axis]);
        origin_[axis] = middle - 0.5 * spacing * (n_[axis] - 1);
    }
    values_.assign(std::size_t(n_[0]) * n_[1] * n_[2], 0.0);
}

void frazil::DistanceLattice::compute(const IndexedSurface& surface, int part, int parts)
{
    const SurfaceDistance exact(surface);

    for (int k = part; k < n_[2]; k += parts) {
        double bound = 1e30;
        for (int j = 0; j < n_[1]; ++j) {
            double* row = values_.data() + std::size_t(n_[0]) * (j + std::size_t(n_[1]) * k);
            for (int i = 0; i < n_[0]; ++i) {
                const Vec3 step = spacing_ * Vec3{double(i), double(j), double(k)};
                row[i] = exact(origin_ + step, bound);
                bound = std::abs(row[i]) + spacing_;
            }
            bound = std::abs(row[0]) + spacing_;
        }
    }
}

void frazil::DistanceLattice::smoothAlong(int axis, std::vector<double>& values) const
{
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? n_[0] : std::size_t(n_[0]) * n_[1];
    const std::size_t line = stride * n_[axis];
    for (std::size_t slab = 0; slab < values.size(); slab += line) {
        for (std::size_t start = slab; start < slab + stride; ++start) {
            double behind = values[start];
            for (std::size_t at = start + stride; at + stride < start + line; at += stride) {
                const double here = values[at];
                values[at] = 0.25 * (behind + 2 * here + values[at + stride]);
                behind = here;
            }
        }
    }
}

double frazil::DistanceLattice::volumeInside(double shift) const
{
    double nodes = 0;
    for (const double d : values_) {
        nodes += std::clamp(0.5 - (d + shift) / spacing_, 0.0, 1.0);
    }
    return nodes * spacing_ * spacing_ * spacing_;
}

void frazil::DistanceLattice::roundEdges(double width, double volume)
{
    const int passes = int(std::lround(2 * width * width / (spacing_ * spacing_)));
    std::vector<double> rest(values_);
    std::fill(values_.begin(), values_.end(), 0.0);
    for (int power = 0; power < filterOrder; ++power) {
        std::vector<double> mean(rest);
        for (int pass = 0; pass < passes; ++pass) {
            for (int axis = 0; axis < 3; ++axis) {
                smoothAlong(axis, mean);
            }
        }
        for (std::size_t i = 0; i < rest.size(); ++i) {
            values_[i] += mean[i];
            rest[i] -= mean[i];
        }
    }

    matchVolume(volume);
}

void frazil::DistanceLattice::matchVolume(double volume)
{
    double shift = 0;
    for (int iteration = 0; iteration < 4; ++iteration) {
        const double half = 0.5 * spacing_;
        const double area = (volumeInside(shift - half) - volumeInside(shift + half)) / spacing_;
        shift += area > 0 ? (volumeInside(shift) - volume) / area : 0;
    }
    for (double& d : values_) {
        d += shift;
    }
}

frazil::Box frazil::DistanceLattice::box() const
{
    const Vec3 size{n_[0] - 1.0, n_[1] - 1.0, n_[2] - 1.0};
    return {origin_, origin_ + spacing_ * size};
}

frazil::Vec3 frazil::DistanceLattice::normal(const Vec3& p) const
{
    const double half = 0.5 * spacing_;
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = p, behind = p;
        ahead[axis] += half;
        behind[axis] -= half;
        gradient[axis] = (distance(ahead) - distance(behind)) / spacing_;
    }
    const double steep = norm(gradient);
    return steep > 1e-3 ? gradient / steep : Vec3{};
}
