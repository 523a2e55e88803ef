// Keys of the events of the film (keyframes, fades, captions, chapters and stops) and of its page.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error/error.h"
#include "scene/camera_views.h"
#include "scene/easing.h"
#include "scene/scene_error.h"
#include "scene/scene_key_rows.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr double most_film_s = 1e7;
constexpr Bounds film_seconds = within(0.0, most_film_s);

constexpr std::array<std::string_view, 2> caption_places{"bottom", "top"};

template <typename Value>
constexpr auto keyframe(Value KeyframeSpec::*member) {
    return in(&Scene::keyframes, member);
}
template <typename Value>
constexpr auto fade(Value FadeSpec::*member) {
    return in(&Scene::fades, member);
}
template <typename Value>
constexpr auto stop(Value StopSpec::*member) {
    return in(&Scene::stops, member);
}
template <typename Value>
constexpr auto timed_caption(Value TimedCaptionSpec::*member) {
    return in(&Scene::captions, member);
}

// Whether a slider, a field or a choice can hold the values of a key.
bool is_controllable(const ValueType& type) {
    const bool is_list = type.size && type.size->least != type.size->most;
    const bool is_text = type.kind == ValueType::Kind::text;
    return !is_list && type.n_rows == 0 && (!is_text || (!type.names.empty() && !type.size));
}

// Throws InputError for a name that is no page in the same folder.
void check_page_name(std::string_view name) {
    if (name.empty()) return;
    constexpr std::string_view suffix = ".html";
    const bool is_page = name.size() > suffix.size() && name.ends_with(suffix) &&
                         name.front() != '.' && name.size() <= 255;
    const bool is_plain = std::none_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f ||
               std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
    });
    if (!is_page || !is_plain)
        throw InputError(
            fmt::format("\"{}\" is no page in the same folder; give the name of its "
                        "file without a folder, as in \"sphere.html\"",
                        printable(name)));
}

// Throws SceneError for a name that is no key, or whose values no control can hold.
void read_controls(const GivenValue& given, SceneDraft& draft) {
    std::vector<std::string> controls = given.texts();
    for (std::size_t i = 0; i < controls.size(); ++i) {
        // An item of a list on the command line has no place of its own.
        const bool has_place = i < given.value().items.size();
        const SourceLocation& where =
            has_place ? given.value().items[i].where : given.value().where;
        const std::string is =
            fmt::format("{}[{}] is \"{}\"", given.name(), i, printable(controls[i]));
        const SceneKey* const key = find_scene_key(path_of_assignment(controls[i]));
        if (key == nullptr)
            throw SceneError(where, fmt::format("{}, which is no key{}", is,
                                                scene_key_remedy(controls[i], false)));
        if (!is_controllable(key->type))
            throw SceneError(where,
                             fmt::format("{}, which takes {}; name a key that takes numbers, "
                                         "true and false, or one of a few names",
                                         is, key->type.words()));
    }
    draft.scene.page.controls = std::move(controls);
}

}  // namespace

std::span<const SceneKey> story_keys() {
    using namespace key_rows;
    static const SceneKey rows[] = {
        // Keyframes: movements of the camera and changes of the speed.
        number("keyframes[].at_s", keyframe(&KeyframeSpec::at_s), film_seconds, "s", "3.0",
               "time of the keyframe, in seconds of film")
            .without_default(),
        text("keyframes[].easing", keyframe(&KeyframeSpec::easing), R"("smooth")",
             "how each value changes on the way from the previous keyframe that sets it")
            .from_list("easings")
            .checked_by(easing_named),
        text(
            "keyframes[].view", keyframe(&KeyframeSpec::view), R"("front")",
            "named view, which gives the azimuth, elevation, distance, field of view and aim "
            "unless "
            "this keyframe gives them itself; like all values of keyframes they hold until a later "
            "keyframe changes them (\"lecture\" leads back to the usual view)")
            .from_list("views")
            .checked_by(camera_view_named),
        integer("keyframes[].panel", keyframe(&KeyframeSpec::panel), within(0, 999), "0",
                "index in [[panels]], from 0, of the panel whose camera moves")
            .default_is("all panels that use [camera]"),
        number("keyframes[].azimuth_deg", keyframe(&KeyframeSpec::azimuth_deg),
               within(-36000.0, 36000.0), "degrees", "30.0",
               "as in [camera]; more than 360 turns the camera more than once"),
        number("keyframes[].elevation_deg", keyframe(&KeyframeSpec::elevation_deg), elevations_deg,
               "degrees", "35.0", "as in [camera]"),
        number("keyframes[].distance", keyframe(&KeyframeSpec::distance), distances,
               "units of the largest half-axis", "4.0", "as in [camera]"),
        number("keyframes[].field_deg", keyframe(&KeyframeSpec::field_deg), fields_deg, "degrees",
               "20.0", "as in [camera]"),
        numbers("keyframes[].target", keyframe(&KeyframeSpec::target), coordinates,
                "units of the largest half-axis", "[0.0, 0.0, 0.5]", "as in [camera]"),
        one_of("keyframes[].look_at", keyframe(&KeyframeSpec::look_at), camera_aims(),
               R"("centre")", "as in [camera]"),
        number("keyframes[].speed", keyframe(&KeyframeSpec::speed), within(0.0, 1e12), "", "0.2",
               "seconds of motion per second of film; 0 stops the motion"),

        // Fades.
        number("fades[].at_s", fade(&FadeSpec::at_s), film_seconds, "s", "2.0",
               "start of the fade, in seconds of film")
            .without_default(),
        number("fades[].over_s", fade(&FadeSpec::over_s), film_seconds, "s", "1.0",
               "duration of the fade, in seconds of film"),
        text("fades[].easing", fade(&FadeSpec::easing), R"("smooth")",
             "how the opacity changes during the fade")
            .from_list("easings")
            .checked_by(easing_named),
        texts("fades[].elements", fade(&FadeSpec::elements), R"(["plane", "momentum"])",
              "elements, overlays or kinds of panels that fade; an element that fades in is "
              "invisible before the fade")
            .without_default(),
        number("fades[].opacity", fade(&FadeSpec::opacity), within(0.0, 1.0), "", "1.0",
               "opacity at the end of the fade: 1 is opaque, 0 is invisible"),

        // Captions.
        number("captions[].at_s", timed_caption(&TimedCaptionSpec::at_s), film_seconds, "s", "4.0",
               "time at which the caption appears, in seconds of film")
            .without_default(),
        number("captions[].over_s", timed_caption(&TimedCaptionSpec::over_s),
               within(0.1, most_film_s), "s", "3.0", "duration of the caption, in seconds of film")
            .default_is("until the next caption in the same place, or the end"),
        text("captions[].text", timed_caption(&TimedCaptionSpec::text), R"("L stays; ω does not.")",
             "text of the caption; may contain live numbers, like the scene's caption")
            .without_default(),
        one_of("captions[].place", timed_caption(&TimedCaptionSpec::place), caption_places,
               R"("top")", "bottom (above the scene's caption) or top (below the scene's title)")
            .omitted_if_default(),

        // Chapters.
        number("chapters[].at_s", in(&Scene::chapters, &ChapterSpec::at_s), film_seconds, "s",
               "0.0", "start of the chapter, in seconds of film")
            .without_default(),
        text("chapters[].title", in(&Scene::chapters, &ChapterSpec::title),
             R"("The invariable plane")", "title of the chapter")
            .without_default(),

        // Stops.
        number("stops[].at_s", stop(&StopSpec::at_s), film_seconds, "s", "4.0",
               "time at which a page waits for its viewer, in seconds of film")
            .without_default(),
        text("stops[].title", stop(&StopSpec::title), R"("Which axis is unstable?")",
             "title of the stop"),
        number("stops[].loop_s", stop(&StopSpec::loop_s), positive, "s", "2.0",
               "the page repeats this many seconds of film before the stop while it waits; it goes "
               "on from the stop, at the end of a repetition")
            .default_is("the page stands still"),
        text("stops[].note", stop(&StopSpec::note), R"("Ask before you go on.")",
             "note for the lecturer, shown in a window of its own"),
        number("stops[].planned_s", stop(&StopSpec::planned_s), film_seconds, "s", "90.0",
               "planned time at which the lecturer begins with this stop, in seconds of the "
               "lecture; the notes show it beside the elapsed time")
            .default_is("none"),

        // The page.
        texts("page.controls", in(&Scene::page, &PageSpec::controls), R"(["start.omega_rad_s"])",
              "keys of this scene that the viewers of a page can change; each takes numbers, true "
              "and false, or one of a few names")
            .read_by(read_controls)
            .default_is(
                "start.omega_rad_s and body.moments_kg_m2 of a free motion that gives them"),
        texts("page.elements", in(&Scene::page, &PageSpec::elements), R"(["plane", "momentum"])",
              "elements and overlays that the viewers of a page can show and hide")
            .from_list("elements")
            .default_is("all"),
        text("page.next", in(&Scene::page, &PageSpec::next), R"("sphere.html")",
             "file of the page that follows, in the same folder; at the end of the film a button "
             "and Page Down lead to it")
            .checked_by(check_page_name)
            .default_is("none"),
        number("page.planned_s", in(&Scene::page, &PageSpec::planned_s), film_seconds, "s", "240.0",
               "planned time for this scene, in seconds of the lecture; in a page of several "
               "scenes, the notes add it to the planned times of the scenes that follow")
            .default_is("0"),
    };
    return rows;
}

}  // namespace poinsot
