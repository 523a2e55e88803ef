// Keys of the events of the film: keyframes, fades, captions and chapters.
#include <array>
#include <string_view>

#include "scene/camera_views.h"
#include "scene/easing.h"
#include "scene/scene_key_rows.h"

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
constexpr auto timed_caption(Value TimedCaptionSpec::*member) {
    return in(&Scene::captions, member);
}

}  // namespace

std::span<const SceneKey> story_keys() {
    using namespace key_rows;
    static const SceneKey rows[] = {
        // Keyframes: movements of the camera and changes of the speed.
        number("keyframes[].at_s", keyframe(&KeyframeSpec::at_s), film_seconds, "s", "3.0",
               "second of the film at which this is reached")
            .without_default(),
        text("keyframes[].easing", keyframe(&KeyframeSpec::easing), R"("smooth")",
             "how values go here from the keyframe before that says them")
            .from_list("easings")
            .checked_by(easing_named),
        text("keyframes[].view", keyframe(&KeyframeSpec::view), R"("front")",
             "a view by name, for all of the camera that this keyframe does not say otherwise")
            .from_list("views")
            .checked_by(camera_view_named),
        integer("keyframes[].panel", keyframe(&KeyframeSpec::panel), within(0, 999), "0",
                "the panel whose camera moves, by its place among [[panels]] from 0")
            .default_is("all that are seen as [camera] says, with no camera of their own"),
        number("keyframes[].azimuth_deg", keyframe(&KeyframeSpec::azimuth_deg),
               within(-36000.0, 36000.0), "degrees", "30.0", "as in [camera]; it may go past 360"),
        number("keyframes[].elevation_deg", keyframe(&KeyframeSpec::elevation_deg), elevations_deg,
               "degrees", "35.0", "as in [camera]"),
        number("keyframes[].distance", keyframe(&KeyframeSpec::distance), distances,
               "largest half-axes", "4.0", "as in [camera]"),
        number("keyframes[].field_deg", keyframe(&KeyframeSpec::field_deg), fields_deg, "degrees",
               "20.0", "as in [camera]"),
        numbers("keyframes[].target", keyframe(&KeyframeSpec::target), coordinates,
                "largest half-axes", "[0.0, 0.0, 0.5]", "as in [camera]"),
        one_of("keyframes[].look_at", keyframe(&KeyframeSpec::look_at), camera_aims(),
               R"("centre")", "as in [camera]"),
        number("keyframes[].speed", keyframe(&KeyframeSpec::speed), within(0.0, 1e12), "", "0.2",
               "seconds of motion a second of film; 0 stops the motion"),

        // Fades.
        number("fades[].at_s", fade(&FadeSpec::at_s), film_seconds, "s", "2.0",
               "second of the film at which it begins")
            .without_default(),
        number("fades[].over_s", fade(&FadeSpec::over_s), film_seconds, "s", "1.0",
               "how long it takes, in seconds of film"),
        text("fades[].easing", fade(&FadeSpec::easing), R"("smooth")", "how it goes")
            .from_list("easings")
            .checked_by(easing_named),
        texts("fades[].elements", fade(&FadeSpec::elements), R"(["plane", "momentum"])",
              "elements, overlays or kinds of panels; those that come in are not seen before")
            .without_default(),
        number("fades[].opacity", fade(&FadeSpec::opacity), within(0.0, 1.0), "", "1.0",
               "in the end: 1 to come in, 0 to go, less than 1 to grow pale"),

        // Captions.
        number("captions[].at_s", timed_caption(&TimedCaptionSpec::at_s), film_seconds, "s", "4.0",
               "second of the film at which it comes")
            .without_default(),
        number("captions[].over_s", timed_caption(&TimedCaptionSpec::over_s),
               within(0.1, most_film_s), "s", "3.0", "how long it stands, in seconds of film")
            .default_is("until the next in its place, or the end"),
        text("captions[].text", timed_caption(&TimedCaptionSpec::text), R"("L stays; ω does not.")",
             "what it says, with live numbers as in the caption")
            .without_default(),
        one_of("captions[].place", timed_caption(&TimedCaptionSpec::place), caption_places,
               R"("top")", "bottom (over the scene's caption) or top (under its title)")
            .omitted_if_default(),

        // Chapters.
        number("chapters[].at_s", in(&Scene::chapters, &ChapterSpec::at_s), film_seconds, "s",
               "0.0", "second of the film at which the section begins")
            .without_default(),
        text("chapters[].title", in(&Scene::chapters, &ChapterSpec::title),
             R"("The invariable plane")", "its name")
            .without_default(),
    };
    return rows;
}

}  // namespace poinsot
