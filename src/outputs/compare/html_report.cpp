#include "compare/html_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "compare/report_page.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "production/records/record.h"
#include "system/run_program.h"
#include "system/suffix.h"
#include "text/control_characters.h"
#include "text/markup.h"

namespace poinsot {

namespace {

std::string numbers_in_words(const ComparedPicture& picture) {
    const Comparison& m = picture.measured;
    if (m.n_pixels == 0 || picture.outcome == Outcome::same) return "";
    std::string words = fmt::format("{} of {} pixels, at most {:.3g} levels", m.n_differing,
                                    m.n_pixels, m.largest_difference);
    if (m.flip) words += fmt::format("; FLIP {:.3g}", *m.flip);
    if (m.ssim) words += fmt::format("; SSIM {:.5f}", *m.ssim);
    return words;
}

// The differences between the records, as a list in JSON; null without records.
std::string changes_of(const ComparedPicture& picture) {
    if (!picture.changes) return "null";
    std::vector<std::string> changes;
    changes.reserve(picture.changes->size());
    for (const std::string& change : *picture.changes) changes.push_back(script_string(change));
    return fmt::format("[{}]", fmt::join(changes, ","));
}

bool has_record(const std::filesystem::path& file) {
    try {
        return !record_text(file).empty();
    } catch (const Error&) {
        return true;
    }
}

// Whether `approve` takes the picture.
bool is_approvable(const ComparedPicture& picture) {
    constexpr std::array unfit{Outcome::unreadable, Outcome::same};
    // People copy the command into a terminal.
    return !picture.actual.empty() && !is_sequence_name(picture.actual) &&
           !has_control_characters(picture.name) &&
           std::find(unfit.begin(), unfit.end(), picture.outcome) == unfit.end();
}

// One picture as an object in the page's data.
std::string object_of(const ComparedPicture& picture, bool approves) {
    std::string object =
        fmt::format(R"({{"name":{},"outcome":{},"reason":{},"numbers":{},"changes":{})",
                    script_string(picture.name), script_string(name_of(picture.outcome)),
                    script_string(picture.reason), script_string(numbers_in_words(picture)),
                    changes_of(picture));
    const auto add = [&object](const char* key, const std::string& text) {
        if (!text.empty()) object += fmt::format(R"(,"{}":{})", key, script_string(text));
    };
    add("expected", picture.shown.expected);
    add("actual", picture.shown.actual);
    add("difference", picture.shown.difference);
    if (picture.shown.n_faint_left_out > 0)
        object += fmt::format(R"(,"faint":{})", picture.shown.n_faint_left_out);
    add("strip", picture.shown.strip);
    if (picture.film && !picture.shown.strip.empty()) {
        std::vector<std::string> frames;
        for (const KeptFrames& kept : picture.film->strip)
            frames.push_back(picture.film->in_words(kept.frame));
        add("frames", fmt::format("{}", fmt::join(frames, ", ")));
    }
    if (approves && is_approvable(picture)) {
        add("approve", shell_word(picture.name));
        if (!has_record(picture.actual)) object += R"(,"foreign":true)";
    }
    return object + "}";
}

// Replaces each @WORD@ of the template in one pass, so that inserted text is not searched.
std::string filled(std::string_view page, std::string_view title, std::string_view data) {
    std::string text;
    for (;;) {
        const std::size_t at = std::min(page.find("@TITLE@"), page.find("@DATA@"));
        text += page.substr(0, at);
        if (at == std::string_view::npos) return text;
        const bool is_title = page.substr(at).starts_with("@TITLE@");
        text += is_title ? title : data;
        page.remove_prefix(at + (is_title ? 7 : 6));
    }
}

}  // namespace

std::string html_report(const std::string& title, std::span<ComparedPicture> pictures,
                        ReportPictures& shown, const std::optional<ComparedFolders>& folders) {
    std::string list;
    for (ComparedPicture& picture : pictures) {
        if (picture.outcome != Outcome::same) shown.add_alone(picture);
        list += fmt::format("{}{}", list.empty() ? "\n" : ",\n",
                            object_of(picture, folders.has_value()));
    }
    const std::string approve =
        folders ? fmt::format("--results {} --baselines {}", shell_word(folders->results),
                              shell_word(folders->baselines))
                : "";
    const std::string data =
        fmt::format("{{\"approve\":{},\"pictures\":[{}\n]}}", script_string(approve), list);
    return filled(report_pages().front().text, escaped_markup(title), data);
}

}  // namespace poinsot
