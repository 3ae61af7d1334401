#include "Stencil.h"

namespace frazil
{

bool reweigh(Stencil& stencil, const CoarseField<double>& importance)
{
    std::array<double, Stencil::capacity> scaled;
    double sum = 0;
    for (int n = 0; n < stencil.count; ++n)
        sum += scaled[n] = stencil.weight[n] * importance[stencil.cell[n]];
    if (!(sum > 0))
        return false;
    for (int n = 0; n < stencil.count; ++n)
        stencil.weight[n] = scaled[n] / sum;
    return true;
}

} // namespace frazil
