// What a page must know of a scene for its controls, as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "construction/flips.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"
#include "mechanics/regime_sentence.h"
#include "production/session/motion_hints.h"
#include "scene/scene_keys.h"
#include "text/json_text.h"
#include "text/numbers.h"
#include "typeset/plain_text.h"
#include "web/module/live_scene.h"

namespace poinsot {

namespace {

// The flips of a body that turns over: one instant, and the time between two unless there is one
// flip alone, both in seconds of the motion; of a motion under a torque the instants within the
// film, `times_s`. Null for any other motion.
std::string flips_text(const Motion& motion, const FilmPlan& film) {
    const MotionProblem& problem = motion.problem();
    if (!is_free(problem.torque)) {
        if (motion.heavy_top() != nullptr) return "null";
        const auto [first_s, last_s] = std::minmax({film.start_s, film.last_time_s()});
        const auto times = sampled_flips(motion, first_s, last_s);
        if (!times || times->empty()) return "null";
        std::vector<std::string> numbers;
        numbers.reserve(times->size());
        for (const double time_s : *times) numbers.push_back(json_number(time_s));
        return JsonObject()
            .add("one_s", times->front())
            .json("interval_s", "null")
            .json("times_s", json_list(numbers))
            .line();
    }
    const auto flips = flips_of(problem, motion.free_constants());
    if (!flips) return "null";
    return JsonObject()
        .add("one_s", flips->one_s)
        .json("interval_s", flips->interval_s ? json_number(*flips->interval_s) : "null")
        .line();
}

// The axis about which the polhode goes: that of the "smallest" or the "largest" moment; null for
// any other motion.
std::string polhode_axis_text(const Motion& motion) {
    switch (motion.regime()) {
        case Regime::elliptic_about_lowest:
            return json_string("smallest");
        case Regime::elliptic_about_highest:
            return json_string("largest");
        default:
            return "null";
    }
}

// Whether viewers may drag the tip of ω, and the plane.
std::string drags_text(const Scene& scene) {
    const std::vector<std::string> controls = controls_of(scene);
    const auto has = [&controls](std::string_view key) {
        return std::find(controls.begin(), controls.end(), key) != controls.end();
    };
    // With |L| given, the plane's distance is the energy alone.
    const ConservedStartSpec* conserved = scene.start.given_by_conserved();
    const bool omega = has("start.omega_rad_s");
    const bool plane = omega || (has("start.energy_J") && conserved != nullptr &&
                                 conserved->quantities.momentum_kg_m2_s.has_value());
    return JsonObject().add("omega", omega).add("plane", plane).line();
}

std::string elements_of(const Stage& stage) {
    std::vector<std::string> items;
    const auto& panels = stage.panels();
    const bool has_space = std::any_of(panels.begin(), panels.end(), [](const Panel& panel) {
        return panel.spec.kind == "space";
    });
    if (!has_space) return "[]";
    const Scene& scene = stage.context().scene;
    const auto offered = [&scene](std::string_view name) {
        const auto& names = scene.page.elements;
        return !names || std::find(names->begin(), names->end(), name) != names->end();
    };
    const auto add = [&](const auto& row, bool is_overlay_row, bool shown) {
        items.push_back(JsonObject()
                            .add("name", row.name)
                            .add("summary", row.summary)
                            .add("overlay", is_overlay_row)
                            .add("offered", offered(row.name))
                            .add("shown", shown)
                            .line());
    };
    for (const Element& element : elements())
        add(element, false, is_shown(stage.context(), element.name));
    for (const OverlayName& overlay : overlays())
        add(overlay, true,
            scene.overlays && (scene.show.empty() || std::find(scene.show.begin(), scene.show.end(),
                                                               overlay.name) != scene.show.end()));
    return json_list(items);
}

// The index in an item of an array of tables: 0 for "body.masses[0].mass_kg" and for keys without.
std::size_t item_of(const std::string& key) {
    const std::size_t open = key.find('[');
    const auto index = open == std::string::npos
                           ? std::nullopt
                           : number_of<std::int64_t>(std::string_view(key).substr(
                                 open + 1, std::max(key.find(']', open), open + 1) - open - 1));
    return index ? static_cast<std::size_t>(*index) : 0;
}

// A key that viewers may change, with its value: TOML writes numbers, lists, booleans and names as
// JSON does.
std::string control_of(const Scene& scene, const std::string& name) {
    const SceneKey& key = *find_scene_key(path_of_assignment(name));
    const ValueType& type = key.type;
    std::string value = key.value ? key.value(scene, item_of(name)) : "";
    if (value.empty()) value = std::string(key.example);
    const bool is_list = type.size.has_value();
    const bool is_choice = type.kind == ValueType::Kind::text;
    const std::string kind = is_choice                               ? "choice"
                             : type.kind == ValueType::Kind::boolean ? "boolean"
                             : is_list                               ? "vector"
                             : type.kind == ValueType::Kind::integer ? "integer"
                                                                     : "number";
    JsonObject control;
    control.add("key", name)
        .add("label", key.summary)
        .add("unit", type.unit)
        .add("kind", kind)
        .json("min", type.bounds.least ? json_number(*type.bounds.least) : "null")
        .json("max", type.bounds.most ? json_number(*type.bounds.most) : "null")
        .json("step", type.kind == ValueType::Kind::integer ? "1" : "null")
        .json("value", value);
    if (is_choice) {
        std::vector<std::string> choices;
        for (const std::string_view choice : type.names) choices.push_back(json_string(choice));
        control.json("choices", json_list(choices));
    }
    return control.line();
}

}  // namespace

std::string LiveScene::description() const {
    const Scene& scene = session_.scene;
    const Theme& theme = session_.theme;
    std::vector<std::string> notes, chapters;
    for (const auto* from : {&scene.notes, &session_.notes})
        for (const std::string& note : *from) notes.push_back(json_string(note));
    for (const std::string& note : stage_->notes()) notes.push_back(json_string(note));
    for (const ChapterSpec& chapter : scene.chapters)
        chapters.push_back(
            JsonObject().add("at_s", chapter.at_s).add("title", chapter.title).line());
    std::vector<std::string> stops, controls;
    for (const StopSpec& stop : scene.stops)
        stops.push_back(
            JsonObject()
                .add("at_s", stop.at_s)
                .add("title", stop.title)
                .json("loop_s", stop.loop_s ? json_number(*stop.loop_s) : "null")
                .add("note", stop.note)
                .json("planned_s", stop.planned_s ? json_number(*stop.planned_s) : "null")
                .line());
    for (const std::string& key : controls_of(scene)) controls.push_back(control_of(scene, key));
    // A loop goes on until it meets its beginning.
    const double last_s =
        film_.repeat_s > 0.0 ? film_.clock.time_at(film_.length_s) : film_.last_time_s();
    // A film that waits at stops is seen from its beginning; any other opens as its still, with its
    // curves drawn.
    const double opens_at_s = scene.stops.empty() && scene.film.still_s
                                  ? film_.clock.film_second_of(*scene.film.still_s).value_or(0.0)
                                  : 0.0;
    return JsonObject()
        .add("title", plain_text(scene.title))
        .add("caption", plain_text(scene.caption))
        .add("language", scene.language)
        .json("theme", JsonObject()
                           .add("name", theme.name)
                           .add("background", hex_text(theme.background.bottom))
                           .add("text", hex_text(theme.text))
                           .line())
        .add("first_time_s", film_.time_of(0))
        .add("last_time_s", last_s)
        .add("film_length_s", film_.length_s)
        .add("opens_at_s", opens_at_s)
        .add("loops", film_.repeat_s > 0.0)
        .add("frames_per_s", film_.rate.per_second())
        .add("width", scene.film.width_px)
        .add("height", scene.film.height_px)
        .add("film_width", film_size_.width_px)
        .add("film_height", film_size_.height_px)
        .add("motion", motion_in_words(session_.motion))
        .add("regime", regime_sentence(session_.motion))
        .json("flips", flips_text(session_.motion, film_))
        .json("polhode_axis", polhode_axis_text(session_.motion))
        .json("drags", drags_text(scene))
        .add("next", scene.page.next)
        .json("notes", json_list(notes))
        .json("panels", panels_text())
        .json("chapters", json_list(chapters))
        .json("stops", json_list(stops))
        .json("controls", json_list(controls))
        .json("elements", elements_of(*stage_))
        .line();
}

}  // namespace poinsot
