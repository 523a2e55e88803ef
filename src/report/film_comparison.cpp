#include "report/film_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "system/in_parallel.h"

namespace poinsot {

namespace {

constexpr std::size_t most_kept = 5;

// Whether one pair of frames differs more than another.
bool is_worse(const Comparison& a, const Comparison& b) {
    const auto rank = [](const Comparison& m) {
        return std::pair(!m.passes(), m.flip.value_or(m.mean_difference));
    };
    return rank(a) > rank(b);
}

// Keeps a pair among the worst; of frames close to each other only the worst.
void keep(std::int64_t frame, const Comparison& measured, const StoredPicture& expected,
          const StoredPicture& actual, std::int64_t least_apart, std::vector<KeptFrames>& kept) {
    const auto close = std::find_if(kept.begin(), kept.end(), [&](const KeptFrames& each) {
        return frame - each.frame < least_apart;
    });
    if (close != kept.end()) {
        if (!is_worse(measured, close->measured)) return;
        kept.erase(close);
    } else if (kept.size() == most_kept) {
        const auto mildest = std::min_element(kept.begin(), kept.end(),
                                              [](const KeptFrames& a, const KeptFrames& b) {
                                                  return is_worse(b.measured, a.measured);
                                              });
        if (!is_worse(measured, mildest->measured)) return;
        kept.erase(mildest);
    }
    kept.push_back({frame, measured, expected, actual});
}

// Whether two frames are the same, bit for bit.
bool are_equal(const StoredPicture& a, const StoredPicture& b) {
    return a.image == b.image && a.deep == b.deep && a.info.bit_depth == b.info.bit_depth &&
           a.info.colours == b.info.colours;
}

}  // namespace

std::string FilmDifferences::in_words(std::int64_t frame) const {
    if (!rate) return fmt::format("frame {}", frame);
    return fmt::format("frame {} ({:.4g} s)", frame,
                       static_cast<double>(frame) / rate->per_second());
}

FilmDifferences compare_films(FrameStream& expected, FrameStream& actual,
                              const CompareLimits& limits, const FrameExtras& extras,
                              int n_threads) {
    FilmDifferences film;
    film.rate = expected.rate() ? expected.rate() : actual.rate();
    const auto least_apart =
        static_cast<std::int64_t>(std::lround(0.5 * (film.rate ? film.rate->per_second() : 30.0)));
    std::array<StoredPicture, 2> now, next;
    std::array<bool, 2> has_next{};
    const auto read_next = [&](std::size_t i) {
        has_next[i] = (i == 0 ? expected : actual).read(next[i]);
    };
    in_parallel(2, n_threads, read_next);
    bool has_worst = false;
    const auto compare_now = [&](std::int64_t frame) {
        if (are_equal(now[0], now[1])) return;
        const CompareExtras of_frame = extras(frame, now[0].image.width(), now[0].image.height());
        const Comparison measured = compare(now[0], now[1], limits, of_frame);
        if (measured.verdict == Verdict::same) return;
        const bool fails = !measured.passes();
        if (film.n_differing == 0 || (fails && film.n_failing == 0)) film.first = frame;
        ++film.n_differing;
        film.n_failing += fails;
        if (!has_worst || is_worse(measured, film.measured)) {
            film.worst = frame;
            film.measured = measured;
            has_worst = true;
        }
        keep(frame, measured, now[0], now[1], least_apart, film.strip);
    };
    while (has_next[0] && has_next[1]) {
        std::swap(now, next);
        // While these two are compared, the next two are decoded.
        in_parallel(3, n_threads, [&](std::size_t i) {
            if (i < 2)
                read_next(i);
            else
                compare_now(film.n_compared);
        });
        ++film.n_compared;
        if (film.measured.verdict == Verdict::size_differs) break;
    }
    film.n_expected = film.n_actual = film.n_compared;
    const bool is_whole = film.measured.verdict != Verdict::size_differs;
    for (StoredPicture rest; is_whole && has_next[0]; has_next[0] = expected.read(rest))
        ++film.n_expected;
    for (StoredPicture rest; is_whole && has_next[1]; has_next[1] = actual.read(rest))
        ++film.n_actual;
    if (!has_worst && film.n_compared > 0 && is_whole) {
        // Equal as far as both go.
        film.measured.expected_width = film.measured.actual_width = now[0].image.width();
        film.measured.expected_height = film.measured.actual_height = now[0].image.height();
        film.measured.n_pixels =
            std::int64_t{film.measured.expected_width} * film.measured.expected_height;
    }
    return film;
}

std::string in_words(const FilmDifferences& film) {
    std::string words;
    const auto frames = [](std::int64_t n) {
        return fmt::format("{} {}", n, n == 1 ? "frame" : "frames");
    };
    const bool has_length = film.n_expected != film.n_actual;
    if (has_length)
        words = fmt::format("expected {}, found {}; of the first {}, ", frames(film.n_expected),
                            film.n_actual, film.n_compared);
    if (film.n_differing == 0) return has_length ? words + "none differs" : "";
    const std::int64_t n = film.n_failing > 0 ? film.n_failing : film.n_differing;
    const std::string counted =
        has_length ? fmt::format("{}", n) : fmt::format("{} of {}", n, frames(film.n_compared));
    words += fmt::format("{} {}; first {}, worst {}", counted,
                         film.n_failing > 0 ? (n == 1 ? "exceeds the limits" : "exceed the limits")
                         : n == 1           ? "differs within the limits"
                                            : "differ within the limits",
                         film.in_words(film.first), film.in_words(film.worst));
    return words;
}

}  // namespace poinsot
