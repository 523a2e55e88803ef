// Makes a complete scene from the draft: torque, method and grid; errors of mechanics/ get the
// place of the key that caused them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "error/error.h"
#include "mechanics/half_life.h"
#include "mechanics/methods.h"
#include "scene/draft_checks.h"
#include "scene/scene_error.h"
#include "scene/scene_keys.h"

namespace poinsot {

namespace {

// [torque]

// The friction for a half-life, which depends on the start.
void complete_half_life(SceneDraft& draft) {
    const Scene& scene = draft.scene;
    if (!scene.half_life_s) return;
    if (draft.has("torque.rate_1_s"))
        refuse(scene, "torque.rate_1_s",
               "torque.half_life_s and torque.rate_1_s both set the friction; leave one out");
    try {
        std::get<InternalFriction>(draft.torques).rate_1_s = friction_rate_of_half_life(
            scene.body.inertia, scene.start.omega_rad_s, *scene.half_life_s);
    } catch (const InputError& error) {
        const bool of_time = std::string_view(error.what()).starts_with("torque.half_life_s");
        throw SceneError(scene.location_of(of_time ? "torque.half_life_s" : "start.omega_rad_s"),
                         error.what());
    }
}

// Refuses keys of other kinds, and a kind without the keys that make it.
void check_torque_keys(const SceneDraft& draft, std::size_t kind) {
    std::string needed;
    bool is_made = false;
    for (const SceneKey& key : scene_keys()) {
        if (!key.torque_kind) continue;
        const std::string path(key.path);
        const bool is_given = draft.has(path);
        if (*key.torque_kind != kind && is_given)
            refuse(draft.scene, path,
                   fmt::format(
                       "{} belongs to kind = \"{}\", but torque.kind is {}; remove one of them",
                       path, torque_kinds[*key.torque_kind].key,
                       draft.has("torque.kind") ? "\"" + draft.torque_kind + "\"" : "not given"));
        if (*key.torque_kind != kind || !key.makes_torque) continue;
        is_made = is_made || is_given;
        needed += (needed.empty() ? "" : " or ") + path;
    }
    if (!is_made && !needed.empty())
        refuse(draft.scene, "torque.kind",
               fmt::format("{} is missing; a torque of kind \"{}\" needs it", needed,
                           torque_kinds[kind].key));
}

// The draft's torque of the kind with this index.
template <std::size_t... k>
Torque torque_of(const TorqueOfEachKind& torques, std::size_t kind, std::index_sequence<k...>) {
    Torque torque;
    ((k == kind ? void(torque = std::get<k>(torques)) : void()), ...);
    return torque;
}

void complete_torque(SceneDraft& draft) {
    const auto row = std::find_if(torque_kinds.begin(), torque_kinds.end(),
                                  [&](const auto& kind) { return kind.key == draft.torque_kind; });
    const std::size_t kind = static_cast<std::size_t>(row - torque_kinds.begin());
    check_torque_keys(draft, kind);
    Scene& scene = draft.scene;
    complete_half_life(draft);
    scene.torque = torque_of(draft.torques, kind, std::make_index_sequence<torque_kinds.size()>());
    if (auto* gravity = std::get_if<Gravity>(&scene.torque))
        gravity->arm_body = unit(scene, "torque.arm_body", gravity->arm_body);
}

// The methods of [motion] and [beside].

// Checks the method in a table: "motion" or "beside".
void check_method_of(const SceneDraft& draft, const std::string& table,
                     const MethodChoice& choice) {
    const Scene& scene = draft.scene;
    const InertiaTensor& inertia = scene.body.inertia;
    const std::string name = table + ".method";
    const Method& method =
        at_scene_key(scene, name, [&]() -> const Method& { return find_method(choice.name); });
    if (!can_solve(method, inertia, scene.torque)) {
        const bool gravity = has_weight(scene.torque);
        const bool exact = method.make == nullptr;
        const std::string torque =
            gravity && exact ? "gravity on a body that is not symmetric about the arm of its weight"
                             : fmt::format("a torque of kind \"{}\"", draft.torque_kind);
        refuse(scene, draft.has(name) ? name : "torque.kind",
               fmt::format("{} has no {}; set {} to one of {}", torque,
                           exact ? "exact solution" : fmt::format("solution by {}", method.name),
                           name, methods_that_solve(inertia, scene.torque)));
    }

    // Checks each option separately, so that an error gets the place of its key.
    const MethodChoice order{choice.name, {}, {}, choice.order};
    const MethodChoice step{choice.name, choice.step_s, {}, {}};
    const MethodChoice tolerance{choice.name, {}, choice.tolerance, {}};
    const auto check = [&](const char* key, const MethodChoice& option) {
        at_scene_key(scene, table + key, [&] { check_method(option, inertia, scene.torque); });
    };
    check(".order", order);
    check(".step_s", step);
    check(".tolerance", tolerance);
}

void check_motion(const SceneDraft& draft) {
    const Scene& scene = draft.scene;
    check_method_of(draft, "motion", scene.method);
    if (!scene.beside) return;
    if (!draft.has("beside.method")) {
        refuse(scene, "beside", "beside.method is missing; name the comparison method");
    }
    check_method_of(draft, "beside", *scene.beside);
}

// [grid] and [[panels]]

// A grid that is not given has as many equal cells as the panels need, up to the limit of a given
// grid.
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
            if (end > most_cells) {
                refuse(
                    scene, fmt::format("panels[{}]", i),
                    fmt::format("panels[{}] reaches to cell {} of {}, and a grid has at most {}; "
                                "move it or let it span fewer",
                                i, end, key, most_cells));
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

void complete_marks(SceneDraft& draft) {
    Scene& scene = draft.scene;
    for (std::size_t i = 0; i < scene.marks.size(); ++i) {
        const std::string item = fmt::format("marks[{}]", i);
        if (!draft.has(item + ".at"))
            refuse(
                scene, item,
                fmt::format("{}.at is missing; say where the mark is, as in at = [1, 0, 0]", item));
        if (scene.marks[i].on == "ellipsoid" && scene.marks[i].at.isZero(0.0))
            refuse(scene, item + ".at",
                   fmt::format("{}.at is zero; a mark on the ellipsoid needs a direction", item));
    }
}

Scene complete_scene(SceneDraft draft) {
    complete_body(draft);
    complete_start(draft);
    complete_torque(draft);
    check_motion(draft);
    complete_camera(draft);
    complete_timeline(draft);
    complete_film(draft);
    complete_grid(draft);
    complete_style(draft);
    complete_marks(draft);
    complete_measured(draft);
    return std::move(draft.scene);
}

}  // namespace poinsot
