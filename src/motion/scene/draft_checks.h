// Functions that check the values of a draft against each other, shared by the complete_*
// functions.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/power_of_two.h"
#include "scene/scene_draft.h"
#include "scene/scene_error.h"

namespace poinsot {

// Throws SceneError at a key.
[[noreturn]] void refuse(const Scene& scene, const std::string& key, std::string_view what);

// Refuses pairs of keys that give one value in two different ways, at the later key.
void refuse_mixed(const Scene& scene, std::span<const std::vector<std::string>> ways,
                  std::string_view remedy);

// The bytes of the file that a key names. Throws SceneFileError at the key.
FileBytes file_named(const SceneDraft& draft, NamedFile::Kind kind, const std::string& key,
                     const std::string& name);

// Returns the unit vector along the given one. A vector of length 1 to rounding is kept exactly, so
// that a scene written out reads back the same; any other is normalised with a note to the user.
// Throws for the zero vector.
template <typename Vector>
Vector unit(Scene& scene, const std::string& key, const Vector& given) {
    const double length = norm_of(given);
    if (!(length > 0.0)) {
        refuse(scene, key, fmt::format("{} is zero; give one that has a direction", key));
    }
    // A quotient of doubles has a squared length within 5 ulp of 1.
    constexpr double rounding = 1.2e-15;
    if (std::abs(given.squaredNorm() - 1.0) <= rounding) return given;
    Vector scaled = given / given.cwiseAbs().maxCoeff();
    scaled /= scaled.norm();
    if (std::abs(length - 1.0) > 1e-12) {
        scene.notes.push_back(fmt::format("{} has length {:.6g} and was scaled to 1", key, length));
    }
    return scaled;
}

// The steps of complete_scene.
void complete_body(SceneDraft& draft);
void complete_object_body(SceneDraft& draft);  // [body] object
void complete_mesh_body(SceneDraft& draft);    // [body] mesh
void complete_look(SceneDraft& draft);         // [object], after the body
void complete_faces(SceneDraft& draft);        // its marked face and pictures, after complete_look
void complete_start(SceneDraft& draft);
void complete_film(SceneDraft& draft);
void complete_camera(SceneDraft& draft);
void complete_timeline(SceneDraft& draft);
void complete_style(SceneDraft& draft);  // a theme file, after [style] is read
void complete_marks(SceneDraft& draft);
void complete_measured(SceneDraft& draft);

}  // namespace poinsot
