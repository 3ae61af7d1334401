/// What both ends of the pair have in common: small messages between the first ranks, passed on to all own ranks,
/// the end of the coupling, and the clock of the waits.
#pragma once

#include <string>
#include <vector>

#include "Wait.h"
#include "World.h"

namespace frazil {

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
    /// Throws InputError with the command to use if there is no partner.
    explicit Link(Side side);

    /// First rank to the partner's first rank; nothing on the others.
    void sendToPartner(int tag, const std::vector<char>& bytes);
    /// From the partner's first rank, to all own ranks.
    std::vector<char> receiveFromPartner(int tag, const char* what);
    void markFinished();

    World& world_;
    Patience patience_;

  private:
    std::vector<char> sent_[2];
    MPI_Request sending_[2] = {MPI_REQUEST_NULL, MPI_REQUEST_NULL};
    bool finished_ = false;

    void finishSending(int slot);
    int slot_ = 0;
    std::vector<char> shareWithOwn(std::vector<char> bytes);
};

} // namespace frazil
