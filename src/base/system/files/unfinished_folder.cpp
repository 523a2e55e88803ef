#include "system/files/unfinished_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "error/error.h"
#include "system/files/atomic_file.h"

namespace poinsot {

namespace fs = std::filesystem;

namespace {

constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

std::vector<std::string> names_in(int folder) {
    std::vector<std::string> names;
    // A new descriptor, since reading moves a position, which duplicates would share.
    const int opened = ::openat(folder, ".", folder_flags);
    DIR* const stream = opened < 0 ? nullptr : ::fdopendir(opened);
    if (stream == nullptr) {
        if (opened >= 0) ::close(opened);
        return names;
    }
    while (const dirent* entry = ::readdir(stream))
        if (const std::string name = entry->d_name; name != "." && name != "..")
            names.push_back(name);
    ::closedir(stream);
    std::sort(names.begin(), names.end());
    return names;
}

// Relative to open folders, so that no link is followed, whoever exchanges a folder meanwhile.
void remove_at(int folder, const std::string& name) {
    if (::unlinkat(folder, name.c_str(), 0) == 0) return;
    if (const int inner = ::openat(folder, name.c_str(), folder_flags); inner >= 0) {
        for (const std::string& each : names_in(inner)) remove_at(inner, each);
        ::close(inner);
    }
    ::unlinkat(folder, name.c_str(), AT_REMOVEDIR);
}

std::string beginning_at(int folder, const std::string& name, std::size_t n_bytes) {
    std::string text(n_bytes, '\0');
    const int opened =
        ::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (opened < 0) return "";
    const ssize_t n = ::pread(opened, text.data(), text.size(), 0);
    ::close(opened);
    text.resize(n < 0 ? 0 : static_cast<std::size_t>(n));
    return text;
}

// Whether an entry is a file or a folder itself, and not a link, a pipe or a device.
bool is_plain(int folder, const std::string& name) {
    struct stat status {};
    return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
           (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode));
}

// −1 if there is nothing of this name.
int open_folder(const UnfinishedPlace& place) {
    const int opened = ::open(place.folder.c_str(), folder_flags);
    if (opened >= 0 || errno == ENOENT) return opened;
    const int error_number = errno;
    if (error_number == ENOTDIR || error_number == ELOOP)
        refuse_aside(place.output, place.folder, "folder");
    if (error_number == EACCES)
        throw EnvironmentError(fmt::format(
            "cannot write {}: its temporary folder {} exists and cannot be opened ({}); remove it, "
            "or name another output",
            place.output.string(), place.folder.string(),
            std::generic_category().message(error_number)));
    throw_write_error(place.output, error_number);
}

int make_folder(const UnfinishedPlace& place) {
    if (::mkdir(place.folder.c_str(), 0777) != 0 && errno != EEXIST)
        throw_write_error(place.output, errno);
    const int opened = open_folder(place);
    if (opened < 0) throw_write_error(place.output, ENOENT);
    return opened;
}

}  // namespace

UnfinishedFolder::UnfinishedFolder(UnfinishedPlace&& place, int descriptor)
    : place_(std::move(place)), descriptor_(descriptor) {}

// After the constructor to which this one delegates, the destructor runs even if this one throws;
// without a lock it removes nothing.
UnfinishedFolder::UnfinishedFolder(AtomicFile&& lock, UnfinishedPlace place,
                                   const std::string& work)
    : UnfinishedFolder(std::move(place), make_folder(place)) {
    check();
    lock_ = std::move(lock);
    // One byte more, so that a longer text is another one.
    if (beginning_at(descriptor_, place_.marker, work.size() + 1) == work) return;
    keep_only([](const std::string&) { return false; });
    write_whole(file(place_.marker), work);
}

std::optional<UnfinishedFolder> UnfinishedFolder::left(UnfinishedPlace place) {
    const int opened = open_folder(place);
    if (opened < 0) return std::nullopt;
    UnfinishedFolder folder(std::move(place), opened);
    folder.check();
    return folder;
}

UnfinishedFolder::~UnfinishedFolder() {
    if (descriptor_ < 0) return;
    if (lock_) remove_if_empty();
    ::close(descriptor_);
}

void UnfinishedFolder::check() const {
    std::vector<std::string> there = names_in(descriptor_);
    // A run that was killed while it wrote the marker leaves its temporary file.
    std::erase(there, aside_path_of(place_.marker).string());
    const std::string& beginning = place_.beginning;
    if (!there.empty() && beginning_at(descriptor_, place_.marker, beginning.size()) != beginning)
        refuse_aside(place_.output, place_.folder, "folder");
    for (const std::string& name : there)
        if (!is_plain(descriptor_, name)) ::unlinkat(descriptor_, name.c_str(), 0);
}

std::vector<std::string> UnfinishedFolder::names() const {
    std::vector<std::string> all = names_in(descriptor_);
    std::erase(all, place_.marker);
    return all;
}

void UnfinishedFolder::remove(const std::string& name) const { remove_at(descriptor_, name); }

void UnfinishedFolder::keep_only(
    const std::function<bool(const std::string& name)>& is_kept) const {
    for (const std::string& name : names())
        if (!is_kept(name)) remove_at(descriptor_, name);
}

void UnfinishedFolder::remove_all() {
    keep_only([](const std::string&) { return false; });
    remove_if_empty();
    if (!lock_) return;
    lock_->discard();
    lock_.reset();
}

void UnfinishedFolder::remove_if_empty() const {
    if (!names().empty()) return;
    ::unlinkat(descriptor_, place_.marker.c_str(), 0);
    ::rmdir(place_.folder.c_str());
}

}  // namespace poinsot
