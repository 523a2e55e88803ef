// Work in a child process, and its progress messages.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "production/session/task.h"

namespace poinsot {

// Runs work in forked processes and receives their messages. Precondition: this process has a
// single thread.
class Children {
 public:
    using Work = std::function<void(const Task& task)>;

    // Starts a process; an exception ends it. It is killed when this process dies. Throws
    // EnvironmentError.
    void start(const Work& work);
    ~Children();  // ends running processes and waits for them
    Children() = default;
    Children(const Children&) = delete;
    Children& operator=(const Children&) = delete;

    // Waits until all processes have succeeded; reports the total of their finished frames, and the
    // messages of the first one. Throws the error of the first failure as InputError or
    // EnvironmentError (a killed process counts as a failure), and if this process is interrupted.
    void wait(const Task& task);

 private:
    struct Child {
        pid_t process = -1;  // −1: has ended
        int pipe = -1;
        std::string heard;  // incomplete line
        std::int64_t n_done = 0;
        std::string failure;
        bool refused = false;  // failed with an InputError
    };
    void listen(Child& child, const Task& task);
    void take_line(Child& child, const std::string& line, const Task& task);
    void end(Child& child);

    std::vector<Child> children_;
};

}  // namespace poinsot
