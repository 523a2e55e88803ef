// Makes the page of a scene: from the scene's file to one HTML file.
#pragma once

#include <string>
#include <vector>

#include "production/session/files/open_session.h"
#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot {

// Writes the page atomically; it carries the text of the scene, the overrides and the files that
// the scene names. Throws InputError for a scene without a picture, and EnvironmentError where the
// program was built without the module for browsers.
void write_page(const SceneRequest& request, const std::string& output, LazyRenderer& renderer,
                const Task& task);

// A picture of the gallery is an icon: its text would be smaller than anybody can read, and type of
// the least scale is not drawn at this width.
inline constexpr int thumbnail_px = 240;
std::vector<Override> thumbnail_overrides();

struct WorkbenchRequest {
    std::vector<SceneRequest> scenes;  // of the gallery; the workbench opens the first
    std::vector<SceneRequest> starts;  // with which one begins a new scene
    std::string schema_file;           // the JSON Schema of scenes
};

// Writes the workbench. Throws as write_page does.
void write_workbench(const WorkbenchRequest& request, const std::string& output,
                     LazyRenderer& renderer);

}  // namespace poinsot
