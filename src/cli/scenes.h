// A command over one scene or many: each gets a name of its own to write to, and one that is bad
// does not keep the others from being made.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cli/options.h"

namespace poinsot {

// `job` is called for each scene that the options name, with options that name it alone: with one
// scene as they are; with several, the first #### of the output counts the scenes from 0. Returns
// the largest exit code; a scene that is refused is said on stderr and counts as 2. Throws
// InputError if several scenes would be written to one name.
int for_each_scene(const Options& options, const std::function<int(const Options&)>& job);

}  // namespace poinsot
