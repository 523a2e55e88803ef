#include "production/records/record_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "error/error.h"
#include "production/records/record_fields.h"
#include "scene/toml/toml_document.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// A value on one line: numbers and texts as they are, lists in brackets.
std::string value_in_words(const TomlValue& value) {
    using Type = TomlValue::Type;
    switch (value.type) {
        case Type::boolean:
            return value.boolean ? "true" : "false";
        case Type::integer:
            return fmt::format("{}", value.integer);
        case Type::number:
            return fmt::format("{}", value.number);
        case Type::text:
        case Type::date:
            return value.text;
        case Type::array:
        case Type::table:
            break;
    }
    std::string words;
    const auto add = [&words](const std::string& part) {
        words += (words.empty() ? "" : ", ") + part;
    };
    for (const TomlValue& item : value.items) add(value_in_words(item));
    for (const TomlEntry& entry : value.entries)
        add(fmt::format("{} = {}", entry.key, value_in_words(entry.value)));
    return value.type == Type::array ? "[" + words + "]" : "{" + words + "}";
}

// A scene's values by their paths, in the order of the text, and the items of its lists of tables:
// "panels[0]".
struct FlatScene {
    std::vector<std::pair<std::string, std::string>> values;
    std::map<std::string, std::string, std::less<>> by_path;
    std::set<std::string, std::less<>> items;

    explicit FlatScene(std::string_view text) { add("", parse_toml(text, "the record's scene")); }

    void add(const std::string& path, const TomlValue& value) {
        const bool is_list_of_tables =
            !value.items.empty() &&
            std::all_of(value.items.begin(), value.items.end(),
                        [](const TomlValue& item) { return item.type == TomlValue::Type::table; });
        if (value.type == TomlValue::Type::table) {
            for (const TomlEntry& entry : value.entries)
                add(path.empty() ? entry.key : path + "." + entry.key, entry.value);
        } else if (is_list_of_tables) {
            for (std::size_t i = 0; i < value.items.size(); ++i) {
                const std::string item = fmt::format("{}[{}]", path, i);
                items.insert(item);
                add(item, value.items[i]);
            }
        } else {
            values.emplace_back(path, value_in_words(value));
            by_path.emplace(values.back());
        }
    }

    const std::string* find(const std::string& path) const {
        const auto at = by_path.find(path);
        return at == by_path.end() ? nullptr : &at->second;
    }
};

// The outermost item of a list that contains a path and that a scene does not have: "panels[2]".
std::string missing_item(const std::string& path, const FlatScene& scene) {
    for (std::size_t at = path.find(']'); at != std::string::npos; at = path.find(']', at + 1)) {
        std::string item = path.substr(0, at + 1);
        if (!scene.items.contains(item)) return item;
    }
    return "";
}

// Whether an absent key has its default: all but those that give the body and its start, of which a
// scene needs some.
bool has_default(std::string_view path) {
    constexpr std::array<std::string_view, 3> tables{"body.", "start.", "torque."};
    return std::none_of(tables.begin(), tables.end(),
                        [path](std::string_view table) { return path.starts_with(table); });
}

constexpr std::size_t most_of_a_value = 60;

std::string change(std::string_view what, std::string_view before, std::string_view after) {
    return fmt::format("{}: {} → {}", printable(what), printable(before, most_of_a_value),
                       printable(after, most_of_a_value));
}

// How fields of records are named here; the other fields are hashes, or follow from the scene.
struct NamedField {
    std::string_view key, name;
    std::string_view absent = "none";
};
constexpr std::array<NamedField, 20> named_fields{{{"time_s", "time in s"},
                                                   {"size", "size"},
                                                   {"depth", "bits per component", "8"},
                                                   {"dpi", "dpi"},
                                                   {"type-pt", "size of type in pt"},
                                                   {"shading", "shading"},
                                                   {"journal", "journal"},
                                                   {"type-as", "text"},
                                                   {"frames", "frames"},
                                                   {"frame", "frame"},
                                                   {"film-frames", "frames of the whole film"},
                                                   {"run", "frames of the interrupted run"},
                                                   {"sheet", "contact sheet"},
                                                   {"method", "method"},
                                                   {"profile", "profile"},
                                                   {"bounds", "bounds of errors"},
                                                   {"renderer", "renderer"},
                                                   {"mesa", "Mesa"},
                                                   {"processor", "processor"},
                                                   {"fonts", "system fonts"}}};

// Fields that follow from the scene where a key of the scene has changed.
bool follows_from_scene(std::string_view field, const std::vector<std::string>& scene_changes) {
    if (scene_changes.empty()) return false;
    if (field == "bounds") return true;
    const std::string_view key = field == "size" ? "film.size" : field == "method" ? "motion." : "";
    return !key.empty() &&
           std::any_of(scene_changes.begin(), scene_changes.end(),
                       [key](const std::string& line) { return line.starts_with(key); });
}

}  // namespace

std::vector<std::string> scene_differences(std::string_view before_text,
                                           std::string_view after_text) {
    const FlatScene before(before_text), after(after_text);
    std::vector<std::string> words;
    std::set<std::string> said;
    const auto one_sided = [&](const std::string& path, const FlatScene& other,
                               std::string_view what) {
        const std::string item = missing_item(path, other);
        if (item.empty()) return false;
        if (said.insert(item).second) words.push_back(fmt::format("{}: {}", printable(item), what));
        return true;
    };
    const auto absent = [](const std::string& path) {
        return has_default(path) ? "default" : "not given";
    };
    for (const auto& [path, value] : before.values) {
        const std::string* const now = after.find(path);
        if (now != nullptr && *now == value) continue;
        if (now == nullptr && one_sided(path, after, "removed")) continue;
        words.push_back(change(path, value, now != nullptr ? *now : absent(path)));
    }
    for (const auto& [path, value] : after.values) {
        if (before.find(path) != nullptr || one_sided(path, before, "added")) continue;
        words.push_back(change(path, absent(path), value));
    }
    return words;
}

std::vector<std::string> differences_in_words(const Record& before, const Record& after) {
    std::vector<std::string> words;
    if (before.scene_name != after.scene_name)
        words.push_back(change("scene", before.scene_name, after.scene_name));
    std::vector<std::string> scene_changes;
    if (before.scene_toml != after.scene_toml)
        scene_changes = scene_differences(before.scene_toml, after.scene_toml);
    words.insert(words.end(), scene_changes.begin(), scene_changes.end());
    if (before.mesh_hash != after.mesh_hash)
        words.emplace_back("the contents of the scene's mesh, pictures or table differ");
    for (const NamedField& named : named_fields) {
        for (const RecordField& field : record_fields()) {
            if (field.key != named.key) continue;
            const std::string absent(named.absent);
            const std::string was = field.text_of(before).value_or(absent);
            const std::string is = field.text_of(after).value_or(absent);
            if (was != is && !follows_from_scene(field.key, scene_changes))
                words.push_back(change(named.name, was, is));
        }
    }
    if (before.version != after.version)
        words.push_back(change("program", before.version, after.version));
    return words;
}

}  // namespace poinsot
