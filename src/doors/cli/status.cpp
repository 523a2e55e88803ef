// poinsot status FOLDER: prints which parts of a submission are done, running or failed.
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/options.h"
#include "production/cluster/submission.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct StatusChoices {
    std::vector<std::string> folders;
    bool json = false;
};

constexpr std::array<const char*, 5> state_names{"waiting", "running", "stopped", "failed", "done"};

const char* name_of(TaskState state) { return state_names[static_cast<std::size_t>(state)]; }

std::string in_words(const TaskStatus& task) {
    std::string text = name_of(task.state);
    if (task.n_frames_done >= 0)
        text += fmt::format(", frame {} of {}", task.n_frames_done, task.n_frames);
    if (task.state == TaskState::stopped) text += ", nothing written for five minutes";
    if (!task.why.empty()) text += fmt::format(": {}", printable(task.why));
    return text;
}

void print_words(const std::vector<FilmStatus>& films) {
    for (const FilmStatus& film : films) {
        std::array<int, state_names.size()> n{};
        for (const TaskStatus& part : film.parts) ++n[static_cast<std::size_t>(part.state)];
        std::string counts;
        for (std::size_t i = state_names.size(); i-- > 0;)
            if (n[i] > 0)
                counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", n[i], state_names[i]);
        fmt::print("{}: {} parts: {}; join {}\n", printable(film.name), film.parts.size(), counts,
                   in_words(film.join));
        for (const TaskStatus& part : film.parts)
            if (part.state != TaskState::done && part.state != TaskState::waiting)
                fmt::print("  {} {}\n", printable(part.name), in_words(part));
    }
}

std::string json_of(const TaskStatus& task) {
    JsonObject object;
    object.add("name", task.name).add("state", name_of(task.state));
    if (task.n_frames_done >= 0)
        object.add("frames_done", task.n_frames_done).add("frames", task.n_frames);
    if (!task.why.empty()) object.add("why", task.why);
    return object.line();
}

void print_json(const std::vector<FilmStatus>& films) {
    std::vector<std::string> rows;
    rows.reserve(films.size());
    for (const FilmStatus& film : films) {
        std::vector<std::string> parts;
        parts.reserve(film.parts.size());
        for (const TaskStatus& part : film.parts) parts.push_back(json_of(part));
        rows.push_back(JsonObject()
                           .add("film", film.name)
                           .add("output", film.output)
                           .json("join", json_of(film.join))
                           .json("parts", json_lines(parts, 2))
                           .line());
    }
    fmt::print("{}\n", json_lines(rows));
}

int run(const StatusChoices& choices) {
    const std::vector<FilmStatus> films = status_of(choices.folders.at(0));
    if (choices.json)
        print_json(films);
    else
        print_words(films);
    for (const FilmStatus& film : films) {
        if (film.join.state == TaskState::failed) return 1;
        for (const TaskStatus& part : film.parts)
            if (part.state == TaskState::failed) return 1;
    }
    return 0;
}

CommandLine status_line() {
    const auto choices = std::make_shared<StatusChoices>();
    StatusChoices& c = *choices;
    return {&c.folders, {json_option(c.json)}, [choices] { return run(*choices); }};
}

}  // namespace

extern const Command status_command{
    "status",
    "FOLDER",
    1,
    1,
    "report the progress of a submission: parts done, running, failed",
    status_line,
    {{{"poinsot status film.mp4.job", "reports on the folder that submit wrote"},
      {"poinsot status film.mp4.job --json", "the same as JSON"}}}};

}  // namespace poinsot
