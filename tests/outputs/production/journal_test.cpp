// What --journal does with the sizes that are given beside it.
#include "production/vectors/journal.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "error/error.h"

namespace poinsot {
namespace {

PrintChoices set_for(const char* journal, std::optional<double> width_mm,
                     std::optional<double> height_mm) {
    PrintChoices print;
    print.width_mm = width_mm;
    print.height_mm = height_mm;
    set_journal(journal_named(journal), print);
    return print;
}

// A figure has the width of a column unless a width is given; a height changes nothing about it.
TEST(Journal, DeterminesTheWidthWhateverTheHeight) {
    for (const Journal& journal : journals())
        for (const std::optional<double> height_mm :
             {std::optional<double>(), std::optional(70.0), std::optional(journal.page_mm)}) {
            const std::string name(journal.name);
            EXPECT_EQ(set_for(name.c_str(), std::nullopt, height_mm).width_mm, journal.column_mm);
            EXPECT_EQ(set_for(name.c_str(), 120.0, height_mm).width_mm, 120.0);
            EXPECT_EQ(set_for(name.c_str(), journal.page_mm, height_mm).height_mm, height_mm);
            EXPECT_THROW(set_for(name.c_str(), journal.page_mm + 0.1, height_mm), InputError);
        }
    // 70 mm high figures in 16:9 were 124 mm wide, and 120 mm high ones 213 mm.
    const auto size = print_size_of(set_for("iop", std::nullopt, 120.0), 1920, 1080);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width_px, 1004);   // 85 mm at 300 dpi
    EXPECT_EQ(size->height_px, 1417);  // 120 mm
}

}  // namespace
}  // namespace poinsot
