#include "drawing/stage/type/caption_template.h"

#include <fmt/format.h>

#include <cctype>

#include "error/error.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Removes at most two digits from the front.
void skip_digits(std::string_view& rest) {
    for (int n = 0; n < 2 && !rest.empty() && rest.front() >= '0' && rest.front() <= '9'; ++n) {
        rest.remove_prefix(1);
    }
}

// A width and a precision of at most two digits each, which limits a caption's length.
bool is_number_format(std::string_view rest) {
    if (rest.starts_with('+')) rest.remove_prefix(1);
    if (rest.starts_with('0')) rest.remove_prefix(1);
    skip_digits(rest);
    if (rest.starts_with('.')) {
        rest.remove_prefix(1);
        const std::size_t before = rest.size();
        skip_digits(rest);
        if (rest.size() == before) return false;
    }
    return rest.empty() || rest == "e" || rest == "f" || rest == "g";
}

std::string formatted(double value, std::string_view format, std::size_t column) {
    if (!is_number_format(format)) {
        throw InputError(
            fmt::format("caption column {}: bad number format \"{}\"; write digits as in .2f",
                        column + 1, printable(format)));
    }
    // A minus sign instead of a hyphen, as in printed formulas.
    std::string digits = fmt::format(fmt::runtime(fmt::format("{{:{}}}", format)), value);
    if (!digits.empty() && digits.front() == '-') digits.replace(0, 1, "\u2212");
    return digits;
}

// Whether the brace at `at` opens the argument of a command such as \\textbf.
bool belongs_to_command(std::string_view text, std::size_t at) {
    std::size_t from = at;
    while (from > 0 && std::isalpha(static_cast<unsigned char>(text[from - 1])) != 0) --from;
    return from < at && from > 0 && text[from - 1] == '\\';
}

// The position after the brace that closes the one at `at`.
std::size_t end_of_group(std::string_view text, std::size_t at) {
    int depth = 0;
    for (std::size_t i = at; i < text.size(); ++i) {
        if (text[i] == '{') ++depth;
        if (text[i] == '}' && --depth == 0) return i + 1;
    }
    return text.size();
}

}  // namespace

std::string expand_live_text(std::string_view text, std::span<const LiveValue> values) {
    std::string out;
    bool formula = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '$') formula = !formula;
        if (formula || (c != '{' && c != '}')) {
            out += c;
            continue;
        }
        if (c == '{' && belongs_to_command(text, i)) {
            const std::size_t end = end_of_group(text, i);
            out += text.substr(i, end - i);
            i = end - 1;
            continue;
        }
        if (i + 1 < text.size() && text[i + 1] == c) {
            out += c;
            ++i;
            continue;
        }
        const std::size_t close = text.find('}', i);
        if (c == '}' || close == std::string_view::npos) {
            throw InputError(fmt::format(
                "caption column {}: a brace without its partner; double it to print a brace",
                i + 1));
        }
        const std::string_view inside = text.substr(i + 1, close - i - 1);
        const std::string_view name = inside.substr(0, inside.find(':'));
        const std::string_view format =
            name.size() < inside.size() ? inside.substr(name.size() + 1) : "g";
        const LiveValue* found = find_row(values, name);
        if (found == nullptr) {
            throw InputError(fmt::format("caption column {}: no number called \"{}\"{}", i + 2,
                                         printable(name), choose_instead(name, names_of(values))));
        }
        out += formatted(found->value, format, i);
        i = close;
    }
    return out;
}

bool is_live(std::string_view text) {
    bool formula = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '$') formula = !formula;
        if (formula || text[i] != '{') continue;
        if (belongs_to_command(text, i)) {
            i = end_of_group(text, i) - 1;
            continue;
        }
        if (i + 1 < text.size() && text[i + 1] == '{') {
            ++i;
            continue;
        }
        return true;
    }
    return false;
}

}  // namespace poinsot
