#include "Hdf5.h"

#include <stdexcept>

namespace frazil
{

namespace
{

herr_t appendDescription(unsigned, const H5E_error2_t* error, void* text)
{
    if (error->desc)
        *static_cast<std::string*>(text) += std::string(": ") + error->desc;
    return 0;
}

[[noreturn]] void fail(const std::string& what)
{
    std::string reasons;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, appendDescription, &reasons);
    throw std::runtime_error("HDF5 cannot " + what + reasons);
}

} // namespace

Hdf5Handle::Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close)
{
    if (id_ < 0)
        fail(what);
}

Hdf5Handle::~Hdf5Handle()
{
    close_(id_);
}

void requireHdf5(herr_t status, const std::string& what)
{
    if (status < 0)
        fail(what);
}

void writeDataset(hid_t group, const std::string& name, hid_t type, const Hyperslab& slab, const void* values)
{
    const int rank = int(slab.whole.size());
    const std::string what = "write " + name;
    const Hdf5Handle inFile(H5Screate_simple(rank, slab.whole.data(), nullptr), H5Sclose, what);
    const Hdf5Handle inMemory(H5Screate_simple(rank, slab.count.data(), nullptr), H5Sclose, what);
    const Hdf5Handle dataset(H5Dcreate2(group, name.c_str(), type, inFile, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Dclose, what);
    requireHdf5(H5Sselect_hyperslab(inFile, H5S_SELECT_SET, slab.start.data(), nullptr, slab.count.data(), nullptr),
                what);
    const Hdf5Handle together(H5Pcreate(H5P_DATASET_XFER), H5Pclose, what);
    requireHdf5(H5Pset_dxpl_mpio(together, H5FD_MPIO_COLLECTIVE), what);
    requireHdf5(H5Dwrite(dataset, type, inMemory, inFile, together, values), what);
}

void writeAttribute(hid_t object, const std::string& name, double value)
{
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "write " + name);
    const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose, "write " + name);
    requireHdf5(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), "write " + name);
}

void writeAttribute(hid_t object, const std::string& name, const std::string& text)
{
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "write " + name);
    requireHdf5(H5Tset_size(type, text.size() + 1), "write " + name);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "write " + name);
    const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                               "write " + name);
    requireHdf5(H5Awrite(attribute, type, text.c_str()), "write " + name);
}

std::string readTextAttribute(hid_t object, const std::string& name)
{
    const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "read " + name);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, "read " + name);
    std::string text(H5Tget_size(type), '\0');
    requireHdf5(H5Aread(attribute, type, text.data()), "read " + name);
    return text.substr(0, text.find('\0'));
}

std::vector<std::string> linksIn(hid_t group)
{
    H5G_info_t info;
    requireHdf5(H5Gget_info(group, &info), "list a group");
    std::vector<std::string> names;
    for (hsize_t n = 0; n < info.nlinks; ++n) {
        const auto length = H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, n, nullptr, 0, H5P_DEFAULT);
        if (length < 0)
            fail("list a group");
        std::string name(std::size_t(length) + 1, '\0');
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, n, name.data(), name.size(), H5P_DEFAULT);
        name.pop_back();
        names.push_back(name);
    }
    return names;
}

} // namespace frazil
