// The bodies of the lecture as closed parts, with their measurements and masses.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "bodies/mass_properties.h"
#include "bodies/triangle_mesh.h"

namespace poinsot {

// A body's surface as it is seen may be finer or coarser than what determines its mass: laces on a
// ball, craters on an asteroid.
enum class PartUse { mass_and_look, mass_only, look_only };

// One closed surface of uniform density and colour, in the body's axes.
struct ObjectPart {
    std::string_view name;
    TriangleMesh mesh;             // m
    std::array<double, 3> srgb{};  // sRGB-encoded, 0…1
    double density_kg_m3 = 1.0;
    PartUse use = PartUse::mass_and_look;
};

// A row of the table of objects. The principal axes of a body with any symmetry lie along x, y, z:
// the axis of symmetry along z; without one, the largest moment of inertia about x, the middle one
// about y and the smallest about z. The centre of mass is at the origin.
struct NamedObject {
    std::string_view name;
    std::string_view summary;
    std::string_view source;  // of the measurements
    std::vector<ObjectPart> (*make)();
};

std::span<const NamedObject> named_objects();

// Returns the object of this name. Throws InputError for an unknown name and suggests the nearest
// one.
const NamedObject& object_named(std::string_view name);

// Mass, centre of mass and inertia of all parts with mass together, in kg, m and kg m².
BodyProperties properties_of(std::span<const ObjectPart> parts);

}  // namespace poinsot
