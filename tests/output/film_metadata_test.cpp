// The metadata of outputs is read back from every format that supports it.
#include "output/film_metadata.h"

#include <gtest/gtest.h>

#include "output/films.h"

namespace poinsot {
namespace {

TEST(FilmMetadata, IsReadBackFromEveryFormat) {
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        // As long as a complete scene, with the characters that formats escape, and of several
        // lines.
        for (const std::string& text :
             {std::string("title = \"L'ω\"\n[body]\nmoments = [3, 2, 1] # = ; \\ é\n"),
              std::string(20000, 'x') + "end", std::string("1")}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 1);
            plan.metadata = text;
            write_film(plan);
            EXPECT_EQ(film_metadata(plan.path), text) << name;
        }
    }
}

TEST(FilmMetadata, IsEmptyWithoutMetadata) {
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const TemporaryFolder folder;
        OutputPlan plan = small_plan(folder / name, 1);
        plan.metadata = "";
        write_film(plan);
        EXPECT_EQ(film_metadata(plan.path), "") << name;
    }
}

TEST(FilmMetadata, OfAMissingFileIsRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(input_error_of([&] { film_metadata(folder / "a.mp4"); }), "");
}

}  // namespace
}  // namespace poinsot
