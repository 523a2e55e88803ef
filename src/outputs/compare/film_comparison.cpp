#include "compare/film_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <tuple>
#include <utility>

#include "system/in_parallel.h"

namespace poinsot {

namespace {

constexpr std::size_t most_kept = 5;

// Whether one pair of frames differs more than another.
bool is_worse(const Comparison& a, const Comparison& b) {
    const auto rank = [](const Comparison& m) {
        return std::tuple(m.verdict == Verdict::size_differs, !m.passes(),
                          m.flip.value_or(m.mean_difference));
    };
    return rank(a) > rank(b);
}

// Keeps a pair among the worst; of each window of so many frames only the worst. Windows that are
// fixed keep several frames of a drift, in which each frame is worse than the one before.
void keep(std::int64_t frame, const Comparison& measured, const StoredPicture& expected,
          const StoredPicture& actual, std::int64_t window, std::vector<KeptFrames>& kept) {
    const auto close = std::find_if(kept.begin(), kept.end(), [&](const KeptFrames& each) {
        return frame / window == each.frame / window;
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

// Frames of one film in a row.
struct Batch {
    std::vector<StoredPicture> frames{1};
    std::vector<std::optional<double>> times_s{1};
    std::size_t n = 0;  // of these frames that were read

    void resize(std::size_t n_frames) {
        frames.resize(n_frames);
        times_s.resize(n_frames);
    }
    // Fills all frames, or as many as the film still has.
    void read(FrameStream& film) {
        for (n = 0; n < frames.size() && film.read(frames[n]); ++n) times_s[n] = film.time_s();
    }
};

// How many pairs are compared at the same time: one for each thread, as far as memory for them and
// for the next ones is not more than for one pair of large pictures.
std::size_t pairs_at_a_time(const Image& frame, int n_threads) {
    constexpr std::int64_t most_pixels = 1 << 23;
    const std::int64_t n_pixels =
        std::max<std::int64_t>(1, std::int64_t{frame.width()} * frame.height());
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(most_pixels / n_pixels, 1, std::max(1, n_threads)));
}

// Counts the differences of pairs of frames, in order.
class DifferenceCount {
 public:
    DifferenceCount(FilmDifferences& film, std::int64_t window) : film_(film), window_(window) {}

    bool has_worst() const { return has_worst_; }

    // Adds frame film.n_compared.
    void add(const Comparison& measured, const StoredPicture& a, const StoredPicture& b) {
        if (measured.verdict == Verdict::same) return;
        const std::int64_t frame = film_.n_compared;
        const bool fails = !measured.passes();
        if (film_.n_differing == 0 || (fails && film_.n_failing == 0)) film_.first = frame;
        ++film_.n_differing;
        film_.n_failing += fails;
        if (!has_worst_ || is_worse(measured, film_.measured)) {
            film_.worst = frame;
            film_.measured = measured;
            has_worst_ = true;
        }
        keep(frame, measured, a, b, window_, film_.strip);
    }

 private:
    FilmDifferences& film_;
    std::int64_t window_;
    bool has_worst_ = false;
};

// The measurement of frames that are equal in all films: their size.
void measure_equal(const Image& frame, Comparison& measured) {
    measured.expected_width = measured.actual_width = frame.width();
    measured.expected_height = measured.actual_height = frame.height();
    measured.n_pixels = std::int64_t{measured.expected_width} * measured.expected_height;
}

}  // namespace

bool are_apart(double expected_s, double actual_s, const std::optional<FrameRate>& rate) {
    // Matroska counts milliseconds, a GIF hundredths.
    constexpr double least_s = 1e-3;
    const double half_a_frame_s = rate ? 0.5 / rate->per_second() : 0.0;
    return std::abs(expected_s - actual_s) > std::max(least_s, half_a_frame_s);
}

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
    const auto window =
        std::max<std::int64_t>(1, std::lround(0.5 * (film.rate ? film.rate->per_second() : 30.0)));
    std::array<Batch, 2> now, next;
    const auto read_next = [&](std::size_t i) { next[i].read(i == 0 ? expected : actual); };
    in_parallel(2, n_threads, read_next);
    const std::size_t n_pairs = pairs_at_a_time(next[0].frames[0].image, n_threads);
    std::mutex asks_extras;
    const auto measure = [&](std::size_t k) -> Comparison {
        const StoredPicture &a = now[0].frames[k], &b = now[1].frames[k];
        if (are_equal(a, b)) return {};
        CompareExtras of_frame;
        {
            const std::lock_guard lock(asks_extras);
            of_frame = extras(film.n_compared + static_cast<std::int64_t>(k), a.image.width(),
                              a.image.height());
        }
        return compare(a, b, limits, of_frame);
    };
    DifferenceCount count(film, window);
    const auto is_whole = [&film] { return film.measured.verdict != Verdict::size_differs; };
    std::vector<Comparison> measured;
    while (is_whole() && next[0].n > 0 && next[1].n > 0) {
        std::swap(now, next);
        for (Batch& batch : next) batch.resize(n_pairs);
        const std::size_t n = std::min(now[0].n, now[1].n);
        measured.assign(n, {});
        // While these pairs are compared, the next ones are decoded.
        in_parallel(2 + n, n_threads, [&](std::size_t i) {
            if (i < 2)
                read_next(i);
            else
                measured[i - 2] = measure(i - 2);
        });
        for (std::size_t k = 0; k < n && is_whole(); ++k, ++film.n_compared) {
            const auto expected_s = now[0].times_s[k], actual_s = now[1].times_s[k];
            if (!film.apart && expected_s && actual_s &&
                are_apart(*expected_s, *actual_s, film.rate))
                film.apart = {film.n_compared, *expected_s, *actual_s};
            count.add(measured[k], now[0].frames[k], now[1].frames[k]);
        }
        if (now[0].n != now[1].n) break;
    }
    film.n_expected = film.n_actual = film.n_compared;
    if (is_whole()) {
        // The rest of the longer one is not decoded only to be counted.
        const auto n_of = [&](std::size_t i, const FrameStream& stream) {
            const bool is_longer = now[i].n > now[1 - i].n || next[i].n > next[1 - i].n;
            return is_longer ? std::max(stream.n_frames(), film.n_compared + 1) : film.n_compared;
        };
        film.n_expected = n_of(0, expected);
        film.n_actual = n_of(1, actual);
    }
    if (!count.has_worst() && film.n_compared > 0)
        measure_equal(now[0].frames[0].image, film.measured);
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
