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
    std::vector<std::string> names;            // of pictures, such as "turn" or "turn.png"
    bool all = false;                          // instead: all new or changed pictures
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

}  // namespace poinsot
