#include "scene/write_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene_keys.h"

namespace poinsot {

namespace {

// Lines grouped by table, with the tables in the order of their first row. In TOML a line belongs
// to the header above it. Therefore, whatever the order of the rows, those of `first`, which has no
// header here, come first, and each table has one header.
class Tables {
 public:
    explicit Tables(std::string_view first) { tables_.emplace_back(first, ""); }

    void add(const SceneKey& key, const std::string& value) {
        auto table = std::find_if(tables_.begin(), tables_.end(),
                                  [&key](const auto& known) { return known.first == key.table(); });
        if (table == tables_.end()) table = tables_.emplace(table, key.table(), "");
        table->second += fmt::format("{} = {}\n", key.leaf(), value);
    }

    std::string text() const {
        std::string text = tables_.front().second;
        for (auto table = tables_.begin() + 1; table != tables_.end(); ++table)
            text += fmt::format("\n{}\n{}", written_table(table->first), table->second);
        return text;
    }

 private:
    std::vector<std::pair<std::string_view, std::string>> tables_;
};

}  // namespace

std::string values_replaced(const Scene& before, const Scene& after) {
    std::string text;
    const auto compare = [&](const SceneKey& key, std::string_view path, std::size_t item) {
        const std::string value = key.write(before, item);
        if (value == key.write(after, item)) return;
        text += fmt::format("{}{}{}", text.empty() ? "" : "; ", path,
                            value.empty() ? " not given" : " = " + value);
    };
    for (const SceneKey& key : scene_keys())
        if (key.path.find("[]") == std::string_view::npos) compare(key, key.path, 0);
    for (const SceneArray& array : scene_arrays())
        for (std::size_t i = 0; i < array.n_items(before); ++i)
            for (const SceneKey& key : scene_keys())
                if (key.path.starts_with(fmt::format("{}[]", array.path)))
                    compare(key,
                            fmt::format("{}[{}]{}", array.path, i,
                                        key.path.substr(array.path.size() + 2)),
                            i);
    return text;
}

std::string to_toml(const Scene& scene) {
    Tables tables("");
    for (const SceneKey& key : scene_keys()) {
        // Arrays of tables are written below their table.
        if (key.path.find("[]") != std::string_view::npos) continue;
        const std::string value = key.write(scene, 0);
        if (!value.empty()) tables.add(key, value);
    }
    std::string text = tables.text();
    for (const SceneArray& array : scene_arrays()) {
        const std::string items = fmt::format("{}[]", array.path);  // "panels[]"
        for (std::size_t i = 0; i < array.n_items(scene); ++i) {
            Tables item(items);
            for (const SceneKey& key : scene_keys()) {
                const bool is_of_item =
                    key.table() == items || key.table().starts_with(items + ".");
                const std::string value = is_of_item ? key.write(scene, i) : "";
                if (!value.empty()) item.add(key, value);
            }
            text += fmt::format("\n[[{}]]\n{}", array.path, item.text());
        }
    }
    return text;
}

}  // namespace poinsot
