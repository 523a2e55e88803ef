// A command over one scene or many: each gets a name of its own to write to, and one that is bad
// does not keep the others from being made.
#pragma once

#include <functional>
#include <vector>

#include "cli/options.h"

namespace poinsot {

// What a command makes of a scene. In the name of a film of pictures, #### may number its frames.
enum class OutputKind { picture, film };

// The options for each scene that they name, with which they name it alone. In the output, {scene}
// becomes the scene's name and the first #### counts the scenes from 0; that of a PNG sequence is
// left to its frames where one scene, or its name, needs no count. Throws InputError if two scenes
// would be written to one name.
std::vector<Options> options_by_scene(const Options& options, OutputKind kind);

// The exit code of a job over one of several scenes: one that is refused is said on stderr and
// counts as 2.
int code_of_one(const std::function<int()>& job);

// `job`, which makes a film, is called for each scene in turn. Returns the largest exit code.
// Throws what the job throws of a scene alone, and InputError as options_by_scene does.
int for_each_scene(const Options& options, const std::function<int(const Options&)>& job);

}  // namespace poinsot
