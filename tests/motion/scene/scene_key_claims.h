// For the scene keys whose value the scene holds in another form, or under several members: a scene
// that gives the key, and a check of the scene.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera_views.h"
#include "scene/style_keys.h"
#include "scene_text.h"

namespace poinsot::scene_keys_tests {

inline const std::string gravity = "[torque]\nkind = \"gravity\"\nmgl_N_m = 2.5\n";
inline const std::string a_top =
    "[body]\nmoments_kg_m2 = [1.0, 1.0, 0.5]\n[start]\ntheta_rad = 0.5\n";
inline const std::string three_masses =
    "[[body.masses]]\nmass_kg = 2.5\nat_m = [1.0, 0.5, 0.25]\n"
    "[[body.masses]]\nmass_kg = 1.0\nat_m = [0.0, 1.0, 0.0]\n"
    "[[body.masses]]\nmass_kg = 1.0\nat_m = [0.0, 0.0, 1.0]\n";

inline const std::string a_wedge =
    "[body]\nmesh = \"wedge.obj\"\nscale = 2\ndensity_kg_m3 = 3\n" + a_start;

inline const std::string a_picture = "[[object.pictures]]\nface = \"-e3\"\nfile = \"cover.png\"\n";

// A scene that gives the key, and a check of the scene's value.
struct Claim {
    std::string text;
    std::function<bool(const Scene&)> holds;
};

inline std::string with(const std::string& table, const std::string& line) {
    return a_scene + (table.empty() ? "" : "[" + table + "]\n") + line + "\n";
}

// By T = 2 J, with moments 3, 2, 1.
inline const std::string conserved = a_body + "[start]\nenergy_J = 2.0\n";
inline Eigen::Vector3d momentum(const Scene& s) {
    return s.body.inertia.matrix_body() * s.start.omega_rad_s;
}
inline double energy_J(const Scene& s) { return 0.5 * momentum(s).dot(s.start.omega_rad_s); }

inline const Torque& torque(const Scene& s) { return s.torque; }

using Claims = std::map<std::string, Claim>;
inline const Claims claims_of_rows{
    {"marks[].colour",
     {a_scene + "[[marks]]\nat = [1, 2, -3]\ncolour = \"#ff0033\"\n",
      [](const Scene& s) {
          return s.marks.at(0).srgb == std::array<double, 3>{1.0, 0.0, 0.2};
      }}},
    {"object.pictures[].file",
     {a_scene + a_picture,
      [](const Scene& s) { return s.object.pictures.at(0).image.width() == 3; }}},
    {"body.moments_kg_m2",
     {a_scene,
      [](const Scene& s) {
          return s.body.given == BodySpec::Given::moments &&
                 s.body.inertia.moments_kg_m2() == Eigen::Vector3d(3.0, 2.0, 1.0);
      }}},
    {"body.tensor_kg_m2",
     {"[body]\ntensor_kg_m2 = [[2, 0.5, 0], [0.5, 2, 0], [0, 0, 3]]\n" + a_start,
      [](const Scene& s) {
          // Eigenvalues of [[2, ½], [½, 2]] are 2 ± ½; measured 4e-16
          const Eigen::Vector3d moments = s.body.inertia.moments_kg_m2();
          return s.body.given == BodySpec::Given::tensor &&
                 std::abs(moments.prod() - 11.25) < 1e-14 && s.body.tensor_kg_m2(0, 1) == 0.5;
      }}},
    {"body.shape",
     {"[body]\nshape = \"box\"\nsize_m = [2, 2, 2]\nmass_kg = 6\n" + a_start,
      [](const Scene& s) {
          return s.body.given == BodySpec::Given::solid && s.body.shape == "box";
      }}},
    {"body.size_m",
     {"[body]\nshape = \"box\"\nsize_m = [2, 2, 2]\nmass_kg = 6\n" + a_start,
      [](const Scene& s) {
          return s.body.size_m == std::vector<double>{2.0, 2.0, 2.0};
      }}},
    {"body.mass_kg",
     {"[body]\nshape = \"box\"\nsize_m = [2, 2, 2]\nmass_kg = 6\n" + a_start,
      [](const Scene& s) {
          // m(a² + b²)/12 = 4
          return s.body.mass_kg == 6.0 &&
                 (s.body.inertia.moments_kg_m2() - Eigen::Vector3d::Constant(4.0)).norm() < 1e-14;
      }}},
    {"body.object",
     {"[body]\nobject = \"book\"\n" + a_start,
      [](const Scene& s) {
          return s.body.given == BodySpec::Given::object && s.body.object == "book" &&
                 s.surfaces.size() > 1;
      }}},
    {"body.mesh",
     {a_wedge,
      [](const Scene& s) {
          return s.body.given == BodySpec::Given::mesh && s.body.mesh == "wedge.obj" &&
                 s.surfaces.size() == 1;
      }}},
    {"body.scale", {a_wedge, [](const Scene& s) { return s.body.scale == 2.0; }}},
    {"body.density_kg_m3",
     {a_wedge,
      [](const Scene& s) {
          // Half a cube of 2 m.
          return s.body.density_kg_m3 == 3.0 && std::abs(s.body.mass_kg - 12.0) < 1e-13;
      }}},
    {"page.next",
     {with("page", "next = \"the top.html\""),
      [](const Scene& s) { return s.page.next == "the top.html"; }}},
    {"object.name",
     {with("object", "name = \"coin\""),
      [](const Scene& s) { return s.object.name == "coin" && s.surfaces.size() > 1; }}},
    {"object.mesh",
     {with("object", "mesh = \"wedge.obj\""),
      [](const Scene& s) { return s.object.mesh == "wedge.obj" && s.surfaces.size() == 1; }}},
    {"body.allow_unphysical",
     {"[body]\nmoments_kg_m2 = [1, 1, 5]\nallow_unphysical = true\n" + a_start,
      [](const Scene& s) { return s.body.allow_unphysical; }}},
    {"body.masses[].mass_kg",
     {three_masses + a_start,
      [](const Scene& s) {
          return s.body.given == BodySpec::Given::masses &&
                 s.body.masses_as_given.at(0).mass_kg == 2.5 && s.body.mass_kg == 4.5;
      }}},
    {"body.masses[].at_m",
     {three_masses + a_start,
      [](const Scene& s) {
          // Σ m r = (2.5, 2.25, 1.625)
          const Eigen::Vector3d centre(2.5 / 4.5, 2.25 / 4.5, 1.625 / 4.5);
          return (s.body.centre_of_mass_m_body - centre).norm() < 1e-15 &&
                 (s.body.masses.at(0).at_m + centre - Eigen::Vector3d(1.0, 0.5, 0.25)).norm() <
                     1e-15;
      }}},
    {"start.omega_rad_s",
     {a_scene,
      [](const Scene& s) { return s.start.omega_rad_s == Eigen::Vector3d(0.5, 2.0, 0.25); }}},
    {"start.energy_J",
     {conserved + "momentum_kg_m2_s = 2.5\n",
      [](const Scene& s) { return std::abs(energy_J(s) - 2.0) < 1e-15; }}},
    {"start.momentum_kg_m2_s",
     {conserved + "momentum_kg_m2_s = 2.5\n",
      [](const Scene& s) { return std::abs(momentum(s).norm() - 2.5) < 1e-15; }}},
    {"start.plane_distance",
     {conserved + "plane_distance = 0.75\nomega_rad_s = [-1, 2, 3]\n",
      [](const Scene& s) {
          return std::abs(std::sqrt(2.0 * energy_J(s)) / momentum(s).norm() - 0.75) < 1e-15 &&
                 std::abs(s.start.omega_rad_s[0] / s.start.omega_rad_s[1] + 0.5) < 1e-15;
      }}},
    {"start.attitude",
     {a_scene + "attitude = [0.5, 0.5, 0.5, -0.5]\n",
      [](const Scene& s) {
          return s.start.space_from_body.coeffs() ==
                 Eigen::Quaterniond(0.5, 0.5, 0.5, -0.5).coeffs();
      }}},
    {"start.attitude_matrix",
     {a_scene + "attitude_matrix = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]\n",
      [](const Scene& s) {
          // e1 goes to e2; measured 2e-16
          return (s.start.space_from_body * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY())
                     .norm() < 1e-15;
      }}},
    {"start.theta_rad",
     {a_top, [](const Scene& s) { return s.start.top && s.start.top->theta_rad == 0.5; }}},
    {"start.theta_dot_rad_s",
     {a_top + "theta_dot_rad_s = 0.25\n",
      [](const Scene& s) {
          return s.start.top->theta_dot_rad_s == 0.25 && s.start.omega_rad_s[0] == 0.25;
      }}},
    {"start.phi_dot_rad_s",
     {a_top + "phi_dot_rad_s = 0.25\n",
      [](const Scene& s) {
          return s.start.top->phi_dot_rad_s == 0.25 &&
                 std::abs(s.start.omega_rad_s[1] - 0.25 * std::sin(0.5)) < 1e-16;
      }}},
    {"start.omega3_rad_s",
     {a_top + "omega3_rad_s = 8\n",
      [](const Scene& s) {
          return s.start.top->omega3_rad_s == 8.0 && s.start.omega_rad_s[2] == 8.0;
      }}},
    {"torque.kind",
     {a_top + gravity, [](const Scene& s) { return std::holds_alternative<Gravity>(torque(s)); }}},
    {"torque.mgl_N_m",
     {a_top + gravity, [](const Scene& s) { return std::get<Gravity>(torque(s)).mgl_N_m == 2.5; }}},
    {"torque.arm_body",
     {a_top + gravity + "arm_body = [0, 0, -2]\n",
      [](const Scene& s) {
          return std::get<Gravity>(torque(s)).arm_body == Eigen::Vector3d(0.0, 0.0, -1.0);
      }}},
    {"torque.torque_body_N_m",
     {with("torque",
           "kind = \"constant_body\"\ntorque_body_N_m = [1, 2, 3]\n[motion]\nmethod = "
           "\"rk4\""),
      [](const Scene& s) {
          return std::get<ConstantTorqueInBody>(torque(s)).torque_body_N_m ==
                 Eigen::Vector3d(1.0, 2.0, 3.0);
      }}},
    {"torque.torque_space_N_m",
     {with("torque",
           "kind = \"constant_space\"\ntorque_space_N_m = [1, 2, 3]\n[motion]\nmethod = "
           "\"rk4\""),
      [](const Scene& s) {
          return std::get<ConstantTorqueInSpace>(torque(s)).torque_space_N_m ==
                 Eigen::Vector3d(1.0, 2.0, 3.0);
      }}},
    {"torque.half_life_s",
     {with("torque", "kind = \"dissipation\"\nhalf_life_s = 3\n[motion]\nmethod = \"rk4\""),
      [](const Scene& s) {
          return s.half_life_s == 3.0 && std::get<InternalFriction>(torque(s)).rate_1_s > 0.0;
      }}},
    {"torque.rate_1_s",
     {with("torque", "kind = \"dissipation\"\nrate_1_s = 0.5\n[motion]\nmethod = \"rk4\""),
      [](const Scene& s) { return std::get<InternalFriction>(torque(s)).rate_1_s == 0.5; }}},
    {"torque.linear_1_s",
     {with("torque", "kind = \"drag\"\nlinear_1_s = [1, 2, 3]\n[motion]\nmethod = \"rk4\""),
      [](const Scene& s) {
          const auto& drag = std::get<Drag>(torque(s));
          return drag.linear_1_s == Eigen::Vector3d(1.0, 2.0, 3.0) &&
                 drag.quadratic_1_rad.isZero(0.0);
      }}},
    {"torque.quadratic_1_rad",
     {with("torque", "kind = \"drag\"\nquadratic_1_rad = [1, 2, 3]\n[motion]\nmethod = \"rk4\""),
      [](const Scene& s) {
          const auto& drag = std::get<Drag>(torque(s));
          return drag.quadratic_1_rad == Eigen::Vector3d(1.0, 2.0, 3.0) &&
                 drag.linear_1_s.isZero(0.0) && drag.growth_1_s == 0.0;
      }}},
    {"torque.growth_1_s",
     {with("torque",
           "kind = \"drag\"\nlinear_1_s = [1, 2, 3]\ngrowth_1_s = -0.5\n[motion]\nmethod = "
           "\"rk4\""),
      [](const Scene& s) { return std::get<Drag>(torque(s)).growth_1_s == -0.5; }}},
    {"measured.file",
     {with("measured", "file = \"gyro.csv\""),
      [](const Scene& s) {
          const auto& rows = s.measured.motion.rows;
          return s.measured.file == "gyro.csv" && rows.size() == 2 && rows[1].time_s == 0.5 &&
                 std::abs(rows[0].omega_body[2] - std::acos(-1.0)) < 1e-15;
      }}},
    {"film.fps",
     {with("film", "fps = 29.97"),
      [](const Scene& s) {
          return s.film.fps_numerator == 30000 && s.film.fps_denominator == 1001;
      }}},
    {"film.size",
     {with("film", "size = \"640x480\""),
      [](const Scene& s) { return s.film.width_px == 640 && s.film.height_px == 480; }}},
    {"camera.view",
     {with("camera", "view = \"contact\"\nazimuth_deg = 7"),
      [](const Scene& s) {
          return s.camera.view == "contact" && s.camera.azimuth_deg == 7.0 &&
                 s.camera.elevation_deg == camera_view_named("contact").elevation_deg &&
                 s.camera.look_at == "foot";
      }}},
    {"keyframes[].view",
     {a_scene + "[[keyframes]]\nat_s = 2\nview = \"top\"\n",
      [](const Scene& s) {
          return s.keyframes.at(0).view == "top" && s.keyframes.at(0).elevation_deg == 90.0 &&
                 s.keyframes.at(0).look_at == "centre";
      }}},
    {"panels[].column",
     {a_scene + "[[panels]]\ncolumn = 2\n",
      [](const Scene& s) { return s.panels.at(0).column == 2 && s.grid.columns.size() == 3; }}},
    {"panels[].row",
     {a_scene + "[[panels]]\n[[panels]]\nrow = 1\n",
      [](const Scene& s) { return s.panels.at(1).row == 1 && s.grid.rows.size() == 2; }}},
};

// The rows of [style] come from a table: a colour for each, and the other values of its kind.
template <std::size_t role>
inline Claim style_claim() {
    const StyleRole& claimed = style_roles()[role];
    const std::string_view more = claimed.kind == StyleKind::line      ? " 1.25 dotted"
                                  : claimed.kind == StyleKind::surface ? " 33.3%"
                                                                       : "";
    return {with("style", fmt::format("{} = \"#003366{}\"", claimed.name, more)),
            [](const Scene& s) {
                const StyleRole& row = style_roles()[role];
                const LookSpec& look = s.style.looks.at(std::string(row.name));
                const bool line = row.kind == StyleKind::line;
                const bool surface = row.kind == StyleKind::surface;
                return look.srgb == std::array<double, 3>{0.0, 0.2, 0.4} &&
                       look.weight == (line ? std::optional(1.25) : std::nullopt) &&
                       look.line == (line ? "dotted" : "") &&
                       look.opacity_percent == (surface ? std::optional(33.3) : std::nullopt);
            }};
}
inline constexpr std::size_t n_style_roles = 35;
template <std::size_t... role>
inline Claims with_styles(Claims all, std::index_sequence<role...>) {
    (all.emplace(fmt::format("style.{}", style_roles()[role].name), style_claim<role>()), ...);
    return all;
}
inline const Claims claims = with_styles(claims_of_rows, std::make_index_sequence<n_style_roles>());

}  // namespace poinsot::scene_keys_tests
