// The hidden folder in which a run keeps the unfinished files of an output, and its lock. A marker
// file in it says that poinsot made it, so that a folder of somebody else is neither used nor
// removed. The unfinished work of a single file is an AtomicFile.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "system/files/atomic_file.h"

namespace poinsot {

// Where an output's unfinished files lie, and how they are recognised.
struct UnfinishedPlace {
    std::filesystem::path output;  // for messages
    std::filesystem::path folder;
    std::string marker;     // name of the marker file
    std::string beginning;  // of the marker's contents, in every folder that poinsot made
};

// Open while it lives. Move-only. Constructors throw EnvironmentError: they refuse, in one line
// that names the output and the folder, a link, a file and a folder without the marker, unless the
// folder is empty. What is neither a file nor a folder in it, such as a link, is removed.
class UnfinishedFolder {
 public:
    // Makes the folder, or continues with that of an interrupted run. The caller has taken the
    // lock, which is held until the end. `work` describes what is made and becomes the contents of
    // the marker: the files of other work are removed.
    UnfinishedFolder(AtomicFile&& lock, UnfinishedPlace place, const std::string& work);
    // The folder that an interrupted run has left, without a lock; nothing if there is none.
    static std::optional<UnfinishedFolder> left(UnfinishedPlace place);
    // Removes a folder that holds no files for another run, if it holds the lock.
    ~UnfinishedFolder();
    UnfinishedFolder(UnfinishedFolder&& other) noexcept
        : place_(std::move(other.place_)),
          lock_(std::move(other.lock_)),
          descriptor_(std::exchange(other.descriptor_, -1)) {}
    UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;

    const std::filesystem::path& path() const { return place_.folder; }
    std::filesystem::path file(const std::string& name) const { return path() / name; }

    // The names of its entries, sorted, without the marker.
    std::vector<std::string> names() const;

    // Remove an entry with all that it contains; all entries but the marker and these; the folder
    // with all entries, and the contents of the lock. They follow no links, and pass over what
    // cannot be removed.
    void remove(const std::string& name) const;
    void keep_only(const std::function<bool(const std::string& name)>& is_kept) const;
    void remove_all();

 private:
    UnfinishedFolder(UnfinishedPlace&& place, int descriptor);
    void check() const;
    void remove_if_empty() const;

    UnfinishedPlace place_;
    std::optional<AtomicFile> lock_;
    int descriptor_ = -1;
};

}  // namespace poinsot
