// poinsot explain FILE: how a picture or film was made, as it says itself.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "cli/command.h"
#include "cli/options.h"
#include "production/record.h"
#include "text/json_text.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

struct ExplainChoices {
    std::vector<std::string> files;
    bool json = false;
    bool verify = false;
};

std::string_view name_of(Verified verified) {
    switch (verified) {
        case Verified::yes:
            return "yes";
        case Verified::no:
            return "no";
        case Verified::cannot_be:
            break;
    }
    return "cannot be";
}

std::string json_of(const Record& record, const std::optional<Verification>& verification) {
    JsonObject object;
    object.add("version", record.version).add("scene", record.scene_name);
    object.add("scene_sha256", record.scene_hash);
    if (!record.mesh_hash.empty()) object.add("mesh_sha256", record.mesh_hash);
    object.add("method", record.method).add("bounds", record.bounds);
    object.add("profile", record.portable ? "portable" : "native");
    if (!record.processor.empty()) object.add("processor", record.processor);
    object.add("renderer", record.renderer).add("mesa", record.mesa);
    if (!record.fonts.empty()) object.add("fonts", record.fonts);
    object.json("size", json_numbers(record.width_px, record.height_px));
    if (record.time_s) object.add("time_s", *record.time_s);
    if (record.dpi) object.add("dpi", *record.dpi);
    if (record.type_pt) object.add("type_pt", *record.type_pt);
    if (record.bit_depth != 8) object.add("depth", record.bit_depth);
    if (!record.shading.empty()) object.add("shading", record.shading);
    if (!record.journal.empty()) object.add("journal", record.journal);
    if (!record.lettering.empty()) object.add("type_as", record.lettering);
    const auto range = [](const auto& of) { return fmt::format("[{}, {}]", of.first, of.second); };
    if (record.frames) object.json("frames", range(*record.frames));
    if (record.run) object.json("run", range(*record.run));
    if (record.frame) object.add("frame", *record.frame);
    if (!record.sheet.empty()) object.add("sheet", record.sheet);
    if (!record.pixels.empty()) object.add("pixels_xxh64", record.pixels);
    if (!record.packets.empty()) object.add("packets_sha256", record.packets);
    if (!record.page.empty()) object.add("page_sha256", record.page);
    if (verification) object.add("verified", name_of(verification->verified));
    return object.add("scene_toml", record.scene_toml).lines();
}

// The text comes from a file: nothing in it may steer the terminal.
void print_text(const Record& record) {
    const std::string& text = record.text;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        fmt::print("{}\n", printable(text.substr(from, end - from), any_length));
        from = end + 1;
    }
}

int run(const ExplainChoices& choices) {
    const std::filesystem::path file = choices.files.at(0);
    const Record record = read_record(file);
    std::optional<Verification> verification;
    if (choices.verify || is_quickly_verified(file, record)) verification = verify(file, record);
    if (choices.json)
        fmt::print("{}", json_of(record, verification));
    else
        print_text(record);
    const auto named = frame_of_name(file);
    if (record.frame && named && *named != *record.frame)
        say(fmt::format("note: {}: is frame {} of its sequence, whatever its name says",
                        printable(file.string()), *record.frame));
    if (!verification) return 0;
    const bool says_no = verification->verified == Verified::no;
    if (says_no || choices.verify)
        say(fmt::format("{}: {}", printable(file.string()), verification->sentence));
    return says_no || (choices.verify && verification->verified != Verified::yes) ? 1 : 0;
}

CommandLine explain_line(std::any& room) {
    auto& c = room.emplace<ExplainChoices>();
    return {&c.files,
            {json_option(c.json),
             {"--verify",
              "read all of the file: is it as it was written? tells mistakes, not forgeries",
              &c.verify}},
            [&c] { return run(c); }};
}

}  // namespace

extern const Command explain_command{
    "explain",
    "FILE",
    1,
    1,
    "print how a picture or film was made",
    explain_line,
    {{{"poinsot explain generic.png", "scene, options and versions that made it"},
      {"poinsot explain generic.mp4 --verify", "is the file as it was written?"}}}};

}  // namespace poinsot
