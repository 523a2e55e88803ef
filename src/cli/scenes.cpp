#include "cli/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "error/error.h"
#include "output/frame_name.h"
#include "production/output_place.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// The name that a scene will have, known before it is read.
std::string scene_name(const std::string& file) {
    return std::filesystem::path(file).stem().string();
}

// Whether #### in the output counts scenes.
bool counts_scenes(const Options& options, OutputKind kind) {
    const std::filesystem::path output = options.output;
    const bool is_sequence = kind == OutputKind::film && output.extension() == ".png";
    const bool told_apart = options.arguments.size() == 1 || has_scene_name(options.output);
    return has_frame_number(output) && !(is_sequence && told_apart);
}

// One output would replace the other without a word.
void refuse_one_name(const std::vector<Options>& each, OutputKind kind) {
    std::map<std::filesystem::path, std::string> taken;
    for (const Options& own : each) {
        const std::string& scene = own.arguments.front();
        const std::filesystem::path output =
            own.output.empty()
                ? default_output(scene_name(scene), kind == OutputKind::film ? ".mp4" : ".png")
                : std::filesystem::path(own.output);
        const auto [other, is_new] = taken.emplace(output.lexically_normal(), scene);
        if (!is_new)
            throw InputError(fmt::format(
                "{} and {} would both be written to {}; name the output with -o and "
                "put #### into it for the scene's number",
                printable(other->second), printable(scene), printable(output.string())));
    }
}

}  // namespace

std::vector<Options> options_by_scene(const Options& options, OutputKind kind) {
    const bool counts = counts_scenes(options, kind);
    if (options.arguments.size() > 1 && !options.output.empty() && !counts &&
        !has_scene_name(options.output))
        throw InputError(fmt::format(
            "{}: {} scenes cannot go to one name; put #### into it for the scene's number or "
            "{{scene}} for its name, or leave -o out to name each after its scene",
            printable(options.output), options.arguments.size()));
    std::vector<Options> each;
    for (const std::string& scene : options.arguments) {
        const auto number = static_cast<std::int64_t>(each.size());
        Options& own = each.emplace_back(options);
        own.arguments = {scene};
        const std::string name = scene_name(scene);
        own.output = (counts ? numbered_output(options.output, number, name)
                             : with_scene_name(options.output, name))
                         .string();
    }
    refuse_one_name(each, kind);
    return each;
}

int code_of_one(const std::function<int()>& job) {
    try {
        return job();
    } catch (const InputError& error) {
        say(printable(error.what()));
        return 2;
    }
}

int for_each_scene(const Options& options, const std::function<int(const Options&)>& job) {
    const std::vector<Options> each = options_by_scene(options, OutputKind::film);
    if (each.size() == 1) return job(each.front());
    int worst = 0;
    for (const Options& own : each) worst = std::max(worst, code_of_one([&] { return job(own); }));
    return worst;
}

}  // namespace poinsot
