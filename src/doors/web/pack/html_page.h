// The text of a page: one HTML file that needs nothing else.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// The scene of a page, and the picture that stands there until it starts.
struct PageContents {
    std::string scene_name;                    // "generic"
    std::string title;                         // as plain text
    std::string language;                      // of languages()
    std::string scene_text;                    // TOML
    std::vector<std::string> overrides;        // "key=value"
    std::map<std::string, std::string> files;  // name as the scene gives it → bytes
    std::vector<std::string> controls;         // keys that a link may set
    int width_px = 0, height_px = 0;           // of the scene's pictures
    std::string ground;                        // background colour, "#rrggbb"
    std::vector<std::uint8_t> poster_png;
    double poster_at_s = 0.0;  // second of the film that it shows
    std::size_t n_stops = 0;
    double planned_s = 0.0;               // for this scene, see PageSpec
    std::string next;                     // page that follows, see PageSpec
    std::vector<PageContents> following;  // scenes that the page shows after this one
};

// Scripts and styles are allowed by their hashes, and connections not at all. Precondition: the
// program has a module.
std::string html_page(const PageContents& contents);

// A scene of the workbench's gallery.
struct GalleryScene {
    std::string name, title, text;
    std::map<std::string, std::string> files;  // name as the scene gives it → bytes
    std::vector<std::uint8_t> thumbnail_png;
};

struct WorkbenchScenes {
    std::vector<GalleryScene> gallery;
    std::vector<GalleryScene> starts;  // with which one begins a new scene
};

// The workbench: an editor of scenes beside a page of `first`, and a gallery. `schema`: the JSON
// Schema of scenes.
std::string html_workbench(const PageContents& first, const WorkbenchScenes& scenes,
                           std::string_view schema);

}  // namespace poinsot
