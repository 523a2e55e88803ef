// Values that the program chooses for a scene: its size on paper, the start of a loop, the film's
// length, the accuracy of the motion and its step. The scene that was read does not change.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/stage/accuracy.h"
#include "drawing/style/theme.h"
#include "mechanics/motion_problem.h"
#include "mechanics/step_choice.h"
#include "mechanics/stop_check.h"
#include "production/session/loop.h"
#include "production/session/print_size.h"
#include "scene/scene.h"
#include "scene/scene_error.h"
#include "typeset/font_source.h"

namespace poinsot {

// The needs of a session besides its scene.
struct SessionRequest {
    FontSource fonts{};             // of its pictures
    PrintChoices print{};           // a size on paper
    std::vector<double> times_s{};  // instants outside of the film that a stepped motion must cover
    bool draws = true;              // false: only numbers are asked for
};

struct ResolvedScene {
    Scene scene;  // as it is drawn: the scene that was read, with the chosen values in their places
    Theme theme;  // the scene's, with its [style]
    std::string as_read;             // values that the scene had before; see values_replaced
    std::optional<Loop> loop;        // of a looping film
    Accuracy accuracy;               // of its pictures
    StepChoice step;                 // of a stepped method; derived from accuracy_px by default
    std::vector<std::string> notes;  // for the user: about what was chosen, and keys without effect
};

// Long stepping: receives the estimate of its time, and may stop it.
struct SteppingWatch {
    std::function<void(double estimate_s)> expect = [](double) {};
    StopCheck stop{};
};

// Throws SceneError, also for stepping that would take longer than longest_stepping_s.
ResolvedScene resolve(const Scene& given, const SessionRequest& request,
                      const SteppingWatch& watch = {});

// The motion's problem over the film, the instants of the request and, in a loop, the motion before
// its start; with the chosen step.
MotionProblem problem_of(const ResolvedScene& resolved, std::span<const double> times_s);

// Whether a method steps.
bool is_stepped(const MethodChoice& choice);

// The key to which an error of a method refers: "motion.step_s" for the table "motion".
std::string key_of(const std::string& table, const MethodChoice& choice);

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

}  // namespace poinsot
