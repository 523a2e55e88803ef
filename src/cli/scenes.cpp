#include "cli/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "error/error.h"
#include "output/frame_name.h"
#include "text/printable.h"

namespace poinsot {

std::vector<Options> options_by_scene(const Options& options) {
    if (options.arguments.size() == 1) return {options};
    if (!options.output.empty() && !has_frame_number(options.output))
        throw InputError(fmt::format(
            "{}: {} scenes cannot go to one name; put #### into it for the scene's number, or "
            "leave -o out to name each after its scene",
            printable(options.output), options.arguments.size()));
    std::vector<Options> each;
    for (const std::string& scene : options.arguments) {
        Options& own = each.emplace_back(options);
        own.arguments = {scene};
        if (!options.output.empty())
            own.output =
                frame_name(options.output, static_cast<std::int64_t>(each.size()) - 1).string();
    }
    return each;
}

int code_of_one(const std::function<int()>& job) {
    try {
        return job();
    } catch (const InputError& error) {
        fmt::print(stderr, "{}\n", printable(error.what()));
        return 2;
    }
}

int for_each_scene(const Options& options, const std::function<int(const Options&)>& job) {
    const std::vector<Options> each = options_by_scene(options);
    if (each.size() == 1) return job(each.front());
    int worst = 0;
    for (const Options& own : each) worst = std::max(worst, code_of_one([&] { return job(own); }));
    return worst;
}

}  // namespace poinsot
