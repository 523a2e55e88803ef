#include "scene/draft_checks.h"

#include <fmt/format.h>

#include <array>

namespace poinsot {

namespace {

// "at line 3", "by --set": the place of the other key of a contradiction.
std::string place(const SourceLocation& where) {
    return where.line > 0 ? fmt::format("at line {}", where.line)
                          : fmt::format("by {}", printable(where.file));
}

bool stands_before(const SourceLocation& a, const SourceLocation& b) {
    const auto order = [](const SourceLocation& where) {
        return std::array<int, 3>{where.line == 0 ? 1 : 0, where.line, where.column};
    };
    return order(a) < order(b);
}

// Refuses two keys that give the same value in different ways, at the later one.
void refuse_both(const Scene& scene, const std::string& one, const std::string& other,
                 std::string_view remedy) {
    if (!scene.locations.contains(one) || !scene.locations.contains(other)) return;
    const bool in_order = stands_before(scene.location_of(one), scene.location_of(other));
    const std::string& first = in_order ? one : other;
    const std::string& second = in_order ? other : one;
    refuse(scene, second,
           fmt::format("{} contradicts {} ({}); {}", second, first, place(scene.location_of(first)),
                       remedy));
}

}  // namespace

void refuse(const Scene& scene, const std::string& key, std::string_view what) {
    throw SceneError(scene.location_of(key), what);
}

void refuse_mixed(const Scene& scene, std::span<const std::vector<std::string>> ways,
                  std::string_view remedy) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
        for (std::size_t j = i + 1; j < ways.size(); ++j) {
            for (const std::string& one : ways[i]) {
                for (const std::string& other : ways[j]) refuse_both(scene, one, other, remedy);
            }
        }
    }
}

}  // namespace poinsot
