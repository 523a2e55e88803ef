#include "production/session/loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "construction/closed_herpolhode.h"
#include "drawing/stage/timeline.h"
#include "error/error.h"
#include "mechanics/free/free_rotation.h"
#include "numerics/power_of_two.h"
#include "scene/film_clock.h"
#include "scene/loop_text.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

std::string counted(int n, std::string_view what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

// A loop of one polhode period, in axes that turn with the herpolhode's mean advance.
std::optional<Loop> one_period(Scene& scene) {
    RotationState start;
    start.omega_body = scene.start.omega_rad_s;
    const bool on_separatrix = problem_of(scene).on_separatrix;
    const auto period_s =
        FreeRotation(scene.body.inertia, start, on_separatrix).constants().polhode_period_s;
    if (period_s) return Loop{*period_s, "one polhode period, seen from the turning camera", ""};
    if (scene.locations.contains("film.loop")) {
        throw SceneError(scene.location_of("film.loop"),
                         "film.loop is \"period\", but this motion has no polhode period; leave "
                         "film.loop out, or start away from the principal axes and the separatrix");
    }
    // The loop was only a default: the film does not loop.
    scene.film.loop.clear();
    return std::nullopt;
}

Loop closed(Scene& scene, const LoopRatio& ratio, std::vector<std::string>& notes) {
    if (problem_of(scene).on_separatrix)
        throw SceneError(scene.location_of("film.loop"),
                         "film.loop needs a polhode period, but this motion lies exactly on the "
                         "separatrix; change the start's energy, momentum or plane distance");
    std::optional<int> component;
    for (int i = 0; i < 3; ++i) {
        if (loop_values()[static_cast<std::size_t>(i)] == scene.film.loop_changes) component = i;
    }
    const ClosedStart start = at_scene_key(scene, "film.loop", [&] {
        return close_herpolhode(scene.body.inertia, scene.start.omega_rad_s,
                                {ratio.turns, ratio.periods}, component);
    });
    Loop loop;
    loop.repeat_s = ratio.periods * start.polhode_period_s;
    loop.in_words = fmt::format("{} about L in {}", counted(ratio.turns, "turn"),
                                counted(ratio.periods, "polhode period"));
    if (start.changed) {
        const double from = scene.start.omega_rad_s[*start.changed];
        const double to = start.omega_body[*start.changed];
        loop.change = fmt::format(
            "{} was changed from {:.6g} to {:.9g} rad/s (by {:+.3g} rad/s, {:.2g} % of |omega|)",
            loop_values()[static_cast<std::size_t>(*start.changed)], from, to, to - from,
            100.0 * std::abs(to - from) / norm_of(scene.start.omega_rad_s));
        notes.push_back(fmt::format("film.loop = \"{}\": {}, so that the herpolhode closes",
                                    scene.film.loop, loop.change));
        scene.start.omega_rad_s = start.omega_body;
    }
    return loop;
}

// Fits one loop to the film, from the film's given length or its given speed.
void fit_film(Scene& scene, double repeat_s, std::vector<std::string>& notes) {
    FilmSpec& film = scene.film;
    constexpr double rounding = 1e-12;
    if (film.duration_s && std::abs(*film.duration_s - repeat_s) > rounding * repeat_s) {
        notes.push_back(fmt::format("film.duration_s = {:g} is ignored: the loop lasts {:.6g} s",
                                    *film.duration_s, repeat_s));
    }
    if (film.length_s) {
        const FilmClock clock(scene);
        const double shown_s = clock.time_at(*film.length_s) - film.start_s;
        if (!(shown_s > 0.0)) {
            throw SceneError(scene.location_of("film.length_s"),
                             "the speed is 0 during the whole film; a loop needs motion");
        }
        const double faster = repeat_s / shown_s;
        if (std::abs(faster - 1.0) > rounding) {
            film.speed *= faster;
            for (KeyframeSpec& key : scene.keyframes) {
                if (key.speed) *key.speed *= faster;
            }
        }
        return;
    }
    film.duration_s = repeat_s;
    if (!FilmClock(scene).length_s()) {
        throw SceneError(scene.location_of("film.loop"),
                         fmt::format("the speed falls to 0 before the loop's {:.6g} s have passed; "
                                     "raise it again, or give film.length_s",
                                     repeat_s));
    }
}

}  // namespace

std::optional<Loop> resolve_loop(Scene& scene, std::vector<std::string>& notes) {
    if (scene.film.loop.empty()) return std::nullopt;
    const auto ratio = loop_ratio_of(scene.film.loop);
    auto loop = ratio ? std::optional(closed(scene, *ratio, notes)) : one_period(scene);
    if (loop) {
        fit_film(scene, loop->repeat_s, notes);
        note_jumps(scene, notes);
    }
    return loop;
}

void note_jumps(const Scene& scene, std::vector<std::string>& notes) {
    const double end_s = FilmClock(scene).length_s().value_or(0.0);
    const Timeline timeline(scene, Eigen::Vector3d::Zero());
    const CameraPose a = timeline.camera_at(0.0);
    const CameraPose b = timeline.camera_at(end_s);
    const auto differs = [](double x, double y) { return std::abs(x - y) > 1e-9; };
    if (differs(std::remainder(a.azimuth_deg - b.azimuth_deg, 360.0), 0.0) ||
        differs(a.elevation_deg, b.elevation_deg) || differs(a.distance, b.distance) ||
        differs(a.field_deg, b.field_deg) || (a.target - b.target).norm() > 1e-9) {
        notes.emplace_back(
            "the camera does not end where it begins, so the loop jumps; bring it back with a last "
            "keyframe");
    }
    for (const FadeSpec& fade : scene.fades) {
        for (const std::string& name : fade.elements) {
            if (!differs(timeline.opacity_of(name, 0.0), timeline.opacity_of(name, end_s)))
                continue;
            const std::string note = fmt::format(
                "\"{}\" does not end with the opacity of the beginning, so the loop jumps; fade it "
                "back",
                printable(name));
            if (std::find(notes.begin(), notes.end(), note) == notes.end()) {
                notes.push_back(note);
            }
        }
    }
}

}  // namespace poinsot
