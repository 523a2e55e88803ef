// The path of the running program, and of the files installed with it.
#pragma once

#include <filesystem>

namespace poinsot {

// The program's executable; empty if the system does not report it.
std::filesystem::path program_path();

// The folder of the program's own files, such as its fonts and scenes; it may be missing: the one
// that was set, or else share/poinsot in the program's install prefix.
std::filesystem::path program_share();

// For code that is loaded into another program, before anything else runs.
void set_program_share(std::filesystem::path folder);

}  // namespace poinsot
