#include "production/films/part_mismatch.h"

#include <fmt/format.h>

#include <string_view>

#include "text/printable.h"

namespace poinsot {

namespace {

std::string_view next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

// The first line in which two scenes differ, from each scene.
std::string differing_lines(std::string_view one, std::string_view other) {
    while (!one.empty() || !other.empty()) {
        const std::string_view a = next_line(one), b = next_line(other);
        if (a != b)
            return fmt::format("\"{}\" and \"{}\"", printable(std::string(a), 80),
                               printable(std::string(b), 80));
    }
    return "their meshes, pictures or tables";
}

}  // namespace

std::string difference_of(const Record& one, const Record& other) {
    std::string found;
    const auto compare = [&found](std::string_view what, const std::string& a,
                                  const std::string& b) {
        if (found.empty() && a != b)
            found = fmt::format("{} differ: {} and {}", what, printable(a), printable(b));
    };
    compare("the versions of poinsot", one.version, other.version);
    compare("their scenes", one.scene_name, other.scene_name);
    if (found.empty() && one.scene_hash != other.scene_hash)
        found = fmt::format("their scenes or settings differ: {}",
                            differing_lines(one.scene_toml, other.scene_toml));
    const auto frames = [](const Record& record) {
        return record.frames ? fmt::format("{}-{}", record.frames->first, record.frames->second)
                             : std::string("none");
    };
    compare("the frames of their films", frames(one), frames(other));
    compare("their profiles", one.portable ? "portable" : "native",
            other.portable ? "portable" : "native");
    compare("their renderers", one.renderer, other.renderer);
    compare("their versions of Mesa", one.mesa, other.mesa);
    compare("their fonts", one.fonts, other.fonts);
    if (found.empty() && one.processor != other.processor)
        found = fmt::format(
            "their processors have different instruction sets ({} and {}), so native pictures "
            "differ; draw the parts with --portable",
            printable(one.processor), printable(other.processor));
    compare("the methods of their motions", one.method, other.method);
    compare("their error bounds", one.bounds, other.bounds);
    return found;
}

}  // namespace poinsot
