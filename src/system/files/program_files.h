// The path of the running program, and of the files installed with it.
#pragma once

#include <filesystem>

namespace poinsot {

// The program's executable; empty if the system does not report it.
std::filesystem::path program_path();

// share/poinsot in the program's install prefix; it may be missing.
std::filesystem::path program_share();

}  // namespace poinsot
