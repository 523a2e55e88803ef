// What the command line said, as the requests that production/ takes.
#pragma once

#include "cli/options.h"
#include "production/picture.h"
#include "production/session.h"

namespace poinsot {

// The scene named by the first argument, with all that was said of it.
SceneRequest scene_request_of(const Options& options);

// Throws InputError for a backend that does not exist.
ContextChoice context_choice_of(const Options& options);

}  // namespace poinsot
