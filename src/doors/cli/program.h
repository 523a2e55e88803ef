// The program: parses the command line and runs one command.
#pragma once

#include <functional>

namespace poinsot {

// Parses a command line without running the command; prints the help or version if requested.
// Returns what runs the command and returns the exit code; it throws Error. Throws InputError.
std::function<int()> read_command_line(int argc, const char* const* argv);

// To be called before any file is opened: occupies closed standard streams, and checks the limit of
// the stack. Throws EnvironmentError.
void prepare_process();

// Returns the exit code: 0 success, 1 the check failed. Throws InputError (2) and EnvironmentError
// (3).
int run_program(int argc, const char* const* argv);

}  // namespace poinsot
