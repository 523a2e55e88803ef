// From a scene to the common input of all commands: the resolved scene, its motion, and the
// instants of its film.
#pragma once

#include <optional>
#include <string>

#include "construction/certificate.h"
#include "mechanics/motion.h"
#include "production/session/film_plan.h"
#include "production/session/resolve.h"
#include "production/session/task.h"

namespace poinsot {

// A resolved scene and its motion.
struct Session : ResolvedScene {
    Motion motion;
    std::optional<Motion> comparison;  // by the scene's second method
    FontSource fonts;                  // of its pictures
};

// The motion of a scene over its film and further instants. Throws SceneError. Rejects stepping
// that would take longer than longest_stepping_s; reports stepping that takes more than a second.
Session session_of(const Scene& scene, const SessionRequest& request = {}, const Task& task = {});

// Upper bound of position errors due to the motion, in pixels: measured for a stepped motion, the
// rounding bound for a closed form.
double motion_error_px(const Session& session);

// The residuals of the construction over all frames. For torque-free rotation.
bool can_certify(const Session& session);
Certificate certify_film(const Session& session, const FilmPlan& film, const Task& task = {});

// The certificate as text, one line per claim, with measured and promised values.
std::string text_of(const Certificate& certificate);

// Reports the notes of the scene's reader, and those about what was chosen.
void tell_notes(const Session& session, const Task& task);

}  // namespace poinsot
