#include "cli/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>

#include "error/error.h"
#include "output/frame_name.h"
#include "production/output_place.h"
#include "system/file_kind.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// The name that a scene will have, known before it is read.
std::string scene_name(const std::string& file) {
    return std::filesystem::path(file).stem().string();
}

// Whether #### in the output counts scenes.
bool counts_scenes(std::size_t n_scenes, const std::filesystem::path& output, OutputKind kind) {
    const bool is_sequence = kind == OutputKind::film && suffix_of(output) == ".png";
    const bool told_apart = n_scenes == 1 || has_scene_name(output.string());
    return has_frame_number(output) && !(is_sequence && told_apart);
}

// One output would replace the other without a word.
void refuse_one_name(const std::vector<SceneJob>& jobs, OutputKind kind) {
    std::map<std::filesystem::path, std::string> taken;
    for (const SceneJob& job : jobs) {
        const std::filesystem::path output =
            job.output.empty()
                ? default_output(scene_name(job.scene), kind == OutputKind::film ? ".mp4" : ".png")
                : std::filesystem::path(job.output);
        const auto [other, is_new] = taken.emplace(output.lexically_normal(), job.scene);
        if (!is_new)
            throw InputError(fmt::format(
                "{} and {} would both be written to {}; name the output with -o and "
                "put #### into it for the scene's number",
                printable(other->second), printable(job.scene), printable(output.string())));
    }
}

}  // namespace

std::filesystem::path scenes_folder() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& folder :
         {program / "../share/poinsot/scenes", program / "../../scenes", fs::path("scenes")})
        if (fs::is_directory(folder, ignored)) return folder;
    throw EnvironmentError(
        "no folder of scenes beside the program; install it with its scenes, or name scene files");
}

std::string scene_file(const std::string& given) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path name(given);
    if (given.empty() || name.has_parent_path() || name.has_extension() ||
        fs::exists(name, ignored))
        return given;
    try {
        const fs::path file = (scenes_folder() / (given + ".toml")).lexically_normal();
        return fs::exists(file, ignored) ? file.string() : given;
    } catch (const EnvironmentError&) {
        return given;  // which is then said not to be there
    }
}

std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind) {
    const bool counts = counts_scenes(scenes.size(), output, kind);
    if (scenes.size() > 1 && !output.empty() && !counts && !has_scene_name(output))
        throw InputError(fmt::format(
            "{}: {} scenes cannot go to one name; put #### into it for the scene's number or "
            "{{scene}} for its name, or leave -o out to name each after its scene",
            printable(output), scenes.size()));
    std::vector<SceneJob> jobs;
    for (const std::string& scene : scenes) {
        const auto number = static_cast<std::int64_t>(jobs.size());
        const std::string name = scene_name(scene);
        const std::filesystem::path own =
            counts ? numbered_output(output, number, name) : with_scene_name(output, name);
        jobs.push_back({scene, own.string()});
    }
    refuse_one_name(jobs, kind);
    return jobs;
}

int code_of_one(const std::function<int()>& job) {
    try {
        return job();
    } catch (const InputError& error) {
        say(printable(error.what()));
        return 2;
    }
}

int for_each_scene(const std::vector<SceneJob>& jobs,
                   const std::function<int(const SceneJob&)>& run) {
    if (jobs.size() == 1) return run(jobs.front());
    int worst = 0;
    for (const SceneJob& job : jobs) worst = std::max(worst, code_of_one([&] { return run(job); }));
    return worst;
}

}  // namespace poinsot
