#include "heldLoads.H"
#include "Time.H"

#include <fmt/format.h>

#include "InputError.h"

Foam::heldLoads::heldLoads(const fvMesh& mesh, const std::vector<frazil::BodyHello>& bodies)
:
    bodies_(bodies),
    rows_
    (
        IOobject
        (
            "bodyLoads",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    )
{
    if (rows_.size() && std::size_t(rows_.size()) != words*bodies.size())
    {
        throw frazil::InputError
        (
            std::string(mesh.time().timeName()) + "/uniform/bodyLoads", "", "",
            fmt::format("it has the loads of {} bodies, the case has {}", rows_.size()/words, bodies.size()),
            "Continue with the bodies that the run began with, or remove the file."
        );
    }
}


void Foam::heldLoads::hold(const std::vector<frazil::BodyLoad>& loads)
{
    rows_.setSize(words*label(loads.size()));
    scalar* row = rows_.data();
    for (const frazil::BodyLoad& load : loads)
    {
        for (int c = 0; c < 3; ++c)
        {
            row[c] = load.force[c];
            row[3 + c] = load.torque[c];
        }
        row[6] = load.submergedShare;
        row += words;
    }
}


std::vector<frazil::BodyLoad> Foam::heldLoads::loads() const
{
    std::vector<frazil::BodyLoad> loads(rows_.size()/words);
    const scalar* row = rows_.cdata();
    for (std::size_t i = 0; i < loads.size(); ++i, row += words)
    {
        loads[i].force = {row[0], row[1], row[2]};
        loads[i].torque = {row[3], row[4], row[5]};
        loads[i].submergedShare = row[6];
        bodies_[i].name.copy(loads[i].name, sizeof loads[i].name - 1);
    }
    return loads;
}


// ************************************************************************* //
