#include "production/cluster/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>
#include <sstream>
#include <system_error>

#include "encoding/film_part.h"
#include "encoding/film_parts.h"
#include "encoding/frame_log.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/own_files.h"
#include "system/files/program_files.h"
#include "system/run_program.h"
#include "text/control_characters.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// Runs a line of a list. A program that was killed (out of memory, by hand) is restarted and
// continues where it was interrupted. So does a task that the scheduler requeues.
constexpr const char* task_name = "task.sh";
constexpr const char* task_script = R"(#!/bin/sh
# task.sh LIST [LINE]: runs one line of a list (a name, a tab, a command), here or as a task of a Slurm array.
cd {folder} || exit 3
line=$(sed -n "${{2:-$((SLURM_ARRAY_TASK_ID + ${{POINSOT_OFFSET:-0}}))}}p" "$1")
name=${{line%%{tab}*}}
exec >>"logs/$name.log" 2>&1
rm -f "state/$name.failed"
: >"state/$name.started"
# On one core a second thread only takes turns with the first.
[ "${{SLURM_CPUS_PER_TASK:-1}}" -gt 1 ] || export LP_NUM_THREADS=0
tries=3
while :; do
    (eval "${{line#*{tab}}}")
    code=$?
    tries=$((tries - 1))
    if [ $code -lt 128 ] || [ $tries -eq 0 ]; then break; fi
    echo "ended by signal $((code - 128)); starting again"
done
if [ $code -eq 0 ]; then : >"state/$name.done"; else echo $code >"state/$name.failed"; fi
exit $code
)";

// A name for logs and states, unique in the submission.
std::string name_for(const fs::path& output, std::set<std::string>& taken) {
    std::string stem = output.stem().string();
    std::replace_if(
        stem.begin(), stem.end(), [](char c) { return c == '#' || c == ' ' || c == '\t'; }, '_');
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
    return name;
}

// A folder of a submission lists the files that poinsot writes into it.
FileLog log_of(const fs::path& folder) {
    return {folder, "poinsot-files", "poinsot: files of a submission"};
}

// Throws for a link, too: files would be written into somebody else's folder.
void make_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_symlink(folder, error))
        throw InputError(fmt::format("{}: is a link; remove it, or name another output",
                                     printable(folder.string())));
    fs::create_directories(folder, error);
    if (error)
        throw EnvironmentError(
            fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

// A line of a list. Throws InputError for a word that would end it or change what a terminal shows.
std::string in_shell(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        if (has_control_characters(word))
            throw InputError(fmt::format(
                "{}: a list of commands cannot hold the control characters of this name "
                "or value; leave them out",
                printable(word)));
        line += (line.empty() ? "" : " ") + shell_word(word);
    }
    return line;
}

std::string program() {
    const fs::path path = program_path();
    return path.empty() ? "poinsot" : path.string();
}

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

// Adds the tasks of one film: its parts, and their join. Returns its line in `films`.
std::string add_film(Submission& submission, const FilmToSubmit& film,
                     const std::vector<std::string>& options, std::int64_t n_asked,
                     const std::string& name, std::vector<fs::path>& folders) {
    const OutputFormat& format = format_for(film.output);
    if (!format.has_parts)
        throw InputError(
            fmt::format("{}: this format has no parts; name a film, or a sequence with ####",
                        printable(film.output.string())));
    const std::int64_t n_parts =
        part_of_film(1, n_asked, film.n_frames, format.n_chunk_frames).n_parts;
    const fs::path output = fs::absolute(film.output);
    const fs::path parts = submission.folder / "parts" / name;
    const bool is_film = format.join != nullptr;
    if (is_film) folders.insert(folders.end(), {parts.parent_path(), parts});
    std::string line =
        fmt::format("{}\t{}\t{}\t{}\n", name, n_parts, output.string(), film.scene_hash);
    std::vector<std::string> join{program(), "join", "-q", "-o", output.string()};
    if (!is_film) join.push_back(output.string());
    for (std::int64_t number = 1; number <= n_parts; ++number) {
        const fs::path part = is_film ? parts / fmt::format("{}-of-{}{}", number, n_parts,
                                                            output.extension().string())
                                      : output;
        if (is_film) join.push_back(part.string());
        std::vector<std::string> command{program(), "render", fs::absolute(film.scene).string()};
        command.insert(command.end(), options.begin(), options.end());
        command.insert(command.end(), film.options.begin(), film.options.end());
        for (const std::string& word :
             {std::string("-q"), std::string("--part"), fmt::format("{}/{}", number, n_parts),
              std::string("-o"), part.string()})
            command.push_back(word);
        submission.parts.push_back({fmt::format("{}.{}", name, number), in_shell(command), line});
    }
    std::string command = in_shell(join);
    // The folder of the parts goes if nothing else is in it.
    if (is_film)
        command +=
            fmt::format(" && rm -f {} && {{ rmdir {} 2>/dev/null || true; }}",
                        in_shell({join.begin() + 5, join.end()}), in_shell({parts.string()}));
    submission.joins.push_back({name + ".join", command, line});
    return line;
}

std::string list_of(const std::vector<SubmittedTask>& tasks) {
    std::string text;
    for (const SubmittedTask& task : tasks)
        text += fmt::format("{}\t{}\n", task.name, task.command);
    return text;
}

// Throws InputError for a folder of somebody else, and for one whose files were edited since.
void check_submission_folder(const FileLog& log) {
    for (const char* name : {task_name, "films", "joins", "tasks"})
        log.check(name, "the submission");
}

// The names of the tasks in a list.
std::vector<std::string> tasks_in(const std::string& list) {
    std::vector<std::string> names;
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);)
        names.push_back(line.substr(0, line.find('\t')));
    return names;
}

void remove_states(const fs::path& folder, const std::string& task) {
    std::error_code ignored;
    for (const char* what : {".started", ".done", ".failed"})
        fs::remove(folder / "state" / (task + what), ignored);
}

// Keeps the state of tasks that were submitted before and are unchanged; removes those of other
// tasks, and their logs.
void keep_what_is_done(Submission& submission) {
    const fs::path& folder = submission.folder;
    const std::string before = read_text_if_there(folder / "films");
    const auto is_as_before = [&](const char* list, const std::vector<SubmittedTask>& tasks) {
        return read_text_if_there(folder / list) == list_of(tasks);
    };
    const bool is_continued =
        is_as_before("tasks", submission.parts) && is_as_before("joins", submission.joins);
    if (!is_continued)
        for (const char* list : {"tasks", "joins"})
            for (const std::string& name : tasks_in(read_text_if_there(folder / list))) {
                remove_states(folder, name);
                std::error_code ignored;
                fs::remove(folder / "logs" / (name + ".log"), ignored);
            }
    for (auto* tasks : {&submission.parts, &submission.joins})
        for (SubmittedTask& task : *tasks)
            if (is_continued && before.find(task.film) != std::string::npos)
                task.is_done = is_there(folder / "state" / (task.name + ".done"));
            else
                remove_states(folder, task.name);
}

}  // namespace

fs::path submission_folder(const fs::path& output) {
    std::string name = output.filename().string();
    std::erase_if(name, [](char c) { return c == '#' || c == '{' || c == '}'; });
    return output.parent_path() / (name + ".job");
}

Submission write_submission(const fs::path& folder, const std::vector<FilmToSubmit>& films,
                            const std::vector<std::string>& options, std::int64_t n_parts) {
    FileLog log = log_of(folder);
    check_submission_folder(log);
    Submission submission;
    submission.folder = fs::weakly_canonical(fs::absolute(folder));
    const std::string script = fmt::format(
        fmt::runtime(task_script), fmt::arg("folder", in_shell({submission.folder.string()})),
        fmt::arg("tab", "\t"));
    std::set<std::string> taken;
    std::vector<fs::path> folders{submission.folder / "state", submission.folder / "logs"};
    std::string list;
    for (const FilmToSubmit& film : films)
        list += add_film(submission, film, options, n_parts, name_for(film.output, taken), folders);
    make_folder(folder);
    log.begin();
    const auto write = [&](const char* name, const std::string& text) {
        log.add(name, text);
        write_whole(submission.folder / name, text);
    };
    write(task_name, script);
    keep_what_is_done(submission);
    for (const fs::path& each : folders) make_folder(each);
    write("films", list);
    write("joins", list_of(submission.joins));
    write("tasks", list_of(submission.parts));
    return submission;
}

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> pieces;
    std::string rest = text;
    for (std::size_t at = 0; (at = rest.find(separator)) != std::string::npos;) {
        pieces.push_back(rest.substr(0, at));
        rest.erase(0, at + 1);
    }
    if (!rest.empty()) pieces.push_back(rest);
    return pieces;
}

// Whether a file was modified within the last minutes, by the file system's clock.
bool is_fresh(const fs::path& path) {
    constexpr auto patience = std::chrono::minutes(5);
    std::error_code error;
    const auto written = fs::last_write_time(path, error);
    return !error && fs::file_time_type::clock::now() - written < patience;
}

std::string last_line_of(const fs::path& log) {
    const std::vector<std::string> lines = split(read_text_if_there(log), '\n');
    return lines.empty() ? "" : lines.back();
}

TaskStatus status_of_task(const fs::path& folder, const std::string& name, const fs::path& part) {
    const auto state = [&](const char* what) { return folder / "state" / (name + what); };
    TaskStatus status;
    status.name = name;
    if (is_there(state(".done"))) {
        status.state = TaskState::done;
    } else if (is_there(state(".failed"))) {
        status.state = TaskState::failed;
        status.why = last_line_of(folder / "logs" / (name + ".log"));
    } else if (is_there(state(".started"))) {
        const fs::path aside = part.empty() ? fs::path() : frame_log_path(part);
        const bool alive = is_fresh(state(".started")) || is_fresh(aside);
        status.state = alive ? TaskState::running : TaskState::stopped;
        try {
            if (is_there(aside)) {
                const PartFile under_way(aside);
                status.n_frames_done = under_way.n_there();
                status.n_frames = under_way.part().n_frames;
            }
        } catch (const Error&) {
            // The part was completed or created at this moment.
        }
    }
    return status;
}

// The folder itself, or the only submission in it.
fs::path folder_with_tasks(const fs::path& folder) {
    if (is_there(folder / "films")) return folder;
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
         at.increment(error))
        if (at->path().extension() == ".job" && is_there(at->path() / "films"))
            found.push_back(at->path());
    if (found.size() == 1) return found.front();
    throw InputError(fmt::format(
        "{}: {}", printable(folder.string()),
        found.empty() ? "is not the folder of a submission; give the folder that submit printed"
                      : "contains several submissions; name one of its .job folders"));
}

}  // namespace

std::vector<FilmStatus> status_of(const fs::path& asked) {
    const fs::path folder = folder_with_tasks(asked);
    std::vector<FilmStatus> films;
    for (const std::string& line : split(read_text_if_there(folder / "films"), '\n')) {
        const std::vector<std::string> fields = split(line, '\t');
        if (fields.size() != 4)
            throw InputError(fmt::format("{}: is not a list of films; submit the films again",
                                         printable((folder / "films").string())));
        FilmStatus film;
        film.name = fields[0];
        film.output = fields[2];
        const std::int64_t n_parts = std::strtoll(fields[1].c_str(), nullptr, 10);
        const std::string suffix = fs::path(film.output).extension().string();
        for (std::int64_t number = 1; number <= n_parts; ++number)
            film.parts.push_back(status_of_task(
                folder, fmt::format("{}.{}", film.name, number),
                folder / "parts" / film.name / fmt::format("{}-of-{}{}", number, n_parts, suffix)));
        film.join = status_of_task(folder, film.name + ".join", {});
        films.push_back(film);
    }
    return films;
}

}  // namespace poinsot
