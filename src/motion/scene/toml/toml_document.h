// A TOML file as plain values with their locations. Only this file uses toml++.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace poinsot {

struct TomlEntry;

// One value of a TOML document.
struct TomlValue {
    enum class Type { boolean, integer, number, text, date, array, table };
    Type type = Type::table;
    SourceLocation where;
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0.0;             // of an integer, too
    std::string text;                // UTF-8
    std::vector<TomlValue> items;    // array
    std::vector<TomlEntry> entries;  // table, in the file's order
};

struct TomlEntry {
    std::string key;
    SourceLocation where;  // of the key
    TomlValue value;
};

// "a string", "an integer", "a table", ….
std::string_view name_of(TomlValue::Type type);

// Largest size of a scene file, and of a scene's text: the text in the record of a picture writes
// every number in full, is therefore longer, and must be readable again.
inline constexpr std::size_t most_scene_file_bytes = std::size_t{1} << 20;
inline constexpr std::size_t most_scene_bytes = std::size_t{3} << 20;

// Returns the document's root table. Throws SceneError for text that is not TOML, and before
// parsing for text that no scene needs and parsers fail on: control characters, bytes that are not
// UTF-8, more than most_scene_bytes, brackets nested deeper than 16, keys of more than 16 parts.
TomlValue parse_toml(std::string_view text, const std::string& file_name);

// Parses the value of a --set: TOML if it reads as one value, a number in another notation (".5"),
// or otherwise the text itself as a string.
TomlValue parse_override_value(std::string_view text, const SourceLocation& where);

// The checks of parse_toml before parsing: first of the bytes, then of the nesting depth. `start`
// is where the text begins; line 0: it is not from a file. Throw SceneError.
void refuse_hostile_bytes(std::string_view text, const SourceLocation& start);
void refuse_hostile_structure(std::string_view text, const SourceLocation& start);

}  // namespace poinsot
