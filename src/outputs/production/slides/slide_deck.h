// The files of a scene's slides: a film and two stills for each stop, slides.json, and a page that
// lists them.
#pragma once

#include <filesystem>
#include <optional>

#include "production/session/files/open_session.h"
#include "production/session/session.h"
#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot {

struct DeckRequest {
    SceneRequest scene;  // of the session
    // Missing, empty, or a deck of a scene of this name, whose files are replaced.
    std::filesystem::path folder;
    std::optional<int> n_jobs;  // as for make_in_jobs
};

// Writes 01.mp4, 01-loop.mp4, 01.vtt, 01.png, 01.pdf, …, slides.json and index.html. The files are
// made in a hidden folder next to it, which is renamed when all are complete. An interrupted run
// leaves the hidden folder, and the same request continues in it. In an existing deck the new files
// replace the old ones, each at once. Films that follow each other share a frame, which decodes to
// the same pixels in both. Throws InputError and EnvironmentError.
void write_deck(const Session& session, const DeckRequest& request, LazyRenderer& renderer,
                const Task& task);

}  // namespace poinsot
