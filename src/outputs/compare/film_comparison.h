// Compares two films frame by frame, holding a few frames of each in memory, and the
// worst five pairs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/frame_stream.h"

namespace poinsot {

// A pair of frames that differ, kept for a strip.
struct KeptFrames {
    std::int64_t frame = 0;
    Comparison measured;
    StoredPicture expected, actual;
    std::vector<PictureRegion> ignored{};  // set by who shows them
};

struct FilmDifferences {
    std::optional<FrameRate> rate;  // of the films; none for two sequences
    std::int64_t n_expected = 0, n_actual = 0, n_compared = 0;  // frames
    std::int64_t n_differing = 0;  // frames with any difference that is not ignored
    std::int64_t n_failing = 0;    // frames that exceed the limits
    std::int64_t first = 0;        // the first of these, or else the first that differs
    std::int64_t worst = 0;        // the one that differs most
    Comparison measured;           // of the worst
    // The first frame that the films show at instants more than half a frame apart.
    struct Instants {
        std::int64_t frame = 0;
        double expected_s = 0, actual_s = 0;
    };
    std::optional<Instants> apart;
    // Up to five of the worst frames, one of each half second, in their order; the worst is among
    // them.
    std::vector<KeptFrames> strip;

    // "frame 12 (0.4 s)"; without a rate "frame 12".
    std::string in_words(std::int64_t frame) const;
};

// Whether two instants of films of this rate are more than half a frame apart: containers round
// their times.
bool are_apart(double expected_s, double actual_s, const std::optional<FrameRate>& rate);

// Extras for a frame whose pixels differ: what to ignore there. Called by one thread at a time, for
// frames in any order.
using FrameExtras = std::function<CompareExtras(std::int64_t frame, int width, int height)>;

// Streams both films; at most n_threads threads decode and compare. Frames of different sizes end
// the comparison, with that verdict. Throws InputError for a film that cannot be read.
FilmDifferences compare_films(FrameStream& expected, FrameStream& actual,
                              const CompareLimits& limits, const FrameExtras& extras,
                              int n_threads);

// Where the films differ, in one line, without the counts of pixels.
std::string in_words(const FilmDifferences& film);

}  // namespace poinsot
