// The table of scene keys: one row for each key of a scene file. Reading, writing, suggestions,
// `poinsot list keys` and the test that every row is covered use it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "scene/value_type.h"

namespace poinsot {

class GivenValue;
struct Scene;
struct SceneDraft;

// One key. In a path, "[]" stands for the index in an array of tables: "body.masses[].mass_kg".
struct SceneKey {
    using Reader = std::function<void(const GivenValue& given, SceneDraft& draft)>;
    using Writer = std::function<std::string(const Scene& scene, std::size_t item)>;

    std::string_view path;     // "start.omega_rad_s"
    ValueType type;            // what it takes
    std::string_view example;  // a value as TOML text
    std::string_view summary;  // what it means

    // Stores the value; throws SceneError for a value that the type does not accept.
    Reader read{};
    // Returns the value as TOML text, or empty if the scene has none. `item`: index for "[]".
    Writer value{};

    // The value in a default-constructed scene, as TOML text; empty: it has none.
    std::string initial{};
    // The default in words, if it is not a fixed value.
    std::string_view default_words{};
    bool has_no_default = false;  // the initial value is not a default
    bool omits_initial = false;   // the writer leaves the initial value out
    // The kind of torque to which the key belongs (torque_kinds), and whether this key, or another
    // of which it is also said, must be given with this kind.
    std::optional<std::size_t> torque_kind{};
    bool makes_torque = false;

    // Further properties of a row, set in the tables of keys.
    SceneKey&& from_list(std::string_view list) && { return with(type.list, list); }
    SceneKey&& values_from(std::span<const std::string_view> names) && {
        return with(type.names, names);
    }
    SceneKey&& values_named(std::string_view names) && { return with(type.names_of_values, names); }
    SceneKey&& with_size(ValueType::Size size) && { return with(type.size, size); }
    SceneKey&& or_text(std::string_view words, std::string_view pattern) &&;
    SceneKey&& or_boolean() && { return with(type.or_boolean, true); }
    SceneKey&& default_is(std::string_view words) && { return with(default_words, words); }
    SceneKey&& without_default() &&;
    SceneKey&& omitted_if_default() && { return with(omits_initial, true); }
    SceneKey&& of_torque(std::size_t kind) && { return with(torque_kind, kind); }
    SceneKey&& needed_by_torque() && { return with(makes_torque, true); }
    SceneKey&& written_if_empty() && { return with(omits_initial, false); }
    SceneKey&& read_by(Reader reader) && { return with(read, std::move(reader)); }
    // `check` throws InputError for an unknown name, which is then refused at its own place.
    SceneKey&& checked_by(std::function<void(const std::string& text)> check) &&;
    SceneKey&& written_by(Writer writer) &&;
    SceneKey&& written_if(bool (*says)(const Scene& scene)) &&;

    // Returns the value as TOML text, or empty if it is to be left out of the file.
    std::string write(const Scene& scene, std::size_t item) const;

    // "omega_rad_s"
    std::string_view leaf() const { return path.substr(path.rfind('.') + 1); }
    // "start", or empty at the top of the file
    std::string_view table() const {
        const std::size_t dot = path.rfind('.');
        return dot == std::string_view::npos ? "" : path.substr(0, dot);
    }
    // "three numbers in rad/s, as in omega_rad_s = [0.01, 2.0, 0.01]"
    std::string expectation() const;
    // The default as TOML text; empty if there is none, or one in words only.
    std::string_view default_text() const;
    // "a number from 0.25 to 8; factor on the size of all type; default 1"
    std::string explanation() const;

 private:
    template <typename Field, typename Set>
    SceneKey&& with(Field& field, Set set) {
        field = std::move(set);
        return std::move(*this);
    }
};

std::span<const SceneKey> scene_keys();

// An array of tables whose items' keys are rows with "[]" in their path.
struct SceneArray {
    std::string_view path;                       // "body.masses"
    void (*grow)(SceneDraft& draft);             // adds an item with its defaults
    std::size_t (*n_items)(const Scene& scene);  // to be written
};

std::span<const SceneArray> scene_arrays();

// The row of a path, or null.
const SceneKey* find_scene_key(std::string_view path);

// The path of the row for a key as it is typed for --set: "body.masses[].mass_kg" for
// "body.masses[0].mass_kg", "start.omega_rad_s" for "start.omega_rad_s[1]".
std::string path_of_assignment(std::string_view key);

// Returns a suggestion for an unknown path, to be appended to a message: `; did you mean "x"?`, or
// the keys of its table. `in_file`: keys are named as written below their [table]; otherwise by
// their whole path.
std::string scene_key_remedy(std::string_view unknown_path, bool in_file);

// The array of tables of a path, or null.
const SceneArray* find_scene_array(std::string_view path);

// Returns a table's header as it is written: "[body]", "[[body.masses]]" for "body.masses[]", or
// "[panels.camera]" for "panels[].camera".
std::string written_table(std::string_view path);

// True if rows lie below this path: "body".
bool is_scene_table(std::string_view path);

}  // namespace poinsot
