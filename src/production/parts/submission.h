// Films in parts as tasks for other machines: a folder with what each is to run, and, as they run,
// with what has become of them. Nothing but files tells of them, so any scheduler will do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poinsot {

// A film to be made elsewhere.
struct FilmToSubmit {
    std::string scene;                 // its file
    std::vector<std::string> options;  // of render, its own
    std::filesystem::path output;
    std::int64_t n_frames = 0;
    std::string scene_hash;  // of the record: of all that is drawn, meshes and pictures too
};

// A line of the lists of tasks: a name, a tab, a command as a shell reads it.
struct SubmittedTask {
    std::string name;  // "generic.3": of the film, and of the part; "generic.join"
    std::string command;
    std::string film;      // the line that `films` has of it
    bool is_done = false;  // by an earlier submission of the same film, nothing of it changed since
};

struct Submission {
    std::filesystem::path folder;
    std::vector<SubmittedTask> parts, joins;  // joins when all parts are done
};

// The folder of a submission to an output: beside it, "film.mp4.job"; {}, # are left out.
std::filesystem::path submission_folder(const std::filesystem::path& output);

// Writes the folder: `tasks`, `joins`, `films` and `task.sh`, which runs a line of a list and keeps
// its log and what became of it. `options` go to every render. An earlier submission of the same
// films is gone on with, but for those whose scenes have changed. Throws InputError for an output
// that has no parts, EnvironmentError.
Submission write_submission(const std::filesystem::path& folder,
                            const std::vector<FilmToSubmit>& films,
                            const std::vector<std::string>& options, std::int64_t n_parts);

// What a folder tells of one of its tasks.
enum class TaskState { waiting, running, stopped, failed, done };
struct TaskStatus {
    std::string name;
    TaskState state = TaskState::waiting;
    std::int64_t n_frames_done = -1, n_frames = -1;  // of one that is not done; −1: not known
    std::string why;                                 // it failed: the last line of its log
};

struct FilmStatus {
    std::string name, output;
    std::vector<TaskStatus> parts;
    TaskStatus join;
};

// Of a folder, or of the single submission in it. Throws InputError for one that has none.
std::vector<FilmStatus> status_of(const std::filesystem::path& folder);

}  // namespace poinsot
