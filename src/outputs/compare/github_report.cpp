#include "compare/github_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/markup.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// The escapes of a workflow command; of a property, commas and colons, too.
std::string escaped(std::string_view text, bool is_property) {
    std::string result;
    for (const char c : printable(text, most_of_a_message)) {
        const bool special =
            c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ','));
        if (special)
            result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        else
            result += c;
    }
    return result;
}

// Text in a cell of a table: no markup, no bar.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : escaped_markup(printable(text, most_of_a_message))) {
        if (c == '|' || c == '`' || c == '*' || c == '_' || c == '[' || c == ']' || c == '\\')
            result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::size_t n_failed_of(std::span<const ComparedPicture> pictures) {
    return static_cast<std::size_t>(
        std::count_if(pictures.begin(), pictures.end(), [](const auto& p) { return !p.passes(); }));
}

}  // namespace

std::string github_annotations(std::span<const ComparedPicture> pictures) {
    // GitHub shows ten of a step; if there are more, the tenth counts them.
    const std::size_t n_failed = n_failed_of(pictures);
    const std::size_t most = n_failed > 10 ? 9 : 10;
    std::string lines;
    std::size_t n_said = 0;
    for (const ComparedPicture& picture : pictures) {
        if (picture.passes() || n_said == most) continue;
        const std::filesystem::path& file =
            picture.expected.empty() ? picture.actual : picture.expected;
        lines += fmt::format(
            "::error {}title={}::{}\n",
            file.empty() ? "" : fmt::format("file={},", escaped(file.string(), true)),
            escaped(fmt::format("{}: {}", name_of(picture.outcome), picture.name), true),
            escaped(picture.line(), false));
        ++n_said;
    }
    if (n_failed > n_said)
        lines += fmt::format("::error title=compare::{} more pictures failed; see the report\n",
                             n_failed - n_said);
    return lines;
}

std::string github_summary(const std::string& title, std::span<const ComparedPicture> pictures) {
    const auto n_same = std::count_if(pictures.begin(), pictures.end(),
                                      [](const auto& p) { return p.outcome == Outcome::same; });
    std::string text = fmt::format("### {}\n\n{} compared, {} failed, {} the same\n", cell(title),
                                   pictures.size(), n_failed_of(pictures), n_same);
    constexpr std::size_t most_rows = 200;
    std::size_t n_rows = 0;
    for (const ComparedPicture& picture : pictures) {
        if (picture.outcome == Outcome::same || n_rows == most_rows) continue;
        if (n_rows++ == 0) text += "\n| outcome | picture | |\n|---|---|---|\n";
        text += fmt::format("| {} | {} | {} |\n", name_of(picture.outcome), cell(picture.name),
                            cell(picture.line()));
    }
    return text + "\n";
}

}  // namespace poinsot
