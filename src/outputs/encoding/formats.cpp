// The table of formats. A new format is one file and one row.
#include "encoding/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "encoding/frame_name.h"
#include "error/error.h"
#include "system/files/file_kind.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

// The functions of the rows, one file each.
std::unique_ptr<FrameSink> open_mp4(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_webm(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_mov(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_gif(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_sequence(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_png_still(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_md5(const OutputPlan& plan);
std::unique_ptr<FrameSink> open_null(const OutputPlan& plan);

std::int64_t recover_mp4(const std::filesystem::path& path, const SealMetadata& seal);
std::int64_t recover_webm(const std::filesystem::path& path, const SealMetadata& seal);
std::int64_t recover_mov(const std::filesystem::path& path, const SealMetadata& seal);
std::int64_t recover_gif(const std::filesystem::path& path, const SealMetadata& seal);

void join_mp4(FrameEntries& entries, const OutputPlan& plan);
void join_webm(FrameEntries& entries, const OutputPlan& plan);
void join_mov(FrameEntries& entries, const OutputPlan& plan);
void join_gif(FrameEntries& entries, const OutputPlan& plan);
void join_md5(FrameEntries& entries, const OutputPlan& plan);

namespace {

// Times are in hundredths of a second, and players treat less than two of them as an error.
constexpr double most_gif_fps = 50.0;

// libvpx's threads busy-wait for each other: two jobs on two cores took 1.3 times as long.
constexpr int cores_of_libvpx = 2;

// The two PNG rows share a suffix: a file name with '#' selects the first.
constexpr OutputFormat format_table[] = {
    {.name = "mp4",
     .suffix = ".mp4",
     .summary = "film, H.264; plays everywhere, no transparency",
     .film = true,
     .alpha = false,
     .n_chunk_frames = frames_a_chunk,
     .open = open_mp4,
     .recover = recover_mp4,
     .join = join_mp4,
     .has_parts = true,
     .n_cores_a_job = 1},
    {.name = "webm",
     .suffix = ".webm",
     .summary = "film, VP9; small files, keeps transparency",
     .film = true,
     .alpha = true,
     .n_chunk_frames = frames_a_chunk,
     .open = open_webm,
     .recover = recover_webm,
     .join = join_webm,
     .has_parts = true,
     .n_cores_a_job = cores_of_libvpx},
    {.name = "mov",
     .suffix = ".mov",
     .summary = "film, ProRes 4444; for video editors, keeps transparency, large files",
     .film = true,
     .alpha = true,
     .n_chunk_frames = frames_a_chunk,
     .open = open_mov,
     .recover = recover_mov,
     .join = join_mov,
     .has_parts = true,
     .n_cores_a_job = 1},
    {.name = "gif",
     .suffix = ".gif",
     .summary = "film with 255 colours, for web pages that accept no video",
     .film = true,
     .alpha = true,
     .n_chunk_frames = 1,
     .open = open_gif,
     .recover = recover_gif,
     .join = join_gif,
     .has_parts = true,
     .n_cores_a_job = 0,
     .most_fps = most_gif_fps},
    {.name = "png-sequence",
     .suffix = ".png",
     .summary = "numbered pictures; #### in the name becomes the frame's number",
     .film = false,
     .alpha = true,
     .n_chunk_frames = 1,
     .open = open_png_sequence,
     .recover = nullptr,
     .join = nullptr,
     .has_parts = true,
     .n_cores_a_job = 1},
    {.name = "png",
     .suffix = ".png",
     .summary = "one picture",
     .film = false,
     .alpha = true,
     .n_chunk_frames = 1,
     .open = open_png_still,
     .recover = nullptr,
     .join = nullptr,
     .has_parts = false,
     .n_cores_a_job = 0},
    {.name = "html",
     .suffix = ".html",
     .summary = "page to turn, play and change in any browser; one file, without a network",
     .kind = FormatKind::page},
    {.name = "pptx",
     .suffix = ".pptx",
     .summary = "presentation with a film on each slide, for the stops or chapters of the scene",
     .kind = FormatKind::slides},
    {.name = "md5",
     .suffix = ".md5",
     .summary = "the MD5 hash of every frame, one per line",
     .film = false,
     .alpha = true,
     .n_chunk_frames = 1,
     .open = open_md5,
     .recover = nullptr,
     .join = join_md5,
     .has_parts = true,
     .n_cores_a_job = 0},
    {.name = "null",
     .suffix = "",
     .summary = "no output: frames are drawn and discarded",
     .film = false,
     .alpha = true,
     .n_chunk_frames = 1,
     .open = open_null,
     .recover = nullptr,
     .join = nullptr,
     .has_parts = false,
     .n_cores_a_job = 0},
};

std::string known_suffixes() {
    std::string list;
    for (const OutputFormat& format : format_table)
        if (!format.suffix.empty() && format.name != "png")
            list += fmt::format("{}{}", list.empty() ? "" : ", ", format.suffix);
    return list;
}

// A common suffix that is not supported, a supported alternative, and how to convert.
struct NearestWay {
    std::string_view suffix;
    std::string_view instead;
};
constexpr std::array<NearestWay, 15> ways = {{
    {".ppt", "write .pptx"},
    {".odp", "write .pptx, which LibreOffice opens"},
    {".key", "write .pptx"},
    {".mkv", "write .mp4, and convert it without loss: `ffmpeg -i film.mp4 -c copy film.mkv`"},
    {".m4v", "write .mp4, which is the same format"},
    {".avi", "write .mp4, which players of .avi also play"},
    {".ogv", "write .webm"},
    {".apng", "write .gif, or .webm, which keeps all colours"},
    {".webp", "write .webm for a film, .png for a picture"},
    {".jpg", "write .png, which is lossless"},
    {".jpeg", "write .png, which is lossless"},
    {".tif", "write .png; `still --depth 16` gives 16 bits per component"},
    {".tiff", "write .png; `still --depth 16` gives 16 bits per component"},
    {".bmp", "write .png"},
    {".exr", "write .png; `still --depth 16` gives 16 bits per component"},
}};

// Advice for an unknown suffix: the alternative to a common one, or the known one that it
// misspells; empty for others.
std::string nearest_way(std::string_view suffix) {
    for (const NearestWay& way : ways)
        if (way.suffix == suffix) return std::string(way.instead);
    std::vector<std::string_view> known;
    for (const OutputFormat& format : format_table)
        if (!format.suffix.empty()) known.push_back(format.suffix);
    const std::string meant = suffix.size() < 3 ? "" : did_you_mean(suffix, known);
    return meant.empty() ? "" : meant.substr(2);
}

// Whether the name has the suffix of a format of this kind.
bool is_name_of(FormatKind kind, const std::filesystem::path& path) {
    const std::string suffix = suffix_of(path);
    return std::any_of(
        std::begin(format_table), std::end(format_table),
        [&](const OutputFormat& format) { return format.suffix == suffix && format.kind == kind; });
}

}  // namespace

std::string text_of(const OutputPlan& plan, const EncodedMetadata& encoded) {
    return plan.seal && !plan.metadata.empty() ? plan.seal(plan.metadata, encoded) : plan.metadata;
}

std::int64_t n_shown_of(const OutputPlan& plan, std::int64_t n_frames) {
    return plan.n_shown == 0 ? n_frames : std::min(plan.n_shown, n_frames);
}

std::int64_t first_number(const OutputPlan& plan) {
    return plan.first_frame + (plan.part ? plan.part->n_before : 0);
}

std::span<const OutputFormat> output_formats() { return format_table; }

std::string film_suffixes() {
    std::vector<std::string_view> films;
    for (const OutputFormat& format : format_table)
        if (format.film) films.push_back(format.suffix);
    std::string words;
    for (std::size_t i = 0; i < films.size(); ++i)
        words += fmt::format("{}{}", i == 0 ? "" : i + 1 == films.size() ? " or " : ", ", films[i]);
    return words;
}

bool is_written_film_name(const std::filesystem::path& path) {
    const std::string suffix = suffix_of(path);
    return std::any_of(
        std::begin(format_table), std::end(format_table),
        [&](const OutputFormat& format) { return format.film && format.suffix == suffix; });
}

void check_rate(const OutputFormat& format, const FrameRate& rate) {
    if (format.most_fps == 0.0 || rate.per_second() <= format.most_fps) return;
    throw InputError(fmt::format(
        "a .{} has at most {:g} frames a second, not {:g}; lower fps, or write MP4 or WebM",
        format.name, format.most_fps, rate.per_second()));
}

const OutputFormat& format_for(const std::filesystem::path& path) {
    // A name without a suffix may be the name of a format, such as "null".
    const std::string suffix = suffix_of(path);
    const bool numbered = has_frame_number(path);
    for (const OutputFormat& format : format_table) {
        if (format.suffix.empty() ? path == format.name : suffix == format.suffix) {
            if (format.name == "png-sequence" && !numbered) continue;
            if (numbered && suffix != ".png")
                throw InputError(
                    fmt::format("{}: #### numbers the pictures of a PNG sequence; leave it out of "
                                "the name of a {}",
                                printable(path.string()), suffix));
            return format;
        }
    }
    const std::string way = nearest_way(suffix);
    throw InputError(fmt::format(
        "{}: there is no output format for {}; {}the formats are {}", printable(path.string()),
        suffix.empty() ? "a name without a suffix" : fmt::format("the suffix \"{}\"", suffix),
        way.empty() ? "" : way + "; ", known_suffixes()));
}

bool is_page_name(const std::filesystem::path& path) { return is_name_of(FormatKind::page, path); }

bool is_slides_name(const std::filesystem::path& path) {
    return is_name_of(FormatKind::slides, path);
}

std::int64_t recover_film(const std::filesystem::path& path, const SealMetadata& seal) {
    const OutputFormat& format = format_for(path);
    if (format.recover == nullptr)
        throw InputError(fmt::format(
            "{}: is not a film, so there is nothing to recover; run the same command again",
            printable(path.string())));
    return format.recover(path, seal);
}

}  // namespace poinsot
