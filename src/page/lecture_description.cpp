// What a page must know of a scene for its controls, as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/panel.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"
#include "page/lecture.h"
#include "production/session/scene_summary.h"
#include "text/json_text.h"
#include "typeset/plain_text.h"

namespace poinsot {

namespace {

std::string hex(const Colour& colour) {
    const auto level = [](double share) {
        return static_cast<int>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", level(colour.r), level(colour.g), level(colour.b));
}

std::string elements_of(const Stage& stage) {
    std::vector<std::string> items;
    const auto& panels = stage.panels();
    const bool has_space = std::any_of(panels.begin(), panels.end(), [](const Panel& panel) {
        return panel.spec.kind == "space";
    });
    if (!has_space) return "[]";
    for (const Element& element : elements())
        items.push_back(JsonObject()
                            .add("name", element.name)
                            .add("summary", element.summary)
                            .add("shown", is_shown(stage.context(), element.name))
                            .line());
    return json_list(items);
}

}  // namespace

std::string Lecture::description() const {
    const Scene& scene = session_.scene;
    const Theme& theme = session_.theme;
    std::vector<std::string> notes, chapters, captions;
    for (const auto* from : {&scene.notes, &session_.notes})
        for (const std::string& note : *from) notes.push_back(json_string(note));
    for (const std::string& note : stage_->notes()) notes.push_back(json_string(note));
    for (const ChapterSpec& chapter : scene.chapters)
        chapters.push_back(JsonObject().add("at_s", chapter.at_s).add("title", chapter.title).line());
    for (const TimedCaptionSpec& caption : scene.captions)
        captions.push_back(
            JsonObject().add("at_s", caption.at_s).add("text", plain_text(caption.text)).line());
    // A loop goes on until it meets its beginning.
    const double last_s =
        film_.loop_s > 0.0 ? film_.clock.time_at(film_.length_s) : film_.last_time_s();
    return JsonObject()
        .add("title", plain_text(scene.title))
        .add("caption", plain_text(scene.caption))
        .add("language", scene.language)
        .json("theme", JsonObject()
                           .add("name", theme.name)
                           .add("background", hex(theme.background.bottom))
                           .add("text", hex(theme.text))
                           .line())
        .add("first_time_s", film_.time_of(0))
        .add("last_time_s", last_s)
        .add("film_length_s", film_.length_s)
        .add("loops", film_.loop_s > 0.0)
        .add("frames_per_s", film_.rate.per_second())
        .add("playback_speed", scene.film.speed)
        .add("width", scene.film.width_px)
        .add("height", scene.film.height_px)
        .add("regime", regime_sentence(session_))
        .json("notes", json_list(notes))
        .json("panels", panels_text())
        .json("chapters", json_list(chapters))
        .json("stops", "[]")
        .json("controls", "[]")
        .json("elements", elements_of(*stage_))
        .json("captions", json_list(captions))
        .line();
}

}  // namespace poinsot
