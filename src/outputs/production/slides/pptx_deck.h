// A presentation of a scene's slides: a .pptx with a film, its title and its note on each slide.
#pragma once

#include <filesystem>
#include <optional>

#include "production/session/session.h"
#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot {

struct PptxRequest {
    std::filesystem::path output;
    std::optional<int> n_jobs{};  // as for make_in_jobs
};

// Writes the presentation atomically: a slide for each stop, with its loop. The films are made in a
// hidden folder next to it; an interrupted run leaves this folder, and the same request continues
// in it. Throws EnvironmentError and InputError, the latter also for an existing
// file that is not a presentation as this function writes it.
void write_pptx(const Session& session, const PptxRequest& request, LazyRenderer& renderer,
                const Task& task);

}  // namespace poinsot
