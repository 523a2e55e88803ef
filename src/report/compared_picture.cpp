#include "report/compared_picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "output/film_metadata.h"
#include "output/frame_name.h"
#include "production/jobs/picture_regions.h"
#include "production/provenance/record.h"
#include "production/provenance/record_difference.h"
#include "report/rendered_page.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/in_parallel.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

Outcome outcome_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return Outcome::same;
        case Verdict::within_limits:
            return Outcome::within_limits;
        case Verdict::size_differs:
            return Outcome::size;
        case Verdict::depth_differs:
            return Outcome::depth;
        case Verdict::colours_differ:
            return Outcome::colours;
        case Verdict::pixels_differ:
            break;
    }
    return Outcome::pixels;
}

bool is_picture_name(const fs::path& file) { return suffix_of(file) == ".png"; }

// Calls a function for every file of a folder and its subfolders, except hidden ones.
template <typename Take>
void for_each_file(const fs::path& folder, const Take& take) {
    std::error_code error;
    fs::recursive_directory_iterator at(folder, error);
    const fs::recursive_directory_iterator end;
    for (; !error && at != end; at.increment(error)) {
        const bool hidden = at->path().filename().string().starts_with('.');
        std::error_code ignored;
        if (at->is_directory(ignored)) {
            if (hidden) at.disable_recursion_pending();
        } else if (!hidden) {
            take(at->path());
        }
    }
    if (error)
        throw InputError(fmt::format("{}: {}; give a folder of pictures",
                                     printable(folder.string()), error.message()));
}

// The files of a folder that can be compared, by name.
std::map<std::string, fs::path> pictures_in(const fs::path& folder) {
    std::map<std::string, fs::path> found;
    for_each_file(folder, [&](const fs::path& path) {
        if (!is_comparable(path)) return;
        const fs::path name = path.lexically_relative(folder);
        if (!is_picture_name(path)) {
            found.emplace(name.generic_string(), path);
            return;
        }
        // turn.png and turn.PNG are two pictures.
        if (!found.emplace(fs::path(name).replace_extension().generic_string(), path).second)
            found.emplace(name.generic_string(), path);
    });
    return found;
}

std::optional<Record> record_of(const fs::path& file) {
    try {
        return read_record(file);
    } catch (const InputError&) {
        return std::nullopt;  // rendered by another program
    }
}

// What a pair may use of the machine beside the other pairs of its folder.
class MachineShare {
 public:
    // Of a pair alone.
    explicit MachineShare(int n_threads) : n_threads_(n_threads), n_threads_alone_(n_threads) {}
    MachineShare(int n_threads, int n_threads_alone, std::mutex& large_pairs)
        : n_threads_(n_threads),
          n_threads_alone_(n_threads_alone),
          alone_(large_pairs, std::defer_lock) {}

    // With so many pixels in each of the two, waits until no other large pair is in memory.
    void need(std::int64_t n_pixels) {
        constexpr std::int64_t many_pixels = 1 << 24;
        if (n_pixels > many_pixels && alone_.mutex() != nullptr && !alone_.owns_lock())
            alone_.lock();
    }
    void need(const fs::path& png) {
        if (alone_.mutex() == nullptr || kind_of_file(png) != FileKind::regular) return;
        try {
            const PngInfo info = read_png_info(png);
            need(std::int64_t{info.width_px} * info.height_px);
        } catch (const Error&) {
            return;  // reported when it is compared
        }
    }
    int n_threads() const { return alone_.owns_lock() ? n_threads_alone_ : n_threads_; }

 private:
    int n_threads_, n_threads_alone_;
    std::unique_lock<std::mutex> alone_;
};

// Whether both are regular files of the same bytes; the reader of pictures reports files that
// cannot be read.
bool have_same_bytes(const fs::path& a, const fs::path& b) {
    if (kind_of_file(a) != FileKind::regular || kind_of_file(b) != FileKind::regular) return false;
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
    // In pieces: films may be larger than memory.
    std::array<std::ifstream, 2> files{std::ifstream(a, std::ios::binary),
                                       std::ifstream(b, std::ios::binary)};
    std::array<std::string, 2> pieces{std::string(1 << 20, '\0'), std::string(1 << 20, '\0')};
    for (;;) {
        for (std::size_t i = 0; i < 2; ++i) {
            files[i].read(pieces[i].data(), std::ssize(pieces[i]));
            pieces[i].resize(static_cast<std::size_t>(files[i].gcount()));
            if (files[i].bad() || !files[i].is_open()) return false;
        }
        if (pieces[0] != pieces[1]) return false;
        if (files[0].eof() || files[1].eof()) return files[0].eof() && files[1].eof();
    }
}

// The records of a pair; none for files by other programs.
struct Records {
    std::optional<Record> expected, actual;
};

// The regions to ignore in a pair: rectangles, and what the records say of names.
class IgnoredRegions {
 public:
    // Throws InputError where neither record can say where a name is.
    IgnoredRegions(std::vector<IgnoredRegion> regions, const Records& records)
        : regions_(std::move(regions)) {
        for (const IgnoredRegion& region : regions_)
            if (!region.rectangle) names_.push_back(region.text);
        if (names_.empty()) return;
        for (const auto* record : {&records.expected, &records.actual}) {
            if (!*record) continue;
            pictures_.emplace_back(**record);
            first_frames_.push_back(
                (*record)->frames ? (*record)->frame.value_or((*record)->frames->first) : 0);
        }
        if (pictures_.empty())
            throw InputError(fmt::format(
                "neither picture has a record that says where to find {}; ignore a rectangle "
                "instead, as 0,0,100%,10%, or ignore the name only in pictures by poinsot, with "
                "[[pictures]] in {}",
                fmt::join(names_, ", "), compare_file_name));
    }

    // `frame`: of a film, from its first.
    std::vector<PictureRegion> in(int width, int height, std::int64_t frame = 0) {
        std::vector<PictureRegion> all;
        for (const IgnoredRegion& region : regions_)
            if (region.rectangle) all.push_back(region.in(width, height));
        for (std::size_t i = 0; i < pictures_.size(); ++i) {
            const std::vector<PictureRegion> named =
                pictures_[i].regions_of(names_, width, first_frames_[i] + frame, found_);
            all.insert(all.end(), named.begin(), named.end());
        }
        return all;
    }
    const std::set<std::string>& found() const { return found_; }

 private:
    std::vector<IgnoredRegion> regions_;
    std::vector<std::string> names_;
    std::vector<PictureRegions> pictures_;  // as the records describe them
    std::vector<std::int64_t> first_frames_;
    std::set<std::string> found_;
};

constexpr std::string_view nothing_left =
    "the ignored regions cover the whole picture, so nothing is compared; ignore less";

// Says how many pixels were ignored, and why.
void tell_ignored(ComparedPicture& result) {
    const std::int64_t n = result.measured.n_ignored;
    if (n == 0 || result.reason.empty()) return;
    result.reason += fmt::format("; {} {} ignored ({})", n, n == 1 ? "pixel" : "pixels",
                                 printable(fmt::format("{}", fmt::join(result.ignored, "; "))));
}

// Compares two pictures in memory. Throws InputError.
void compare_pictures(const StoredPicture& expected, const StoredPicture& actual,
                      const Records& records, const CompareRequest& request, const Gates& gates,
                      ComparedPicture& result) {
    CompareExtras extras{.ssim = request.ssim, .flip = request.flip};
    const bool same_size = expected.image.width() == actual.image.width() &&
                           expected.image.height() == actual.image.height();
    const bool same_pixels =
        same_size && expected.image == actual.image && expected.deep == actual.deep;
    if (same_size && !same_pixels && !gates.ignore.empty()) {
        try {
            IgnoredRegions regions(gates.ignore, records);
            extras.ignored = regions.in(expected.image.width(), expected.image.height());
            result.found_regions = regions.found();
        } catch (const InputError& error) {
            result.outcome = Outcome::region;
            result.reason = error.what();
            return;
        }
    }
    result.measured = compare(expected, actual, result.limits, extras);
    result.outcome = outcome_of(result.measured.verdict);
    result.reason = result.measured.reason;
    tell_ignored(result);
    if (same_size && !same_pixels && result.measured.n_pixels == 0) {
        result.outcome = Outcome::region;
        result.reason = nothing_left;
    }
    if (result.outcome != Outcome::same && request.seen)
        request.seen(result, {expected, actual, result.limits, extras.ignored, {}});
}

// A record in the metadata of a picture.
std::optional<Record> record_in(const PngInfo& info, const fs::path& file) {
    const auto text = info.texts.find(metadata_name);
    if (text == info.texts.end()) return std::nullopt;
    try {
        return parse_record(text->second, file.string());
    } catch (const InputError&) {
        return std::nullopt;
    }
}

// Says what the records of two files that differ say.
void tell_changes(const Records& records, ComparedPicture& result) {
    if (result.outcome == Outcome::same || !records.expected || !records.actual) return;
    try {
        result.changes = differences_in_words(*records.expected, *records.actual);
    } catch (const InputError&) {
        // The scene of an old record is no TOML for this program.
    }
}

// The header's width and height (PNG specification §11.2.2); empty for what is no regular file.
std::string stated_size_of(const fs::path& png) {
    constexpr std::size_t at = 16, n_bytes = 8;
    if (kind_of_file(png) != FileKind::regular) return "";
    const std::string beginning = read_beginning(png, at + n_bytes);
    return beginning.size() < at + n_bytes ? "" : beginning.substr(at);
}

// Whether two pictures have different sizes, which their headers say.
bool sizes_differ(ComparedPicture& result) {
    if (stated_size_of(result.expected) == stated_size_of(result.actual)) return false;
    const PngInfo a = read_png_info(result.expected), b = read_png_info(result.actual);
    if (a.width_px == b.width_px && a.height_px == b.height_px) return false;
    result.measured = size_difference(a.width_px, a.height_px, b.width_px, b.height_px);
    result.outcome = Outcome::size;
    result.reason = result.measured.reason;
    tell_changes({record_in(a, result.expected), record_in(b, result.actual)}, result);
    return true;
}

void compare_pages(const CompareRequest& request, const Gates& gates, MachineShare& share,
                   ComparedPicture& result) {
    if (have_same_bytes(result.expected, result.actual)) return;
    RenderedPages pages;
    const fs::path expected_png = pages.picture_of(result.expected);
    const fs::path actual_png = pages.picture_of(result.actual);
    share.need(expected_png);
    share.need(actual_png);
    const StoredPicture expected = request.read(expected_png);
    const StoredPicture actual = request.read(actual_png);
    const Records records{record_of(result.expected), record_of(result.actual)};
    compare_pictures(expected, actual, records, request, gates, result);
    tell_changes(records, result);
}

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

// Where players put the pictures is theirs to choose.
DisplayMatrix without_place(DisplayMatrix display) {
    display[6] = display[7] = 0;
    return display;
}

// What two films say of colours, where both say something.
bool name_different_colours(const std::string& a, const std::string& b) {
    const auto says_none = [](const std::string& name) {
        return name.empty() || name == "unknown";
    };
    return !says_none(a) && !says_none(b) && a != b;
}

// What a player shows differently whatever the frames are; a sequence is shown as it is stored.
void compare_what_films_say(const FrameStream& expected, const FrameStream& actual,
                            ComparedPicture& result) {
    const VideoInfo as_stored;
    const VideoInfo& a = expected.info() ? *expected.info() : as_stored;
    const VideoInfo& b = actual.info() ? *actual.info() : as_stored;
    const auto say = [&result](Outcome outcome, std::string reason) {
        result.outcome = outcome;
        result.reason = std::move(reason);
    };
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

void compare_two_films(const CompareRequest& request, const Gates& gates, MachineShare& share,
                       ComparedPicture& result) {
    FrameStream expected(result.expected), actual(result.actual);
    if (have_same_bytes(result.expected, result.actual)) return;
    Records records{record_of(expected.file()), record_of(actual.file())};
    name_first_frame(records.expected);
    name_first_frame(records.actual);
    compare_what_films_say(expected, actual, result);
    if (result.outcome != Outcome::same) {
        tell_changes(records, result);
        return;
    }
    std::optional<IgnoredRegions> regions;
    try {
        regions.emplace(gates.ignore, records);
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
        tell_ignored(result);
    }
    if (film.measured.n_ignored > 0 && film.measured.n_pixels == 0) {
        result.outcome = Outcome::region;
        result.reason = nothing_left;
    }
    tell_changes(records, result);
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

// The kinds of files, as far as one is compared with its like.
enum class Kind { picture, page, film };
Kind kind_of_name(const fs::path& file) {
    if (is_film_name(file) || is_sequence_name(file)) return Kind::film;
    return is_vector_page_name(file) ? Kind::page : Kind::picture;
}

FileKind kind_of_compared(const fs::path& file) {
    if (!is_sequence_name(file)) return kind_of_file(file);
    return frames_there(file).empty() ? FileKind::missing : FileKind::regular;
}

}  // namespace

bool is_comparable(const fs::path& file) {
    return is_picture_name(file) || is_vector_page_name(file) || is_film_name(file);
}

void check_regions(const Gates& gates, const fs::path& picture) {
    const IgnoredRegions findable(gates.ignore, {record_of(picture), {}});
}

std::vector<fs::path> other_pictures_in(const fs::path& folder) {
    constexpr std::array<std::string_view, 6> suffixes{".jpg",  ".jpeg", ".webp",
                                                       ".tiff", ".tif",  ".bmp"};
    std::vector<fs::path> found;
    for_each_file(folder, [&](const fs::path& path) {
        const std::string suffix = suffix_of(path);
        if (std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end())
            found.push_back(path.lexically_relative(folder));
    });
    std::sort(found.begin(), found.end());
    return found;
}

std::string ComparedPicture::line() const {
    constexpr std::size_t most_changes = 5;
    std::string text;
    if (changes && changes->empty() && outcome == Outcome::pixels)
        text = "scene, settings and versions are the same; ";
    for (std::size_t i = 0; changes && i < std::min(changes->size(), most_changes); ++i)
        text += (*changes)[i] + "; ";
    if (changes && changes->size() > most_changes)
        text += fmt::format("and {} more changes; ", changes->size() - most_changes);
    return text + reason;
}

std::string_view name_of(Outcome outcome) {
    constexpr std::array<std::string_view, 14> names{
        "unreadable", "missing", "baseline", "renderer", "size",       "rate",          "length",
        "depth",      "colours", "region",   "pixels",   "unexpected", "within limits", "same"};
    return names.at(static_cast<std::size_t>(outcome));
}

std::optional<CompareLimits> limits_between(const Baseline& approved, std::string_view renderer,
                                            std::string_view mesa) {
    if (is_foreign(approved)) return CompareLimits::exact();
    if (approved.renderer == renderer && approved.mesa == mesa) return CompareLimits::exact();
    const auto is_llvmpipe = [](std::string_view name) { return name.starts_with("llvmpipe"); };
    if (!is_llvmpipe(approved.renderer) || !is_llvmpipe(renderer)) return std::nullopt;
    return CompareLimits{.differing_share = 1e-3, .level = 1, .over_level_share = 0.0};
}

namespace {

ComparedPicture compare_pair(const std::string& name, const fs::path& expected,
                             const fs::path& actual, const CompareRequest& request,
                             const Baselines* baselines, const std::string& baseline_name,
                             MachineShare& share) {
    ComparedPicture result;
    result.name = name;
    if (kind_of_compared(expected) != FileKind::missing) result.expected = expected;
    if (kind_of_compared(actual) != FileKind::missing) result.actual = actual;
    const bool is_listed = baselines != nullptr && baselines->manifest().contains(baseline_name);
    if (result.expected.empty() && is_listed) {
        result.outcome = Outcome::baseline;
        result.reason = fmt::format(
            "{} names this baseline, but the picture is missing; restore it, approve a new one, or "
            "remove its line with poinsot approve --remove",
            manifest_name);
        return result;
    }
    if (result.actual.empty()) {
        result.outcome = Outcome::missing;
        result.reason = "the baseline exists, but the new file is missing";
        return result;
    }
    if (result.expected.empty()) {
        result.outcome = Outcome::unexpected;
        result.reason = fmt::format("this {} has no baseline; approve it if it is right",
                                    is_picture_name(actual) ? "picture" : "file");
        return result;
    }
    const Gates gates =
        request.gates.over(request.file ? request.file->gates_of(baseline_name) : Gates{});
    for (const IgnoredRegion& region : gates.ignore) result.ignored.push_back(region.text);
    std::optional<CompareLimits> by_renderer = CompareLimits::exact();
    if (!request.limits && !gates.decides() && is_listed) {
        const Baseline& approved = baselines->manifest().at(baseline_name);
        if (const auto now = record_of(actual))
            by_renderer = limits_between(approved, now->renderer, now->mesa);
        if (!by_renderer) {
            result.outcome = Outcome::renderer;
            result.reason = fmt::format(
                "drawn by another renderer than the baseline ({}, Mesa {}); draw it with the same "
                "renderer, or set with --profile how much may differ",
                printable(approved.renderer), printable(approved.mesa));
            return result;
        }
    }
    result.limits = limits_of(gates, request.limits, *by_renderer);
    const auto report_fault = [&](const std::string& hash) {
        std::string fault = baselines->fault(baseline_name, hash);
        if (fault.empty()) return;
        result.outcome = Outcome::baseline;
        result.reason = std::move(fault);
    };
    try {
        const Kind kind = kind_of_name(expected);
        if (kind != kind_of_name(actual))
            throw InputError(fmt::format(
                "{} and {}: different kinds of files; give two pictures, two films, or two vector "
                "figures",
                printable(expected.string()), printable(actual.string())));
        if (kind != Kind::picture) {
            if (kind == Kind::page)
                compare_pages(request, gates, share, result);
            else
                compare_two_films(request, gates, share, result);
            // Those that were never approved need no line in the manifest.
            if (is_listed) report_fault(pixel_hash_of_file(expected));
            return result;
        }
        // With a manifest, the pixels of the baseline are checked whatever the sizes.
        const bool has_manifest = baselines != nullptr && baselines->has_manifest();
        if (!request.seen && !has_manifest && sizes_differ(result)) return result;
        share.need(expected);
        share.need(actual);
        // Of two files of the same bytes one is read, to see that it is a whole PNG.
        const StoredPicture picture = request.read(expected);
        if (have_same_bytes(expected, actual)) {
            result.measured = compare(picture, picture, CompareLimits::exact());
        } else {
            const StoredPicture other = request.read(actual);
            const Records records{record_in(picture.info, expected), record_in(other.info, actual)};
            compare_pictures(picture, other, records, request, gates, result);
            tell_changes(records, result);
        }
        if (has_manifest) report_fault(pixels_sha256(picture));
    } catch (const InputError& error) {
        result.outcome = Outcome::unreadable;
        result.reason = error.what();
    }
    return result;
}

}  // namespace

ComparedPicture compare_files(const std::string& name, const fs::path& expected,
                              const fs::path& actual, const CompareRequest& request,
                              const Baselines* baselines, const std::string& baseline_name) {
    MachineShare whole(request.n_threads);
    return compare_pair(name, expected, actual, request, baselines,
                        baseline_name.empty() ? name : baseline_name, whole);
}

std::vector<ComparedPicture> compare_folders(const fs::path& expected, const fs::path& actual,
                                             const CompareRequest& request) {
    const auto expected_files = pictures_in(expected);
    const auto actual_files = pictures_in(actual);
    std::map<std::string, std::pair<fs::path, fs::path>> names;
    for (const auto& [name, path] : expected_files) names[name].first = path;
    for (const auto& [name, path] : actual_files) names[name].second = path;
    const Baselines baselines(expected);
    for (const auto& [name, line] : baselines.manifest()) names[name];
    if (names.empty())
        throw InputError(
            fmt::format("{} and {}: neither contains a picture, a film or a figure (.png, .mp4, "
                        ".webm, .gif, .pdf, .svg); nothing to compare",
                        printable(expected.string()), printable(actual.string())));
    const std::vector<std::pair<std::string, std::pair<fs::path, fs::path>>> pairs(names.begin(),
                                                                                   names.end());
    if (request.file) {
        std::vector<std::string> all;
        all.reserve(pairs.size());
        for (const auto& [name, paths] : pairs) all.push_back(name);
        request.file->check_used(all);
    }
    std::vector<ComparedPicture> results(pairs.size());
    std::mutex large_pairs;
    const int n_threads_each = std::max(
        1, request.n_threads / static_cast<int>(std::min<std::size_t>(pairs.size(), 1 << 16)));
    in_parallel(pairs.size(), request.n_threads, [&](std::size_t i) {
        const auto& [name, paths] = pairs[i];
        MachineShare share(n_threads_each, request.n_threads, large_pairs);
        try {
            results[i] =
                compare_pair(name, paths.first, paths.second, request, &baselines, name, share);
        } catch (const NoRasteriser& error) {
            // Without the program that renders pages, the other files are still compared.
            results[i] = {.name = name,
                          .expected = paths.first,
                          .actual = paths.second,
                          .outcome = Outcome::unreadable,
                          .reason = error.what()};
        }
    });
    return results;
}

void sort_by_severity(std::vector<ComparedPicture>& pictures) {
    const auto rank = [](const ComparedPicture& p) {
        const Comparison& m = p.measured;
        const double difference = m.flip.value_or(m.mean_difference);
        return std::make_tuple(p.outcome, -difference, std::string_view(p.name));
    };
    std::stable_sort(pictures.begin(), pictures.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

bool all_pass(std::span<const ComparedPicture> pictures) {
    return std::all_of(pictures.begin(), pictures.end(),
                       [](const ComparedPicture& p) { return p.passes(); });
}

}  // namespace poinsot
