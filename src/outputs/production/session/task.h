// Work that may take long: what it says to its user, how far it is, and whether it shall stop.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace poinsot {

// The defaults do nothing. open_session, make_output and the library's drawing thread hold `stop`
// while they work: wherever stop_if_interrupted() is called below them, it asks.
struct Task {
    // May be called from any thread: while one works, another may report an estimate of the time.
    std::function<void(const std::string& line)> say = [](const std::string&) {};
    // For films: the film's name and number of frames when drawing starts, the number of finished
    // frames, and the completed file.
    std::function<void(const std::string& what, std::int64_t n_frames)> begin =
        [](const std::string&, std::int64_t) {};
    std::function<void(std::int64_t n_done)> done = [](std::int64_t) {};
    std::function<void(const std::string& made)> finish = [](const std::string&) {};
    // Whether the work shall end, with an EnvironmentError; asked about every 20 ms on the thread
    // that works. Signals end it as well.
    std::function<bool()> stop{};
};

}  // namespace poinsot
