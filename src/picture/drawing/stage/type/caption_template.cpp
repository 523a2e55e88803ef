#include "drawing/stage/type/caption_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "drawing/stage/type/written_unit.h"
#include "error/error.h"
#include "text/languages.h"
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

// Digits with thin spaces between thousands, if there are five or more before the decimal point.
std::string in_groups(std::string number) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto first = std::find_if(number.begin(), number.end(), is_digit);
    const auto end = std::find_if_not(first, number.end(), is_digit);
    const auto begin = static_cast<std::size_t>(first - number.begin());
    auto at = static_cast<std::size_t>(end - number.begin());
    if (at < begin + 5) return number;
    while (at > begin + 3) number.insert(at -= 3, "\\,");
    return number;
}

std::string formatted(double value, std::string_view format, std::string_view decimal_mark,
                      std::size_t column) {
    if (!is_number_format(format)) {
        throw InputError(
            fmt::format("caption column {}: bad number format \"{}\"; write digits as in .2f",
                        column + 1, printable(format)));
    }
    // A minus sign instead of a hyphen, as in printed formulas.
    std::string digits = with_decimal_mark(
        in_groups(fmt::format(fmt::runtime(fmt::format("{{:{}}}", format)), value)), decimal_mark);
    if (!digits.empty() && digits.front() == '-') digits.replace(0, 1, "\u2212");
    return digits;
}

// A row of numbers as a formula. The common power of ten is a multiple of three.
std::string formatted_row(const std::vector<double>& row, std::string_view format,
                          std::string_view decimal_mark, std::size_t column) {
    double largest = 0.0;
    for (const double number : row) largest = std::max(largest, std::abs(number));
    int power = 0;
    if (largest > 0.0 && std::isfinite(largest) && (largest < 0.01 || largest >= 1e4))
        power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
    // A list needs another separator where the decimal mark is a comma, and a comma in braces is no
    // separator of a formula.
    const bool has_comma = decimal_mark == ",";
    const std::string_view separator = has_comma ? ";\\, " : ",\\, ";
    if (has_comma) decimal_mark = "{,}";
    std::string out = "$(";
    for (const double number : row) {
        if (out.size() > 2) out += separator;
        out += formatted(number / std::pow(10.0, power), format, decimal_mark, column);
    }
    out += ")";
    if (power != 0) out += fmt::format("\\times 10^{{{}}}", power);
    return out + "$";
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

// A reference to a number, and what follows it.
struct Reference {
    const LiveValue& value;
    std::string_view format;
    std::string_view after;
    std::size_t column;
};

// The text with every reference replaced by what the function returns for it.
std::string replaced(std::string_view text, std::span<const LiveValue> values,
                     const std::function<std::string(const Reference&)>& printed) {
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
        const bool has_format = name.size() < inside.size();
        const LiveValue* found = find_row(values, name);
        if (found == nullptr) {
            throw InputError(fmt::format("caption column {}: no number called \"{}\"{}", i + 2,
                                         printable(name), choose_instead(name, names_of(values))));
        }
        const std::string_view format =
            has_format ? inside.substr(name.size() + 1) : std::string_view(found->format);
        out += printed({*found, format, text.substr(close + 1), i});
        i = close;
    }
    return out;
}

// The unit that the text has beside a number, and the factor from the number's unit to it: nothing
// if they are of different kinds.
struct Beside {
    WrittenUnit written;
    std::optional<double> per_own;
};
std::optional<Beside> unit_beside(const Reference& reference) {
    const auto own = unit_named(reference.value.unit);
    if (!own) return std::nullopt;
    auto written = written_unit(reference.after, own->dimension);
    if (!written) return std::nullopt;
    Beside beside{std::move(*written), {}};
    if (beside.written.unit.dimension == own->dimension) {
        const std::string name[] = {beside.written.text};
        beside.per_own = unit_shown(name, reference.value.unit).per_SI;
    }
    return beside;
}

// A unit after its number: a space that does not break lines, none before a degree sign.
std::string after_number(std::string_view unit) {
    std::string set = unit.starts_with("\u00b0") ? "" : "~";
    for (const char c : printed_unit(unit)) set += c == ' ' ? '~' : c;
    return set;
}

}  // namespace

std::string expand_live_text(std::string_view text, std::span<const LiveValue> values,
                             std::string_view decimal_mark) {
    return replaced(text, values, [decimal_mark](const Reference& reference) {
        const LiveValue& live = reference.value;
        const auto number = [&](double factor) {
            if (live.row.empty())
                return formatted(live.value * factor, reference.format, decimal_mark,
                                 reference.column);
            std::vector<double> row = live.row;
            for (double& component : row) component *= factor;
            return formatted_row(row, reference.format, decimal_mark, reference.column);
        };
        if (!live.brings_unit) return number(1.0);
        const auto beside = unit_beside(reference);
        if (!beside) return number(1.0) + after_number(live.unit);
        if (beside->written.goes_on) return number(1.0);
        if (!beside->per_own) return number(1.0) + after_number(live.unit);
        return number(*beside->per_own);
    });
}

std::vector<std::string> unit_notes(std::string_view text, std::span<const LiveValue> values) {
    std::vector<std::string> notes;
    replaced(text, values, [&notes](const Reference& reference) -> std::string {
        const LiveValue& live = reference.value;
        const auto beside = unit_beside(reference);
        if (!beside || beside->written.goes_on || beside->per_own == 1.0) return "";
        const std::string_view written = beside->written.text;
        if (!live.brings_unit)
            notes.push_back(
                fmt::format("\"{}\" stands beside {{{}}}, which is a number in {}; write {} there",
                            written, live.name, live.unit, live.unit));
        else if (beside->per_own)
            notes.push_back(
                fmt::format("{{{}}} is shown in {}, which stands beside it, although its unit here "
                            "is {}; leave the unit out, and the number brings its own",
                            live.name, written, live.unit));
        else
            notes.push_back(
                fmt::format("\"{}\" stands beside {{{}}}, which is shown in {}; leave the unit "
                            "out, since the number brings its own",
                            written, live.name, live.unit));
        return "";
    });
    return notes;
}

std::vector<std::string_view> numbers_in(std::string_view text, std::span<const LiveValue> values) {
    std::vector<std::string_view> names;
    replaced(text, values, [&names](const Reference& reference) -> std::string {
        names.push_back(reference.value.name);
        return "";
    });
    return names;
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
