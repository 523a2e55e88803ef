// Formats JSON numbers, objects and lists; json_string is in printable.h.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/printable.h"

namespace poinsot {

// A finite double with enough digits to read it back exactly; null for other values.
std::string json_number(double value);

// Values on one line: "[1, 2]".
std::string json_list(std::span<const std::string> values);
template <typename... Numbers>
std::string json_numbers(Numbers... values) {
    return json_list(std::vector<std::string>{json_number(static_cast<double>(values))...});
}

// One value per line; `indent` is the indentation of the line with the brackets.
std::string json_lines(std::span<const std::string> values, int indent = 0);

// A JSON object; members keep the order in which they are added.
class JsonObject {
 public:
    // Adds a member whose value is already JSON.
    JsonObject& json(std::string_view key, std::string_view value);
    JsonObject& add(std::string_view key, std::string_view text);
    template <std::integral Whole>
    JsonObject& add(std::string_view key, Whole value) {
        if constexpr (std::same_as<Whole, bool>)
            return json(key, value ? "true" : "false");
        else
            return json(key, std::to_string(value));
    }
    template <std::floating_point Real>
    JsonObject& add(std::string_view key, Real value) {
        return json(key, json_number(value));
    }

    std::string line() const;   // {"a": 1, "b": 2}
    std::string lines() const;  // one member per line, with a newline at the end
 private:
    std::vector<std::string> members_;
};

}  // namespace poinsot
