#include "body_options.h"

#include "DidYouMean.h"

#include <algorithm>

namespace frazil
{

BodyOptions::BodyOptions(const Settings& words)
{
    mesh = words.text("mesh");
    if (words.has("density"))
        density = words.positive("density");
    if (words.has("mass"))
        mass = words.positive("mass");
    velocity = words.vec3("velocity", velocity);
    omega = words.vec3("omega", omega);
    hasCom = words.has("com");
    com = words.vec3("com", com);
    if (words.has("inertia"))
        readInertia(words);
    if (words.has("lock"))
        readLock(words);
    if (density <= 0 && mass <= 0)
        words.reject("mesh", "gives the body no mass", "Add 'density RHO' [kg/m3] or 'mass M' [kg], above zero");
    if (hasCom && !hasInertia)
        words.reject("com", "moves the centre of mass away from the surface's centroid, so its inertia is not known",
                     "Add 'inertia XX YY ZZ XY XZ YZ' about that centre [kg m2]");
}

void BodyOptions::readInertia(const Settings& words)
{
    const std::vector<double> given = words.numbers("inertia");
    std::copy(given.begin(), given.end(), inertia.begin());
    if (!positiveDefinite(inertia))
        words.reject("inertia", "is not a positive definite tensor",
                     "Its order is XX YY ZZ XY XZ YZ [kg m2], with XY = -sum of m x y");
    hasInertia = true;
}

void BodyOptions::readLock(const Settings& words)
{
    const std::vector<std::string> name = {"x", "y", "z", "rx", "ry", "rz"};
    for (const std::string& word : words.words("lock")) {
        const auto found = std::find(name.begin(), name.end(), word);
        if (found == name.end())
            words.reject("lock", word + " is no direction" + didYouMean(word, name), "Choose from: x y z rx ry rz");
        lock[found - name.begin()] = true;
    }
}

RigidMotion startMotion(const BodyOptions& options, const MassProperties& solid)
{
    RigidMotion motion;
    motion.mass = options.mass > 0 ? options.mass : solid.mass;
    motion.centre = options.hasCom ? options.com : solid.centre;
    motion.inertia = options.hasInertia ? options.inertia : solid.inertia;
    if (!options.hasInertia)
        for (double& component : motion.inertia)
            component *= motion.mass / solid.mass;
    for (int axis = 0; axis < 3; ++axis) {
        motion.lockMove[axis] = options.lock[axis];
        motion.lockTurn[axis] = options.lock[axis + 3];
    }
    motion.velocity = options.velocity;
    motion.setOmega(options.omega);
    return motion;
}

} // namespace frazil
