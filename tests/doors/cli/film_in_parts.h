// A film in parts, made by several runs or by several processes of one run.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "sanitized.h"

namespace poinsot::testing {

// A film of 372 frames: four chunks, the last of them short.
inline constexpr const char* a_scene = R"(title = "In parts"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [96, 54]
duration_s = 12.4
quality = "draft"
[[chapters]]
at_s = 0.0
title = "One"
[[chapters]]
at_s = 5.0
title = "Two \"quoted\""
[[captions]]
at_s = 4.0
text = '$\mathbf{L}$ stays'
)";

// A film that takes until a signal ends it.
inline const std::string large_size =
    sanitized ? " --set film.size=[160,90] " : " --set film.size=[640,360] ";

class Parts : public ::testing::Test {
 protected:
    Parts() { folder_.write("a.toml", a_scene); }

    ProgramRun run(const std::string& arguments) { return run_program_in(folder_, arguments); }
    void make(const std::string& arguments) {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.code, 0) << arguments << ": " << done.err;
    }
    std::string bytes(const std::string& name) { return text_of(folder_.path() / name); }
    // Returns the message of a refused command.
    std::string refusal(const std::string& arguments, int code = 2) {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.code, code) << arguments << ": " << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
        return done.err;
    }
    void expect_refusal(const std::string& arguments, const std::string& words, int code = 2) {
        const std::string said = refusal(arguments, code);
        EXPECT_NE(said.find(words), std::string::npos) << arguments << ": " << said;
    }
    std::vector<std::string> names() {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        return found;
    }

    ScratchFolder folder_;
};

}  // namespace poinsot::testing
