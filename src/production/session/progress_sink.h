// Progress callbacks of a job, for the code that talks to the user.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace poinsot {

// Unset callbacks do nothing.
struct ProgressSink {
    // May be called from any thread: while one works, another may report an estimate of the time.
    std::function<void(const std::string& line)> say = [](const std::string&) {};
    // For films: the film's name and number of frames when drawing starts, the number of finished
    // frames, and the completed file.
    std::function<void(const std::string& what, std::int64_t n_frames)> begin =
        [](const std::string&, std::int64_t) {};
    std::function<void(std::int64_t n_done)> done = [](std::int64_t) {};
    std::function<void(const std::string& made)> finish = [](const std::string&) {};
};

}  // namespace poinsot
