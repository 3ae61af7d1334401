/// The catalogue of drag laws: every name runs its own law, another word is an error that lists them all, and each law
/// stands in the documentation with its source.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "Catalogue.h"
#include "DragLaws.h"
#include "InputError.h"

using namespace frazil;

namespace
{

DragLaw lawNamed(const std::string& name)
{
    Settings settings("couplingProperties", "forces");
    settings.set("drag", name);
    return Catalogue<DragLaw>::choose(settings, "drag");
}

std::string documentation()
{
    std::ifstream file(COUPLING_PROPERTIES_MD);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST(DragCatalogue, EveryNameRunsItsOwnLaw)
{
    std::set<std::size_t> chosen;
    for (const std::string& name : Catalogue<DragLaw>::names()) {
        const DragLaw law = lawNamed(name);
        EXPECT_EQ(std::visit([](const auto& one) { return std::string(one.name); }, law), name);
        chosen.insert(law.index());
    }
    EXPECT_EQ(chosen.size(), std::variant_size_v<DragLaw>);
}

TEST(DragCatalogue, TheFirstIsTheDefault)
{
    const Settings nothing("couplingProperties", "forces");
    EXPECT_EQ(Catalogue<DragLaw>::choose(nothing, "drag").index(), 0u);
}

TEST(DragCatalogue, AnotherWordListsAllNames)
{
    try {
        lawNamed("DiFelise");
        FAIL();
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("did you mean \"DiFelice\"?"), std::string::npos) << text;
        for (const std::string& name : Catalogue<DragLaw>::names())
            EXPECT_NE(text.find(name), std::string::npos) << name;
    }
}

TEST(DragCatalogue, EveryLawIsDocumentedWithItsSource)
{
    const std::string text = documentation();
    for (const std::string& name : Catalogue<DragLaw>::names()) {
        const std::string source = std::visit([](const auto& law) { return law.source; }, lawNamed(name));
        const std::size_t row = text.find("\n| `" + name + "` |");
        ASSERT_NE(row, std::string::npos) << name << " has no row in couplingProperties.md";
        EXPECT_NE(text.substr(row + 1, text.find('\n', row + 1) - row).find(source), std::string::npos)
            << name << ": its row lacks " << source;
    }
}
