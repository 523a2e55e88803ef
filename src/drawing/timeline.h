// The film as it is told: where the camera stands and how much of each thing is seen at any second
// of the film.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/track.h"

namespace poinsot {

// The camera's values of one instant, as in CameraSpec.
struct CameraPose {
    double azimuth_deg = 0.0, elevation_deg = 0.0;
    double distance = 1.0;
    double field_deg = 28.0;
    Eigen::Vector3d target = Eigen::Vector3d::Zero();  // picture axes
    // 1: aimed and, if need be, taken away so that the whole figure is seen, as when nothing says
    // where it looks; 0: exactly where `target` and `distance` say; between: on its way.
    double framing = 1.0;
};

class Timeline {
 public:
    Timeline() = default;
    // `foot`: where L meets the invariable plane, picture axes, which places what look_at names.
    Timeline(const Scene& scene, const Eigen::Vector3d& foot);
    // The same of one panel with a camera of its own, which the keyframes that name the panel move.
    Timeline(const Scene& scene, const CameraSpec& camera, std::optional<int> panel,
             const Eigen::Vector3d& foot);

    CameraPose camera_at(double film_s) const;
    bool camera_moves() const;
    // The second of the film after which it stands.
    double last_key_s() const { return last_key_s_; }
    // The pose at second 0 with the least distance and field of the whole film: no pixel covers
    // less of what stands at the target.
    CameraPose nearest_camera() const;

    // Whether a fade names this, and how much of it is seen, 0…1.
    bool fades(std::string_view name) const { return opacities_.contains(name); }
    double opacity_of(std::string_view name, double film_s) const;

 private:
    Track azimuth_deg_, elevation_deg_, log_distance_, field_deg_, framing_;
    std::array<Track, 3> target_;
    double last_key_s_ = 0.0;
    double distance_ = 1.0;  // where it does not move, the very number given
    std::map<std::string, Track, std::less<>> opacities_;
};

// A point that look_at names, picture axes.
Eigen::Vector3d aim_point(std::string_view name, const Eigen::Vector3d& foot);

}  // namespace poinsot
