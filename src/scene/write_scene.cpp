#include "scene/write_scene.h"

#include <fmt/format.h>

#include "scene/scene_keys.h"

namespace poinsot {

std::string to_toml(const Scene& scene) {
    std::string text;
    std::string_view table;
    for (const SceneKey& key : scene_keys()) {
        // Arrays of tables follow below their table.
        if (key.path.find("[]") != std::string_view::npos) continue;
        const std::string value = key.write(scene, 0);
        if (value.empty()) continue;
        if (key.table() != table) {
            table = key.table();
            text += fmt::format("\n[{}]\n", table);
        }
        text += fmt::format("{} = {}\n", key.leaf(), value);
    }
    if (scene.body.given != BodySpec::Given::masses) return text;
    for (std::size_t i = 0; i < scene.body.masses_as_given.size(); ++i) {
        text += "\n[[body.masses]]\n";
        for (const SceneKey& key : scene_keys()) {
            if (key.table() == "body.masses[]") {
                text += fmt::format("{} = {}\n", key.leaf(), key.write(scene, i));
            }
        }
    }
    return text;
}

}  // namespace poinsot
