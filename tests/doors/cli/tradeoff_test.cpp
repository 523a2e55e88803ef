// tradeoff: the printed rows, and no temporary files.
#include <gtest/gtest.h>

#include <string>

#include "cli/program_run.h"
#include "cli/small_scene.h"

namespace poinsot::testing {
namespace {

// About two hundred rows: by default only the Pareto front is printed; the files have all rows.
TEST(Tradeoff, PrintsTheFrontAndLeavesNoTemporaryFiles) {
    const ScratchFolder folder, temporary;
    folder.write("scene.toml", racket);
    const std::string arguments =
        "tradeoff scene.toml -q --size 64x36 --set film.duration_s=0.2 -o t";
    const std::string runner = "env TMPDIR='" + temporary.path().string() + "'";
    const ProgramRun front = run_program_in(folder, arguments, runner);
    ASSERT_EQ(front.code, 0) << front.err;
    EXPECT_EQ(temporary.listing(), "");
    const std::string csv = text_of(folder.path() / "t.csv");
    const auto count = [](const std::string& text, const std::string& what) {
        std::ptrdiff_t n = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
        return n;
    };
    EXPECT_EQ(count(front.out, "\n* "), count(csv, ",true\n"));
    EXPECT_EQ(count(front.out, "\n  euler "), 0);
    EXPECT_GT(count(csv, ",false\n"), 20);
    // The cost of a frame is measured at the film's own size and quality.
    EXPECT_NE(front.out.find("at 64x36 and quality lecture"), std::string::npos) << front.out;
    const ProgramRun all = run_program_in(folder, arguments + " --all", runner);
    ASSERT_EQ(all.code, 0) << all.err;
    EXPECT_GT(count(all.out, "\n"), count(front.out, "\n") + 20);
}

}  // namespace
}  // namespace poinsot::testing
