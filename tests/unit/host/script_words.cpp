/// The words behind the style of a fix: which of them are keywords, which are values, and what is said to wrong ones.
#include <gtest/gtest.h>

#include "InputError.h"
#include "script_words.h"

using namespace frazil;

namespace
{

const std::vector<Keyword> known = {{"young"},      {"stiffness_ratio"}, {"damping", 1, 4}, {"velocity", 3, 3},
                                    {"lock", 1, 6}, {"bonds"},           {"steps"}};

Settings read(std::vector<std::string> words)
{
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(&word[0]);
    return scriptWords(int(pointers.size()), pointers.data(), known);
}

template <class Action> std::string refusal(Action&& action)
{
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string refused(const std::vector<std::string>& words)
{
    return refusal([&] { read(words); });
}

} // namespace

TEST(ScriptWords, ValuesOfEveryKind)
{
    const Settings words =
        read({"damping", "0.1", "0.2", "young", "5e8", "velocity", "1", "-2", "3", "lock", "x", "rz"});
    EXPECT_EQ(words.number("young"), 5e8);
    EXPECT_EQ(words.numbers("damping"), (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(words.vec3("velocity").y, -2);
    EXPECT_EQ(words.words("lock"), (std::vector<std::string>{"x", "rz"}));
    EXPECT_EQ(positiveInt(words, "steps", 7), 7);
}

TEST(ScriptWords, AnIdMayLookLikeAKeyword)
{
    EXPECT_EQ(read({"bonds", "bonds", "young", "1"}).text("bonds"), "bonds");
    EXPECT_EQ(read({"young", "1", "bonds", "young"}).text("bonds"), "young");
}

TEST(ScriptWords, AMisspeltKeywordIsToldWhereverItStands)
{
    const std::string rest = ". Known: young, stiffness_ratio, damping, velocity, lock, bonds, steps.";
    EXPECT_EQ(refused({"yung", "1"}), "yung: unknown keyword (did you mean \"young\"?)" + rest);
    EXPECT_EQ(refused({"damping", "0.1", "yung", "1"}), "yung: unknown keyword (did you mean \"young\"?)" + rest);
    EXPECT_EQ(refused({"lock", "x", "velocty", "1", "2", "3"}),
              "velocty: unknown keyword (did you mean \"velocity\"?)" + rest);
    EXPECT_EQ(refused({"speed", "1"}), "speed: unknown keyword" + rest);
}

TEST(ScriptWords, AMissingValueIsToldAtItsKeyword)
{
    EXPECT_EQ(refused({"young"}), "young: needs 1 value. Add what is missing behind it.");
    EXPECT_EQ(refused({"velocity", "1", "2"}), "velocity 1 2: needs 3 values. Add what is missing behind it.");
    EXPECT_EQ(refused({"young", "stiffness_ratio", "2"}), "young: needs 1 value. Add what is missing behind it.");
    EXPECT_EQ(refused({"velocity", "1", "2", "young", "5e8"}),
              "velocity 1 2: needs 3 values. Add what is missing behind it.");
    EXPECT_EQ(refused({"young", "1", "young", "2"}), "young: stands twice. Give it once.");
}

TEST(ScriptWords, NumbersAreFiniteAndWholeWhereTheyCount)
{
    for (const char* word : {"nan", "inf", "-inf", "1e999", "5e8Pa", "v_young"})
        EXPECT_THROW(read({"young", word}).number("young"), InputError) << word;
    for (const char* word : {"0", "-3", "1.5", "1e3", "3000000000", "nan"})
        EXPECT_THROW(positiveInt(read({"steps", word}), "steps"), InputError) << word;
    EXPECT_EQ(refusal([] {
                  positiveInt(read({"steps", "3000000000"}), "steps");
              }),
              "steps 3000000000: is too large. Give a whole number up to 2147483647.");
    EXPECT_EQ(positiveInt(read({"steps", "2147483647"}), "steps"), 2147483647);
}
