// One function for each built-in object. Included only inside src/motion/bodies.
#pragma once

#include <vector>

#include "bodies/named_objects.h"

namespace poinsot::object_makers {

// Everyday objects (everyday_objects.cpp).
std::vector<ObjectPart> t_handle();
std::vector<ObjectPart> racket();
std::vector<ObjectPart> book();
std::vector<ObjectPart> phone();
std::vector<ObjectPart> football();
std::vector<ObjectPart> plate();
std::vector<ObjectPart> disc();
std::vector<ObjectPart> coin();

// The elementary solids, each as a real object (plain_objects.cpp).
std::vector<ObjectPart> box();
std::vector<ObjectPart> cylinder();
std::vector<ObjectPart> cone();
std::vector<ObjectPart> ellipsoid();
std::vector<ObjectPart> sphere();
std::vector<ObjectPart> torus();

// Celestial bodies (celestial_objects.cpp).
std::vector<ObjectPart> earth();
std::vector<ObjectPart> toutatis();

// Sets one common density of the parts with mass so that their total mass is mass_kg.
std::vector<ObjectPart> of_mass(std::vector<ObjectPart> parts, double mass_kg);

// Moves the parts so that their common centre of mass is the origin.
std::vector<ObjectPart> centred(std::vector<ObjectPart> parts);

}  // namespace poinsot::object_makers
