// From what was read to a whole scene: the ways of giving a thing are weighed against each other,
// and the mechanics' refusals get the place of the key that they concern.
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "error/error.h"
#include "error/nearest.h"
#include "mechanics/heavy_top.h"
#include "mechanics/methods.h"
#include "scene/scene_draft.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& key, std::string_view what) {
    throw SceneError(scene.location_of(key), what);
}

// Calls the mechanics; what it refuses is wrong at this key.
template <typename Call>
decltype(auto) at_key(const Scene& scene, const std::string& key, Call call) {
    try {
        return call();
    } catch (const SceneError&) {
        throw;
    } catch (const InputError& error) {
        refuse(scene, key, error.what());
    }
}

// "at line 3", "by --set", for the other half of a contradiction.
std::string place(const SourceLocation& where) {
    return where.line > 0 ? fmt::format("at line {}", where.line)
                          : fmt::format("by {}", echo(where.file));
}

bool stands_before(const SourceLocation& a, const SourceLocation& b) {
    const auto order = [](const SourceLocation& where) {
        return std::array<int, 3>{where.line == 0 ? 1 : 0, where.line, where.column};
    };
    return order(a) < order(b);
}

// Refuses two keys that say the same thing in different ways, at the one that stands later.
void refuse_both(const Scene& scene, const std::string& one, const std::string& other,
                 std::string_view remedy) {
    if (!scene.locations.contains(one) || !scene.locations.contains(other)) return;
    const bool in_order = stands_before(scene.location_of(one), scene.location_of(other));
    const std::string& first = in_order ? one : other;
    const std::string& second = in_order ? other : one;
    refuse(scene, second,
           fmt::format("{} contradicts {} ({}); {}", second, first, place(scene.location_of(first)),
                       remedy));
}

// Refuses every pair of keys of two different ways.
void refuse_mixed(const Scene& scene, std::span<const std::vector<std::string>> ways,
                  std::string_view remedy) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
        for (std::size_t j = i + 1; j < ways.size(); ++j) {
            for (const std::string& one : ways[i]) {
                for (const std::string& other : ways[j]) refuse_both(scene, one, other, remedy);
            }
        }
    }
}

// A vector of length 1 to rounding is kept bit for bit, so that a scene written out reads back the
// same; any other is scaled, and the user is told. Throws for the zero vector.
template <typename Vector>
Vector unit(Scene& scene, const std::string& key, const Vector& given) {
    const double length = given.stableNorm();
    if (!(length > 0.0)) {
        refuse(scene, key, fmt::format("{} is zero; give one that has a direction", key));
    }
    // A quotient of doubles has a squared length within 5 ulp of 1.
    constexpr double rounding = 1.2e-15;
    if (std::abs(given.squaredNorm() - 1.0) <= rounding) return given;
    Vector scaled = given / given.cwiseAbs().maxCoeff();
    scaled /= scaled.norm();
    if (std::abs(length - 1.0) > 1e-12) {
        scene.notes.push_back(fmt::format("{} has length {:.6g} and was scaled to 1", key, length));
    }
    return scaled;
}

// [body]

const std::array<std::vector<std::string>, 4> ways_of_body{{
    {"body.moments_kg_m2"},
    {"body.tensor_kg_m2"},
    {"body.shape", "body.size_m", "body.mass_kg"},
    {"body.masses"},
}};

void complete_solid(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    body.given = BodySpec::Given::solid;
    if (!draft.has("body.shape")) {
        const std::string given = draft.size_m ? "body.size_m" : "body.mass_kg";
        refuse(scene, given,
               fmt::format("{} is given but body.shape is not; name the solid, as in shape = "
                           "\"box\"",
                           given));
    }

    const auto table = solids();
    const auto solid = std::find_if(table.begin(), table.end(),
                                    [&body](const Solid& row) { return row.name == body.shape; });
    if (solid == table.end()) {
        std::vector<std::string_view> names;
        for (const Solid& row : table) names.push_back(row.name);
        const std::string near = did_you_mean(body.shape, names);
        refuse(scene, "body.shape",
               fmt::format(
                   "unknown shape \"{}\"{}", echo(body.shape),
                   near.empty() ? fmt::format("; choose from: {}", fmt::join(names, ", ")) : near));
    }
    if (!draft.size_m) {
        refuse(scene, "body.shape",
               fmt::format("body.size_m is missing; give the {}'s {} in m", body.shape,
                           solid->size_meaning));
    }
    if (!draft.mass_kg) {
        refuse(scene, "body.shape", "body.mass_kg is missing; give the solid's mass in kg");
    }
    if (draft.size_m->size() != static_cast<std::size_t>(solid->n_sizes)) {
        refuse(scene, "body.size_m",
               fmt::format("body.size_m has {} {}; a {} has {}: {}", draft.size_m->size(),
                           draft.size_m->size() == 1 ? "entry" : "entries", body.shape,
                           solid->n_sizes, solid->size_meaning));
    }
    body.size_m = *draft.size_m;
    body.mass_kg = *draft.mass_kg;
    body.inertia = at_key(scene, "body.size_m", [&body] {
        return inertia_of_solid(body.shape, body.size_m, body.mass_kg);
    });
}

void complete_masses(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    body.given = BodySpec::Given::masses;
    for (std::size_t i = 0; i < draft.masses.size(); ++i) {
        for (const std::string_view leaf : {"mass_kg", "at_m"}) {
            const std::string item = fmt::format("body.masses[{}]", i);
            const std::string key = fmt::format("{}.{}", item, leaf);
            if (!draft.has(key)) {
                refuse(scene, item,
                       fmt::format("{} is missing; each mass has mass_kg and at_m", key));
            }
        }
    }
    body.masses_as_given = draft.masses;
    const MassDistribution found =
        at_key(scene, "body.masses", [&body] { return inertia_of_masses(body.masses_as_given); });
    body.inertia = found.inertia;
    body.mass_kg = found.mass_kg;
    body.centre_of_mass_m_body = found.centre_of_mass_m_body;
    body.masses = body.masses_as_given;
    for (PointMass& mass : body.masses) mass.at_m -= body.centre_of_mass_m_body;
}

void complete_body(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    refuse_mixed(scene, ways_of_body, "give the body in one way only");
    const Physicality physicality =
        body.allow_unphysical ? Physicality::waived : Physicality::required;
    if (draft.moments_kg_m2) {
        body.given = BodySpec::Given::moments;
        body.inertia = at_key(scene, "body.moments_kg_m2", [&] {
            return InertiaTensor::from_principal_moments(*draft.moments_kg_m2, physicality);
        });
    } else if (draft.tensor_kg_m2) {
        body.given = BodySpec::Given::tensor;
        body.inertia = at_key(scene, "body.tensor_kg_m2", [&] {
            return InertiaTensor::from_matrix(*draft.tensor_kg_m2, physicality);
        });
        // The average of two doubles that are equal is that double, bit for bit.
        const Eigen::Matrix3d& tensor = *draft.tensor_kg_m2;
        body.tensor_kg_m2 = 0.5 * tensor + 0.5 * tensor.transpose();
    } else if (draft.has("body.masses")) {
        complete_masses(draft);
    } else if (draft.has("body.shape") || draft.size_m || draft.mass_kg) {
        complete_solid(draft);
    } else {
        refuse(scene, "body",
               "the body is missing; under [body] give moments_kg_m2, tensor_kg_m2, shape with "
               "size_m and mass_kg, or [[body.masses]]");
    }
    if (!body.inertia.note().empty()) {
        scene.notes.push_back(fmt::format("body.tensor_kg_m2: {}", body.inertia.note()));
    }
}

// [start]

const std::vector<std::string> top_keys{"start.theta_rad", "start.theta_dot_rad_s",
                                        "start.phi_dot_rad_s", "start.omega3_rad_s"};

// The proper rotation that a matrix is, to rounding or nearly.
Eigen::Vector4d attitude_of_matrix(Scene& scene, const Eigen::Matrix3d& matrix) {
    const std::string key = "start.attitude_matrix";
    const double largest = matrix.cwiseAbs().maxCoeff();
    const double residual =
        largest > 2.0
            ? largest
            : (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (residual > 1e-6) {
        refuse(scene, key,
               fmt::format("{} is not a rotation: its columns are not unit vectors at right "
                           "angles (off by {:.2g}); give an orthogonal matrix",
                           key, residual));
    }
    if (matrix.determinant() < 0.0) {
        refuse(scene, key,
               fmt::format("{} is a reflection (determinant -1), which no rotation of a body "
                           "reaches; turn the sign of one column",
                           key));
    }
    if (residual > 1e-12) {
        scene.notes.push_back(fmt::format(
            "{} is orthogonal to {:.2g} only; a rotation near it is used", key, residual));
    }
    const Eigen::Quaterniond q = Eigen::Quaterniond(matrix).normalized();
    return {q.w(), q.x(), q.y(), q.z()};
}

// A top's start in body axes: R = Rx(θ), and ω from the rates at φ = ψ = 0.
void complete_top(SceneDraft& draft) {
    Scene& scene = draft.scene;
    if (!draft.has("start.theta_rad")) {
        const auto given = std::find_if(top_keys.begin(), top_keys.end(),
                                        [&](const std::string& key) { return draft.has(key); });
        refuse(scene, *given,
               fmt::format("{} is given but start.theta_rad is not; give the tilt at t = 0, as in "
                           "theta_rad = 0.7",
                           *given));
    }
    const TopStart& top = draft.top;
    scene.start.top = top;
    HeavyTopProblem problem;
    problem.theta_rad = top.theta_rad;
    problem.theta_dot_rad_s = top.theta_dot_rad_s;
    problem.phi_dot_rad_s = top.phi_dot_rad_s;
    problem.omega3_rad_s = top.omega3_rad_s;
    const RotationState state = start_of(problem);
    scene.start.space_from_body = state.space_from_body;
    scene.start.omega_rad_s = state.omega_body;
}

void complete_start(SceneDraft& draft) {
    Scene& scene = draft.scene;
    const std::array<std::vector<std::string>, 2> ways_of_start{{{"start.omega_rad_s"}, top_keys}};
    refuse_mixed(scene, ways_of_start,
                 "give omega_rad_s, or the Euler angles and rates of a top, not both");
    const std::array<std::vector<std::string>, 3> ways_of_attitude{
        {{"start.attitude"}, {"start.attitude_matrix"}, top_keys}};
    refuse_mixed(scene, ways_of_attitude, "give the attitude in one way only");

    const bool top = std::any_of(top_keys.begin(), top_keys.end(),
                                 [&](const std::string& key) { return draft.has(key); });
    if (top) return complete_top(draft);
    if (!draft.has("start.omega_rad_s")) {
        refuse(scene, "start",
               "start.omega_rad_s is missing; under [start] give the angular velocity at t = 0 in "
               "body axes, as in omega_rad_s = [0.01, 2.0, 0.01]");
    }
    Eigen::Vector4d attitude(1.0, 0.0, 0.0, 0.0);
    if (draft.attitude) attitude = unit(scene, "start.attitude", *draft.attitude);
    if (draft.attitude_matrix) attitude = attitude_of_matrix(scene, *draft.attitude_matrix);
    // Of q and −q, the same attitude, the one with w ≥ 0.
    if (attitude[0] < 0.0) attitude = -attitude;
    scene.start.space_from_body =
        Eigen::Quaterniond(attitude[0], attitude[1], attitude[2], attitude[3]);
}

// [torque]

struct TorqueKind {
    std::string_view name;
    std::string needed;                 // the key without which the kind means nothing
    std::vector<std::string> its_keys;  // that key, too
};

void complete_torque(SceneDraft& draft) {
    static const std::array<TorqueKind, 5> kinds{{
        {"none", "", {}},
        {"gravity", "torque.mgl_N_m", {"torque.mgl_N_m", "torque.arm_body"}},
        {"constant_body", "torque.torque_body_N_m", {"torque.torque_body_N_m"}},
        {"constant_space", "torque.torque_space_N_m", {"torque.torque_space_N_m"}},
        {"dissipation", "torque.rate_1_s", {"torque.rate_1_s"}},
    }};
    Scene& scene = draft.scene;
    for (const TorqueKind& kind : kinds) {
        if (kind.name == draft.torque_kind) {
            if (kind.needed.empty() || draft.has(kind.needed)) continue;
            refuse(scene, "torque.kind",
                   fmt::format("{} is missing; a torque of kind \"{}\" needs it", kind.needed,
                               kind.name));
        }
        for (const std::string& key : kind.its_keys) {
            if (!draft.has(key)) continue;
            refuse(scene, key,
                   fmt::format(
                       "{} belongs to kind = \"{}\", but torque.kind is {}; remove one of "
                       "them",
                       key, kind.name,
                       draft.has("torque.kind") ? "\"" + draft.torque_kind + "\"" : "not given"));
        }
    }

    if (draft.torque_kind == "gravity") {
        draft.gravity.arm_body = unit(scene, "torque.arm_body", draft.gravity.arm_body);
        scene.torque = draft.gravity;
    } else if (draft.torque_kind == "constant_body") {
        scene.torque = draft.constant_body;
    } else if (draft.torque_kind == "constant_space") {
        scene.torque = draft.constant_space;
    } else if (draft.torque_kind == "dissipation") {
        scene.torque = draft.dissipation;
    }
}

// [motion]

void check_motion(const SceneDraft& draft) {
    const Scene& scene = draft.scene;
    const MethodChoice& choice = scene.method;
    const InertiaTensor& inertia = scene.body.inertia;
    const Method& method =
        at_key(scene, "motion.method", [&]() -> const Method& { return find_method(choice.name); });
    if (!can_solve(method, inertia, scene.torque)) {
        const bool gravity = std::holds_alternative<GravityTorque>(scene.torque);
        const bool exact = method.make == nullptr;
        const std::string torque =
            gravity && exact ? "gravity on a body that is not symmetric about the arm of its weight"
                             : fmt::format("a torque of kind \"{}\"", draft.torque_kind);
        refuse(scene, draft.has("motion.method") ? "motion.method" : "torque.kind",
               fmt::format("{} has no {}; set motion.method to one of {}", torque,
                           exact ? "exact solution" : fmt::format("solution by {}", method.name),
                           methods_that_solve(inertia, scene.torque)));
    }

    // Each option by itself, so that what is wrong gets its own place.
    const MethodChoice order{choice.name, {}, {}, choice.order};
    const MethodChoice step{choice.name, choice.step_s, {}, {}};
    const MethodChoice tolerance{choice.name, {}, choice.tolerance, {}};
    at_key(scene, "motion.order", [&] { check_method(order, inertia, scene.torque); });
    at_key(scene, "motion.step_s", [&] { check_method(step, inertia, scene.torque); });
    at_key(scene, "motion.tolerance", [&] { check_method(tolerance, inertia, scene.torque); });
}

// [film]

// A scene cannot ask for more frames than a disk holds.
void check_film(const Scene& scene) {
    const FilmSpec& film = scene.film;
    constexpr double most_frames = 1e7;
    const double duration_s = film.duration_s.value_or(default_film_s * film.speed);
    const double n_frames = duration_s / film.speed * static_cast<double>(film.fps_numerator) /
                            static_cast<double>(film.fps_denominator);
    if (!(n_frames <= most_frames) || !std::isfinite(film.start_s + duration_s)) {
        refuse(scene, "film.duration_s",
               fmt::format("the film would have {:.3g} frames; a film has at most {:.0g}, so "
                           "shorten film.duration_s or raise film.speed",
                           n_frames, most_frames));
    }
}

// [grid] and [[panels]]

// A grid that was not given has as many equal cells as the panels reach.
void complete_grid(SceneDraft& draft) {
    Scene& scene = draft.scene;
    const auto extend = [&](const std::string& key, std::vector<double>& sizes, int PanelSpec::*at,
                            int PanelSpec::*span) {
        for (std::size_t i = 0; i < scene.panels.size(); ++i) {
            const int end = scene.panels[i].*at + scene.panels[i].*span;
            if (end <= static_cast<int>(sizes.size())) continue;
            if (draft.has(key)) {
                refuse(scene, fmt::format("panels[{}]", i),
                       fmt::format("panels[{}] reaches to cell {} of {}, which has {}; move it or "
                                   "extend the grid",
                                   i, end, key, sizes.size()));
            }
            sizes.resize(static_cast<std::size_t>(end), 1.0);
        }
    };
    extend("grid.columns", scene.grid.columns, &PanelSpec::column, &PanelSpec::columns);
    extend("grid.rows", scene.grid.rows, &PanelSpec::row, &PanelSpec::rows);

    for (std::size_t j = 1; j < scene.panels.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            const PanelSpec& a = scene.panels[i];
            const PanelSpec& b = scene.panels[j];
            const bool apart = a.column + a.columns <= b.column ||
                               b.column + b.columns <= a.column || a.row + a.rows <= b.row ||
                               b.row + b.rows <= a.row;
            if (apart) continue;
            refuse(scene, fmt::format("panels[{}]", j),
                   fmt::format("panels[{}] covers a cell of panels[{}]; give each panel cells of "
                               "its own by column and row",
                               j, i));
        }
    }
}

}  // namespace

Scene complete_scene(SceneDraft draft) {
    complete_body(draft);
    complete_start(draft);
    complete_torque(draft);
    check_motion(draft);
    check_film(draft.scene);
    complete_grid(draft);
    return std::move(draft.scene);
}

}  // namespace poinsot
