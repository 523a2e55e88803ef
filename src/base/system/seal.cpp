#include "system/seal.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "system/sha256.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

constexpr std::string_view hexadecimal = "0123456789abcdef";

// The place of the next run of as many hexadecimal digits as a hash has; npos without one.
std::size_t next_hash(std::string_view text, std::size_t from) {
    while (from < text.size()) {
        const std::size_t begin = text.find_first_of(hexadecimal, from);
        if (begin == std::string_view::npos) return begin;
        const std::size_t end = std::min(text.find_first_not_of(hexadecimal, begin), text.size());
        if (end - begin == blank_seal.size()) return begin;
        from = end;
    }
    return std::string_view::npos;
}

std::string line_of(const FileHash& file) {
    return JsonObject().add("name", file.name).add("sha256", file.sha256).line();
}

}  // namespace

std::string sealed(std::string text) {
    const std::string hash = sha256_of(text);
    return text.replace(text.find(blank_seal), blank_seal.size(), hash);
}

bool is_sealed(std::string_view text) {
    // What stands before the seal may look like one, such as the hash of a scene.
    constexpr int n_tries = 16;
    std::string blank(text);
    std::size_t at = next_hash(text, 0);
    for (int i = 0; i < n_tries && at != std::string_view::npos; ++i) {
        const std::string_view hash = text.substr(at, blank_seal.size());
        blank.replace(at, blank_seal.size(), blank_seal);
        if (sha256_of(blank) == hash) return true;
        blank.replace(at, hash.size(), hash);
        at = next_hash(text, at + hash.size());
    }
    return false;
}

std::string with_files(std::string_view object, std::span<const FileHash> files) {
    std::vector<std::string> lines;
    for (const FileHash& file : files) lines.push_back(line_of(file));
    constexpr std::string_view begin = "{\n", end = "\n}\n";
    const std::string members =
        JsonObject().add("sha256", blank_seal).json("files", json_lines(lines, 2)).lines();
    return sealed(fmt::format("{},\n{}", object.substr(0, object.size() - end.size()),
                              members.substr(begin.size())));
}

std::string with_more_files(std::string text, std::span<const FileHash> files) {
    constexpr std::string_view seal = "\n  \"sha256\": \"", list = "\n  \"files\": [";
    const std::size_t seal_at = text.rfind(seal) + seal.size();
    text.replace(seal_at, blank_seal.size(), blank_seal);
    std::string lines;
    for (const FileHash& file : files) lines += fmt::format("\n    {},", line_of(file));
    return sealed(text.insert(text.find(list, seal_at) + list.size(), lines));
}

bool lists_file(std::string_view text, const FileHash& file) {
    return is_sealed(text) && text.find(line_of(file)) != std::string_view::npos;
}

bool lists_name(std::string_view text, std::string_view name) {
    const std::string begin =
        fmt::format("\n    {{\"name\": {}, \"sha256\": \"", json_string(name));
    return text.find(begin) != std::string_view::npos;
}

}  // namespace poinsot
