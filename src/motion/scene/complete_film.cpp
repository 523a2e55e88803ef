// [film], [camera] and the events of the film: keyframes, fades and chapters.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera_views.h"
#include "scene/draft_checks.h"
#include "scene/film_clock.h"
#include "scene/scene_keys.h"

namespace poinsot {

namespace {

std::string item_name(std::string_view array, std::size_t i) {
    return fmt::format("{}[{}]", array, i);
}

// Requires these keys in each item, and items in order of time.
template <typename Item>
void need_items(const SceneDraft& draft, std::string_view array, const std::vector<Item>& items,
                std::initializer_list<std::string_view> keys) {
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const std::string_view key : keys) {
            const std::string name = fmt::format("{}.{}", item_name(array, i), key);
            if (!draft.has(name))
                refuse(draft.scene, item_name(array, i),
                       fmt::format("{} is missing; give it", name));
        }
    for (std::size_t i = 1; i < items.size(); ++i)
        if (items[i].at_s < items[i - 1].at_s)
            refuse(draft.scene, item_name(array, i) + ".at_s",
                   fmt::format("{}.at_s is {}, before the {} s of {}; put them in order of time",
                               item_name(array, i), items[i].at_s, items[i - 1].at_s,
                               item_name(array, i - 1)));
}

// Requires a time within the film; the length of a loop is known only with its motion.
void need_within_film(const Scene& scene, const std::string& item, double at_s, double length_s,
                      bool is_within, std::string_view remedy) {
    if (is_within || !scene.film.loop.empty()) return;
    refuse(scene, item + ".at_s",
           fmt::format("{}.at_s is {}, but the film ends at {:.6g} s; {}", item, at_s, length_s,
                       remedy));
}

// A camera aims at a point or at a thing.
void need_one_aim(const Scene& scene, const std::string& camera, bool target, bool look_at) {
    if (target && look_at)
        refuse(scene, camera + ".target",
               fmt::format("{0}.target contradicts {0}.look_at; give one of them", camera));
}

// Fills the values that a keyframe does not give from its view.
void apply_view(KeyframeSpec& key) {
    if (key.view.empty()) return;
    const CameraView& view = camera_view_named(key.view);
    if (!key.azimuth_deg) key.azimuth_deg = view.azimuth_deg;
    if (!key.elevation_deg) key.elevation_deg = view.elevation_deg;
    if (!key.distance) key.distance = view.distance;
    if (!key.field_deg) key.field_deg = view.field_deg;
    if (!key.target && key.look_at.empty()) key.look_at = view.look_at;
}

// The names of a keyframe's values, so that none is given twice at one instant.
std::vector<std::string_view> values_of(const KeyframeSpec& key) {
    std::vector<std::string_view> names;
    if (key.azimuth_deg) names.emplace_back("azimuth_deg");
    if (key.elevation_deg) names.emplace_back("elevation_deg");
    if (key.distance) names.emplace_back("distance");
    if (key.field_deg) names.emplace_back("field_deg");
    if (key.target || !key.look_at.empty()) names.emplace_back("target");
    if (key.speed) names.emplace_back("speed");
    return names;
}

bool holds(const std::vector<std::string_view>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void check_keyframes(SceneDraft& draft) {
    Scene& scene = draft.scene;
    need_items(draft, "keyframes", scene.keyframes, {"at_s"});
    for (std::size_t i = 0; i < scene.keyframes.size(); ++i) {
        KeyframeSpec& key = scene.keyframes[i];
        const std::string item = item_name("keyframes", i);
        need_one_aim(scene, item, key.target.has_value(), draft.has(item + ".look_at"));
        apply_view(key);
        const auto names = values_of(key);
        if (names.empty()) {
            refuse(scene, item,
                   fmt::format("{} sets nothing; give a view, a value of the camera, or the speed",
                               item));
        }
        const auto n_panels = static_cast<int>(std::max<std::size_t>(1, scene.panels.size()));
        if (key.panel.value_or(0) >= n_panels)
            refuse(scene, item + ".panel",
                   fmt::format("{}.panel is {}, but the scene has {}, counted from 0; name one of "
                               "those",
                               item, *key.panel,
                               n_panels == 1 ? "one panel" : fmt::format("{} panels", n_panels)));
        for (std::size_t j = 0; j < i; ++j) {
            if (scene.keyframes[j].at_s != key.at_s) continue;
            const bool other_camera = scene.keyframes[j].panel != key.panel;
            for (const std::string_view name : values_of(scene.keyframes[j])) {
                if (!holds(names, name) || (other_camera && name != "speed")) continue;
                refuse(scene, item + ".at_s",
                       fmt::format("{} and {} both set the {} at {} s; remove one of them",
                                   item_name("keyframes", j), item, name, key.at_s));
            }
        }
    }
}

void check_fades(const SceneDraft& draft) {
    const Scene& scene = draft.scene;
    need_items(draft, "fades", scene.fades, {"at_s", "elements"});
    for (std::size_t i = 0; i < scene.fades.size(); ++i) {
        const std::string item = item_name("fades", i);
        if (scene.fades[i].elements.empty()) {
            refuse(scene, item + ".elements",
                   fmt::format("{}.elements is empty; name what fades, as in [\"plane\"]", item));
        }
        for (const std::string& name : scene.fades[i].elements) {
            for (std::size_t j = 0; j < i; ++j) {
                const FadeSpec& before = scene.fades[j];
                const bool same = std::find(before.elements.begin(), before.elements.end(), name) !=
                                  before.elements.end();
                const double end_s = before.at_s + before.over_s;
                if (!same || end_s <= scene.fades[i].at_s) continue;
                refuse(scene, item + ".at_s",
                       fmt::format("{} begins at {} s, while {} still fades \"{}\" until {} s; let "
                                   "one end before the next",
                                   item, scene.fades[i].at_s, item_name("fades", j),
                                   printable(name), end_s));
            }
        }
    }
}

void check_chapters(const SceneDraft& draft, double length_s) {
    const Scene& scene = draft.scene;
    need_items(draft, "chapters", scene.chapters, {"at_s", "title"});
    for (std::size_t i = 0; i < scene.chapters.size(); ++i) {
        const std::string item = item_name("chapters", i);
        const double at_s = scene.chapters[i].at_s;
        if (i > 0 && scene.chapters[i - 1].at_s == at_s) {
            refuse(scene, item + ".at_s",
                   fmt::format("{} begins with {}, at {} s; let each last a while", item,
                               item_name("chapters", i - 1), at_s));
        }
        need_within_film(scene, item, at_s, length_s, at_s < length_s, "begin it earlier");
    }
}

// Stops are a frame apart, within the film; a loop lies between its stop and the one before.
void check_stops(const SceneDraft& draft, double length_s) {
    const Scene& scene = draft.scene;
    need_items(draft, "stops", scene.stops, {"at_s"});
    const double frame_s = static_cast<double>(scene.film.fps_denominator) /
                           static_cast<double>(scene.film.fps_numerator);
    // Of decimal numbers such as 0.1 and 0.4 at 10 frames a second.
    constexpr double rounding = 1e-9;
    for (std::size_t i = 0; i < scene.stops.size(); ++i) {
        const StopSpec& stop = scene.stops[i];
        const std::string item = item_name("stops", i);
        const double since_s = i == 0 ? 0.0 : scene.stops[i - 1].at_s;
        const double apart_s = stop.at_s - since_s;
        if (i > 0 && apart_s == 0.0)
            refuse(scene, item + ".at_s",
                   fmt::format("{} and {} are both at {} s; remove one of them",
                               item_name("stops", i - 1), item, stop.at_s));
        if (i > 0 && apart_s < frame_s * (1.0 - rounding))
            refuse(scene, item + ".at_s",
                   fmt::format("{} is {:.3g} s after {}, less than a frame ({:.3g} s); move one of "
                               "them",
                               item, apart_s, item_name("stops", i - 1), frame_s));
        need_within_film(scene, item, stop.at_s, length_s, stop.at_s <= length_s, "put it earlier");
        if (stop.loop_s.value_or(frame_s) < frame_s * (1.0 - rounding))
            refuse(
                scene, item + ".loop_s",
                fmt::format("{}.loop_s is {}, less than a frame ({:.3g} s); make the loop longer",
                            item, *stop.loop_s, frame_s));
        if (stop.loop_s.value_or(0.0) > apart_s * (1.0 + rounding))
            refuse(scene, item + ".loop_s",
                   fmt::format("{}.loop_s is {}, but {} {:.6g} s lie before that stop; make the "
                               "loop shorter",
                               item, *stop.loop_s, i == 0 ? "only" : "since the last stop only",
                               apart_s));
    }
}

// A control of an item of an array needs that item.
void check_controls(const SceneDraft& draft) {
    const Scene& scene = draft.scene;
    if (!scene.page.controls) return;
    for (std::size_t i = 0; i < scene.page.controls->size(); ++i) {
        const std::string& control = (*scene.page.controls)[i];
        const std::string path = path_of_assignment(control);
        for (const SceneArray& array : scene_arrays()) {
            if (!path.starts_with(fmt::format("{}[]", array.path))) continue;
            const std::size_t close = control.find(']');
            if (close != std::string::npos && draft.has(control.substr(0, close + 1))) continue;
            refuse(
                scene, "page.controls",
                fmt::format("page.controls[{}] is \"{}\", but the scene has {} [[{}]], counted "
                            "from 0; give the number of one of them, as in {}[0]",
                            i, printable(control), array.n_items(scene), array.path, array.path));
        }
    }
}

// Each caption begins within the film and has a duration; those of one place do not overlap.
void check_captions(const SceneDraft& draft, double length_s) {
    const Scene& scene = draft.scene;
    need_items(draft, "captions", scene.captions, {"at_s", "text"});
    std::map<std::string, std::size_t> before;
    for (std::size_t i = 0; i < scene.captions.size(); ++i) {
        const TimedCaptionSpec& caption = scene.captions[i];
        const std::string item = item_name("captions", i);
        need_within_film(scene, item, caption.at_s, length_s, caption.at_s < length_s,
                         "begin it earlier");
        const auto last = before.find(caption.place);
        if (last != before.end()) {
            const TimedCaptionSpec& other = scene.captions[last->second];
            const double end_s = other.at_s + other.over_s.value_or(0.0);
            if (caption.at_s == other.at_s || end_s > caption.at_s)
                refuse(scene, item + ".at_s",
                       fmt::format("{} begins at {} s, while {} is still shown in the same place; "
                                   "begin it later, or put one of them at another place",
                                   item, caption.at_s, item_name("captions", last->second)));
        }
        before[caption.place] = i;
    }
}

// A loop needs a motion with a polhode.
void check_loop(SceneDraft& draft) {
    Scene& scene = draft.scene;
    FilmSpec& film = scene.film;
    const bool turns = scene.camera.motion == "co-precessing";
    const bool nothing_acts = is_free(scene.torque);
    if (turns && !nothing_acts) {
        refuse(scene, "camera.motion",
               "camera.motion is \"co-precessing\", but under a torque there is no herpolhode to "
               "turn with; set it to \"fixed\"");
    }
    if (!film.loop.empty() && !nothing_acts) {
        refuse(scene, "film.loop",
               "film.loop needs a torque-free body: under a torque no herpolhode closes; leave it "
               "out");
    }
    if (film.loop == "period" && !turns) {
        refuse(scene, "film.loop",
               "film.loop is \"period\", but after one polhode period only a co-precessing camera "
               "sees the same picture; set camera.motion to \"co-precessing\", or give film.loop "
               "as turns/periods, as in \"5/3\"");
    }
    if (!film.loop_changes.empty() && (film.loop.empty() || film.loop == "period")) {
        refuse(scene, "film.loop_changes",
               "film.loop_changes needs film.loop as turns/periods; give it, as in loop = \"5/3\"");
    }
    if (turns && film.loop.empty() && !film.duration_s && !film.length_s) film.loop = "period";
}

}  // namespace

void complete_camera(SceneDraft& draft) {
    Scene& scene = draft.scene;
    CameraSpec& camera = scene.camera;
    need_one_aim(scene, "camera", camera.target.has_value(),
                 draft.has("camera.look_at") && camera.look_at != CameraSpec{}.look_at);
    for (std::size_t i = 0; i < scene.panels.size(); ++i) {
        const PanelCameraSpec& own = scene.panels[i].camera;
        need_one_aim(scene, item_name("panels", i) + ".camera", own.target.has_value(),
                     !own.look_at.empty());
    }
    if (camera.view.empty()) return;
    const CameraView& view = camera_view_named(camera.view);
    if (!draft.has("camera.azimuth_deg")) camera.azimuth_deg = view.azimuth_deg;
    if (!draft.has("camera.elevation_deg")) camera.elevation_deg = view.elevation_deg;
    if (!draft.has("camera.distance")) camera.distance = view.distance;
    if (!draft.has("camera.field_deg")) camera.field_deg = view.field_deg;
    // A target given by the scene takes precedence over the view's aim.
    if (!draft.has("camera.look_at") && !camera.target) camera.look_at = view.look_at;
}

void complete_timeline(SceneDraft& draft) {
    check_loop(draft);
    check_keyframes(draft);
    check_fades(draft);
}

// A scene cannot have more frames than a disk can hold.
void complete_film(SceneDraft& draft) {
    const Scene& scene = draft.scene;
    const FilmSpec& film = scene.film;
    const std::array<std::vector<std::string>, 2> ways{{{"film.duration_s"}, {"film.length_s"}}};
    refuse_mixed(scene, ways,
                 "give film.duration_s (of the motion) or film.length_s (of the film), not both");

    const std::optional<double> length_s = FilmClock(scene).length_s();
    if (!length_s) {
        refuse(scene, "film.duration_s",
               fmt::format("the speed falls to 0 before {:g} s of the motion have passed; raise it "
                           "again, or give film.length_s instead of film.duration_s",
                           *film.duration_s));
    }
    constexpr double most_frames = 1e7;
    const double n_frames = *length_s * static_cast<double>(film.fps_numerator) /
                            static_cast<double>(film.fps_denominator);
    if (!(n_frames <= most_frames) || !std::isfinite(film_end_time_s(scene))) {
        refuse(scene, film.length_s ? "film.length_s" : "film.duration_s",
               fmt::format("the film would have {:.3g} frames; a film has at most {:.0g}, so "
                           "shorten {} or raise film.speed",
                           n_frames, most_frames,
                           film.length_s ? "film.length_s" : "film.duration_s"));
    }
    check_chapters(draft, *length_s);
    check_captions(draft, *length_s);
    check_stops(draft, *length_s);
    check_controls(draft);
}

}  // namespace poinsot
