// poinsot status FOLDER: what of a submission is done, running, failed.
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/options.h"
#include "production/parts/submission.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct StatusChoices {
    std::vector<std::string> folders;
    bool json = false;
};

constexpr std::array<const char*, 5> kStates{"waiting", "running", "stopped", "failed", "done"};

const char* name_of(TaskState state) { return kStates[static_cast<std::size_t>(state)]; }

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
        std::array<int, kStates.size()> n{};
        for (const TaskStatus& part : film.parts) ++n[static_cast<std::size_t>(part.state)];
        std::string counts;
        for (std::size_t i = kStates.size(); i-- > 0;)
            if (n[i] > 0)
                counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", n[i], kStates[i]);
        fmt::print("{}: {} parts: {}; join {}\n", printable(film.name), film.parts.size(), counts,
                   in_words(film.join));
        for (const TaskStatus& part : film.parts)
            if (part.state != TaskState::done && part.state != TaskState::waiting)
                fmt::print("  {} {}\n", printable(part.name), in_words(part));
    }
}

std::string json_of(const TaskStatus& task) {
    std::string text = fmt::format("{{\"name\": {}, \"state\": \"{}\"", json_string(task.name),
                                   name_of(task.state));
    if (task.n_frames_done >= 0)
        text +=
            fmt::format(", \"frames_done\": {}, \"frames\": {}", task.n_frames_done, task.n_frames);
    if (!task.why.empty()) text += fmt::format(", \"why\": {}", json_string(task.why));
    return text + "}";
}

void print_json(const std::vector<FilmStatus>& films) {
    fmt::print("[\n");
    for (std::size_t i = 0; i < films.size(); ++i) {
        const FilmStatus& film = films[i];
        fmt::print("  {{\"film\": {}, \"output\": {}, \"join\": {}, \"parts\": [\n",
                   json_string(film.name), json_string(film.output), json_of(film.join));
        for (std::size_t k = 0; k < film.parts.size(); ++k)
            fmt::print("    {}{}\n", json_of(film.parts[k]), k + 1 < film.parts.size() ? "," : "");
        fmt::print("  ]}}{}\n", i + 1 < films.size() ? "," : "");
    }
    fmt::print("]\n");
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

CommandLine line(std::any& room) {
    auto& c = room.emplace<StatusChoices>();
    return {&c.folders, {json_option(c.json)}, [&c] { return run(c); }};
}

}  // namespace

extern const Command status_command{
    "status",
    "FOLDER",
    1,
    1,
    "say what of a submission is done, running or failed",
    line,
    {{{"poinsot status film.mp4.job", "of the folder that submit has made"},
      {"poinsot status film.mp4.job --json", "the same for a script"}}}};

}  // namespace poinsot
