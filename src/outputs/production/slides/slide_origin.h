// Of which scene slides are, as slides.json and presentations say it.
#pragma once

#include <string>

namespace poinsot {

// Slides are of one talk if their scenes have the same name, and either are the same file, however
// it was edited, or the same scene: so slides survive neither a scene of another folder nor another
// one of their name, and are replaced after each change of their own. A scene without a file, such
// as one of Python, has its title instead.
struct SlideOrigin {
    std::string scene_name, title;
    std::string scene_file{};  // seen from the folder of the slides; empty: none
    std::string scene_sha256;  // of scene_hash_of
};

}  // namespace poinsot
