#include "system/own_files.h"

#include <system_error>

namespace poinsot {

std::filesystem::path own_program() {
    std::error_code error;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path() : program;
}

std::filesystem::path own_share() {
    return own_program().parent_path().parent_path() / "share" / "poinsot";
}

}  // namespace poinsot
