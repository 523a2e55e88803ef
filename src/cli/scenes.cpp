#include "cli/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "error/error.h"
#include "output/frame_name.h"
#include "text/printable.h"

namespace poinsot {

std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output) {
    if (scenes.size() == 1) return {{scenes.front(), output}};
    if (!output.empty() && !has_frame_number(output))
        throw InputError(fmt::format(
            "{}: {} scenes cannot go to one name; put #### into it for the scene's number, or "
            "leave -o out to name each after its scene",
            printable(output), scenes.size()));
    std::vector<SceneJob> jobs;
    for (const std::string& scene : scenes) {
        const auto number = static_cast<std::int64_t>(jobs.size());
        jobs.push_back({scene, output.empty() ? "" : frame_name(output, number).string()});
    }
    return jobs;
}

int code_of_one(const std::function<int()>& job) {
    try {
        return job();
    } catch (const InputError& error) {
        fmt::print(stderr, "{}\n", printable(error.what()));
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
