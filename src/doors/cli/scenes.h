// Runs one command for several scenes, separately: an error in one scene does not stop the others.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "scene/override.h"

namespace poinsot {

// Returns the scenes supplied with the program, next to an installed program or in the source
// folder of a build, by name. Throws EnvironmentError.
std::vector<std::filesystem::path> bundled_scenes();

// Returns the file of a scene as a user names it: "generic" is a supplied scene if there is no such
// file in the current folder. Throws InputError with the nearest name for a bare name that is
// neither.
std::string scene_file(const std::string& given);

struct SceneJob {
    std::string scene;
    std::string output;               // empty: named after the scene
    std::vector<Override> overrides;  // applied after those of the command line
};

// The output of a command. In the name of a film made of pictures, and of pictures of one scene,
// #### may number these.
enum class OutputKind { picture, pictures, film };

// Returns one job for each scene. In the output, {scene} is replaced by the scene's name and the
// first #### by the scene's number from 0; the #### of a PNG sequence or of pictures of a scene
// numbers these if there is one scene or the scene's name makes the outputs distinct. Throws
// InputError if two scenes would have the same output.
std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind);

// Does the same for jobs whose output names are not filled in yet; `output` is the user's text.
std::vector<SceneJob> named_jobs(std::vector<SceneJob> jobs, const std::string& output,
                                 OutputKind kind);

// Prints the errors of several jobs: for a sweep each reason once, and at the end the other runs
// that failed for the same reason.
class Refusals {
 public:
    // Returns the exit code of a job; an error counts as 2.
    int code_of(const SceneJob& job, const std::function<int()>& run);

    // Prints the jobs whose errors were not printed.
    void say_others() const;

 private:
    std::set<std::string> said_;
    std::vector<std::string> likewise_;
};

// Calls `run` for each job in turn. Returns the largest exit code. With a single scene, exceptions
// pass through.
int for_each_scene(const std::vector<SceneJob>& jobs,
                   const std::function<int(const SceneJob&)>& run);

}  // namespace poinsot
