/// Each drag law against values worked out by hand from its published, dimensional form (to 1e-5), its limits, and the
/// forces that the model makes of it.
///
/// Hand calculations: ρ = 1000 kg/m3, μ = 1e-3 Pa s, D = 2 mm, hence A = 3.14159e-6 m2, V = 4.18879e-9 m3,
/// 3πμD = 1.884956e-5 kg/s and Re = αf 2e6 s/m |ur|.
#include <gtest/gtest.h>

#include <map>

#include "Catalogue.h"
#include "DidYouMean.h"
#include "DragLaws.h"
#include "ForceModel.h"
#include "InputError.h"
#include "PressureResponse.h"

using namespace frazil;

namespace
{

const Phase water{1000, 1e-3}, air{1.2, 1.8e-5};

ForceModel model(std::initializer_list<std::pair<const char*, const char*>> entries)
{
    Settings settings("constant/couplingProperties", "forces");
    for (const auto& [key, value] : entries)
        settings.set(key, value);
    const ForceModel forces(settings);
    settings.finish();
    return forces;
}

} // namespace

TEST(DiFelice, SingleSphere)
{
    // αf = 1, ur = 0.05: Re = 100, Cd = (0.63 + 0.48)² = 1.2321; K = ½ 1000 1.2321 3.14159e-6 0.05 = 9.67689e-5 kg/s;
    // F = 9.67689e-5/1.884956e-5 = 5.13375
    EXPECT_NEAR(DiFelice{}(100, 1), 5.13375, 1e-5);
    EXPECT_NEAR(dragCoefficient(DiFelice{}, water, 2e-3, 0.05, 1), 9.67689e-5, 1e-9);
}

TEST(DiFelice, Bed)
{
    // αf = 0.5, ur = 0.1: Re = 100, χ = 3.7 - 0.65 exp(-0.125) = 3.12638;
    // K = ½ 1000 1.2321 3.14159e-6 0.1 0.5^(2 - 3.12638) = 1.935378e-4 x 2.183103 = 4.225121e-4; F = 22.41496
    EXPECT_NEAR(DiFelice::exponent(100), 3.12638, 1e-5);
    EXPECT_NEAR(DiFelice{}(100, 0.5), 22.41496, 1e-5);
}

TEST(DiFelice, StokesLimitIsFinite)
{
    EXPECT_NEAR(DiFelice{}(0, 1), 4.8 * 4.8 / 24, 1e-15);
    EXPECT_NEAR(DiFelice{}(0, 0.5), 0.96 * std::pow(0.5, -2.7), 1e-12);
    EXPECT_NEAR(DiFelice{}(1e-12, 0.5), DiFelice{}(0, 0.5), 1e-5);
}

TEST(Ergun, Bed)
{
    // αf = 0.5, ur = 0.1: β = 150 0.25 1e-3/(0.5 4e-6) + 1.75 0.5 1000 0.1/2e-3 = 18750 + 43750 = 62500 kg/m3/s;
    // K = V β/0.5 = 5.23599e-4; F = 27.7778
    EXPECT_NEAR(Ergun{}(100, 0.5), 27.77778, 1e-5);
    EXPECT_NEAR(dragCoefficient(Ergun{}, water, 2e-3, 0.1, 0.5), 5.23599e-4, 1e-9);
}

TEST(WenYu, Suspension)
{
    // αf = 0.9, Re = 100: Cd = 0.24 (1 + 0.15 x 23.659197) = 1.0917311, ur = 0.1/1.8 = 0.0555556;
    // β = 0.75 Cd 0.9 0.1 1000 0.0555556/2e-3 x 0.9^-2.65 = 2046.9958 x 1.3220788 = 2706.290 kg/m3/s;
    // K = V β/0.1 = 1.1336080e-4; F = 6.013977
    EXPECT_NEAR(WenYu{}(100, 0.9), 6.013977, 1e-6);
    EXPECT_NEAR(dragCoefficient(WenYu{}, water, 2e-3, 0.1 / 1.8, 0.9), 1.133608e-4, 1e-10);
}

TEST(Gidaspow, TakesEachLawInItsRange)
{
    EXPECT_EQ(Gidaspow{}(50, 0.79), Ergun{}(50, 0.79));
    EXPECT_EQ(Gidaspow{}(50, 0.8), WenYu{}(50, 0.8));
}

TEST(SchillerNaumann, SingleSphere)
{
    // Re = 1: Cd Re = 24 1.15 = 27.6. Re = 2000: 0.44 2000 = 880. The voidage only undoes the superficial Re.
    EXPECT_DOUBLE_EQ(SchillerNaumann::cdRe(1), 27.6);
    EXPECT_DOUBLE_EQ(SchillerNaumann::cdRe(2000), 880);
    EXPECT_DOUBLE_EQ(SchillerNaumann{}(0, 1), 1);
    EXPECT_DOUBLE_EQ(SchillerNaumann{}(0.5, 0.5), 1.15);
}

TEST(KochHill, DenseAndDilute)
{
    // αs = 0.5, Re = 100: F0 = 10 0.5/0.125 = 40; F3 = 0.0673 + 0.106 + 0.0232/0.03125 = 0.9157;
    // F = 0.25 (40 + 45.785) = 21.44625
    EXPECT_NEAR(KochHill{}(100, 0.5), 21.44625, 1e-10);
    // αs = 0.2, Re = 0: F0 = (1 + 3 √0.1 + 2.109375 0.2 ln 0.2 + 3.228)/(1 + 0.1362 - 0.3392 + 0.06528)
    //                      = 4.497706/0.86228 = 5.21606; F = 0.64 F0 = 3.33828
    EXPECT_NEAR(KochHill{}(0, 0.8), 3.33828, 1e-4);
    EXPECT_EQ(KochHill{}(0, 1), 1);
}

TEST(Beetstra, Bed)
{
    // αs = 0.5, Re = 100: 10 0.5/0.25 = 20; 0.25 (1 + 1.5 √0.5) = 0.515165;
    // 0.413 100/(24 0.25) = 6.883333 times (2 + 0.75 + 8.4 100^-0.343 = 1.730929) = 4.480929
    // over (1 + 10^1.5 100^-1.5 = 1.031623) gives 29.89826; f = 50.41343, F = 25.20671
    EXPECT_NEAR(Beetstra{}(100, 0.5), 25.20671, 1e-5);
    EXPECT_DOUBLE_EQ(Beetstra{}(0, 1), 1);
    EXPECT_NEAR(Beetstra{}(1e-9, 0.5), Beetstra{}(0, 0.5), 1e-4);
}

namespace
{

struct Value {
    double re, fluidFraction, drag; ///< F(Re, αf)
};

/// Worked out from the published, dimensional formulas alone (K from the force or from β, with the slip that belongs to
/// Re), F = K/(3πμD); dilute, dense, both branches of Gidaspow, Koch & Hill and Schiller & Naumann.
const std::map<std::string, std::vector<Value>> byHand{
    {"DiFelice",
     {{0.1, 0.95, 1.19427},
      {1, 0.9, 1.5969},
      {10, 0.7, 4.10387},
      {100, 0.5, 22.415},
      {400, 0.45, 82.1109},
      {1200, 0.85, 44.4339}}},
    {"Gidaspow",
     {{0.1, 0.95, 1.18093},
      {1, 0.9, 1.52039},
      {10, 0.7, 4.96032},
      {100, 0.5, 27.7778},
      {400, 0.45, 96.6049},
      {1200, 0.85, 33.8425}}},
    {"SchillerNaumann",
     {{0.1, 0.95, 1.03194},
      {1, 0.9, 1.16126},
      {10, 0.7, 1.9322},
      {100, 0.5, 6.71346},
      {400, 0.45, 16.9202},
      {1200, 0.85, 25.8824}}},
    {"KochHill",
     {{0.1, 0.95, 1.75436},
      {1, 0.9, 2.33857},
      {10, 0.7, 5.28316},
      {100, 0.5, 21.4463},
      {400, 0.45, 70.5892},
      {1200, 0.85, 68.4291}}},
    {"Beetstra",
     {{0.1, 0.95, 1.67665},
      {1, 0.9, 2.24834},
      {10, 0.7, 5.79555},
      {100, 0.5, 25.2067},
      {400, 0.45, 74.0323},
      {1200, 0.85, 58.0051}}},
    {"none", {{0.1, 0.95, 0}, {1200, 0.5, 0}}},
};

/// F of a single sphere as Re -> 0: Stokes' 1, Di Felice's own limit 4.8²/24.
const std::map<std::string, double> stokesLimit{{"DiFelice", 0.96}, {"Gidaspow", 1}, {"SchillerNaumann", 1},
                                                {"KochHill", 1},    {"Beetstra", 1}, {"none", 0}};

double drag(const std::string& name, double re, double fluidFraction)
{
    Settings settings("constant/couplingProperties", "forces");
    settings.set("drag", name);
    return std::visit([&](const auto& law) { return law(re, fluidFraction); },
                      Catalogue<DragLaw>::choose(settings, "drag"));
}

} // namespace

/// A law that joins the catalogue without values here fails.
TEST(DragLaws, EveryLawOfTheCatalogueHasItsPublishedValues)
{
    for (const std::string& name : Catalogue<DragLaw>::names()) {
        ASSERT_EQ(byHand.count(name), 1u) << name << " has no values worked out by hand";
        for (const Value& value : byHand.at(name))
            EXPECT_NEAR(drag(name, value.re, value.fluidFraction), value.drag, 1e-5 * value.drag)
                << name << " at Re " << value.re << ", αf " << value.fluidFraction;
    }
}

TEST(DragLaws, EveryLawHasItsStokesLimit)
{
    for (const std::string& name : Catalogue<DragLaw>::names()) {
        ASSERT_EQ(stokesLimit.count(name), 1u) << name << " has no limit worked out by hand";
        EXPECT_DOUBLE_EQ(drag(name, 0, 1), stokesLimit.at(name)) << name;
        EXPECT_NEAR(drag(name, 1e-10, 1), stokesLimit.at(name), 1e-4) << name;
    }
}

/// More solid, more drag; faster, more drag: over all Re and αf but where Gidaspow and Koch & Hill jump, as published.
TEST(DragLaws, GrowWithSolidAndSpeed)
{
    for (const std::string& name : Catalogue<DragLaw>::names()) {
        for (const double re : {0.01, 1.0, 50.0, 500.0}) {
            for (double e = 0.45; e < 0.99; e += 0.03) {
                const double one = drag(name, re, e);
                EXPECT_GE(drag(name, 1.2 * re, e), one) << name << ", Re " << re << ", αf " << e;
                const bool jumps = (name == "Gidaspow" && e < 0.8 && e + 0.03 >= 0.8) ||
                                   (name == "KochHill" && e <= 0.6 && e + 0.03 > 0.6);
                EXPECT_TRUE(jumps || drag(name, re, e + 0.03) <= one) << name << ", Re " << re << ", αf " << e;
            }
        }
    }
}

TEST(SchillerNaumann, ItsLimits)
{
    // Re -> 0: F - 1 = 0.15 Re^0.687, 0.15 x 10^(-4.122) = 1.13263e-5 at Re = 1e-6
    EXPECT_NEAR(SchillerNaumann{}(1e-6, 1) - 1, 1.13263e-5, 1e-10);
    // Cd = 24/999.999 (1 + 0.15 x 115.0800) = 0.438289 just below Re = 1000, Newton's 0.44 from there on
    EXPECT_NEAR(SchillerNaumann::cdRe(999.999) / 999.999, 0.438289, 1e-6);
    for (const double re : {1000.0, 3e4, 2e5})
        EXPECT_DOUBLE_EQ(SchillerNaumann::cdRe(re) / re, 0.44);
}

TEST(ForceModel, PressureGradientIsBuoyancyAndHasNoOtherPart)
{
    LocalFlow flow;
    flow.pressureGradient = {0, 0, -9810};
    const ParticleState sphere{{}, {}, 1e-3, 1};
    const Interaction force = model({})(flow, sphere, water, air);
    EXPECT_NEAR(force.passiveForce.z, 9810 * 4.0 / 3 * pi * 1e-9, 1e-18); // 4.109e-5 N
    EXPECT_EQ(force.passiveForce.x, 0);
}

TEST(ForceModel, AddedMassAndSpin)
{
    LocalFlow flow;
    flow.water.acceleration = {3, 0, 0};
    flow.water.vorticity = {0, 0, 8};
    const ParticleState sphere{{}, {}, 1e-3, 1};
    const Interaction force = model({{"rotationalDrag", "on"}})(flow, sphere, water, air);
    EXPECT_NEAR(force.addedMass, 0.5 * 1000 * 4.0 / 3 * pi * 1e-9, 1e-18);
    EXPECT_EQ(force.fluidAcceleration.x, 3);
    EXPECT_NEAR(force.spinCoefficient, pi * 1e-3 * 8e-9, 1e-20);
    EXPECT_EQ(force.fluidSpin.z, 4);
    EXPECT_EQ(model({{"addedMass", "off"}})(flow, sphere, water, air).addedMass, 0);
}

TEST(ForceModel, PartlyWetBlendsForcesNotViscosities)
{
    LocalFlow flow;
    flow.water.velocity = flow.air.velocity = {0.05, 0, 0};
    flow.wetShare = 0.25;
    const ParticleState sphere{{}, {}, 1e-3, 1};
    const Interaction force = model({})(flow, sphere, water, air);
    const double inWater = dragCoefficient(DiFelice{}, water, 2e-3, 0.05, 1);
    const double inAir = dragCoefficient(DiFelice{}, air, 2e-3, 0.05, 1);
    EXPECT_DOUBLE_EQ(force.dragCoefficient, 0.25 * inWater + 0.75 * inAir);
    EXPECT_DOUBLE_EQ(force.addedMass, 0.5 * 4.0 / 3 * pi * 1e-9 * (0.25 * 1000 + 0.75 * 1.2));
}

/// Still water below, a wind of 20 m/s above, a sphere at rest that is half in each.
TEST(ForceModel, EachFluidPushesWithItsOwnVelocityAndAcceleration)
{
    LocalFlow flow;
    flow.wetShare = 0.5;
    flow.air.velocity = {20, 0, 0};
    flow.air.acceleration = {100, 0, 0};
    const ParticleState sphere{{}, {}, 1e-3, 1};
    const Interaction force = model({})(flow, sphere, water, air);
    const double inWater = 0.5 * dragCoefficient(DiFelice{}, water, 2e-3, 0, 1);
    const double inAir = 0.5 * dragCoefficient(DiFelice{}, air, 2e-3, 20, 1);
    EXPECT_DOUBLE_EQ(force.dragCoefficient, inWater + inAir);
    EXPECT_DOUBLE_EQ(force.dragCoefficient * force.fluidVelocity.x, inAir * 20);
    EXPECT_NEAR(force.addedMass * force.fluidAcceleration.x, 0.5 * 0.5 * 1.2 * 4.0 / 3 * pi * 1e-9 * 100, 1e-20);
}

TEST(ForceModel, ASphereThatIsHalfThereFeelsHalf)
{
    LocalFlow flow;
    flow.water.velocity = {0.05, 0, 0};
    flow.pressureGradient = {0, 0, -9810};
    ParticleState sphere{{}, {}, 1e-3, 1};
    const Interaction whole = model({})(flow, sphere, water, air);
    sphere.presence = 0.5;
    const Interaction half = model({})(flow, sphere, water, air);
    EXPECT_DOUBLE_EQ(half.dragCoefficient, 0.5 * whole.dragCoefficient);
    EXPECT_DOUBLE_EQ(half.addedMass, 0.5 * whole.addedMass);
    EXPECT_DOUBLE_EQ(half.passiveForce.z, 0.5 * whole.passiveForce.z);
    EXPECT_EQ(half.fluidVelocity.x, whole.fluidVelocity.x);
}

TEST(ForceModel, ShieldingScalesDragAndAddedMassOnly)
{
    LocalFlow flow;
    flow.water.velocity = {0.05, 0, 0};
    flow.pressureGradient = {0, 0, -9810};
    const ParticleState open{{}, {}, 1e-3, 1}, shielded{{}, {}, 1e-3, 0.25};
    const ForceModel on = model({{"shielding", "on"}});
    const Interaction full = on(flow, open, water, air), part = on(flow, shielded, water, air);
    EXPECT_DOUBLE_EQ(part.dragCoefficient, 0.25 * full.dragCoefficient);
    EXPECT_DOUBLE_EQ(part.addedMass, 0.25 * full.addedMass);
    EXPECT_EQ(part.passiveForce.z, full.passiveForce.z);
    EXPECT_EQ(model({})(flow, shielded, water, air).dragCoefficient, full.dragCoefficient);
}

/// 1 m3 of spheres of 900 kg/m3 in a bed with ε = 0.4: shut-in water of 1000 kg/m3 has the inertia 1000 0.6/0.4 = 1500 kg.
TEST(PressureResponse, ShutInWaterIsAnInertia)
{
    ResponseSums sums;
    sums.volume = 1, sums.mass = 900, sums.displaced = 1000;
    sums.drive = {2400, 0, 0};
    EXPECT_DOUBLE_EQ(pressureResponse(sums, 0.4, 0.1).x, -1500); // 1 m/s2
    sums.drive = {900, 0, 0};
    sums.reference = {1, 0, 0}; // ∇p knows it: the particles go on accelerating so
    EXPECT_NEAR(pressureResponse(sums, 0.4, 0.1).x, 0, 1e-12);
}

/// ... with added mass 500 (1/0.16 - 1) = 2625 kg more, and drag of 200 kg/s, 200 5.25 0.1 = 105 kg.
TEST(PressureResponse, AddedMassAndDragAnswerToo)
{
    ResponseSums sums;
    sums.volume = 2, sums.mass = 900, sums.addedMass = 500, sums.displaced = 1000, sums.drag = 200;
    sums.drive = {0, 900 + 500 + 1500 + 2625 + 20 + 105, 0};
    EXPECT_NEAR(pressureResponse(sums, 0.4, 0.1).y, -(1500 + 2625 + 105) / 2.0, 1e-10);
}

TEST(PressureResponse, NothingInFreeFluidOrWithoutParticles)
{
    ResponseSums sums;
    EXPECT_EQ(norm(pressureResponse(sums, 0.4, 0.1)), 0);
    sums.volume = 1, sums.mass = 900, sums.addedMass = 500, sums.displaced = 1000, sums.drag = 200;
    sums.drive = {1000, 0, 0};
    EXPECT_EQ(pressureResponse(sums, 1, 0.1).x, 0);
}

TEST(ForceModel, NothingMovesNothingBreaks)
{
    const ParticleState sphere{{}, {}, 1e-3, 1};
    for (const std::string& law : Catalogue<DragLaw>::names()) {
        const Interaction force = model({{"drag", law.c_str()}})(LocalFlow{}, sphere, water, air);
        EXPECT_TRUE(std::isfinite(force.dragCoefficient)) << law;
        EXPECT_EQ(norm(force.passiveForce), 0) << law;
    }
}

TEST(ForceModel, RefusesAnUnknownLaw)
{
    try {
        model({{"drag", "DiFellice"}});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(),
                  "constant/couplingProperties: forces.drag DiFellice: is not one of the choices (did you "
                  "mean \"DiFelice\"?). Choose from: " +
                      joined(Catalogue<DragLaw>::names()) + ".");
    }
}
