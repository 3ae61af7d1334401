/// What both ends of the pair have in common: small messages between the first ranks, passed on to all own ranks,
/// the end of the coupling, and the clock of the waits.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "Hello.h"
#include "Wait.h"
#include "World.h"

namespace frazil
{

class Link
{
  public:
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    /// Have both sides agreed on the end? Then nothing may be sent any more.
    bool finished() const { return finished_; }
    /// Time spent waiting for the partner [s].
    double waited() const { return patience_.waited(); }

  protected:
    /// Where the user sets the limit of the waits after the handshake.
    static constexpr const char* watchdogKey = "`watchdog` in constant/couplingProperties";

    enum Tag {
        helloTag = 1,
        stepTag,
        bodyTag,
        loadTag,
        particleTag /* and the next one */,
        replyTag = particleTag + 2
    };

    /// Throws InputError with the command to use if there is no partner.
    explicit Link(Side side);
    ~Link() = default;

    /// First rank to the partner's first rank; nothing on the others. The bytes are kept until they are under way.
    void send(Tag tag, std::vector<char> bytes);
    /// From the partner's first rank, to all own ranks. `what` as for Patience::until.
    std::vector<char> receive(Tag tag, const char* what);

    template <class T> void sendList(Tag tag, const std::vector<T>& list)
    {
        static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
        const char* bytes = reinterpret_cast<const char*>(list.data());
        send(tag, std::vector<char>(bytes, bytes + list.size() * sizeof(T)));
    }
    template <class T> std::vector<T> receiveList(Tag tag, const char* what)
    {
        const std::vector<char> bytes = receive(tag, what);
        std::vector<T> list(bytes.size() / sizeof(T));
        if (!bytes.empty()) {
            std::memcpy(static_cast<void*>(list.data()), bytes.data(), list.size() * sizeof(T));
        }
        return list;
    }

    /// Throws std::runtime_error with both values of whatever does not fit.
    void compare(const DemHello& dem, const FoamHello& foam) const;
    /// Counts the exchanges, tells World where we are, and says goodbye if this was the last one.
    void noteStep(double time, bool last);
    void waitForAll(const char* what, std::vector<MPI_Request>& requests);

    World& world_;
    Patience patience_;

  private:
    std::vector<char> sent_;
    MPI_Request sending_ = MPI_REQUEST_NULL;
    long step_ = -1;
    bool finished_ = false;

    void shareWithOwn(std::vector<char>& bytes, const char* what);
};

} // namespace frazil
