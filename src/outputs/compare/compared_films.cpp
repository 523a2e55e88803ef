#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "compare/file_pair.h"
#include "compare/frame_stream.h"
#include "error/error.h"

namespace poinsot {

namespace {

// Whether two films drift apart by less than half a frame over their length: the times of a GIF are
// in hundredths of a second, so that its rate is not exactly that of the film it shows.
bool rates_agree(const FrameStream& a, const FrameStream& b) {
    const auto rate_a = a.rate(), rate_b = b.rate();
    if (!rate_a || !rate_b) return true;
    const auto n_frames = static_cast<double>(std::max(a.n_frames(), b.n_frames()));
    return std::abs(rate_a->per_second() / rate_b->per_second() - 1.0) * n_frames < 0.5;
}

// How a player turns or mirrors the pictures, in words.
std::string in_words(const DisplayMatrix& display) {
    constexpr std::int32_t one = upright[0];
    struct Way {
        std::array<std::int32_t, 4> turn;
        std::string_view words;
    };
    constexpr std::array ways{Way{{one, 0, 0, one}, "upright"},
                              Way{{0, one, -one, 0}, "turned by 90° clockwise"},
                              Way{{-one, 0, 0, -one}, "turned by 180°"},
                              Way{{0, -one, one, 0}, "turned by 90° counter-clockwise"},
                              Way{{-one, 0, 0, one}, "mirrored left to right"},
                              Way{{one, 0, 0, -one}, "mirrored top to bottom"}};
    for (const Way& way : ways)
        if (std::array{display[0], display[1], display[3], display[4]} == way.turn)
            return std::string(way.words);
    return "turned, mirrored or stretched in another way";
}

// Players choose the place of the pictures.
DisplayMatrix without_place(DisplayMatrix display) {
    display[6] = display[7] = 0;
    return display;
}

// Whether both films name a colour property, and name it differently.
bool name_different_colours(const std::string& a, const std::string& b) {
    const auto says_none = [](const std::string& name) {
        return name.empty() || name == "unknown";
    };
    return !says_none(a) && !says_none(b) && a != b;
}

// Compares the properties of films that change what a player shows of the same frames; a sequence
// is shown as it is stored.
void compare_film_headers(const FrameStream& expected, const FrameStream& actual,
                          ComparedPicture& result) {
    const VideoInfo as_stored;
    const VideoInfo& a = expected.info() ? *expected.info() : as_stored;
    const VideoInfo& b = actual.info() ? *actual.info() : as_stored;
    const auto say = [&result](Outcome outcome, std::string reason) {
        result.outcome = outcome;
        result.reason = std::move(reason);
    };
    if (a.is_shown != b.is_shown)
        return say(Outcome::size,
                   fmt::format("expected a track of pictures that is switched {}, "
                               "found one that is switched {}",
                               a.is_shown ? "on" : "off", b.is_shown ? "on" : "off"));
    if (without_place(a.display) != without_place(b.display))
        return say(Outcome::size, fmt::format("expected pictures that are shown {}, found {}",
                                              in_words(a.display), in_words(b.display)));
    if (a.pixel_width * b.pixel_height != b.pixel_width * a.pixel_height)
        return say(Outcome::size,
                   fmt::format("expected a pixel aspect of {}:{}, found {}:{}", a.pixel_width,
                               a.pixel_height, b.pixel_width, b.pixel_height));
    if (name_different_colours(a.primaries, b.primaries) ||
        name_different_colours(a.transfer, b.transfer))
        return say(Outcome::colours,
                   fmt::format("expected the primaries {} and the transfer {}, found {} and {}",
                               a.primaries, a.transfer, b.primaries, b.transfer));
    if (!rates_agree(expected, actual))
        return say(Outcome::rate,
                   fmt::format("expected {:.6g} frames a second, found {:.6g}",
                               expected.rate()->per_second(), actual.rate()->per_second()));
}

// Whether two films of the same frames are over at different instants.
std::string end_apart(const FrameStream& expected, const FrameStream& actual,
                      const FilmDifferences& film) {
    const VideoInfo *const a = expected.info(), *const b = actual.info();
    if (a == nullptr || b == nullptr) return "";
    // A film that was written into a pipe does not say it.
    const bool both_say = a->duration_s > 0.0 && b->duration_s > 0.0;
    if (!both_say || !are_apart(a->duration_s, b->duration_s, film.rate)) return "";
    return fmt::format("expected {:.4g} s, found {:.4g} s", a->duration_s, b->duration_s);
}

// Of a film, the record of the first frame, whether it is a film or a sequence.
void name_first_frame(std::optional<Record>& record) {
    if (record && record->frames && !record->frame) record->frame = record->frames->first;
}

}  // namespace

void compare_two_films(const CompareRequest& request, const GivenLimits& given, MachineShare& share,
                       ComparedPicture& result) {
    FrameStream expected(result.expected), actual(result.actual);
    if (have_same_bytes(result.expected, result.actual)) return;
    Records records{find_record(expected.file()), find_record(actual.file())};
    name_first_frame(records.expected);
    name_first_frame(records.actual);
    compare_film_headers(expected, actual, result);
    if (result.outcome != Outcome::same) {
        add_record_differences(records, result);
        return;
    }
    std::optional<IgnoredRegions> regions;
    try {
        regions.emplace(given.ignore, records);
    } catch (const InputError& error) {
        result.outcome = Outcome::region;
        result.reason = error.what();
        return;
    }
    // A comparison of films holds up to eight pairs of frames: the worst ones and the present ones.
    share.need(8 * std::max(expected.frame_pixels(), actual.frame_pixels()));
    FilmDifferences film = compare_films(
        expected, actual, result.limits,
        [&](std::int64_t frame, int width, int height) {
            return CompareExtras{request.ssim, request.flip, regions->in(width, height, frame)};
        },
        share.n_threads());
    result.measured = film.measured;
    result.found_regions = regions->found();
    result.outcome = outcome_of(film.measured.verdict);
    if (result.outcome == Outcome::size) {
        result.reason = film.measured.reason;
        if (film.worst > 0)
            result.reason = fmt::format("{}: {}", film.in_words(film.worst), result.reason);
    } else {
        result.reason = in_words(film);
        if (!film.measured.reason.empty())
            result.reason += fmt::format("; there {}", film.measured.reason);
        std::string times;
        if (film.n_expected != film.n_actual) {
            result.outcome = Outcome::length;
        } else if (film.apart) {
            times = fmt::format("frame {} is shown at {:.4g} s instead of {:.4g} s",
                                film.apart->frame, film.apart->actual_s, film.apart->expected_s);
        } else {
            times = end_apart(expected, actual, film);
        }
        if (!times.empty()) {
            result.outcome = Outcome::rate;
            result.reason = times + (result.reason.empty() ? "" : "; " + result.reason);
        }
        add_ignored_pixels(result);
    }
    if (film.measured.n_ignored > 0 && film.measured.n_pixels == 0) {
        result.outcome = Outcome::region;
        result.reason = nothing_left;
    }
    add_record_differences(records, result);
    if (request.seen && !film.strip.empty()) {
        for (KeptFrames& kept : film.strip)
            kept.ignored =
                regions->in(kept.expected.image.width(), kept.expected.image.height(), kept.frame);
        const KeptFrames& worst =
            *std::find_if(film.strip.begin(), film.strip.end(),
                          [&](const KeptFrames& kept) { return kept.frame == film.worst; });
        request.seen(result,
                     {worst.expected, worst.actual, result.limits, worst.ignored, film.strip});
    }
    for (KeptFrames& kept : film.strip) kept.expected = {}, kept.actual = {};
    result.film = std::move(film);
}

}  // namespace poinsot
