// How many processes draw a film where the user does not say: as many as pay on this machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "production/session.h"

namespace poinsot {

// What there is to draw with.
struct Machine {
    int n_cores = 1;              // that this process may use
    std::int64_t memory_MiB = 0;  // of the machine; 0: not known
};
Machine this_machine();

// What a film is to its processes.
struct FilmWork {
    std::int64_t n_frames = 0;
    int width_px = 0, height_px = 0;
    std::string quality;
    std::filesystem::path output;  // its name says the format
};
FilmWork work_of(const Session& session, std::int64_t n_frames,
                 const std::filesystem::path& output);

struct JobChoice {
    int n_jobs = 1;
    int n_threads = 1;            // that each draws with; the encoders have threads of their own
    std::int64_t memory_MiB = 0;  // of all of them, about
    std::string why;
};

// From the machine's numbers and the film's alone, never from its load or a clock, so that the same
// command does the same again. Throws InputError for a name or quality that is not known.
JobChoice choose_jobs(const FilmWork& film, const Machine& machine);

// "2 processes, each drawing with one thread, about 900 MiB together"
std::string in_words(const JobChoice& choice);

// Threads that each of so many jobs draws with.
int n_drawing_threads(int n_jobs, int n_cores);

}  // namespace poinsot
