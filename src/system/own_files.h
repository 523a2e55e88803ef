// Where the running program lies, and what was installed with it.
#pragma once

#include <filesystem>

namespace poinsot {

// The program's file; empty where the system does not tell.
std::filesystem::path own_program();

// share/poinsot of the prefix that the program lies in, whether it is there or not.
std::filesystem::path own_share();

}  // namespace poinsot
