// The film's timeline: the camera's pose and the opacity of each element at any second of the film.
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

// The camera's values at one instant, as in CameraSpec.
struct CameraPose {
    double azimuth_deg = 0.0, elevation_deg = 0.0;
    double distance = 1.0;
    double field_deg = 28.0;
    double roll_deg = 0.0;                             // turns the picture counterclockwise
    Eigen::Vector3d target = Eigen::Vector3d::Zero();  // picture axes
    // 1: aimed at the whole figure and moved back if needed, as without an explicit target; 0:
    // exactly at `target` and `distance`; between: interpolated.
    double framing = 1.0;
};

class Timeline {
 public:
    Timeline() = default;
    // `foot`: where L meets the invariable plane, picture axes; look_at's names are located with
    // it.
    Timeline(const Scene& scene, const Eigen::Vector3d& foot);
    // The timeline of one panel's own camera, with the keyframes that name the panel.
    Timeline(const Scene& scene, const CameraSpec& camera, std::optional<int> panel,
             const Eigen::Vector3d& foot);

    CameraPose camera_at(double film_s) const;
    bool camera_moves() const;
    // The second of the film after which the camera does not move.
    double last_key_s() const { return last_key_s_; }
    // The pose at second 0 with the least distance and field of the whole film: an upper bound of
    // the resolution at the target.
    CameraPose nearest_camera() const;

    // Whether a fade names this element, and the element's opacity, 0…1.
    bool fades(std::string_view name) const { return opacities_.contains(name); }
    double opacity_of(std::string_view name, double film_s) const;

 private:
    Track azimuth_deg_, elevation_deg_, log_distance_, field_deg_, framing_;
    std::array<Track, 3> target_;
    double last_key_s_ = 0.0;
    double roll_deg_ = 0.0;
    double distance_ = 1.0;  // of a camera that does not move, exactly as given
    std::map<std::string, Track, std::less<>> opacities_;
};

// The point that a name in look_at denotes, picture axes.
Eigen::Vector3d aim_point(std::string_view name, const Eigen::Vector3d& foot);

}  // namespace poinsot
