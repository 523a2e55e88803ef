#include "system/files/program_files.h"

#include <system_error>
#include <utility>

namespace poinsot {

namespace {

std::filesystem::path& share_that_was_set() {
    static std::filesystem::path folder;
    return folder;
}

}  // namespace

void set_program_share(std::filesystem::path folder) { share_that_was_set() = std::move(folder); }

std::filesystem::path program_path() {
    std::error_code error;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path() : program;
}

std::filesystem::path program_share() {
    if (!share_that_was_set().empty()) return share_that_was_set();
    return program_path().parent_path().parent_path() / "share" / "poinsot";
}

}  // namespace poinsot
