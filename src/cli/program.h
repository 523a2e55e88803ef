// The program: parses the command line and runs one command.
#pragma once

namespace poinsot {

// Returns the exit code: 0 done, 1 the answer is no. Throws InputError (2) and EnvironmentError
// (3).
int run_program(int argc, const char* const* argv);

}  // namespace poinsot
