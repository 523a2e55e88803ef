#include "drawing/stage_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/accuracy.h"
#include "drawing/elements/smooth_paths.h"
#include "drawing/panel.h"
#include "drawing/type/overlay.h"
#include "numerics/least_turn.h"
#include "scene/film_clock.h"
#include "scene/scene_error.h"
#include "shapes/identity.h"
#include "text/languages.h"
#include "text/units.h"

namespace poinsot {

namespace {

// Drawn with radii up to twice the picture's height: the sagitta r(1 − cos(π/n)) stays below
// curve_px.
CurveGeometry circle_of_radius_1(const StageOptions& options, double curve_px) {
    CurveGeometry circle;
    circle.closed = true;
    const double least = std::numbers::pi / std::sqrt(curve_px / options.height_px);
    const int n_points = static_cast<int>(std::clamp(std::ceil(least), 512.0, 65536.0));
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    circle.smooth = smooth_circle(Eigen::Vector3d::Zero(), 1.0, circle.points.size());
    return circle;
}

}  // namespace

ConstructionPicture::ConstructionPicture(const MotionProblem& problem, std::string_view plane)
    : construction(problem.inertia, problem.start),
      polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix),
      cones(rolling_cones(problem.inertia, problem.start.omega_body)) {
    picture_per_rho = 1.0 / construction.half_axes().maxCoeff();
    half_axes = construction.half_axes() * picture_per_rho;
    plane_distance = construction.plane_distance() * picture_per_rho;
    herpolhode_radius = polhode.annulus().outer * picture_per_rho;
    picture_from_space = least_turn(construction.normal_space(), Eigen::Vector3d::UnitZ());
    normal = Eigen::Vector3d::UnitZ();
    if (plane == "below") {
        const Eigen::Quaterniond half_turn_about_x(0.0, 1.0, 0.0, 0.0);
        picture_from_space = half_turn_about_x * picture_from_space;
        normal = -normal;
    }
}

Eigen::Quaterniond ConstructionPicture::picture_from_body(const FrameInput& instant) const {
    return picture_from_space * instant.state.space_from_body;
}

Eigen::Matrix3d ConstructionPicture::principal_axes(const FrameInput& instant) const {
    return picture_from_body(instant).toRotationMatrix() *
           construction.inertia().body_from_principal();
}

Eigen::Vector3d ConstructionPicture::contact(const FrameInput& instant) const {
    const Eigen::Vector3d rho =
        picture_from_space * construction.contact_space(instant.state) * picture_per_rho;
    return dissipates ? Eigen::Vector3d(rho * rho_growth(instant.state.omega_body)) : rho;
}

Eigen::Vector3d ConstructionPicture::foot(const FrameInput& instant) const {
    return dissipates ? Eigen::Vector3d(foot() / rho_growth(instant.state.omega_body)) : foot();
}

double ConstructionPicture::rho_growth(const Eigen::Vector3d& omega_body) const {
    if (!dissipates) return 1.0;
    // F(ω/√(2T(0))) = T/T(0).
    const Eigen::Vector3d rho = construction.contact_body(omega_body);
    return 1.0 / std::sqrt(rho.dot(construction.inertia().matrix_body() * rho));
}

Eigen::Vector3d ConstructionPicture::contact_body(const Eigen::Vector3d& omega_body) const {
    if (!dissipates) return construction.contact_body(omega_body);
    return construction.contact_body(omega_body) * rho_growth(omega_body);
}

StageData::StageData(const Scene& scene_, const Motion& motion_, const StageOptions& options_,
                     const Motion* comparison_)
    : scene(scene_), motion(motion_), options(options_), user_theme(theme_of(scene_)) {
    if (comparison_ != nullptr) comparison.emplace(*comparison_);
    px = options.line_scale > 0.0 ? options.line_scale : options.height_px / 1080.0;
    film_first_s = std::min(scene.film.start_s, options.first_time_s);
    film_last_s = std::max(film_end_time_s(scene), options.last_time_s);
    curve_px = options.curve_px > 0.0 ? options.curve_px : accuracy_of(scene).curve_px();
    unit_circle = keep(circle_of_radius_1(options, curve_px), curve_px, "a circle");
    unit_segment =
        keep({.points = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}}, 0.0, "a line");
    make_construction();
    timeline = Timeline(scene, rolling ? rolling->foot() : Eigen::Vector3d::Zero().eval());
    // Curves are subdivided to this, those that are made for one instant as well.
    curve_error_px = curve_px;
    make_panels();
    if (comparison && !shows_comparison) {
        throw SceneError(scene.location_of("beside"),
                         "no panel here shows the comparison method; add a panel \"space\", "
                         "\"body\", \"object\", \"top\", \"momentum\" or \"plot\"");
    }
    overlays = make_overlays(*this);
    check_fades();
    check_unlabelled();
    check_keyframes();
}

void StageData::make_construction() {
    const MotionProblem& problem = motion.motion().problem();
    const bool dissipates = std::holds_alternative<DissipationTorque>(problem.torque);
    if (!(dissipates || std::holds_alternative<NoTorque>(problem.torque)) ||
        problem.start.omega_body.isZero(0.0)) {
        return;
    }
    rolling.emplace(problem, scene.construction.plane);
    if (dissipates) {
        rolling->dissipates = true;
        rolling->cones.reset();  // their angles change
        widen_herpolhode();
        return;
    }
    const FreeRotationConstants constants = motion.motion().free_constants();
    polhode_period_s = constants.polhode_period_s;
    if (scene.camera.motion == "co-precessing") turn_rate_rad_s = constants.mean_advance_rate_rad_s;
}

// Enlarges the herpolhode's radius to the largest component of ρ in the plane over the film.
void StageData::widen_herpolhode() {
    constexpr int n_looks = 512;
    constexpr Quantities in_plane{.attitude = false, .herpolhode = true, .euler_angles = false};
    for (int k = 0; k <= n_looks; ++k) {
        const double time_s =
            options.first_time_s + (options.last_time_s - options.first_time_s) * k / n_looks;
        const MotionSample sample = motion.motion().sample(time_s, in_plane);
        const Eigen::Vector3d rho =
            rolling->construction.contact_in_plane(sample.herpolhode_space) *
            rolling->rho_growth(sample.state.omega_body);
        rolling->herpolhode_radius =
            std::max(rolling->herpolhode_radius, rho.norm() * rolling->picture_per_rho);
    }
}

StageData::~StageData() = default;

const CurveGeometry* StageData::keep(CurveGeometry geometry, double off_px, std::string_view what) {
    constexpr double rounding = 1e-6;
    if (!(off_px <= (1.0 + rounding) * curve_px)) {
        const double from_s = std::min(options.first_time_s, film_first_s);
        const double to_s = std::max(options.last_time_s, film_last_s);
        throw SceneError(
            scene.location_of("film"),
            fmt::format("{} cannot be drawn within accuracy_px = {:g} from t = {:g} s to {:g} s: "
                        "it has too many turns, or the times are too large to resolve its points; "
                        "set film.start_s nearer to the last instant shown, shorten the film or "
                        "its trails, or raise accuracy_px",
                        what, scene.accuracy_px, from_s, to_s));
    }
    curve_error_px = std::max(curve_error_px, off_px);
    geometry.id = next_identity();
    return &curves.emplace_back(std::move(geometry));
}

void StageData::note(std::string text) {
    if (std::find(notes.begin(), notes.end(), text) == notes.end())
        notes.push_back(std::move(text));
}

const MeshGeometry* StageData::keep(MeshGeometry geometry) {
    geometry.id = next_identity();
    return &meshes.emplace_back(std::move(geometry));
}

FrameInput StageData::instant_at(const FilmTime& moment) const {
    const MotionSample sample = motion.sample(moment.time_s, needs);
    FrameInput instant{moment.time_s, sample.state,  sample.herpolhode_space,
                       sample.euler,  moment.film_s, {}};
    if (shows_comparison) {
        constexpr Quantities whole_state{
            .attitude = true, .herpolhode = false, .euler_angles = false};
        instant.comparison = comparison->sample(moment.time_s, whole_state).state;
    }
    if (turns()) {
        const Eigen::Quaterniond turn = turned_from_space(moment.time_s);
        instant.state.space_from_body = turn * instant.state.space_from_body;
        instant.herpolhode_space = turn * instant.herpolhode_space;
        if (instant.comparison) {
            instant.comparison->space_from_body = turn * instant.comparison->space_from_body;
        }
    }
    return instant;
}

Eigen::Quaterniond StageData::turned_from_space(double time_s) const {
    const double angle_rad = turn_rate_rad_s * (time_s - scene.film.start_s);
    return Eigen::Quaterniond(Eigen::AngleAxisd(-angle_rad, rolling->construction.normal_space()));
}

double StageData::quickest_rate_rad_s() const {
    const MotionProblem& problem = motion.motion().problem();
    const double I_least = problem.inertia.moments_kg_m2().minCoeff();
    const Eigen::Vector3d omega =
        problem.inertia.body_from_principal().transpose() * problem.start.omega_body;
    // In units of the least moment, so that T neither overflows nor underflows.
    const Eigen::Vector3d weights = (problem.inertia.moments_kg_m2() / I_least).cwiseSqrt();
    double rate = weights.cwiseProduct(omega).stableNorm();
    if (const auto* gravity = std::get_if<GravityTorque>(&problem.torque)) {
        rate = std::hypot(rate, 2.0 * std::sqrt(std::abs(gravity->mgl_N_m) / I_least));
    }
    return rate;
}

std::vector<LiveValue> StageData::live_values(const Scene& scene, const FrameInput& instant) {
    const Eigen::Vector3d& omega = instant.state.omega_body;
    const Eigen::Vector3d momentum = scene.body.inertia.matrix_body() * omega;
    const double energy_J = 0.5 * omega.dot(momentum);
    std::vector<LiveValue> values{{"time_s", instant.time_s, "s"},
                                  {"time_h", instant.time_s / 3600.0, "h"},
                                  {"time_d", instant.time_s / 86400.0, "d"},
                                  {"omega_1_rad_s", omega[0], "rad/s"},
                                  {"omega_2_rad_s", omega[1], "rad/s"},
                                  {"omega_3_rad_s", omega[2], "rad/s"},
                                  {"kinetic_energy_J", energy_J, "J"},
                                  {"momentum_kg_m2_s", momentum.stableNorm(), "kg m²/s"}};
    // In the unit in which the scene shows such a quantity, which the number brings along.
    const auto add = [&](std::string_view name, double value, std::string_view unit) {
        const ShownUnit shown = unit_shown(scene.units, unit);
        values.push_back({name, value * shown.per_SI, shown.name, true});
    };
    add("t", instant.time_s, "s");
    add("omega_1", omega[0], "rad/s");
    add("omega_2", omega[1], "rad/s");
    add("omega_3", omega[2], "rad/s");
    add("omega", omega.stableNorm(), "rad/s");
    for (const std::string_view name : {"T", "kinetic_energy"}) add(name, energy_J, "J");
    for (const std::string_view name : {"L", "momentum"})
        add(name, momentum.stableNorm(), "kg m²/s");
    return values;
}

std::string StageData::live_text(const Scene& scene, std::string_view text,
                                 const FrameInput& instant) {
    return expand_live_text(text, live_values(scene, instant), decimal_mark_of(scene.language));
}

}  // namespace poinsot
