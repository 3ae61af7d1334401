/// The file of bonds: what is a pair, and what is said to a line that is none.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "read_bond_list.h"

using namespace frazil;

namespace
{

/// What is wrong with a file of this text.
std::string problemOf(const std::string& text, BondList& pairs)
{
    const std::string path = testing::TempDir() + "bond_list.txt";
    std::ofstream(path) << text;
    const std::string problem = readBondList(path, pairs);
    std::remove(path.c_str());
    return problem.substr(problem.find(path) == std::string::npos ? 0 : problem.find(path) + path.size());
}

std::string problemOf(const std::string& text)
{
    BondList pairs;
    return problemOf(text, pairs);
}

} // namespace

TEST(BondList, PairsInTheOrderOfTheFileLowerIdFirst)
{
    BondList pairs;
    EXPECT_EQ(problemOf("# a comment\n7 3 # another\n\n  3\t12\r\n", pairs), "");
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0].id1, 3);
    EXPECT_EQ(pairs[0].id2, 7);
    EXPECT_EQ(pairs[0].line, 2);
    EXPECT_EQ(pairs[1].id2, 12);
    EXPECT_EQ(pairs[1].line, 4);
}

TEST(BondList, WrongLinesAreNamed)
{
    const std::string cure = " is no pair of ids; cure: two whole numbers above 0 in each line";
    EXPECT_EQ(problemOf("1 2\n1 x\n"), ", line 2: '1 x'" + cure);
    EXPECT_EQ(problemOf("1 2 3\n"), ", line 1: '1 2 3'" + cure);
    EXPECT_EQ(problemOf("0 2\n"), ", line 1: '0 2'" + cure);
    EXPECT_EQ(problemOf("2 2\n"), ", line 1: sphere 2 with itself; cure: two different ids");
    EXPECT_EQ(problemOf("1 2\n\n2 1\n"), ", line 3: the pair 1 2 is there already, in line 1; cure: each pair once");
    EXPECT_EQ(problemOf("# nothing\n"), ": no pair in it; cure: lines 'id1 id2'");
    BondList pairs;
    EXPECT_EQ(readBondList("nowhere.txt", pairs),
              "list nowhere.txt: the file cannot be read; cure: check the path, it starts at the folder of the run");
}
