#include "cli/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "error/error.h"
#include "error/nearest.h"
#include "output/frame_name.h"

namespace poinsot {

int for_each_scene(const Options& options, const std::function<int(const Options&)>& job) {
    if (options.arguments.size() == 1) return job(options);
    if (!options.output.empty() && !has_frame_number(options.output))
        throw InputError(fmt::format(
            "{}: {} scenes cannot go to one name; put #### into it for the scene's number, or "
            "leave -o out to name each after its scene",
            printable(options.output), options.arguments.size()));
    int worst = 0;
    std::int64_t number = 0;
    for (const std::string& scene : options.arguments) {
        Options own = options;
        own.arguments = {scene};
        if (!options.output.empty()) own.output = frame_name(options.output, number).string();
        ++number;
        try {
            worst = std::max(worst, job(own));
        } catch (const InputError& error) {
            fmt::print(stderr, "{}\n", printable(error.what()));
            worst = std::max(worst, 2);
        }
    }
    return worst;
}

}  // namespace poinsot
