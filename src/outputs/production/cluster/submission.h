// Films in parts as tasks for other machines: a folder with the tasks' commands and, as they run,
// their states. It consists of files only, so that it works with any scheduler.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

// A film to be made on other machines.
struct FilmToSubmit {
    std::string scene;                 // its file
    std::vector<std::string> options;  // of render, for this film
    std::filesystem::path output;
    std::int64_t n_frames = 0;
    std::string scene_hash;  // of the record: includes meshes and pictures
};

// A line of a task list: a name, a tab, and a shell command.
struct SubmittedTask {
    std::string name;  // of film and part: "generic.3"; "generic.join"
    std::string command;
    std::string film;      // its film's line in `films`
    bool is_done = false;  // by an earlier submission of the unchanged film
};

struct Submission {
    std::filesystem::path folder;
    std::vector<SubmittedTask> parts, joins;  // joins run when all parts are done
};

// The folder of a submission, named after the output: "film.mp4.job", beside it; {}, # are left
// out.
std::filesystem::path submission_folder(const std::filesystem::path& output);

// Writes the folder: `tasks`, `joins`, `films` and `task.sh`, which runs a line of a list and
// writes its log and its state. `options` are passed to every render. An earlier submission of the
// same films is continued, except for films whose scenes have changed. Throws InputError for an
// output format without parts, EnvironmentError.
Submission write_submission(const std::filesystem::path& folder,
                            const std::vector<FilmToSubmit>& films,
                            const std::vector<std::string>& options, std::int64_t n_parts);

// State of a task, from the files of its folder.
enum class TaskState { waiting, running, stopped, failed, done };
struct TaskStatus {
    std::string name;
    TaskState state = TaskState::waiting;
    std::int64_t n_frames_done = -1, n_frames = -1;  // of an unfinished task; −1: unknown
    std::string why;                                 // if it failed: the last line of its log
};

struct FilmStatus {
    std::string name, output;
    std::vector<TaskStatus> parts;
    TaskStatus join;
};

// Status of a submission folder, or of the only submission in a folder. Throws InputError if there
// is none.
std::vector<FilmStatus> status_of(const std::filesystem::path& folder);

}  // namespace poinsot
