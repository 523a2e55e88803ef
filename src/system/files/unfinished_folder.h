// The hidden folder in which a run keeps the unfinished files of an output. A marker file in it
// says that poinsot made it, so that a folder of somebody else is neither used nor removed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace poinsot {

struct FolderMarker {
    std::string name;       // of the marker file
    std::string beginning;  // of its contents, in folders that poinsot made
};

// Open while it lives. Move-only. All throw EnvironmentError.
class UnfinishedFolder {
 public:
    // Makes the folder, or opens the one that an interrupted run has left. Refuses, in one line
    // that names the output and the folder, a link, a file and a folder without the marker, unless
    // the folder is empty. What is neither a file nor a folder in it, such as a link, is removed.
    // Afterwards write the marker, if has_marker() is false.
    UnfinishedFolder(const std::filesystem::path& output, std::filesystem::path folder,
                     FolderMarker marker);
    // The folder that an interrupted run has left; nothing if there is none.
    static std::optional<UnfinishedFolder> left(const std::filesystem::path& output,
                                                const std::filesystem::path& folder,
                                                const FolderMarker& marker);
    ~UnfinishedFolder();
    UnfinishedFolder(UnfinishedFolder&& other) noexcept
        : output_(std::move(other.output_)),
          folder_(std::move(other.folder_)),
          marker_(std::move(other.marker_)),
          descriptor_(std::exchange(other.descriptor_, -1)) {}
    UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;

    const std::filesystem::path& path() const { return folder_; }
    std::filesystem::path marker_path() const { return folder_ / marker_.name; }
    bool has_marker() const;

    // The names of its entries, sorted, without the marker.
    std::vector<std::string> names() const;

    // Remove an entry with all that it contains; all entries but the marker; the folder with all
    // entries; the folder if only the marker is left in it. They follow no links, and pass over
    // what cannot be removed.
    void remove(const std::string& name) const;
    void clear() const;
    void remove_all() const;
    void remove_if_empty() const;

 private:
    UnfinishedFolder(std::filesystem::path output, std::filesystem::path folder,
                     FolderMarker marker, int descriptor);
    void check() const;

    std::filesystem::path output_, folder_;
    FolderMarker marker_;
    int descriptor_ = -1;
};

}  // namespace poinsot
