// A file made aside and renamed when it is whole: under the final name stands the old file or the
// new one, never a part of one. The lowest layer that writes files; images and films both use it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// Throws EnvironmentError: `cannot write PATH: REASON`, the reason being that of the errno given.
[[noreturn]] void throw_write_error(const std::filesystem::path& path, int error_number);

// Where a file is made before it gets its name: hidden, in the same folder.
std::filesystem::path aside_path_of(const std::filesystem::path& path,
                                    std::string_view suffix = ".part");

// Holds the file aside open and locked, so that a second run on the same output is refused. A file
// aside that a killed run has left is taken over. Where the final name is a device or a pipe there
// is nothing to make aside: bytes go straight to it. A symbolic link is followed. "-" is standard
// output; writing to it throws ReaderGone where nobody reads. Move-only.
//
// Writing past a limit on file sizes raises SIGXFSZ, which the program must ignore for the error to
// arrive here.
class AtomicFile {
 public:
    // Throws EnvironmentError if the folder does not exist or cannot be written, if the name is
    // that of a folder, or if another run holds the file.
    explicit AtomicFile(const std::filesystem::path& path);
    // The same with a file aside of the caller's naming, in the same folder.
    // keep_contents leaves what a killed run has written, for the caller to go on from, and unless
    // it is discarded leaves it again.
    // Another run that holds it is waited for where when_held is given, which is called first.
    AtomicFile(const std::filesystem::path& path, const std::filesystem::path& aside,
               bool keep_contents = false, const std::function<void()>& when_held = {});
    ~AtomicFile();  // removes what is aside, unless it was committed or released or is kept
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;

    int descriptor() const { return descriptor_; }
    const std::filesystem::path& path() const { return path_; }    // final name, links followed
    const std::filesystem::path& aside() const { return aside_; }  // empty for a device

    // Appends at the descriptor's position. Throws EnvironmentError.
    void write(std::span<const std::uint8_t> bytes);

    // Syncs the contents, renames, syncs the folder and closes. Throws EnvironmentError, and then
    // leaves nothing.
    void commit();

    // Syncs, closes and leaves the contents aside for a later run to find.
    void release();

    // Removes what is aside and closes.
    void discard() noexcept;

    // Takes the place of another file aside of the same output, which is closed and forgotten.
    // Throws EnvironmentError.
    void replace(AtomicFile& other);

 private:
    void open_aside(const std::function<void()>& when_held);
    bool has_contents() const;

    std::filesystem::path path_;
    std::filesystem::path aside_;
    int descriptor_ = -1;
    bool keeps_ = false;
};

// A whole file at once. Throws EnvironmentError.
void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_whole(const std::filesystem::path& path, std::string_view text);

}  // namespace poinsot
