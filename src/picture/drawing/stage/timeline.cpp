#include "drawing/stage/timeline.h"

#include <algorithm>
#include <cmath>

namespace poinsot {

Eigen::Vector3d aim_point(std::string_view name, const Eigen::Vector3d& foot) {
    if (name == "centre") return Eigen::Vector3d::Zero();
    if (name == "foot") return foot;
    // The middle between the plane and the extent of the body on its other side.
    return 0.5 * (foot - foot.stableNormalized());
}

Timeline::Timeline(const Scene& scene, const Eigen::Vector3d& foot)
    : Timeline(scene, scene.camera, std::nullopt, foot) {}

Timeline::Timeline(const Scene& scene, const CameraSpec& camera, std::optional<int> panel,
                   const Eigen::Vector3d& foot)
    : azimuth_deg_(camera.azimuth_deg),
      elevation_deg_(camera.elevation_deg),
      log_distance_(std::log(camera.distance)),
      field_deg_(camera.field_deg),
      framing_(!camera.target && camera.look_at == "middle" ? 1.0 : 0.0),
      roll_deg_(camera.roll_deg),
      distance_(camera.distance) {
    const Eigen::Vector3d start = camera.target.value_or(aim_point(camera.look_at, foot));
    for (int i = 0; i < 3; ++i) target_[static_cast<std::size_t>(i)] = Track(start[i]);
    for (const KeyframeSpec& key : scene.keyframes) {
        if (key.panel != panel) continue;
        const Easing& easing = easing_named(key.easing);
        if (key.azimuth_deg) azimuth_deg_.add(key.at_s, *key.azimuth_deg, easing);
        if (key.elevation_deg) elevation_deg_.add(key.at_s, *key.elevation_deg, easing);
        // The logarithm is interpolated, so that a zoom has a constant ratio per time.
        if (key.distance) log_distance_.add(key.at_s, std::log(*key.distance), easing);
        if (key.field_deg) field_deg_.add(key.at_s, *key.field_deg, easing);
        last_key_s_ = key.at_s;
        if (!key.target && key.look_at.empty()) continue;
        framing_.add(key.at_s, !key.target && key.look_at == "middle" ? 1.0 : 0.0, easing);
        const Eigen::Vector3d target = key.target.value_or(aim_point(key.look_at, foot));
        for (int i = 0; i < 3; ++i) {
            target_[static_cast<std::size_t>(i)].add(key.at_s, target[i], easing);
        }
    }

    for (const FadeSpec& fade : scene.fades) {
        const Easing& easing = easing_named(fade.easing);
        for (const std::string& name : fade.elements) {
            // An element that first fades in to full opacity starts invisible; one that fades out
            // starts visible.
            const auto known = opacities_.try_emplace(name, fade.opacity < 1.0 ? 1.0 : 0.0).first;
            Track& opacity = known->second;
            opacity.add(fade.at_s, opacity.last_value(), easing);
            opacity.add(fade.at_s + fade.over_s, fade.opacity, easing);
        }
    }
}

CameraPose Timeline::camera_at(double film_s) const {
    CameraPose pose;
    pose.azimuth_deg = azimuth_deg_.at(film_s);
    pose.elevation_deg = elevation_deg_.at(film_s);
    pose.distance = log_distance_.moves() ? std::exp(log_distance_.at(film_s)) : distance_;
    pose.field_deg = field_deg_.at(film_s);
    pose.roll_deg = roll_deg_;
    pose.framing = framing_.at(film_s);
    for (int i = 0; i < 3; ++i) {
        pose.target[i] = target_[static_cast<std::size_t>(i)].at(film_s);
    }
    return pose;
}

bool Timeline::camera_moves() const {
    return azimuth_deg_.moves() || elevation_deg_.moves() || log_distance_.moves() ||
           field_deg_.moves() || framing_.moves() ||
           std::any_of(target_.begin(), target_.end(), [](const Track& t) { return t.moves(); });
}

CameraPose Timeline::nearest_camera() const {
    CameraPose pose = camera_at(0.0);
    if (log_distance_.moves()) pose.distance = std::exp(log_distance_.least());
    pose.field_deg = field_deg_.least();
    return pose;
}

double Timeline::opacity_of(std::string_view name, double film_s) const {
    const auto found = opacities_.find(name);
    return found == opacities_.end() ? 1.0 : found->second.at(film_s);
}

}  // namespace poinsot
