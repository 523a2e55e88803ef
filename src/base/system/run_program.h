// Runs another program to its end and returns its output and exit code.
#pragma once

#include <string>
#include <vector>

namespace poinsot {

struct ProgramOutcome {
    bool found = true;  // false: no such program was found, and nothing ran
    int code = -1;      // the exit code; 128 + signal number if a signal ended the program
    std::string out, err;
};

// Searches the program in PATH and runs it with empty input. Throws EnvironmentError if no process
// can be created.
ProgramOutcome run_program(const std::vector<std::string>& command);

// Quotes a word for a shell: single quotes if it contains special characters.
std::string shell_word(const std::string& text);

// Splits a line into words as a shell does: at spaces, with quotes and backslashes.
std::vector<std::string> shell_words(const std::string& line);

}  // namespace poinsot
