// For every scene key a scene that gives it, and a check of the scene's value.
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
    {"title", {"title = \"x ω\"\n" + a_scene, [](const Scene& s) { return s.title == "x ω"; }}},
    {"caption",
     {"caption = 'y $\\omega$'\n" + a_scene,
      [](const Scene& s) { return s.caption == "y $\\omega$"; }}},
    {"accuracy_px",
     {"accuracy_px = 0.25\n" + a_scene, [](const Scene& s) { return s.accuracy_px == 0.25; }}},
    {"theme", {"theme = \"dark\"\n" + a_scene, [](const Scene& s) { return s.theme == "dark"; }}},
    {"hidden",
     {"hidden = \"dashed\"\n" + a_scene, [](const Scene& s) { return s.hidden == "dashed"; }}},
    {"hidden_arrows",
     {"hidden_arrows = \"dashed\"\n" + a_scene,
      [](const Scene& s) { return s.hidden_arrows == "dashed"; }}},
    {"crossings",
     {"crossings = \"gap\"\n" + a_scene, [](const Scene& s) { return s.crossings == "gap"; }}},
    {"labels", {"labels = false\n" + a_scene, [](const Scene& s) { return !s.labels; }}},
    {"unlabelled",
     {"unlabelled = [\"omega\"]\n" + a_scene,
      [](const Scene& s) { return s.unlabelled == std::vector<std::string>{"omega"}; }}},
    {"style.title_scale",
     {with("style", "title_scale = 1.5"),
      [](const Scene& s) { return s.style.title_scale == 1.5; }}},
    {"style.caption_scale",
     {with("style", "caption_scale = 1.5"),
      [](const Scene& s) { return s.style.caption_scale == 1.5; }}},
    {"style.heading_scale",
     {with("style", "heading_scale = 1.5"),
      [](const Scene& s) { return s.style.heading_scale == 1.5; }}},
    {"style.label_scale",
     {with("style", "label_scale = 1.5"),
      [](const Scene& s) { return s.style.label_scale == 1.5; }}},
    {"style.chart_scale",
     {with("style", "chart_scale = 1.5"),
      [](const Scene& s) { return s.style.chart_scale == 1.5; }}},
    {"marks[].at",
     {a_scene + "[[marks]]\nat = [1, 2, -3]\n",
      [](const Scene& s) { return s.marks.at(0).at == Eigen::Vector3d(1, 2, -3); }}},
    {"marks[].on",
     {a_scene + "[[marks]]\nat = [1, 2, -3]\non = \"body\"\n",
      [](const Scene& s) { return s.marks.at(0).on == "body"; }}},
    {"marks[].name",
     {a_scene + "[[marks]]\nat = [1, 2, -3]\nname = \"P_1\"\n",
      [](const Scene& s) { return s.marks.at(0).name == "P_1"; }}},
    {"marks[].trail",
     {a_scene + "[[marks]]\nat = [1, 2, -3]\ntrail = true\n",
      [](const Scene& s) { return s.marks.at(0).trail; }}},
    {"marks[].colour",
     {a_scene + "[[marks]]\nat = [1, 2, -3]\ncolour = \"#ff0033\"\n",
      [](const Scene& s) {
          return s.marks.at(0).srgb == std::array<double, 3>{1.0, 0.0, 0.2};
      }}},
    {"object.marked_face",
     {a_scene + "[object]\nmarked_face = \"-e2\"\n",
      [](const Scene& s) { return s.object.marked_face == "-e2"; }}},
    {"object.pictures[].face",
     {a_scene + a_picture, [](const Scene& s) { return s.object.pictures.at(0).face == "-e3"; }}},
    {"object.pictures[].file",
     {a_scene + a_picture,
      [](const Scene& s) { return s.object.pictures.at(0).image.width() == 3; }}},
    {"object.pictures[].up",
     {a_scene + a_picture + "up = \"-e1\"\n",
      [](const Scene& s) { return s.object.pictures.at(0).up == "-e1"; }}},
    {"overlays", {"overlays = false\n" + a_scene, [](const Scene& s) { return !s.overlays; }}},
    {"panel_letters",
     {"panel_letters = true\n" + a_scene, [](const Scene& s) { return s.panel_letters; }}},
    {"clock", {"clock = false\n" + a_scene, [](const Scene& s) { return s.clock == false; }}},
    {"type_scale",
     {"type_scale = 1.5\n" + a_scene, [](const Scene& s) { return s.type_scale == 1.5; }}},
    {"language",
     {"language = \"fr\"\n" + a_scene, [](const Scene& s) { return s.language == "fr"; }}},
    {"units",
     {"units = [\"rpm\", \"g cm²/s\"]\n" + a_scene,
      [](const Scene& s) {
          return s.units == std::vector<std::string>{"rpm", "g cm²/s"};
      }}},
    {"symbols.omega",
     {with("symbols", "omega = '\\Omega'"),
      [](const Scene& s) { return s.symbols.omega == "\\Omega"; }}},
    {"symbols.momentum",
     {with("symbols", "momentum = 'J'"), [](const Scene& s) { return s.symbols.momentum == "J"; }}},
    {"symbols.rho",
     {with("symbols", "rho = 'r'"), [](const Scene& s) { return s.symbols.rho == "r"; }}},
    {"symbols.e1",
     {with("symbols", "e1 = 'x'"), [](const Scene& s) { return s.symbols.e1 == "x"; }}},
    {"symbols.e2",
     {with("symbols", "e2 = 'y'"), [](const Scene& s) { return s.symbols.e2 == "y"; }}},
    {"symbols.e3",
     {with("symbols", "e3 = 'z'"), [](const Scene& s) { return s.symbols.e3 == "z"; }}},
    {"symbols.polhode",
     {with("symbols", "polhode = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("polhode") == "it"; }}},
    {"symbols.herpolhode",
     {with("symbols", "herpolhode = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("herpolhode") == "it"; }}},
    {"symbols.invariable-plane",
     {with("symbols", "invariable-plane = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("invariable-plane") == "it"; }}},
    {"symbols.inertia-ellipsoid",
     {with("symbols", "inertia-ellipsoid = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("inertia-ellipsoid") == "it"; }}},
    {"symbols.body-cone",
     {with("symbols", "body-cone = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("body-cone") == "it"; }}},
    {"symbols.space-cone",
     {with("symbols", "space-cone = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("space-cone") == "it"; }}},
    {"symbols.separatrix",
     {with("symbols", "separatrix = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("separatrix") == "it"; }}},
    {"symbols.measured",
     {with("symbols", "measured = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("measured") == "it"; }}},
    {"symbols.unit-sphere",
     {with("symbols", "unit-sphere = 'it'"),
      [](const Scene& s) { return s.symbols.things.at("unit-sphere") == "it"; }}},
    {"labels.polhode.offset_pt",
     {with("labels", "polhode.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("polhode") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.herpolhode.offset_pt",
     {with("labels", "herpolhode.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("herpolhode") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.invariable-plane.offset_pt",
     {with("labels", "invariable-plane.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("invariable-plane") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.inertia-ellipsoid.offset_pt",
     {with("labels", "inertia-ellipsoid.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("inertia-ellipsoid") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.body-cone.offset_pt",
     {with("labels", "body-cone.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("body-cone") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.space-cone.offset_pt",
     {with("labels", "space-cone.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("space-cone") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.separatrix.offset_pt",
     {with("labels", "separatrix.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("separatrix") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.measured.offset_pt",
     {with("labels", "measured.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("measured") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.unit-sphere.offset_pt",
     {with("labels", "unit-sphere.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("unit-sphere") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.omega.offset_pt",
     {with("labels", "omega.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) { return s.label_offsets_pt.at("omega") == Eigen::Vector2d(1.5, -2.0); }}},
    {"labels.momentum.offset_pt",
     {with("labels", "momentum.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) {
          return s.label_offsets_pt.at("momentum") == Eigen::Vector2d(1.5, -2.0);
      }}},
    {"labels.rho.offset_pt",
     {with("labels", "rho.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) { return s.label_offsets_pt.at("rho") == Eigen::Vector2d(1.5, -2.0); }}},
    {"labels.e1.offset_pt",
     {with("labels", "e1.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) { return s.label_offsets_pt.at("e1") == Eigen::Vector2d(1.5, -2.0); }}},
    {"labels.e2.offset_pt",
     {with("labels", "e2.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) { return s.label_offsets_pt.at("e2") == Eigen::Vector2d(1.5, -2.0); }}},
    {"labels.e3.offset_pt",
     {with("labels", "e3.offset_pt = [1.5, -2.0]"),
      [](const Scene& s) { return s.label_offsets_pt.at("e3") == Eigen::Vector2d(1.5, -2.0); }}},
    {"names",
     {"names = [\"polhode\"]\n" + a_scene,
      [](const Scene& s) { return s.names == std::vector<std::string>{"polhode"}; }}},
    {"show",
     {"show = [\"plane\", \"omega\"]\n" + a_scene,
      [](const Scene& s) {
          return s.show == std::vector<std::string>{"plane", "omega"};
      }}},
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
     {a_top + gravity,
      [](const Scene& s) { return std::holds_alternative<GravityTorque>(torque(s)); }}},
    {"torque.mgl_N_m",
     {a_top + gravity,
      [](const Scene& s) { return std::get<GravityTorque>(torque(s)).mgl_N_m == 2.5; }}},
    {"torque.arm_body",
     {a_top + gravity + "arm_body = [0, 0, -2]\n",
      [](const Scene& s) {
          return std::get<GravityTorque>(torque(s)).arm_body == Eigen::Vector3d(0.0, 0.0, -1.0);
      }}},
    {"torque.torque_body_N_m",
     {with("torque",
           "kind = \"constant_body\"\ntorque_body_N_m = [1, 2, 3]\n[motion]\nmethod = "
           "\"rk4\""),
      [](const Scene& s) {
          return std::get<ConstantBodyTorque>(torque(s)).torque_body_N_m ==
                 Eigen::Vector3d(1.0, 2.0, 3.0);
      }}},
    {"torque.torque_space_N_m",
     {with("torque",
           "kind = \"constant_space\"\ntorque_space_N_m = [1, 2, 3]\n[motion]\nmethod = "
           "\"rk4\""),
      [](const Scene& s) {
          return std::get<ConstantSpaceTorque>(torque(s)).torque_space_N_m ==
                 Eigen::Vector3d(1.0, 2.0, 3.0);
      }}},
    {"torque.half_life_s",
     {with("torque", "kind = \"dissipation\"\nhalf_life_s = 3\n[motion]\nmethod = \"rk4\""),
      [](const Scene& s) {
          return s.half_life_s == 3.0 && std::get<DissipationTorque>(torque(s)).rate_1_s > 0.0;
      }}},
    {"torque.rate_1_s",
     {with("torque", "kind = \"dissipation\"\nrate_1_s = 0.5\n[motion]\nmethod = \"rk4\""),
      [](const Scene& s) { return std::get<DissipationTorque>(torque(s)).rate_1_s == 0.5; }}},
    {"motion.method",
     {with("motion", "method = \"rk4\""), [](const Scene& s) { return s.method.name == "rk4"; }}},
    {"motion.step_s",
     {with("motion", "method = \"rk4\"\nstep_s = 0.5"),
      [](const Scene& s) { return s.method.step_s == 0.5; }}},
    {"motion.tolerance",
     {with("motion", "method = \"dopri5\"\ntolerance = 1e-9"),
      [](const Scene& s) { return s.method.tolerance == 1e-9; }}},
    {"motion.order",
     {with("motion", "method = \"dmv\"\norder = 4"),
      [](const Scene& s) { return s.method.order == 4; }}},
    {"beside.method",
     {with("beside", "method = \"euler\""),
      [](const Scene& s) { return s.beside.value().name == "euler"; }}},
    {"beside.step_s",
     {with("beside", "method = \"rk4\"\nstep_s = 0.5"),
      [](const Scene& s) { return s.beside.value().step_s == 0.5; }}},
    {"beside.tolerance",
     {with("beside", "method = \"dopri5\"\ntolerance = 1e-4"),
      [](const Scene& s) { return s.beside.value().tolerance == 1e-4; }}},
    {"beside.order",
     {with("beside", "method = \"dmv\"\norder = 6"),
      [](const Scene& s) { return s.beside.value().order == 6; }}},
    {"measured.file",
     {with("measured", "file = \"gyro.csv\""),
      [](const Scene& s) {
          const auto& rows = s.measured.motion.rows;
          return s.measured.file == "gyro.csv" && rows.size() == 2 && rows[1].time_s == 0.5 &&
                 std::abs(rows[0].omega_body[2] - std::acos(-1.0)) < 1e-15;
      }}},
    {"film.start_s",
     {with("film", "start_s = -2.5"), [](const Scene& s) { return s.film.start_s == -2.5; }}},
    {"film.duration_s",
     {with("film", "duration_s = 7"), [](const Scene& s) { return s.film.duration_s == 7.0; }}},
    {"film.fps",
     {with("film", "fps = 29.97"),
      [](const Scene& s) {
          return s.film.fps_numerator == 30000 && s.film.fps_denominator == 1001;
      }}},
    {"film.size",
     {with("film", "size = \"640x480\""),
      [](const Scene& s) { return s.film.width_px == 640 && s.film.height_px == 480; }}},
    {"film.speed",
     {with("film", "speed = 0.5"), [](const Scene& s) { return s.film.speed == 0.5; }}},
    {"film.quality",
     {with("film", "quality = \"draft\""),
      [](const Scene& s) { return s.film.quality == "draft"; }}},
    {"camera.azimuth_deg",
     {with("camera", "azimuth_deg = 10"),
      [](const Scene& s) { return s.camera.azimuth_deg == 10.0; }}},
    {"camera.elevation_deg",
     {with("camera", "elevation_deg = 30"),
      [](const Scene& s) { return s.camera.elevation_deg == 30.0; }}},
    {"camera.distance",
     {with("camera", "distance = 7"), [](const Scene& s) { return s.camera.distance == 7.0; }}},
    {"camera.field_deg",
     {with("camera", "field_deg = 40"), [](const Scene& s) { return s.camera.field_deg == 40.0; }}},
    {"camera.target",
     {with("camera", "target = [0, 0, 0.5]"),
      [](const Scene& s) { return s.camera.target == Eigen::Vector3d(0.0, 0.0, 0.5); }}},
    {"camera.motion",
     {with("camera", "motion = \"co-precessing\""),
      [](const Scene& s) { return s.camera.motion == "co-precessing"; }}},
    {"film.still_s",
     {with("film", "still_s = 9.5"), [](const Scene& s) { return s.film.still_s == 9.5; }}},
    {"film.length_s",
     {with("film", "length_s = 20"), [](const Scene& s) { return s.film.length_s == 20.0; }}},
    {"film.loop",
     {with("film", "loop = \"5/3\""), [](const Scene& s) { return s.film.loop == "5/3"; }}},
    {"film.loop_changes",
     {with("film", "loop = \"5/3\"\nloop_changes = \"omega_body_2\""),
      [](const Scene& s) { return s.film.loop_changes == "omega_body_2"; }}},
    {"camera.look_at",
     {with("camera", "look_at = \"foot\""),
      [](const Scene& s) { return s.camera.look_at == "foot"; }}},
    {"camera.view",
     {with("camera", "view = \"contact\"\nazimuth_deg = 7"),
      [](const Scene& s) {
          return s.camera.view == "contact" && s.camera.azimuth_deg == 7.0 &&
                 s.camera.elevation_deg == camera_view_named("contact").elevation_deg &&
                 s.camera.look_at == "foot";
      }}},
    {"trail.polhode",
     {with("trail", "polhode = \"history\""),
      [](const Scene& s) { return s.trail.polhode == "history"; }}},
    {"trail.herpolhode",
     {with("trail", "herpolhode = \"fading\""),
      [](const Scene& s) { return s.trail.herpolhode == "fading"; }}},
    {"trail.axis",
     {with("trail", "axis = \"fading\""), [](const Scene& s) { return s.trail.axis == "fading"; }}},
    {"trail.length_s",
     {with("trail", "length_s = 4"), [](const Scene& s) { return s.trail.length_s == 4.0; }}},
    {"trail.direction_marks",
     {with("trail", "direction_marks = true"),
      [](const Scene& s) { return s.trail.direction_marks; }}},
    {"construction.plane",
     {with("construction", "plane = \"above\""),
      [](const Scene& s) { return s.construction.plane == "above"; }}},
    {"construction.sweep",
     {with("construction", "sweep = \"energy\""),
      [](const Scene& s) { return s.construction.sweep == "energy"; }}},
    {"keyframes[].at_s",
     {a_scene + "[[keyframes]]\nat_s = 2\nspeed = 1\n",
      [](const Scene& s) { return s.keyframes.at(0).at_s == 2.0; }}},
    {"keyframes[].easing",
     {a_scene + "[[keyframes]]\nat_s = 2\nspeed = 1\neasing = \"hold\"\n",
      [](const Scene& s) { return s.keyframes.at(0).easing == "hold"; }}},
    {"keyframes[].view",
     {a_scene + "[[keyframes]]\nat_s = 2\nview = \"top\"\n",
      [](const Scene& s) {
          return s.keyframes.at(0).view == "top" && s.keyframes.at(0).elevation_deg == 90.0 &&
                 s.keyframes.at(0).look_at == "centre";
      }}},
    {"panels[].camera.azimuth_deg",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\nazimuth_deg = 30\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.azimuth_deg == 30.0;
      }}},
    {"panels[].camera.elevation_deg",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\nelevation_deg = 20\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.elevation_deg == 20.0;
      }}},
    {"panels[].camera.distance",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\ndistance = 4\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.distance == 4.0;
      }}},
    {"panels[].camera.field_deg",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\nfield_deg = 20\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.field_deg == 20.0;
      }}},
    {"panels[].camera.target",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\ntarget = [0.0, 0.0, 0.5]\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.target->z() == 0.5;
      }}},
    {"panels[].camera.look_at",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\nlook_at = \"foot\"\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.look_at == "foot";
      }}},
    {"panels[].camera.view",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\nview = \"high\"\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.view == "high";
      }}},
    {"panels[].camera.projection",
     {a_scene + "[[panels]]\nkind = \"space\"\n[panels.camera]\nprojection = \"orthographic\"\n",
      [](const Scene& s) {
          const PanelCameraSpec& c = s.panels.at(0).camera;
          return c.projection == "orthographic";
      }}},
    {"camera.projection",
     {with("camera", "projection = \"orthographic\""),
      [](const Scene& s) { return s.camera.projection == "orthographic"; }}},
    {"keyframes[].panel",
     {a_scene + "[[keyframes]]\nat_s = 2\npanel = 0\nazimuth_deg = 1\n",
      [](const Scene& s) { return s.keyframes.at(0).panel == 0; }}},
    {"keyframes[].azimuth_deg",
     {a_scene + "[[keyframes]]\nat_s = 2\nazimuth_deg = 400\n",
      [](const Scene& s) { return s.keyframes.at(0).azimuth_deg == 400.0; }}},
    {"keyframes[].elevation_deg",
     {a_scene + "[[keyframes]]\nat_s = 2\nelevation_deg = 40\n",
      [](const Scene& s) { return s.keyframes.at(0).elevation_deg == 40.0; }}},
    {"keyframes[].distance",
     {a_scene + "[[keyframes]]\nat_s = 2\ndistance = 4\n",
      [](const Scene& s) { return s.keyframes.at(0).distance == 4.0; }}},
    {"keyframes[].field_deg",
     {a_scene + "[[keyframes]]\nat_s = 2\nfield_deg = 40\n",
      [](const Scene& s) { return s.keyframes.at(0).field_deg == 40.0; }}},
    {"keyframes[].target",
     {a_scene + "[[keyframes]]\nat_s = 2\ntarget = [0, 0, 0.5]\n",
      [](const Scene& s) { return s.keyframes.at(0).target == Eigen::Vector3d(0.0, 0.0, 0.5); }}},
    {"keyframes[].look_at",
     {a_scene + "[[keyframes]]\nat_s = 2\nlook_at = \"foot\"\n",
      [](const Scene& s) { return s.keyframes.at(0).look_at == "foot"; }}},
    {"keyframes[].speed",
     {a_scene + "[[keyframes]]\nat_s = 2\nspeed = 0\n",
      [](const Scene& s) { return s.keyframes.at(0).speed == 0.0; }}},
    {"fades[].at_s",
     {a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\n\n",
      [](const Scene& s) { return s.fades.at(0).at_s == 2.0; }}},
    {"fades[].over_s",
     {a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\nover_s = 0.5\n",
      [](const Scene& s) { return s.fades.at(0).over_s == 0.5; }}},
    {"fades[].easing",
     {a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\neasing = \"linear\"\n",
      [](const Scene& s) { return s.fades.at(0).easing == "linear"; }}},
    {"fades[].elements",
     {a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\n\n",
      [](const Scene& s) { return s.fades.at(0).elements == std::vector<std::string>{"plane"}; }}},
    {"fades[].opacity",
     {a_scene + "[[fades]]\nat_s = 2\nelements = [\"plane\"]\nopacity = 0.25\n",
      [](const Scene& s) { return s.fades.at(0).opacity == 0.25; }}},
    {"captions[].at_s",
     {a_scene + "[[captions]]\nat_s = 2\ntext = \"x\"\n",
      [](const Scene& s) { return s.captions.at(0).at_s == 2.0; }}},
    {"captions[].over_s",
     {a_scene + "[[captions]]\nat_s = 2\ntext = \"x\"\nover_s = 1.5\n",
      [](const Scene& s) { return s.captions.at(0).over_s == 1.5; }}},
    {"captions[].text",
     {a_scene + "[[captions]]\nat_s = 2\ntext = \"x\"\n",
      [](const Scene& s) { return s.captions.at(0).text == "x"; }}},
    {"captions[].place",
     {a_scene + "[[captions]]\nat_s = 2\ntext = \"x\"\nplace = \"top\"\n",
      [](const Scene& s) { return s.captions.at(0).place == "top"; }}},
    {"chapters[].at_s",
     {a_scene + "[[chapters]]\nat_s = 2\ntitle = \"x\"\n",
      [](const Scene& s) { return s.chapters.at(0).at_s == 2.0; }}},
    {"chapters[].title",
     {a_scene + "[[chapters]]\nat_s = 2\ntitle = \"x\"\n",
      [](const Scene& s) { return s.chapters.at(0).title == "x"; }}},
    {"stops[].at_s",
     {a_scene + "[[stops]]\nat_s = 2\n", [](const Scene& s) { return s.stops.at(0).at_s == 2.0; }}},
    {"stops[].title",
     {a_scene + "[[stops]]\nat_s = 2\ntitle = \"x\"\n",
      [](const Scene& s) { return s.stops.at(0).title == "x"; }}},
    {"stops[].loop_s",
     {a_scene + "[[stops]]\nat_s = 2\nloop_s = 1.5\n",
      [](const Scene& s) { return s.stops.at(0).loop_s == 1.5; }}},
    {"stops[].note",
     {a_scene + "[[stops]]\nat_s = 2\nnote = \"x\"\n",
      [](const Scene& s) { return s.stops.at(0).note == "x"; }}},
    {"page.controls",
     {with("page", "controls = [\"start.omega_rad_s[1]\", \"film.fps\"]"),
      [](const Scene& s) {
          return s.page.controls.value() ==
                 std::vector<std::string>{"start.omega_rad_s[1]", "film.fps"};
      }}},
    {"page.elements",
     {with("page", "elements = [\"plane\"]"),
      [](const Scene& s) { return s.page.elements == std::vector<std::string>{"plane"}; }}},
    {"grid.columns",
     {with("grid", "columns = [2, 1]"),
      [](const Scene& s) {
          return s.grid.columns == std::vector<double>{2.0, 1.0};
      }}},
    {"grid.rows",
     {with("grid", "rows = [2, 1]"),
      [](const Scene& s) {
          return s.grid.rows == std::vector<double>{2.0, 1.0};
      }}},
    {"panels[].kind",
     {a_scene + "[[panels]]\nkind = \"plan\"\n",
      [](const Scene& s) { return s.panels.at(0).kind == "plan"; }}},
    {"panels[].column",
     {a_scene + "[[panels]]\ncolumn = 2\n",
      [](const Scene& s) { return s.panels.at(0).column == 2 && s.grid.columns.size() == 3; }}},
    {"panels[].row",
     {a_scene + "[[panels]]\n[[panels]]\nrow = 1\n",
      [](const Scene& s) { return s.panels.at(1).row == 1 && s.grid.rows.size() == 2; }}},
    {"panels[].columns",
     {a_scene + "[[panels]]\ncolumns = 2\n",
      [](const Scene& s) { return s.panels.at(0).columns == 2; }}},
    {"panels[].rows",
     {a_scene + "[[panels]]\nrows = 2\n", [](const Scene& s) { return s.panels.at(0).rows == 2; }}},
    {"panels[].quantity",
     {a_scene + "[[panels]]\nkind = \"plot\"\nquantity = \"omega\"\n",
      [](const Scene& s) { return s.panels.at(0).quantity == "omega"; }}},
    {"panels[].curves",
     {a_scene + "[[panels]]\nkind = \"body\"\ncurves = 4\n",
      [](const Scene& s) { return s.panels.at(0).curves == 4; }}},
    {"panels[].title",
     {a_scene + "[[panels]]\ntitle = \"\"\n[[panels]]\nrow = 1\n",
      [](const Scene& s) { return s.panels.at(0).title == "" && !s.panels.at(1).title; }}},
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
