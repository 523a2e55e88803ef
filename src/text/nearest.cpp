#include "text/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "text/printable.h"

namespace poinsot {

namespace {

// Levenshtein's distance: insertions, deletions and replacements.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view given, std::span<const std::string_view> known) {
    if (given.size() > 64) return "";
    std::string_view best;
    std::size_t least = std::max<std::size_t>(2, given.size() / 3) + 1;
    for (const std::string_view name : known) {
        const std::size_t distance = edit_distance(given, name);
        if (distance < least) {
            least = distance;
            best = name;
        }
    }
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
