// Prints notes and progress on stderr: a bar on a terminal, or regular lines in a log.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "production/session/task.h"

namespace poinsot {

class ProgressBar {
 public:
    explicit ProgressBar(bool quiet);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // Callbacks that use this object, which must outlive them; they print nothing if quiet.
    Task task();

 private:
    using Clock = std::chrono::steady_clock;

    void begin(const std::string& what, std::int64_t total);
    void at(std::int64_t done);
    // Ends the bar and prints the name of the result.
    void finish(const std::string& made);

    bool quiet_;
    bool terminal_;
    std::string what_;
    std::int64_t total_ = 0;
    bool bar_open_ = false;
    Clock::time_point started_{};
    Clock::time_point last_shown_{};
};

}  // namespace poinsot
