#include "cli/options.h"

#include <utility>
#include <variant>

#include "cli/option_values.h"
#include "cli/scenes.h"

namespace poinsot {

namespace {

// How the text of an option reaches its slot.
struct Reader {
    const OptionRow& row;

    OptionValue operator()(bool* value) const { return value; }
    OptionValue operator()(int* value) const { return value; }
    OptionValue operator()(std::string* value) const { return value; }
    OptionValue operator()(std::optional<double>* value) const { return value; }
    OptionValue operator()(const InstantSlot& slot) const {
        return ReadText{[slot, &row = row](const std::string& text) {
            *slot.clearest = text == "auto";
            if (!*slot.clearest) *slot.time_s = parse_number(row.flag(), text, row.wanted);
        }};
    }
    OptionValue operator()(const FramesSlot& slot) const {
        return ReadText{[slot](const std::string& text) { *slot.frames = parse_frames(text); }};
    }
};

OptionValue value_of(const OptionRow& row, GivenOptions& given) {
    if (row.slot != nullptr) return std::visit(Reader{row}, row.slot(given));
    // A bare word becomes a TOML string; numbers stay numbers.
    return ReadText{[&row, &given](const std::string& value) {
        given.overrides.push_back(
            {std::string(row.key), parse_text(row.flag(), value), row.flag()});
    }};
}

}  // namespace

std::vector<Option> options_of(unsigned verbs, GivenOptions& given) {
    std::vector<Option> options;
    for (const OptionRow& row : option_rows())
        if ((row.verbs & verbs) != 0)
            options.push_back({.flags = row.flag(),
                               .takes = std::string(row.takes),
                               .help = row.help,
                               .value = value_of(row, given),
                               .wanted = std::string(row.wanted),
                               .completes = std::string(row.completes)});
    return options;
}

Option set_option(GivenOptions& given) {
    return {.flags = "--set",
            .takes = "KEY=VALUE",
            .help = "set any scene key; repeatable",
            .value = ReadEach{[&given](const std::string& assignment) {
                given.overrides.push_back(override_of(assignment));
            }},
            .completes = "keys"};
}

Option allow_outside_option(bool& allow_outside) {
    return {.flags = "--allow-outside",
            .help = "allow the scene to name files outside its folder",
            .value = &allow_outside};
}

SceneRequest scene_request(const std::string& argument, const GivenOptions& given,
                           const std::vector<Override>& more_overrides) {
    return scene_request_of(scene_file(argument), given, more_overrides);
}

Option output_option(std::string& output, std::string_view help) {
    return {.flags = "-o,--output",
            .takes = "FILE",
            .help = std::string(help),
            .value = &output,
            .completes = "file"};
}

Option json_option(bool& json, std::string_view help) {
    return {.flags = "--json", .help = std::string(help), .value = &json};
}

Option quiet_option(bool& quiet) {
    return {.flags = "--quiet,-q", .help = "hide progress and notes", .value = &quiet};
}

std::vector<Option> joined(std::initializer_list<std::vector<Option>> groups) {
    std::vector<Option> all;
    for (const std::vector<Option>& group : groups)
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

}  // namespace poinsot
