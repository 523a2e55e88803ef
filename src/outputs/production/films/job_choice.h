// The default number of processes for a film: as many as speed it up on this machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "production/session/plan.h"
#include "production/session/session.h"

namespace poinsot {

// The resources of a machine.
struct Machine {
    int n_cores = 1;              // available to this process
    std::int64_t memory_MiB = 0;  // of the machine; 0: unknown
};
Machine this_machine();

// The properties of a film that determine its cost.
struct FilmWork {
    std::int64_t n_frames = 0;
    int width_px = 0, height_px = 0;
    std::string quality;
    std::filesystem::path output;  // its suffix determines the format
};
FilmWork work_of(const Session& session, std::int64_t n_frames,
                 const std::filesystem::path& output);

struct JobChoice {
    int n_jobs = 1;
    int n_threads = 1;            // drawing threads per process; encoders have their own
    std::int64_t memory_MiB = 0;  // of all of them, approximately
    std::string why;
};

// Depends only on the machine's and the film's properties, never on load or a clock, so that the
// same command always has the same result. Throws InputError for an unknown name or quality.
JobChoice choose_jobs(const FilmWork& film, const Machine& machine);

// "2 processes, each drawing with one thread, about 900 MiB together"
std::string in_words(const JobChoice& choice);

// How a film can be divided, and into how many processes it is by default.
std::vector<PlanLine> plan_of_parts(const Session& session, const FilmPlan& film);

// Drawing threads per process for this number of processes.
int n_drawing_threads(int n_jobs, int n_cores);

}  // namespace poinsot
