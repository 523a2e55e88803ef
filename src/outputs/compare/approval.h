// Approves pictures as new baselines, and records their origin and the reason.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct ApprovalRequest {
    std::filesystem::path results, baselines;  // folders
    std::vector<std::string> names;            // such as "turn", "turn.png" or "turn.mp4"
    bool all = false;                          // instead: everything new or changed
    std::string why;                           // the reason, kept in the manifest
    bool any_renderer = false;                 // accepts pictures of any renderer
    bool foreign = false;                      // accepts pictures by other programs
};

// Progress callbacks.
struct ApprovalTelling {
    // Reports the outcome for a picture, in words.
    std::function<void(const std::string& name, std::string_view outcome)> settled;
    std::function<void(const std::string& note)> note;
};

// Approves the pictures; all checks come before any change. Throws InputError, EnvironmentError.
void approve(const ApprovalRequest& request, const ApprovalTelling& progress);

// Removes baselines with their lines in the manifest, by name; all checks come first. `why` is
// reported, and kept nowhere. Throws like approve().
void remove_baselines(const std::filesystem::path& baselines, const std::vector<std::string>& names,
                      const std::string& why, const ApprovalTelling& progress);

}  // namespace poinsot
