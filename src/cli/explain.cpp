// poinsot explain FILE: how a picture or film was made, as it says itself.
#include <fmt/format.h>

#include <array>

#include "cli/command.h"
#include "production/record.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

std::string json_of(const Record& record) {
    std::string text = "{\n";
    const auto add = [&text](std::string_view key, const std::string& json) {
        text += fmt::format("  {}: {},\n", json_string(key), json);
    };
    add("version", json_string(record.version));
    add("scene", json_string(record.scene_name));
    add("scene_sha256", json_string(record.scene_hash));
    if (!record.mesh_hash.empty()) add("mesh_sha256", json_string(record.mesh_hash));
    add("method", json_string(record.method));
    add("bounds", json_string(record.bounds));
    add("profile", json_string(record.portable ? "portable" : "native"));
    add("renderer", json_string(record.renderer));
    add("mesa", json_string(record.mesa));
    add("size", fmt::format("[{}, {}]", record.width_px, record.height_px));
    if (record.time_s) add("time_s", json_number(*record.time_s));
    if (record.dpi) add("dpi", json_number(*record.dpi));
    if (record.type_pt) add("type_pt", json_number(*record.type_pt));
    if (record.bit_depth != 8) add("depth", fmt::format("{}", record.bit_depth));
    if (record.frames)
        add("frames", fmt::format("[{}, {}]", record.frames->first, record.frames->second));
    return text + fmt::format("  \"scene_toml\": {}\n}}\n", json_string(record.scene_toml));
}

int run(const Options& options) {
    const Record record = read_record(options.arguments.at(0));
    if (options.json) {
        fmt::print("{}", json_of(record));
        return 0;
    }
    // The text comes from a file: nothing in it may steer the terminal.
    const std::string text = to_text(record);
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        fmt::print("{}\n", printable(text.substr(from, end - from)));
        from = end + 1;
    }
    return 0;
}

constexpr std::array<std::string_view, 1> options_taken{"json"};

}  // namespace

const Command explain_command{"explain",     "FILE", 1, 1, "print how a picture or film was made",
                              options_taken, run};

}  // namespace poinsot
