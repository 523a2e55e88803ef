// The files of a scene's slides: a film and two stills for each stop, and slides.json.
#pragma once

#include <filesystem>
#include <optional>

#include "production/jobs/open_session.h"
#include "production/jobs/picture.h"
#include "production/session/progress_sink.h"
#include "production/session/session.h"

namespace poinsot {

struct DeckRequest {
    SceneRequest scene;            // of the session
    std::filesystem::path folder;  // missing, empty, or a deck of this scene, which is replaced
    std::optional<int> n_jobs;     // as for make_in_jobs
};

// Writes 01.mp4, 01-loop.mp4, 01.png, 01.pdf, … and slides.json. They are made in a hidden folder
// beside, which takes the folder's name when it is complete; an interrupted run leaves it, and the
// same request continues there. Films that follow each other share a frame, which decodes to the
// same pixels in both. Throws InputError and EnvironmentError; then the folder is unchanged.
void write_deck(const Session& session, const DeckRequest& request, LazyRenderer& renderer,
                const ProgressSink& progress);

}  // namespace poinsot
