// Images → files. A sink takes video frames in order and makes one whole output, or nothing under
// the final name.
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

#include "image/image.h"
#include "output/film_part.h"

namespace poinsot {

struct FrameRate {
    std::int64_t numerator = 30;
    std::int64_t denominator = 1;
    double per_second() const {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }
};

// A named section, in frames of the output counted from its first.
struct FilmChapter {
    std::string title;
    std::int64_t first_frame = 0;
    std::int64_t end_frame = 0;  // one past its last
};

// Text that stands under the picture, or at its top, for a while: plain, without empty lines;
// milliseconds of the output from its first frame.
struct FilmSubtitle {
    std::string text;
    std::int64_t begin_ms = 0, end_ms = 0;
    bool at_top = false;
};

// The millisecond of the output at which frame n of it is shown, to the nearest.
constexpr std::int64_t milliseconds_of(std::int64_t n, const FrameRate& rate) {
    return (2000 * n * rate.denominator + rate.numerator) / (2 * rate.numerator);
}

// What an output can say of itself only when it is made.
struct Contents {
    std::int64_t n_frames = 0;               // of a film
    std::string packets = {};                // of a film: see output/film_packets.h
    std::optional<std::int64_t> frame = {};  // of a numbered picture
    std::string pixels = {};                 // of a picture: see image/pixel_check.h
};

// The text that an output carries, from the one that its plan has.
using Tell = std::function<std::string(const std::string& metadata, const Contents& contents)>;

// What every output needs to know before its first frame.
struct OutputPlan {
    std::filesystem::path path;  // final name; "####" in a PNG name is the frame number
    int width_px = 0, height_px = 0;
    FrameRate rate;
    std::int64_t first_frame = 0;     // number of the first frame written, for sequences
    std::int64_t n_frames = 0;        // how many will come
    std::string quality = "lecture";  // a name of output/quality.h
    int encoder_threads = 0;          // 0: chosen by the sink
    std::string metadata;             // text carried in the file
    Tell tell;                        // makes that text of it; without, it is carried as it is
    // Of the frames that come, a film has the first so many; 0: all. Its packets are those of a
    // film that goes on, as those of one that was recovered are.
    std::int64_t n_shown = 0;
    std::vector<FilmChapter> chapters;    // where the container can, in order
    std::vector<FilmSubtitle> subtitles;  // likewise, two at once at most: below and at the top
    // Go on from what an interrupted run with the same plan has left aside, and leave it aside when
    // interrupted again. Formats that cannot start from the first frame.
    bool resume = false;
    // Of those frames, n_frames from the n_before-th on, as a part of the film; metadata, chapters
    // and first_frame stay the film's. Formats that have parts.
    std::optional<FilmPart> part = {};
    // Whether the film's first frame is transparent anywhere; known to a part that begins later.
    std::optional<bool> has_alpha = {};
};

// Called on the thread that writes, once a frame.
using WasRead = std::function<void()>;

// write() in frame order, then finish(); a sink destroyed unfinished leaves nothing under the final
// name. From one thread at a time.
class FrameSink {
 public:
    virtual ~FrameSink() = default;
    // How many frames an interrupted run has left: write() starts with the one after them.
    virtual std::int64_t n_frames_kept() const { return 0; }
    // Whether a frame, counted from the plan's first, is there. write() is given those that are
    // not, in their order; of a sequence, one here and there may be missing.
    virtual bool has_frame(std::int64_t frame) const { return frame < n_frames_kept(); }
    virtual void write(const Image& frame) = 0;  // throws EnvironmentError
    // The same, telling as soon as the picture is not needed any more.
    virtual void write_telling(const Image& frame, const WasRead& was_read) {
        write(frame);
        was_read();
    }
    virtual void finish() = 0;  // flushes, syncs and renames; throws EnvironmentError
};

class FrameEntries;  // see output/frame_log.h

// A row of the table of formats.
struct OutputFormat {
    std::string_view name;        // "mp4"
    std::string_view suffix;      // ".mp4"; empty for those chosen by name only
    std::string_view summary;     // for `poinsot list formats`
    bool film;                    // several frames in one file
    bool alpha;                   // keeps transparency
    std::int64_t n_chunk_frames;  // frames of a film that are encoded without knowing of others
    // Throws InputError for what the format cannot hold (odd sizes, rate 0), EnvironmentError for
    // what the machine refuses. Precondition: check_rate().
    std::unique_ptr<FrameSink> (*open)(const OutputPlan& plan);
    // As recover_film; null where nothing unfinished is left, or is whole as it is.
    std::int64_t (*recover)(const std::filesystem::path& path, const Tell& tell);
    // Puts a film together from the entries of its parts, under the plan's name. Null where a
    // part's frames are whole as they are, or where there are no parts.
    void (*join)(FrameEntries& entries, const OutputPlan& plan);
    bool has_parts;
    // Cores that a process keeps busy with its encoder, so that more of them would only wait for
    // each other; 0: one process ends sooner, since it encodes alone.
    int n_cores_a_job;
    double most_fps = 0.0;  // 0: any rate
};

// Throws InputError for more frames a second than the format can show.
void check_rate(const OutputFormat& format, const FrameRate& rate);

std::span<const OutputFormat> output_formats();

// The format that a file name asks for: by suffix, a "####" PNG name being a sequence. Throws
// InputError listing the known.
const OutputFormat& format_for(const std::filesystem::path& path);

// Makes a film of what an interrupted run has left aside, as far as it goes without a gap, under
// the final name, and returns its number of frames. The rest aside is removed. Throws: InputError
// if nothing was left, or for what is no film; EnvironmentError, and then leaves what was aside.
std::int64_t recover_film(const std::filesystem::path& path, const Tell& tell = {});

}  // namespace poinsot
