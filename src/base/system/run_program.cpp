#include "system/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "error/error.h"

namespace poinsot {

namespace {

using Ends = std::array<int, 2>;  // of a pipe: read end, write end

Ends make_pipe() {
    Ends ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw EnvironmentError(std::string("no pipe to another program: ") + std::strerror(errno));
    return ends;
}

// Reads from both pipes until they are closed.
void read_all(const std::array<int, 2>& from, const std::array<std::string*, 2>& to) {
    std::array<pollfd, 2> pipes{pollfd{from[0], POLLIN, 0}, pollfd{from[1], POLLIN, 0}};
    std::array<char, 4096> buffer{};
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
        if (::poll(pipes.data(), pipes.size(), -1) < 0) {
            if (errno == EINTR) continue;
            break;
        }
        for (std::size_t i = 0; i < pipes.size(); ++i) {
            if (pipes[i].fd < 0 || pipes[i].revents == 0) continue;
            const ssize_t n = ::read(pipes[i].fd, buffer.data(), buffer.size());
            if (n < 0 && errno == EINTR) continue;
            if (n > 0)
                to[i]->append(buffer.data(), static_cast<std::size_t>(n));
            else
                pipes[i].fd = -1;
        }
    }
}

}  // namespace

ProgramOutcome run_program(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const Ends out = make_pipe(), err = make_pipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
    pid_t process = -1;
    const int failed = ::posix_spawnp(&process, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(out[1]);
    ::close(err[1]);
    ProgramOutcome outcome;
    if (failed == 0) {
        read_all({out[0], err[0]}, {&outcome.out, &outcome.err});
        int status = 0;
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    ::close(out[0]);
    ::close(err[0]);
    outcome.found = failed != ENOENT && failed != EACCES;
    if (failed != 0 && outcome.found)
        throw EnvironmentError(command.front() + ": " + std::strerror(failed));
    return outcome;
}

std::string shell_word(const std::string& text) {
    const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::strchr("_-./=:,+@%", c) != nullptr;
    });
    if (plain) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::vector<std::string> shell_words(const std::string& line) {
    std::vector<std::string> words;
    bool inside = false;
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        char c = line[i];
        const bool parts = quote == 0 && (c == ' ' || c == '\t' || c == '\n');
        if (parts) {
            inside = false;
            continue;
        }
        if (!inside) words.emplace_back();
        inside = true;
        if (quote != 0 ? c == quote : c == '\'' || c == '"') {
            quote = quote != 0 ? 0 : c;
            continue;
        }
        if (c == '\\' && quote != '\'' && i + 1 < line.size()) c = line[++i];
        words.back() += c;
    }
    return words;
}

}  // namespace poinsot
