/// Columns of a CSV file, each with its name and its value in one place, so that header and lines cannot drift apart.
///
///     static const Columns<Row> columns = Columns<Row>()
///         .add("particles", "{}", &Row::particles)          // a member or anything that can be called with a Row
///         .addVector("force", "{:.17g}", &Row::force);      // forceX, forceY, forceZ
///
/// Cost: a formatted number per column and line. No MPI.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "Vec3.h"

namespace frazil
{

template <class Row> class Columns
{
  public:
    /// @param format  of fmt, e.g. "{:.17g}", which keeps every digit
    template <class Value> Columns& add(const std::string& name, const char* format, Value value)
    {
        names_.push_back(name);
        texts_.push_back([=](const Row& row) { return fmt::format(fmt::runtime(format), std::invoke(value, row)); });
        return *this;
    }

    /// Three columns, name and X, Y, Z.
    template <class Value> Columns& addVector(const std::string& name, const char* format, Value value)
    {
        for (int axis = 0; axis < 3; ++axis) {
            add(name + "XYZ"[axis], format, [=](const Row& row) { return Vec3(std::invoke(value, row))[axis]; });
        }
        return *this;
    }

    const std::vector<std::string>& names() const { return names_; }

    /// Names, with commas between them.
    std::string header() const { return fmt::format("{}", fmt::join(names_, ",")); }

    /// Values, likewise.
    std::string line(const Row& row) const
    {
        std::string text;
        for (const auto& value : texts_)
            text += (text.empty() ? "" : ",") + value(row);
        return text;
    }

  private:
    std::vector<std::string> names_;
    std::vector<std::function<std::string(const Row&)>> texts_;
};

} // namespace frazil
