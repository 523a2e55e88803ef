// The request of a film, a page, a presentation or slides, as the command line and the library make
// it: the output's name says what is made.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "production/session/files/open_session.h"
#include "production/session/film_plan.h"
#include "production/session/session.h"
#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot {

struct FilmOrder {
    // Empty: output/<scene>.mp4. A page (.html), a presentation (.pptx), a sequence (#### in the
    // name), else a film.
    std::string output{};
    std::string slides{};  // instead: the folder for a film and two stills for each stop
    std::optional<std::pair<std::int64_t, std::int64_t>> frames{};  // inclusive, from 0
    std::optional<std::pair<std::int64_t, std::int64_t>> part{};    // K of N, from 1
    std::optional<int> n_jobs{};                                    // as for make_in_jobs
    bool certify = false;  // `accepts` is called before anything is drawn
};

// Refuses what the output cannot have, and impossible numbers. Throws InputError.
void check_order(const FilmOrder& order);

// What the caller adds. `session` opens the scene, at most once; a page does without. `accepts`
// looks at the film before it is drawn.
struct FilmCaller {
    std::function<const Session&()> session;
    std::function<bool(const Session& session, const FilmPlan& film)> accepts{};
};

// Makes the output of an order that check_order accepts; `scene` is that of the caller's session.
// Returns false, and draws nothing, if the film is not accepted. Throws InputError and
// EnvironmentError.
bool make_output(const SceneRequest& scene, const FilmOrder& order, const FilmCaller& caller,
                 LazyRenderer& renderer, const Task& task);

}  // namespace poinsot
