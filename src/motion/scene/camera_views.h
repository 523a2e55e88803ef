// The table of named camera views.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

// The [camera] values of a named view.
struct CameraView {
    std::string_view name;
    std::string_view summary;
    double azimuth_deg, elevation_deg;
    double distance;  // in largest half-axes
    double field_deg;
    std::string_view look_at;  // of camera_aims()
};

std::span<const CameraView> camera_views();

// Returns a view by name. Throws InputError with the nearest name and the list.
const CameraView& camera_view_named(std::string_view name);

// The projections: "perspective", or "orthographic", along parallel lines.
std::span<const std::string_view> camera_projections();

// The names that `look_at` accepts: "middle" of the construction, "centre" of the body, "foot" of L
// on the invariable plane.
std::span<const std::string_view> camera_aims();

}  // namespace poinsot
