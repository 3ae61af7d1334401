/// The fluid's step beside a partner: whole DEM steps, the end of the run, growth, and a fluid that diverges.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "stepLength.H"

using Foam::stepLength;

namespace
{

const double dem = 1e-6; // [s]

} // namespace

TEST(StepLength, WholeDemStepsRoundedDown)
{
    stepLength length;
    EXPECT_EQ(length.substeps(10.9e-6, dem, 0, 1), 10);
    EXPECT_EQ(length.substeps(10 * dem, dem, 0, 1), 10); // 9.999999999999998 DEM steps are ten
    EXPECT_EQ(length.longSteps(), 0);
}

TEST(StepLength, AtLeastOneAndThatIsCounted)
{
    stepLength length;
    EXPECT_EQ(length.substeps(0.3 * dem, dem, 0, 1), 1);
    EXPECT_EQ(length.longSteps(), 1);
}

TEST(StepLength, DoesNotPassTheEnd)
{
    stepLength length;
    EXPECT_EQ(length.substeps(10 * dem, dem, 0, 3.2e-6), 3);
    EXPECT_EQ(length.substeps(10 * dem, dem, 0, 0.1e-6), 1); // the last one is taken whole
}

TEST(StepLength, ADivergingFluidIsAnError)
{
    stepLength length;
    EXPECT_THROW(length.substeps(0.5e-3 * dem, dem, 0.25, 1), std::runtime_error);
    EXPECT_THROW(length.substeps(std::numeric_limits<double>::quiet_NaN(), dem, 0.25, 1), std::runtime_error);
}

TEST(StepLength, GrowsByOneDemStepWhereAFifthIsLess)
{
    EXPECT_TRUE(stepLength::stuck(4 * dem, dem));
    EXPECT_FALSE(stepLength::stuck(6 * dem, dem));
    EXPECT_FALSE(stepLength::stuck(0, dem));
    EXPECT_DOUBLE_EQ(stepLength::grown(4 * dem, dem, 1, 1), 5 * dem);
    EXPECT_DOUBLE_EQ(stepLength::grown(4 * dem, dem, 4.5 * dem, 1), 4.5 * dem);
    EXPECT_DOUBLE_EQ(stepLength::grown(4 * dem, dem, 1, 4.2 * dem), 4.2 * dem);
}
