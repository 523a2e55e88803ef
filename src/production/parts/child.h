// Work done by a process of its own, and what it tells of it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "production/telling.h"

namespace poinsot {

// Runs work in forked processes and hears them. Precondition: this process has one thread.
class Children {
 public:
    using Work = std::function<void(const Telling& telling)>;

    // Starts one; what it throws ends it. It is killed when this process dies. Throws
    // EnvironmentError.
    void start(const Work& work);
    ~Children();  // ends those that still run, and waits for them
    Children() = default;
    Children(const Children&) = delete;
    Children& operator=(const Children&) = delete;

    // Waits until all have ended well, and passes on how many of all their frames are done and what
    // the first says. Throws what the first failure said, as InputError or EnvironmentError, one
    // that was killed being a failure, and when this process is interrupted.
    void wait(const Telling& telling);

 private:
    struct Child {
        pid_t process = -1;  // −1: has ended
        int pipe = -1;
        std::string heard;  // no whole line yet
        std::int64_t n_done = 0;
        std::string failure;
        bool refused = false;  // failed by its input
    };
    void listen(Child& child, const Telling& telling);
    void take_line(Child& child, const std::string& line, const Telling& telling);
    void end(Child& child);

    std::vector<Child> children_;
};

}  // namespace poinsot
