// From a scene's name to what every command needs: the scene, its motion, and the instants of its
// film.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "construction/certificate.h"
#include "drawing/accuracy.h"
#include "mechanics/motion.h"
#include "mechanics/step_choice.h"
#include "output/frame_sink.h"
#include "production/loop.h"
#include "production/print_size.h"
#include "production/telling.h"
#include "scene/film_clock.h"
#include "scene/load_scene.h"
#include "scene/scene.h"
#include "scene/scene_error.h"

namespace poinsot {

// A scene that has been read and whose motion has been made.
struct Session {
    Scene scene;
    Accuracy accuracy;
    StepChoice step;  // of a stepped method; chosen from accuracy_px where the scene does not say
    Motion motion;
    std::optional<Motion> beside;  // by the scene's second method
    std::optional<Loop> loop;      // of a film that runs into itself
};

// What is wanted of a scene file.
struct SceneRequest {
    std::string file;
    std::vector<std::string> overrides;  // see load_scene
    OutsideFiles outside = OutsideFiles::refused;
    PrintChoices print;
    std::vector<double> times_s;  // instants that a stepped motion must cover besides the film
};

// Throws InputError.
Session open_session(const SceneRequest& request, const Telling& telling = {});

// The motion of a scene over its film and further instants, its step chosen. Throws SceneError.
// Stepping that would take longer than longest_stepping_s is refused, and what takes more than a
// second is told.
Session session_of(Scene scene, std::span<const double> times_s = {}, const Telling& telling = {});

// How far the motion can carry anything drawn from the truth, in pixels: measured for a stepped
// motion, the bound of rounding for a closed form.
double motion_error_px(const Session& session);

// The instants of a film. Frame k shows second k/fps of it, from the ratio, never accumulated, and
// the clock says which instant of the motion that is. The frames of a loop divide it evenly, so
// that the one after the last is the first.
struct FilmPlan {
    FrameRate rate;
    double start_s = 0.0;
    FilmClock clock;
    double length_s = 0.0;      // of the film
    double loop_s = 0.0;        // seconds of motion after which it begins again; 0: it does not
    std::int64_t n_frames = 0;  // of the whole film

    FilmMoment moment_of(std::int64_t frame) const;
    double time_of(std::int64_t frame) const { return moment_of(frame).time_s; }
    double last_time_s() const { return n_frames > 0 ? time_of(n_frames - 1) : start_s; }
};

FilmPlan film_plan(const Session& session);

// The residuals of the construction over all frames; every frame counts. Torque-free scenes that
// turn.
bool can_certify(const Session& session);
Certificate certify_film(const Session& session, const FilmPlan& film, const Telling& telling = {});

// The certificate as lines of text, one a claim, with what was measured and what was promised.
std::string text_of(const Certificate& certificate);

// Throws the SceneError that at_key_of_error makes of one.
[[noreturn]] void throw_at_key(const Scene& scene, const std::string& key,
                               const std::string& time_key, const InputError& error);

// Calls what may throw an InputError of the mechanics, which knows no file: one that begins with a
// key of [start], as "omega_rad_s: …", gets that key's place; one about a time gets that of
// `time_key`, any other that of `key`.
template <typename Call>
decltype(auto) at_key_of_error(const Scene& scene, const std::string& key,
                               const std::string& time_key, Call call) {
    try {
        return call();
    } catch (const SceneError&) {
        throw;
    } catch (const InputError& error) {
        throw_at_key(scene, key, time_key, error);
    }
}

// What the scene's reader left for the user.
void tell_notes(const Scene& scene, const Telling& telling);

}  // namespace poinsot
