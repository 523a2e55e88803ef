// Files opened for reading: regular files only, since a pipe may never end and a device has no
// size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// A regular file, open for reading while it lives.
class InputFile {
 public:
    // Never blocks: a pipe without a writer is refused like every file that is not regular. Throws
    // InputError for these (`PATH: a pipe or a device, not a regular file; …`), EnvironmentError
    // for a file that is missing or cannot be opened (`cannot read PATH: REASON`).
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;

    int descriptor() const { return descriptor_; }

 private:
    int descriptor_ = -1;
};

// The whole file. Throw as InputFile does, and EnvironmentError where reading fails.
std::string read_text(const std::filesystem::path& path);
std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path);

// The whole file in pieces, in order, so that a file of any size takes little memory. Throws as
// read_text does.
void read_pieces(const std::filesystem::path& path,
                 const std::function<void(std::string_view piece)>& take);

// Its first bytes, all of them where it has fewer. Throws as read_text does.
std::string read_beginning(const std::filesystem::path& path, std::size_t n_bytes);

// Whether this is a regular file that can be read and begins so. Never throws.
bool begins_with(const std::filesystem::path& path, std::string_view beginning) noexcept;

// The whole file, or nothing where there is none. Throws as read_text does.
std::string read_text_if_there(const std::filesystem::path& path);

}  // namespace poinsot
