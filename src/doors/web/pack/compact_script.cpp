#include "web/pack/compact_script.h"

#include <algorithm>

namespace poinsot {

namespace {

std::string without_comments(std::string_view text) {
    std::string rest;
    for (std::size_t at = text.find("/*"); at != std::string_view::npos; at = text.find("/*")) {
        const bool is_comment = text.substr(at + 2).find_first_of("* ") == 0;
        const std::size_t end = is_comment ? text.find("*/", at + 2) : at;
        rest += text.substr(0, is_comment ? at : at + 2);
        text.remove_prefix(std::min(end, text.size() - 2) + 2);
    }
    return rest.append(text);
}

}  // namespace

std::string compact_script(std::string_view script) {
    const std::string text = without_comments(script);
    std::string rest;
    for (std::string_view left = text; !left.empty();) {
        std::string_view line = left.substr(0, left.find('\n'));
        left.remove_prefix(std::min(line.size() + 1, left.size()));
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (!line.empty() && !line.starts_with("//")) rest.append(line).append("\n");
    }
    return rest;
}

}  // namespace poinsot
