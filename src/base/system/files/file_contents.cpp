#include "system/files/file_contents.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <limits>
#include <utility>

#include "error/error.h"
#include "system/files/file_kind.h"

namespace poinsot {

namespace {

[[noreturn]] void throw_read_error(const std::filesystem::path& path, int error_number) {
    throw EnvironmentError(
        fmt::format("cannot read {}: {}", path.string(), std::strerror(error_number)));
}

[[noreturn]] void refuse(const std::filesystem::path& path, FileKind kind) {
    throw InputError(fmt::format("{}: {}", path.string(), in_words(kind)));
}

// Reads up to this many bytes, or to the end of the file, regardless of its reported size: files in
// /proc report the size 0.
template <class Bytes>
Bytes contents_of(const std::filesystem::path& path, std::size_t most) {
    const InputFile file(path);
    struct stat status {};
    if (::fstat(file.descriptor(), &status) != 0) throw_read_error(path, errno);
    constexpr std::size_t least_room = 4096;
    const auto size = static_cast<std::size_t>(status.st_size);
    Bytes bytes(std::min(std::max(least_room, size + 1), most), 0);
    std::size_t n_read = 0;
    while (n_read < most) {
        if (n_read == bytes.size()) bytes.resize(std::min(2 * bytes.size(), most));
        const ssize_t n = ::read(file.descriptor(), bytes.data() + n_read, bytes.size() - n_read);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_read_error(path, errno);
        if (n == 0) break;
        n_read += static_cast<std::size_t>(n);
    }
    bytes.resize(n_read);
    return bytes;
}

constexpr std::size_t to_the_end = std::numeric_limits<std::size_t>::max();

}  // namespace

InputFile::InputFile(const std::filesystem::path& path) {
    // Asked before it is opened, for opening some devices acts on them.
    const FileKind kind = kind_of_file(path);
    if (kind == FileKind::special || kind == FileKind::link_circle) refuse(path, kind);
    // Without waiting, since a pipe may have taken the file's place meanwhile.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor_ < 0) throw_read_error(path, errno);
    struct stat status {};
    const bool is_known = ::fstat(descriptor_, &status) == 0;
    if (is_known && S_ISREG(status.st_mode)) return;
    const int error_number = errno;
    ::close(descriptor_);
    if (!is_known) throw_read_error(path, error_number);
    refuse(path, S_ISDIR(status.st_mode) ? FileKind::folder : FileKind::special);
}

InputFile::~InputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

InputFile::InputFile(InputFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

std::string read_text(const std::filesystem::path& path) {
    return contents_of<std::string>(path, to_the_end);
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
    return contents_of<std::vector<std::uint8_t>>(path, to_the_end);
}

void read_pieces(const std::filesystem::path& path,
                 const std::function<void(std::string_view piece)>& take) {
    const InputFile file(path);
    std::string piece(1 << 20, '\0');
    while (true) {
        const ssize_t n = ::read(file.descriptor(), piece.data(), piece.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_read_error(path, errno);
        if (n == 0) return;
        take(std::string_view(piece).substr(0, static_cast<std::size_t>(n)));
    }
}

std::string read_beginning(const std::filesystem::path& path, std::size_t n_bytes) {
    return contents_of<std::string>(path, n_bytes);
}

bool begins_with(const std::filesystem::path& path, std::string_view beginning) noexcept {
    try {
        return read_beginning(path, beginning.size()) == beginning;
    } catch (const std::exception&) {
        return false;
    }
}

std::string read_text_if_there(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored) ? read_text(path) : "";
}

}  // namespace poinsot
