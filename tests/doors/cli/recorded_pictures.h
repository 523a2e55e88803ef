// Pictures with records, in a folder with the folders of baselines (ref) and of results (new).
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"

namespace poinsot::testing {

// Returns the value of a key in the record of a file.
inline std::string said(const std::string& explained, const std::string& key) {
    const std::size_t at = explained.find("\n" + key + ": ");
    if (at == std::string::npos) return "";
    const std::size_t from = at + key.size() + 3;
    return explained.substr(from, explained.find('\n', from) - from);
}

class Pictures : public ::testing::Test {
 protected:
    Pictures() {
        folder_.write("scene.toml", racket);
        for (const char* name : {"ref", "new"})
            std::filesystem::create_directory(folder_.path() / name);
    }

    ProgramRun run(const std::string& arguments) const {
        return run_program_in(folder_, arguments);
    }
    // Renders a picture of the scene.
    void draw(const std::string& file, const std::string& options) const {
        const ProgramRun drawn = run("still scene.toml -q -o " + file + " " + options);
        ASSERT_EQ(drawn.code, 0) << drawn.err;
    }
    ProgramRun approve(const std::string& arguments) const {
        return run("approve --results new --baselines ref " + arguments);
    }

    inline static const std::string racket = R"(
title = "Racket"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [128, 72]
duration_s = 0.5
)";
    ScratchFolder folder_;
};

}  // namespace poinsot::testing
