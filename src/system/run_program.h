// Another program, run to its end: what it said and how it ended.
#pragma once

#include <string>
#include <vector>

namespace poinsot {

struct ProgramOutcome {
    bool found = true;  // otherwise there is no such program, and nothing ran
    int code = -1;      // its exit code; 128 + the signal that ended it
    std::string out, err;
};

// Looks the program up along PATH; its input is empty. Throws EnvironmentError if no process can be
// made.
ProgramOutcome run_program(const std::vector<std::string>& command);

// As a shell reads it back: in single quotes where it has anything that a shell would not pass on.
std::string shell_word(const std::string& text);

// The words of a line, as a shell parts them: at spaces, quotes keep them together, a backslash
// keeps what follows it.
std::vector<std::string> shell_words(const std::string& line);

}  // namespace poinsot
