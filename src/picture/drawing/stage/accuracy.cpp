#include "drawing/stage/accuracy.h"

#include <cmath>
#include <numbers>

#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/timeline.h"

namespace poinsot {

Accuracy accuracy_of(const Scene& scene) {
    // Arrows reach longest_arrow_length; their nearest point is nearer to the eye than the target
    // by that length.
    const CameraPose camera = Timeline(scene, Eigen::Vector3d::Zero()).nearest_camera();
    const double nearest = std::max(0.1, camera.distance - longest_arrow_length);
    const double field_rad = camera.field_deg * std::numbers::pi / 180.0;
    const double units_per_px = 2.0 * nearest * std::tan(0.5 * field_rad) / scene.film.height_px;
    return {scene.accuracy_px, longest_arrow_length / units_per_px};
}

}  // namespace poinsot
