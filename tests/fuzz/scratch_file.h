// Bytes as a named file, for functions that read files; the next one replaces it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "temporary_folder.h"

namespace poinsot::fuzz {

// A folder for this process, removed at its end.
inline const std::filesystem::path& scratch_folder() {
    static const TemporaryFolder folder;
    return folder.path();
}

inline std::filesystem::path scratch_file(const std::string& name, const std::uint8_t* data,
                                          std::size_t size) {
    const std::filesystem::path path = scratch_folder() / name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path;
}

}  // namespace poinsot::fuzz
