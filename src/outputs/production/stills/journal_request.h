// The changes that a journal's figure makes in a scene.
#pragma once

#include "production/session/files/open_session.h"
#include "production/session/task.h"

namespace poinsot {

// Draws as journals ask: in theme print, with letters on the panels, and without the text that
// belongs in the author's caption. What the scene or the command line says itself has precedence.
// `request.print` names the journal. `keeps_text`: as --keep-text. Throws InputError.
void apply_journal_style(bool keeps_text, SceneRequest& request, const Task& task);

}  // namespace poinsot
