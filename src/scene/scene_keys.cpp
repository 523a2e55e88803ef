#include "scene/scene_keys.h"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "scene/camera_views.h"
#include "scene/easing.h"
#include "scene/frame_rate.h"
#include "scene/given_value.h"
#include "scene/loop_text.h"
#include "scene/scene_draft.h"
#include "scene/scene_error.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;
using Given = BodySpec::Given;

constexpr std::array<std::string_view, 5> torque_kinds{"none", "gravity", "constant_body",
                                                       "constant_space", "dissipation"};
constexpr std::array<std::string_view, 2> camera_motions{"fixed", "co-precessing"};
constexpr std::array<std::string_view, 3> trail_kinds{"whole", "history", "fading"};
constexpr int most_pixels = 16384;  // largest framebuffer
constexpr double most_film_s = 1e7;

// A second of the film.
double film_second(const GivenValue& given) { return given.number_between(0.0, most_film_s); }

// The name of a row of a table, which is refused at its own place if there is none.
template <typename Find>
std::string name_in_table(const GivenValue& given, Find find) {
    std::string name = given.text();
    try {
        find(name);
    } catch (const InputError& error) {
        throw SceneError(given.value().where, error.what());
    }
    return name;
}

std::string easing_name(const GivenValue& given) { return name_in_table(given, easing_named); }
std::string view_name(const GivenValue& given) { return name_in_table(given, camera_view_named); }

void read_loop(const GivenValue& given, SceneDraft& draft) {
    draft.scene.film.loop = given.text();
    if (draft.scene.film.loop == "period" || loop_ratio_of(draft.scene.film.loop)) return;
    given.refuse(fmt::format("\"{}\"", echo(draft.scene.film.loop)),
                 "give turns over periods, each 1 to 1000, as in \"5/3\", or \"period\"");
}

// fps as a number, or as a ratio in a string.
void read_fps(const GivenValue& given, SceneDraft& draft) {
    const bool as_text = given.value().type == TomlValue::Type::text;
    const auto rate = as_text ? rate_of_text(given.text()) : rate_of_decimal(given.number());
    if (!rate) {
        given.refuse(
            as_text ? fmt::format("\"{}\"", echo(given.text())) : fmt::format("{}", given.number()),
            "give video frames a second from 0.001 to 1000, as 30, 29.97 or "
            "\"30000/1001\"");
    }
    draft.scene.film.fps_numerator = rate->first;
    draft.scene.film.fps_denominator = rate->second;
}

// size as [width, height], or as "1920x1080".
void read_size(const GivenValue& given, SceneDraft& draft) {
    const TomlValue& value = given.value();
    std::array<std::int64_t, 2> size{};
    std::string written;
    if (value.type == TomlValue::Type::text) {
        written = echo(given.text());
        int used = 0;
        const std::string text = given.text();
        const bool digits = text.find_first_not_of("0123456789x") == std::string::npos;
        const int n = std::sscanf(text.c_str(), "%9ldx%9ld%n", &size[0], &size[1], &used);
        if (!digits || n != 2 || used != static_cast<int>(text.size())) {
            given.refuse(fmt::format("\"{}\"", written),
                         "give width and height in pixels, as in \"1920x1080\"");
        }
    } else {
        if (value.type != TomlValue::Type::array || value.items.size() != 2) given.refuse_type();
        for (size_t i = 0; i < 2; ++i) {
            if (value.items[i].type != TomlValue::Type::integer) given.refuse_type();
            size[i] = value.items[i].integer;
        }
        written = fmt::format("{}x{}", size[0], size[1]);
    }
    for (const std::int64_t n_pixels : size) {
        if (n_pixels < 1 || n_pixels > most_pixels) {
            given.refuse(written,
                         fmt::format("give a width and a height from 1 to {} pixels", most_pixels));
        }
    }
    draft.scene.film.width_px = static_cast<int>(size[0]);
    draft.scene.film.height_px = static_cast<int>(size[1]);
}

constexpr int most_cells = 64;  // columns or rows of a grid

int cell(const GivenValue& given, int least) { return given.integer_between(least, most_cells); }

std::vector<double> grid_sizes(const GivenValue& given) {
    std::vector<double> sizes = given.positive_numbers();
    if (sizes.empty() || sizes.size() > most_cells) {
        given.refuse(fmt::format("a list of {} numbers", sizes.size()),
                     fmt::format("give 1 to {} relative sizes", most_cells));
    }
    return sizes;
}

// Texts of values that only some scenes say.
std::string top_text(const Scene& scene, double TopStart::*angle) {
    return scene.start.top ? toml_text((*scene.start.top).*angle) : "";
}

template <typename Kind, typename Value>
std::string torque_text(const Scene& scene, Value Kind::*value) {
    const auto* torque = std::get_if<Kind>(&scene.torque);
    return torque != nullptr ? toml_text(torque->*value) : "";
}

template <typename Value>
std::string optional_text(const std::optional<Value>& value) {
    return value ? toml_text(*value) : "";
}

std::string text_unless_empty(const std::string& text) {
    return text.empty() ? "" : toml_text(std::string_view(text));
}

// The item that a value belongs to.
KeyframeSpec& keyframe(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.keyframes.at(given.item());
}
FadeSpec& fade(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.fades.at(given.item());
}

std::string attitude_text(const Scene& scene) {
    const Eigen::Quaterniond& q = scene.start.space_from_body;
    if (scene.start.top || q.coeffs() == Eigen::Quaterniond::Identity().coeffs()) return "";
    return toml_text(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
}

// What is read of the second method; the first key of it makes it.
MethodChoice& beside(SceneDraft& draft) {
    if (!draft.scene.beside) draft.scene.beside.emplace();
    return *draft.scene.beside;
}

template <typename Value>
std::string beside_text(const Scene& scene, std::optional<Value> MethodChoice::*value) {
    return scene.beside ? optional_text((*scene.beside).*value) : "";
}

constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double pi = 3.141592653589793;

const SceneKey table[] = {
    {"title", "a string", "", R"("Tennis racket")",
     "heading of the picture; default: the file's name",
     [](const GivenValue& g, SceneDraft& d) { d.scene.title = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.title)); }},
    {"caption", "a string", "", R"("I = (3, 2, 1) kg m²")", "text below the picture; default: none",
     [](const GivenValue& g, SceneDraft& d) { d.scene.caption = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.caption)); }},
    {"accuracy_px", "a number", "pixels", "0.1",
     "largest distance of anything drawn from the truth; default 0.1",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.accuracy_px = g.number_between(1e-6, 100.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.accuracy_px); }},
    {"theme", "a string", "", R"("light")", "colours and line styles, see `poinsot list themes`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.theme = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.theme)); }},
    {"show", "a list of strings", "", R"(["plane", "ellipsoid", "polhode"])",
     "elements drawn, see `poinsot list elements`; default: those that suit the motion",
     [](const GivenValue& g, SceneDraft& d) { d.scene.show = g.texts(); },
     [](const Scene& s, size_t) {
         return s.show.empty() ? "" : toml_text(std::span<const std::string>(s.show));
     }},

    // The body, in exactly one of six ways.
    {"body.moments_kg_m2", "three numbers", "kg m²", "[3.0, 2.0, 1.0]",
     "principal moments, in any order: the axes keep the order given",
     [](const GivenValue& g, SceneDraft& d) { d.moments_kg_m2 = g.positive_vector(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::moments ? toml_text(s.body.inertia.moments_kg_m2()) : "";
     }},
    {"body.tensor_kg_m2", "three rows of three numbers", "kg m²",
     "[[3.0, 0.1, 0.0], [0.1, 2.0, 0.0], [0.0, 0.0, 2.5]]",
     "the full symmetric inertia tensor about the centre of mass, in any body axes",
     [](const GivenValue& g, SceneDraft& d) { d.tensor_kg_m2 = g.matrix(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::tensor ? toml_text(s.body.tensor_kg_m2) : "";
     }},
    {"body.shape", "a string", "", R"("box")", "a uniform solid: box, ellipsoid, cylinder, …",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.shape = g.text(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::solid ? toml_text(std::string_view(s.body.shape)) : "";
     }},
    {"body.size_m", "a list of numbers", "m", "[0.3, 0.2, 0.1]",
     "the solid's sizes: a box's edges, an ellipsoid's half-axes, a cylinder's radius and height, "
     "…",
     [](const GivenValue& g, SceneDraft& d) { d.size_m = g.positive_numbers(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::solid ? toml_text(std::span<const double>(s.body.size_m))
                                             : "";
     }},
    {"body.mass_kg", "a number", "kg", "2.0",
     "mass of the solid, object or mesh; default for an object: that of its materials",
     [](const GivenValue& g, SceneDraft& d) { d.mass_kg = g.positive(); },
     [](const Scene& s, size_t) {
         const Given given = s.body.given;
         const bool says = given == Given::solid || given == Given::object ||
                           (given == Given::mesh && !s.body.density_kg_m3);
         return says ? toml_text(s.body.mass_kg) : "";
     }},
    {"body.object", "a string", "", R"("t-handle")", "a real thing, see `poinsot list objects`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.object = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.body.object); }},
    {"body.mesh", "a string", "", R"("wedge.obj")",
     "a closed surface, .obj or .stl, in the scene's folder: a solid of uniform density in its "
     "axes; the centre of mass is found",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.mesh = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.body.mesh); }},
    {"body.scale", "a number", "m", "0.001",
     "one unit of a mesh's lengths, or the factor on an object's; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.scale = g.number_between(1e-12, 1e12); },
     [](const Scene& s, size_t) { return s.body.scale == 1.0 ? "" : toml_text(s.body.scale); }},
    {"body.density_kg_m3", "a number", "kg/m³", "2700.0", "density of a mesh, instead of its mass",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.density_kg_m3 = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.body.density_kg_m3); }},
    {"body.allow_unphysical", "true or false", "", "true",
     "keep the mathematics where no real body has these moments; default false",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.allow_unphysical = g.boolean(); },
     [](const Scene& s, size_t) { return s.body.allow_unphysical ? toml_text(true) : ""; }},
    {"body.masses[].mass_kg", "a number", "kg", "1.0", "mass of one point",
     [](const GivenValue& g, SceneDraft& d) { d.masses.at(g.item()).mass_kg = g.positive(); },
     [](const Scene& s, size_t i) { return toml_text(s.body.masses_as_given.at(i).mass_kg); }},
    {"body.masses[].at_m", "three numbers", "m", "[0.5, 0.0, -0.25]",
     "its place in body axes, from any origin: the centre of mass is found",
     [](const GivenValue& g, SceneDraft& d) { d.masses.at(g.item()).at_m = g.vector(); },
     [](const Scene& s, size_t i) { return toml_text(s.body.masses_as_given.at(i).at_m); }},

    // What a body given by its moments or its tensor looks like.
    {"object.name", "a string", "", R"("toutatis")",
     "the object panel shows this thing, see `poinsot list objects`, in place of a box; its axes "
     "follow the order of the moments",
     [](const GivenValue& g, SceneDraft& d) { d.scene.object.name = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.object.name); }},
    {"object.mesh", "a string", "", R"("wedge.obj")",
     "the same from a closed surface in a file, .obj or .stl, in the scene's folder",
     [](const GivenValue& g, SceneDraft& d) { d.scene.object.mesh = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.object.mesh); }},

    // The state at t = 0, by ω or by the Euler angles of a top.
    {"start.omega_rad_s", "three numbers", "rad/s", "[0.01, 2.0, 0.01]",
     "angular velocity at t = 0, in body axes",
     [](const GivenValue& g, SceneDraft& d) { d.scene.start.omega_rad_s = g.vector(); },
     [](const Scene& s, size_t) { return s.start.top ? "" : toml_text(s.start.omega_rad_s); }},
    {"start.attitude", "four numbers w, x, y, z", "", "[0.5, 0.5, 0.5, 0.5]",
     "space_from_body at t = 0 as a quaternion; default: body and space axes coincide",
     [](const GivenValue& g, SceneDraft& d) { d.attitude = g.four_numbers(); },
     [](const Scene& s, size_t) { return attitude_text(s); }},
    {"start.attitude_matrix", "three rows of three numbers", "",
     "[[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]",
     "space_from_body at t = 0 as a rotation matrix",
     [](const GivenValue& g, SceneDraft& d) { d.attitude_matrix = g.matrix(); },
     [](const Scene&, size_t) { return std::string(); }},  // written as start.attitude
    {"start.theta_rad", "a number", "rad", "0.7",
     "a top's tilt at t = 0: angle of e3 from the vertical, 0 to π (φ = ψ = 0)",
     [](const GivenValue& g, SceneDraft& d) { d.top.theta_rad = g.number_between(0.0, pi); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::theta_rad); }},
    {"start.theta_dot_rad_s", "a number", "rad/s", "0.0", "its rate; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.top.theta_dot_rad_s = g.number(); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::theta_dot_rad_s); }},
    {"start.phi_dot_rad_s", "a number", "rad/s", "0.35",
     "the top's rate of precession at t = 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.top.phi_dot_rad_s = g.number(); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::phi_dot_rad_s); }},
    {"start.omega3_rad_s", "a number", "rad/s", "8.0",
     "the top's spin: component of ω along e3; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.top.omega3_rad_s = g.number(); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::omega3_rad_s); }},

    // The torque, one kind with its own keys.
    {"torque.kind", "a string", "", R"("gravity")",
     "none, gravity, constant_body, constant_space or dissipation; default none",
     [](const GivenValue& g, SceneDraft& d) { d.torque_kind = g.one_of(torque_kinds); },
     [](const Scene& s, size_t) {
         return s.torque.index() == 0 ? "" : toml_text(torque_kinds.at(s.torque.index()));
     }},
    {"torque.mgl_N_m", "a number", "N m", "1.0",
     "gravity: weight times distance of the centre of mass from the fixed point",
     [](const GivenValue& g, SceneDraft& d) { d.gravity.mgl_N_m = g.number(); },
     [](const Scene& s, size_t) { return torque_text(s, &GravityTorque::mgl_N_m); }},
    {"torque.arm_body", "three numbers", "", "[0.0, 0.0, 1.0]",
     "gravity: direction from the fixed point to the centre of mass, body axes; default e3",
     [](const GivenValue& g, SceneDraft& d) { d.gravity.arm_body = g.vector(); },
     [](const Scene& s, size_t) { return torque_text(s, &GravityTorque::arm_body); }},
    {"torque.torque_body_N_m", "three numbers", "N m", "[0.0, 0.0, 0.1]",
     "constant_body: the torque in body axes",
     [](const GivenValue& g, SceneDraft& d) { d.constant_body.torque_body_N_m = g.vector(); },
     [](const Scene& s, size_t) { return torque_text(s, &ConstantBodyTorque::torque_body_N_m); }},
    {"torque.torque_space_N_m", "three numbers", "N m", "[0.0, 0.0, 0.1]",
     "constant_space: the torque in space axes",
     [](const GivenValue& g, SceneDraft& d) { d.constant_space.torque_space_N_m = g.vector(); },
     [](const Scene& s, size_t) { return torque_text(s, &ConstantSpaceTorque::torque_space_N_m); }},
    {"torque.rate_1_s", "a number", "1/s", "0.05",
     "dissipation: rate of internal friction, at which T decays while L is kept",
     [](const GivenValue& g, SceneDraft& d) { d.dissipation.rate_1_s = g.positive(); },
     [](const Scene& s, size_t) { return torque_text(s, &DissipationTorque::rate_1_s); }},

    // How the motion is computed.
    {"motion.method", "a string", "", R"("exact")",
     "how the motion is computed, see `poinsot list methods`; default exact",
     [](const GivenValue& g, SceneDraft& d) { d.scene.method.name = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.method.name)); }},
    {"motion.step_s", "a number", "s", "0.01",
     "step of a stepping method; default: chosen from accuracy_px",
     [](const GivenValue& g, SceneDraft& d) { d.scene.method.step_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.method.step_s); }},
    {"motion.tolerance", "a number", "", "1e-9",
     "relative error of an adaptive method; default: chosen from accuracy_px",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.method.tolerance = g.number_between(smallest, 1.0);
     },
     [](const Scene& s, size_t) { return optional_text(s.method.tolerance); }},
    {"motion.order", "an integer", "", "4", "order of a method that comes in several",
     [](const GivenValue& g, SceneDraft& d) { d.scene.method.order = g.integer_between(1, 20); },
     [](const Scene& s, size_t) { return optional_text(s.method.order); }},

    // The same motion by a second method, as a ghost.
    {"beside.method", "a string", "", R"("euler")",
     "a second method whose motion is drawn beside the first as a ghost; default: none",
     [](const GivenValue& g, SceneDraft& d) { beside(d).name = g.text(); },
     [](const Scene& s, size_t) {
         return s.beside ? toml_text(std::string_view(s.beside->name)) : "";
     }},
    {"beside.step_s", "a number", "s", "0.05", "its step; default: a 200th of the shortest turn",
     [](const GivenValue& g, SceneDraft& d) { beside(d).step_s = g.positive(); },
     [](const Scene& s, size_t) { return beside_text(s, &MethodChoice::step_s); }},
    {"beside.tolerance", "a number", "", "1e-4",
     "its relative error if it is adaptive; default 1e-9",
     [](const GivenValue& g, SceneDraft& d) {
         beside(d).tolerance = g.number_between(smallest, 1.0);
     },
     [](const Scene& s, size_t) { return beside_text(s, &MethodChoice::tolerance); }},
    {"beside.order", "an integer", "", "4", "its order if it comes in several",
     [](const GivenValue& g, SceneDraft& d) { beside(d).order = g.integer_between(1, 20); },
     [](const Scene& s, size_t) { return beside_text(s, &MethodChoice::order); }},

    // Which instants become video frames.
    {"film.start_s", "a number", "s", "0.0",
     "instant of the motion that the film begins with; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.start_s = g.number(); },
     [](const Scene& s, size_t) { return toml_text(s.film.start_s); }},
    {"film.duration_s", "a number", "s", "12.0",
     "stretch of the motion that is shown; default: ten seconds of film",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.duration_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.film.duration_s); }},
    {"film.length_s", "a number", "s", "20.0",
     "length of the film instead, in seconds of film: keyframes and fades count those",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.length_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.film.length_s); }},
    {"film.loop", "a string", "", R"("5/3")",
     "\"p/q\": start so that the herpolhode closes after q polhode periods with p turns about L, "
     "and show that; \"period\": one polhode period, for a co-precessing camera; default: no loop",
     read_loop,
     [](const Scene& s,
        size_t) { return s.film.loop.empty() ? "" : toml_text(std::string_view(s.film.loop)); }},
    {"film.loop_changes", "a string", "", R"("omega_2")",
     "component of start.omega_rad_s that the loop may change; default: the one that has to change "
     "least",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.film.loop_changes = g.one_of(loop_values());
     },
     [](const Scene& s, size_t) {
         return s.film.loop_changes.empty() ? "" : toml_text(std::string_view(s.film.loop_changes));
     }},
    {"film.fps", "a number or a ratio in a string", "1/s", R"("30000/1001")",
     "video frames a second; 29.97 means 30000/1001; default 30", read_fps,
     [](const Scene& s, size_t) {
         const std::string rate = text_of_rate({s.film.fps_numerator, s.film.fps_denominator});
         return s.film.fps_denominator == 1 ? rate : toml_text(std::string_view(rate));
     }},
    {"film.size", "two integers or a string", "pixels", "[1920, 1080]",
     "width and height of the picture, also \"1920x1080\"; default 1920x1080", read_size,
     [](const Scene& s, size_t) {
         return fmt::format("[{}, {}]", s.film.width_px, s.film.height_px);
     }},
    {"film.speed", "a number", "", "1.0", "seconds of motion a second of film; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.speed = g.positive(); },
     [](const Scene& s, size_t) { return toml_text(s.film.speed); }},
    {"film.quality", "a string", "", R"("lecture")",
     "draft, lecture, print or reference, see `poinsot list qualities`; default lecture",
     [](const GivenValue& g, SceneDraft& d) { d.scene.film.quality = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.film.quality)); }},

    // Where it is seen from; the picture's vertical is L.
    {"camera.azimuth_deg", "a number", "degrees", "-40.0",
     "direction of the camera about the vertical",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.azimuth_deg = g.number_between(-3600.0, 3600.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.azimuth_deg); }},
    {"camera.elevation_deg", "a number", "degrees", "14.0", "its height above the plane, -90 to 90",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.elevation_deg = g.number_between(-90.0, 90.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.elevation_deg); }},
    {"camera.distance", "a number", "largest half-axes", "5.2",
     "its distance from the target; more where the figure would not fit, unless target is given",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.distance = g.number_between(0.01, 10000.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.distance); }},
    {"camera.field_deg", "a number", "degrees", "28.0", "its vertical field of view, 0.1 to 150",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.camera.field_deg = g.number_between(0.1, 150.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.camera.field_deg); }},
    {"camera.target", "three numbers", "largest half-axes", "[0.0, 0.0, -0.2]",
     "the point it looks at, in picture axes; default: what look_at names",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.target = g.vector(); },
     [](const Scene& s, size_t) { return optional_text(s.camera.target); }},
    {"camera.look_at", "a string", "", R"("foot")",
     "middle of the construction, centre of the body, or foot of L on the plane; default middle",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.look_at = g.one_of(camera_aims()); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.camera.look_at)); }},
    {"camera.view", "a string", "", R"("contact")",
     "a view by name for all of the camera that is not said otherwise, see `poinsot list views`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.view = view_name(g); },
     [](const Scene& s, size_t) {
         return s.camera.view.empty() ? "" : toml_text(std::string_view(s.camera.view));
     }},
    {"camera.motion", "a string", "", R"("fixed")",
     "fixed, or co-precessing: turning about L with the herpolhode's mean advance, so that every "
     "polhode period looks like the last; default fixed",
     [](const GivenValue& g, SceneDraft& d) { d.scene.camera.motion = g.one_of(camera_motions); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.camera.motion)); }},

    // How much of the contact point's paths is shown.
    {"trail.polhode", "a string", "", R"("fading")",
     "whole, history (since the film began) or fading (what trail.length_s holds); default whole",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.polhode = g.one_of(trail_kinds); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.trail.polhode)); }},
    {"trail.herpolhode", "a string", "", R"("fading")",
     "whole (of the film), history or fading; default history",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.herpolhode = g.one_of(trail_kinds); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.trail.herpolhode)); }},
    {"trail.length_s", "a number", "s", "4.0",
     "length of a fading trail, in seconds of motion; default: one polhode period",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.length_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.trail.length_s); }},
    {"trail.direction_marks", "true or false", "", "true",
     "small chevrons along both paths, for the sense of the motion; default false",
     [](const GivenValue& g, SceneDraft& d) { d.scene.trail.direction_marks = g.boolean(); },
     [](const Scene& s, size_t) { return toml_text(s.trail.direction_marks); }},

    // The film told in its own seconds: the camera's ways and the motion's speed, …
    {"keyframes[].at_s", "a number", "s", "3.0", "second of the film at which this is reached",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).at_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.keyframes.at(i).at_s); }},
    {"keyframes[].easing", "a string", "", R"("smooth")",
     "how values go here from the keyframe before that says them, see `poinsot list easings`; "
     "default smooth",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).easing = easing_name(g); },
     [](const Scene& s, size_t i) {
         return toml_text(std::string_view(s.keyframes.at(i).easing));
     }},
    {"keyframes[].view", "a string", "", R"("front")",
     "a view by name for all of the camera that this keyframe does not say otherwise",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).view = view_name(g); },
     [](const Scene& s, size_t i) { return text_unless_empty(s.keyframes.at(i).view); }},
    {"keyframes[].azimuth_deg", "a number", "degrees", "30.0", "as in [camera]; it may go past 360",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).azimuth_deg = g.number_between(-36000.0, 36000.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).azimuth_deg); }},
    {"keyframes[].elevation_deg", "a number", "degrees", "35.0", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).elevation_deg = g.number_between(-90.0, 90.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).elevation_deg); }},
    {"keyframes[].distance", "a number", "largest half-axes", "4.0", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).distance = g.number_between(0.01, 10000.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).distance); }},
    {"keyframes[].field_deg", "a number", "degrees", "20.0", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).field_deg = g.number_between(0.1, 150.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).field_deg); }},
    {"keyframes[].target", "three numbers", "largest half-axes", "[0.0, 0.0, 0.5]",
     "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).target = g.vector(); },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).target); }},
    {"keyframes[].look_at", "a string", "", R"("centre")", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).look_at = g.one_of(camera_aims()); },
     [](const Scene& s, size_t i) { return text_unless_empty(s.keyframes.at(i).look_at); }},
    {"keyframes[].speed", "a number", "", "0.2",
     "seconds of motion a second of film; 0 stops the motion",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).speed = g.number_between(0.0, 1e12); },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).speed); }},

    // … what comes and goes, …
    {"fades[].at_s", "a number", "s", "2.0", "second of the film at which it begins",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).at_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.fades.at(i).at_s); }},
    {"fades[].over_s", "a number", "s", "1.0", "how long it takes, in seconds of film; default 1",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).over_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.fades.at(i).over_s); }},
    {"fades[].easing", "a string", "", R"("smooth")",
     "how it goes, see `poinsot list easings`; default smooth",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).easing = easing_name(g); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.fades.at(i).easing)); }},
    {"fades[].elements", "a list of strings", "", R"(["plane", "momentum"])",
     "elements, overlays or kinds of panels; those that come in are not seen before",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).elements = g.texts(); },
     [](const Scene& s, size_t i) {
         return toml_text(std::span<const std::string>(s.fades.at(i).elements));
     }},
    {"fades[].opacity", "a number", "", "1.0",
     "in the end, 0 to 1: 1 to come in (the default), 0 to go, less than 1 to grow pale",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).opacity = g.number_between(0.0, 1.0); },
     [](const Scene& s, size_t i) { return toml_text(s.fades.at(i).opacity); }},

    // … and what its sections are called.
    {"chapters[].at_s", "a number", "s", "0.0", "second of the film at which the section begins",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.chapters.at(g.item()).at_s = film_second(g);
     },
     [](const Scene& s, size_t i) { return toml_text(s.chapters.at(i).at_s); }},
    {"chapters[].title", "a string", "", R"("The invariable plane")", "its name",
     [](const GivenValue& g, SceneDraft& d) { d.scene.chapters.at(g.item()).title = g.text(); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.chapters.at(i).title)); }},

    // Several views of one motion, in the cells of a grid.
    {"grid.columns", "a list of numbers", "", "[2.0, 1.0]",
     "relative widths of the columns that panels stand in; default: equal ones",
     [](const GivenValue& g, SceneDraft& d) { d.scene.grid.columns = grid_sizes(g); },
     [](const Scene& s, size_t) { return toml_text(std::span<const double>(s.grid.columns)); }},
    {"grid.rows", "a list of numbers", "", "[1.0, 1.0]",
     "relative heights of the rows that panels stand in; default: equal ones",
     [](const GivenValue& g, SceneDraft& d) { d.scene.grid.rows = grid_sizes(g); },
     [](const Scene& s, size_t) { return toml_text(std::span<const double>(s.grid.rows)); }},
    {"panels[].kind", "a string", "", R"("space")",
     "what the panel shows, see `poinsot list panels`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).kind = g.text(); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.panels.at(i).kind)); }},
    {"panels[].column", "an integer", "", "0", "column of its upper left cell, from 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).column = cell(g, 0); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).column); }},
    {"panels[].row", "an integer", "", "0", "row of its upper left cell, from 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).row = cell(g, 0); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).row); }},
    {"panels[].columns", "an integer", "", "1", "number of columns that it spans; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).columns = cell(g, 1); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).columns); }},
    {"panels[].rows", "an integer", "", "1", "number of rows that it spans; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).rows = cell(g, 1); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).rows); }},
    {"panels[].quantity", "a string", "", R"("omega")",
     "what a plot shows against time; default: what suits the motion",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).quantity = g.text(); },
     [](const Scene& s, size_t i) {
         const std::string& quantity = s.panels.at(i).quantity;
         return quantity.empty() ? "" : toml_text(std::string_view(quantity));
     }},
    {"panels[].title", "a string", "", R"("Body axes")",
     "heading of the panel, \"\" for none; default: that of its kind",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).title = g.text(); },
     [](const Scene& s, size_t i) {
         const auto& title = s.panels.at(i).title;
         return title ? toml_text(std::string_view(*title)) : "";
     }},
};

const SceneArray arrays[] = {
    {"body.masses", [](SceneDraft& d) { d.masses.emplace_back(); },
     [](const Scene& s) { return s.body.masses_as_given.size(); }},
    {"panels", [](SceneDraft& d) { d.scene.panels.emplace_back(); },
     [](const Scene& s) { return s.panels.size(); }},
    {"keyframes", [](SceneDraft& d) { d.scene.keyframes.emplace_back(); },
     [](const Scene& s) { return s.keyframes.size(); }},
    {"fades", [](SceneDraft& d) { d.scene.fades.emplace_back(); },
     [](const Scene& s) { return s.fades.size(); }},
    {"chapters", [](SceneDraft& d) { d.scene.chapters.emplace_back(); },
     [](const Scene& s) { return s.chapters.size(); }},
};

}  // namespace

std::string SceneKey::expectation() const {
    return fmt::format("{}{}{}, as in {} = {}", type, unit.empty() ? "" : " in ", unit, leaf(),
                       example);
}

std::span<const SceneKey> scene_keys() { return table; }
std::span<const SceneArray> scene_arrays() { return arrays; }

}  // namespace poinsot
