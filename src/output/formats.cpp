// The table of formats. A new one is one file and one row.
#include "output/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "error/error.h"
#include "output/frame_name.h"
#include "system/file_kind.h"

namespace poinsot {

namespace {

// The two PNG rows share a suffix: a file name with '#' in it asks for the first.
constexpr std::array<OutputFormat, 7> kFormats = {{
    {"mp4", ".mp4", "film, H.264; plays everywhere, no transparency", true, false, kChunkFrames,
     open_mp4, recover_mp4, join_mp4, true},
    {"webm", ".webm", "film, VP9; small, keeps transparency", true, true, kChunkFrames, open_webm,
     recover_webm, join_webm, true},
    {"gif", ".gif", "film of 255 colours, for pages that take no other", true, true, 1, open_gif,
     recover_gif, join_gif, true},
    {"png-sequence", ".png", "numbered pictures; #### in the name is the frame", false, true, 1,
     open_png_sequence, nullptr, nullptr, true},
    {"png", ".png", "one picture", false, true, 1, open_png_still, nullptr, nullptr, false},
    {"md5", ".md5", "the hash of every frame, a line each", false, true, 1, open_md5, nullptr,
     join_md5, true},
    {"null", "", "nothing: frames are drawn and dropped", false, true, 1, open_null, nullptr,
     nullptr, false},
}};

std::string known_suffixes() {
    std::string list;
    for (const OutputFormat& format : kFormats)
        if (!format.suffix.empty() && format.name != "png")
            list += fmt::format("{}{}", list.empty() ? "" : ", ", format.suffix);
    return list;
}

}  // namespace

std::string text_of(const OutputPlan& plan, const Contents& contents) {
    return plan.tell && !plan.metadata.empty() ? plan.tell(plan.metadata, contents) : plan.metadata;
}

std::int64_t n_shown_of(const OutputPlan& plan, std::int64_t n_frames) {
    return plan.n_shown == 0 ? n_frames : std::min(plan.n_shown, n_frames);
}

std::int64_t first_number(const OutputPlan& plan) {
    return plan.first_frame + (plan.part ? plan.part->n_before : 0);
}

std::span<const OutputFormat> output_formats() { return kFormats; }

const OutputFormat& format_for(const std::filesystem::path& path) {
    // A name without a suffix may be that of a format, as "null" is.
    const std::string suffix = suffix_of(path);
    const bool numbered = has_frame_number(path);
    for (const OutputFormat& format : kFormats) {
        if (format.suffix.empty() ? path == format.name : suffix == format.suffix) {
            if (format.name == "png-sequence" && !numbered) continue;
            if (numbered && suffix != ".png")
                throw InputError(fmt::format(
                    "{}: #### numbers the pictures of a PNG sequence; a {} has no use for it",
                    path.string(), suffix));
            return format;
        }
    }
    throw InputError(fmt::format(
        "{}: no output is known by {}; the known are {}", path.string(),
        suffix.empty() ? "a name without suffix" : fmt::format("the suffix \"{}\"", suffix),
        known_suffixes()));
}

std::int64_t recover_film(const std::filesystem::path& path, const Tell& tell) {
    const OutputFormat& format = format_for(path);
    if (format.recover == nullptr)
        throw InputError(
            fmt::format("{}: is no film, so nothing of it lies aside; run the same command again",
                        path.string()));
    return format.recover(path, tell);
}

}  // namespace poinsot
