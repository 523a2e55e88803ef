// Properties of every kind of output: after any sequence of {run, interrupt, kill, failing call,
// full disk, freed, change of a setting} on one output, either no file has its final name or the
// file is byte-identical to that of an uninterrupted run with one of its settings; the next
// undisturbed run makes a byte-identical file; and no other files are left.
//
// Runs in one process, on tiny pictures, with simulated disk faults (failing_disk.h). Everything
// follows from a seed; --seed, --kind and --only reproduce a failing sequence.
// Usage: output_sequences [--seed N] [--sequences N] [--kind NAME] [--only K]
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "compare/baselines.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "image/synthetic.h"
#include "temporary_folder.h"
#include "trust/failing_disk.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

// The files of a folder, by name.
using Contents = std::map<std::string, std::string>;

Contents contents_of(const fs::path& folder) {
    Contents contents;
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        contents[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return contents;
}

bool is_hidden(const std::string& name) { return name.starts_with('.'); }

// One kind of output and its settings.
struct Kind {
    std::string name;
    int n_settings;
    // Makes the output in a folder with one of its settings. n_frames: stops there unfinished, as
    // after Ctrl-C; empty: runs to the end. Throws Error.
    std::function<void(const fs::path& folder, int setting, std::optional<int> n_frames)> run;
    int n_steps;  // of a run, for choosing where to stop it
};

// Films and pictures --------------------------------------------------------------------------

constexpr int n_few = 5, n_many = 125;  // frames: less than a chunk, and more

// Two scenes, each with few frames or many: many frames are more than one chunk.
OutputPlan plan_of(const std::string& name, const fs::path& folder, int setting) {
    OutputPlan plan;
    plan.path = folder / name;
    plan.width_px = 32;
    plan.height_px = 18;
    const bool film = name.find('#') == std::string::npos && !name.ends_with(".png");
    plan.n_frames = name == "a.png" ? 1 : film && setting >= 2 ? n_many : n_few;
    plan.quality = "draft";
    plan.metadata = fmt::format("scene {}, {} frames", setting % 2, plan.n_frames);
    plan.seal = [](const std::string& metadata, const poinsot::EncodedMetadata& told) {
        return fmt::format("{} {} {} {} {}", metadata, told.n_frames, told.packets,
                           told.frame.value_or(-1), told.pixels);
    };
    plan.encoder_threads = 1;
    plan.resume = true;
    return plan;
}

const Image& frame_of(int setting, std::int64_t k) {
    static std::map<std::pair<int, std::int64_t>, Image> frames;
    const auto key = std::make_pair(setting % 2, k);
    const auto found = frames.find(key);
    if (found != frames.end()) return found->second;
    return frames[key] = synthetic_frame(32, 18, static_cast<int>(k) + 1000 * (setting % 2));
}

void run_output(const std::string& name, const fs::path& folder, int setting,
                std::optional<int> n_frames) {
    const OutputPlan plan = plan_of(name, folder, setting);
    const auto sink = format_for(plan.path).open(plan);
    int n_written = 0;
    for (std::int64_t k = 0; k < plan.n_frames; ++k) {
        if (sink->has_frame(k)) continue;
        if (n_frames && n_written == *n_frames) {
            // Waits for writer threads; otherwise timing would determine whether pending frames are
            // dropped.
            const bool numbered = name.find('#') != std::string::npos;
            for (int i = 0; i < 2000 && numbered && n_renames() < n_written && !has_struck(); ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return;
        }
        sink->write(frame_of(setting, k));
        ++n_written;
    }
    sink->finish();
}

Kind output_kind(const std::string& name) {
    const bool film = name.find('#') == std::string::npos && name != "a.png";
    return {name, film ? 4 : 2,
            [name](const fs::path& folder, int setting, std::optional<int> n_frames) {
                run_output(name, folder, setting, n_frames);
            },
            name == "a.png" ? 1 : n_few};
}

// Baselines -----------------------------------------------------------------------------------

// Approves two pictures, in one of two versions, with their manifest lines.
void run_approval(const fs::path& source, const fs::path& folder, int setting) {
    BaselineWriter writer(folder);
    std::vector<BaselineWriter::Change> changes;
    for (const char* name : {"one", "two"}) {
        const fs::path from = source / fmt::format("{}_{}.png", name, setting);
        const Baseline line{pixels_sha256(read_stored_png(from)), "scene", "renderer", "22", "1",
                            fmt::format("look {}", setting)};
        const auto now = writer.manifest().find(name);
        const bool same = now != writer.manifest().end() && now->second == line;
        if (!same || writer.pixels_of(name) != line.pixels) changes.push_back({name, from, line});
    }
    writer.take(changes);
}

Kind baselines_kind(const fs::path& source) {
    for (int setting = 0; setting < 2; ++setting)
        for (const char* name : {"one", "two"})
            write_png(source / fmt::format("{}_{}.png", name, setting),
                      synthetic_frame(16, 9, setting + (name[0] == 'o' ? 10 : 20)));
    return {"baselines", 2,
            [source](const fs::path& folder, int setting, std::optional<int>) {
                run_approval(source, folder, setting);
            },
            1};
}

// Sequences -----------------------------------------------------------------------------------

struct Tally {
    std::map<std::string, int> steps;
    int n_wrong = 0;
};

class Sequence {
 public:
    Sequence(const Kind& kind, const std::vector<Contents>& expected, fs::path folder,
             std::mt19937_64 dice, Tally& tally)
        : kind_(kind),
          expected_(expected),
          folder_(std::move(folder)),
          dice_(std::move(dice)),
          tally_(tally) {}

    // A description of the failure, or empty.
    std::string make() {
        setting_ = any(kind_.n_settings);
        // Films of many frames are slow: most sequences have none.
        if (kind_.n_settings == 4 && any(8) != 0) setting_ %= 2;
        const int n_steps = 2 + any(6);
        for (int k = 0; k < n_steps; ++k) {
            if (std::string fault = step(); !fault.empty()) return told_ + ": " + fault;
        }
        freed();
        const std::string error = run({});
        if (!error.empty()) return fmt::format("{}, last run: {}", told_, error);
        return contents_of(folder_) == expected() ? "" : told_ + ", last run: " + difference();
    }

 private:
    int any(int n) { return static_cast<int>(dice_() % static_cast<std::uint64_t>(n)); }
    const Contents& expected() const { return expected_[static_cast<std::size_t>(setting_)]; }

    void tell(const std::string& what) {
        told_ += (told_.empty() ? "" : ", ") + what;
        ++tally_.steps[what.substr(0, what.find(' '))];
    }

    void freed() {
        full_ = false;
        set_fault({});
    }

    // The message of an error, or empty.
    std::string run(std::optional<int> n_frames) {
        made_with_.insert(setting_);
        try {
            kind_.run(folder_, setting_, n_frames);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    std::string step() {
        const int chosen = any(12);
        if (chosen < 2) return change();
        if (chosen < 4) return undisturbed();
        if (chosen < 5 && kind_.n_steps > 1) return interrupted();
        if (chosen < 8) return disturbed(DiskFault::Kind::kill, "kill");
        if (chosen < 10) return disturbed(DiskFault::Kind::error, "error");
        if (full_) {
            tell("freed");
            freed();
            return "";
        }
        return disturbed(DiskFault::Kind::full, "full");
    }

    std::string change() {
        const int half = setting_ >= 2 ? 2 : 0;
        setting_ = half + (setting_ - half + 1) % 2;
        if (kind_.n_settings == 4 && any(8) == 0) setting_ = (setting_ + 2) % 4;
        tell(fmt::format("change to {}", setting_));
        return "";
    }

    std::string undisturbed() {
        tell("run");
        if (!full_) set_fault({});
        const std::string error = run({});
        if (error.empty() && contents_of(folder_) != expected()) return difference();
        if (!error.empty() && !full_) return "refused though nothing failed: " + error;
        return what_is_there();
    }

    std::string interrupted() {
        const int n_frames = any(expected_n_frames());
        tell(fmt::format("interrupt after {}", n_frames));
        if (!full_) set_fault({});
        run(n_frames);
        return what_is_there();
    }

    int expected_n_frames() const { return setting_ >= 2 ? n_many : kind_.n_steps; }

    // A run with a disk fault, at a random call of a run of this length.
    std::string disturbed(DiskFault::Kind fault, const std::string& name) {
        const int n_calls = setting_ >= 2 ? 5 * n_many : 40;
        // The first and the last calls are the most critical ones.
        std::int64_t n = 1 + (any(2) == 0 ? any(12) : any(n_calls));
        if (fault == DiskFault::Kind::full) n = any(2) == 0 ? any(600) : any(6000);
        constexpr std::array<int, 4> errors{ENOSPC, EIO, EDQUOT, EACCES};
        const int error_number = errors[static_cast<std::size_t>(any(4))];
        tell(
            fmt::format("{} at {}{}", name, n,
                        fault == DiskFault::Kind::error ? fmt::format(" ({})", error_number) : ""));
        set_fault({fault, n, error_number});
        full_ = fault == DiskFault::Kind::full;
        const std::string error = run({});
        const bool struck = has_struck();
        if (!full_) set_fault({});
        if (error.find('\n') != std::string::npos) return "more than a line: " + error;
        if (!struck && !full_ && !error.empty()) return "refused though nothing failed: " + error;
        if (error.empty() && fault != DiskFault::Kind::kill) {
            // The failing call may be irrelevant; then everything is correct, except for files that
            // could not be removed.
            if (visible(contents_of(folder_)) != expected()) return difference();
        }
        return what_is_there();
    }

    static Contents visible(Contents contents) {
        std::erase_if(contents, [](const auto& file) { return is_hidden(file.first); });
        return contents;
    }

    // Under the outputs' names there is no file, or one that some run makes.
    std::string what_is_there() const {
        for (const auto& [name, bytes] : visible(contents_of(folder_))) {
            bool right = false;
            for (const int setting : made_with_) {
                const Contents& whole = expected_[static_cast<std::size_t>(setting)];
                const auto found = whole.find(name);
                right = right || (found != whole.end() && found->second == bytes);
            }
            // While pictures are replaced, the manifest may have lines of both versions.
            if (!right && name != manifest_name)
                return fmt::format("{} is there, of {} bytes, and is no run's", name, bytes.size());
        }
        return "";
    }

    std::string difference() const {
        std::string text = "not as an uninterrupted run leaves it:";
        const Contents found = contents_of(folder_);
        for (const auto& [name, bytes] : expected())
            if (!found.contains(name)) text += fmt::format(" {} is missing", name);
        for (const auto& [name, bytes] : found)
            if (!expected().contains(name))
                text += fmt::format(" {} is left", name);
            else if (expected().at(name) != bytes)
                text += fmt::format(" {} differs", name);
        return text;
    }

    const Kind& kind_;
    const std::vector<Contents>& expected_;
    fs::path folder_;
    std::mt19937_64 dice_;
    Tally& tally_;
    int setting_ = 0;
    bool full_ = false;
    std::set<int> made_with_;
    std::string told_;
};

struct Choices {
    std::uint64_t seed = 1;
    int n_sequences = 2000;
    std::string kind;
    std::optional<int> only;
};

int number_of(std::string_view text) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

Choices choices_of(int argc, char** argv) {
    Choices choices;
    for (int k = 1; k + 1 < argc; k += 2) {
        const std::string_view option = argv[k], value = argv[k + 1];
        if (option == "--seed") choices.seed = static_cast<std::uint64_t>(number_of(value));
        if (option == "--sequences") choices.n_sequences = number_of(value);
        if (option == "--kind") choices.kind = value;
        if (option == "--only") choices.only = number_of(value);
    }
    return choices;
}

// Identical on every machine: one generator per sequence, from seed, kind and number.
std::mt19937_64 dice_of(const Choices& choices, const std::string& kind, int number) {
    std::seed_seq seed{static_cast<unsigned>(choices.seed), static_cast<unsigned>(number),
                       static_cast<unsigned>(std::hash<std::string>{}(kind))};
    return std::mt19937_64(seed);
}

int try_kind(const Kind& kind, const Choices& choices, const fs::path& place) {
    const auto began = std::chrono::steady_clock::now();
    const fs::path folder = place / "output";
    std::vector<Contents> expected;
    for (int setting = 0; setting < kind.n_settings; ++setting) {
        fs::create_directory(folder);
        kind.run(folder, setting, {});
        expected.push_back(contents_of(folder));
        fs::remove_all(folder);
    }
    Tally tally;
    int n_made = 0;
    for (int k = 0; k < choices.n_sequences; ++k) {
        if (choices.only && *choices.only != k) continue;
        fs::create_directory(folder);
        watch_folder(folder.string());
        const std::string fault =
            Sequence(kind, expected, folder, dice_of(choices, kind.name, k), tally).make();
        watch_folder("");
        set_fault({});
        fs::remove_all(folder);
        ++n_made;
        if (fault.empty()) continue;
        if (++tally.n_wrong <= 10)
            fmt::print("WRONG {} --seed {} --kind {} --only {}\n", fault, choices.seed, kind.name,
                       k);
    }
    std::string steps;
    for (const auto& [name, n] : tally.steps) steps += fmt::format(" {} {}", n, name);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    fmt::print("{:12} {:5} sequences, {} wrong, {:.1f} s:{}\n", kind.name, n_made, tally.n_wrong,
               took.count(), steps);
    std::fflush(stdout);
    return tally.n_wrong;
}

int try_all(const Choices& choices) {
    const TemporaryFolder folder;
    const fs::path& place = folder.path();
    fs::create_directory(place / "source");
    std::vector<Kind> kinds;
    for (const char* file : {"a.png", "a_#.png", "a.mp4", "a.webm", "a.mov", "a.gif", "a.md5"})
        kinds.push_back(output_kind(file));
    kinds.push_back(baselines_kind(place / "source"));
    int n_wrong = 0;
    for (const Kind& kind : kinds)
        if (choices.kind.empty() || choices.kind == kind.name)
            n_wrong += try_kind(kind, choices, place);
    return n_wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace poinsot::testing

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);
    return poinsot::testing::try_all(poinsot::testing::choices_of(argc, argv));
}
