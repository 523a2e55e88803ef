// Values of a scene that its user gives in place of those in the file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// A value of a scene's key, and who gives it.
struct Override {
    std::string key;    // "body.masses[0].mass_kg"
    std::string value;  // TOML; a text needs no quotes
    // The option that gives it, for messages. One that stands for a key, such as --size, is shown
    // with the value alone.
    std::string origin = "--set";
    bool operator==(const Override&) const = default;

    // "key=value"
    std::string assignment() const;
    // As its user typed it: "--set film.fps=30", "--fps 30".
    std::string as_typed() const;
};

// Splits "key=value" at its first "=". Throws SceneError if there is none.
Override override_of(std::string_view assignment, std::string_view origin = "--set");
std::vector<Override> overrides_of(std::span<const std::string> assignments);

// Whether one of the overrides gives this key a value.
bool is_given(std::span<const Override> overrides, std::string_view key);

}  // namespace poinsot
