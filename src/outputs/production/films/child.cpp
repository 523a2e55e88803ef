#include "production/films/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <string_view>

#include "error/error.h"
#include "system/interrupt.h"
#include "text/numbers.h"

namespace poinsot {

namespace {

// The first letter of a line in the pipe is its kind.
constexpr char tells_done = 'd', tells_line = 's', tells_refusal = 'r', tells_failure = 'f';

// Separates the lines of a message, which is one line in the pipe.
constexpr char line_break = '\x1e';

void tell(int pipe, char what, std::string text) {
    std::replace(text.begin(), text.end(), '\n', line_break);
    text = what + text + '\n';
    for (std::string_view rest = text; !rest.empty();) {
        const ssize_t n = ::write(pipe, rest.data(), rest.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return;  // the parent has died: the signal follows
        rest.remove_prefix(static_cast<std::size_t>(n));
    }
}

Task telling_on(int pipe) {
    Task task;
    task.say = [pipe](const std::string& line) { tell(pipe, tells_line, line); };
    task.done = [pipe](std::int64_t n) { tell(pipe, tells_done, fmt::format("{}", n)); };
    return task;
}

[[noreturn]] void run(const Children::Work& work, int pipe) {
    int code = 1;
    try {
        work(telling_on(pipe));
        code = 0;
    } catch (const InputError& error) {
        tell(pipe, tells_refusal, error.what());
    } catch (const std::bad_alloc&) {
        tell(pipe, tells_failure,
             "out of memory; use fewer jobs, a smaller picture or a shorter film");
    } catch (const std::exception& error) {
        tell(pipe, tells_failure, error.what());
    }
    // Exits without flushing buffers or running destructors of the parent.
    ::_exit(code);
}

}  // namespace

void Children::start(const Work& work) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw EnvironmentError(
            fmt::format("cannot make a pipe to another process: {}", std::strerror(errno)));
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
        // Not SIGTERM, after which a child would finish its frame and flush its encoder; the log
        // has all finished frames in any case. The parent may have died before this call.
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(1);
        ::close(ends[0]);
        for (const Child& other : children_) ::close(other.pipe);
        run(work, ends[1]);
    }
    ::close(ends[1]);
    if (process < 0) {
        ::close(ends[0]);
        throw EnvironmentError(fmt::format("cannot start a process: {}", std::strerror(errno)));
    }
    Child& child = children_.emplace_back();
    child.process = process;
    child.pipe = ends[0];
}

Children::~Children() {
    for (const Child& child : children_)
        if (child.process > 0) ::kill(child.process, SIGTERM);
    for (Child& child : children_) {
        if (child.process > 0)
            while (::waitpid(child.process, nullptr, 0) < 0 && errno == EINTR) {
            }
        if (child.pipe >= 0) ::close(child.pipe);
    }
}

void Children::take_line(Child& child, const std::string& line, const Task& task) {
    std::string text = line.substr(1);
    std::replace(text.begin(), text.end(), line_break, '\n');
    if (line[0] == tells_done) {
        child.n_done = number_of<std::int64_t>(text).value_or(child.n_done);
        std::int64_t n_done = 0;
        for (const Child& each : children_) n_done += each.n_done;
        task.done(n_done);
    } else if (line[0] == tells_line) {
        // Notes are the same from all children: only the first one's are shown.
        if (&child == &children_.front()) task.say(text);
    } else {
        child.failure = text;
        child.refused = line[0] == tells_refusal;
    }
}

// Reads a child's messages; a closed pipe means that the child has ended.
void Children::listen(Child& child, const Task& task) {
    std::array<char, 4096> buffer{};
    const ssize_t n = ::read(child.pipe, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) return;
    if (n <= 0) return end(child);
    child.heard.append(buffer.data(), static_cast<std::size_t>(n));
    for (std::size_t at = 0; (at = child.heard.find('\n')) != std::string::npos;) {
        const std::string line = child.heard.substr(0, at);
        child.heard.erase(0, at + 1);
        if (!line.empty()) take_line(child, line, task);
    }
}

void Children::end(Child& child) {
    int status = 0;
    while (::waitpid(child.process, &status, 0) < 0 && errno == EINTR) {
    }
    child.process = -1;
    ::close(child.pipe);
    child.pipe = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    if (child.refused) throw InputError(child.failure);
    if (!child.failure.empty()) throw EnvironmentError(child.failure);
    const std::string how = WIFSIGNALED(status)
                                ? fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                                              ::strsignal(WTERMSIG(status)))
                                : fmt::format("ended with code {}", WEXITSTATUS(status));
    throw EnvironmentError(fmt::format("job {} of {} {}; run the same command again to continue",
                                       &child - children_.data() + 1, children_.size(), how));
}

void Children::wait(const Task& task) {
    for (;;) {
        stop_if_interrupted();
        std::vector<pollfd> pipes;
        std::vector<Child*> heard;
        for (Child& child : children_) {
            if (child.pipe < 0) continue;
            pipes.push_back({.fd = child.pipe, .events = POLLIN, .revents = 0});
            heard.push_back(&child);
        }
        if (pipes.empty()) return;
        // Limits the delay of a signal that arrives between the check above and this call.
        constexpr int patience_ms = 200;
        if (::poll(pipes.data(), pipes.size(), patience_ms) <= 0) continue;
        for (std::size_t i = 0; i < pipes.size(); ++i)
            if (pipes[i].revents != 0) listen(*heard[i], task);
    }
}

}  // namespace poinsot
