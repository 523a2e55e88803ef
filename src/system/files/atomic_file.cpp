#include "system/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "error/error.h"
#include "system/interrupt.h"

namespace poinsot {

namespace fs = std::filesystem;

namespace {

std::string reason(int error_number) { return std::generic_category().message(error_number); }

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// The final name with symbolic links followed, so that the link itself is not replaced.
fs::path followed(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_symlink(path, ignored)) return path;
    fs::path target = fs::weakly_canonical(path, ignored);
    return ignored ? path : target;
}

bool is_device(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void check_place(const fs::path& path) {
    std::error_code ignored;
    const fs::path folder = folder_of(path);
    if (!path.has_filename() || fs::is_directory(path, ignored))
        throw EnvironmentError(
            fmt::format("cannot write {}: it is a folder; name a file in it", path.string()));
    if (!fs::exists(folder, ignored) && ignored.value() != EACCES)
        throw EnvironmentError(
            fmt::format("cannot write {}: the folder {} does not exist; make it first",
                        path.string(), folder.string()));
}

// If no file can be created in the folder, the message names the folder, not the file.
[[noreturn]] void throw_open_error(const fs::path& path, int error_number) {
    const bool of_folder = error_number == EACCES || error_number == EPERM ||
                           error_number == EROFS || error_number == ENOENT;
    if (!of_folder) throw_write_error(path, error_number);
    throw EnvironmentError(
        fmt::format("cannot write {}: the folder {} cannot be written ({}); name another",
                    path.string(), folder_of(path).string(), reason(error_number)));
}

// Whether the name still refers to the open file: between opening and locking, another run may have
// renamed or removed it.
bool names(const fs::path& path, int descriptor) {
    struct stat by_name {};
    struct stat by_descriptor {};
    return stat(path.c_str(), &by_name) == 0 && fstat(descriptor, &by_descriptor) == 0 &&
           by_name.st_ino == by_descriptor.st_ino && by_name.st_dev == by_descriptor.st_dev;
}

// The temporary file must be a regular file: bytes for a pipe or a link would go elsewhere, and
// writing to a full pipe would block.
[[noreturn]] void refuse_aside(const fs::path& path, const fs::path& aside) {
    throw EnvironmentError(fmt::format(
        "cannot write {}: its temporary file {} exists and is not a regular file; remove it",
        path.string(), aside.string()));
}

// A pipe is open once somebody reads it. Asked again and again, since a call that waits for that
// would go on through an interrupt.
int open_device(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_fifo(path, ignored)) return ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    int descriptor = -1;
    while ((descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK)) < 0 &&
           errno == ENXIO) {
        stop_if_interrupted();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (descriptor >= 0) fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
    return descriptor;
}

// Tries to lock, 20 ms apart, before another run counts as running: 2 s.
constexpr int n_tries_to_lock = 100;

bool is_regular(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

void throw_write_error(const fs::path& path, int error_number) {
    throw EnvironmentError(fmt::format("cannot write {}: {}", path.string(), reason(error_number)));
}

fs::path aside_path_of(const fs::path& path, std::string_view suffix) {
    return path.parent_path() / fmt::format(".{}{}", path.filename().string(), suffix);
}

AtomicFile::AtomicFile(const fs::path& path) : path_(followed(path)) {
    if (path_ == "-") {
        descriptor_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
        if (descriptor_ < 0) throw_write_error("stdout", errno);
        return;
    }
    check_place(path_);
    if (is_device(path_)) {
        descriptor_ = open_device(path_);
        if (descriptor_ < 0) throw_write_error(path_, errno);
        return;
    }
    aside_ = aside_path_of(path_);
    open_aside({});
}

AtomicFile::AtomicFile(const fs::path& path, const fs::path& aside, bool keep_contents,
                       const std::function<void()>& when_held)
    : path_(followed(path)), aside_(aside), keeps_(keep_contents) {
    check_place(path_);
    open_aside(when_held);
}

AtomicFile::~AtomicFile() {
    // Keep the contents that an interrupted run has left, whatever the error.
    if (keeps_ && has_contents()) aside_.clear();
    discard();
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      aside_(std::exchange(other.aside_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      keeps_(other.keeps_) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
    if (this == &other) return *this;
    discard();
    path_ = std::move(other.path_);
    aside_ = std::exchange(other.aside_, {});
    descriptor_ = std::exchange(other.descriptor_, -1);
    keeps_ = other.keeps_;
    return *this;
}

void AtomicFile::open_aside(const std::function<void()>& when_held) {
    while (descriptor_ < 0) {
        std::error_code ignored;
        const fs::file_status there = fs::symlink_status(aside_, ignored);
        if (fs::exists(there) && !fs::is_regular_file(there)) refuse_aside(path_, aside_);
        const int opened = ::open(aside_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (opened < 0) throw_open_error(path_, errno);
        if (!is_regular(opened)) {
            ::close(opened);
            refuse_aside(path_, aside_);
        }
        // A file system that cannot lock still gets its file; it only cannot refuse a second run.
        int locked = flock(opened, LOCK_EX | LOCK_NB);
        if (locked != 0 && errno == EWOULDBLOCK && when_held) {
            when_held();
            do locked = flock(opened, LOCK_EX);
            while (locked != 0 && errno == EINTR);
        }
        // Processes that were killed hold their files until the system has taken them down.
        for (int n = 0; locked != 0 && errno == EWOULDBLOCK && n < n_tries_to_lock; ++n) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            locked = flock(opened, LOCK_EX | LOCK_NB);
        }
        if (locked != 0 && errno == EWOULDBLOCK) {
            ::close(opened);
            throw EnvironmentError(fmt::format(
                "cannot write {}: another run is writing it; wait for it or name another output",
                path_.string()));
        }
        if (names(aside_, opened))
            descriptor_ = opened;
        else
            ::close(opened);
    }
    if (!keeps_ && ftruncate(descriptor_, 0) != 0) {
        const int error_number = errno;
        discard();
        throw_write_error(path_, error_number);
    }
}

bool AtomicFile::has_contents() const {
    struct stat status {};
    return descriptor_ >= 0 && fstat(descriptor_, &status) == 0 && status.st_size > 0;
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t n_written = ::write(descriptor_, bytes.data(), bytes.size());
        if (n_written < 0) {
            if (errno == EINTR) continue;
            if (errno == EPIPE && path_ == "-") throw ReaderGone("stdout is closed");
            throw_write_error(path_, errno);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(n_written));
    }
}

void AtomicFile::commit() {
    const bool renames = !aside_.empty();
    // A pipe or a terminal cannot be synced and does not need to be.
    if (fsync(descriptor_) != 0 && (renames || (errno != EINVAL && errno != EROFS))) {
        const int error_number = errno;
        discard();
        throw_write_error(path_, error_number);
    }
    if (renames) {
        if (::rename(aside_.c_str(), path_.c_str()) != 0) {
            const int error_number = errno;
            discard();
            throw_write_error(path_, error_number);
        }
        aside_.clear();
        // The folder entry must be synced, too; some file systems cannot sync a folder.
        const int folder = ::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder >= 0) {
            fsync(folder);
            ::close(folder);
        }
    }
    const int closed = ::close(std::exchange(descriptor_, -1));
    // After sync and rename the file is complete, even if closing reports an error.
    if (closed != 0 && errno != EINTR && !renames) throw_write_error(path_, errno);
}

void AtomicFile::release() {
    fsync(descriptor_);
    aside_.clear();
    discard();
}

void AtomicFile::replace(AtomicFile& other) {
    if (fsync(descriptor_) != 0 || ::rename(aside_.c_str(), other.aside_.c_str()) != 0)
        throw_write_error(path_, errno);
    aside_ = std::exchange(other.aside_, {});
    other.discard();
}

void AtomicFile::discard() noexcept {
    // Remove the file before releasing the lock, so that another run's temporary file is never
    // removed.
    if (descriptor_ >= 0 && !aside_.empty()) ::unlink(aside_.c_str());
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
    aside_.clear();
}

void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void write_whole(const std::filesystem::path& path, std::string_view text) {
    write_whole(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace poinsot
