// The physical quantities of a motion, each defined once: tables of samples, captions and charts
// show them. Index 1 to 3 alone, as in omega_1, means a component along a principal axis; names
// with "body" mean the body axes, in which the scene gives its numbers.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "construction/poinsot_construction.h"
#include "mechanics/motion.h"

namespace poinsot {

// A unit as printed, "kg m²/s", and as the end of a name, "kg_m2_s"; both empty for a dimensionless
// number.
struct QuantityUnit {
    std::string_view printed;
    std::string_view suffix;
};

// The body and the construction, which the quantities of all instants share.
struct QuantitySource {
    const InertiaTensor& inertia;
    const PoinsotConstruction* construction = nullptr;  // set if the residuals are asked for
    bool has_angles = false;  // whether the samples contain the motion's own Euler angles
};

struct Quantity {
    std::string_view name;
    std::string_view symbol;  // the lecture's, accepted as a name; may be empty
    std::string_view summary;
    std::span<const std::string_view> components;  // names of the numbers, without unit
    QuantityUnit unit;
    Quantities wanted;  // from the motion
    // One value for each component. Throws InputError where there is none.
    void (*values)(const QuantitySource& source, const MotionSample& sample, double* values);
    bool (*offered)(const Motion&) = nullptr;  // null: by every motion
    std::string_view offered_by = {};          // description of those motions, for messages
};

std::span<const Quantity> quantities();

// "omega_1_rad_s": the name of a component with its unit.
std::string name_with_unit(const Quantity& quantity, std::size_t component);

// ω and L along the principal axes, L in body axes, and T: in rad/s, kg m²/s and J.
Eigen::Vector3d omega_principal(const InertiaTensor& inertia, const MotionSample& sample);
Eigen::Vector3d momentum_principal(const InertiaTensor& inertia, const MotionSample& sample);
Eigen::Vector3d momentum_body(const InertiaTensor& inertia, const MotionSample& sample);
double kinetic_energy_J(const InertiaTensor& inertia, const MotionSample& sample);

}  // namespace poinsot
