// A small scene, and a folder with one in which a test runs commands.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/program_run.h"

namespace poinsot::testing {

inline const std::string racket = R"(
title = "Racket"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [320, 180]
duration_s = 1.0
)";

// The fixture of tests of messages. Each file gives it an alias, so that the suite has the name of
// its command.
class Messages : public ::testing::Test {
 protected:
    Messages() { folder_.write("scene.toml", scene); }

    ProgramRun run(const std::string& arguments) const {
        return run_program_in(folder_, arguments);
    }

    // One line on stderr with every part, the exit code, and no file.
    void refuses(const std::string& arguments, int code, const std::vector<std::string>& parts) {
        const std::string before = folder_.listing();
        const ProgramRun answer = run(arguments);
        EXPECT_EQ(answer.code, code) << arguments;
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        for (const std::string& part : parts)
            EXPECT_NE(answer.err.find(part), std::string::npos) << arguments << ": " << answer.err;
        EXPECT_EQ(folder_.listing(), before) << arguments;
    }

    inline static const std::string scene = R"(title = "Told"
[body]
moments_kg_m2 = [1.0, 2.0, 2.5]
[start]
omega_rad_s = [0.3, 1.0, 0.2]
[film]
size = [64, 48]
duration_s = 0.2
)";
    ScratchFolder folder_;
};

}  // namespace poinsot::testing
