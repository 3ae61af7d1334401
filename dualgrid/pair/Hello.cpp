#include "Hello.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

namespace frazil
{

namespace
{

/// Writes or reads the members of a hello in one order, so that packing and unpacking cannot drift apart.
class Archive
{
  public:
    Archive() = default;
    explicit Archive(const std::vector<char>& bytes) : bytes_(bytes), reading_(true) {}

    void operator()(double& value) { raw(&value, sizeof value); }
    void operator()(std::int64_t& value) { raw(&value, sizeof value); }
    void operator()(Vec3& v) { raw(&v, sizeof v); }
    void operator()(Box& box) { raw(&box, sizeof box); }
    void operator()(std::string& text)
    {
        std::int64_t length = std::int64_t(text.size());
        (*this)(length);
        text.resize(length);
        raw(&text[0], length);
    }
    void operator()(std::vector<BodyHello>& bodies)
    {
        std::int64_t count = std::int64_t(bodies.size());
        (*this)(count);
        bodies.resize(count);
        for (BodyHello& body : bodies) {
            (*this)(body.name);
            (*this)(body.volume);
        }
    }
    std::vector<char> take() { return std::move(bytes_); }

  private:
    void raw(void* data, std::size_t size)
    {
        char* place = static_cast<char*>(data);
        if (!reading_) {
            bytes_.insert(bytes_.end(), place, place + size);
        } else if (at_ + size > bytes_.size()) {
            throw std::runtime_error(
                "The partner's greeting cannot be read: the two programs are of different versions");
        } else {
            std::memcpy(place, bytes_.data() + at_, size);
            at_ += size;
        }
    }

    std::vector<char> bytes_;
    std::size_t at_ = 0;
    bool reading_ = false;
};

// A partner of another version is told by its version; the rest of its hello is not read.
void visit(Archive& archive, DemHello& h)
{
    archive(h.version);
    if (h.version != messageVersion) {
        return;
    }
    archive(h.units), archive(h.gravity);
    archive(h.startTime), archive(h.endTime), archive(h.deltaT), archive(h.fluidTime);
    archive(h.reach), archive(h.largestRadius), archive(h.particles), archive(h.bodies);
}

void visit(Archive& archive, FoamHello& h)
{
    archive(h.version);
    if (h.version != messageVersion) {
        return;
    }
    archive(h.gravity), archive(h.startTime), archive(h.endTime);
    archive(h.mesh), archive(h.coarse), archive(h.cellSize);
    archive(h.ranks), archive(h.watchdog), archive(h.bodies);
}

std::string words(const Vec3& v)
{
    return fmt::format("({:g} {:g} {:g})", v.x, v.y, v.z);
}

std::string words(const Box& box)
{
    return words(box.min) + " to " + words(box.max);
}

std::string compareUnits(const DemHello& dem)
{
    if (dem.units == "si") {
        return "";
    }
    return fmt::format("units: frazilDem computes in `{}`, frazilFoam in SI. Use `units si` in the input script.\n",
                       dem.units);
}

std::string compareGravity(const DemHello& dem, const FoamHello& foam)
{
    if (norm(dem.gravity - foam.gravity) <= 1e-6 * std::max(norm(dem.gravity), norm(foam.gravity))) {
        return "";
    }
    return fmt::format("gravity: frazilDem has {} m/s2 (fix gravity), frazilFoam {} m/s2 (constant/g). "
                       "Make them equal.\n",
                       words(dem.gravity), words(foam.gravity));
}

std::string compareTimes(const DemHello& dem, const FoamHello& foam)
{
    const double demSpan = dem.endTime - dem.startTime, foamSpan = foam.endTime - foam.startTime;
    std::string lines;
    if (demSpan < foamSpan - 0.5 * dem.deltaT) {
        lines += fmt::format(
            "end time: frazilDem's run ends {:g} s after the start of the coupling ({:.0f} steps of {:g} s), "
            "frazilFoam's endTime lies {:g} s after it. Lengthen `run` to {:.0f} steps (if it is split into "
            "several, say where the last one ends: run N stop STEP) or shorten endTime.\n",
            demSpan, demSpan / dem.deltaT, dem.deltaT, foamSpan, std::ceil(foamSpan / dem.deltaT - 1e-6));
    }
    if (dem.fluidTime >= 0 && std::fabs(dem.fluidTime - foam.startTime) > 0.5 * dem.deltaT) {
        lines += fmt::format(
            "start time: frazilDem's restart file belongs to fluid time {:g} s, frazilFoam starts at {:g} s. "
            "Take the restart file and the time folder of the same time.\n",
            dem.fluidTime, foam.startTime);
    }
    return lines;
}

bool holds(const Box& outer, const Box& inner)
{
    return outer.contains(inner.min) && outer.contains(inner.max);
}

std::string compareSpace(const DemHello& dem, const FoamHello& foam)
{
    std::string lines;
    if (dem.particles > 0 && !holds(foam.coarse, dem.reach)) {
        lines += fmt::format("coarseGrid: it covers {} m, but the particles' centres reach over {} m. "
                             "Widen coarseGrid min and max in constant/couplingProperties.\n",
                             words(foam.coarse), words(dem.reach));
    }
    const Box overlap{{std::max(foam.mesh.min.x, foam.coarse.min.x), std::max(foam.mesh.min.y, foam.coarse.min.y),
                       std::max(foam.mesh.min.z, foam.coarse.min.z)},
                      {std::min(foam.mesh.max.x, foam.coarse.max.x), std::min(foam.mesh.max.y, foam.coarse.max.y),
                       std::min(foam.mesh.max.z, foam.coarse.max.z)}};
    if (overlap.min.x >= overlap.max.x || overlap.min.y >= overlap.max.y || overlap.min.z >= overlap.max.z) {
        lines += fmt::format("coarseGrid: it covers {} m and does not touch the fluid mesh, {} m. "
                             "Correct coarseGrid min and max in constant/couplingProperties.\n",
                             words(foam.coarse), words(foam.mesh));
    }
    return lines;
}

const BodyHello* find(const std::vector<BodyHello>& bodies, const std::string& name)
{
    for (const BodyHello& body : bodies) {
        if (body.name == name) {
            return &body;
        }
    }
    return nullptr;
}

std::string names(const std::vector<BodyHello>& bodies)
{
    std::string list;
    for (const BodyHello& body : bodies) {
        list += (list.empty() ? "" : ", ") + body.name;
    }
    return list.empty() ? "none" : list;
}

std::string compareBodies(const DemHello& dem, const FoamHello& foam)
{
    std::string lines;
    for (const BodyHello& body : dem.bodies) {
        const BodyHello* other = find(foam.bodies, body.name);
        if (!other) {
            lines +=
                fmt::format("bodies: frazilDem has a body `{}` (fix body/rigid), frazilFoam has: {}. Add it to bodies "
                            "in constant/couplingProperties.\n",
                            body.name, names(foam.bodies));
        } else if (!sameVolume(other->volume, body.volume)) {
            lines += fmt::format(
                "body `{}`: its surface holds {:.9g} m3 in frazilDem, {:.9g} m3 in frazilFoam. Give both the "
                "same STL file and scale.\n",
                body.name, body.volume, other->volume);
        }
    }
    for (const BodyHello& body : foam.bodies) {
        if (!find(dem.bodies, body.name)) {
            lines += fmt::format(
                "bodies: frazilFoam has a body `{}` (constant/couplingProperties), frazilDem has: {}. Add a fix "
                "body/rigid with this name to the input script, or remove the body.\n",
                body.name, names(dem.bodies));
        }
    }
    return lines;
}

} // namespace

std::vector<char> pack(const DemHello& hello)
{
    DemHello copy = hello;
    Archive archive;
    visit(archive, copy);
    return archive.take();
}

std::vector<char> pack(const FoamHello& hello)
{
    FoamHello copy = hello;
    Archive archive;
    visit(archive, copy);
    return archive.take();
}

DemHello unpackDemHello(const std::vector<char>& bytes)
{
    DemHello hello;
    Archive archive(bytes);
    visit(archive, hello);
    return hello;
}

FoamHello unpackFoamHello(const std::vector<char>& bytes)
{
    FoamHello hello;
    Archive archive(bytes);
    visit(archive, hello);
    return hello;
}

std::string mismatch(const DemHello& dem, const FoamHello& foam)
{
    if (dem.version != foam.version) {
        return fmt::format(
            "version of the messages: {} in frazilDem, {} in frazilFoam. Build both from the same sources.\n",
            dem.version, foam.version);
    }
    return compareUnits(dem) + compareGravity(dem, foam) + compareTimes(dem, foam) + compareSpace(dem, foam) +
           compareBodies(dem, foam);
}

} // namespace frazil
