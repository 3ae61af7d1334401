/// The few calls of HDF5 that the snapshots need, with errors as exceptions and handles that close themselves.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <hdf5.h>
#include <mpi.h>

namespace frazil
{

/// Owns one HDF5 handle.
class Hdf5Handle
{
  public:
    /// Throws if `id` is HDF5's sign of failure; `what` completes "HDF5 cannot ...".
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
    ~Hdf5Handle();
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    operator hid_t() const { return id_; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Throws with HDF5's own words if `status` is a failure.
void requireHdf5(herr_t status, const std::string& what);

/// Part of an array that one rank writes.
struct Hyperslab {
    std::vector<hsize_t> whole, start, count;
};

/// Collective: creates the dataset `name` in `group` and writes every rank's part.
void writeDataset(hid_t group, const std::string& name, hid_t type, const Hyperslab& slab, const void* values);

void writeAttribute(hid_t object, const std::string& name, double value);
void writeAttribute(hid_t object, const std::string& name, const std::string& text);
std::string readTextAttribute(hid_t object, const std::string& name);

/// Names of the links in a group, sorted.
std::vector<std::string> linksIn(hid_t group);

} // namespace frazil
