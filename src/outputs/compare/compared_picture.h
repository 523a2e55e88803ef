// Compares two pictures, films or vector figures, or two folders of them, in one pass; reports,
// test results and exit codes follow from the outcomes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/baselines.h"
#include "compare/compare.h"
#include "compare/compare_file.h"
#include "compare/film_comparison.h"
#include "compare/given_limits.h"
#include "image/files/png_files.h"
#include "image/png.h"
#include "system/files/processor.h"

namespace poinsot {

// In order of severity.
enum class Outcome {
    unreadable,  // one of the two is not a complete picture or film
    missing,     // expected, but does not exist
    baseline,    // the baseline is not the approved picture
    renderer,    // rendered by another kind of renderer than the baseline
    size,        // exists, in another size, or a film that is shown turned or stretched
    rate,        // a film with frames at other times
    length,      // a film with another number of frames
    depth,       // with another number of bits per component
    colours,     // with samples in another colour space
    region,      // a region to be ignored is unknown, or leaves nothing to compare
    pixels,      // more pixels differ than allowed
    unexpected,  // exists, but has no baseline
    within_limits,
    same
};

// "missing", "within limits".
std::string_view name_of(Outcome outcome);

// The pictures of a pair that the report shows, as addresses in its page; empty: none.
struct ShownPictures {
    std::string expected, actual, difference;
    std::int64_t n_faint_left_out = 0;  // pixels that `difference` does not show
    std::string strip;                  // of films: rows of expected | difference × 16 | actual
};

struct ComparedPicture {
    std::string name{};  // path within the folder, without ".png"; with the suffix of other files
    std::filesystem::path expected{}, actual{};  // files; empty if missing
    Outcome outcome = Outcome::same;
    std::string reason{};  // one line; empty if the pictures are equal
    // The differences between the two records; none if a record is missing or if the pictures are
    // equal.
    std::optional<std::vector<std::string>> changes{};
    Comparison measured{};   // of pictures that could both be read; of films, their worst frames
    CompareLimits limits{};  // that were applied
    std::vector<std::string> ignored{};     // regions, as given
    std::set<std::string> found_regions{};  // of those with names, the ones that it shows
    std::optional<FilmDifferences> film{};  // without the pictures of its strip
    ShownPictures shown{};

    bool passes() const { return outcome == Outcome::same || outcome == Outcome::within_limits; }
    // The changes and the reason in one line: "theme: light → dark; 7 of 100 pixels differ …". At
    // most five changes are named.
    std::string line() const;
};

// Two pictures in memory that are not the same.
struct PicturePair {
    const StoredPicture& expected;
    const StoredPicture& actual;
    const CompareLimits& limits;
    std::span<const PictureRegion> ignored;
    std::span<const KeptFrames> strip;  // of films
};

// Returns the default limits between a baseline and a picture by this renderer (GL_RENDERER) and
// version of Mesa: no pixel may differ with the same renderer and version; between two versions of
// llvmpipe 0.1 % of the pixels may differ by a level, because Mesa 22 and 26 round differently in
// fewer; none may differ from a picture of another program; no limits are known for other pairs.
std::optional<CompareLimits> limits_between(const Baseline& approved, std::string_view renderer,
                                            std::string_view mesa);

// The options of a comparison.
struct CompareRequest {
    // Of a profile. None: what drew the baseline decides, else no pixel may differ.
    std::optional<CompareLimits> limits{};
    GivenLimits given{};                // of the command line
    std::optional<CompareFile> file{};  // of the baselines
    bool ssim = false, flip = false;    // measure these, whether or not they decide
    std::function<StoredPicture(const std::filesystem::path&)> read = read_stored_png;
    // Receives each pair that is not the same while it is in memory, on the thread that compares.
    std::function<void(ComparedPicture&, const PicturePair&)> seen{};
    int n_threads = n_processors();  // of a folder, all of which call the functions, or of a film
};

// Compares two files, or two sequences. A file that does not exist is "missing" or "unexpected". If
// baselines are given, their manifest names the expected picture and, if no limits are given,
// determines the limits from the renderer; otherwise no pixel may differ. The manifest and
// compare.toml know it by the name of the baseline; empty: the same name.
ComparedPicture compare_files(const std::string& name, const std::filesystem::path& expected,
                              const std::filesystem::path& actual, const CompareRequest& request,
                              const Baselines* baselines = nullptr,
                              const std::string& baseline_name = "");

// Throws InputError for limits that ignore something by its name in pictures like this one, which
// has no record that says where it is.
void check_regions(const GivenLimits& given, const std::filesystem::path& picture);

// The pictures of a folder and its subfolders that are of another kind (JPEG, WebP, TIFF, BMP), so
// that compare_folders passes them over; relative to the folder, in order.
std::vector<std::filesystem::path> other_pictures_in(const std::filesystem::path& folder);

// Whether a name is that of a file that can be compared: a PNG, a film, a PDF or an SVG.
bool is_comparable(const std::filesystem::path& file);

// Compares every such file in the two folders and their subfolders, except hidden ones, and every
// picture that the manifest of the first folder names. The result is in the order of the names, for
// any number of threads. Throws InputError for a folder or a manifest that cannot be read, and if
// there are no pictures.
std::vector<ComparedPicture> compare_folders(const std::filesystem::path& expected,
                                             const std::filesystem::path& actual,
                                             const CompareRequest& request);

// Worst first: by outcome, then by perceived difference (FLIP) where it was measured, by the mean
// difference where not, then by name.
void sort_by_severity(std::vector<ComparedPicture>& pictures);

bool all_pass(std::span<const ComparedPicture> pictures);

}  // namespace poinsot
