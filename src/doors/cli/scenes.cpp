#include "cli/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "encoding/frame_name.h"
#include "error/error.h"
#include "production/stills/output_place.h"
#include "system/files/file_kind.h"
#include "system/files/program_files.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// The name of a scene, known before the file is read.
std::string scene_name(const std::string& file) {
    return std::filesystem::path(file).stem().string();
}

// Whether #### may number the pictures of each output.
bool is_sequence(const std::filesystem::path& output, OutputKind kind) {
    return kind == OutputKind::pictures ||
           (kind == OutputKind::film && suffix_of(output) == ".png");
}

// Whether #### in the output counts scenes.
bool counts_scenes(std::size_t n_scenes, const std::filesystem::path& output, OutputKind kind) {
    const bool told_apart = n_scenes == 1 || has_scene_name(output.string());
    return has_frame_number(output) && !(is_sequence(output, kind) && told_apart);
}

// The difference between a job and another one: its scene, or else its values of the sweep.
std::string difference(const SceneJob& job, const SceneJob& other) {
    if (job.scene != other.scene) return job.scene;
    std::string values;
    for (std::size_t i = 0; i < job.overrides.size(); ++i)
        if (job.overrides[i] != other.overrides[i])
            values +=
                fmt::format("{}{}", values.empty() ? "" : ", ", job.overrides[i].assignment());
    return values;
}

// Two jobs with the same output are refused, because one would silently replace the other.
void refuse_one_name(const std::vector<SceneJob>& jobs, OutputKind kind) {
    std::map<std::filesystem::path, const SceneJob*> taken;
    for (const SceneJob& job : jobs) {
        const std::filesystem::path output =
            job.output.empty()
                ? default_output(scene_name(job.scene), kind == OutputKind::film ? ".mp4" : ".png")
                : std::filesystem::path(job.output);
        const auto [other, is_new] = taken.emplace(output.lexically_normal(), &job);
        if (is_new) continue;
        const std::string one = difference(*other->second, job),
                          two = difference(job, *other->second);
        if (one.empty())
            throw InputError(
                fmt::format("{} is given twice, and both would be written to {}; give it once",
                            printable(job.scene), printable(output.string())));
        throw InputError(fmt::format(
            "{} and {} would both be written to {}; name the output with -o and put #### into it "
            "for a number, {{scene}} for the scene, or {{KEY}} for the swept value",
            printable(one), printable(two), printable(output.string())));
    }
}

// A message without the parts that vary between runs of a sweep: the swept values, and every
// number.
std::string reason_of(const SceneJob& job, std::string message) {
    for (const Override& given : job.overrides)
        for (std::size_t at = 0; (at = message.find(given.assignment(), at)) != std::string::npos;)
            message.erase(at, given.assignment().size());
    std::string reason;
    for (const char c : message)
        if ((c < '0' || c > '9') && c != '.' && c != '-') reason += c;
    return job.scene + reason;
}

// Next to an installed program, or in the source folder of a build.
std::filesystem::path scenes_folder() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    for (const fs::path& folder :
         {program_share() / "scenes", program_path().parent_path() / "../../scenes",
          fs::path("scenes")})
        if (fs::is_directory(folder, ignored)) return folder;
    throw EnvironmentError(
        "the program's folder of scenes is missing; install the program with its scenes, or name "
        "scene files");
}

}  // namespace

std::vector<std::filesystem::path> bundled_scenes() {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(scenes_folder(), error))
        if (entry.path().extension() == ".toml") files.push_back(entry.path().lexically_normal());
    if (error)
        throw EnvironmentError(fmt::format("the scenes cannot be listed: {}", error.message()));
    std::sort(files.begin(), files.end());
    return files;
}

std::string scene_file(const std::string& given) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path name(given);
    if (given.empty() || name.has_parent_path() || name.has_extension() ||
        fs::exists(name, ignored))
        return given;
    std::vector<std::string> known;
    try {
        for (const fs::path& file : bundled_scenes()) {
            if (file.stem() == name) return file.string();
            known.push_back(file.stem().string());
        }
    } catch (const EnvironmentError&) {
        // Reported below as an unknown name.
    }
    const std::string near =
        fs::exists(given + ".toml", ignored)
            ? fmt::format("; did you mean \"{}.toml\"?", printable(given, any_length))
            : did_you_mean(given, std::vector<std::string_view>(known.begin(), known.end()));
    if (near.empty()) return given;  // load_scene reports that it does not exist
    throw InputError(fmt::format("{}: no such file, and no scene has that name{}",
                                 printable(given, any_length), near));
}

std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind) {
    if (scenes.size() > 1 && !output.empty() && !counts_scenes(scenes.size(), output, kind) &&
        !has_scene_name(output))
        throw InputError(fmt::format(
            "{}: {} scenes need as many output names; put #### into the name for the scene's "
            "number or {{scene}} for its name, or leave -o out to name each output after its scene",
            printable(output), scenes.size()));
    std::vector<SceneJob> jobs;
    jobs.reserve(scenes.size());
    for (const std::string& scene : scenes) jobs.push_back({scene, output, {}});
    return named_jobs(std::move(jobs), output, kind);
}

std::vector<SceneJob> named_jobs(std::vector<SceneJob> jobs, const std::string& output,
                                 OutputKind kind) {
    // Outputs that are distinct without a number need none.
    const bool told_apart = std::any_of(jobs.begin(), jobs.end(), [&](const SceneJob& job) {
        return job.output != jobs.front().output;
    });
    const bool counts = told_apart ? has_frame_number(output) && !is_sequence(output, kind)
                                   : counts_scenes(jobs.size(), output, kind);
    std::int64_t number = 0;
    for (SceneJob& job : jobs) {
        const std::string name = scene_name(job.scene);
        job.output =
            (counts ? numbered_output(job.output, number, name) : with_scene_name(job.output, name))
                .string();
        ++number;
    }
    refuse_one_name(jobs, kind);
    return jobs;
}

int Refusals::code_of(const SceneJob& job, const std::function<int()>& run) {
    try {
        return run();
    } catch (const InputError& error) {
        if (job.overrides.empty() || said_.insert(reason_of(job, error.what())).second)
            say(printable(error.what()));
        else
            likewise_.push_back(
                difference(job, {job.scene, "", std::vector<Override>(job.overrides.size())}));
        return 2;
    }
}

void Refusals::say_others() const {
    if (likewise_.empty()) return;
    constexpr std::size_t most = 5;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, likewise_.size()); ++i)
        list += fmt::format("{}{}", list.empty() ? "" : "; ", likewise_[i]);
    say(printable(fmt::format(
        "refused for the same reason: {}{}", list,
        likewise_.size() > most ? fmt::format("; and {} more", likewise_.size() - most) : "")));
}

int for_each_scene(const std::vector<SceneJob>& jobs,
                   const std::function<int(const SceneJob&)>& run) {
    if (jobs.size() == 1) return run(jobs.front());
    int worst = 0;
    Refusals refusals;
    for (const SceneJob& job : jobs)
        worst = std::max(worst, refusals.code_of(job, [&] { return run(job); }));
    refusals.say_others();
    return worst;
}

}  // namespace poinsot
