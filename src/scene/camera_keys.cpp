// Keys of the camera, the construction's position and the trails.
#include <array>
#include <string_view>

#include "scene/camera_views.h"
#include "scene/scene_key_rows.h"

namespace poinsot {

namespace {

constexpr std::array<std::string_view, 2> camera_motions{"fixed", "co-precessing"};
constexpr std::array<std::string_view, 3> trail_kinds{"whole", "history", "fading"};
constexpr std::array<std::string_view, 2> plane_sides{"below", "above"};
constexpr std::array<std::string_view, 2> construction_sweeps{"axis", "energy"};

template <typename Value>
constexpr auto camera(Value CameraSpec::*member) {
    return in(&Scene::camera, member);
}
template <typename Value>
constexpr auto trail(Value TrailSpec::*member) {
    return in(&Scene::trail, member);
}

}  // namespace

std::span<const SceneKey> camera_keys() {
    using namespace key_rows;
    static const SceneKey rows[] = {
        // The camera; the picture's vertical is the normal of the invariable plane.
        number("camera.azimuth_deg", camera(&CameraSpec::azimuth_deg), within(-3600.0, 3600.0),
               "degrees", "-40.0", "direction of the camera about the vertical"),
        number("camera.elevation_deg", camera(&CameraSpec::elevation_deg), elevations_deg,
               "degrees", "14.0", "its height above the plane"),
        number("camera.distance", camera(&CameraSpec::distance), distances, "largest half-axes",
               "5.2",
               "its distance from the target; more where the figure would not fit, unless target "
               "is given"),
        number("camera.field_deg", camera(&CameraSpec::field_deg), fields_deg, "degrees", "28.0",
               "its vertical field of view"),
        numbers("camera.target", camera(&CameraSpec::target), coordinates, "largest half-axes",
                "[0.0, 0.0, -0.2]", "the point it looks at, in picture axes")
            .default_is("what look_at names"),
        one_of("camera.look_at", camera(&CameraSpec::look_at), camera_aims(), R"("foot")",
               "middle of the construction, centre of the body, or foot of L on the plane"),
        text("camera.view", camera(&CameraSpec::view), R"("contact")",
             "a view by name for all of the camera that is not said otherwise")
            .from_list("views")
            .checked_by(camera_view_named),
        one_of("camera.motion", camera(&CameraSpec::motion), camera_motions, R"("fixed")",
               "fixed, or co-precessing: turning about L with the herpolhode's mean advance, so "
               "that every polhode period looks like the last"),
        one_of("camera.projection", camera(&CameraSpec::projection), camera_projections(),
               R"("orthographic")",
               "perspective, or orthographic: along parallel lines, so that what is parallel stays "
               "so and equal lengths are equal wherever they lie")
            .omitted_if_default(),

        // How the construction lies in the picture.
        one_of("construction.plane", in(&Scene::construction, &ConstructionSpec::plane),
               plane_sides, R"("above")",
               "below: the body rolls on the invariable plane, L and ω point down to it; above: L "
               "and ω point up to the plane, which is seen through"),
        one_of("construction.sweep", in(&Scene::construction, &ConstructionSpec::sweep),
               construction_sweeps, R"("axis")",
               "what the film runs through instead of the motion. axis: an axis n over all "
               "directions of the body at rest; energy: √(2T)/L from the least to the greatest "
               "that the body has")
            .default_is("none"),

        // Which part of the contact point's paths is shown.
        one_of("trail.polhode", trail(&TrailSpec::polhode), trail_kinds, R"("fading")",
               "whole, history (since the film began) or fading (what trail.length_s holds)"),
        one_of("trail.herpolhode", trail(&TrailSpec::herpolhode), trail_kinds, R"("fading")",
               "whole (of the film), history or fading"),
        number("trail.length_s", trail(&TrailSpec::length_s), positive, "s", "4.0",
               "length of a fading trail, in seconds of motion")
            .default_is("one polhode period"),
        boolean("trail.direction_marks", trail(&TrailSpec::direction_marks), "true",
                "small chevrons along both paths, for the sense of the motion"),
    };
    return rows;
}

}  // namespace poinsot
