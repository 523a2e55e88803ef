// A random scene with every key, as text.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "bodies/named_objects.h"
#include "mechanics/methods.h"
#include "mechanics/solids.h"
#include "scene/body_faces.h"
#include "scene/camera_views.h"
#include "scene/easing.h"
#include "scene/scene.h"
#include "scene/scene_keys.h"
#include "scene/style_keys.h"
#include "scene/toml/toml_text.h"

namespace poinsot::random_scenes_tests {

class Dice {
 public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    // From 0 to n − 1.
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    double between(double least, double most) {
        const double part = static_cast<double>(engine_() >> 11) * 0x1p-53;
        return std::clamp(least + part * (most - least), least, most);
    }
    // Any finite double, by its bits, including subnormal ones and −0.
    double any() {
        if (one_in(8)) return one_in(2) ? 0.0 : -0.0;
        const double value = std::bit_cast<double>(engine_());
        return std::isfinite(value) ? value : 0x1.fffffffffffffp1023;
    }
    double magnitude(int least_exponent, int most_exponent) {
        const int exponent = least_exponent + below(most_exponent - least_exponent + 1);
        return std::ldexp(between(1.0, 2.0), exponent);
    }
    template <typename List>
    auto one_of(const List& list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(std::size(list))))];
    }
    // Text that scenes may contain and TOML must preserve: quotes, backslashes, line ends, TOML
    // syntax, characters of two to four bytes, invisible characters.
    std::string text() {
        static const std::vector<std::string> parts{"a",         "Z",
                                                    "7",         " ",
                                                    "\"",        "\\",
                                                    "'",         "\n",
                                                    "\t",        "#",
                                                    "=",         "[",
                                                    "]",         "{",
                                                    "}",         ",",
                                                    ".",         "ω",
                                                    "₁",         "𝐋",
                                                    "\\u",       "\"\"\"",
                                                    "'''",       "\n\n",
                                                    "poinsot 1", "\xef\xbb\xbf",
                                                    "\u202e",    "\u200b",
                                                    "\uffff",    "\ufffe",
                                                    "\u00a0",    "\U0001fffe",
                                                    "[marks]\n", "a = 1\n"};
        std::string text;
        for (int n = below(8); n > 0; --n) text += one_of(parts);
        return text;
    }

 private:
    std::mt19937_64 engine_;
};

// A scene as text, key by key. Tables may be in any order, as users write them.
class Text {
 public:
    void set(const std::string& path, const std::string& value) { values_[path] = value; }
    void set_text(const std::string& path, const std::string& value) {
        set(path, toml_text(std::string_view(value)));
    }
    void set_number(const std::string& path, double value) { set(path, toml_text(value)); }
    bool has(const std::string& path) const { return values_.contains(path); }
    // "panels[2].camera.view" → its value as TOML.
    const std::map<std::string, std::string>& values() const { return values_; }

    std::string toml() const {
        std::string top;
        std::map<std::string, std::string> tables;  // "panels[0]", "panels[0].camera", "body"
        for (const auto& [path, value] : values_) {
            const std::size_t dot = path.rfind('.');
            const std::string table = dot == std::string::npos ? "" : path.substr(0, dot);
            (table.empty() ? top : tables[table]) +=
                fmt::format("{} = {}\n", path.substr(dot + 1), value);
        }
        // An item without own keys precedes its tables.
        for (const auto& [path, value] : values_)
            if (const std::size_t end = path.find(']'); end != std::string::npos)
                tables[path.substr(0, end + 1)];
        for (const auto& [table, lines] : tables) {
            std::string header;
            bool inside = false;
            for (const char c : table) {
                inside = c == '[' || (inside && c != ']');
                if (!inside && c != ']') header += c;
            }
            const bool is_item = table.ends_with(']');
            top += fmt::format("{}{}{}\n{}", is_item ? "[[" : "[", header, is_item ? "]]" : "]",
                               lines);
        }
        return top;
    }

 private:
    std::map<std::string, std::string> values_;
};

inline std::string vector_text(double x, double y, double z) {
    return toml_text(Eigen::Vector3d(x, y, z));
}

inline std::string any_vector(Dice& dice) {
    const double x = dice.any(), y = dice.any();
    return vector_text(x, y, dice.any());
}

inline std::string list_text(std::vector<std::string> texts) {
    return toml_text(std::span<const std::string>(texts));
}

inline std::string some_texts(Dice& dice) {
    std::vector<std::string> texts{dice.text()};
    for (int n = dice.below(3); n > 0; --n) texts.push_back(dice.text());
    return list_text(texts);
}

inline std::string a_target(Dice& dice) {
    const double x = dice.between(-1e4, 1e4), y = dice.one_in(4) ? -0.0 : dice.between(-1.0, 1.0);
    return vector_text(x, y, dice.between(-1e-4, 1e-4));
}

inline std::string name_of_view(Dice& dice) {
    return std::string(dice.one_of(camera_views()).name);
}
inline std::string name_of_easing(Dice& dice) { return std::string(dice.one_of(easings()).name); }

// A file has either labels = … or [labels].
inline void write_names(Dice& dice, Text& text) {
    if (dice.one_in(3))
        text.set("names", toml_text(dice.one_in(2)));
    else if (dice.one_in(2))
        text.set("names", "[" + toml_text(dice.one_of(named_things)) + "]");
    for (const std::string_view name : named_things)
        if (dice.one_in(12)) text.set_text(fmt::format("symbols.{}", name), dice.text());
    if (dice.one_in(2)) return text.set("labels", toml_text(dice.one_in(2)));
    const auto move = [&](std::string_view name) {
        const double x = dice.between(-1e3, 1e3), y = dice.between(-1e3, 1e3);
        if (dice.one_in(4))
            text.set(fmt::format("labels.{}.offset_pt", name),
                     fmt::format("[{}, {}]", toml_text(x), toml_text(y)));
    };
    for (const std::string_view name : named_things) move(name);
    for (const std::string_view name : named_quantities) move(name);
}

inline void write_picture(Dice& dice, Text& text) {
    for (const char* key : {"title", "caption", "symbols.omega", "symbols.momentum", "symbols.rho",
                            "symbols.e1", "symbols.e2", "symbols.e3"})
        if (dice.one_in(2)) text.set_text(key, dice.text());
    for (const char* key : {"show", "unlabelled"})
        if (dice.one_in(2)) text.set(key, some_texts(dice));
    for (const char* key : {"clock", "overlays", "panel_letters"})
        if (dice.one_in(2)) text.set(key, toml_text(dice.one_in(2)));
    write_names(dice, text);
    if (dice.one_in(2)) text.set_number("accuracy_px", dice.between(1e-6, 100.0));
    if (dice.one_in(2)) text.set_text("theme", "dark");
    if (dice.one_in(2)) text.set_number("type_scale", dice.between(0.25, 8.0));
    constexpr std::array units{"rpm", "deg", "g cm²", "mN m", "cm"};
    if (dice.one_in(2)) text.set("units", list_text({dice.one_of(units)}));
}

// The rows whose type gives the values: names, true or false, and numbers between bounds are
// random.
inline void write_rows_with_names(Dice& dice, Text& text) {
    for (const SceneKey& key : scene_keys()) {
        const bool in_array = key.path.find("[]") != std::string_view::npos;
        if (key.type.names.empty() || key.type.size || in_array || key.path == "torque.kind" ||
            key.path == "object.marked_face" || key.path == "camera.look_at" ||
            key.path == "film.loop_changes" || key.path == "camera.motion")
            continue;
        if (dice.one_in(2))
            text.set_text(std::string(key.path), std::string(dice.one_of(key.type.names)));
    }
}

inline void write_body(Dice& dice, Text& text) {
    const int way = dice.below(6);
    const double scale = dice.magnitude(-40, 40);
    if (dice.one_in(3)) text.set("body.allow_unphysical", "true");
    const bool is_free = text.has("body.allow_unphysical");
    if (way == 0) {
        const double I1 = scale * dice.between(1.0, 2.0);
        const double I2 = dice.one_in(2) ? I1 : scale * dice.between(1.0, 2.0);
        text.set("body.moments_kg_m2",
                 vector_text(I1, I2, scale * dice.between(1.0, is_free ? 9.0 : 2.0)));
    } else if (way == 1) {
        Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
        for (int i = 0; i < 3; ++i) {
            tensor(i, i) = scale * dice.between(2.0, 2.5);
            for (int j = 0; j < i; ++j)
                tensor(i, j) = tensor(j, i) = dice.one_in(4) ? (dice.one_in(2) ? -0.0 : 5e-324)
                                                             : scale * dice.between(-0.1, 0.1);
        }
        text.set("body.tensor_kg_m2", toml_text(tensor));
    } else if (way == 2) {
        const Solid& solid = dice.one_of(solids());
        std::vector<double> sizes;
        // Ascending, because a tube's outer radius is its second size.
        for (int k = 0; k < solid.n_sizes; ++k) sizes.push_back(dice.between(0.1, 0.2) * (k + 1));
        if (solid.name == "torus") std::reverse(sizes.begin(), sizes.end());
        text.set_text("body.shape", std::string(solid.name));
        text.set("body.size_m", toml_text(std::span<const double>(sizes)));
        text.set_number("body.mass_kg", scale);
    } else if (way == 3) {
        const std::array<Eigen::Vector3d, 4> corners{
            Eigen::Vector3d{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {-1.0, -1.0, -1.0}};
        for (int k = 0; k < 4; ++k) {
            const Eigen::Vector3d corner = corners[static_cast<std::size_t>(k)];
            text.set_number(fmt::format("body.masses[{}].mass_kg", k), dice.between(0.5, 2.0));
            const double x = corner.x() + dice.between(-0.3, 0.3);
            text.set(fmt::format("body.masses[{}].at_m", k),
                     vector_text(x, corner.y() + dice.between(-0.3, 0.3), corner.z()));
        }
    } else if (way == 4) {
        // The other objects have too many triangles for a thousand scenes.
        constexpr std::array few_triangles{"box", "book", "coin", "t-handle"};
        text.set_text("body.object", dice.one_of(few_triangles));
        if (dice.one_in(2)) text.set_number("body.mass_kg", scale);
        if (dice.one_in(2)) text.set_number("body.scale", dice.magnitude(-30, 30));
    } else {
        text.set_text("body.mesh", "wedge.obj");
        text.set_number(dice.one_in(2) ? "body.mass_kg" : "body.density_kg_m3", scale);
        if (dice.one_in(2)) text.set_number("body.scale", dice.magnitude(-30, 30));
    }
    if (way < 2 && dice.one_in(2)) {
        if (dice.one_in(2))
            text.set_text("object.name", "book");
        else
            text.set_text("object.mesh", "wedge.obj");
    }
    if (way > 1 || text.has("object.mesh") || text.has("object.name")) return;
    // A box has flat faces.
    const int face = dice.below(6);
    if (dice.one_in(2)) text.set_text("object.marked_face", std::string(body_faces()[face]));
    for (int k = 0, n = dice.below(3); k < n; ++k) {
        const std::string item = fmt::format("object.pictures[{}].", k);
        const int own = (face + 1 + k) % 6;
        text.set_text(item + "face", std::string(body_faces()[own]));
        text.set_text(item + "file", "cover.png");
        if (dice.one_in(2)) text.set_text(item + "up", std::string(body_faces()[(own + 2) % 6]));
    }
}

// T, and L or the distance for an L²/2T that is the mean of the moments, which a body always has.
inline void write_conserved(Dice& dice, Text& text) {
    const auto moments = text.values().find("body.moments_kg_m2");
    if (moments == text.values().end()) return;
    double mean = 0.0;
    std::istringstream numbers(moments->second.substr(1));
    for (std::string number; std::getline(numbers, number, ',');) mean += std::stod(number) / 3.0;
    const double energy_J = dice.between(0.5, 2.0);
    text.set_number("start.energy_J", energy_J);
    if (dice.one_in(2))
        text.set_number("start.momentum_kg_m2_s", std::sqrt(2.0 * energy_J * mean));
    else
        text.set_number("start.plane_distance", 1.0 / std::sqrt(mean));
}

inline void write_motion(Dice& dice, Text& text) {
    if (dice.one_in(6)) text.set_text("measured.file", "gyro.csv");
    if (dice.one_in(3)) {
        text.set_number("start.theta_rad", dice.between(0.0, 3.14));
        for (const char* key :
             {"start.theta_dot_rad_s", "start.phi_dot_rad_s", "start.omega3_rad_s"})
            if (dice.one_in(2)) text.set_number(key, dice.any());
    } else {
        const bool any = dice.one_in(2);
        const double x = dice.between(-3.0, 3.0), y = dice.between(-3.0, 3.0);
        text.set("start.omega_rad_s",
                 any ? any_vector(dice) : vector_text(x, y, dice.between(0.1, 3.0)));
        if (!any && dice.one_in(3)) write_conserved(dice, text);
        if (dice.one_in(3)) {
            Eigen::Vector4d q;
            for (double& entry : q.reshaped())
                entry = dice.one_in(3) ? (dice.one_in(2) ? 0.0 : -0.0) : dice.between(-1.0, 1.0);
            text.set("start.attitude", toml_text(q));
        } else if (dice.one_in(2)) {
            const Eigen::Quaterniond q(dice.between(0.1, 1.0), dice.between(-1.0, 1.0),
                                       dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
            text.set("start.attitude_matrix",
                     toml_text(Eigen::Matrix3d(q.normalized().toRotationMatrix())));
        }
    }
    const std::string kind(dice.one_of(find_scene_key("torque.kind")->type.names));
    text.set_text("torque.kind", kind);
    if (kind == "gravity") {
        text.set_number("torque.mgl_N_m", dice.any());
        if (dice.one_in(2))
            text.set("torque.arm_body", vector_text(dice.between(-1.0, 1.0), -0.0, 0.6));
    } else if (kind == "constant_body") {
        text.set("torque.torque_body_N_m", any_vector(dice));
    } else if (kind == "constant_space") {
        text.set("torque.torque_space_N_m", any_vector(dice));
    } else if (kind == "dissipation") {
        if (dice.one_in(2))
            text.set_number("torque.rate_1_s", dice.magnitude(-40, 40));
        else
            text.set_number("torque.half_life_s", dice.between(0.1, 100.0));
    } else if (kind == "drag") {
        const auto rates = [&dice] {
            const double x = dice.magnitude(-40, 40), y = dice.between(0.0, 1.0);
            return vector_text(x, y, 0.0);
        };
        const bool both = dice.one_in(3), is_linear = dice.one_in(2);
        if (both || is_linear) text.set("torque.linear_1_s", rates());
        if (both || !is_linear) text.set("torque.quadratic_1_rad", rates());
        if (dice.one_in(2)) text.set_number("torque.growth_1_s", dice.any());
    }
    for (const std::string table : {"motion", "beside"}) {
        const Method& method = dice.one_of(methods());
        if (dice.one_in(3) && kind == "none") continue;
        text.set_text(table + ".method", std::string(method.name));
        if (method.takes_step && dice.one_in(2))
            text.set_number(table + ".step_s", dice.magnitude(-40, 40));
        if (method.takes_tolerance && dice.one_in(2))
            text.set_number(table + ".tolerance", dice.between(1e-14, 1e-3));
        if (!method.orders.empty() && dice.one_in(2))
            text.set(table + ".order", toml_text(dice.one_of(method.orders)));
    }
}

inline void write_film(Dice& dice, Text& text) {
    if (dice.one_in(2)) text.set_number("film.start_s", dice.between(-1e3, 1e3));
    const int way = dice.below(3);
    if (way > 0)
        text.set_number(way == 1 ? "film.duration_s" : "film.length_s", dice.between(8.0, 20.0));
    if (dice.one_in(2)) text.set_number("film.still_s", dice.any());
    if (dice.one_in(2)) text.set_number("film.speed", dice.between(0.5, 2.0));
    constexpr std::array rates{"24", "25", "\"30000/1001\"", "\"1/7\"", "50"};
    if (dice.one_in(2)) text.set("film.fps", dice.one_of(rates));
    if (dice.one_in(2))
        text.set("film.size",
                 fmt::format("[{}, {}]", 1 + dice.below(16384), 1 + dice.below(16384)));
    if (dice.one_in(2)) text.set_text("film.quality", "draft");
    // Loops and turning cameras need a free body.
    if (text.values().at("torque.kind") != "\"none\"") return;
    const int loop = dice.below(4);
    if (loop == 1)
        text.set_text("film.loop",
                      fmt::format("{}/{}", 1 + dice.below(1000), 1 + dice.below(1000)));
    if (loop == 1 && dice.one_in(2)) text.set_text("film.loop_changes", "omega_body_2");
    if (loop == 2) text.set_text("film.loop", "period");
    if (loop >= 2) text.set_text("camera.motion", "co-precessing");
}

// The camera of [camera], of a panel or of a keyframe.
inline void write_camera(Dice& dice, const std::string& table, Text& text) {
    if (dice.one_in(2)) text.set_number(table + "azimuth_deg", dice.between(-3600.0, 3600.0));
    if (dice.one_in(2)) text.set_number(table + "elevation_deg", dice.between(-90.0, 90.0));
    if (dice.one_in(2)) text.set_number(table + "distance", dice.between(0.01, 10000.0));
    if (dice.one_in(2)) text.set_number(table + "field_deg", dice.between(0.1, 150.0));
    if (dice.one_in(2)) text.set_text(table + "view", name_of_view(dice));
    const int aim = dice.below(3);
    if (aim == 1) text.set(table + "target", a_target(dice));
    if (aim == 2) text.set_text(table + "look_at", std::string(dice.one_of(camera_aims())));
}

inline void write_cameras_and_panels(Dice& dice, Text& text) {
    write_camera(dice, "camera.", text);
    text.set_number("camera.roll_deg", 30.0);
    if (dice.one_in(2)) text.set_number("trail.length_s", dice.magnitude(-40, 40));
    if (dice.one_in(2)) text.set("trail.direction_marks", "true");
    if (dice.one_in(2)) text.set("trail.ticks", "true");

    const int n_panels = dice.below(4);
    for (int k = 0; k < n_panels; ++k) {
        const std::string item = fmt::format("panels[{}].", k);
        text.set(item + "row", toml_text(2 * k));
        if (dice.one_in(2)) text.set(item + "column", toml_text(dice.below(65)));
        if (dice.one_in(2)) text.set(item + "columns", toml_text(1 + dice.below(64)));
        if (dice.one_in(2)) text.set(item + "rows", "2");
        if (dice.one_in(2)) text.set(item + "curves", toml_text(dice.below(41)));
        for (const char* key : {"kind", "quantity", "title"})
            if (dice.one_in(2)) text.set_text(item + key, dice.text());
        if (dice.one_in(2)) write_camera(dice, item + "camera.", text);
        if (dice.one_in(3)) text.set_text(item + "camera.projection", "orthographic");
        if (k == 1) text.set_text(item + "inset", "bottom left");
    }
    for (const char* key : {"grid.columns", "grid.rows"}) {
        if (!dice.one_in(4)) continue;
        std::vector<double> sizes;
        for (int n = 1 + dice.below(64); n > 0; --n) sizes.push_back(dice.magnitude(-1074, 1023));
        text.set(key, toml_text(std::span<const double>(sizes)));
    }
    for (int k = 0, n = dice.below(3); k < n; ++k) {
        const std::string item = fmt::format("marks[{}].", k);
        text.set(item + "at", a_target(dice));
        if (dice.one_in(2)) text.set_text(item + "on", std::string(dice.one_of(mark_places())));
        if (dice.one_in(2)) text.set_text(item + "name", dice.text());
        if (dice.one_in(2)) text.set(item + "trail", "true");
        if (dice.one_in(2))
            text.set_text(item + "colour",
                          dice.one_in(4) ? "ghost" : fmt::format("#{:06x}", dice.below(1 << 24)));
    }
}

// Within eight seconds, the length of the shortest film.
inline void write_what_is_told(Dice& dice, Text& text) {
    const int n_panels = static_cast<int>(
        std::count_if(text.values().begin(), text.values().end(), [](const auto& value) {
            return value.first.starts_with("panels[") && value.first.ends_with("].row");
        }));
    double at_s = 0.0;
    for (int k = 0, n = dice.below(4); k < n; ++k) {
        const std::string item = fmt::format("keyframes[{}].", k);
        text.set_number(item + "at_s", at_s += dice.between(0.01, 1.0));
        if (dice.one_in(2)) text.set_text(item + "easing", name_of_easing(dice));
        write_camera(dice, item, text);
        if (n_panels > 0 && dice.one_in(2))
            text.set(item + "panel", toml_text(dice.below(n_panels)));
        text.set_number(item + "speed", dice.between(0.5, 2.0));
    }
    at_s = 0.0;
    for (int k = 0, n = dice.below(3); k < n; ++k) {
        const std::string item = fmt::format("fades[{}].", k);
        text.set_number(item + "at_s", at_s += dice.between(0.5, 1.0));
        if (dice.one_in(2)) text.set_number(item + "over_s", dice.between(0.0, 0.5));
        if (dice.one_in(2)) text.set_text(item + "easing", name_of_easing(dice));
        if (dice.one_in(2)) text.set_number(item + "opacity", dice.between(0.0, 1.0));
        text.set(item + "elements", some_texts(dice));
    }
    at_s = -0.0;
    for (int k = 0, n = dice.below(3); k < n; ++k) {
        const std::string item = fmt::format("captions[{}].", k);
        text.set_number(item + "at_s", at_s);
        at_s += dice.between(0.5, 1.0);
        if (dice.one_in(2)) text.set_number(item + "over_s", dice.between(0.1, 0.5));
        text.set_text(item + "text", dice.text());
        if (dice.one_in(2)) text.set_text(item + "place", "top");
    }
    at_s = -0.0;
    for (int k = 0, n = dice.below(3); k < n; ++k) {
        const std::string item = fmt::format("chapters[{}].", k);
        text.set_number(item + "at_s", at_s);
        at_s += dice.between(0.5, 1.0);
        text.set_text(item + "title", dice.text());
    }
    at_s = -0.0;
    // Two stops in a film of less than 1 frame a second may be closer than a frame.
    for (int k = 0, n = dice.below(2); k < n; ++k) {
        const std::string item = fmt::format("stops[{}].", k);
        at_s += dice.between(0.5, 1.0);
        text.set_number(item + "at_s", at_s);
        if (dice.one_in(2)) text.set_text(item + "title", dice.text());
        if (dice.one_in(2)) text.set_number(item + "loop_s", dice.between(0.01, 0.5));
        if (dice.one_in(2)) {
            text.set_text(item + "note", dice.text());
            text.set_number(item + "planned_s", 60.0 * at_s);
        }
    }
    if (dice.one_in(3)) text.set("page.elements", some_texts(dice));
    if (dice.one_in(3)) {
        text.set("page.next", R"("the next.html")");
        text.set_number("page.planned_s", 60.0 * at_s);
    }
    if (dice.one_in(3))
        text.set("page.controls", R"(["film.speed", "start.omega_rad_s[2]", "camera.motion"])");
}

inline void write_style(Dice& dice, Text& text) {
    for (const StyleRole& role : style_roles()) {
        if (!dice.one_in(3)) continue;
        std::vector<std::string> words;
        if (dice.one_in(2)) words.push_back(fmt::format("#{:06x}", dice.below(1 << 24)));
        if (role.kind == StyleKind::line && dice.one_in(2))
            words.push_back(fmt::format("{}", dice.between(0.1, 10.0)));
        if (role.kind == StyleKind::surface && dice.one_in(2))
            words.push_back(fmt::format("{}%", dice.between(0.0, 100.0)));
        if (role.kind == StyleKind::line && dice.one_in(2))
            words.emplace_back(dice.one_of(line_kinds()));
        if (words.empty()) words.emplace_back("#012345");
        std::string look;
        for (const std::string& word : words) look += (look.empty() ? "" : " ") + word;
        text.set_text(fmt::format("style.{}", role.name), look);
    }
    for (const char* key :
         {"title_scale", "caption_scale", "heading_scale", "label_scale", "chart_scale"})
        if (dice.one_in(2)) text.set_number(fmt::format("style.{}", key), dice.between(0.25, 8.0));
}

inline Text random_scene(Dice& dice) {
    Text text;
    write_picture(dice, text);
    write_rows_with_names(dice, text);
    write_body(dice, text);
    write_motion(dice, text);
    write_film(dice, text);
    write_cameras_and_panels(dice, text);
    write_what_is_told(dice, text);
    write_style(dice, text);
    return text;
}

}  // namespace poinsot::random_scenes_tests
