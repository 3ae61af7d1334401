/// SnapshotFile on any number of ranks: what is written can be read back, also after a restart and with lost particles.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "Hdf5.h"
#include "LocalCells.h"
#include "SnapshotFile.h"
#include "Sum.h"

using namespace frazil;

namespace
{

using Ends = std::array<std::int64_t, 2>;
const std::string path = "snapshot_test.h5";
const int chain = 10; ///< particles 1..10 at x = id, bonded to their neighbours

/// Particle id lives on rank id * 7 % ranks; so do the bonds of its upper side. Particle `lost` is missing.
void writeChain(SnapshotFile& file, std::int64_t step, double time, int lost = 0)
{
    const int rank = rankIn(MPI_COMM_WORLD), ranks = ranksIn(MPI_COMM_WORLD);
    std::vector<std::int64_t> ids;
    std::vector<Vec3> position, velocity;
    std::vector<Ends> bonds;
    std::vector<double> tension;
    for (int id = 1; id <= chain; ++id) {
        if (id * 7 % ranks != rank)
            continue;
        if (id != lost) {
            ids.push_back(id);
            position.push_back({double(id), 0, time});
            velocity.push_back({0, 10.0 * id, 0});
        }
        if (id == chain)
            continue;
        bonds.push_back({id, id + 1});
        tension.push_back(100.0 * id);
    }
    const CoarseGrid grid(Box{{0, 0, 0}, {5, 4, 3}}, 1, ranks, {0, 0, -9.81});
    const LocalCells cells(grid, rank);
    std::vector<double> number;
    for (int c = 0; c < cells.ownedCount(); ++c)
        number.push_back(double(cells.global(c)) + time);

    file.begin(step, time);
    file.particles("particles", ids, position.data(), {{"velocity", 3, &velocity.data()->x}});
    file.bonds("bonds", bonds, {{"tension", 1, tension.data()}});
    file.coarse("coarse", grid, {{"number", 1, number.data()}});
    file.end();
}

template <class T> std::vector<T> read(const std::string& name, hid_t type)
{
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open");
    const Hdf5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name);
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "size of " + name);
    std::vector<T> values(H5Sget_simple_extent_npoints(space));
    requireHdf5(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read " + name);
    return values;
}

void checkChain(const std::string& step, double time, std::size_t particles, std::size_t bonds)
{
    const auto ids = read<std::int64_t>("/particles/" + step + "/id", H5T_NATIVE_INT64);
    const auto position = read<double>("/particles/" + step + "/position", H5T_NATIVE_DOUBLE);
    const auto velocity = read<double>("/particles/" + step + "/velocity", H5T_NATIVE_DOUBLE);
    ASSERT_EQ(ids.size(), particles);
    for (std::size_t n = 0; n < ids.size(); ++n) {
        EXPECT_EQ(position[3 * n], ids[n]);
        EXPECT_EQ(position[3 * n + 2], time);
        EXPECT_EQ(velocity[3 * n + 1], 10 * ids[n]);
    }
    const auto ends = read<std::int64_t>("/bonds/" + step + "/ends", H5T_NATIVE_INT64);
    const auto tension = read<double>("/bonds/" + step + "/tension", H5T_NATIVE_DOUBLE);
    ASSERT_EQ(tension.size(), bonds);
    for (std::size_t b = 0; b < tension.size(); ++b) {
        EXPECT_EQ(ids[ends[2 * b]] * 100, tension[b]);
        EXPECT_EQ(ids[ends[2 * b + 1]], ids[ends[2 * b]] + 1);
    }
    const auto number = read<double>("/coarse/" + step + "/number", H5T_NATIVE_DOUBLE);
    ASSERT_EQ(number.size(), 60u);
    for (std::size_t c = 0; c < number.size(); ++c)
        EXPECT_EQ(number[c], double(c) + time);
}

int countIn(const std::string& text, const std::string& word)
{
    int count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

std::string xdmf()
{
    std::ifstream in("snapshot_test.xdmf");
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace

TEST(SnapshotFile, WritesAppendsAndReplaces)
{
    {
        SnapshotFile file(path, MPI_COMM_WORLD);
        writeChain(file, 0, 0);
        writeChain(file, 100, 0.5, 4);
        writeChain(file, 200, 1);
    }
    {
        SnapshotFile file(path, MPI_COMM_WORLD, SnapshotFile::Mode::append); // a restart from step 50
        writeChain(file, 150, 0.75);
    }
    if (rankIn(MPI_COMM_WORLD) == 0) {
        checkChain("000000000000", 0, chain, chain - 1);
        checkChain("000000000100", 0.5, chain - 1, chain - 3); // without particle 4 and its two bonds
        checkChain("000000000150", 0.75, chain, chain - 1);
        EXPECT_THROW(checkChain("000000000200", 1, chain, chain - 1), std::runtime_error) << "is of the run before";
        const std::string text = xdmf();
        EXPECT_EQ(countIn(text, "<Time Value=\"0.5\"/>"), 3);
        EXPECT_EQ(countIn(text, "<Time Value=\"1\"/>"), 0);
        EXPECT_EQ(countIn(text, "<Grid "), countIn(text, "</Grid>"));
        EXPECT_EQ(countIn(text, "CollectionType=\"Temporal\""), 3);
        EXPECT_EQ(countIn(text, "snapshot_test.h5:/particles/000000000150/velocity"), 1);
    }
    MPI_Barrier(MPI_COMM_WORLD);
}

TEST(SnapshotFile, SymmetricTensorsAreWrittenInFull)
{
    const int rank = rankIn(MPI_COMM_WORLD), ranks = ranksIn(MPI_COMM_WORLD);
    const CoarseGrid grid(Box{{0, 0, 0}, {5, 4, 3}}, 1, ranks, {0, 0, -9.81});
    const std::vector<double> given = {11, 22, 33, 12, 13, 23}, full = {11, 12, 13, 12, 22, 23, 13, 23, 33};
    std::vector<double> cells;
    for (int c = 0; c < LocalCells(grid, rank).ownedCount(); ++c)
        cells.insert(cells.end(), given.begin(), given.end());
    const Vec3 position{double(rank), 0, 0};
    SnapshotFile file(path, MPI_COMM_WORLD);
    file.begin(0, 0);
    file.particles("particles", {rank + 1}, &position, {{"stress", 6, given.data()}});
    file.bonds("bonds", {{rank + 1, 1}}, {{"stress", 6, given.data()}});
    file.coarse("coarse", grid, {{"stress", 6, cells.data()}});
    file.end();
    if (rank == 0) {
        for (const char* series : {"/particles", "/bonds", "/coarse"}) {
            const auto stress = read<double>(series + std::string("/000000000000/stress"), H5T_NATIVE_DOUBLE);
            EXPECT_EQ(stress.size() % 9, 0u) << series;
            for (std::size_t n = 0; n < stress.size(); ++n)
                EXPECT_EQ(stress[n], full[n % 9]) << series;
        }
        EXPECT_EQ(countIn(xdmf(), "AttributeType=\"Tensor\""), 3);
        EXPECT_EQ(countIn(xdmf(), "AttributeType=\"Tensor6\""), 0);
    }
    MPI_Barrier(MPI_COMM_WORLD);
}

TEST(SnapshotFile, SaysWhatItCannotWrite)
{
    try {
        SnapshotFile file("no/such/folder/results.h5", MPI_COMM_WORLD);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).find("HDF5 cannot create no/such/folder/results.h5"), 0u) << error.what();
    }
}

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    ::testing::InitGoogleTest(&argc, argv);
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return failed;
}
