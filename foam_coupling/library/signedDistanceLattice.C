#include "signedDistanceLattice.H"

#include "surfaceDistance.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

frazil::signedDistanceLattice::signedDistanceLattice
(
    const Box& bounds,
    double spacing,
    double margin
)
:
    spacing_(spacing)
{
    const Vec3 size = bounds.size();
    for (int axis = 0; axis < 3; ++axis)
    {
        const double length = size[axis] + 2*margin;
        n_[axis] = std::max(2, int(std::ceil(length/spacing)) + 1);
        const double middle = 0.5*(bounds.min[axis] + bounds.max[axis]);
        origin_[axis] = middle - 0.5*spacing*(n_[axis] - 1);
    }
    values_.assign(std::size_t(n_[0])*n_[1]*n_[2], 0.0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void frazil::signedDistanceLattice::compute
(
    const IndexedSurface& surface,
    int part,
    int parts
)
{
    const surfaceDistance exact(surface);

    for (int k = part; k < n_[2]; k += parts)
    {
        double bound = 1e30;
        for (int j = 0; j < n_[1]; ++j)
        {
            double* row = values_.data() + std::size_t(n_[0])*(j + std::size_t(n_[1])*k);
            for (int i = 0; i < n_[0]; ++i)
            {
                const Vec3 step = spacing_*Vec3{double(i), double(j), double(k)};
                row[i] = exact(origin_ + step, bound);
                bound = std::abs(row[i]) + spacing_;
            }
            bound = std::abs(row[0]) + spacing_;
        }
    }
}


frazil::Box frazil::signedDistanceLattice::box() const
{
    const Vec3 size{n_[0] - 1.0, n_[1] - 1.0, n_[2] - 1.0};
    return {origin_, origin_ + spacing_*size};
}


frazil::Vec3 frazil::signedDistanceLattice::normal(const Vec3& p) const
{
    const double half = 0.5*spacing_;
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
        Vec3 ahead = p, behind = p;
        ahead[axis] += half;
        behind[axis] -= half;
        gradient[axis] = (distance(ahead) - distance(behind))/spacing_;
    }
    const double steep = norm(gradient);
    return steep > 1e-3 ? gradient/steep : Vec3{};
}


// ************************************************************************* //
