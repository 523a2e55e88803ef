#include "production/session/picture_setting.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "drawing/stage/label_requests.h"
#include "drawing/stage/stage_store.h"
#include "drawing/style/picture_quality.h"
#include "mechanics/torque_kinds.h"
#include "scene/scene_error.h"
#include "text/printable.h"

namespace poinsot {

PictureSpan whole_film(const FilmPlan& film) {
    return {.first_time_s = film.time_of(0), .last_time_s = film.last_time_s()};
}

PictureSpan span_of_instant(const Session& session, const FilmPlan& film, double time_s) {
    const TrailSpec& trail = session.scene.trail;
    PictureSpan span{.first_time_s = std::min(film.start_s, time_s),
                     .last_time_s = time_s,
                     .first_shown_s = time_s};
    // A polhode is one closed curve without a film, but for a body that loses energy.
    const bool is_whole = trail.herpolhode == "whole" || trail.axis == "whole" ||
                          (trail.polhode == "whole" && dissipates(session.motion.problem().torque));
    if (is_whole) span.last_time_s = std::max(time_s, film.last_time_s());
    return span;
}

PictureSetting setting_of(const Scene& scene, const PrintChoices& print) {
    // Returned as a pointer: g++ 14 warns that a reference may dangle.
    const PictureQuality& quality = *at_scene_key(
        scene, "film.quality", [&scene] { return &picture_quality_named(scene.film.quality); });
    const auto paper = print_size_of(print, scene.film.width_px, scene.film.height_px);
    PictureSetting setting{.curve_tolerance = quality.curve_tolerance, .samples = quality.samples};
    if (paper) setting.put_on(*paper);
    return setting;
}

Stage stage_of(const Session& session, const PictureSpan& span, const PictureSetting& setting) {
    StageOptions options;
    options.width_px = session.scene.film.width_px * setting.samples;
    options.height_px = session.scene.film.height_px * setting.samples;
    options.samples = setting.samples;
    options.line_scale = setting.line_scale * setting.samples;
    options.px_per_pt = setting.px_per_pt * setting.samples;
    options.least = setting.least.times(setting.samples);
    options.first_time_s = span.first_time_s;
    options.last_time_s = span.last_time_s;
    options.views = setting.views;
    options.fonts = session.fonts;
    options.first_shown_s = span.first_shown_s;
    options.is_still = span.is_still;
    options.repeat_s = session.loop ? session.loop->repeat_s : 0.0;
    // In pixels of the rendered picture, which is `samples` times as large as the final one.
    options.curve_px = session.accuracy.curve_px(setting.curve_tolerance * setting.samples);
    return at_key_of_error(session.scene, "motion", "film", [&] {
        return Stage(session.scene, session.theme, session.motion, options,
                     session.comparison ? &*session.comparison : nullptr);
    });
}

void tell_stage_notes(const Stage& stage, const Task& task) {
    for (const std::string& note : stage.notes()) task.say("note: " + note);
    const std::vector<char32_t>& missing = stage.store().text().typesetter().missing();
    if (missing.empty()) return;
    task.say(
        fmt::format("note: no installed font has {}: drawn as boxes; install a font that has them, "
                    "as fonts-noto or fonts-dejavu",
                    listed(missing)));
}

void tell_unnamed(const Stage& stage, std::span<const FilmTime> moments, const Task& task) {
    std::set<std::string_view> no_room, out_of_sight, named;
    for (const FilmTime& moment : moments) {
        const Drawing drawing = stage.at(moment);
        for (const UnnamedThing& thing : drawing.unnamed)
            (thing.is_in_sight ? no_room : out_of_sight).insert(thing.name);
        for (const View& view : drawing.views)
            for (const Label& label : view.labels) named.insert(name_of_label(label.name));
    }
    std::erase_if(no_room, [&](std::string_view name) { return named.contains(name); });
    std::erase_if(out_of_sight, [&](std::string_view name) {
        return named.contains(name) || no_room.contains(name);
    });
    if (!no_room.empty())
        task.say(
            fmt::format("note: no room for the name of {}: make the picture larger or the camera "
                        "nearer, or say in `names` which names to show",
                        fmt::join(no_room, ", ")));
    if (!out_of_sight.empty())
        task.say(fmt::format(
            "note: no name for {}, of which too little is in sight: choose another {}camera, or "
            "say in `names` which names to show",
            fmt::join(out_of_sight, ", "), moments.size() == 1 ? "instant or " : ""));
}

PictureBound bound_of(const Session& session, const Stage& stage, int samples) {
    return {motion_error_px(session),
            stage.curve_error_px() / samples,
            {stage.notes().begin(), stage.notes().end()}};
}

std::string in_words(const PictureBound& bound, double accuracy_px) {
    std::string words = fmt::format(
        "within {:.2g} px of the truth (motion {:.2g} px, curves {:.2g} px; {:g} px "
        "asked)",
        bound.total_px(), bound.motion_px, bound.curves_px, accuracy_px);
    for (const std::string& note : bound.notes) words += "; " + note;
    return words;
}

PreparedPicture::PreparedPicture(const Session& session, const PictureSpan& span,
                                 const PictureSetting& setting)
    : samples(setting.samples),
      stage(stage_of(session, span, setting)),
      bound(bound_of(session, stage, samples)) {}

PreparedPicture::PreparedPicture(const Session& session, const PictureSpan& span,
                                 const PrintChoices& print)
    : PreparedPicture(session, span, setting_of(session.scene, print)) {}

}  // namespace poinsot
