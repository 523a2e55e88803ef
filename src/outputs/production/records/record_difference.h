// The differences between the records of two pictures, in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "production/records/record.h"

namespace poinsot {

// The differences of two scenes, of how they were drawn, and of the programs, in this order: one
// line each, as "style.polhode: default → #1060ff" or "program: 0.1.0 → 0.2.0". Empty if nothing
// differs except for the file's contents. The texts of the scenes are compared as TOML, so that
// this works for records of any version.
std::vector<std::string> differences_in_words(const Record& before, const Record& after);

// The differences of two scene texts alone. Throws SceneError for a text that is not TOML.
std::vector<std::string> scene_differences(std::string_view before, std::string_view after);

}  // namespace poinsot
