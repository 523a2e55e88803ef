// doctor: what this machine has, and advice for what is missing.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"

namespace poinsot::testing {
namespace {

TEST(Doctor, FindsAContextHere) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(folder, "doctor");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_NE(run.out.find("context OSMesa"), std::string::npos);
}

// A file that is not a library simulates a missing library.
TEST(Doctor, AdvisesAvailablePackages) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "lib");
    folder.write("lib/libOSMesa.so.8", "no library");
    const ProgramRun run = run_program_in(folder, "doctor", "LD_LIBRARY_PATH=$PWD/lib");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    const std::size_t at = run.out.find("context OSMesa");
    const std::string line = run.out.substr(at, run.out.find('\n', at) - at);
    EXPECT_NE(line.find("not needed: EGL works"), std::string::npos) << line;
    EXPECT_EQ(run.out.find("libosmesa6"), std::string::npos) << run.out;
    // Both are missing: the advice also covers distributions without the first.
    folder.write("lib/libEGL.so.1", "no library");
    const ProgramRun none = run_program_in(folder, "doctor", "LD_LIBRARY_PATH=$PWD/lib");
    EXPECT_EQ(none.code, 1) << none.out << none.err;
    EXPECT_NE(none.out.find("libosmesa6 where there is one"), std::string::npos) << none.out;
    EXPECT_NE(none.out.find("libegl1, libegl-mesa0 and libgl1-mesa-dri"), std::string::npos)
        << none.out;
}

}  // namespace
}  // namespace poinsot::testing
