#include "CellCutting.h"

#include <utility>

namespace
{

/// Where on the edge from an inside to an outside corner the distance is zero,
/// as a share of the edge from the inside corner
inline double cut(double inside, double outside)
{
    return inside / (inside - outside);
}

/// Two corners a, b inside, two corners c, d outside: the wedge between the
/// edge ab and the cut, as three tetrahedra
inline double wedge(double a, double b, double c, double d)
{
    const double ac = cut(a, c), ad = cut(a, d), bc = cut(b, c), bd = cut(b, d);
    return ac * ad + ac * bd * (1 - ad) + (1 - ac) * bc * bd;
}

} // namespace

double frazil::insideShare(double a, double b, double c)
{
    // Bring the corners inside to the front
    if (b < a)
        std::swap(a, b);
    if (c < a)
        std::swap(a, c);
    if (c < b)
        std::swap(b, c);

    if (a >= 0)
        return 0;
    if (c < 0)
        return 1;
    if (b >= 0)
        return cut(a, b) * cut(a, c);
    return 1 - (1 - cut(a, c)) * (1 - cut(b, c));
}

double frazil::insideShare(double a, double b, double c, double d)
{
    if (b < a)
        std::swap(a, b);
    if (d < c)
        std::swap(c, d);
    if (c < a)
        std::swap(a, c);
    if (d < b)
        std::swap(b, d);
    if (c < b)
        std::swap(b, c);

    if (a >= 0)
        return 0;
    if (d < 0)
        return 1;
    if (b >= 0)
        return cut(a, b) * cut(a, c) * cut(a, d);
    if (c >= 0)
        return wedge(a, b, c, d);
    return 1 - (1 - cut(a, d)) * (1 - cut(b, d)) * (1 - cut(c, d));
}

double frazil::insideShare(const CutFace& face)
{
    double inside = 0, all = 0;
    for (int i = 0; i < face.corners; ++i) {
        const int j = i + 1 < face.corners ? i + 1 : 0;
        const double area = norm(cross(face.point[i] - face.centre, face.point[j] - face.centre));
        all += area;
        inside += area * insideShare(face.distance[i], face.distance[j], face.centreDistance);
    }
    return all > 0 ? inside / all : 0;
}

void frazil::CutCell::add(const CutFace& face)
{
    const Vec3 height = face.centre - centre_;
    for (int i = 0; i < face.corners; ++i) {
        const int j = i + 1 < face.corners ? i + 1 : 0;
        const Vec3 base = cross(face.point[i] - face.centre, face.point[j] - face.centre);
        const double volume = std::abs(dot(base, height));
        all_ += volume;
        inside_ +=
            volume * frazil::insideShare(face.distance[i], face.distance[j], face.centreDistance, centreDistance_);
    }
}
