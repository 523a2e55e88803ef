#include "system/files/unfinished_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

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
int open_folder(const fs::path& output, const fs::path& folder) {
    const int opened = ::open(folder.c_str(), folder_flags);
    if (opened >= 0 || errno == ENOENT) return opened;
    if (errno == ENOTDIR || errno == ELOOP) refuse_aside(output, folder, "folder");
    throw_write_error(output, errno);
}

}  // namespace

UnfinishedFolder::UnfinishedFolder(fs::path output, fs::path folder, FolderMarker marker,
                                   int descriptor)
    : output_(std::move(output)),
      folder_(std::move(folder)),
      marker_(std::move(marker)),
      descriptor_(descriptor) {
    check();
}

UnfinishedFolder::UnfinishedFolder(const fs::path& output, fs::path folder, FolderMarker marker)
    : output_(output), folder_(std::move(folder)), marker_(std::move(marker)) {
    if (::mkdir(folder_.c_str(), 0777) != 0 && errno != EEXIST) throw_write_error(output, errno);
    descriptor_ = open_folder(output_, folder_);
    if (descriptor_ < 0) throw_write_error(output_, ENOENT);
    check();
}

std::optional<UnfinishedFolder> UnfinishedFolder::left(const fs::path& output,
                                                       const fs::path& folder,
                                                       const FolderMarker& marker) {
    const int opened = open_folder(output, folder);
    if (opened < 0) return std::nullopt;
    return UnfinishedFolder(output, folder, marker, opened);
}

UnfinishedFolder::~UnfinishedFolder() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

bool UnfinishedFolder::has_marker() const {
    return beginning_at(descriptor_, marker_.name, marker_.beginning.size()) == marker_.beginning;
}

// Called by constructors, whose destructor does not run where it throws.
void UnfinishedFolder::check() const {
    std::vector<std::string> there = names_in(descriptor_);
    // A run that was killed while it wrote the marker leaves its temporary file.
    std::erase(there, aside_path_of(marker_.name).string());
    if (!there.empty() && !has_marker()) {
        ::close(descriptor_);
        refuse_aside(output_, folder_, "folder");
    }
    for (const std::string& name : there)
        if (!is_plain(descriptor_, name)) ::unlinkat(descriptor_, name.c_str(), 0);
}

std::vector<std::string> UnfinishedFolder::names() const {
    std::vector<std::string> all = names_in(descriptor_);
    std::erase(all, marker_.name);
    return all;
}

void UnfinishedFolder::remove(const std::string& name) const { remove_at(descriptor_, name); }

void UnfinishedFolder::clear() const {
    for (const std::string& name : names()) remove_at(descriptor_, name);
}

void UnfinishedFolder::remove_all() const {
    clear();
    remove_if_empty();
}

void UnfinishedFolder::remove_if_empty() const {
    if (!names().empty()) return;
    ::unlinkat(descriptor_, marker_.name.c_str(), 0);
    ::rmdir(folder_.c_str());
}

}  // namespace poinsot
