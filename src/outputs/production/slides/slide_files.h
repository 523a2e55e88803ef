// The films of slides while they are made, for a folder of slides or a presentation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "production/session/session.h"
#include "production/session/task.h"
#include "production/slides/slide_list.h"
#include "production/stills/picture.h"
#include "system/files/unfinished_folder.h"

namespace poinsot {

// Of which scene slides in a folder are.
SlideOrigin origin_of(const Scene& scene, const std::filesystem::path& folder);

// The hidden folder in which the files are made, with a lock beside it. It is removed unless it
// holds frames from which another run can continue.
class SlidesAside {
 public:
    // The folder has the name of `place` with a suffix, as of a temporary file. Continues with the
    // films that an interrupted run with the same plan has left in it; other files are removed.
    // `output` is for messages. Throws EnvironmentError, also if another run makes this output, and
    // for a folder that is not such a one.
    SlidesAside(const std::filesystem::path& output, const std::filesystem::path& place,
                std::string_view suffix, const std::string& plan);

    const std::filesystem::path& path() const { return folder_.path(); }
    std::filesystem::path file(const std::string& name) const { return folder_.file(name); }

    // Whether a run has finished this film, and it still has the bytes of then.
    bool has_finished(const std::string& name) const;
    // Keeps the hash of a finished film for the next run.
    void set_finished(const std::string& name);
    void remove(const std::string& name) const { folder_.remove(name); }

    // Removes all files but the plan and these.
    void keep_only(const std::set<std::string>& files) const;
    void remove() { folder_.remove_all(); }

 private:
    UnfinishedFolder folder_;
    std::map<std::string, std::string> finished_;  // SHA-256 of the files, by name
};

// Makes 01.mp4, 01-loop.mp4, … that are not there yet, with their captions. They report as one
// film, which the caller finishes. Throws as make_in_jobs does.
void make_slide_films(const Session& session, const std::vector<Slide>& slides, SlidesAside& aside,
                      std::optional<int> n_jobs, LazyRenderer& renderer, const Task& task);

}  // namespace poinsot
