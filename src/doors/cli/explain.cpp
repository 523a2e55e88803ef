// poinsot explain FILE: prints how a picture or film was made, from its own record.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "cli/command.h"
#include "cli/options.h"
#include "production/films/redraw.h"
#include "production/records/record.h"
#include "production/records/record_fields.h"
#include "production/records/verify.h"
#include "text/json_text.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

struct ExplainChoices {
    std::vector<std::string> files;
    bool json = false;
    bool verify = false;
    bool allow_outside = false;
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

std::string json_of(const Record& record, const std::optional<Verification>& verification,
                    const std::optional<RedrawCheck>& redraw) {
    JsonObject object;
    object.add("version", record.version);
    for (const RecordField& field : record_fields())
        if (const auto said = field.text_of(record))
            object.json(json_key_of(field), json_of(field, *said));
    if (verification) object.add("verified", name_of(verification->verified));
    if (redraw) object.add("can_be_drawn_again", redraw->obstacle.empty() ? "yes" : "no");
    if (redraw && !redraw->obstacle.empty()) object.add("why_not", redraw->obstacle);
    return object.add("scene_toml", record.scene_toml).lines();
}

// The text comes from a file: control characters must not reach the terminal.
void print_text(const Record& record) {
    const std::string& text = record.text;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        fmt::print("{}\n", printable(text.substr(from, end - from), any_length));
        from = end + 1;
    }
}

std::string in_words(const RedrawCheck& redraw) {
    if (redraw.obstacle.empty()) return "; it can be drawn again here";
    return fmt::format("; it cannot be drawn again here: {}",
                       printable(redraw.obstacle, most_of_a_message));
}

int run(const ExplainChoices& choices) {
    const std::filesystem::path file = choices.files.at(0);
    const Record record = read_record(file);
    std::optional<Verification> verification;
    if (choices.verify || is_quickly_verified(file, record)) verification = verify(file, record);
    const bool is_whole = verification && verification->verified == Verified::yes;
    std::optional<RedrawCheck> redraw;
    if (choices.verify && is_whole)
        redraw = check_redraw({.file = file, .outside = outside_files(choices.allow_outside)},
                              record, {.say = say});
    if (choices.json)
        fmt::print("{}", json_of(record, verification, redraw));
    else
        print_text(record);
    const auto named = frame_of_name(file);
    if (record.frames && record.frame && named && *named != *record.frame)
        say(fmt::format("note: {}: its record says frame {}, its name gives another number",
                        printable(file.string()), *record.frame));
    if (!verification) return 0;
    const bool says_no = verification->verified == Verified::no;
    if (says_no || choices.verify)
        say(fmt::format("{}: {}{}", printable(file.string()), verification->sentence,
                        redraw ? in_words(*redraw) : ""));
    if (!redraw) return says_no || choices.verify ? 1 : 0;
    for (const std::string& note : redraw->notes) say(note);
    return redraw->obstacle.empty() ? 0 : 1;
}

CommandLine explain_line() {
    const auto choices = std::make_shared<ExplainChoices>();
    ExplainChoices& c = *choices;
    return {&c.files,
            {json_option(c.json),
             {.flags = "--verify",
              .help = "read the whole file and check that it is unchanged and can be drawn again "
                      "here; exit code 0 if both hold; detects accidents, not forgery",
              .value = &c.verify},
             allow_outside_option(c.allow_outside)},
            [choices] { return run(*choices); }};
}

}  // namespace

extern const Command explain_command{
    "explain",
    "FILE",
    1,
    1,
    "show how a picture or film was made",
    explain_line,
    {{{"poinsot explain generic.png",
       "prints the scene, options and versions that made the picture"},
      {"poinsot explain generic.mp4 --verify",
       "checks that the film is unchanged and can be drawn again"}}}};

}  // namespace poinsot
