#include "system/file_contents.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "error/error.h"

namespace poinsot {

namespace {

class Opened {
 public:
    explicit Opened(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~Opened() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    int descriptor() const { return descriptor_; }

 private:
    int descriptor_;
};

[[noreturn]] void throw_read_error(const std::filesystem::path& path) {
    throw EnvironmentError(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
}

// To its end, whatever size it had at first: what stands in /proc says that it has none.
template <class Bytes>
Bytes contents_of(const std::filesystem::path& path) {
    const Opened file(path);
    struct stat status {};
    if (file.descriptor() < 0 || ::fstat(file.descriptor(), &status) != 0) throw_read_error(path);
    constexpr std::size_t least_room = 4096;
    Bytes bytes(std::max(least_room, static_cast<std::size_t>(status.st_size) + 1), 0);
    std::size_t n_read = 0;
    while (true) {
        if (n_read == bytes.size()) bytes.resize(2 * bytes.size());
        const ssize_t n = ::read(file.descriptor(), bytes.data() + n_read, bytes.size() - n_read);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_read_error(path);
        if (n == 0) break;
        n_read += static_cast<std::size_t>(n);
    }
    bytes.resize(n_read);
    return bytes;
}

}  // namespace

std::string read_text(const std::filesystem::path& path) { return contents_of<std::string>(path); }

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
    return contents_of<std::vector<std::uint8_t>>(path);
}

std::string read_text_if_there(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored) ? read_text(path) : "";
}

}  // namespace poinsot
