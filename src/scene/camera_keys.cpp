// Keys of the camera, the construction's position and the trails.
#include <array>
#include <string_view>

#include "scene/camera_views.h"
#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;

constexpr std::array<std::string_view, 2> camera_motions{"fixed", "co-precessing"};
constexpr std::array<std::string_view, 3> trail_kinds{"whole", "history", "fading"};
constexpr std::array<std::string_view, 2> plane_sides{"below", "above"};
constexpr std::array<std::string_view, 2> construction_sweeps{"axis", "energy"};

const SceneKey camera_rows[] = {
    // The camera; the picture's vertical is the normal of the invariable plane.
    {"camera.azimuth_deg", "a number from -3600 to 3600", "degrees", "-40.0",
     "direction of the camera about the vertical",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.azimuth_deg = g.number_between(-3600.0, 3600.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.azimuth_deg); }},
    {"camera.elevation_deg", "a number from -90 to 90", "degrees", "14.0",
     "its height above the plane",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.elevation_deg = g.number_between(-90.0, 90.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.elevation_deg); }},
    {"camera.distance", "a number from 0.01 to 10000", "largest half-axes", "5.2",
     "its distance from the target; more where the figure would not fit, unless target is given",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.distance = g.number_between(0.01, 10000.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.distance); }},
    {"camera.field_deg", "a number from 0.1 to 150", "degrees", "28.0",
     "its vertical field of view",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.field_deg = g.number_between(0.1, 150.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.field_deg); }},
    {"camera.target", "three numbers", "largest half-axes", "[0.0, 0.0, -0.2]",
     "the point it looks at, in picture axes; default: what look_at names",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.target = target_of(g); },
     [](const Scene& s, size_t) { return optional_text(s.camera.target); }},
    {"camera.look_at", "a string", "", R"("foot")",
     "middle of the construction, centre of the body, or foot of L on the plane; default middle",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.look_at = g.one_of(camera_aims()); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.camera.look_at)); },
     camera_aims()},
    {"camera.view", "a string", "", R"("contact")",
     "a view by name for all of the camera that is not said otherwise, see `poinsot list views`",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.view = name_in_table(g, camera_view_named);
     },
     [](const Scene& s, size_t) {
         return s.camera.view.empty() ? "" : toml_text(std::string_view(s.camera.view));
     }},
    {"camera.motion", "a string", "", R"("fixed")",
     "fixed, or co-precessing: turning about L with the herpolhode's mean advance, so that every "
     "polhode period looks like the last; default fixed",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.motion = g.one_of(camera_motions); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.camera.motion)); },
     camera_motions},
    {"camera.projection", "a string", "", R"("orthographic")",
     "perspective, or orthographic: along parallel lines, so that what is parallel stays so and "
     "equal lengths are equal wherever they lie; default perspective",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.projection = g.one_of(camera_projections());
     },
     [](const Scene& s, size_t) {
         const std::string& projection = s.camera.projection;
         return projection == "perspective" ? "" : toml_text(std::string_view(projection));
     },
     camera_projections()},

    // How the construction lies in the picture.
    {"construction.plane", "a string", "", R"("above")",
     "below: the body rolls on the invariable plane, L and ω point down to it; above: L and ω "
     "point "
     "up to the plane, which is seen through; default below",
     [](const GivenValue& g, SceneDraft& d) { d.scene.construction.plane = g.one_of(plane_sides); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.construction.plane)); },
     plane_sides},
    {"construction.sweep", "a string", "", R"("axis")",
     "what the film runs through instead of the motion. axis: an axis n over all directions of the "
     "body at rest; energy: √(2T)/L from the least to the greatest that the body has; default none",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.construction.sweep = g.one_of(construction_sweeps);
     },
     [](const Scene& s, size_t) { return text_unless_empty(s.construction.sweep); },
     construction_sweeps},

    // Which part of the contact point's paths is shown.
    {"trail.polhode", "a string", "", R"("fading")",
     "whole, history (since the film began) or fading (what trail.length_s holds); default whole",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.polhode = g.one_of(trail_kinds); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.trail.polhode)); },
     trail_kinds},
    {"trail.herpolhode", "a string", "", R"("fading")",
     "whole (of the film), history or fading; default history",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.herpolhode = g.one_of(trail_kinds); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.trail.herpolhode)); },
     trail_kinds},
    {"trail.length_s", "a positive number", "s", "4.0",
     "length of a fading trail, in seconds of motion; default: one polhode period",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.length_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.trail.length_s); }},
    {"trail.direction_marks", "true or false", "", "true",
     "small chevrons along both paths, for the sense of the motion; default false",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.direction_marks = g.boolean(); },
     [](const Scene& s, size_t) { return toml_text(s.trail.direction_marks); }},
};

}  // namespace

std::span<const SceneKey> camera_keys() { return camera_rows; }

}  // namespace poinsot
