// The table of scene keys: one row for each key of a scene file. Reading, writing, suggestions,
// `poinsot list keys` and the test that every row is covered use it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

class GivenValue;
struct Scene;
struct SceneDraft;

// One key. In a path, "[]" stands for the index in an array of tables: "body.masses[].mass_kg".
struct SceneKey {
    std::string_view path;     // "start.omega_rad_s"
    std::string_view type;     // "three numbers"
    std::string_view unit;     // "rad/s", or empty
    std::string_view example;  // a value as TOML text
    std::string_view summary;  // what it means, and the default where there is one

    // Stores the value; throws SceneError for a wrong type or a number out of its domain.
    void (*read)(const GivenValue& given, SceneDraft& draft);

    // Returns the value as TOML text, or empty if the scene does not have it. `item`: index for
    // "[]".
    std::string (*write)(const Scene& scene, std::size_t item);

    // The strings that it accepts, if they are a fixed list that no other table of the program
    // holds.
    std::span<const std::string_view> names{};

    // "omega_rad_s"
    std::string_view leaf() const { return path.substr(path.rfind('.') + 1); }
    // "start", or empty at the top of the file
    std::string_view table() const {
        const std::size_t dot = path.rfind('.');
        return dot == std::string_view::npos ? "" : path.substr(0, dot);
    }
    // "three numbers in rad/s, as in omega_rad_s = [0.01, 2.0, 0.01]"
    std::string expectation() const;
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

// Returns a suggestion for an unknown path, to be appended to a message: `; did you mean "x"?`, or
// the keys of its table. `in_file`: keys are named as written below their [table], otherwise by
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
