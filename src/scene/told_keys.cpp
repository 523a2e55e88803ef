// Keys of the events of the film: keyframes, fades, captions and chapters.
#include <array>
#include <string>
#include <string_view>

#include "scene/camera_views.h"
#include "scene/easing.h"
#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;

constexpr double most_film_s = 1e7;

// A second of the film.
double film_second(const GivenValue& given) { return given.number_between(0.0, most_film_s); }

// The keyframe that a value belongs to.
KeyframeSpec& keyframe(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.keyframes.at(given.item());
}
FadeSpec& fade(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.fades.at(given.item());
}

TimedCaptionSpec& caption(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.captions.at(given.item());
}
constexpr std::array<std::string_view, 2> caption_places{"bottom", "top"};

const SceneKey told_rows[] = {
    // Keyframes: movements of the camera and changes of the speed.
    {"keyframes[].at_s", "a number from 0 to 1e7", "s", "3.0",
     "second of the film at which this is reached",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).at_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.keyframes.at(i).at_s); }},
    {"keyframes[].easing", "a string", "", R"("smooth")",
     "how values go here from the keyframe before that says them, see `poinsot list easings`; "
     "default smooth",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).easing = name_in_table(g, easing_named);
     },
     [](const Scene& s, size_t i) {
         return toml_text(std::string_view(s.keyframes.at(i).easing));
     }},
    {"keyframes[].view", "a string", "", R"("front")",
     "a view by name, see `poinsot list views`, for all of the camera that this keyframe does not "
     "say otherwise",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).view = name_in_table(g, camera_view_named);
     },
     [](const Scene& s, size_t i) { return text_unless_empty(s.keyframes.at(i).view); }},
    {"keyframes[].panel", "an integer from 0 to 999", "", "0",
     "the panel whose camera moves, by its place among [[panels]] from 0; default: all that are "
     "seen as [camera] says, with no camera of their own",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).panel = g.integer_between(0, 999); },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).panel); }},
    {"keyframes[].azimuth_deg", "a number from -36000 to 36000", "degrees", "30.0",
     "as in [camera]; it may go past 360",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).azimuth_deg = g.number_between(-36000.0, 36000.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).azimuth_deg); }},
    {"keyframes[].elevation_deg", "a number from -90 to 90", "degrees", "35.0", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).elevation_deg = g.number_between(-90.0, 90.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).elevation_deg); }},
    {"keyframes[].distance", "a number from 0.01 to 10000", "largest half-axes", "4.0",
     "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).distance = g.number_between(0.01, 10000.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).distance); }},
    {"keyframes[].field_deg", "a number from 0.1 to 150", "degrees", "20.0", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         keyframe(g, d).field_deg = g.number_between(0.1, 150.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).field_deg); }},
    {"keyframes[].target", "three numbers", "largest half-axes", "[0.0, 0.0, 0.5]",
     "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).target = target_of(g); },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).target); }},
    {"keyframes[].look_at", "a string", "", R"("centre")", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).look_at = g.one_of(camera_aims()); },
     [](const Scene& s, size_t i) { return text_unless_empty(s.keyframes.at(i).look_at); },
     camera_aims()},
    {"keyframes[].speed", "a number from 0 to 1e12", "", "0.2",
     "seconds of motion a second of film; 0 stops the motion",
     [](const GivenValue& g, SceneDraft& d) { keyframe(g, d).speed = g.number_between(0.0, 1e12); },
     [](const Scene& s, size_t i) { return optional_text(s.keyframes.at(i).speed); }},

    // Fades.
    {"fades[].at_s", "a number from 0 to 1e7", "s", "2.0", "second of the film at which it begins",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).at_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.fades.at(i).at_s); }},
    {"fades[].over_s", "a number from 0 to 1e7", "s", "1.0",
     "how long it takes, in seconds of film; default 1",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).over_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.fades.at(i).over_s); }},
    {"fades[].easing", "a string", "", R"("smooth")",
     "how it goes, see `poinsot list easings`; default smooth",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).easing = name_in_table(g, easing_named); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.fades.at(i).easing)); }},
    {"fades[].elements", "a list of strings", "", R"(["plane", "momentum"])",
     "elements, overlays or kinds of panels; those that come in are not seen before",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).elements = g.texts(); },
     [](const Scene& s, size_t i) {
         return toml_text(std::span<const std::string>(s.fades.at(i).elements));
     }},
    {"fades[].opacity", "a number from 0 to 1", "", "1.0",
     "in the end: 1 to come in (the default), 0 to go, less than 1 to grow pale",
     [](const GivenValue& g, SceneDraft& d) { fade(g, d).opacity = g.number_between(0.0, 1.0); },
     [](const Scene& s, size_t i) { return toml_text(s.fades.at(i).opacity); }},

    // Captions.
    {"captions[].at_s", "a number from 0 to 1e7", "s", "4.0",
     "second of the film at which it comes",
     [](const GivenValue& g, SceneDraft& d) { caption(g, d).at_s = film_second(g); },
     [](const Scene& s, size_t i) { return toml_text(s.captions.at(i).at_s); }},
    {"captions[].over_s", "a number from 0.1 to 1e7", "s", "3.0",
     "how long it stands, in seconds of film; default: until the next in its place, or the end",
     [](const GivenValue& g, SceneDraft& d) {
         caption(g, d).over_s = g.number_between(0.1, most_film_s);
     },
     [](const Scene& s, size_t i) { return optional_text(s.captions.at(i).over_s); }},
    {"captions[].text", "a string", "", R"("L stays; ω does not.")",
     "what it says, with live numbers as in the caption",
     [](const GivenValue& g, SceneDraft& d) { caption(g, d).text = g.text(); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.captions.at(i).text)); }},
    {"captions[].place", "a string", "", R"("top")",
     "bottom (over the scene's caption) or top (under its title); default bottom",
     [](const GivenValue& g, SceneDraft& d) { caption(g, d).place = g.one_of(caption_places); },
     [](const Scene& s, size_t i) {
         const std::string& place = s.captions.at(i).place;
         return place == "bottom" ? "" : toml_text(std::string_view(place));
     },
     caption_places},

    // Chapters.
    {"chapters[].at_s", "a number from 0 to 1e7", "s", "0.0",
     "second of the film at which the section begins",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.chapters.at(g.item()).at_s = film_second(g);
     },
     [](const Scene& s, size_t i) { return toml_text(s.chapters.at(i).at_s); }},
    {"chapters[].title", "a string", "", R"("The invariable plane")", "its name",
     [](const GivenValue& g, SceneDraft& d) { d.scene.chapters.at(g.item()).title = g.text(); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.chapters.at(i).title)); }},
};

}  // namespace

std::span<const SceneKey> told_keys() { return told_rows; }

}  // namespace poinsot
