// The values read so far, before alternative keys are checked against each other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "scene/parse_scene.h"
#include "scene/scene.h"

namespace poinsot {

// A tuple of the alternatives of a variant.
template <typename Variant>
struct OneOfEach;
template <typename... Kinds>
struct OneOfEach<std::variant<Kinds...>> {
    using Tuple = std::tuple<Kinds...>;
};
using TorqueOfEachKind = OneOfEach<Torque>::Tuple;

// The rows of the key table fill it; it holds values that are determined by several keys.
struct SceneDraft {
    Scene scene;
    SceneFiles files = no_scene_file;

    // [body]
    std::optional<Eigen::Vector3d> moments_kg_m2;
    std::optional<Eigen::Matrix3d> tensor_kg_m2;
    std::optional<std::vector<double>> size_m;
    std::optional<double> mass_kg;
    std::vector<PointMass> masses;

    // [start]
    std::optional<double> energy_J, momentum_kg_m2_s, plane_distance;
    std::optional<Eigen::Vector4d> attitude;  // w, x, y, z
    std::optional<Eigen::Matrix3d> attitude_matrix;
    TopStart top;

    // [torque]
    std::string torque_kind = "none";
    TorqueOfEachKind torques;  // of which torque_kind chooses one

    bool has(const std::string& key) const { return scene.locations.contains(key); }
};

// Checks the draft's values against each other and makes the scene. Throws SceneError for missing
// or contradictory values, and for impossible bodies.
Scene complete_scene(SceneDraft draft);

}  // namespace poinsot
