// The type of a scene key's values. Reading, error messages, `poinsot list keys`, the scene
// reference and the JSON schema are all derived from it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// The range of a number.
struct Bounds {
    std::optional<double> least{}, most{};
    bool without_least = false;  // numbers must be greater than `least`

    bool hold(double number) const {
        const bool is_low = least && (without_least ? !(number > *least) : number < *least);
        return !is_low && !(most && number > *most);
    }
    // " from 1e-6 to 100", " greater than 0", or empty.
    std::string words() const;
};

inline constexpr Bounds no_bounds{};
inline constexpr Bounds positive{0.0, std::nullopt, true};
constexpr Bounds within(double least, double most) { return {least, most, false}; }

// A bound in its usual notation: "1e-6", "1e7", "0.25".
std::string bound_text(double bound);

struct ValueType {
    enum class Kind { boolean, number, integer, text };
    // The number of values in a list.
    struct Size {
        std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();
    };

    Kind kind = Kind::text;
    Bounds bounds{};          // of each number
    std::string_view unit{};  // "rad/s", or words such as "pixels"; empty: none

    // The texts that are accepted, or the `poinsot list` that names them. Both empty: any text.
    std::span<const std::string_view> names{};
    std::string_view list{};

    std::optional<Size> size{};          // absent: a single value
    std::size_t n_rows = 0;              // of a matrix; 0: not a matrix
    std::string_view names_of_values{};  // "w, x, y, z"

    // A string that is accepted instead of the value, in words ("a ratio as a string") and as a
    // regular expression.
    std::string_view or_text{}, or_pattern{};
    bool or_boolean = false;  // whether true and false are accepted, too

    bool may_be_text() const { return kind == Kind::text || !or_text.empty(); }
    // "three positive numbers in kg m²"
    std::string words() const;
};

}  // namespace poinsot
