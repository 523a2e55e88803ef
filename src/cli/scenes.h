// One command over several scenes: each by itself, and one that is refused stops no other.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace poinsot {

struct SceneJob {
    std::string scene;
    std::string output;  // empty: named after the scene
};

// One for each scene: with one scene its output is as given; with several, the first #### of it
// counts the scenes from 0. Throws InputError if several scenes would be written to one name.
std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output);

// The exit code of a job over one of several scenes: one that is refused is said on stderr and
// counts as 2.
int code_of_one(const std::function<int()>& job);

// `run` is called for each job in turn. Returns the largest exit code. Throws what it throws of a
// scene alone.
int for_each_scene(const std::vector<SceneJob>& jobs,
                   const std::function<int(const SceneJob&)>& run);

}  // namespace poinsot
