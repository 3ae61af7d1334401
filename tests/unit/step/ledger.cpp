/// ledger.csv: as many values as names, each under its own name; errors against numbers worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "Columns.h"
#include "Ledger.h"

using namespace frazil;

namespace
{

std::vector<std::string> words(const std::string& line)
{
    std::vector<std::string> list;
    std::stringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');)
        list.push_back(word);
    return list;
}

/// The value of a column, as ledger.csv shows it.
std::string valueOf(const Ledger& ledger, const std::string& name)
{
    const auto names = words(Ledger::csvHeader()), values = words(ledger.csvLine(0.25));
    EXPECT_EQ(names.size(), values.size());
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? "no column" : values[found - names.begin()];
}

} // namespace

TEST(Ledger, ValuesStandUnderTheirNames)
{
    Ledger ledger;
    ledger.particles = 7;
    ledger.fineVolume = 0.125;
    ledger.given = {1, 2.5, 3};
    ledger.response = {0, 0, -0.5};
    EXPECT_EQ(valueOf(ledger, "time"), "0.25");
    EXPECT_EQ(valueOf(ledger, "particles"), "7");
    EXPECT_EQ(valueOf(ledger, "volumeFine"), "0.125");
    EXPECT_EQ(valueOf(ledger, "impulseFineY"), "2.5");
    EXPECT_EQ(valueOf(ledger, "responseZ"), "-0.5");
}

TEST(Ledger, EveryColumnIsDocumented)
{
    std::ifstream file(COUPLING_PROPERTIES_MD);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::string name : words(Ledger::csvHeader())) {
        const bool component = name.size() > 1 && std::string("XYZ").find(name.back()) != std::string::npos;
        const std::string whole = component ? name.substr(0, name.size() - 1) : name;
        EXPECT_TRUE(text.find("`" + name) != std::string::npos || text.find("`" + whole) != std::string::npos) << name;
    }
}

TEST(Ledger, ErrorsAreRelative)
{
    Ledger ledger;
    ledger.particleVolume = 2, ledger.absentVolume = 0.5, ledger.coarseVolume = 1.25; // 0.25 of 2 is missing
    ledger.fineVolume = 1, ledger.clippedVolume = 0.75;                               // 0.5 of 2 too much
    ledger.received = {3, 0, 0}, ledger.carriedIn = {1, 0, 0}, ledger.coarseImpulse = {4, 0, 0.4};
    ledger.impulseScale = 4;
    EXPECT_EQ(valueOf(ledger, "volumeErrorCoarse"), "0.125");
    EXPECT_EQ(valueOf(ledger, "volumeErrorFine"), "0.25");
    EXPECT_EQ(valueOf(ledger, "impulseErrorCoarse"), "0.1");
}

TEST(Columns, KeepEveryDigit)
{
    struct Row {
        double x = 0.1;
        Vec3 v{1, 2, 3};
    };
    const auto columns = Columns<Row>()
                             .add("x", "{:.17g}", &Row::x)
                             .addVector("v", "{}", &Row::v)
                             .add("twice", "{}", [](const Row& row) { return 2 * row.v.y; });
    EXPECT_EQ(columns.header(), "x,vX,vY,vZ,twice");
    EXPECT_EQ(columns.line(Row{}), "0.10000000000000001,1,2,3,4");
}
