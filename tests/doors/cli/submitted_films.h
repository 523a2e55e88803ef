// Films submitted to a cluster: a fake sbatch records its arguments.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/program_run.h"

namespace poinsot::testing::submit_tests {

inline constexpr const char* a_scene = R"(title = "Submitted"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [96, 54]
duration_s = 12.0
quality = "draft"
)";

class Submit : public ::testing::Test {
 protected:
    Submit() {
        folder_.write("a.toml", a_scene);
        folder_.write("b.toml", a_scene);
        std::filesystem::create_directory(folder_.path() / "bin");
        std::filesystem::create_directory(folder_.path() / "config");
    }
    // A fake program that is found before the real one.
    void stand_in(const std::string& name, const std::string& script) {
        const std::string file = folder_.write("bin/" + name, "#!/bin/sh\n" + script);
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }
    ProgramRun run(const std::string& arguments) {
        return run_program_in(folder_, arguments,
                              "PATH=\"$PWD/bin:$PATH\" XDG_CONFIG_HOME=\"$PWD/config\"");
    }
    std::string text(const std::string& name) { return text_of(folder_.path() / name); }
    int n_lines(const std::string& name) {
        const std::string all = text(name);
        return static_cast<int>(std::count(all.begin(), all.end(), '\n'));
    }

    ScratchFolder folder_;
};

// Numbers its jobs from 100, and records its arguments, one line per call.
inline constexpr const char* accepting_sbatch =
    "echo \"$@\" >>calls\necho $((99 + $(wc -l <calls)))\n";

}  // namespace poinsot::testing::submit_tests
