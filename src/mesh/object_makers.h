// One function for each built-in object. Inside of src/mesh only.
#pragma once

#include <vector>

#include "mesh/named_objects.h"

namespace poinsot::object_makers {

// Things at hand (everyday_objects.cpp).
std::vector<ObjectPart> t_handle();
std::vector<ObjectPart> racket();
std::vector<ObjectPart> book();
std::vector<ObjectPart> football();
std::vector<ObjectPart> plate();
std::vector<ObjectPart> disc();
std::vector<ObjectPart> coin();

// The solids by an example of each (plain_objects.cpp).
std::vector<ObjectPart> box();
std::vector<ObjectPart> cylinder();
std::vector<ObjectPart> cone();
std::vector<ObjectPart> ellipsoid();
std::vector<ObjectPart> sphere();
std::vector<ObjectPart> torus();

// Celestial bodies (celestial_objects.cpp).
std::vector<ObjectPart> earth();
std::vector<ObjectPart> toutatis();

// The parts with the one density that gives them this mass together.
std::vector<ObjectPart> of_mass(std::vector<ObjectPart> parts, double mass_kg);

// The parts moved so that their common centre of mass is the origin.
std::vector<ObjectPart> centred(std::vector<ObjectPart> parts);

}  // namespace poinsot::object_makers
