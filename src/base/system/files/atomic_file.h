// Writes files atomically: a temporary file is renamed when it is complete, so that the final name
// is always the old or the new file. The lowest layer that writes files; used for images and films.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// Throws EnvironmentError: `cannot write PATH: REASON`, with the reason of this errno.
[[noreturn]] void throw_write_error(const std::filesystem::path& path, int error_number);

// The path of the temporary file: hidden, in the same folder.
std::filesystem::path aside_path_of(const std::filesystem::path& path,
                                    std::string_view suffix = ".part");

// Throws EnvironmentError if the temporary file of this output exists and is not unfinished work of
// poinsot: call it before work whose result the file will hold.
void check_aside(const std::filesystem::path& path);

// Removes the temporary file that a killed run has left of an output, and no other file.
void remove_left_aside(const std::filesystem::path& path) noexcept;

// Throws EnvironmentError for what has the name of unfinished work and is something else. `what`:
// "file" or "folder".
[[noreturn]] void refuse_aside(const std::filesystem::path& path,
                               const std::filesystem::path& aside, std::string_view what);

// Whether an unmarked file is unfinished work, by its contents.
using IsUnfinished = std::function<bool(int descriptor)>;

// Holds the temporary file open and locked, so that a second run with the same output is rejected.
// Takes over a temporary file that a killed run has left. The sticky bit, which has no other
// meaning for a file, marks it: any other file of this name is refused. On file systems that do not
// keep this bit, the user removes what a killed run has left. If the final name is a device or a
// pipe, bytes go directly to it, without a temporary file. Symbolic links are followed. "-" is
// standard output; writing to it throws ReaderGone if the reader has closed the pipe. Move-only.
//
// Writing past a limit on file size raises SIGXFSZ; the program must ignore it so that this class
// can report the error.
class AtomicFile {
 public:
    // Throws EnvironmentError if the folder does not exist or is not writable, if the name is a
    // folder, if another run holds the file, or if something else has the temporary file's name.
    explicit AtomicFile(const std::filesystem::path& path);
    // The same with a temporary file named by the caller, in the same folder. keep_contents keeps
    // the contents that a killed run has written, so that the caller can continue, and keeps them
    // again unless the file is discarded; it must then be marked, or else be recognised by
    // is_unfinished. With when_held, waits for another run that holds the file, after calling
    // when_held.
    AtomicFile(const std::filesystem::path& path, const std::filesystem::path& aside,
               bool keep_contents = false, const std::function<void()>& when_held = {},
               const IsUnfinished& is_unfinished = {});
    // Only a lock for an output, which may be a folder: never commit it.
    static AtomicFile lock(const std::filesystem::path& output, const std::filesystem::path& aside);
    ~AtomicFile();  // removes the temporary file, unless committed, released or kept
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;

    int descriptor() const { return descriptor_; }
    // The final name as it was given.
    const std::filesystem::path& path() const { return path_; }
    // The temporary file; empty for a device.
    const std::filesystem::path& aside() const { return aside_; }

    // Appends at the current position. Throws EnvironmentError.
    void write(std::span<const std::uint8_t> bytes);

    // Syncs the contents, renames the file, syncs the folder and closes. On failure throws
    // EnvironmentError and removes the temporary file.
    void commit();

    // Syncs, closes and leaves the temporary file for a later run.
    void release();

    // Removes the temporary file and closes.
    void discard() noexcept;

    // Renames this temporary file to the path of `other`, another temporary file of the same
    // output, which is closed. Throws EnvironmentError.
    void replace(AtomicFile& other);

 private:
    AtomicFile() = default;
    void open_aside(const std::function<void()>& when_held, const IsUnfinished& is_unfinished);
    bool has_contents() const;

    std::filesystem::path path_;    // for messages
    std::filesystem::path target_;  // with links followed
    std::filesystem::path aside_;
    int descriptor_ = -1;
    bool keeps_ = false;
};

// Writes a whole file atomically. Throws EnvironmentError.
void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_whole(const std::filesystem::path& path, std::string_view text);

}  // namespace poinsot
