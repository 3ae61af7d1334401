/// The watch over swings between particles and fluid.
#include <gtest/gtest.h>

#include <cmath>

#include "SwingWatch.h"

using namespace frazil;

namespace
{

int warnings(double growth, double period, double scale = 1)
{
    SwingWatch watch;
    int count = 0;
    double amplitude = 1;
    for (int n = 0; n < 60; ++n, amplitude *= growth)
        count += watch.grows({0, amplitude * std::cos(2 * 3.14159265358979 * n / period), 0}, scale);
    return count;
}

} // namespace

TEST(SwingWatch, WarnsOfASwingThatGrows)
{
    EXPECT_GT(warnings(1.2, 3.7), 0);
    EXPECT_GT(warnings(1.2, 2), 0);
}

TEST(SwingWatch, SaysNothingOfSteadySwingsWavesAndImpacts)
{
    EXPECT_EQ(warnings(1, 3.7), 0);
    EXPECT_EQ(warnings(0.8, 3.7), 0);
    EXPECT_EQ(warnings(1.2, 40), 0) << "a wave that grows";
    EXPECT_EQ(warnings(1.2, 3.7, 1e9), 0) << "too small to matter";
    SwingWatch watch;
    int count = 0;
    for (int n = 0; n < 60; ++n)
        count += watch.grows({0, n < 30 ? 0 : 1000 * std::exp(-0.3 * (n - 30)), 0}, 1);
    EXPECT_EQ(count, 0) << "an impact";
}
