/// Results over time in one HDF5 file, with an XDMF file beside it that ParaView opens at any moment.
///
///   /<series>/<step>/   position, id, arrays ...      particles        (points)
///                       ends, arrays ...              bonds            (lines between particles)
///                       arrays ... [nz][ny][nx]       coarse grid      (cells)
///
/// Use, on every rank of the communicator and with the same names:
///   file.begin(step, time); file.particles(...); file.bonds(...); file.coarse(...); file.end();
/// The HDF5 file is open between begin() and end() only, and the XDMF file is replaced in one move after it, so a run
/// that is killed leaves all earlier snapshots readable.
/// Restart: Mode::append keeps the snapshots before the first new one and removes those from there on.
/// Cost: collective parallel writes, one dataset per array. Parallel: MPI-IO through HDF5; bonds find their ends by one
/// round of questions to rank id % ranks.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <mpi.h>

#include "CoarseGrid.h"
#include "Vec3.h"

namespace frazil
{

/// `components` doubles per particle, bond or cell: 1 scalar, 3 vector, 6 symmetric tensor (xx yy zz xy xz yz),
/// which is written as the full one (xx xy xz yx yy yz zx zy zz), 9 full tensor.
struct SnapshotArray {
    std::string name;
    int components;
    const double* values;
};

class SnapshotFile
{
  public:
    enum class Mode { create, append };

    /// @param path  of the HDF5 file, e.g. results.h5; the XDMF file is results.xdmf
    SnapshotFile(std::string path, MPI_Comm comm, Mode mode = Mode::create);

    void begin(std::int64_t step, double time); ///< time [s]
    /// This rank's particles; position [m].
    void particles(const std::string& series, const std::vector<std::int64_t>& ids, const Vec3* position,
                   const std::vector<SnapshotArray>& arrays);
    /// This rank's bonds between particles of the particles() before, each on one rank. A bond whose end is not among
    /// them (a lost particle) is left out.
    void bonds(const std::string& series, const std::vector<std::array<std::int64_t, 2>>& ids,
               const std::vector<SnapshotArray>& arrays);
    /// The cells that rank r of the communicator owns as owner r of the grid, in the order of LocalCells.
    void coarse(const std::string& series, const CoarseGrid& grid, const std::vector<SnapshotArray>& arrays);
    void end();

    const std::string& path() const { return path_; }

  private:
    void readEarlier();
    void removeFrom(std::int64_t step);
    std::string groupOf(const std::string& series) const;
    void openGroup(const std::string& series);
    void closeGroup(const std::string& series, const std::string& xdmf);
    std::string reference(const std::string& series, const std::string& array) const;
    std::string writeRows(const std::string& series, const std::vector<SnapshotArray>& arrays, std::int64_t count,
                          const char* centre);
    std::vector<std::array<std::int64_t, 2>> placesOf(const std::vector<std::array<std::int64_t, 2>>& ids);
    void writeXdmf() const;

    std::string path_, xdmfPath_, h5Name_;
    MPI_Comm comm_;
    bool firstOfAppend_;
    std::int64_t file_ = -1, group_ = -1; ///< HDF5's handles while open
    std::int64_t step_ = 0;
    double time_ = 0;
    std::string points_;                                              ///< XDMF geometry of the last particles()
    std::vector<std::int64_t> ids_;                                   ///< of the last particles()
    std::map<std::string, std::map<std::int64_t, std::string>> xdmf_; ///< series, step: the XDMF grid
};

} // namespace frazil
