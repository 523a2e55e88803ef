// From a scene's name to the common input of all commands: the scene, its motion, and the instants
// of its film.
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
#include "production/session/loop.h"
#include "production/session/print_size.h"
#include "production/session/progress_sink.h"
#include "scene/film_clock.h"
#include "scene/load_scene.h"
#include "scene/scene.h"
#include "scene/scene_error.h"

namespace poinsot {

// A scene that was read, and its motion.
struct Session {
    Scene scene;
    Accuracy accuracy;
    StepChoice step;  // of a stepped method; derived from accuracy_px by default
    Motion motion;
    std::optional<Motion> comparison;  // by the scene's second method
    std::optional<Loop> loop;          // of a looping film
};

// A request to open a scene file.
struct SceneRequest {
    std::string file;
    std::vector<std::string> overrides;  // see load_scene
    OutsideFiles outside = OutsideFiles::refused;
    PrintChoices print;
    std::vector<double> times_s;  // instants outside of the film that a stepped motion must cover
};

// Throws InputError.
Session open_session(const SceneRequest& request, const ProgressSink& progress = {});

// The motion of a scene over its film and further instants, with its step chosen. Throws
// SceneError. Rejects stepping that would take longer than longest_stepping_s; reports stepping
// that takes more than a second.
Session session_of(Scene scene, std::span<const double> times_s = {},
                   const ProgressSink& progress = {});

// Upper bound of position errors due to the motion, in pixels: measured for a stepped motion, the
// rounding bound for a closed form.
double motion_error_px(const Session& session);

// The instants of a film. Frame k shows second k/fps of it, computed from the ratio without
// accumulation; the scene's clock maps this second to an instant of the motion. The frames of a
// loop divide it evenly, so that the frame after the last is the first.
struct FilmPlan {
    FrameRate rate;
    double start_s = 0.0;
    FilmClock clock;
    double length_s = 0.0;      // of the film
    double loop_s = 0.0;        // period of a loop, seconds of motion; 0: no loop
    std::int64_t n_frames = 0;  // of the whole film

    FilmTime moment_of(std::int64_t frame) const;
    double time_of(std::int64_t frame) const { return moment_of(frame).time_s; }
    double last_time_s() const { return n_frames > 0 ? time_of(n_frames - 1) : start_s; }
};

FilmPlan film_plan(const Session& session);

// The residuals of the construction over all frames. For torque-free rotation.
bool can_certify(const Session& session);
Certificate certify_film(const Session& session, const FilmPlan& film,
                         const ProgressSink& progress = {});

// The certificate as text, one line per claim, with measured and promised values.
std::string text_of(const Certificate& certificate);

// Throws the SceneError into which at_key_of_error converts an error.
[[noreturn]] void throw_at_key(const Scene& scene, const std::string& key,
                               const std::string& time_key, const InputError& error);

// Calls a function that may throw an InputError of the mechanics, which does not know scene files:
// adds the position of a key. An error that starts with a key of [start], such as "omega_rad_s: …",
// gets that key's position; an error about a time gets that of `time_key`, any other that of `key`.
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

// Reports the notes of the scene's reader.
void tell_notes(const Scene& scene, const ProgressSink& progress);

}  // namespace poinsot
