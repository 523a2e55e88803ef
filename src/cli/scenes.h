// One command over several scenes: each by itself, and one that is refused stops no other.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace poinsot {

// The scenes that came with the program, beside an installed one or in the checkout that a build
// stands in, by name. Throws EnvironmentError.
std::vector<std::filesystem::path> own_scenes();

// The file of a scene as a user names it: "generic" is one that came with the program, where no
// such file is here. Throws InputError with the nearest for a mere name that is neither.
std::string scene_file(const std::string& given);

struct SceneJob {
    std::string scene;
    std::string output;                  // empty: named after the scene
    std::vector<std::string> overrides;  // see load_scene; after those of the command line
};

// What a command makes of a scene. In the name of a film of pictures, #### may number its frames.
enum class OutputKind { picture, film };

// One for each scene. In the output, {scene} becomes the scene's name and the first #### counts the
// scenes from 0; that of a PNG sequence is left to its frames where one scene, or its name, needs
// no count. Throws InputError if two scenes would be written to one name.
std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind);

// The same of jobs whose outputs are still names to be filled in; `output` is what the user said.
std::vector<SceneJob> named_jobs(std::vector<SceneJob> jobs, const std::string& output,
                                 OutputKind kind);

// What is said of several jobs that are refused: of a sweep's runs each reason once, and in the end
// which others it holds for.
class Refusals {
 public:
    // The exit code of a job: one that is refused counts as 2.
    int code_of(const SceneJob& job, const std::function<int()>& run);

    // Says for which jobs nothing was said.
    void say_others() const;

 private:
    std::set<std::string> said_;
    std::vector<std::string> likewise_;
};

// `run` is called for each job in turn. Returns the largest exit code. Throws what it throws of a
// scene alone.
int for_each_scene(const std::vector<SceneJob>& jobs,
                   const std::function<int(const SceneJob&)>& run);

}  // namespace poinsot
