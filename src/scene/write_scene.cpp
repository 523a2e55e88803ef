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
    for (const SceneArray& array : scene_arrays()) {
        const std::string items = fmt::format("{}[]", array.path);  // "panels[]"
        for (std::size_t i = 0; i < array.n_items(scene); ++i) {
            text += fmt::format("\n[[{}]]\n", array.path);
            table = items;
            for (const SceneKey& key : scene_keys()) {
                if (!key.path.starts_with(items)) continue;
                const std::string value = key.write(scene, i);
                if (value.empty()) continue;
                if (key.table() != table) {
                    table = key.table();
                    text += fmt::format("\n{}\n", written_table(table));
                }
                text += fmt::format("{} = {}\n", key.leaf(), value);
            }
        }
    }
    return text;
}

}  // namespace poinsot
