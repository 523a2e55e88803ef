#include "scene/camera_views.h"

#include <array>

#include "error/error.h"
#include "scene/scene.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

constexpr std::array<std::string_view, 3> aims{"middle", "centre", "foot"};
constexpr std::array<std::string_view, 2> projections{"perspective", "orthographic"};

const std::array<CameraView, 6> view_rows{{
    {"lecture", "the usual view, a little from above", CameraSpec{}.azimuth_deg,
     CameraSpec{}.elevation_deg, CameraSpec{}.distance, CameraSpec{}.field_deg, "middle"},
    {"front", "from the front, level with the centre", -90.0, 3.0, 5.4, 28.0, "middle"},
    {"side", "from the side, level with the centre", 0.0, 3.0, 5.4, 28.0, "middle"},
    {"high", "from high above, so that the plane appears wide", -40.0, 42.0, 6.4, 28.0, "middle"},
    {"top", "from above, along L, so that the herpolhode appears undistorted", -90.0, 90.0, 7.2,
     28.0, "centre"},
    {"contact", "close to the plane, at the contact point", -40.0, 9.0, 3.3, 28.0, "foot"},
}};

}  // namespace

std::span<const CameraView> camera_views() { return view_rows; }

const CameraView& camera_view_named(std::string_view name) {
    if (const CameraView* row = find_row(view_rows, name)) return *row;
    throw InputError(unknown("camera view", name, names_of(view_rows)));
}

std::span<const std::string_view> camera_aims() { return aims; }

std::span<const std::string_view> camera_projections() { return projections; }

}  // namespace poinsot
