#include "cli/option_values.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "error/error.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Parses a number that is the whole text.
template <typename Number>
std::optional<Number> typed(std::string_view text) {
    return number_of<Number>(without_plus(text));
}

std::optional<double> finite_number(std::string_view text) {
    const auto number = typed<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace

std::string parse_text(std::string_view option, const std::string& text) {
    if (!text.empty()) return text;
    throw InputError(
        fmt::format("{}: the value is empty; give a value, or leave the option out", option));
}

double parse_number(std::string_view option, std::string_view text, std::string_view wanted) {
    if (const auto number = finite_number(text)) return *number;
    throw InputError(fmt::format("{}: \"{}\" is not a finite number; give {}, as 12 or 0.5", option,
                                 printable(text), wanted));
}

int parse_whole(std::string_view option, std::string_view text, std::string_view wanted) {
    if (const auto number = typed<int>(text)) return *number;
    throw InputError(
        fmt::format("{}: \"{}\" is not a whole number; give {}", option, printable(text), wanted));
}

std::pair<std::int64_t, std::int64_t> parse_frames(std::string_view text) {
    const std::size_t dash = text.find('-');
    const auto first = typed<std::int64_t>(text.substr(0, dash));
    const auto last =
        dash == std::string_view::npos ? first : typed<std::int64_t>(text.substr(dash + 1));
    if (!first || !last || *first < 0 || *last < *first)
        throw InputError(fmt::format(
            "--frames {}: not a range of frames; write A-B with 0 <= A <= B, as in 0-99",
            printable(text)));
    return {*first, *last};
}

std::pair<std::int64_t, std::int64_t> parse_part(std::string_view text) {
    const std::size_t slash = text.find('/');
    std::optional<std::int64_t> number, n_parts;
    if (slash != std::string_view::npos) {
        number = typed<std::int64_t>(text.substr(0, slash));
        n_parts = typed<std::int64_t>(text.substr(slash + 1));
    }
    if (!number || !n_parts || *number < 1 || *number > *n_parts)
        throw InputError(fmt::format(
            "--part {}: not a part; write K/N with 1 <= K <= N, as 3/8 for the third of eight",
            printable(text)));
    return {*number, *n_parts};
}

}  // namespace poinsot
