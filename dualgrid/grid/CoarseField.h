/// Values of type T on the coarse cells of one fluid rank, in the order of LocalCells (owned, then ghosts).
#pragma once

#include <algorithm>
#include <vector>

#include "LocalCells.h"

namespace frazil
{

template <class T> class CoarseField
{
  public:
    CoarseField() = default;
    explicit CoarseField(const LocalCells& cells, const T& value = T()) : values_(cells.count(), value) {}

    /// Fits the field to the cells and sets every value; memory is reused.
    void reset(const LocalCells& cells, const T& value = T()) { values_.assign(cells.count(), value); }

    T& operator[](int local) { return values_[local]; }
    const T& operator[](int local) const { return values_[local]; }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    int count() const { return int(values_.size()); }

  private:
    std::vector<T> values_;
};

} // namespace frazil
