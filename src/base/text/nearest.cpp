#include "text/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "text/printable.h"

namespace poinsot {

namespace {

// How many insertions, deletions, replacements and exchanges of two neighbours make one of the
// other (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1), above, two_above;
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        two_above = std::exchange(above, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min(
                {above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], two_above[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view given, std::span<const std::string_view> known) {
    if (given.size() > 64) return "";
    std::string_view best;
    // Of a short name most letters must be right; the dashes of an option are none.
    const std::size_t n_letters =
        given.size() - std::min(given.find_first_not_of('-'), given.size());
    const std::size_t most = n_letters < 5 ? 1 : std::max<std::size_t>(2, n_letters / 3);
    std::size_t least = most + 1;
    for (const std::string_view name : known) {
        // A name that lacks only its unit, as "time" for "time_s", is as near as one mistyped
        // letter.
        const bool lacks_unit = given.size() > 2 && name.starts_with(given) &&
                                name.substr(given.size()).starts_with('_');
        const std::size_t distance = lacks_unit ? 1 : edit_distance(given, name);
        if (distance < least) {
            least = distance;
            best = name;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view given, std::span<const std::string_view> known) {
    const std::string_view best = nearest_name(given, known);
    return best.empty() ? "" : fmt::format("; did you mean \"{}\"?", best);
}

std::string choose_instead(std::string_view given, std::span<const std::string_view> known) {
    std::string near = did_you_mean(given, known);
    return near.empty() ? fmt::format("; choose from: {}", fmt::join(known, ", ")) : near;
}

std::string unknown(std::string_view what, std::string_view given,
                    std::span<const std::string_view> known) {
    return fmt::format("unknown {} \"{}\"{}", what, printable(given), choose_instead(given, known));
}

}  // namespace poinsot
