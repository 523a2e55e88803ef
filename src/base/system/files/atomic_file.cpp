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

std::string reason(int error_number) {
    if (error_number == ENAMETOOLONG)
        return "the name is too long; a file name of at most 200 bytes leaves space for the names "
               "of the hidden files";
    return std::generic_category().message(error_number);
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// The final name with symbolic links followed, so that the link itself is not replaced, even where
// it leads to a file that does not exist yet. A circle of links is left to the call that opens it.
fs::path followed(const fs::path& path) {
    constexpr int most_links = 40;
    fs::path target = path;
    std::error_code missing, error;
    for (int n = 0; n < most_links && fs::is_symlink(target, missing); ++n)
        target = target.parent_path() / fs::read_symlink(target, error);
    return error ? path : target;
}

bool is_device(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// `target`: the path with links followed.
void check_folder_of(const fs::path& path, const fs::path& target) {
    std::error_code ignored;
    const fs::path folder = folder_of(target);
    if (!fs::exists(folder, ignored) && ignored.value() == ENAMETOOLONG)
        throw_write_error(path, ENAMETOOLONG);
    if (!fs::exists(folder, ignored) && ignored.value() != EACCES)
        throw EnvironmentError(
            fmt::format("cannot write {}: the folder {} does not exist; make it first",
                        path.string(), folder.string()));
}

void check_place(const fs::path& path, const fs::path& target) {
    std::error_code ignored;
    if (fs::is_symlink(target, ignored)) throw_write_error(path, ELOOP);
    if (!path.has_filename() || fs::is_directory(path, ignored))
        throw EnvironmentError(
            fmt::format("cannot write {}: it is a folder; name a file in it", path.string()));
    check_folder_of(path, target);
}

// If no file can be created in the folder, the message names the folder, not the file; if the
// temporary file is there and cannot be opened, the message names it.
[[noreturn]] void throw_open_error(const fs::path& path, const fs::path& aside, int error_number) {
    struct stat there {};
    if (error_number == EACCES && lstat(aside.c_str(), &there) == 0)
        throw EnvironmentError(
            fmt::format("cannot write {}: its temporary file {} exists and cannot be opened ({}); "
                        "remove it, or "
                        "name another output",
                        path.string(), aside.string(), reason(error_number)));
    const bool of_folder = error_number == EACCES || error_number == EPERM ||
                           error_number == EROFS || error_number == ENOENT;
    if (!of_folder) throw_write_error(path, error_number);
    throw EnvironmentError(
        fmt::format("cannot write {}: the folder {} cannot be written ({}); name another",
                    path.string(), folder_of(aside).string(), reason(error_number)));
}

// Whether the name still refers to the open file: between opening and locking, another run may have
// renamed or removed it.
bool names(const fs::path& path, int descriptor) {
    struct stat by_name {};
    struct stat by_descriptor {};
    return lstat(path.c_str(), &by_name) == 0 && fstat(descriptor, &by_descriptor) == 0 &&
           by_name.st_ino == by_descriptor.st_ino && by_name.st_dev == by_descriptor.st_dev;
}

constexpr mode_t mark = S_ISVTX, new_file = 0666 | mark;
constexpr mode_t all_permissions = S_IRWXU | S_IRWXG | S_IRWXO;

bool is_marked(const struct stat& status) {
    return S_ISREG(status.st_mode) && (status.st_mode & mark) != 0;
}

void set_mark(int descriptor, bool marked) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0) return;
    const mode_t permissions = status.st_mode & all_permissions;
    // A file of another user keeps what it has.
    [[maybe_unused]] const int changed =
        fchmod(descriptor, marked ? permissions | mark : permissions);
}

// Gives the open file the permissions of the file that it replaces, if there is one, and `more`.
void take_permissions_of(const fs::path& target, int descriptor, mode_t more) {
    struct stat there {};
    if (lstat(target.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return;
    [[maybe_unused]] const int changed =
        fchmod(descriptor, (there.st_mode & all_permissions) | more);
}

// Opens what is there without waiting for a pipe and without following a link; −1 with errno ENOENT
// if it has vanished.
int open_left(const fs::path& path, const fs::path& aside) {
    struct stat there {};
    const bool is_there = lstat(aside.c_str(), &there) == 0;
    if (is_there && !S_ISREG(there.st_mode)) refuse_aside(path, aside, "file");
    const int opened =
        is_there ? ::open(aside.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK) : -1;
    struct stat status {};
    if (opened < 0 || (fstat(opened, &status) == 0 && S_ISREG(status.st_mode))) return opened;
    ::close(opened);
    refuse_aside(path, aside, "file");
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

}  // namespace

void throw_write_error(const fs::path& path, int error_number) {
    throw EnvironmentError(fmt::format("cannot write {}: {}", path.string(), reason(error_number)));
}

fs::path aside_path_of(const fs::path& path, std::string_view suffix) {
    return path.parent_path() / fmt::format(".{}{}", path.filename().string(), suffix);
}

void refuse_aside(const fs::path& path, const fs::path& aside, std::string_view what) {
    throw EnvironmentError(fmt::format(
        "cannot write {}: its temporary {} {} exists and is not unfinished work of poinsot; remove "
        "it, or name another output",
        path.string(), what, aside.string()));
}

void check_aside(const fs::path& path) {
    if (path == "-" || is_device(path)) return;
    const fs::path aside = aside_path_of(followed(path));
    struct stat there {};
    if (lstat(aside.c_str(), &there) != 0) {
        if (errno == ENAMETOOLONG) throw_write_error(path, errno);
        return;
    }
    if (is_marked(there)) return;
    const int opened = open_left(path, aside);
    if (opened < 0) return;  // opening it for writing reports the error
    // Another run may write it on a file system that does not keep the mark.
    const bool is_held = flock(opened, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(opened);
    if (!is_held) refuse_aside(path, aside, "file");
}

void remove_left_aside(const fs::path& path) noexcept {
    const fs::path aside = aside_path_of(path);
    struct stat there {};
    if (lstat(aside.c_str(), &there) == 0 && is_marked(there)) ::unlink(aside.c_str());
}

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(followed(path)) {
    if (path_ == "-") {
        descriptor_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
        if (descriptor_ < 0) throw_write_error("stdout", errno);
        return;
    }
    check_place(path_, target_);
    if (is_device(path_)) {
        descriptor_ = open_device(path_);
        if (descriptor_ < 0) throw_write_error(path_, errno);
        return;
    }
    aside_ = aside_path_of(target_);
    open_aside({}, {});
}

AtomicFile::AtomicFile(const fs::path& path, const fs::path& aside, bool keep_contents,
                       const std::function<void()>& when_held, const IsUnfinished& is_unfinished)
    : path_(path), target_(followed(path)), aside_(aside), keeps_(keep_contents) {
    check_place(path_, target_);
    open_aside(when_held, is_unfinished);
}

AtomicFile AtomicFile::lock(const fs::path& output, const fs::path& aside) {
    check_folder_of(output, output);
    AtomicFile file;
    file.path_ = output;
    file.aside_ = aside;
    file.open_aside({}, {});
    return file;
}

AtomicFile::~AtomicFile() {
    // Keep the contents that an interrupted run has left, whatever the error.
    if (keeps_ && has_contents()) aside_.clear();
    discard();
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      aside_(std::exchange(other.aside_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      keeps_(other.keeps_) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
    if (this == &other) return *this;
    discard();
    path_ = std::move(other.path_);
    target_ = std::move(other.target_);
    aside_ = std::exchange(other.aside_, {});
    descriptor_ = std::exchange(other.descriptor_, -1);
    keeps_ = other.keeps_;
    return *this;
}

void AtomicFile::open_aside(const std::function<void()>& when_held,
                            const IsUnfinished& is_unfinished) {
    while (descriptor_ < 0) {
        int opened =
            ::open(aside_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, new_file);
        const bool is_new = opened >= 0;
        if (!is_new && errno == EEXIST) {
            opened = open_left(path_, aside_);
            if (opened < 0 && errno == ENOENT) continue;
        }
        if (opened < 0) throw_open_error(path_, aside_, errno);
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
        if (!names(aside_, opened)) {
            ::close(opened);
            continue;
        }
        struct stat status {};
        if (!is_new && (fstat(opened, &status) != 0 || !is_marked(status))) {
            if (!is_unfinished || !is_unfinished(opened)) {
                ::close(opened);
                refuse_aside(path_, aside_, "file");
            }
            set_mark(opened, true);
        }
        // From the beginning, so that nobody reads the contents of a private file meanwhile.
        take_permissions_of(target_, opened, S_IRUSR | S_IWUSR | mark);
        descriptor_ = opened;
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
        take_permissions_of(target_, descriptor_, mark);
        if (::rename(aside_.c_str(), target_.c_str()) != 0) {
            const int error_number = errno;
            discard();
            throw_write_error(path_, error_number);
        }
        aside_.clear();
        // Only now: a run that is killed before leaves a file that the next one takes over.
        set_mark(descriptor_, false);
        // The folder entry must be synced, too; some file systems cannot sync a folder.
        const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
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
