// The program: parses the command line and runs one command.
#pragma once

#include <any>
#include <functional>
#include <vector>

namespace poinsot {

// A command line that has been read. Move-only.
struct CommandToRun {
    CommandToRun() = default;
    CommandToRun(CommandToRun&&) = default;

    std::vector<std::any> rooms;  // the choices of every command, which `run` reads where they are
    std::function<int()> run;     // returns the exit code; throws Error
};

// Reads a command line and does nothing of it but printing help or version where they are asked
// for. Throws InputError.
CommandToRun read_command_line(int argc, const char* const* argv);

// Returns the exit code: 0 done, 1 the answer is no. Throws InputError (2) and EnvironmentError
// (3).
int run_program(int argc, const char* const* argv);

}  // namespace poinsot
