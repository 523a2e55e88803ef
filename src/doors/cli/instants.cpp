#include "cli/instants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>

#include "error/error.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/rational.h"

namespace poinsot {

namespace {

// No table can have more.
constexpr double most_instants = 1e8;

// Parses a text that is a finite number, as the nearest double and as the exact decimal.
std::optional<double> finite_decimal(std::string_view text) {
    const auto number = number_of<double>(without_plus(text));
    return number && std::isfinite(*number) ? number : std::nullopt;
}
std::optional<Rational> exact_decimal(std::string_view text) {
    return finite_decimal(text) ? rational_of(without_plus(text)) : std::nullopt;
}

[[noreturn]] void throw_no_time(std::string_view item) {
    throw InputError(fmt::format(
        "--times: \"{}\" is not a time in seconds; write T,T,… as in 0,0.5,1, first:last:step or "
        "first:last/n",
        printable(item)));
}

[[noreturn]] void throw_bad_range(std::string_view item, std::string_view what) {
    throw InputError(fmt::format("--times: \"{}\" {}", printable(item), what));
}

void check_count(std::string_view item, double count) {
    if (count > most_instants)
        throw_bad_range(item, "has more than 100000000 instants; split it into several runs");
}

void append(const Progression& instants, std::int64_t n, std::vector<double>& times) {
    for (std::int64_t k = 0; k < n; ++k) times.push_back(instants.at(k));
}

void append_stepped(std::string_view item, const Rational& first, const Rational& last,
                    const Rational& step, std::vector<double>& times) {
    const double steps = step.is_zero() ? -1.0 : nearest_double((last - first) / step);
    if (!(steps >= 0.0))
        throw_bad_range(item, "never reaches its last instant; give a step towards it");
    check_count(item, steps);
    // A last instant that is missed only because of the rounding of a written step is included.
    const auto n = static_cast<std::int64_t>(std::floor(steps * (1.0 + 1e-15) + 1e-12));
    append(Progression(first, step), n + 1, times);
}

void append_divided(std::string_view item, const Rational& first, const Rational& last,
                    double n_given, std::vector<double>& times) {
    check_count(item, n_given);
    if (!(n_given >= 2) || n_given != std::floor(n_given))
        throw_bad_range(item, "needs a whole number of instants, 2 or more, after its /");
    const auto n = static_cast<std::int64_t>(n_given);
    append(Progression(first, (last - first) / (n - 1)), n, times);
}

void append_item(std::string_view item, std::vector<double>& times) {
    const std::size_t colon = item.find(':');
    if (colon == std::string_view::npos) {
        const auto time = finite_decimal(item);
        if (!time) throw_no_time(item);
        times.push_back(*time);
        return;
    }
    const std::string_view rest = item.substr(colon + 1);
    const std::size_t split = rest.find_first_of(":/");
    if (split == std::string_view::npos) throw_no_time(item);
    const std::string_view third = rest.substr(split + 1);
    const auto first = exact_decimal(item.substr(0, colon));
    const auto last = exact_decimal(rest.substr(0, split));
    if (!first || !last) throw_no_time(item);
    if (rest[split] == ':') {
        const auto step = exact_decimal(third);
        if (!step) throw_no_time(item);
        append_stepped(item, *first, *last, *step, times);
    } else {
        const auto n = finite_decimal(third);
        if (!n) throw_no_time(item);
        append_divided(item, *first, *last, *n, times);
    }
}

std::string all_of(const std::string& file) {
    std::ostringstream text;
    if (file == "-") {
        text << std::cin.rdbuf();
        return std::move(text).str();
    }
    std::ifstream stream(file, std::ios::binary);
    errno = 0;
    text << stream.rdbuf();
    if (!stream.is_open() || text.bad() || errno != 0)
        throw InputError(fmt::format("--times-file {}: cannot be read; name a file of instants",
                                     printable(file)));
    return std::move(text).str();
}

// Appends the instants of one line; places in the line are counted from 1.
void append_line(std::string_view line, const std::string& name, std::size_t line_number,
                 std::vector<double>& times) {
    constexpr std::string_view between = " \t\r,";
    std::size_t begin = 0;
    while ((begin = line.find_first_not_of(between, begin)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(between, begin), line.size());
        const std::string_view item = line.substr(begin, end - begin);
        const auto time = finite_decimal(item);
        if (!time)
            throw InputError(
                fmt::format("{}:{}:{}: \"{}\" is not a time in seconds; write one instant per line",
                            printable(name), line_number, begin + 1, printable(item)));
        times.push_back(*time);
        begin = end;
    }
}

}  // namespace

std::vector<double> parse_times(std::string_view text) {
    if (text == "-") return instants_in("-");
    std::vector<double> times;
    while (true) {
        const std::size_t comma = text.find(',');
        append_item(text.substr(0, comma), times);
        if (comma == std::string_view::npos) return times;
        text.remove_prefix(comma + 1);
    }
}

std::vector<double> instants_of(std::string_view text, const std::string& name) {
    std::vector<double> times;
    for (std::size_t line_number = 1; !text.empty(); ++line_number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        append_line(line.substr(0, line.find('#')), name, line_number, times);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (times.empty())
        throw InputError(fmt::format("{}: contains no instants; write one per line, in seconds",
                                     printable(name)));
    return times;
}

std::vector<double> instants_in(const std::string& file) {
    return instants_of(all_of(file), file == "-" ? "standard input" : file);
}

}  // namespace poinsot
