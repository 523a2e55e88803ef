#include "scene/parse_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_error.h"
#include "scene/scene_keys.h"
#include "scene/toml/toml_document.h"
#include "text/label_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Sets the location of every part of an override's value to the command line.
void locate(TomlValue& value, const SourceLocation& where) {
    value.where = where;
    for (TomlValue& item : value.items) locate(item, where);
    for (TomlEntry& entry : value.entries) {
        entry.where = where;
        locate(entry.value, where);
    }
}

// The value of an override, as its key needs it.
TomlValue value_of(const Override& given, const SourceLocation& where) {
    const std::string& key = given.key;
    const std::string path = path_of_assignment(key);
    const SceneKey* row = find_scene_key(path);
    if (row == nullptr && find_scene_array(path) == nullptr) {
        throw SceneError(where, is_scene_table(path)
                                    ? fmt::format("{} is a table; set one of its keys, see "
                                                  "`poinsot list keys`",
                                                  written_table(path))
                                    : fmt::format("unknown key \"{}\"{}", printable(key),
                                                  scene_key_remedy(path, false)));
    }

    TomlValue value = parse_override_value(given.value, where);
    const bool may_be_text = row != nullptr && row->type.may_be_text();
    const bool is_boolean =
        row != nullptr && row->type.or_boolean && value.type == TomlValue::Type::boolean;
    if (may_be_text && !is_boolean && value.type != TomlValue::Type::array) {
        // A string value needs no quotes on the command line: title=2024.
        value.text = value.type == TomlValue::Type::text ? value.text : given.value;
        value.type = TomlValue::Type::text;
    }
    locate(value, where);
    return value;
}

// The entry of a table, created if missing.
TomlEntry& entry_of(TomlValue& table, std::string_view key, const SourceLocation& where) {
    for (TomlEntry& entry : table.entries) {
        if (entry.key == key) return entry;
    }
    table.entries.push_back({std::string(key), where, {}});
    table.entries.back().value.where = where;
    return table.entries.back();
}

// The item that "omega_rad_s[1]" names within the array "omega_rad_s"; an item of an array of
// arrays has several indices.
TomlValue& item_of(TomlValue& array, std::string_view part, const SourceLocation& where) {
    TomlValue* item = &array;
    for (std::size_t bracket = part.find('['); bracket != std::string_view::npos;
         bracket = part.find('[', bracket + 1)) {
        std::size_t index = 0;
        const char* const digits = part.data() + bracket + 1;
        const auto [end, failed] = std::from_chars(digits, part.data() + part.size(), index);
        if (failed != std::errc{} || index >= item->items.size()) {
            throw SceneError(
                where,
                fmt::format(
                    "there is no {}: the scene has {} of them, counted from 0; name one of those",
                    part, item->items.size()));
        }
        item = &item->items[index];
    }
    return *item;
}

void apply_override(TomlValue& root, const Override& given) {
    const SourceLocation where{given.as_typed(), 0, 0};
    TomlValue given_value = value_of(given, where);
    TomlValue* table = &root;
    std::string_view rest = given.key;
    while (true) {
        // If the file has another type here than a table, the reader reports it later, except for a
        // boolean that may stand for its table: labels = true is [labels].
        const std::string_view path =
            std::string_view(given.key).substr(0, given.key.size() - rest.size());
        const bool stands_for_table = !path.empty() && table->type == TomlValue::Type::boolean &&
                                      find_scene_key(path.substr(0, path.size() - 1)) != nullptr &&
                                      is_scene_table(path.substr(0, path.size() - 1));
        if (stands_for_table && !table->boolean)
            throw SceneError(where, fmt::format("{} = false leaves nothing to set here; set "
                                                "{} to true, or leave this key out",
                                                path.substr(0, path.size() - 1),
                                                path.substr(0, path.size() - 1)));
        if (stands_for_table) table->type = TomlValue::Type::table;
        if (table->type != TomlValue::Type::table) return;
        const std::size_t dot = rest.find('.');
        const std::string_view part = rest.substr(0, dot);
        const std::size_t bracket = part.find('[');
        TomlEntry& entry = entry_of(*table, part.substr(0, bracket), where);
        if (dot == std::string_view::npos) {
            TomlValue& value = item_of(entry.value, part, where);
            // [labels] says that there are labels: labels = true changes nothing.
            const bool is_said = value.type == TomlValue::Type::table &&
                                 given_value.type == TomlValue::Type::boolean &&
                                 given_value.boolean && is_scene_table(given.key);
            if (is_said) return;
            entry.where = where;
            value = std::move(given_value);
            return;
        }
        table = &entry.value;
        rest.remove_prefix(dot + 1);
        if (bracket == std::string_view::npos) continue;

        // One item of an array of tables, which must exist in the file.
        table = &item_of(entry.value, part, where);
    }
}

// Walks through the document and passes every value to its row.
class Reader {
 public:
    explicit Reader(SceneDraft& draft) : draft_(draft) {}

    // `path` names rows ("body.masses[]"), `name` is what the user writes ("body.masses[2]").
    void read_table(const TomlValue& table, const std::string& path, const std::string& name,
                    std::size_t item) {
        for (const TomlEntry& entry : table.entries) {
            const std::string entry_path = joined(path, entry.key);
            const std::string entry_name = joined(name, entry.key);
            // Some names are both a key and a table: labels = false, and [labels].
            const bool is_table =
                entry.value.type == TomlValue::Type::table && is_scene_table(entry_path);
            const SceneKey* const key = is_table ? nullptr : find_scene_key(entry_path);
            if (key != nullptr) {
                draft_.scene.locations[entry_name] = entry.where;
                key->read(GivenValue(*key, entry_name, item, entry.value), draft_);
            } else if (const SceneArray* array = find_scene_array(entry_path)) {
                draft_.scene.locations[entry_name] = entry.where;
                read_array(*array, entry, entry_name);
            } else if (is_scene_table(entry_path)) {
                draft_.scene.locations[entry_name] = entry.where;
                if (entry.value.type != TomlValue::Type::table) {
                    refuse_kind(entry, entry_name, fmt::format("a table, as in [{}]", entry_path));
                }
                read_table(entry.value, entry_path, entry_name, item);
            } else {
                refuse_unknown(entry, path, entry_path);
            }
        }
    }

 private:
    static std::string joined(const std::string& table, const std::string& key) {
        // A dot within a quoted key must not look like a path.
        const bool plain = key.find('.') == std::string::npos;
        return table + (table.empty() ? "" : ".") + (plain ? key : "\"" + key + "\"");
    }

    void read_array(const SceneArray& array, const TomlEntry& entry, const std::string& name) {
        const std::string kind = fmt::format("an array of tables, as in [[{}]]", array.path);
        if (entry.value.type != TomlValue::Type::array) refuse_kind(entry, name, kind);
        for (std::size_t i = 0; i < entry.value.items.size(); ++i) {
            const TomlValue& item = entry.value.items[i];
            const std::string item_name = fmt::format("{}[{}]", name, i);
            if (item.type != TomlValue::Type::table) {
                throw SceneError(item.where, fmt::format("{} is {}; {} must be {}", item_name,
                                                         name_of(item.type), name, kind));
            }
            draft_.scene.locations[item_name] = item.where;
            array.grow(draft_);
            read_table(item, fmt::format("{}[]", array.path), item_name, i);
        }
    }

    [[noreturn]] static void refuse_kind(const TomlEntry& entry, const std::string& name,
                                         const std::string& kind) {
        throw SceneError(entry.where, fmt::format("{} is {}; it must be {}", name,
                                                  name_of(entry.value.type), kind));
    }

    [[noreturn]] static void refuse_unknown(const TomlEntry& entry, const std::string& table,
                                            const std::string& path) {
        const bool is_table = entry.value.type == TomlValue::Type::table;
        throw SceneError(
            entry.where,
            fmt::format("unknown {} \"{}\"{}{}", is_table ? "table" : "key", printable(entry.key),
                        table.empty() ? "" : " in " + written_table(table),
                        scene_key_remedy(path, true)));
    }

    SceneDraft& draft_;
};

}  // namespace

FileBytes no_scene_file(const NamedFile& file) {
    throw InputError(fmt::format("{} = \"{}\": no files can be read here; leave it out", file.key,
                                 printable(file.name)));
}

Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const Override> overrides, const SceneFiles& files) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        throw SceneError({file_name, 1, 1},
                         "the file is empty; a scene needs at least [body] and [start]");
    }
    TomlValue root = parse_toml(text, file_name);
    for (const Override& given : overrides) apply_override(root, given);

    SceneDraft draft;
    draft.files = files;
    draft.scene.file = file_name;
    draft.scene.name = std::filesystem::path(file_name).stem().string();
    draft.scene.title = as_caption(draft.scene.name);
    Reader(draft).read_table(root, "", "", 0);
    return complete_scene(std::move(draft));
}

}  // namespace poinsot
