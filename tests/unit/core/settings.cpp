/// Settings: what is read, and the words of every refusal.
#include <gtest/gtest.h>

#include "InputError.h"
#include "Settings.h"

using frazil::InputError;
using frazil::Settings;

namespace
{

const char* const file = "constant/couplingProperties";

template <class Action> std::string refusal(Action&& action)
{
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

Settings coupling()
{
    Settings settings(file, "");
    settings.addSub("coarseGrid").set("min", "(0 -1e-1 .5)");
    settings.addSub("coarseGrid").set("cellSize", "5e-3");
    settings.set("dualGrid", "off");
    settings.set("drag", "Gidaspow");
    settings.set("steps", "12");
    return settings;
}

} // namespace

TEST(Settings, ReadsEveryKind)
{
    const Settings settings = coupling();
    const frazil::Vec3 min = settings.sub("coarseGrid").vec3("min");
    EXPECT_EQ(min.x, 0);
    EXPECT_EQ(min.y, -0.1);
    EXPECT_EQ(min.z, 0.5);
    EXPECT_EQ(settings.sub("coarseGrid").number("cellSize"), 0.005);
    EXPECT_FALSE(settings.flag("dualGrid", true));
    EXPECT_EQ(settings.word("drag", {"DiFelice", "Gidaspow"}), "Gidaspow");
    EXPECT_EQ(settings.integer("steps"), 12);
    EXPECT_EQ(settings.number("absent", 3), 3);
    EXPECT_NO_THROW(settings.finish());
}

TEST(Settings, NumbersInEveryCommonFormat)
{
    Settings settings("f", "");
    const std::pair<const char*, double> formats[] = {{"1", 1},    {"-2.5", -2.5}, {"+3", 3},
                                                      {".5", 0.5}, {"5.", 5},      {"1E+3", 1000}};
    for (const auto& [word, value] : formats) {
        settings.set("x", word);
        EXPECT_EQ(settings.number("x"), value) << word;
    }
    for (const char* word : {"", "1,5", "1e", "nan", "inf", "0x10", "1 2", "+-3", "one"}) {
        settings.set("x", word);
        EXPECT_THROW(settings.number("x"), InputError) << word;
    }
}

TEST(Settings, UnknownKeyNamesTheNearestAndTheKnown)
{
    Settings settings(file, "");
    settings.addSub("coarseGrid").set("celSize", "5e-3");
    const Settings& grid = settings.sub("coarseGrid");
    grid.vec3("min", {});
    grid.vec3("max", {});
    grid.number("cellSize", 1);
    EXPECT_EQ(refusal([&] { settings.finish(); }),
              "constant/couplingProperties: coarseGrid: unknown key \"celSize\" (did you mean \"cellSize\"?). "
              "Known keys: min, max, cellSize.");
}

TEST(Settings, UnknownSubDictionaryIsRefusedToo)
{
    Settings settings(file, "");
    settings.addSub("force").set("drag", "none");
    settings.sub("forces");
    EXPECT_EQ(refusal([&] { settings.finish(); }),
              "constant/couplingProperties: unknown key \"force\" (did you mean \"forces\"?). Known keys: forces.");
}

TEST(Settings, WordsOfTheOtherRefusals)
{
    Settings settings = coupling();
    settings.set("watchdog", "ten");
    EXPECT_EQ(refusal([&] { settings.number("watchdog"); }),
              "constant/couplingProperties: watchdog ten: is not a number. Write it like 0.005 or 5e-3, in SI units.");
    EXPECT_EQ(refusal([&] {
                  settings.word("drag", {"DiFelice", "Gidaspov"});
              }),
              "constant/couplingProperties: drag Gidaspow: is not one of the choices (did you mean \"Gidaspov\"?). "
              "Choose from: DiFelice, Gidaspov.");
    EXPECT_EQ(refusal([&] { settings.flag("drag", true); }),
              "constant/couplingProperties: drag Gidaspow: is neither on nor off. "
              "Choose from: on, off, yes, no, true, false.");
    EXPECT_EQ(refusal([&] { settings.sub("coarseGrid").vec3("cellSize"); }),
              "constant/couplingProperties: coarseGrid.cellSize 5e-3: is not a vector. Write three numbers: (x y z).");
    EXPECT_EQ(refusal([&] { settings.sub("coarseGrid").vec3("max"); }),
              "constant/couplingProperties: coarseGrid: key \"max\" is missing. Add a line: max <value>;.");
    EXPECT_EQ(refusal([&] { settings.number("coarseGrid", 1); }),
              "constant/couplingProperties: coarseGrid: must be a single value, not a sub-dictionary. "
              "Write coarseGrid <value>;.");
}

TEST(Settings, WordsOfAScript)
{
    Settings words("", "", Settings::Form::script);
    words.set("inertia", "1 2 3 4 5 6");
    words.set("lock", "x rz");
    words.set("damping", "0.1 nan");
    EXPECT_EQ(words.numbers("inertia"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(words.words("lock"), (std::vector<std::string>{"x", "rz"}));
    EXPECT_EQ(words.notNegative("ramp", 0.5), 0.5);
    try {
        words.numbers("damping");
        FAIL();
    } catch (const InputError& wrong) {
        EXPECT_STREQ(wrong.what(), "damping 0.1 nan: nan is not a number. Write it like 0.005 or 5e-3, in SI units.");
    }
    try {
        words.number("young");
        FAIL();
    } catch (const InputError& wrong) {
        EXPECT_STREQ(wrong.what(), "keyword \"young\" is missing. Add young <value>.");
    }
}
