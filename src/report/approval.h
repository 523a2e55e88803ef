// Pictures taken as the new baselines, with what they were made of and why.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct ApprovalRequest {
    std::filesystem::path results, baselines;  // folders
    std::vector<std::string> names;            // of pictures, as "turn" or "turn.png"
    bool all = false;                          // instead: all that are new or have changed
    std::string why;                           // kept in the manifest
    bool any_renderer = false;                 // whatever drew them
};

// Who hears of what is done.
struct ApprovalTelling {
    // What has become of a picture, in words.
    std::function<void(const std::string& name, std::string_view outcome)> settled;
    std::function<void(const std::string& note)> note;
};

// Everything is checked before anything is changed. Throws InputError, EnvironmentError.
void approve(const ApprovalRequest& request, const ApprovalTelling& telling);

}  // namespace poinsot
