// Bytes as a named file, for functions that read files: it is in memory, and the next one replaces
// it.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace poinsot::fuzz {

// A folder for this process, in memory if the machine has a memory file system.
inline const std::filesystem::path& scratch_folder() {
    static const std::filesystem::path folder = [] {
        const std::filesystem::path memory = "/dev/shm";
        std::filesystem::path made =
            (std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path()) /
            ("poinsot_fuzz_" + std::to_string(getpid()));
        std::filesystem::create_directories(made);
        std::atexit([] {
            std::error_code ignored;
            std::filesystem::remove_all(scratch_folder(), ignored);
        });
        return made;
    }();
    return folder;
}

inline std::filesystem::path scratch_file(const std::string& name, const std::uint8_t* data,
                                          std::size_t size) {
    const std::filesystem::path path = scratch_folder() / name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path;
}

}  // namespace poinsot::fuzz
