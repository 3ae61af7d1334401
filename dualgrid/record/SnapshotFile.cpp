#include "SnapshotFile.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <unordered_map>

#include <fmt/format.h>
#include <unistd.h>

#include "Hdf5.h"
#include "Router.h"
#include "Sum.h"

namespace frazil
{

namespace
{

using Ends = std::array<std::int64_t, 2>;

const char* attributeType(int components)
{
    switch (components) {
    case 1:
        return "Scalar";
    case 3:
        return "Vector";
    case 9:
        return "Tensor";
    default:
        return "Matrix";
    }
}

/// Symmetric tensors made full; `storage` holds their values.
/// Not written as Tensor6: of its six components VTK's two XDMF readers, both in ParaView, make different tensors.
std::vector<SnapshotArray> withFullTensors(std::vector<SnapshotArray> arrays, std::int64_t count,
                                           std::vector<std::vector<double>>& storage)
{
    static const int place[9] = {0, 3, 4, 3, 1, 5, 4, 5, 2}; // of xx xy xz yx yy yz zx zy zz in xx yy zz xy xz yz
    for (SnapshotArray& array : arrays) {
        if (array.components != 6)
            continue;
        storage.emplace_back();
        for (std::int64_t n = 0; n < count; ++n)
            for (const int component : place)
                storage.back().push_back(array.values[6 * n + component]);
        array.components = 9;
        array.values = storage.back().data();
    }
    return arrays;
}

std::string dataItem(const std::string& dimensions, const char* type, const std::string& reference)
{
    return fmt::format("<DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"8\" Format=\"HDF\">{}</DataItem>",
                       dimensions, type, reference);
}

std::string attribute(const SnapshotArray& array, const char* centre, const std::string& dimensions,
                      const std::string& reference)
{
    const std::string all = array.components == 1 ? dimensions : fmt::format("{} {}", dimensions, array.components);
    return fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n", array.name,
                       attributeType(array.components), centre, dataItem(all, "Float", reference));
}

std::string uniformGrid(const std::string& name, double time, const std::string& content)
{
    return fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\"><Time Value=\"{:.12g}\"/>\n{}</Grid>\n", name, time,
                       content);
}

/// Rows of `components` values; this rank's come at share.first.
Hyperslab rows(const Share& share, std::int64_t count, int components)
{
    Hyperslab slab{{hsize_t(share.total)}, {hsize_t(share.first)}, {hsize_t(count)}};
    if (components > 1) {
        slab.whole.push_back(components);
        slab.start.push_back(0);
        slab.count.push_back(components);
    }
    return slab;
}

/// Opened by all ranks together; errors come as exceptions instead of HDF5's own print.
hid_t openTogether(const std::string& path, MPI_Comm comm, bool create, unsigned access)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Hdf5Handle parallel(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "open " + path);
    requireHdf5(H5Pset_fapl_mpio(parallel, comm, MPI_INFO_NULL), "open " + path);
    const hid_t file = create ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, parallel)
                              : H5Fopen(path.c_str(), access, parallel);
    requireHdf5(file < 0 ? -1 : 0, (create ? "create " : "open ") + path);
    return file;
}

std::string stepName(std::int64_t step)
{
    return fmt::format("{:012d}", step);
}

} // namespace

SnapshotFile::SnapshotFile(std::string path, MPI_Comm comm, Mode mode)
    : path_(std::move(path)), comm_(comm), firstOfAppend_(mode == Mode::append) // until the file turns out to be new
{
    const auto slash = path_.find_last_of('/');
    const auto dot = path_.find_last_of('.');
    h5Name_ = path_.substr(slash == std::string::npos ? 0 : slash + 1);
    xdmfPath_ =
        path_.substr(0, dot == std::string::npos || (slash != std::string::npos && dot < slash) ? path_.size() : dot);
    xdmfPath_ += ".xdmf";
    double exists = rankIn(comm_) == 0 && access(path_.c_str(), F_OK) == 0;
    sumOverRanks(&exists, 1, comm_); // what the first rank sees counts
    if (firstOfAppend_ && exists > 0) {
        readEarlier();
    } else {
        firstOfAppend_ = false;
        H5Fclose(openTogether(path_, comm_, true, 0));
        writeXdmf();
    }
}

void SnapshotFile::readEarlier()
{
    const Hdf5Handle file(openTogether(path_, comm_, false, H5F_ACC_RDONLY), H5Fclose, "open " + path_);
    for (const std::string& series : linksIn(file)) {
        const Hdf5Handle group(H5Gopen2(file, series.c_str(), H5P_DEFAULT), H5Gclose, "read " + series);
        for (const std::string& step : linksIn(group)) {
            const Hdf5Handle snapshot(H5Gopen2(group, step.c_str(), H5P_DEFAULT), H5Gclose, "read " + step);
            xdmf_[series][std::stoll(step)] = readTextAttribute(snapshot, "xdmf");
        }
    }
}

void SnapshotFile::removeFrom(std::int64_t step)
{
    for (auto& [series, steps] : xdmf_) {
        for (auto late = steps.lower_bound(step); late != steps.end(); late = steps.erase(late)) {
            const std::string name = "/" + series + "/" + stepName(late->first);
            requireHdf5(H5Ldelete(file_, name.c_str(), H5P_DEFAULT), "remove " + name);
        }
    }
}

void SnapshotFile::begin(std::int64_t step, double time)
{
    file_ = openTogether(path_, comm_, false, H5F_ACC_RDWR);
    step_ = step;
    time_ = time;
    points_.clear();
    if (firstOfAppend_)
        removeFrom(step);
    firstOfAppend_ = false;
}

void SnapshotFile::end()
{
    requireHdf5(H5Fclose(file_), "close " + path_);
    file_ = -1;
    writeXdmf();
}

std::string SnapshotFile::groupOf(const std::string& series) const
{
    return "/" + series + "/" + stepName(step_);
}

std::string SnapshotFile::reference(const std::string& series, const std::string& array) const
{
    return h5Name_ + ":" + groupOf(series) + "/" + array;
}

void SnapshotFile::openGroup(const std::string& series)
{
    const Hdf5Handle withParents(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "write " + series);
    requireHdf5(H5Pset_create_intermediate_group(withParents, 1), "write " + series);
    group_ = H5Gcreate2(file_, groupOf(series).c_str(), withParents, H5P_DEFAULT, H5P_DEFAULT);
    requireHdf5(group_ < 0 ? -1 : 0, "write " + groupOf(series) + " to " + path_);
    writeAttribute(group_, "time", time_);
}

void SnapshotFile::closeGroup(const std::string& series, const std::string& xdmf)
{
    writeAttribute(group_, "xdmf", xdmf);
    H5Gclose(group_);
    group_ = -1;
    xdmf_[series][step_] = xdmf;
}

std::string SnapshotFile::writeRows(const std::string& series, const std::vector<SnapshotArray>& arrays,
                                    std::int64_t count, const char* centre)
{
    const Share share = shareOf(count, comm_);
    std::string xdmf;
    std::vector<std::vector<double>> tensors;
    for (const SnapshotArray& array : withFullTensors(arrays, count, tensors)) {
        writeDataset(group_, array.name, H5T_NATIVE_DOUBLE, rows(share, count, array.components), array.values);
        xdmf += attribute(array, centre, std::to_string(share.total), reference(series, array.name));
    }
    return xdmf;
}

void SnapshotFile::particles(const std::string& series, const std::vector<std::int64_t>& ids, const Vec3* position,
                             const std::vector<SnapshotArray>& arrays)
{
    const std::int64_t count = std::int64_t(ids.size());
    const Share share = shareOf(count, comm_);
    const std::string total = std::to_string(share.total);
    openGroup(series);
    writeDataset(group_, "id", H5T_NATIVE_INT64, rows(share, count, 1), ids.data());
    writeDataset(group_, "position", H5T_NATIVE_DOUBLE, rows(share, count, 3), position);
    points_ = "<Geometry GeometryType=\"XYZ\">" + dataItem(total + " 3", "Float", reference(series, "position")) +
              "</Geometry>\n";
    ids_ = ids;
    std::string content = fmt::format("<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n", total);
    content += points_ + "<Attribute Name=\"id\" AttributeType=\"Scalar\" Center=\"Node\">" +
               dataItem(total, "Int", reference(series, "id")) + "</Attribute>\n";
    content += writeRows(series, arrays, count, "Node");
    closeGroup(series, uniformGrid(series, time_, content));
}

void SnapshotFile::bonds(const std::string& series, const std::vector<Ends>& ids,
                         const std::vector<SnapshotArray>& arrays)
{
    const std::vector<Ends> places = placesOf(ids);
    std::vector<Ends> ends;
    std::vector<std::vector<double>> values(arrays.size());
    for (std::size_t b = 0; b < places.size(); ++b) {
        if (places[b][0] < 0 || places[b][1] < 0)
            continue;
        ends.push_back(places[b]);
        for (std::size_t a = 0; a < arrays.size(); ++a) {
            const double* first = arrays[a].values + b * arrays[a].components;
            values[a].insert(values[a].end(), first, first + arrays[a].components);
        }
    }
    std::vector<SnapshotArray> kept(arrays);
    for (std::size_t a = 0; a < arrays.size(); ++a)
        kept[a].values = values[a].data();

    const std::int64_t count = std::int64_t(ends.size());
    const Share share = shareOf(count, comm_);
    openGroup(series);
    writeDataset(group_, "ends", H5T_NATIVE_INT64, rows(share, count, 2), ends.data());
    std::string content =
        fmt::format("<Topology TopologyType=\"Polyline\" NodesPerElement=\"2\" NumberOfElements=\"{}\">", share.total);
    content += dataItem(fmt::format("{} 2", share.total), "Int", reference(series, "ends")) + "</Topology>\n" + points_;
    content += writeRows(series, kept, count, "Cell");
    closeGroup(series, uniformGrid(series, time_, content));
}

/// Place of each end in the particles' dataset, -1 if it is not there. Rank id % ranks keeps the address of id.
std::vector<Ends> SnapshotFile::placesOf(const std::vector<Ends>& ids)
{
    Router router(comm_);
    const int ranks = ranksIn(comm_);
    const std::int64_t first = shareOf(std::int64_t(ids_.size()), comm_).first;
    std::vector<int> to;
    std::vector<Ends> addresses;
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        to.push_back(int(ids_[n] % ranks));
        addresses.push_back({ids_[n], first + std::int64_t(n)});
    }
    std::unordered_map<std::int64_t, std::int64_t> placeOf;
    for (const Ends& address : router.send(to, addresses))
        placeOf[address[0]] = address[1];

    to.clear();
    std::vector<std::int64_t> questions;
    for (const Ends& bond : ids) {
        for (const std::int64_t id : bond) {
            to.push_back(int(id % ranks));
            questions.push_back(id);
        }
    }
    std::vector<std::int64_t> answers = router.send(to, questions);
    for (std::int64_t& id : answers) {
        const auto found = placeOf.find(id);
        id = found == placeOf.end() ? -1 : found->second;
    }
    answers = router.answer(answers);
    std::vector<Ends> places(ids.size());
    for (std::size_t b = 0; b < places.size(); ++b)
        places[b] = {answers[2 * b], answers[2 * b + 1]};
    return places;
}

void SnapshotFile::coarse(const std::string& series, const CoarseGrid& grid, const std::vector<SnapshotArray>& arrays)
{
    const CellIndex& n = grid.cells();
    const CoarseGrid::Block block = grid.block(rankIn(comm_));
    const std::string cells = fmt::format("{} {} {}", n[2], n[1], n[0]);
    const Vec3& origin = grid.box().min;
    openGroup(series);
    std::string content = fmt::format(
        "<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n<Geometry GeometryType=\"ORIGIN_DXDYDZ\">"
        "<DataItem Dimensions=\"3\" NumberType=\"Float\" Format=\"XML\">{:.12g} {:.12g} {:.12g}</DataItem>"
        "<DataItem Dimensions=\"3\" NumberType=\"Float\" Format=\"XML\">{:.12g} {:.12g} "
        "{:.12g}</DataItem></Geometry>\n",
        n[2] + 1, n[1] + 1, n[0] + 1, origin.z, origin.y, origin.x, grid.cellSize(), grid.cellSize(), grid.cellSize());
    const std::int64_t count =
        std::int64_t(block.hi[0] - block.lo[0]) * (block.hi[1] - block.lo[1]) * (block.hi[2] - block.lo[2]);
    std::vector<std::vector<double>> tensors;
    for (const SnapshotArray& array : withFullTensors(arrays, count, tensors)) {
        Hyperslab slab;
        for (int a = 2; a >= 0; --a) {
            slab.whole.push_back(n[a]);
            slab.start.push_back(block.lo[a]);
            slab.count.push_back(block.hi[a] - block.lo[a]);
        }
        if (array.components > 1) {
            slab.whole.push_back(array.components);
            slab.start.push_back(0);
            slab.count.push_back(array.components);
        }
        writeDataset(group_, array.name, H5T_NATIVE_DOUBLE, slab, array.values);
        content += attribute(array, "Cell", cells, reference(series, array.name));
    }
    closeGroup(series, uniformGrid(series, time_, content));
}

void SnapshotFile::writeXdmf() const
{
    if (rankIn(comm_) > 0)
        return;
    const std::string draft = xdmfPath_ + ".part";
    std::ofstream out(draft);
    out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n";
    for (const auto& [series, steps] : xdmf_) {
        out << fmt::format("<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", series);
        for (const auto& entry : steps)
            out << entry.second;
        out << "</Grid>\n";
    }
    out << "</Domain>\n</Xdmf>\n";
    out.close();
    if (!out || std::rename(draft.c_str(), xdmfPath_.c_str()) != 0) {
        throw std::runtime_error("cannot write " + xdmfPath_ + ": is the disk full?");
    }
}

} // namespace frazil
