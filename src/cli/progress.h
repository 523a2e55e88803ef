// How far a long job is: a bar on a terminal, plain lines elsewhere, nothing when quiet. All on
// stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace poinsot {

class Progress {
 public:
    Progress(std::string what, std::int64_t total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void at(std::int64_t done);
    // Ends the bar and prints what was made.
    void finish(const std::string& made);

 private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    std::int64_t total_;
    bool quiet_;
    bool terminal_;
    bool bar_open_ = false;
    Clock::time_point started_ = Clock::now();
    Clock::time_point last_shown_{};
};

}  // namespace poinsot
