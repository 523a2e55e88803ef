// A pair of files to compare, and the functions that comparisons of pictures, films and folders
// share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compare/baselines.h"
#include "compare/compared_picture.h"
#include "compare/given_limits.h"
#include "production/records/record.h"
#include "production/stills/picture_regions.h"

namespace poinsot {

// Two files, of which one may be missing.
struct FilePair {
    std::string name;
    std::filesystem::path expected, actual;
    const Baselines* baselines = nullptr;  // of their folder
    std::string baseline_name;             // as the manifest and compare.toml know it
};

// The share of the machine that a pair may use while other pairs of its folder are compared.
class MachineShare {
 public:
    // Of a pair alone.
    explicit MachineShare(int n_threads) : n_threads_(n_threads), n_threads_alone_(n_threads) {}
    MachineShare(int n_threads, int n_threads_alone, std::mutex& large_pairs)
        : n_threads_(n_threads),
          n_threads_alone_(n_threads_alone),
          alone_(large_pairs, std::defer_lock) {}

    // With so many pixels in each of the two, waits until no other large pair is in memory.
    void need(std::int64_t n_pixels);
    // Likewise for a file, by its header.
    void need(const std::filesystem::path& png);
    int n_threads() const { return alone_.owns_lock() ? n_threads_alone_ : n_threads_; }

 private:
    int n_threads_, n_threads_alone_;
    std::unique_lock<std::mutex> alone_;
};

// The records of a pair; none for files by other programs.
struct Records {
    std::optional<Record> expected, actual;
};

// The regions to ignore in a pair: rectangles, and what the records say of names.
class IgnoredRegions {
 public:
    // Throws InputError where neither record can say where a name is.
    IgnoredRegions(std::vector<IgnoredRegion> regions, const Records& records);

    // `frame`: of a film, from its first.
    std::vector<PictureRegion> in(int width, int height, std::int64_t frame = 0);
    const std::set<std::string>& found() const { return found_; }

 private:
    std::vector<IgnoredRegion> regions_;
    std::vector<std::string> names_;
    std::vector<PictureRegions> pictures_;  // as the records describe them
    std::vector<std::int64_t> first_frames_;
    std::set<std::string> found_;
};

inline constexpr std::string_view nothing_left =
    "the ignored regions cover the whole picture, so nothing is compared; ignore less";

Outcome outcome_of(Verdict verdict);
bool is_picture_name(const std::filesystem::path& file);
// None if another program rendered the file.
std::optional<Record> find_record(const std::filesystem::path& file);
// Whether both are regular files of the same bytes; the reader of pictures reports files that
// cannot be read.
bool have_same_bytes(const std::filesystem::path& a, const std::filesystem::path& b);

// Says how many pixels were ignored, and why.
void add_ignored_pixels(ComparedPicture& result);
// Adds the differences between the records of two files that differ.
void add_record_differences(const Records& records, ComparedPicture& result);

// Compares the two films or sequences that `result` names. Throws InputError.
void compare_two_films(const CompareRequest& request, const GivenLimits& given, MachineShare& share,
                       ComparedPicture& result);
ComparedPicture compare_pair(const FilePair& pair, const CompareRequest& request,
                             MachineShare& share);

}  // namespace poinsot
