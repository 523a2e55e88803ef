// Runs the command line, handles uncaught exceptions and sets the exit code.
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "cli/program.h"
#include "error/error.h"
#include "text/printable.h"

namespace {

// Prints a message, in which texts from anywhere may be quoted, without control characters for the
// terminal. If the stream fails, the message is written to its file descriptor.
void say(const char* message) {
    const std::string line = poinsot::printable(message, poinsot::most_of_a_message) + "\n";
    if (std::fputs(line.c_str(), stderr) == EOF &&
        write(STDERR_FILENO, line.data(), line.size()) < 0)
        std::perror("poinsot");
}

// Like tools that do not handle signals, `poinsot sample … | head` ends by SIGPIPE.
int end_with_the_reader() {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    return 128 + SIGPIPE;
}

}  // namespace

int main(int argc, char** argv) {
    // A closed pipe and a file size limit become write errors with a message, instead of signals
    // that end the process.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // Freed large buffers are returned to the system: a film creates a new encoder every few
    // seconds, and memory must not grow with the film. The next frame reuses the memory of a frame.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    mallopt(M_TRIM_THRESHOLD, 32 << 20);
    try {
        poinsot::prepare_process();
        return poinsot::run_program(argc, argv);
    } catch (const poinsot::InputError& error) {
        say(error.what());
        return 2;
    } catch (const poinsot::ReaderGone&) {
        return end_with_the_reader();
    } catch (const poinsot::Error& error) {
        say(error.what());
        return 3;
    } catch (const std::bad_alloc&) {
        std::fputs("out of memory; ask for a smaller picture or a shorter film\n", stderr);
        return 3;
    } catch (const std::filesystem::filesystem_error& error) {
        say((error.path1().string() + ": " + error.code().message() +
             (error.code() == std::errc::filename_too_long ? "; shorten it" : ""))
                .c_str());
        return 3;
    } catch (const std::system_error& error) {
        // Only printing on stdout throws this error code.
        if (error.code() == std::errc::broken_pipe) return end_with_the_reader();
        if (error.code() == std::errc::resource_unavailable_try_again) {
            std::fputs(
                "no further thread could be started; raise the limits of processes and memory "
                "(ulimit -u, -v, -d)\n",
                stderr);
            return 3;
        }
        say(("poinsot: " + std::string(error.what())).c_str());
        return 3;
    } catch (const std::exception& error) {
        say(("poinsot: " + std::string(error.what())).c_str());
        return 3;
    }
}
