// Joins the parts of a film; the result is byte-identical to a single run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "production/session/task.h"

namespace poinsot {

// Joins parts, given in any order: files of render --part; or the pictures of a sequence, by their
// names or by a pattern with "####", which are copied to another sequence or, if the output is
// their own name, checked for completeness. {scene} in the output is the scene's name. Chapters are
// written as by a single run. Returns the accuracy that the parts state. Throws InputError for
// parts that do not make one film, with the reason; throws EnvironmentError, and then leaves no
// file under the final name.
std::string join(const std::vector<std::string>& parts, const std::string& output,
                 const Task& task);

}  // namespace poinsot
