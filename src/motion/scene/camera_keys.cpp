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
               "degrees", "14.0", "angle of the camera above the horizontal"),
        number("camera.distance", camera(&CameraSpec::distance), distances,
               "units of the largest half-axis", "5.2",
               "distance of the camera from its target; without target, poinsot increases it until "
               "the figure fits"),
        number("camera.field_deg", camera(&CameraSpec::field_deg), fields_deg, "degrees", "28.0",
               "vertical field of view"),
        number("camera.roll_deg", camera(&CameraSpec::roll_deg), within(-360.0, 360.0), "degrees",
               "90.0", "turns the picture counterclockwise; 90 lays L flat")
            .omitted_if_default(),
        numbers("camera.target", camera(&CameraSpec::target), coordinates,
                "units of the largest half-axis", "[0.0, 0.0, -0.2]",
                "point that the camera looks at, in picture axes")
            .default_is("the point that look_at names"),
        one_of("camera.look_at", camera(&CameraSpec::look_at), camera_aims(), R"("foot")",
               "point that the camera looks at: middle of the construction, centre of the body, or "
               "foot of L on the plane"),
        text("camera.view", camera(&CameraSpec::view), R"("contact")",
             "named view, which supplies the values that this table does not set")
            .from_list("views")
            .checked_by(camera_view_named),
        one_of("camera.motion", camera(&CameraSpec::motion), camera_motions, R"("fixed")",
               "fixed, or co-precessing: the camera rotates about L at the mean rate of the "
               "herpolhode, so that all polhode periods look the same"),
        one_of("camera.projection", camera(&CameraSpec::projection), camera_projections(),
               R"("orthographic")",
               "perspective, or orthographic: parallel lines stay parallel, and lengths do not "
               "depend on the distance")
            .omitted_if_default(),

        // How the construction lies in the picture.
        one_of("construction.plane", in(&Scene::construction, &ConstructionSpec::plane),
               plane_sides, R"("above")",
               "below: the body rolls on the invariable plane, and L and ω point down; above: L "
               "and ω point up to the plane, and you look through it"),
        one_of("construction.sweep", in(&Scene::construction, &ConstructionSpec::sweep),
               construction_sweeps, R"("axis")",
               "quantity that the film varies instead of time; axis: an axis n runs over all "
               "directions of a body at rest; energy: √(2T)/L runs from its least to its greatest "
               "value")
            .default_is("none"),

        // Which part of the contact point's paths and of the path of a top's axis is shown.
        one_of("trail.polhode", trail(&TrailSpec::polhode), trail_kinds, R"("fading")",
               "part of the polhode that is drawn: whole, history (since the film began) or fading "
               "(the last trail.length_s)"),
        one_of(
            "trail.herpolhode", trail(&TrailSpec::herpolhode), trail_kinds, R"("fading")",
            "part of the herpolhode that is drawn: whole (of the entire film), history or fading"),
        one_of("trail.axis", trail(&TrailSpec::axis), trail_kinds, R"("fading")",
               "part of the path of a heavy top's axis that is drawn: whole, history or fading")
            .omitted_if_default(),
        number("trail.length_s", trail(&TrailSpec::length_s), positive, "s", "4.0",
               "length of a fading trail, in seconds of motion")
            .default_is("one polhode period, or one nutation of a heavy top"),
        boolean("trail.direction_marks", trail(&TrailSpec::direction_marks), "true",
                "whether chevrons along both paths show the direction of motion"),
        boolean("trail.ticks", trail(&TrailSpec::ticks), "true",
                "whether polhode and herpolhode have ticks at equal lengths, which meet at the "
                "contact point: the ellipsoid rolls without slipping")
            .omitted_if_default(),
    };
    return rows;
}

}  // namespace poinsot
