// Reasons why two records do not belong to parts of the same film.
#include "production/films/part_mismatch.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace poinsot {
namespace {

Record record() {
    Record record;
    record.version = "1";
    record.scene_name = "a";
    record.scene_hash = "h";
    record.scene_toml = "title = \"A\"\nquality = \"draft\"\n";
    record.method = "exact";
    record.processor = "x86 fma";
    record.renderer = "llvmpipe";
    record.mesa = "22.3.6";
    record.frames = {0, 99};
    return record;
}

TEST(PartMismatch, NeedsAllFieldsThatPixelsDependOn) {
    const std::vector<std::pair<std::function<void(Record&)>, const char*>> changes{
        {[](Record& r) { r.version = "2"; }, "versions of poinsot differ: 1 and 2"},
        {[](Record& r) {
             r.scene_hash = "i";
             r.scene_toml = "title = \"A\"\nquality = \"print\"\n";
         },
         "\"quality = \"draft\"\" and \"quality = \"print\"\""},
        {[](Record& r) {
             r.frames = {0, 98};
         },
         "0-99 and 0-98"},
        {[](Record& r) { r.portable = true; }, "native and portable"},
        {[](Record& r) { r.renderer = "softpipe"; }, "renderers differ"},
        {[](Record& r) { r.mesa = "25.0.7"; }, "Mesa differ"},
        {[](Record& r) { r.fonts = "F 1"; }, "fonts differ"},
        {[](Record& r) { r.processor = "x86"; }, "--portable"},
    };
    EXPECT_EQ(difference_of(record(), record()), "");
    for (const auto& [change, words] : changes) {
        Record other = record();
        change(other);
        EXPECT_NE(difference_of(record(), other).find(words), std::string::npos)
            << difference_of(record(), other);
    }
    // Pictures of one sequence differ only in these fields.
    Record other = record();
    other.frame = 7;
    other.pixels = "p";
    EXPECT_EQ(difference_of(record(), other), "");
}

}  // namespace
}  // namespace poinsot
