// Entry: hands over to the command line; what nothing else catches, and the exit codes.
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "cli/program.h"
#include "error/error.h"
#include "text/printable.h"

namespace {

// A message may quote names and texts from anywhere; a terminal must not obey them. It is the last
// chance to be heard: where the stream fails, the file below it is tried.
void say(const char* message) {
    const std::string line = poinsot::printable(message, poinsot::most_of_a_message) + "\n";
    if (std::fputs(line.c_str(), stderr) == EOF &&
        write(STDERR_FILENO, line.data(), line.size()) < 0)
        std::perror("poinsot");
}

// As the tools do that know nothing of signals: `poinsot sample … | head` ends by SIGPIPE.
int end_with_the_reader() {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    return 128 + SIGPIPE;
}

}  // namespace

int main(int argc, char** argv) {
    // A closed pipe and a limit on file sizes are errors of a write, with a sentence, not deaths.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // Large buffers go back to the system when they are freed: a film's encoder is made anew every
    // few seconds, and memory must not grow with the film. What a frame frees, the next one takes.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    mallopt(M_TRIM_THRESHOLD, 32 << 20);
    try {
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
    } catch (const std::system_error& error) {
        // Only printing on stdout leaves by it with this number.
        if (error.code() == std::errc::broken_pipe) return end_with_the_reader();
        say(("poinsot: " + std::string(error.what())).c_str());
        return 3;
    } catch (const std::exception& error) {
        say(("poinsot: " + std::string(error.what())).c_str());
        return 3;
    }
}
