// The parts of a film, joined to the bytes of one run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "production/telling.h"

namespace poinsot {

// Joins parts, given in any order: files of render --part; or the pictures of a sequence, by their
// names or by one with "####", which are copied to another sequence or, where that is their own
// name, checked to be all there. In the output {scene} is the scene's name. Chapters are written
// beside as one run writes them. Returns what the parts say of accuracy. Throws: InputError for
// parts that do not make one film, saying which and why; EnvironmentError, and then leaves nothing
// under the final name.
std::string join(const std::vector<std::string>& parts, const std::string& output,
                 const Telling& telling);

}  // namespace poinsot
