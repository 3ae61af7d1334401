#include "ledgerFile.H"
#include "Pstream.H"

#include <fstream>

#include "InputError.h"

Foam::ledgerFile::ledgerFile(const bool continued)
{
    if (!Pstream::master())
    {
        return;
    }

    const std::string header = frazil::Ledger::csvHeader() + transportLedger::header();
    std::string before = header;
    if (continued)
    {
        std::ifstream file("ledger.csv");
        std::getline(file, before);
    }
    if (before != header)
    {
        throw frazil::InputError
        (
            "ledger.csv", "", "",
            "it has other columns than this frazilFoam writes, so that a continued run cannot append to it",
            "Continue with the program that began the run, or move ledger.csv away"
        );
    }
    file_.reset
    (
        new OFstream
        (
            fileName("ledger.csv"),
            IOstream::ASCII,
            IOstream::currentVersion,
            IOstream::UNCOMPRESSED,
            continued
        )
    );

    if (!continued)
    {
        file_() << header.c_str() << endl;
    }
}


void Foam::ledgerFile::write
(
    const scalar time,
    const frazil::Ledger& ledger,
    const frazil::StepReport& report,
    const frazil::ParticleView& particles
)
{
    const std::string transport = transport_.line(report, particles);
    if (file_.valid())
    {
        file_() << ledger.csvLine(time).c_str() << transport.c_str() << endl;
    }
}


// ************************************************************************* //
