// Options that several commands share, each with its name and help, and the requests to production/
// that are made from them.
#pragma once

#include <string>
#include <vector>

#include "cli/option.h"
#include "production/session/files/open_session.h"
#include "production/session/session.h"
#include "production/stills/picture.h"

namespace poinsot {

// Options of commands that read a scene.
struct SceneOptions {
    std::vector<std::string> overrides;  // of --set, --size, --fps, --quality, --theme
    bool allow_outside = false;
};

Option set_option(SceneOptions& scene);
Option size_option(SceneOptions& scene);
Option fps_option(SceneOptions& scene);
Option quality_option(SceneOptions& scene);
Option theme_option(SceneOptions& scene);
Option allow_outside_option(bool& allow_outside);

SceneRequest scene_request_of(const std::string& file, const SceneOptions& options,
                              const std::vector<std::string>& more_overrides = {});
OutsideFiles outside_files(bool allow_outside);

// Options of commands that draw.
struct BackendOptions {
    std::string backend = "auto";
    bool portable = false;
};

Option backend_option(BackendOptions& context);
Option portable_option(BackendOptions& context);

// Throws InputError for a backend that does not exist.
ContextChoice context_choice_of(const BackendOptions& options);

Option output_option(std::string& output, std::string_view help = "output file");
// The answer is one JSON document, also for several scenes.
Option json_option(bool& json, std::string_view help = "print one JSON document");
Option quiet_option(bool& quiet);

}  // namespace poinsot
