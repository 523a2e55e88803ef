// Finds keys by name, and the nearest key to an unknown name.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "scene/scene_error.h"
#include "scene/scene_keys.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

// The rows of this table.
std::vector<std::string_view> leaves_of(std::string_view table) {
    std::vector<std::string_view> leaves;
    for (const SceneKey& key : scene_keys()) {
        if (key.table() == table) leaves.push_back(key.leaf());
    }
    return leaves;
}

// The tables and arrays of tables directly in this one.
std::vector<std::string_view> tables_of(std::string_view table) {
    std::vector<std::string_view> tables;
    for (const SceneKey& key : scene_keys()) {
        std::string_view path = key.table();
        if (path.ends_with("[]")) path.remove_suffix(2);
        const std::size_t dot = path.rfind('.');
        const std::string_view parent = dot == std::string_view::npos ? "" : path.substr(0, dot);
        if (path.empty() || parent != table) continue;
        const std::string_view leaf = path.substr(parent.empty() ? 0 : parent.size() + 1);
        if (std::find(tables.begin(), tables.end(), leaf) == tables.end()) tables.push_back(leaf);
    }
    return tables;
}

// The key of a name with a missing unit or a wrong ending: "omega" for "omega_rad_s".
std::string_view with_other_ending(std::string_view given,
                                   const std::vector<std::string_view>& known) {
    if (given.size() < 3) return "";
    for (const std::string_view name : known) {
        const bool stem = name.starts_with(given);
        const std::size_t unit = name.find('_');
        const bool other_unit = unit != std::string_view::npos && unit >= 3 &&
                                given.starts_with(name.substr(0, unit + 1));
        if (stem || other_unit) return name;
    }
    return "";
}

std::string nearest(std::string_view given, const std::vector<std::string_view>& known) {
    std::string by_letters = did_you_mean(given, known);
    if (!by_letters.empty()) return by_letters;
    const std::string_view by_ending = with_other_ending(given, known);
    return by_ending.empty() ? "" : fmt::format("; did you mean \"{}\"?", by_ending);
}

// "body.masses[0].mass_kg" → "body.masses[].mass_kg", the path of a row.
std::string without_indices(std::string_view key) {
    std::string path;
    bool inside = false;
    for (const char c : key) {
        inside = inside && c >= '0' && c <= '9';
        if (!inside) path += c;
        if (c == '[') inside = true;
    }
    return path;
}

}  // namespace

const SceneKey* find_scene_key(std::string_view path) {
    const auto keys = scene_keys();
    const auto found = std::find_if(keys.begin(), keys.end(),
                                    [path](const SceneKey& key) { return key.path == path; });
    return found == keys.end() ? nullptr : &*found;
}

std::string path_of_assignment(std::string_view key) {
    std::string path = without_indices(key);
    // An item of an array of values: start.omega_rad_s[1].
    if (path.ends_with("[]") && find_scene_key(path.substr(0, path.size() - 2)) != nullptr)
        path.resize(path.size() - 2);
    return path;
}

bool is_scene_table(std::string_view path) {
    const std::string beginning = fmt::format("{}.", path);
    const auto keys = scene_keys();
    return std::any_of(keys.begin(), keys.end(), [&beginning](const SceneKey& key) {
        return key.path.starts_with(beginning);
    });
}

std::string written_table(std::string_view path) {
    if (path.ends_with("[]")) return fmt::format("[[{}]]", path.substr(0, path.size() - 2));
    // A table of an item is written below that item: [panels.camera].
    std::string written(path);
    for (std::size_t at = 0; (at = written.find("[]", at)) != std::string::npos;)
        written.erase(at, 2);
    return fmt::format("[{}]", written);
}

const SceneArray* find_scene_array(std::string_view path) {
    const auto arrays = scene_arrays();
    const auto found = std::find_if(arrays.begin(), arrays.end(),
                                    [path](const SceneArray& array) { return array.path == path; });
    return found == arrays.end() ? nullptr : &*found;
}

std::string scene_key_remedy(std::string_view unknown_path, bool in_file) {
    const std::size_t dot = unknown_path.rfind('.');
    const std::string_view table = dot == std::string_view::npos ? "" : unknown_path.substr(0, dot);
    const std::string_view leaf = unknown_path.substr(dot == std::string_view::npos ? 0 : dot + 1);

    // On the command line whole paths are typed, so whole paths are suggested.
    if (!in_file) {
        std::vector<std::string_view> paths;
        for (const SceneKey& key : scene_keys()) paths.push_back(key.path);
        std::string near = nearest(unknown_path, paths);
        if (!near.empty()) return near;
    }

    // The nearest name in the same table, then a key of exactly that name in another table.
    std::vector<std::string_view> here = leaves_of(table);
    const std::vector<std::string_view> tables = tables_of(table);
    here.insert(here.end(), tables.begin(), tables.end());
    if (in_file) {
        std::string near = nearest(leaf, here);
        if (!near.empty()) return near;
    }
    for (const SceneKey& key : scene_keys()) {
        if (key.leaf() != leaf) continue;
        if (!in_file) return fmt::format("; did you mean \"{}\"?", key.path);
        return key.table().empty()
                   ? fmt::format("; \"{}\" stands above the first [table]", leaf)
                   : fmt::format("; \"{}\" belongs in {}", leaf, written_table(key.table()));
    }
    if (here.empty()) return "; see `poinsot list keys`";
    return table.empty() ? fmt::format("; choose from: {}", fmt::join(here, ", "))
                         : fmt::format("; {} has: {}", written_table(table), fmt::join(here, ", "));
}

}  // namespace poinsot
