// Images → files. A sink takes video frames in order and writes one output atomically.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "encoding/film_part.h"
#include "image/frame_rate.h"
#include "image/image.h"

namespace poinsot {

// A named section; its frames are counted from the output's first frame.
struct FilmChapter {
    std::string title;
    std::int64_t first_frame = 0;
    std::int64_t end_frame = 0;  // one past its last
};

// Text shown at the bottom or top of the picture for a time: plain, without empty lines;
// milliseconds of the output from its first frame.
struct FilmSubtitle {
    std::string text;
    std::int64_t begin_ms = 0, end_ms = 0;
    bool at_top = false;
};

// Returns the millisecond of the output at which its frame n is shown, rounded.
constexpr std::int64_t milliseconds_of(std::int64_t n, const FrameRate& rate) {
    return (2000 * n * rate.denominator + rate.numerator) / (2 * rate.numerator);
}

// Metadata known only after encoding.
struct EncodedMetadata {
    std::int64_t n_frames = 0;               // of a film
    std::string packets = {};                // of a film: see output/film_packets.h
    std::string file = {};                   // of a film: see output/film_file_hash.h
    std::optional<std::int64_t> frame = {};  // of a numbered picture
    std::string pixels = {};                 // of a picture: see image/pixels_xxh64.h
};

// Makes the text that an output carries from the plan's metadata.
using SealMetadata =
    std::function<std::string(const std::string& metadata, const EncodedMetadata& encoded)>;

// Settings that an output needs before its first frame.
struct OutputPlan {
    std::filesystem::path path;  // final name; "####" in a PNG name is the frame number
    int width_px = 0, height_px = 0;
    FrameRate rate;
    std::int64_t first_frame = 0;     // number of the first frame written, for sequences
    std::int64_t n_frames = 0;        // number of frames that will be written
    std::string quality = "lecture";  // a name of output/quality.h
    int encoder_threads = 0;          // 0: chosen by the sink
    std::string metadata;             // text carried in the file
    SealMetadata seal;  // makes the text from metadata; if empty, metadata is used as it is
    // The film keeps only the first n_shown of the written frames; 0: all. Its packets are those of
    // the longer film, as in a recovered film.
    std::int64_t n_shown = 0;
    std::string language;                 // of its tracks, ISO 639-2; empty: undetermined
    std::vector<FilmChapter> chapters;    // in order; for containers that support them
    std::vector<FilmSubtitle> subtitles;  // likewise; at most two at once: at the bottom and top
    // Continue from the log that an interrupted run with the same plan has left, and keep the log
    // when interrupted again. Formats that do not support this start from the first frame.
    bool resume = false;
    // Only n_frames from the n_before-th on, as a part of the film; metadata, chapters and
    // first_frame stay the film's. For formats that have parts.
    std::optional<FilmPart> part = {};
    // Encode the film's first and last frame alone, so that their packets depend on no other frame.
    // For .mp4.
    bool ends_alone = false;
    // Whether the film's first frame has transparent pixels; a part that begins later needs to
    // know.
    std::optional<bool> has_alpha = {};
};

// Called on the writing thread, once per frame.
using PixelsConsumed = std::function<void()>;

// Call write() in frame order, then finish(). Destroying an unfinished sink leaves no file under
// the final name. One thread at a time may use a sink.
class FrameSink {
 public:
    virtual ~FrameSink() = default;
    // The number of frames kept from an interrupted run: write() continues after them.
    virtual std::int64_t n_frames_kept() const { return 0; }
    // Whether a frame, counted from the plan's first, already exists. write() receives the missing
    // frames in order; in a sequence, any frame may be missing.
    virtual bool has_frame(std::int64_t frame) const { return frame < n_frames_kept(); }
    virtual void write(const Image& frame) = 0;  // throws EnvironmentError
    // Like write(), and calls consumed as soon as the picture is not needed any more.
    virtual void write_notifying(const Image& frame, const PixelsConsumed& consumed) {
        write(frame);
        consumed();
    }
    virtual void finish() = 0;  // flushes, syncs and renames; throws EnvironmentError
};

class FrameEntries;  // see output/frame_log.h

// The contents of a format: frames, which a sink of this folder writes; the scene itself; or a film
// for each stop. `OutputFormat::open` is null unless it holds frames.
enum class FormatKind { frames, page, slides };

// A row of the table of formats.
struct OutputFormat {
    std::string_view name;     // "mp4"
    std::string_view suffix;   // ".mp4"; empty for those chosen by name only
    std::string_view summary;  // for `poinsot list formats`
    FormatKind kind = FormatKind::frames;
    bool film = false;                // several frames in one file
    bool alpha = false;               // keeps transparency
    std::int64_t n_chunk_frames = 1;  // frames of a film that are encoded independently of others
    // Opens a sink. Throws InputError for a plan that the format cannot hold (odd sizes, rate 0),
    // EnvironmentError for failures of the machine. Precondition: check_rate().
    std::unique_ptr<FrameSink> (*open)(const OutputPlan& plan) = nullptr;
    // Like recover_film; null if an unfinished run leaves nothing, or only complete files.
    std::int64_t (*recover)(const std::filesystem::path& path, const SealMetadata& seal) = nullptr;
    // Assembles a film from the entries of its parts, under the plan's name. Null if the frames of
    // a part are complete files, or if the format has no parts.
    void (*join)(FrameEntries& entries, const OutputPlan& plan) = nullptr;
    bool has_parts = false;
    // Cores that the encoder of one process keeps busy, to limit the number of processes; 0: a
    // single process is faster, because only one process encodes.
    int n_cores_a_job = 0;
    double most_fps = 0.0;  // 0: any rate
};

// Throws InputError for more frames per second than the format can show.
void check_rate(const OutputFormat& format, const FrameRate& rate);

std::span<const OutputFormat> output_formats();

// Returns the format for a file name, by suffix; a PNG name with "####" is a sequence. Throws
// InputError that lists the known formats.
const OutputFormat& format_for(const std::filesystem::path& path);

// The suffixes of films in words: ".mp4, .webm, .mov or .gif".
std::string film_suffixes();

// Whether a file name is that of a film in one of these formats.
bool is_written_film_name(const std::filesystem::path& path);

// Whether a file name is that of a page.
bool is_page_name(const std::filesystem::path& path);

// Whether a file name is that of a presentation of slides.
bool is_slides_name(const std::filesystem::path& path);

// Makes a film under its final name from the log of an interrupted run, up to the first gap, and
// returns its number of frames. The rest of the log is removed. Throws: InputError if there is no
// log, or for a file that is not a film; EnvironmentError, and then keeps the log.
std::int64_t recover_film(const std::filesystem::path& path, const SealMetadata& seal = {});

}  // namespace poinsot
