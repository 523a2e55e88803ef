// The table of formats. A new one is one file and one row.
#include "output/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "error/error.h"
#include "output/frame_name.h"
#include "system/file_kind.h"
#include "text/nearest.h"

namespace poinsot {

// What the rows open, one file each.
std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_gif(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_sequence(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_still(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_md5(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_null(const OutputPlan& plan);

std::int64_t recover_mp4(const std::filesystem::path& path, const Tell& tell);
std::int64_t recover_webm(const std::filesystem::path& path, const Tell& tell);
std::int64_t recover_gif(const std::filesystem::path& path, const Tell& tell);

void join_mp4(FrameEntries& entries, const OutputPlan& plan);
void join_webm(FrameEntries& entries, const OutputPlan& plan);
void join_gif(FrameEntries& entries, const OutputPlan& plan);
void join_md5(FrameEntries& entries, const OutputPlan& plan);

namespace {

// Times are in hundredths of a second, and players take less than two of them for a mistake.
constexpr double most_gif_fps = 50.0;

// The two PNG rows share a suffix: a file name with '#' in it asks for the first.
constexpr std::array<OutputFormat, 7> kFormats = {{
    {"mp4", ".mp4", "film, H.264; plays everywhere, no transparency", true, false, kChunkFrames,
     open_mp4, recover_mp4, join_mp4, true},
    {"webm", ".webm", "film, VP9; small, keeps transparency", true, true, kChunkFrames, open_webm,
     recover_webm, join_webm, true},
    {"gif", ".gif", "film of 255 colours, for pages that take no other", true, true, 1, open_gif,
     recover_gif, join_gif, true, most_gif_fps},
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

// What a suffix that is not written here has beside it, and how to come from there to it.
struct NearestWay {
    std::string_view suffix;
    std::string_view instead;
};
constexpr std::array<NearestWay, 13> ways = {{
    {".mov", "write .mp4, and `ffmpeg -i film.mp4 -c copy film.mov` puts it into one unchanged"},
    {".mkv", "write .mp4, and `ffmpeg -i film.mp4 -c copy film.mkv` puts it into one unchanged"},
    {".m4v", "write .mp4, which it is by another name"},
    {".avi", "write .mp4, which all that play .avi play"},
    {".ogv", "write .webm"},
    {".apng", "write .gif, or .webm, which keeps all colours"},
    {".webp", "write .webm for a film, .png for a picture"},
    {".jpg", "write .png, which loses nothing"},
    {".jpeg", "write .png, which loses nothing"},
    {".tif", "write .png, 16 bits a component by `still --depth 16`"},
    {".tiff", "write .png, 16 bits a component by `still --depth 16`"},
    {".bmp", "write .png"},
    {".exr", "write .png, 16 bits a component by `still --depth 16`"},
}};

// For a suffix that is unknown: the way of one that many write, or the known one that it is a slip
// of; empty for others.
std::string nearest_way(std::string_view suffix) {
    for (const NearestWay& way : ways)
        if (way.suffix == suffix) return std::string(way.instead);
    std::vector<std::string_view> known;
    for (const OutputFormat& format : kFormats)
        if (!format.suffix.empty()) known.push_back(format.suffix);
    const std::string meant = suffix.size() < 3 ? "" : did_you_mean(suffix, known);
    return meant.empty() ? "" : meant.substr(2);
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

void check_rate(const OutputFormat& format, const FrameRate& rate) {
    if (format.most_fps == 0.0 || rate.per_second() <= format.most_fps) return;
    throw InputError(
        fmt::format("a .{} shows at most {:g} frames a second, not {:g}; lower fps, or write MP4 "
                    "or WebM",
                    format.name, format.most_fps, rate.per_second()));
}

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
    const std::string way = nearest_way(suffix);
    throw InputError(fmt::format(
        "{}: no output is known by {}; {}the known are {}", path.string(),
        suffix.empty() ? "a name without suffix" : fmt::format("the suffix \"{}\"", suffix),
        way.empty() ? "" : way + "; ", known_suffixes()));
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
