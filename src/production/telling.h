// What a job has to tell as it goes on, for whoever talks to the user.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace poinsot {

// What is not filled in is not told.
struct Telling {
    // From any thread: while one works, another may say how long it will take.
    std::function<void(const std::string& line)> say = [](const std::string&) {};
    // Of a film: its name and frames when drawing begins, how many there are, and the file once it
    // is whole.
    std::function<void(const std::string& what, std::int64_t n_frames)> begin =
        [](const std::string&, std::int64_t) {};
    std::function<void(std::int64_t n_done)> done = [](std::int64_t) {};
    std::function<void(const std::string& made)> finish = [](const std::string&) {};
};

}  // namespace poinsot
