#include "system/files/program_files.h"

#include <system_error>

namespace poinsot {

std::filesystem::path program_path() {
    std::error_code error;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path() : program;
}

std::filesystem::path program_share() {
    return program_path().parent_path().parent_path() / "share" / "poinsot";
}

}  // namespace poinsot
